// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/patch_contact.h"

#include "base/errors.h"
#include "contact/patch/elasticity/patch_half_space.h"
#include "shared/pi.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;
using mcawr::pi;

/// Linear between places that increase, the outermost value beyond.
double interpolated(const std::vector<double> &places, const std::vector<double> &values, double at)
{
  const auto after = std::upper_bound(places.begin(), places.end(), at);
  if (after == places.begin())
    return values.front();
  if (after == places.end())
    return values.back();
  const auto k = static_cast<std::size_t>(after - places.begin());
  const double part = (at - places[k - 1]) / (places[k] - places[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

double shearModulus(const ElasticBody &body)
{
  return body.youngsModulus / (2.0 * (1.0 + body.poissonsRatio));
}

} // namespace

ElasticPair combinedPair(const ElasticBody &wheel, const ElasticBody &rail)
{
  constexpr double rounding = 1e-9;
  const double G1 = shearModulus(wheel), G2 = shearModulus(rail);
  const double nu1 = wheel.poissonsRatio, nu2 = rail.poissonsRatio;
  const double G = 2.0 / (1.0 / G1 + 1.0 / G2);
  const double K = 0.25 * G * ((1.0 - 2.0 * nu1) / G1 - (1.0 - 2.0 * nu2) / G2);
  return {G, 0.5 * G * (nu1 / G1 + nu2 / G2), std::abs(K) > rounding ? K : 0.0};
}

HertzEllipse PatchContactSpecification::hertz(double normalForce) const
{
  const ElasticPair pair = combinedPair(bodies[0], bodies[1]);
  const double modulus = pair.G / (1.0 - pair.nu);
  if (curvatures)
    return hertzEllipse(normalForce, modulus, *curvatures);
  return hertzEllipseOfAxes(normalForce, modulus, semiAxes[0], semiAxes[1]);
}

Vector PatchContact::gap(const Travel &wheel, const Travel &rail) const
{
  Vector gap = sampled(grid, [&](double x, double y) { return hertz.gap(x, y); });
  if (!surface.wheel.isSmooth())
    gap -= surface.wheel.window(grid, wheel);
  if (!surface.rail.isSmooth())
    gap -= surface.rail.window(grid, rail);
  return gap;
}

NormalContactProblem PatchContact::problem(double pressureLimit, double normalForce,
                                           const Travel &wheel, const Travel &rail) const
{
  NormalContactProblem problem;
  problem.profile = gap(wheel, rail);
  problem.load = normalForce / grid.cellArea();
  problem.approach = approach;
  problem.pressureLimit = pressureLimit;
  return problem;
}

Vector PatchContact::bound(const Vector &mu, const Vector &pressure) const
{
  return mu.cwiseProduct(pressure).cwiseMin(yieldStress);
}

double PatchContact::meanFriction(const Vector &mu, const Vector &pressure) const
{
  return bound(mu, pressure).sum() / pressure.sum();
}

Vector PatchContact::across(Vector mu) const
{
  if (muFactor.size() > 0)
    mu.array() *= muFactor.array();
  return mu;
}

double PatchContact::carried(double normalForce, const Vector &pressure) const
{
  return approach ? pressure.sum() * grid.cellArea() : normalForce;
}

EdgeCompliance PatchContact::edge(const Vector &pressure, const Vector &gap) const
{
  return edgesInside ? edgeCompliance(grid, pair, pressure, gap) : EdgeCompliance{};
}

bool PatchContact::isNominal(int cell) const
{
  const double x = grid.x(cell % grid.nx) / hertz.a, y = grid.y(cell / grid.nx) / hertz.b;
  return x * x + y * y <= 1.0;
}

double PatchContact::nominalMean(const Vector &values) const
{
  double sum = 0.0;
  int inside = 0;
  for (int i = 0; i < grid.cells(); ++i)
    if (isNominal(i)) {
      sum += values[i];
      ++inside;
    }
  return sum / inside;
}

double PatchContact::nominalArea() const
{
  return pi * hertz.a * hertz.b;
}

double PatchContact::realArea(const Vector &pressure) const
{
  return grid.cellArea() * static_cast<double>((pressure.array() > 0.0).count());
}

void checkInsideBox(const PatchGrid &grid, const Vector &pressure)
{
  const auto fail = [](const char *where) {
    throw Error(ExitCode::BadInput,
                fmt::format("contact.domain: the contact reaches the {} border of the box of "
                            "cells; increase it, or contact.box, or cells beside contact.cell",
                            where));
  };
  for (int iy = 0; iy < grid.ny; ++iy) {
    if (pressure[grid.index(grid.nx - 1, iy)] > 0.0)
      fail("leading");
    if (pressure[grid.index(0, iy)] > 0.0)
      fail("trailing");
  }
  for (int ix = 0; ix < grid.nx; ++ix)
    if (pressure[grid.index(ix, 0)] > 0.0 || pressure[grid.index(ix, grid.ny - 1)] > 0.0)
      fail("lateral");
}

PatchContact preparePatch(const PatchContactSpecification &contact,
                          const RoughPatchSpecification &roughness, double load, std::size_t index,
                          double pressureLimit, double travel)
{
  PatchContact patch;
  patch.load = load;
  patch.edgesInside = contact.edgesInside;
  patch.hertz = contact.hertz(load);
  patch.pair = combinedPair(contact.bodies[0], contact.bodies[1]);
  patch.pair.layer = contact.layer.compliance();
  patch.yieldStress = contact.layer.yieldStress;
  const std::array<double, 2> box = contact.box.value_or(
      std::array{contact.domain * patch.hertz.a, contact.domain * patch.hertz.b});
  patch.grid = centredGrid(contact.nx, contact.ny, box[0], box[1]);
  patch.grid.left += contact.centre[0];
  patch.grid.bottom += contact.centre[1];
  if (!contact.acrossY.empty())
    patch.muFactor = sampled(patch.grid, [&](double, double y) {
      return interpolated(contact.acrossY, contact.acrossFactor, y);
    });
  if (!contact.approach.empty()) {
    const auto found = std::find(contact.load.begin(), contact.load.end(), load);
    patch.approach = contact.approach[found - contact.load.begin()];
  }
  patch.surface = prepareRoughPatch(roughness, index, patch.grid, travel);
  PatchHalfSpace space(patch.grid, patch.pair);
  patch.normal = solveNormalContact(space, patch.problem(pressureLimit, load));
  if (!(patch.normal.pressure.maxCoeff() > 0.0))
    throw Error(ExitCode::BadInput, "contact.approach: the bodies do not touch");
  patch.load = patch.carried(load, patch.normal.pressure);
  checkInsideBox(patch.grid, patch.normal.pressure);
  return patch;
}

} // namespace wheelrail
