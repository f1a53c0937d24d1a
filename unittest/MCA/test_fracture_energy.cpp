// SPDX-License-Identifier: GPL-2.0-or-later
// fracture energy. The comparisons of every criterion with the slow reference (test_kernel.cpp,
// test_kernel_space.cpp) take it, too, with the formula that stands here.
#include "laws/fracture/by_energy.h"
#include "sample.h"
#include "sample_space.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mca;

namespace {

// Density of elastic energy of a solid, sigma:eps/2, with Lame's constant of the laws.
double sideOf(const reference::LinkView &l, const Material &m, double mean)
{
  const double E = m.youngsModulus, nu = m.poissonsRatio, G = E / 2 / (1 + nu);
  const bool planeStress = l.laws.plane.word() == "stress";
  const double lame = l.laws.elasticity.word() == "pairwise" ? 0
                      : planeStress                          ? E * nu / (1 - nu * nu)
                                                             : E * nu / (1 + nu) / (1 - 2 * nu);
  const double bulk = planeStress ? 2.0 / 3 * (G + lame) : E / 3 / (1 - 2 * nu);
  const double trace = mean / bulk;
  return l.dimension * G * (l.e * l.e + l.gamma * l.gamma) + lame * trace * trace / 2;
}

const bool known = [] {
  reference::criteria()["energy"] = [](const reference::LinkView &l) {
    const double density = (sideOf(l, l.a, l.meanA) + sideOf(l, l.b, l.meanB)) / 2;
    const double limitA = l.a.strength * l.a.strength / 2 / l.a.youngsModulus;
    const double limitB = l.b.strength * l.b.strength / 2 / l.b.youngsModulus;
    return density >= std::fmin(limitA, limitB);
  };
  return true;
}();

PairLaw lawOf(const std::vector<std::string> &words, const Packing &packing)
{
  LawSet set;
  std::vector<std::string> all = {"fracture", "energy", "plasticity", "none"};
  all.insert(all.end(), words.begin(), words.end());
  EXPECT_EQ(set.parse(all), "");
  return makePairLaw(set, steel(), steel(), 1.0, packing);
}

// Unit normals of the contacts of an automaton inside.
std::vector<Eigen::Vector3d> normalsOf(const Packing &packing)
{
  std::vector<Eigen::Vector3d> all;
  if (packing.dimension == 2)
    for (int k = 0; k < 6; k++)
      all.emplace_back(std::cos(k * std::acos(-1.0) / 3), std::sin(k * std::acos(-1.0) / 3), 0);
  else
    for (int k = 0; k < 12; k++) { // along the diagonals of a cube's faces
      Eigen::Vector3d n(k & 1 ? 1 : -1, k & 2 ? 1 : -1, 0);
      all.push_back(Eigen::Vector3d(n[k / 4], n[(k / 4 + 1) % 3], n[(k / 4 + 2) % 3]).normalized());
    }
  return all;
}

LinkLoad loadOf(const Eigen::Matrix3d &eps, const Eigen::Vector3d &n, double mean)
{
  LinkLoad load{};
  load.e = n.dot(eps * n);
  load.gamma = (eps * n - load.e * n).norm();
  load.meanI = load.meanJ = mean;
  return load;
}

} // namespace

TEST(FractureEnergy, MeanOfTheContactsIsTheSolidsInUniaxialTension)
{
  const Material m = steel();
  const double sigma = 70, E = m.youngsModulus, nu = m.poissonsRatio;
  ASSERT_TRUE(known);
  for (const Packing &packing : {packing::hex, packing::fcc}) {
    const bool plane = packing.dimension == 2;
    const PairLaw law = plane ? lawOf({"plane", "stress"}, packing) : lawOf({}, packing);
    Eigen::Matrix3d eps = Eigen::Vector3d(1, -nu, plane ? 0 : -nu).asDiagonal();
    eps *= sigma / E;
    double sum = 0;
    const auto normals = normalsOf(packing);
    for (const auto &n : normals)
      sum += FractureByEnergy::density(loadOf(eps, n, sigma / 3), law.limits.fracture);
    EXPECT_NEAR(sum / packing.coordination, sigma * sigma / 2 / E, 1e-12 * sigma * sigma / E);
    EXPECT_EQ(static_cast<int>(normals.size()), packing.coordination);
  }
}

TEST(FractureEnergy, BreaksABulkLinkAtTheEnergyOfTheStrength)
{
  const Material m = steel();
  const PairLaw law = lawOf({}, packing::fcc);
  const double limit = m.strength * m.strength / 2 / m.youngsModulus;
  EXPECT_DOUBLE_EQ(law.limits.fracture.value[0], limit);
  const double strain = std::sqrt(limit / 3 / m.shearModulus());
  for (const double factor : {1 - 1e-12, 1 + 1e-12})
    for (const bool shear : {false, true}) {
      LinkLoad load{};
      (shear ? load.gamma : load.e) = -factor * strain; // of either sign
      EXPECT_EQ(bulkBreaks(law.limits, load), factor > 1);
    }
  LinkLoad pressed{};
  pressed.meanI = pressed.meanJ = -1e3;
  EXPECT_TRUE(bulkBreaks(law.limits, pressed));
  // what would break does not heal
  EXPECT_EQ(nextKind(link::weld, -1e3, 0, bulkBreaks(law.limits, pressed), law.limits), link::weld);
  EXPECT_EQ(nextKind(link::weld, -1e3, 0, bulkBreaks(law.limits, {}), law.limits), link::bulk);
}

TEST(FractureEnergy, TheWeakerMaterialDecides)
{
  LawSet set;
  ASSERT_EQ(set.parse({"fracture", "energy"}), "");
  Material tough = steel();
  tough.strength *= 3;
  tough.youngsModulus *= 2; // more energy all the same
  const PairLaw law = makePairLaw(set, steel(), tough, 1.0),
                turned = makePairLaw(set, tough, steel(), 1.0);
  EXPECT_DOUBLE_EQ(law.limits.fracture.value[0], 92.0 * 92.0 / 2 / 206000);
  EXPECT_EQ(law.limits.fracture.value[0], turned.limits.fracture.value[0]);
  EXPECT_EQ(law.limits.fracture.value[2], turned.limits.fracture.value[3]);
}

TEST(FractureEnergy, WordsReadBack)
{
  LawSet set, again;
  ASSERT_EQ(set.parse({"fracture", "energy", "link_work", "0.5"}), "");
  ASSERT_EQ(again.parse(set.words()), "");
  EXPECT_EQ(again.fracture.word(), "energy");
  EXPECT_EQ(again.words(), set.words());
  EXPECT_EQ(set.notInDimension(3), "");
  EXPECT_FALSE(set.fracture.criterion().needsLocalStress);
}

// A block under uniaxial tension along a row of contacts: these break first, in the step in which
// their density reaches the limit.
TEST(FractureEnergy, LinksAlongTheTensionBreakFirst)
{
  const Material m = steel();
  const double E = m.youngsModulus, nu = m.poissonsRatio;
  for (const Kernel *kernel : supportedKernels(2)) {
    reference::Sample s = periodicBlock(m, 8, 6, 1);
    ASSERT_EQ(s.laws.parse({"fracture", "energy", "plane", "stress", "plasticity", "none"}), "");
    const FractureLimits limits = makePairLaw(s.laws, m, m, 1.0).limits.fracture;
    KernelRun run(*kernel, s, false);
    const double increment = 1e-6;
    double strain = 0, density = 0;
    for (int k = 0; k < 1000 && s.changed == 0; k++) {
      strain += increment;
      for (auto &a : s.automata) {
        const double x = a.x, y = a.y;
        a.vx = increment * x / (1 + strain - increment);
        a.vy = -nu * increment * y / (1 - nu * (strain - increment));
        a.x = x + a.vx;
        a.y = y + a.vy;
      }
      run.step(s, 1.0);
      LinkLoad row{};
      row.e = strain;
      row.meanI = row.meanJ = strain * E / 3;
      const double before = density;
      density = FractureByEnergy::density(row, limits);
      if (s.changed > 0) {
        EXPECT_LT(before, limits.value[0] * (1 + 1e-9));
      }
    }
    EXPECT_GE(density, limits.value[0] * (1 - 1e-9));
    EXPECT_EQ(s.changed, 48); // one link of each automaton lies along the tension
    // a third of the links bears more than the mean: they break below the strength
    EXPECT_LT(strain * E, m.strength);
    EXPECT_GT(strain * E, 0.7 * m.strength);
    for (const auto &c : s.contacts) {
      const bool along = std::abs(s.automata[c.j].y - s.automata[c.i].y) < 0.1;
      EXPECT_EQ(c.next.kind > 0, !along);
    }
  }
}
