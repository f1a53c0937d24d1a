// SPDX-License-Identifier: GPL-2.0-or-later
// Leading edges inside their cells: what the forces gain, and what must not change.
#include "contact/patch/solvers/edge_compliance.h"
#include "contact/patch/solvers/transient.h"
#include "patch_cases.h"
#include "shared/pi.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

/// Steady rolling on a solved normal contact, with edges inside their cells or without.
struct Rolling {
  Rolling(const PatchGrid &cells, const ElasticPair &elastic, double friction,
          NormalContactResult pressure)
      : grid(cells), pair(elastic), mu(friction), normal(std::move(pressure))
  {
  }
  TangentialProblem problem(const Creepage &creepage, bool inside) const
  {
    TangentialProblem p;
    p.bound = mu * normal.pressure;
    p.creepage = creepage;
    if (inside)
      p.edge = edgeCompliance(grid, pair, normal.pressure, normal.gap);
    return p;
  }
  PatchSums solve(const Creepage &creepage, bool inside) const
  {
    return patchSums(grid, TangentialSolver(grid, pair).solve(problem(creepage, inside)));
  }
  PatchGrid grid;
  ElasticPair pair;
  double mu;
  NormalContactResult normal;
};

Rolling sphereOn(int n, const Vector &roughness = {})
{
  const Sphere sphere;
  const HertzEllipse h = sphere.hertz();
  const PatchGrid grid = centredGrid(n, n, 2.4, 2.4);
  return {grid, sphere.pair, sphere.mu,
          pressed(grid, sphere.pair, h.curvatures.A, h.curvatures.B, sphere.load, roughness)};
}

} // namespace

TEST(PatchEdges, SpheresForcesOnFewCells)
{
  // Against the limits of test_patch_rolling.cpp (+-.0006), on 20 and 40 cells a diameter: less
  // than a third of the error that whole cells have
  const Sphere sphere;
  const struct {
    Creepage scaled;
    double force;
    bool alongY;
  } cases[] = {{{0.02329, 0.0, 0.0}, -0.0968, false},
               {{0.23291, 0.0, 0.0}, -0.7220, false},
               {{0.0, 0.16, 0.0}, -0.4921, true},
               {{0.0, 0.0, 0.2}, -0.2882, true}};
  for (const int n : {24, 48}) {
    const Rolling rolling = sphereOn(n);
    for (const auto &c : cases) {
      const Creepage creepage{c.scaled.xi * sphere.creepUnit(), c.scaled.eta * sphere.creepUnit(),
                              c.scaled.phi * sphere.creepUnit()};
      const auto error = [&](bool inside) {
        const PatchSums sums = rolling.solve(creepage, inside);
        const double force = c.alongY ? sums.forceY : sums.forceX;
        return std::abs(force / (sphere.mu * sphere.load) - c.force);
      };
      EXPECT_LT(error(true), error(false) / 3.0 + 0.0006) << n;
      EXPECT_LT(error(true), (n == 24 ? 0.03 : 0.015) * std::abs(c.force) + 0.0006) << n;
    }
  }
}

TEST(PatchEdges, CarterOnARowOfLongCells)
{
  // -Fx/(mu N) = .19, .64, .91 at .1, .4, .7 of the creep of full sliding; whole cells are off by
  // .34/n of it
  const ElasticPair pair{1.0, 0.28};
  const double peak = 1e-3, mu = 0.3, length = 1000.0;
  const double radius = 0.5 * pair.G / (1.0 - pair.nu) / peak;
  const double load = 0.5 * mcawr::pi * peak * length;
  const double creeps[] = {0.1, 0.4, 0.7}, exact[] = {0.19, 0.64, 0.91};
  for (const int n : {50, 101, 200}) {
    const double dx = 2.0 / n;
    const PatchGrid grid{{n + 2, 1, dx, length}, -1.0 - dx, -0.5 * length};
    const Rolling rolling(grid, pair, mu, pressed(grid, pair, 0.5 / radius, 0.0, load));
    for (int i = 0; i < 3; ++i) {
      const auto error = [&](bool inside) {
        const PatchSums sums = rolling.solve({creeps[i] * mu / radius, 0.0, 0.0}, inside);
        return std::abs(-sums.forceX / (mu * load) - exact[i]);
      };
      EXPECT_LT(error(true), error(false) / 3.0) << n << " " << creeps[i];
    }
  }
}

TEST(PatchEdges, OnlyLeadingCellsOfAnEllipse)
{
  const Rolling rolling = sphereOn(48);
  const EdgeCompliance edge =
      edgeCompliance(rolling.grid, rolling.pair, rolling.normal.pressure, rolling.normal.gap);
  for (int iy = 0; iy < rolling.grid.ny; ++iy)
    for (int ix = 0; ix < rolling.grid.nx; ++ix) {
      const int i = rolling.grid.index(ix, iy);
      const bool leading =
          rolling.normal.pressure[i] > 0.0 && rolling.normal.pressure[i + 1] == 0.0;
      if (!leading) {
        ASSERT_EQ(edge.xx[i], 0.0);
        ASSERT_EQ(edge.yy[i], 0.0);
        ASSERT_EQ(edge.xy[i], 0.0);
      }
      // mirrored in y: the shear term changes its sign
      const int mirrored = rolling.grid.index(ix, rolling.grid.ny - 1 - iy);
      ASSERT_NEAR(edge.xx[i], edge.xx[mirrored], 1e-5 * rolling.grid.dx);
      ASSERT_NEAR(edge.xy[i], -edge.xy[mirrored], 1e-5 * rolling.grid.dx);
    }
}

TEST(PatchEdges, FullSlidingCarriesAllFriction)
{
  const Sphere sphere;
  const HertzEllipse h = sphere.hertz();
  const PatchGrid grid = centredGrid(48, 48, 3.4, 3.4);
  const Rolling rolling(grid, sphere.pair, sphere.mu,
                        pressed(grid, sphere.pair, h.curvatures.A, h.curvatures.B, sphere.load,
                                waves(grid, 0.02, 0.25, 1.0, 1)));
  const PatchSums sums = rolling.solve({100.0 * sphere.creepUnit(), 0.0, 0.0}, true);
  EXPECT_EQ(sums.stickArea, 0.0);
  EXPECT_NEAR(-sums.forceX, sphere.mu * sphere.load, 1e-3 * sphere.mu * sphere.load);
}

TEST(PatchEdges, RollingBecomesSteady)
{
  // A step of one cell has the same compliance at its edges, so that a smooth contact that rolls on
  // stays at the steady traction
  const Sphere sphere;
  const Rolling rolling = sphereOn(40);
  const TangentialProblem problem =
      rolling.problem({0.15 * sphere.creepUnit(), 0.1 * sphere.creepUnit(), 0.0}, true);
  TangentialOptions tight;
  tight.tolerance = 1e-8;
  const TangentialResult steady =
      TangentialSolver(rolling.grid, rolling.pair).solve(problem, tight);
  TransientPatch patch(rolling.grid, rolling.pair);
  patch.startFrom(steady.traction);
  TransientPatch::Step step;
  step.bound = problem.bound;
  step.creepage = problem.creepage;
  step.edge = problem.edge;
  const TangentialResult next = patch.step(step, tight);
  EXPECT_LT((next.traction.x - steady.traction.x).norm(), 1e-6 * steady.traction.x.norm());
  EXPECT_LT((next.traction.y - steady.traction.y).norm(), 1e-6 * steady.traction.y.norm());
}
