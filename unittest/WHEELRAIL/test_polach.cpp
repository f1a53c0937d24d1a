// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/random_number.h"
#include "creep/patch/polach_forces.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

using namespace wheelrail;

namespace {

using mcawr::pi;

/// Steel, a = 6, b = 4 mm at 100 kN; the coefficients are of the right size, that is enough here.
const PolachContact wheel{82000.0, 6.0, 4.0, 1e5, {4.6, 4.2, 1.9, 1.0}};
/// Circle of a = b = 1 with G = 1, Kalker's coefficients at nu = 0.3.
const PolachContact circle{1.0, 1.0, 1.0, 1.0, {4.2936, 3.7273, 1.4957, 1.18}};
const PolachParameters clean{0.3, 1.0, 0.0, 1.0, 1.0};
const PolachParameters wet{0.3, 0.4, 0.2, 0.3, 0.1}; // Polach 2005, Table 2

std::vector<PolachPoint> curve(const PolachParameters &p, double noise, bool withLateral,
                               const std::vector<double> &speeds, double spin = 0.0)
{
  std::vector<PolachPoint> points;
  std::uint64_t k = 0;
  const auto random = [&] { return noise * (2.0 * uniformNumber(11, k++) - 1.0); };
  for (const double speed : speeds)
    for (const double creep : {2e-4, 5e-4, 1e-3, 2e-3, 4e-3, 8e-3, 0.02, 0.05, 0.1, 0.2}) {
      std::vector<PolachState> states = {{creep, 0.0, 0.0, speed, 1e5}};
      if (withLateral)
        states.push_back({0.5 * creep, -creep, spin, speed, 8e4});
      for (const PolachState &s : states) {
        const PolachForce f = polachForce(p, wheel, s);
        points.push_back({s, f.x + s.load * random(), f.y + s.load * random()});
      }
    }
  return points;
}

std::string messageOf(const std::vector<PolachPoint> &points)
{
  try {
    choosePolach(points, wheel);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::NotConverged);
    return error.what();
  }
  return "";
}

} // namespace

/// With kA = kS = 1 and constant friction: F = (2 N mu/pi) [eps/(1 + eps^2) + atan(eps)].
TEST(Polach, TheFormOf1999)
{
  const double load = 1e5, epsilonPerCreep = 82000.0 * pi * 6.0 * 4.0 * 4.6 / (4.0 * load * 0.3);
  for (const double epsilon : {0.01, 0.5, 1.0, 7.0}) {
    const PolachForce f =
        polachForce(clean, wheel, {epsilon / epsilonPerCreep, 0.0, 0.0, 20.0, load});
    const double expected =
        2.0 * load * 0.3 / pi * (epsilon / (1.0 + epsilon * epsilon) + std::atan(epsilon));
    EXPECT_NEAR(f.x, -expected, 1e-12 * expected);
    EXPECT_EQ(f.y, 0.0);
  }
}

/// Small creepages: (kA + kS)/2 times Kalker's linear theory, the spin's part too, at any load.
TEST(Polach, BeginsWithKalkersLinearTheory)
{
  const double small = 1e-9;
  for (const PolachParameters &p : {clean, wet})
    for (const double load : {1e5, 3e4}) {
      const double k = 0.5 * (p.kA + p.kS), growth = std::cbrt(load / 1e5);
      const double a = 6.0 * growth, b = 4.0 * growth, G = 82000.0;
      const double tolerance = 1e-5; // relative
      const double x = -k * G * a * b * 4.6 * small, y = -k * G * a * b * 4.2 * small;
      const double spin = -k * G * std::pow(a * b, 1.5) * 1.9 * small;
      EXPECT_NEAR(polachForce(p, wheel, {small, 0.0, 0.0, 10.0, load}).x, x, -tolerance * x);
      EXPECT_NEAR(polachForce(p, wheel, {0.0, small, 0.0, 10.0, load}).y, y, -tolerance * y);
      EXPECT_NEAR(polachForce(p, wheel, {0.0, 0.0, small, 10.0, load}).y, spin, -tolerance * spin);
    }
}

TEST(Polach, EndsWithFullSliding)
{
  // kS eps >> 1: F = mu(w) N against the creep
  PolachContact stiff = wheel;
  stiff.shearModulus *= 1e4;
  const PolachForce f = polachForce(wet, stiff, {0.3, -0.4, 0.0, 20.0, 1e5});
  const double mu = polachFriction(wet, 0.5 * 20.0);
  EXPECT_NEAR(mu, 0.3 * (0.6 * std::exp(-2.0) + 0.4), 1e-15);
  EXPECT_NEAR(f.x, -0.6 * mu * 1e5, 1e-5 * mu * 1e5);
  EXPECT_NEAR(f.y, 0.8 * mu * 1e5, 1e-5 * mu * 1e5);
  EXPECT_EQ(polachForce(wet, wheel, {0.0, 0.0, 0.0, 20.0, 1e5}).x, 0.0);
}

/// The exact theory's forces on a sphere (nu = 0.3, mu N = 1, G a^2/(mu N) = 1): Polach's smooth
/// law is known to lie a few per cent above it.
TEST(Polach, IsNearTheExactTheory)
{
  const auto at = [](double creep, double lateral, double spin) {
    return polachForce({1.0, 1.0, 0.0, 1.0, 1.0}, circle, {creep, lateral, spin, 1.0, 1.0});
  };
  EXPECT_NEAR(at(0.02329, 0.0, 0.0).x, -0.0968, 0.05 * 0.0968);
  EXPECT_NEAR(at(0.23291, 0.0, 0.0).x, -0.7220, 0.05 * 0.7220);
  EXPECT_NEAR(at(0.0, 0.16, 0.0).y, -0.4921, 0.08 * 0.4921);
  EXPECT_NEAR(at(0.0, 0.0, 0.2).y, -0.2882, 0.08 * 0.2882);
}

TEST(Polach, SpinWidensTheLateralCreepage)
{
  // phi a and eta of opposite signs, phi a the smaller one: eta is kept
  const PolachForce against = polachForce(clean, wheel, {0.0, 1e-3, -1e-4, 10.0, 1e5});
  const PolachForce with = polachForce(clean, wheel, {0.0, 1e-3, 1e-4, 10.0, 1e5});
  EXPECT_LT(with.y, against.y); // both forces towards -y add up
  const PolachForce mirror = polachForce(clean, wheel, {0.0, -1e-3, -1e-4, 10.0, 1e5});
  EXPECT_DOUBLE_EQ(mirror.y, -with.y);
}

TEST(Polach, AFitRecoversItsParameters)
{
  for (const bool withLateral : {false, true}) {
    const PolachFit fit =
        fitPolach(curve(wet, 0.0, withLateral, {5.0, 30.0}, 1e-4), wheel, PolachFriction::Falling);
    EXPECT_EQ(fit.notIdentifiable, "");
    EXPECT_NEAR(fit.parameters.mu0, wet.mu0, 1e-6);
    EXPECT_NEAR(fit.parameters.A, wet.A, 1e-6);
    EXPECT_NEAR(fit.parameters.B, wet.B, 1e-6);
    EXPECT_NEAR(fit.parameters.kA, wet.kA, 1e-6);
    EXPECT_NEAR(fit.parameters.kS, wet.kS, 1e-6);
    EXPECT_LT(fit.worst, 1e-8);
  }
}

/// The standard errors are those of the scatter: noise of 0.005 (uniform) moves each parameter by
/// less than four of them, and by more than nothing.
TEST(Polach, StandardErrorsFollowTheScatter)
{
  const double noise = 0.005;
  const PolachFit fit =
      fitPolach(curve(wet, noise, true, {5.0, 30.0}, 1e-4), wheel, PolachFriction::Falling);
  EXPECT_NEAR(fit.rms, noise / std::sqrt(3.0), 0.3 * noise / std::sqrt(3.0));
  const auto &p = fit.parameters;
  const std::array<double, 5> off = {p.mu0 - wet.mu0, p.A - wet.A, p.B - wet.B, p.kA - wet.kA,
                                     p.kS - wet.kS};
  for (int k = 0; k < polachParameters; ++k) {
    EXPECT_GT(fit.standardError[k], 0.0);
    EXPECT_LT(std::abs(off[k]), 4.0 * fit.standardError[k]) << polachParameterNames[k];
  }
  const PolachFit tenth =
      fitPolach(curve(wet, 0.1 * noise, true, {5.0, 30.0}, 1e-4), wheel, PolachFriction::Falling);
  EXPECT_NEAR(tenth.standardError[0] / fit.standardError[0], 0.1, 0.02);
}

TEST(Polach, ConstantFrictionIsFoundToBeConstant)
{
  const PolachParameters dry{0.35, 1.0, 0.0, 0.9, 0.5};
  const auto points = curve(dry, 0.002, true, {20.0});
  const PolachChoice choice = choosePolach(points, wheel);
  EXPECT_EQ(choice.best.friction, PolachFriction::Constant);
  EXPECT_NE(choice.reason, "");
  EXPECT_NEAR(choice.best.parameters.mu0, 0.35, 4.0 * choice.best.standardError[0]);
  EXPECT_EQ(choice.best.parameters.A, 1.0);
  EXPECT_EQ(choice.best.standardError[2], 0.0);
  EXPECT_EQ(choosePolach(curve(wet, 0.002, true, {5.0, 30.0}), wheel).best.friction,
            PolachFriction::Falling);
}

/// A little too soft a curve of constant friction must not become one that falls to nothing: A and
/// B would be fitted to the misfit.
TEST(Polach, AFallNeedsSlipSpeedsThatShowIt)
{
  const PolachParameters falling{0.35, 0.4, 0.1, 0.9, 0.5};
  auto points = curve(falling, 0.002, true, {0.2}); // slips by up to 0.04 m/s
  const PolachFit fit = fitPolach(points, wheel, PolachFriction::Falling);
  EXPECT_NE(fit.notIdentifiable, "");
  EXPECT_EQ(choosePolach(points, wheel).best.friction, PolachFriction::Constant);
  points = curve(falling, 0.002, true, {20.0, 80.0});
  EXPECT_EQ(choosePolach(points, wheel).best.friction, PolachFriction::Falling);
}

TEST(Polach, WhatIsNotInThePointsIsSaid)
{
  std::vector<PolachPoint> linear; // the linear part: only mu0's and the factors' combination
  for (const double creep : {1e-7, 2e-7, 3e-7, 5e-7, 1e-6, 2e-6, 3e-6})
    linear.push_back({{creep, 0.0, 0.0, 10.0, 1e5}, -3e8 * creep, 0.0});
  EXPECT_NE(messageOf(linear).find("not identifiable"), std::string::npos) << messageOf(linear);
  std::vector<PolachPoint> sliding; // full sliding: nothing of kA and kS
  for (const double creep : {0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
    sliding.push_back({{creep, 0.0, 0.0, 10.0, 1e5}, -3e4, 0.0});
  EXPECT_NE(messageOf(sliding).find("not identifiable"), std::string::npos) << messageOf(sliding);
  linear.resize(3);
  EXPECT_NE(messageOf(linear).find("3 forces"), std::string::npos);
  const auto still = fitPolach(curve(clean, 0.0, false, {0.0}), wheel, PolachFriction::Falling);
  EXPECT_NE(still.notIdentifiable.find("no point slips"), std::string::npos);
}

TEST(Polach, ForcesThatAreNotFiniteAreRefused)
{
  auto points = curve(wet, 0.0, false, {5.0});
  points[2].forceX = NAN;
  EXPECT_THROW(fitPolach(points, wheel, PolachFriction::Constant), std::invalid_argument);
  points[2].forceX = 0.0;
  points[2].state.load = 0.0;
  EXPECT_THROW(fitPolach(points, wheel, PolachFriction::Constant), std::invalid_argument);
}

// Spin that outweighs the creepages is not in the form: neither mu0 nor kS may pay for it.
TEST(Polach, SpinIsFittedWhereTheFormCan)
{
  const PolachParameters dry{0.35, 1.0, 0.0, 0.8, 0.6};
  EXPECT_TRUE(isInPolachsSpin({1e-3, 0.0, 1e-4, 10.0, 1e5}, wheel)); // 6e-4 at the edge
  EXPECT_FALSE(isInPolachsSpin({5e-4, 0.0, -1e-4, 10.0, 1e5}, wheel));
  EXPECT_TRUE(isInPolachsSpin({5e-4, 0.0, -1e-4, 10.0, 1e4}, wheel)); // a smaller contact
  // true points without spin, and forces with spin that are a third of the form's
  auto points = curve(dry, 0.0, false, {10.0});
  const auto plain = points.size();
  for (const double creep : {1e-4, 3e-4, 1e-3, 3e-3}) {
    const PolachState state{creep, 0.0, 2e-3, 10.0, 1e5};
    const PolachForce f = polachForce(dry, wheel, state);
    points.push_back({state, f.x / 3.0, f.y / 3.0});
  }
  PolachChoice choice = choosePolach(points, wheel);
  EXPECT_EQ(choice.leftOut, 4);
  double largest = 0.0;
  for (const PolachPoint &point : points)
    largest = std::max(largest, std::hypot(point.forceX, point.forceY) / point.state.load);
  EXPECT_LE(choice.best.parameters.mu0, largest);
  EXPECT_NEAR(choice.best.parameters.mu0, dry.mu0, 0.02 * dry.mu0);
  EXPECT_LT(choice.best.worst, 0.01);
  EXPECT_GT(choice.worstLeftOut, 0.01);
  EXPECT_NE(choice.warning.find("4 of 14 operating points"), std::string::npos) << choice.warning;
  EXPECT_EQ(nlohmann::json::parse(polachJson(choice, wheel))["points_left_out"], 4);
  points.resize(plain);
  EXPECT_EQ(choosePolach(points, wheel).warning, "");
}

// Measured with the contact of an elongated ellipse, mu = 0.35, spin 0.3 1/m on all points.
TEST(Polach, WithTooMuchSpinMu0StaysBelowWhatWasSeen)
{
  const PolachContact ellipse{82031.0, 4.8014668, 17.498892, 110e3, {2.9, 3.1, 0.9, 2.0}};
  const double forces[][3] = {{1e-4, -952.80, -9835.58},   {3e-4, -2855.23, -9821.18},
                              {1e-3, -9432.56, -9649.59},  {2e-3, -18340.25, -9077.85},
                              {3e-3, -26167.38, -8159.63}, {5e-3, -36440.82, -5415.65},
                              {1e-2, -38386.94, -1267.77}, {2e-2, -38477.17, -328.47}};
  std::vector<PolachPoint> points;
  for (const auto &[creep, x, y] : forces)
    points.push_back({{creep, 0.0, 3e-4, 20.0, 110e3}, x, y});
  const PolachChoice choice = choosePolach(points, ellipse);
  EXPECT_LE(choice.best.parameters.mu0, 0.35);
  EXPECT_NE(choice.warning.find("points have more spin"), std::string::npos) << choice.warning;
}

TEST(Polach, FilesHoldParametersAndPoints)
{
  const auto points = curve(wet, 0.002, true, {5.0, 30.0});
  const PolachChoice choice = choosePolach(points, wheel);
  const auto json = nlohmann::json::parse(polachJson(choice, wheel));
  EXPECT_EQ(json["format"], "mca-polach 1");
  EXPECT_EQ(json["kA"].get<double>(), choice.best.parameters.kA);
  EXPECT_EQ(json["standard_error"]["B"].get<double>(), choice.best.standardError[2]);
  EXPECT_EQ(json["friction"], "falling");
  EXPECT_EQ(json["in_polachs_range"], true);
  const std::string table = polachCsv(choice, wheel, points);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2 + static_cast<int>(points.size()));
  const std::string row = table.substr(table.rfind('\n', table.size() - 2) + 1);
  double v[9];
  ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", v, v + 1, v + 2, v + 3,
                        v + 4, v + 5, v + 6, v + 7, v + 8),
            9);
  const PolachForce f = polachForce(choice.best.parameters, wheel, points.back().state);
  EXPECT_NEAR(v[0], points.back().state.creep, 1e-12);
  EXPECT_NEAR(v[6], points.back().forceY, 1e-4);
  EXPECT_NEAR(v[7], f.x, 1e-4);
}
