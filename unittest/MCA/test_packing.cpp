// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/packing.h"

#include "sample.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

using namespace mca;

namespace {

Eigen::Vector3d vector(const Lattice::Point &p)
{
  return {p.x, p.y, p.z};
}

/// Unit vectors to the nearest neighbours of an automaton of the lattice's basis.
std::vector<Eigen::Vector3d> normals(const Packing &p, const Lattice &lattice, size_t from)
{
  const int layers = p.dimension == 2 ? 0 : 2;
  std::vector<Eigen::Vector3d> all;
  for (const auto &to : lattice.basis)
    for (int a = -2; a <= 2; a++)
      for (int b = -2; b <= 2; b++)
        for (int c = -layers; c <= layers; c++) {
          const Eigen::Vector3d n = vector(to) - vector(lattice.basis[from]) +
                                    a * vector(lattice.edges[0]) + b * vector(lattice.edges[1]) +
                                    c * vector(lattice.edges[2]);
          if (n.norm() > 0.1 && n.norm() < 1.2)
            all.push_back(n);
        }
  return all;
}

class PackingTest : public testing::TestWithParam<Packing> {};

} // namespace

TEST_P(PackingTest, NeighboursTouchAndAreIsotropic)
{
  const Packing &p = GetParam();
  const Lattice lattice = latticeOf(p);
  for (size_t from = 0; from < lattice.basis.size(); from++) {
    const auto all = normals(p, lattice, from);
    ASSERT_EQ(static_cast<int>(all.size()), p.coordination);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const auto &n : all) {
      EXPECT_NEAR(n.norm(), 1.0, 1e-15);
      sum += n * n.transpose();
    }
    Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    if (p.dimension == 2)
      one(2, 2) = 0;
    EXPECT_LT((sum - one * p.coordination / p.dimension).norm(), 1e-14);
  }
}

TEST_P(PackingTest, CellsFillTheLattice)
{
  const Packing &p = GetParam();
  const Lattice lattice = latticeOf(p);
  const double period =
      vector(lattice.edges[0]).cross(vector(lattice.edges[1])).dot(vector(lattice.edges[2]));
  const double d = 2.5, h = 3.0;
  const double volume = std::abs(period) * d * d * (p.dimension == 2 ? h : d);
  const double cells = static_cast<double>(lattice.basis.size()) * Cell{p, d, h}.cellVolume();
  EXPECT_NEAR(cells, volume, 1e-14 * volume);
}

TEST_P(PackingTest, StressWeightIsQSOverV)
{
  const Cell cell{GetParam(), 0.7, 1.9};
  EXPECT_NEAR(0.5 * 0.7 * cell.contactArea() / cell.cellVolume(), GetParam().stressWeight(), 1e-15);
}

TEST_P(PackingTest, MassHasTheDensityOfTheSolid)
{
  const Cell cell{GetParam(), 2.5, 1.3};
  EXPECT_DOUBLE_EQ(cell.mass(0.0078), 0.0078 * cell.cellVolume());
  EXPECT_DOUBLE_EQ(cell.inertia(0.0078), cell.mass(0.0078) * 2.5 * 2.5 * GetParam().inertia);
}

TEST_P(PackingTest, IsFoundByItsName)
{
  const Packing *found = findPacking(GetParam().name);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->coordination, GetParam().coordination);
  EXPECT_EQ(findPacking("bcc"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, PackingTest, testing::ValuesIn(packing::all),
                         [](const auto &p) { return std::string(p.param.name); });

TEST(Packing, SixContactAreasMakeTheHexagonalCellsSurface)
{
  const Cell cell{packing::hex, 2.0, 1.0}; // a hexagon of width d has the side d/sqrt(3)
  EXPECT_NEAR(cell.contactArea(), 2.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(6 * 0.5 * 0.5 * 2.0 * cell.contactArea(), cell.cellVolume(), 1e-14);
}

TEST(Packing, ContactAreasAreTheCellsFaces)
{
  // a rhombic dodecahedron of inner diameter d, and a cube
  EXPECT_NEAR((Cell{packing::fcc, 2.0}.contactArea()), 4.0 / (2.0 * std::sqrt(2.0)), 1e-15);
  EXPECT_NEAR((Cell{packing::hcp, 2.0}.contactArea()), 4.0 / (2.0 * std::sqrt(2.0)), 1e-15);
  EXPECT_NEAR((Cell{packing::sc, 2.0}.contactArea()), 4.0, 1e-15);
}

TEST(Packing, InertiaOfDiscAndBall)
{
  using mcawr::pi;
  const Cell disc{packing::hex, 2.5, 1.0}, ball{packing::fcc, 2.5};
  EXPECT_NEAR(disc.mass(0.0078) / (0.0078 * pi / 4 * 2.5 * 2.5), 2 * std::sqrt(3.0) / pi, 1e-14);
  EXPECT_NEAR(disc.inertia(0.0078), 0.5 * disc.mass(0.0078) * 1.25 * 1.25, 1e-17);
  EXPECT_NEAR(ball.inertia(0.0078), 0.4 * ball.mass(0.0078) * 1.25 * 1.25, 1e-17);
}

TEST(Packing, PlaneOnesAreProportionalToTheThickness)
{
  const Cell thin{packing::hex, 2.5, 1.0}, thick{packing::hex, 2.5, 4.0};
  EXPECT_DOUBLE_EQ(thick.cellVolume(), 4 * thin.cellVolume());
  EXPECT_DOUBLE_EQ(thick.contactArea(), 4 * thin.contactArea());
  EXPECT_DOUBLE_EQ(thick.inertia(1.0), 4 * thin.inertia(1.0));
  EXPECT_EQ((Cell{packing::fcc, 2.5, 4.0}.cellVolume()), (Cell{packing::fcc, 2.5}.cellVolume()));
}

// the farthest place of the period from all centres, by a grid of its edges
TEST(Packing, HoleIsTheFarthestPlaceFromAllCentres)
{
  for (const mca::Packing &packing : mca::packing::all) {
    const mca::Lattice lattice = mca::latticeOf(packing);
    constexpr int grid = 24; // of which thirds, quarters and halves hold the holes
    const int layers = packing.dimension == 2 ? 1 : grid;
    const auto &[a, b, c] = lattice.edges;
    double farthest = 0.0;
    for (int i = 0; i < grid; i++)
      for (int j = 0; j < grid; j++)
        for (int k = 0; k < layers; k++) {
          double nearest = HUGE_VAL;
          for (const auto &p : lattice.basis)
            for (int m = 0; m < 27; m++) {
              if (packing.dimension == 2 && m / 9 != 1)
                continue;
              const double u = static_cast<double>(i) / grid + m % 3 - 1;
              const double v = static_cast<double>(j) / grid + m / 3 % 3 - 1;
              const double w =
                  packing.dimension == 2 ? 0.0 : static_cast<double>(k) / grid + m / 9 - 1;
              nearest = std::min(nearest, std::hypot(u * a.x + v * b.x + w * c.x - p.x,
                                                     u * a.y + v * b.y + w * c.y - p.y,
                                                     u * a.z + v * b.z + w * c.z - p.z));
            }
          farthest = std::max(farthest, nearest);
        }
    EXPECT_NEAR(farthest, packing.hole, 1e-12) << packing.name;
  }
}
