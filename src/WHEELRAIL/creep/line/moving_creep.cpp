// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/moving_creep.h"

#include "base/errors.h"
#include "contact/line/line_coupling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double pressureTolerance = 1e-5; ///< the next step shifts the pressure by a cell anyway

/// Moved along with the material by one cell.
/// \param incoming what comes in
Vector movedAlong(const Vector &values, double incoming = 0.0)
{
  Vector moved = Vector::Constant(values.size(), incoming);
  moved.head(values.size() - 1) = values.tail(values.size() - 1);
  return moved;
}

/// Adds the values of a step to a sum.
void addValues(LineValues &sum, const LineValues &step)
{
  static const std::vector<Column<LineValues>> columns = lineColumns();
  for (const Column<LineValues> &column : columns)
    column.value.set(sum, column.value.get(sum) + column.value.get(step));
}

} // namespace

MovingCreep::MovingCreep(const CreepPhysics &physics, const MovingSpecification &moving,
                         const FrictionLaw &law, const ContactSetup &setup)
    : physics_(physics), moving_(moving), law_(law), setup_(setup),
      domain_(setup.cells, Boundary::Free), normal_(setup.normal)
{
  if (physics.memoryLength > 0.0 && law.dependsOnSpeed())
    memory_.emplace(CellGrid{setup.cells, 1, setup.cellSize, 1.0}, physics.memoryLength);
}

void MovingCreep::solvePressure(int step, const std::vector<Roller> &rollers)
{
  double warmest = 0.0;
  for (const Roller &roller : rollers)
    warmest = std::max(warmest, setup_.nominalMean(roller.temperature));
  NormalContactOptions options;
  options.tolerance = pressureTolerance;
  options.start = step ? movedAlong(normal_.pressure) : normal_.pressure;
  NormalContactProblem problem = setup_.problem(physics_.pressureLimit(law_, warmest), step);
  if (rollers.size() == 1)
    problem.cellLimits =
        physics_.pressureLimits(law_, movedAlong(rollers[0].temperature)) / setup_.hertz.modulus;
  if (coupling_ != 0.0 && step > 0) {
    const RollingResult &last = rollers[0].result;
    Vector traction = Vector::Zero(setup_.cells);
    traction.segment(windowBegin_, last.traction.size()) = last.traction;
    problem.profile += couplingDisplacement(coupling_, traction);
  }
  normal_ = solveNormalContact(domain_, problem, options);
  checkInsideDomain(normal_.pressure);
  contact_.pressure = normal_.pressure * setup_.hertz.modulus;
}

/// Makes the window as large as this step's contact needs (never at the domain's ends); it never
/// shrinks.
void MovingCreep::fitWindow(std::vector<Roller> &rollers)
{
  int first = 0, last = setup_.cells - 1;
  while (!(normal_.pressure[first + 1] > 0.0))
    ++first; // one cell more: traction leaves the contact there
  while (!(normal_.pressure[last] > 0.0))
    --last;
  int end = last + 1;
  if (window_) {
    if (first >= windowBegin_ && end <= windowBegin_ + window_->cells())
      return;
    first = std::min(first, windowBegin_);
    end = std::max(end, windowBegin_ + window_->cells());
  }
  // Room to both sides as far as a fast transform gives it, so that it seldom has to grow.
  const int cells = std::min(setup_.cells, fastTransformSize(2 * (end - first)) / 2);
  const int begin = std::clamp((first + end - cells) / 2, 0, setup_.cells - cells);
  window_.emplace(cells, Boundary::Free);
  for (Roller &roller : rollers)
    roller.rolling.moveTo(*window_, begin - windowBegin_);
  windowBegin_ = begin;
}

void MovingCreep::roll(Roller &roller, double speed, bool counted)
{
  const Vector &p = contact_.pressure;
  const int cells = window_->cells();
  if (roller.heat)
    roller.temperature = movedAlong(roller.temperature);
  physics_.checkStrength(law_, roller.temperature.maxCoeff(), speed, roller.creep);
  if (memory_) {
    roller.memoryRatio = movedAlong(roller.memoryRatio, 1.0);
    roller.mu = SlipMemory::mu(law_, p, roller.temperature, roller.memoryRatio);
  } else {
    roller.mu = law_.mu({p, roller.creep * speed, roller.temperature});
  }
  const Vector imposed = imposedBy(normal_.pressure, roller);
  roller.result = roller.rolling.step(setup_.bound(roller.mu, p).segment(windowBegin_, cells),
                                      roller.creep, imposed);
  if (memory_) {
    Vector slip = Vector::Zero(setup_.cells);
    slip.segment(windowBegin_, cells) = roller.result.slip;
    roller.memoryRatio =
        memory_->after(roller.memoryRatio, law_, p, roller.temperature, speed, slip);
  }
  if (roller.heat) {
    Vector heat = Vector::Zero(setup_.cells);
    heat.segment(windowBegin_, cells) =
        roller.result.traction.cwiseProduct(roller.result.slip) * (setup_.hertz.modulus * speed);
    roller.heat->step(heat);
    for (int i = 0; i < setup_.cells; ++i)
      if (setup_.isNominal(i) || (i >= windowBegin_ && i < windowBegin_ + cells))
        roller.temperature[i] = roller.heat->rise(i);
  }
  LineValues step = lineValues(setup_, roller.result.force() / normal_.pressure.sum(),
                               roller.result.traction * setup_.hertz.modulus, p, roller.mu,
                               roller.temperature, roller.result.state);
  roller.carried += setup_.meanFriction(roller.mu, p);
  step.frictionWork = setup_.cellSize * setup_.hertz.modulus *
                      drivenWork(roller.result.traction, roller.creep, imposed);
  addValues(roller.pass, step);
  if (!counted)
    return;
  addValues(roller.counted, step);
  roller.hottest = std::max(roller.hottest, roller.temperature.maxCoeff());
}

Vector MovingCreep::imposedBy(const Vector &pressure, Roller &roller) const
{
  if (coupling_ == 0.0)
    return {};
  const Vector before = std::exchange(roller.pressed, couplingDisplacement(coupling_, pressure));
  const double comingIn = -coupling_ * pressure.sum(); // far ahead
  const Vector carried = movedAlong(before.size() > 0 ? before : roller.pressed, comingIn);
  return (roller.pressed - carried).segment(windowBegin_, window_->cells());
}

void MovingCreep::endPass(Roller &roller, double speed, int steps)
{
  if (physics_.thermal.model == ThermalModel::Averaged ||
      physics_.thermal.model == ThermalModel::AveragedPower) {
    const double workOverLoad = physics_.thermal.model == ThermalModel::Averaged
                                    ? roller.carried * roller.creep
                                    : roller.pass.frictionWork / setup_.hertz.load;
    roller.temperature.setConstant(
        meanTemperatureRise(workOverLoad / steps * speed, setup_.hertz.hertzPressure,
                            setup_.hertz.halfWidth, speed, physics_.thermal.material));
  }
  roller.pass = {};
  roller.carried = 0.0;
}

CreepPoint MovingCreep::pointOf(const Roller &roller, double speed, int steps, int counted) const
{
  CreepPoint point;
  for (const Column<LineValues> &column : lineColumns())
    column.value.set(point, column.value.get(roller.counted) / counted);
  point.speed = speed;
  point.creep = roller.creep;
  point.traction = point.tractionRatio * setup_.hertz.load;
  point.temperatureMaximum =
      roller.heat ? roller.hottest : maximumOverMeanTemperature() * roller.hottest;
  point.iterations = steps;
  point.use = law_.use({contact_.pressure, roller.creep * speed, roller.temperature});
  return point;
}

// A step is one cell of rolling: the profile is read a cell further on, which moves its asperities
// a cell towards smaller x. All that belongs to the material moves with it: the pressure (as a
// start of the normal contact only), the traction (`TransientRolling`), the temperature. Creeps do
// not change the pressure, so that one normal contact a step serves all of them; only where a
// hardness falls with temperature does the warmest of them decide, and of unlike bodies the
// traction; the sweep then calls with one creep.
std::vector<CreepPoint> MovingCreep::solve(double speed, const std::vector<double> &creeps,
                                           const std::function<bool()> &progress)
{
  const HertzContact &hertz = setup_.hertz;
  const int pass = static_cast<int>(std::ceil(2.0 * hertz.halfWidth / setup_.cellSize));
  const std::int64_t way = std::int64_t{moving_.passes} * pass;
  if (way > std::numeric_limits<int>::max())
    throw Error(ExitCode::BadInput,
                fmt::format("moving.passes: {} of {} cells are {} steps; at most {} are allowed",
                            moving_.passes, pass, way, std::numeric_limits<int>::max()));
  const int steps = static_cast<int>(way);
  if (steps > setup_.longestTravel())
    throw Error(
        ExitCode::BadInput,
        fmt::format("mode moving: {} passes need a profile of {:.3g} mm, there are {:.3g} mm",
                    moving_.passes, (setup_.cells + steps) * setup_.cellSize * 1e3,
                    (setup_.cells + setup_.longestTravel()) * setup_.cellSize * 1e3));
  const double reference = moving_.referenceLength * hertz.halfWidth / setup_.cellSize;
  coupling_ = creeps.front() < 0.0 ? -setup_.coupling : setup_.coupling;
  std::vector<Roller> rollers;
  for (int step = 0; step < steps; ++step) {
    if (!progress())
      return {};
    solvePressure(step, rollers);
    fitWindow(rollers);
    // once, in the first step: a roller needs the window, and the window the first pressure
    for (std::size_t k = rollers.size(); k < creeps.size(); ++k) {
      rollers.push_back({std::abs(creeps[k]),
                         TransientRolling(*window_, reference, setup_.layer),
                         {},
                         Vector::Zero(setup_.cells),
                         {},
                         Vector::Ones(setup_.cells),
                         {},
                         {},
                         {},
                         {},
                         0.0,
                         0.0});
      if (physics_.thermal.model == ThermalModel::Local)
        rollers.back().heat.emplace(setup_.cells, setup_.cellSize, speed,
                                    physics_.thermal.material);
    }
    for (Roller &roller : rollers) {
      roll(roller, speed, step >= steps / 2);
      if ((step + 1) % pass == 0)
        endPass(roller, speed, pass);
    }
  }

  std::vector<CreepPoint> points;
  for (const Roller &roller : rollers)
    points.push_back(pointOf(roller, speed, steps, steps - steps / 2));
  fields_.clear();
  for (const Roller &roller : rollers)
    fields_.push_back(fieldsOf(roller));
  return points;
}

ContactFields MovingCreep::fieldsOf(const Roller &roller) const
{
  ContactFields fields = contact_;
  const int cells = window_->cells();
  fields.mu = roller.mu;
  fields.temperature = roller.temperature;
  if (roller.heat)
    for (int i = 0; i < setup_.cells; ++i)
      fields.temperature[i] = roller.heat->rise(i);
  fields.traction = fields.slip = Vector::Zero(setup_.cells);
  fields.traction.segment(windowBegin_, cells) = roller.result.traction * setup_.hertz.modulus;
  fields.slip.segment(windowBegin_, cells) = roller.result.slip;
  fields.state.assign(setup_.cells, Adhesion::Apart);
  std::copy(roller.result.state.begin(), roller.result.state.end(),
            fields.state.begin() + windowBegin_);
  return fields;
}

} // namespace wheelrail
