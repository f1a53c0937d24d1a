// SPDX-License-Identifier: GPL-2.0-or-later
#include "case_text.h"
#include "contact/patch/patch_contact.h"
#include "contact/wear.h"
#include "creep/patch/patch_point.h"
#include "law/forms/constant.h"

#include <gtest/gtest.h>

using namespace wheelrail;

namespace {

/// A sphere of steel that slides in full: creep 10 %, mu 0.3.
PatchPoint sliding(const WearLaw &wear, double creep = 0.1)
{
  PatchContactSpecification contact;
  contact.load = {1e5};
  contact.curvatures = GapCurvatures{1.0, 1.0};
  contact.bodies = {ElasticBody{210e9, 0.3}, ElasticBody{210e9, 0.3}};
  contact.domain = 2.2;
  contact.nx = contact.ny = 32;
  const PatchContact patch = preparePatch(contact, {}, 1e5, 0, INFINITY, 0.0);
  CreepPhysics physics;
  physics.thermal.model = ThermalModel::Off;
  physics.wear = wear;
  FrozenPatch rolling(physics, patch, 0.5);
  PatchDrive drive;
  drive.creepage.xi = creep;
  return rolling.solve(ConstantLaw(0.3), 20.0, drive);
}

} // namespace

TEST(Wear, TGammaHasThreeRegimes)
{
  constexpr double MPa = 1e6, unit = 1e-3; // ug/(m mm2) in SI
  EXPECT_DOUBLE_EQ(tGammaWear(0.0), 0.0);
  EXPECT_DOUBLE_EQ(tGammaWear(5.0 * MPa), 26.5 * unit);
  EXPECT_DOUBLE_EQ(tGammaWear(50.0 * MPa), 55.0 * unit);
  EXPECT_NEAR(tGammaWear(77.2000001 * MPa), 55.0 * unit, 1e-5 * unit);
  EXPECT_NEAR(tGammaWear(87.2 * MPa), (55.0 + 619.0) * unit, 1e-9 * unit);
}

// Where all slides, the slip is the creep but for the elastic one, whose integral over the load is
// second order.
TEST(Wear, ArchardOfFullSlidingIsLoadTimesSlip)
{
  WearLaw wear;
  wear.kind = WearLaw::Kind::Archard;
  wear.coefficient = 1e-4;
  wear.hardness = 2.5e9;
  const PatchPoint point = sliding(wear);
  EXPECT_NEAR(point.wearVolume, 1e-4 * 1e5 * 0.1 / 2.5e9, 2e-3 * point.wearVolume);
  // the row through the middle: load of a length 3N/(4a), spread over the way
  const double a = std::cbrt(3.0 * 1e5 * (1.0 - 0.09) * 2.0 / 210e9 / (8.0 * 1.0)); // R = 1/2
  EXPECT_NEAR(point.wearDepth, 1e-4 * 0.1 / 2.5e9 * 0.75 * 1e5 / a, 0.01 * point.wearDepth);
  EXPECT_EQ(sliding({}).wearVolume, 0.0);
}

TEST(Wear, TGammaOfFullSlidingInTheMildRegime)
{
  WearLaw wear;
  wear.kind = WearLaw::Kind::TGamma;
  wear.density = 7800.0;
  const double creep = 0.02; // index at most 0.3 x 1.6 GPa x 0.02: below 10.4 N/mm2
  const PatchPoint point = sliding(wear, creep);
  EXPECT_NEAR(point.wearVolume, 5.3e-9 * point.frictionWork / 7800.0, 1e-9 * point.wearVolume);
}

TEST(Wear, WorkAndTGammaAgree)
{
  const PatchPoint point = sliding({});
  EXPECT_NEAR(point.tGamma, 0.3 * 1e5 * 0.1, 1e-5 * point.tGamma); // and a little across
  EXPECT_NEAR(point.frictionWork, point.tGamma, 2e-3 * point.tGamma);
  EXPECT_DOUBLE_EQ(point.frictionWork * 20.0, point.frictionalPower);
  EXPECT_NEAR(point.peakTraction, 0.3 * point.peakPressure, 1e-6 * point.peakTraction);
}

TEST(Wear, IsReadFromTheCase)
{
  const std::string wheel = "contact: {load: 100 kN, youngs_modulus: 210 GPa, poissons_ratio: 0.3, "
                            "radii: {wheel_rolling: 0.5 m, rail_profile: 300 mm}}\ncreep: 0.01\n";
  const auto wearOf = [&](const std::string &text) {
    return std::get<PatchSpecification>(case_text::read(wheel + text).task).physics.wear;
  };
  const WearLaw archard = wearOf("wear: {law: archard, coefficient: 1e-4, hardness: 2600 MPa}\n");
  EXPECT_EQ(archard.kind, WearLaw::Kind::Archard);
  EXPECT_EQ(archard.hardness, 2.6e9);
  EXPECT_EQ(wearOf("wear: {law: t_gamma}\n").density, 7800.0);
  EXPECT_EQ(wearOf("").kind, WearLaw::Kind::None);
  EXPECT_THROW(wearOf("wear: {law: t_gamma, hardness: 2 GPa}\n"), Error);
}
