// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_CASES_H
#define WHEELRAIL_PATCH_CASES_H

#include "contact/normal_contact.h"
#include "contact/patch/elasticity/grid.h"
#include "contact/patch/elasticity/hertz_ellipse.h"
#include "contact/patch/elasticity/patch_half_space.h"
#include "contact/patch/solvers/patch_sums.h"
#include "contact/patch/solvers/tangential.h"

#include <optional>

/// Contacts over a patch that several tests use.
namespace patch_cases {

/// Square cells from a corner, as the reference's inputs give them.
inline wheelrail::PatchGrid gridFrom(int nx, int ny, double cell, double left, double bottom)
{
  return {{nx, ny, cell, cell}, left, bottom};
}

/// Smooth contact under a load: A, B the gap's curvatures.
inline wheelrail::NormalContactResult pressed(const wheelrail::PatchGrid &grid,
                                              const wheelrail::ElasticPair &pair, double A,
                                              double B, double load,
                                              const Eigen::VectorXd &roughness = {})
{
  wheelrail::PatchHalfSpace space(grid, pair);
  wheelrail::NormalContactProblem problem;
  problem.profile = sampled(grid, [&](double x, double y) { return A * x * x + B * y * y; });
  if (roughness.size() == grid.cells())
    problem.profile += roughness;
  problem.load = load / grid.cellArea();
  return solveNormalContact(space, problem);
}

/// Waves of random directions and phases with lengths between two limits: a rough surface of this
/// root-mean-square slope.
Eigen::VectorXd waves(const wheelrail::PatchGrid &grid, double rmsSlope, double shortest,
                      double longest, unsigned seed);

/// A sphere of contact radius 1 (length) at G = 1: nothing but ratios matters.
struct Sphere {
  wheelrail::ElasticPair pair{1.0, 0.3};
  double load = 0.01, mu = 0.3;
  wheelrail::HertzEllipse hertz() const
  {
    return wheelrail::hertzEllipseOfAxes(load, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  }
  /// Exact Hertzian pressure times mu at the cells' centres.
  Eigen::VectorXd bound(const wheelrail::PatchGrid &grid) const
  {
    const wheelrail::HertzEllipse h = hertz();
    return sampled(grid, [&](double x, double y) { return mu * h.pressure(x, y); });
  }
  /// Creepage of 1 in the scaled form xi G a^2/(mu N).
  double creepUnit() const { return mu * load / pair.G; }
};

} // namespace patch_cases
#endif
