// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/static_patch.h"

#include "contact/patch/patch_sums.h"
#include "contact/patch/transient.h"
#include "creep/patch/patch_curve.h"

namespace wheelrail {
namespace {
constexpr double tolerance = 1e-7; ///< one solve, which may be exact
}

StaticPatch solveStaticPatch(const CreepPhysics &physics, const FrictionLaw &law,
                             const PatchContact &contact, const PatchTask &task)
{
  const Eigen::VectorXd &pressure = contact.normal.pressure;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(contact.grid.cells());
  StaticPatch still;
  // nothing slides on, nothing heats
  still.fields.pressure = pressure;
  still.fields.gap = contact.normal.gap;
  still.fields.mu = frictionCoefficient(physics.friction, law, pressure, 0.0, zero);
  still.fields.temperature = zero;
  TransientPatch transient(contact.grid, contact.pair);
  TransientPatch::Step step;
  step.bound = still.fields.mu.cwiseProduct(pressure);
  step.cells = 0;
  step.creepage = task.drive.creepage;
  step.forceX = task.drive.forceX;
  step.forceY = task.drive.forceY;
  const double capacity = step.bound.sum() * contact.grid.cellArea();
  if (task.forceRatio > 0.0) {
    step.forceX = -task.forceRatio * capacity;
    step.forceY = 0.0;
  }
  TangentialOptions options;
  options.tolerance = tolerance;
  const TangentialResult result = transient.step(step, options);
  const PatchSums sums = patchSums(contact.grid, result);
  still.fields.traction = result.traction;
  still.fields.slip = result.slip;
  still.fields.state = result.state;
  PatchPoint &point = still.point;
  point.surface = contact.surface.number;
  point.load = contact.load;
  point.creepage = result.creepage;
  point.forceX = sums.forceX;
  point.forceY = sums.forceY;
  point.momentZ = sums.momentZ;
  point.muMean = capacity / (pressure.sum() * contact.grid.cellArea());
  point.products = result.products + result.coarseProducts;
  point.stickFraction = sums.stickArea / sums.contactArea;
  point.approach = contact.normal.approach;
  point.peakPressure = contact.normal.peakPressure();
  point.realArea = contact.realArea(pressure);
  return still;
}

} // namespace wheelrail
