// SPDX-License-Identifier: GPL-2.0-or-later
#include "laws/fracture_criteria.h"
#include "laws/plasticity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace mca;

TEST(Fracture, StrainIntensityOfPureOpening)
{
  EXPECT_DOUBLE_EQ(strainIntensity2(0.04, 0.0), 0.04 * 0.04);
  EXPECT_EQ(strainIntensity2(-0.04, 0.0), 0.0); // compression does not break
  EXPECT_EQ(strainIntensity2(0.0, 0.0), 0.0);
}

TEST(Fracture, StrainIntensityOfShearHasNoSign)
{
  EXPECT_DOUBLE_EQ(strainIntensity2(0.0, 0.03), 4.0 / 3 * 0.03 * 0.03);
  EXPECT_EQ(strainIntensity2(0.0, -0.03), strainIntensity2(-0.01, 0.03));
  EXPECT_DOUBLE_EQ(strainIntensity2(0.02, 0.03), 0.02 * 0.02 + 4.0 / 3 * 0.03 * 0.03);
}

TEST(Fracture, LinkIntensity)
{
  EXPECT_DOUBLE_EQ(linkIntensity2(92, 0), 92.0 * 92.0);
  EXPECT_EQ(linkIntensity2(-92, 0), 0.0);
  EXPECT_DOUBLE_EQ(linkIntensity2(30, -40), 30.0 * 30.0 + 3 * 40.0 * 40.0);
  EXPECT_DOUBLE_EQ(linkIntensity2(-30, 40), 3 * 40.0 * 40.0);
}

TEST(Fracture, EquivalentStressIsVonMisesInAnyFrame)
{
  const StressTensor s{80, -30, 25, 10};
  const double strength = stressIntensity(s);
  const double mean = (s.xx + s.yy + s.zz) / 3;
  for (const double angle : {0.0, 0.4, 1.9, -2.5}) {
    const double nx = std::cos(angle), ny = std::sin(angle);
    const double sigma = s.xx * nx * nx + s.yy * ny * ny + 2 * s.xy * nx * ny;
    const double tau = (s.yy - s.xx) * nx * ny + s.xy * (nx * nx - ny * ny);
    LocalStress local = faceStress(automatonStress(s.xx, s.yy, s.xy, mean), PlaneVector{nx, ny});
    local.sigma = sigma;
    local.tau = tau;
    EXPECT_NEAR(local.along, s.xx + s.yy - sigma, 1e-12);
    EXPECT_NEAR(local.across, s.zz, 1e-12);
    EXPECT_TRUE(reaches(local, druckerPrager(strength * (1 - 1e-12), 1.0)));
    EXPECT_FALSE(reaches(local, druckerPrager(strength * (1 + 1e-12), 1.0)));
  }
}

TEST(Fracture, EquivalentStressIsVonMisesInSpaceInAnyFrame)
{
  const StressTensor s{80, -30, 25, 10, -15, 40};
  const double strength = stressIntensity(s);
  for (const Vector &direction :
       {Vector{1, 0, 0}, Vector{0, 0, 1}, Vector{1, 2, -3}, Vector{-0.3, 0.1, 0.2}}) {
    const Vector n = 1.0 / length(direction) * direction;
    const Vector t = {s.xx * n.x + s.xy * n.y + s.xz * n.z, s.xy * n.x + s.yy * n.y + s.yz * n.z,
                      s.xz * n.x + s.yz * n.y + s.zz * n.z};
    LocalStress local = faceStress(s, n);
    local.sigma = dot(t, n);
    local.tau = length(t - local.sigma * n);
    EXPECT_NEAR(local.sigma + local.along + local.across, s.xx + s.yy + s.zz, 1e-12);
    EXPECT_TRUE(reaches(local, druckerPrager(strength * (1 - 1e-12), 1.0)));
    EXPECT_FALSE(reaches(local, druckerPrager(strength * (1 + 1e-12), 1.0)));
  }
}

TEST(Fracture, AFaceUnderPressureHasTwoEqualPrincipalStresses)
{
  const LocalStress face = faceStress(StressTensor{-7, -7, 0, -7}, Vector{0.6, 0.0, 0.8});
  EXPECT_NEAR(face.along, -7, 1e-6); // the root of a difference that rounding leaves
  EXPECT_NEAR(face.across, -7, 1e-6);
}

TEST(Fracture, FaceOfThePlaneIsThatOfSpace)
{
  const StressTensor s{80, -30, 25, 10};
  const LocalStress plane = faceStress(s, PlaneVector{0.6, 0.8});
  const LocalStress space = faceStress(s, Vector{0.6, 0.8, 0.0});
  EXPECT_NEAR(std::max(plane.along, plane.across), space.along, 1e-12);
  EXPECT_NEAR(std::min(plane.along, plane.across), space.across, 1e-12);
}

/// What the cone bears in plane strain, with the stresses (sigma, 0, nu sigma) of an elastic solid:
/// |sigma|/sigma_t in compression at the limit.
static double planeStrainCompression(double ratio, double nu)
{
  const double equivalent = std::sqrt(1.0 - nu + nu * nu);
  const double rest = (ratio + 1.0) * equivalent - (ratio - 1.0) * (1.0 + nu);
  return rest > 0.0 ? 2.0 * ratio / rest : INFINITY;
}

TEST(Fracture, TheConeInPlaneStrain)
{
  const double nu = 0.3, tensile = 92;
  for (const double ratio : {1.0, 3.0, 5.0}) {
    const double p = planeStrainCompression(ratio, nu) * tensile;
    EXPECT_FALSE(reaches({-p * (1 - 1e-12), 0, 0, -nu * p}, druckerPrager(tensile, ratio)));
    EXPECT_TRUE(
        reaches({-p * (1 + 1e-9), 0, 0, -nu * p * (1 + 1e-9)}, druckerPrager(tensile, ratio)));
  }
  EXPECT_NEAR(planeStrainCompression(3, nu), 6.28, 0.005);
  const double most = mostConeRatio(nu);
  EXPECT_NEAR(most, 5.32, 0.005);
  EXPECT_GT(planeStrainCompression(most * (1 - 1e-9), nu), 1e6);
  EXPECT_EQ(planeStrainCompression(most * (1 + 1e-9), nu), INFINITY);
  EXPECT_FALSE(reaches({-1e9, 0, 0, -nu * 1e9}, druckerPrager(tensile, most + 0.1)));
}

TEST(Fracture, MohrCoulombHoldsBothStrengthsWhateverActsBetween)
{
  const double tensile = 92, ratio = 3, nu = 0.3;
  const FractureLimits limit = {{ratio, ratio * tensile}};
  const auto breaks = [&](const LocalStress &s) {
    LinkLoad load = {};
    load.local = s;
    return FractureByMohrCoulomb::broken(load, limit);
  };
  for (const double across : {0.0, nu}) {
    const auto uniaxial = [&](double s) { return breaks({s, 0, 0, across * s}); };
    EXPECT_FALSE(uniaxial(tensile * (1 - 1e-12)));
    EXPECT_TRUE(uniaxial(tensile * (1 + 1e-12)));
    EXPECT_FALSE(uniaxial(-ratio * tensile * (1 - 1e-12)));
    EXPECT_TRUE(uniaxial(-ratio * tensile * (1 + 1e-12)));
  }
  // pure shear has the principal stresses tau and -tau; a confining pressure strengthens by a
  const double tau = ratio * tensile / (ratio + 1);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_FALSE(breaks({0, sign * tau * (1 - 1e-12), 0, 0}));
    EXPECT_TRUE(breaks({0, sign * tau * (1 + 1e-12), 0, 0}));
  }
  EXPECT_FALSE(breaks({-ratio * (tensile + 49), 0, -50, -50}));
  EXPECT_TRUE(breaks({-ratio * (tensile + 51), 0, -50, -50}));
}

TEST(Fracture, DruckerPragerHoldsBothStrengths)
{
  const double tensile = 92, ratio = 3;
  const FractureLimits limit = druckerPrager(tensile, ratio);
  const auto uniaxial = [&](double sigma) { return reaches({sigma, 0, 0, 0}, limit); };
  EXPECT_FALSE(uniaxial(tensile * (1 - 1e-12)));
  EXPECT_TRUE(uniaxial(tensile * (1 + 1e-12)));
  EXPECT_FALSE(uniaxial(-ratio * tensile * (1 - 1e-12)));
  EXPECT_TRUE(uniaxial(-ratio * tensile * (1 + 1e-12)));
  // pure shear: (a+1)/2 sqrt(3) tau = a sigma_t, of either sign
  const double tau = 2 * ratio * tensile / (ratio + 1) / std::sqrt(3.0);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_FALSE(reaches({0, sign * tau * (1 - 1e-12), 0, 0}, limit));
    EXPECT_TRUE(reaches({0, sign * tau * (1 + 1e-12), 0, 0}, limit));
  }
  // hydrostatic: the apex at sigma_mean = sigma_c/(1.5 (a-1)), pressure never
  const double apex = ratio * tensile / (1.5 * (ratio - 1));
  EXPECT_FALSE(reaches({apex - 1e-9, 0, apex - 1e-9, apex - 1e-9}, limit));
  EXPECT_TRUE(reaches({apex + 1e-9, 0, apex + 1e-9, apex + 1e-9}, limit));
  EXPECT_FALSE(reaches({-1e9, 0, -1e9, -1e9}, limit));
  EXPECT_FALSE(reaches({1e9, 1e9, 0, 0}, {{1.0, 0.0, std::numeric_limits<double>::infinity()}}));
}
