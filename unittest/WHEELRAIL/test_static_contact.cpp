// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "case_text.h"
#include "contact_cases.h"
#include "creep/line/static_contact.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;
using contact_cases::cylinder;
using contact_cases::table2;

namespace {
using mcawr::pi;

StaticCases solve(const std::string &text)
{
  const StaticSpecification asked = case_text::still(text);
  return solveStaticCases(asked, *asked.friction.read());
}
} // namespace

TEST(StaticTraction, CattaneoMindlin)
{
  // Stick zone in the middle, half-width a sqrt(1 - T/(mu N)); q = mu p0 [sqrt(1-x^2) - c sqrt(..)]
  const int n = 2000;
  HalfPlane plane(n, Boundary::Free);
  const NormalContactProblem problem = cylinder(n);
  const double mu = 0.3, force = 0.6, c = std::sqrt(1.0 - force), h = 4.0 / n;
  const NormalContactResult normal = solveNormalContact(plane, problem);
  const StaticTraction solved = staticTraction(plane, problem, normal, mu, force);
  const Vector &q = solved.traction;
  ASSERT_EQ(solved.stick.size(), 1u);
  EXPECT_NEAR(solved.stick[0].length(), 2.0 * c / h, 0.02);
  EXPECT_NEAR(solved.stick[0].left + solved.stick[0].right, n - 1.0, 1e-3); // centred
  EXPECT_NEAR(q.sum() / (mu * problem.load), force, 1e-9);
  const double p0 = table2().hertzPressure / table2().modulus;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5 - n / 2) * h;
    const double outer = std::abs(x) < 1.0 ? std::sqrt(1.0 - x * x) : 0.0;
    const double inner = std::abs(x) < c ? c * std::sqrt(1.0 - x * x / (c * c)) : 0.0;
    if (std::abs(std::abs(x) - 1.0) < 3 * h || std::abs(std::abs(x) - c) < 3 * h)
      continue;
    EXPECT_NEAR(q[i] / (mu * p0), outer - inner, 2e-3) << x;
  }
  // No slip inside: the displacement is the same everywhere in the stick zone, which is centred
  const Vector u = plane.displacement(q);
  const int reach = static_cast<int>(0.9 * c / h);
  for (int i = n / 2 - reach; i < n / 2 + reach; ++i)
    EXPECT_NEAR(u[i], u[n / 2], 1e-5 * std::abs(u[n / 2] - u[0]));
  EXPECT_THROW(staticTraction(plane, problem, normal, mu, 1.0), Error);
}

TEST(StaticCases, SmoothAndRough)
{
  const StaticCases smooth =
      solve(case_text::table2 + "friction: {law: constant, mu: 0.3}\n"
                                "mode: static\nstatic: {force_ratio: [0, 0.36, 0.75]}\n");
  ASSERT_EQ(smooth.points.size(), 3u);
  for (const StaticPoint &p : smooth.points) {
    EXPECT_NEAR(p.stickLength, 2.0 * table2().halfWidth * std::sqrt(1.0 - p.forceRatio), 1e-7);
    EXPECT_NEAR(p.stickCentre, 0.0, 1e-8);
    EXPECT_NEAR(p.traction, p.forceRatio * 0.3 * 4e6, 1.0);
  }
  const StaticCases rough =
      solve(case_text::table2 + "roughness: {hurst: 0.8, rms_slope: 0.02, wavelength_min: 0.1 mm, "
                                "wavelength_max: 10 mm, seed: [1, 2]}\ncells: 2048\n"
                                "mode: static\nstatic: {force_ratio: 0.5}\n");
  ASSERT_EQ(rough.points.size(), 2u);
  EXPECT_EQ(rough.points[1].profile, 2u);
  EXPECT_NEAR(rough.points[1].mu, 0.328667, 1e-6); // Eq. 8: nothing slides, nothing heats
  EXPECT_LT(rough.points[0].stickLength, rough.contacts[0].realContactLength());
  const ContactFields &f = rough.fields.at(2);
  for (int i = 0; i < f.traction.size(); ++i) {
    const double bound = f.mu[i] * f.pressure[i];
    EXPECT_LE(f.traction[i], bound * (1.0 + 1e-9));
    if (f.state[i] == Adhesion::Slip) {
      EXPECT_NEAR(f.traction[i], bound, 1e-6 * bound);
    }
  }
}

TEST(StaticCases, PeriodicIsWestergaard)
{
  // One wave a period: stick zone of the contact under N - T/mu, both from sin^2(pi a/L) = N/N*
  const double period = 0.01, amplitude = 10e-6 * std::sqrt(2.0);
  const double full = pi * contactModulus({{{210e9, 0.3}, {210e9, 0.3}}}) * amplitude /
                      period; // p* of Johnson, 13.2
  const StaticCases cases =
      solve("contact: {load_per_length: 2000 N/mm, period: 10 mm, youngs_modulus: 210 GPa,\n"
            "          poissons_ratio: 0.3}\ncells: 512\n"
            "roughness: {hurst: 0.8, rms_height: 10 um, wavelength_min: 10 mm,\n"
            "            wavelength_max: 10 mm, seed: 3}\n"
            "friction: {law: constant, mu: 0.3}\nmode: static\nstatic: {force_ratio: [0, 0.5]}\n");
  const auto length = [&](double load) {
    return 2.0 * period / pi * std::asin(std::sqrt(load / period / full));
  };
  EXPECT_NEAR(cases.points[0].stickLength, length(2e6), 1e-3 * period);
  EXPECT_NEAR(cases.points[1].stickLength, length(1e6), 1e-3 * period);
  EXPECT_NEAR(cases.contacts[0].realContactLength(), length(2e6), 1e-3 * period);
  EXPECT_NEAR(cases.fields.at(2).pressure.maxCoeff(), 2.0 * std::sqrt(2e6 / period * full),
              1e-3 * cases.fields.at(2).pressure.maxCoeff());
}
