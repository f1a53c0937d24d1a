// SPDX-License-Identifier: GPL-2.0-or-later
// Plane strain and plane stress of one automaton: Hooke's law, and plastic flow against a
// material point that is integrated in three dimensions with small implicit steps.
#include "laws/plane.h"

#include "sample.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

using namespace mca;

namespace {

using mcawr::pi;

struct Strain {
  double xx, yy, xy;
};

/// One automaton of the packing with its six contacts under homogeneous strain.
struct Point {
  Material m = steel();
  ElasticModuli moduli = planeStrainModuli(m.shearModulus(), m.bulkModulus());
  bool volumePreserving = true;
  std::array<double, 6> plastic{}, plasticShear{};
  double kappa = 0;
  StressTensor stress{};
  double mean = 0;

  void evaluate(const Strain &eps, bool flows)
  {
    average(eps);
    if (!flows)
      return;
    const YieldCurve curve(m);
    const StressTensor yielding =
        volumePreserving ? flowStress(stress.xx, stress.yy, stress.xy) : stress;
    const RadialReturn back = radialReturn(stressIntensity(yielding), curve(kappa), moduli.shear);
    const double M = back.factor, twoG = 2 * moduli.shear;
    const double centre = volumePreserving ? (stress.xx + stress.yy) / 2 : mean;
    kappa += back.strain;
    for (int k = 0; k < 6; k++) {
      const double sigma = normalResponse(e_[k], twoG, moduli.D, mean);
      plastic[k] += (1 - M) * (sigma - centre) / twoG;
      plasticShear[k] += (1 - M) * gamma_[k];
    }
    average(eps); // the state after the return
  }

  /// Sum of the plastic strains in the plane.
  double plasticVolume() const
  {
    double sum = 0;
    for (const double p : plastic)
      sum += p / 3;
    return sum;
  }

 private:
  std::array<double, 6> e_{}, gamma_{};

  void average(const Strain &eps)
  {
    const double twoG = 2 * moduli.shear;
    double sum = 0;
    for (int k = 0; k < 6; k++) {
      const double nx = std::cos(k * pi / 3), ny = std::sin(k * pi / 3);
      e_[k] = eps.xx * nx * nx + eps.yy * ny * ny + 2 * eps.xy * nx * ny - plastic[k];
      gamma_[k] = (eps.yy - eps.xx) * nx * ny + eps.xy * (nx * nx - ny * ny) - plasticShear[k];
      sum += e_[k];
    }
    mean = meanStress(sum, moduli.bulk);
    stress = {0, 0, 0, 0};
    for (int k = 0; k < 6; k++) {
      const double nx = std::cos(k * pi / 3), ny = std::sin(k * pi / 3);
      const double sigma = normalResponse(e_[k], twoG, moduli.D, mean);
      const StressTensor s = stressShare(sigma, twoG * gamma_[k], nx, ny);
      stress = {stress.xx + s.xx, stress.yy + s.yy, stress.xy + s.xy, 0};
    }
    stress = automatonStress(stress.xx, stress.yy, stress.xy, mean);
  }
};

/// J2 flow with isotropic hardening in the plane alone, implicit steps.
struct Reference {
  Material m = steel();
  double kappa = 0;
  double plastic = 0, plasticShear = 0; // (xx - yy)/2, xy
  StressTensor stress{};

  void strain(const Strain &eps)
  {
    const double G = m.shearModulus(), K = m.bulkModulus(), area = eps.xx + eps.yy;
    double half = 2 * G * ((eps.xx - eps.yy) / 2 - plastic);
    double shear = 2 * G * (eps.xy - plasticShear);
    const double q = std::sqrt(3.0) * std::hypot(half, shear);
    const YieldCurve curve(m);
    double lower = 0, upper = q / (3 * G); // q - 3G d = Y(kappa + d)
    if (q <= curve(kappa))
      upper = 0;
    for (int k = 0; k < 60; k++) {
      const double d = 0.5 * (lower + upper);
      (q - 3 * G * d > curve(kappa + d) ? lower : upper) = d;
    }
    const double left = q > 0 ? 1 - 3 * G * upper / q : 1;
    plastic += (1 - left) * half / (2 * G);
    plasticShear += (1 - left) * shear / (2 * G);
    half *= left;
    shear *= left;
    kappa += upper;
    const double pressure = (K + G / 3) * area; // nothing flows across the plane
    stress = {pressure + half, pressure - half, shear, (K - 2 * G / 3) * area};
  }
};

double difference(const StressTensor &a, const StressTensor &b)
{
  return std::max(
      {std::abs(a.xx - b.xx), std::abs(a.yy - b.yy), std::abs(a.xy - b.xy), std::abs(a.zz - b.zz)});
}

} // namespace

TEST(Plane, StressIsHookesWithoutStressAcross)
{
  for (const double nu : {-0.3, 0.0, 0.3, 0.49}) {
    Point p;
    p.m.poissonsRatio = nu;
    p.moduli = planeStressModuli(p.m.shearModulus(), p.m.bulkModulus());
    const Strain eps{3e-4, -1e-4, 2e-4};
    p.evaluate(eps, false);
    const double E = p.m.youngsModulus, c = E / (1 - nu * nu);
    EXPECT_NEAR(p.stress.xx, c * (eps.xx + nu * eps.yy), 1e-10);
    EXPECT_NEAR(p.stress.yy, c * (eps.yy + nu * eps.xx), 1e-10);
    EXPECT_NEAR(p.stress.xy, E / (1 + nu) * eps.xy, 1e-10);
    EXPECT_NEAR(p.stress.zz, 0, 1e-10);
    EXPECT_NEAR(p.mean, (p.stress.xx + p.stress.yy) / 3, 1e-10);
    // the energy of the solid
    double squares = 0;
    for (int k = 0; k < 6; k++) {
      const double nx = std::cos(k * pi / 3), ny = std::sin(k * pi / 3);
      const double ex = eps.xx * nx + eps.xy * ny, ey = eps.xy * nx + eps.yy * ny;
      squares += ex * ex + ey * ey;
    }
    const double energy =
        0.5 * (p.stress.xx * eps.xx + p.stress.yy * eps.yy + 2 * p.stress.xy * eps.xy);
    EXPECT_NEAR(energyDensity(squares, p.mean, p.moduli.shear, p.moduli.bulk, p.moduli.D), energy,
                1e-12 * energy);
  }
}

TEST(Plane, StrainKeepsTheSolidsModuli)
{
  const Material m = steel();
  const ElasticModuli moduli = planeStrainModuli(m.shearModulus(), m.bulkModulus());
  EXPECT_EQ(moduli.bulk, m.bulkModulus());
  EXPECT_NEAR(moduli.D, meanStressWeight(m), 1e-15);
}

TEST(Plane, FlowKeepsTheVolume)
{
  for (const bool preserving : {true, false}) {
    Point p;
    p.volumePreserving = preserving;
    for (int k = 1; k <= 400; k++)
      p.evaluate({k * 5e-5, k * 1e-5, k * 2e-5}, true);
    EXPECT_GT(p.kappa, 0.01);
    if (preserving)
      EXPECT_NEAR(p.plasticVolume(), 0, 1e-15);
    else // what the plain return does instead
      EXPECT_GT(std::abs(p.plasticVolume()), 1e-3);
  }
}

TEST(Plane, FlowIsThatOfAMaterialPoint)
{
  // tension with lateral contraction, shear, a turning path, and unloading with reversal
  const std::function<Strain(double)> paths[] = {[](double t) -> Strain {
                                                   return {0.03 * t, -0.012 * t, 0};
                                                 },
                                                 [](double t) -> Strain {
                                                   return {0, 0, 0.03 * t};
                                                 },
                                                 [](double t) -> Strain {
                                                   return {0.02 * t, 0.005 * t, 0.03 * t * t};
                                                 },
                                                 [&](double t) -> Strain {
                                                   const double a = 0.02 * std::sin(1.5 * pi * t);
                                                   return {a, -0.5 * a, 0.3 * a};
                                                 }};
  for (const auto &path : paths) {
    double error[2];
    for (int fine = 0; fine < 2; fine++) {
      const int steps = 4000 << fine;
      Point p;
      Reference r;
      error[fine] = 0;
      for (int k = 1; k <= steps; k++) {
        const Strain eps = path(static_cast<double>(k) / steps);
        p.evaluate(eps, true);
        r.strain(eps);
        error[fine] = std::max(
            {error[fine], difference(p.stress, r.stress), std::abs(p.kappa - r.kappa) * 1e4});
      }
      EXPECT_GT(p.kappa, 0.01);
    }
    // the explicit yield stress lags by a step: hardening 3.5 GPa times the step's flow
    EXPECT_LT(error[0], 0.05);
    EXPECT_LT(error[1], 0.6 * error[0]);
  }
}
