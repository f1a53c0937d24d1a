// SPDX-License-Identifier: GPL-2.0-or-later
// Unlike bodies on a line (Bentall and Johnson): the influence, the printed results of CONTACT, the
// equations by a dense sum, and what must hold of rolling.
#include "case_text.h"
#include "contact/line/line_coupling.h"
#include "contact/patch/patch_contact.h"
#include "creep/line/creep_curve.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;

constexpr ElasticBody steel = {209920e6, 0.28}, aluminium = {60260e6, 0.31};

/// CONTACT's case: rollers of aluminium and steel with radii of 50 mm, a contact of 2 x 0.1 mm.
std::string rollers(const std::string &creeps, double mu, const std::string &more = "",
                    const std::string &bodies =
                        "youngs_modulus: [60260 MPa, 209920 MPa], poissons_ratio: [0.31, 0.28]")
{
  return fmt::format("contact: {{load_per_length: 16.2019 N/mm, radius: 25 mm, {}, domain: 2.16}}\n"
                     "friction: {{law: constant, mu: {}}}\nthermal: off\nspeed: 1 m/s\n"
                     "cells: 216\nfields: all\ncreep: {}\n{}",
                     bodies, mu, creeps, more);
}

CreepCurves solved(const std::string &text)
{
  const CreepSpecification asked = case_text::rolling(text);
  return solveCreepCurves(asked, asked.friction.read());
}

int count(const ContactFields &fields, Adhesion state)
{
  return static_cast<int>(std::count(fields.state.begin(), fields.state.end(), state));
}

} // namespace

TEST(ElasticBodies, EqualOnesKeepTheirModulus)
{
  const double one = 210e9 / (2.0 * (1.0 - 0.3 * 0.3));
  EXPECT_EQ(contactModulus({{{210e9, 0.3}, {210e9, 0.3}}}), one); // to the last bit
  EXPECT_EQ(couplingOf({steel, steel}), 0.0);
}

TEST(ElasticBodies, UnlikeOnesAreThoseOfThePatch)
{
  const ElasticPair pair = combinedPair(aluminium, steel);
  EXPECT_NEAR(contactModulus({aluminium, steel}) / (pair.G / (1.0 - pair.nu)), 1.0, 1e-14);
  EXPECT_NEAR(couplingOf({aluminium, steel}), pair.K / (1.0 - pair.nu), 1e-14);
  EXPECT_DOUBLE_EQ(couplingOf({steel, aluminium}), -couplingOf({aluminium, steel}));
  EXPECT_EQ(couplingOf({{{100e9, 0.5}, {3e9, 0.5}}}), 0.0);
  EXPECT_NEAR(couplingOf({{{1.0, 0.0}, {1e15, 0.3}}}), 0.5, 1e-12); // its largest value
}

TEST(LineCoupling, SlipIsTheDisplacementThatGrowsOverACell)
{
  const Vector p = Vector::Random(20).cwiseAbs();
  const Vector u = couplingDisplacement(0.2, p), slip = couplingSlip(0.2, p);
  for (int i = 0; i + 1 < p.size(); ++i)
    EXPECT_NEAR(slip[i], u[i] - u[i + 1], 1e-14);
  EXPECT_NEAR(u[0] + 0.2 * p[0], 0.2 * p.sum(), 1e-13); // the left end, and the right one
  EXPECT_NEAR(u[19] - 0.2 * p[19], -0.2 * p.sum(), 1e-13);
  EXPECT_DOUBLE_EQ(slip[19], 0.2 * p[19]);
}

TEST(LineCoupling, ReciprocalWork)
{
  // work of a pressure by the gap that a traction opens, and of that traction on the wheel, -q, by
  // the displacement under the pressure
  const Vector p = Vector::Random(30).cwiseAbs(), q = Vector::Random(30);
  EXPECT_NEAR(p.dot(couplingDisplacement(0.3, q)), -q.dot(couplingDisplacement(0.3, p)), 1e-12);
}

TEST(LineCoupling, CreepsThatContactPrints)
{
  // examples/bentall: T/(mu N) at the creep that it finds, to half a unit of the creep's last
  // digit; the largest pressure, cells that stick and cells in contact
  struct Case {
    double mu, creep, ratio, peak, error;
    int stick, contact;
  };
  for (const Case &given : {Case{1e-4, -5.260e-4, 0.0, 103.1, 2e-2, 1, 200},
                            Case{0.05, -4.294e-4, 0.0, 103.6, 4e-4, 125, 200},
                            Case{0.05, -2.108e-4, 0.75, 103.2, 2e-4, 36, 200},
                            Case{0.05, -5.392e-4, -0.75, 103.3, 3e-4, 106, 201}}) {
    const CreepCurves curves = solved(rollers(fmt::format("{}", given.creep), given.mu));
    const ContactFields &fields = curves.fields.at(1);
    EXPECT_NEAR(curves.points[0].tractionRatio / given.mu, given.ratio, given.error) << given.creep;
    EXPECT_NEAR(fields.pressure.maxCoeff() / 1e6, given.peak, 0.051) << given.creep;
    EXPECT_EQ((fields.pressure.array() > 0.0).count(), given.contact) << given.creep;
    EXPECT_NEAR(count(fields, Adhesion::Stick), given.stick, 1) << given.creep;
  }
}

TEST(LineCoupling, FreeRollingWithoutSlip)
{
  // Bufler's exact solution: creep -2 eta a/R, eta = ln[(1 + beta)/(1 - beta)]/(2 pi), on a contact
  // that is shorter than Hertz's by sqrt(1 + 4 eta^2). 2e-3 of the creep: the edges' stresses
  // oscillate. Without the coupling T/N would be -0.18.
  const double beta = couplingOf({aluminium, steel});
  const double eta = std::log((1.0 + beta) / (1.0 - beta)) / (2.0 * pi);
  const HertzContact hertz = hertzContact(16201.9, 0.025, contactModulus({aluminium, steel}));
  const double creep = -2.0 * eta * hertz.halfWidth / std::sqrt(1.0 + 4.0 * eta * eta) / 0.025;
  const CreepCurves curves = solved(rollers(fmt::format("{:.12g}", creep), 10.0));
  const double slope = initialSlope(hertz.modulus, 2.0 * hertz.halfWidth) / hertz.load;
  EXPECT_NEAR(curves.points[0].tractionRatio, 0.0, 2e-3 * std::abs(creep) * slope);
  EXPECT_EQ(count(curves.fields.at(1), Adhesion::Slip), 0);
}

TEST(LineCoupling, FieldsSatisfyTheEquations)
{
  // By dense sums with the logarithm of a loaded cell and its derivative half-way between cells:
  // one approach under all cells in contact, no slip where cells stick, slip along the traction.
  constexpr double creep = -4.294e-4, mu = 0.05;
  const CreepCurves curves = solved(rollers(fmt::format("{}", creep), mu));
  const ContactFields &fields = curves.fields.at(1);
  const ContactSetup &setup = curves.contacts[0];
  const double modulus = contactModulus({aluminium, steel});
  const double beta = couplingOf({aluminium, steel});
  const int n = setup.cells;
  const Vector p = fields.pressure / modulus, q = fields.traction / modulus;
  const auto integral = [](double x) { return x == 0.0 ? 0.0 : x * std::log(std::abs(x)) - x; };
  double lowest = 1e9, highest = -1e9, below = 0.0;
  for (int i = 0; i < n; ++i) {
    double slip = creep + beta * (p[i] + (i + 1 < n ? p[i + 1] : 0.0)), gap = setup.gap()[i];
    for (int j = 0; j < n; ++j) {
      gap -= 2.0 / pi * p[j] * (integral(i - j + 0.5) - integral(i - j - 0.5));
      slip -= 2.0 / pi * q[j] / (i - j + 0.5);
    }
    gap -= 2.0 * beta * (below + 0.5 * q[i]);
    below += q[i];
    if (p[i] > 0.0) {
      lowest = std::min(lowest, gap);
      highest = std::max(highest, gap);
    }
    EXPECT_LE(std::abs(q[i]), mu * p[i] * (1.0 + 1e-8)) << i;
    // the cells at the edges have the compliance of their share in contact, too
    if (!(p[i] > 0.0) || i < 9 || i > n - 10)
      continue;
    if (fields.state[i] == Adhesion::Stick) {
      EXPECT_NEAR(slip, 0.0, 1e-7 * std::abs(creep)) << i;
    } else {
      EXPECT_GE(slip * q[i], 0.0) << i;
    }
  }
  EXPECT_LT(highest - lowest, 1e-6 * setup.gap()[0]);
}

TEST(LineCoupling, ExchangedBodiesAreTheMirrorImage)
{
  const CreepCurves one = solved(rollers("[-4e-4, -1e-4]", 0.05));
  const CreepCurves other =
      solved(rollers("[4e-4, 1e-4]", 0.05, "",
                     "youngs_modulus: [209920 MPa, 60260 MPa], poissons_ratio: [0.28, 0.31]"));
  for (int k : {0, 1})
    EXPECT_NEAR(one.points[k].tractionRatio, -other.points[k].tractionRatio, 1e-9);
}

TEST(LineCoupling, CoefficientsThatDoNotCoupleAreThoseOfOneModulus)
{
  // nu 1/2 of both: only E* counts
  const CreepCurves unlike =
      solved(rollers("3e-4", 0.05, "", "youngs_modulus: [100 GPa, 300 GPa], poissons_ratio: 0.5"));
  const CreepCurves like = solved(rollers("3e-4", 0.05, "",
                                          "youngs_modulus: 150 GPa, "
                                          "poissons_ratio: 0.5"));
  EXPECT_NEAR(unlike.points[0].tractionRatio, like.points[0].tractionRatio, 1e-12);
  EXPECT_GT(unlike.points[0].tractionRatio, 0.0);
}

TEST(LineCoupling, SmoothMovingContactComesToTheSteadyState)
{
  for (double creep : {-2.108e-4, 3e-4}) {
    const std::string text = fmt::format("{}", creep);
    const double steady = solved(rollers(text, 0.05)).points[0].tractionRatio;
    const double moving =
        solved(rollers(text, 0.05, "mode: moving\nmoving: {passes: 4}\n")).points[0].tractionRatio;
    EXPECT_NEAR(moving, steady, 0.02 * 0.05) << creep;
  }
}

TEST(LineCoupling, HeatIsThatOfFrictionAlsoWhereTheDriveIsBraked)
{
  // near free rolling traction times creep is below 0: rolling resistance does the work
  // moving: the heat of a pass warms the next one
  for (const auto &[mode, tolerance] : {std::pair{"frozen", 1e-6}, std::pair{"moving", 0.1}}) {
    std::string text = rollers("-1e-4", 0.05, fmt::format("mode: {}\n", mode));
    text.replace(text.find("thermal: off"), 12, "thermal: {model: averaged_power}");
    const CurvePoint point = solved(text).points[0];
    EXPECT_LT(point.traction * point.creep, 0.0) << mode;
    EXPECT_GT(point.frictionWork, 0.0) << mode;
    const HertzContact hertz = hertzContact(16201.9, 25e-3, contactModulus({aluminium, steel}));
    const double rise =
        meanTemperatureRise(point.frictionWork / hertz.load * point.speed, hertz.hertzPressure,
                            hertz.halfWidth, point.speed, {50.0, 7800.0, 450.0});
    EXPECT_NEAR(point.temperatureRise, rise, tolerance * rise) << mode;
  }
}

TEST(LineCoupling, RestIsRefused)
{
  const std::string bodies =
      "youngs_modulus: [60260 MPa, 209920 MPa], poissons_ratio: [0.31, 0.28]";
  try {
    case_text::read("contact: {load_per_length: 16 N/mm, radius: 25 mm, " + bodies +
                    "}\nfriction: {law: constant, mu: 0.1}\nmode: static\n"
                    "static: {force_ratio: 0.5}\n");
    FAIL();
  } catch (const Error &error) {
    EXPECT_NE(std::string(error.what()).find(":1: contact.youngs_modulus: mode static"),
              std::string::npos)
        << error.what();
  }
}
