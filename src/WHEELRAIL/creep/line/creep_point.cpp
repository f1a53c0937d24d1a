// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/creep_point.h"

#include "base/errors.h"
#include "contact/line/line_coupling.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double temperatureTolerance = 1e-9; ///< of the strength temperature
constexpr double memoryTolerance = 1e-5;      ///< of mu
constexpr double couplingTolerance = 1e-6;    ///< of unlike bodies, relative to the pressure
constexpr int maxIterations = 100;
constexpr int settling = 10; ///< iterations in which steps shrink, unless the pressure jumps
/// By how much a pressure may then exceed the hardness of its cell [-].
constexpr double mostExcess = 1e-3;

} // namespace

FrozenCreep::FrozenCreep(const CreepPhysics &physics, const ContactSetup &setup)
    : physics_(physics), setup_(setup)
{
  contact_.intervals = contactIntervals(setup_.normal, Boundary::Free);
  contact_.pressure = setup_.normal.pressure * setup_.hertz.modulus;
  contact_.traction = contact_.temperature = contact_.slip = Vector::Zero(setup_.cells);
  contact_.state.assign(setup_.cells, Adhesion::Apart);
  if (physics.memoryLength > 0.0)
    memory_.emplace(CellGrid{setup.cells, 1, setup.cellSize, 1.0}, physics.memoryLength);
}

Vector FrozenCreep::muNow(const FrictionLaw &law, double slidingSpeed) const
{
  return memory_ ? SlipMemory::mu(law, contact_.pressure, contact_.temperature, memoryRatio_)
                 : law.mu({contact_.pressure, slidingSpeed, contact_.temperature});
}

void FrozenCreep::roll(double creep)
{
  const std::vector<ContactInterval> &intervals = contact_.intervals;
  // Traction outside of the contact is zero: only the window around it is computed. The window
  // never shrinks, for its spectra are kept.
  const int needed = intervals.back().last - intervals.front().first + 1;
  if (!window_ || window_->cells() < needed)
    window_.emplace(std::min(setup_.cells, fastTransformSize(2 * needed) / 2), Boundary::Free);
  const int cells = window_->cells();
  const int first = std::min(intervals.front().first, setup_.cells - cells);
  const double modulus = setup_.hertz.modulus;

  RollingOptions options;
  options.start.assign(contact_.state.begin() + first, contact_.state.begin() + first + cells);
  options.startTraction = contact_.traction.segment(first, cells) / modulus;
  options.contact = intervals;
  for (ContactInterval &interval : options.contact)
    interval.shift(-first);
  options.layer = setup_.layer;
  const Vector bound = setup_.bound(contact_.mu, contact_.pressure).segment(first, cells);
  if (coupling_ != 0.0)
    options.imposed = couplingSlip(coupling_, contact_.pressure.segment(first, cells) / modulus);
  const RollingResult result = solveFrozenRolling(*window_, bound, creep, options);
  contact_.traction.setZero();
  contact_.slip.setZero();
  contact_.state.assign(setup_.cells, Adhesion::Apart);
  contact_.traction.segment(first, cells) = result.traction * modulus;
  contact_.slip.segment(first, cells) = result.slip;
  frictionWork_ = setup_.cellSize * modulus * drivenWork(result.traction, creep, options.imposed);
  std::copy(result.state.begin(), result.state.end(), contact_.state.begin() + first);
}

Vector FrozenCreep::temperatureFrom(double speed, double creep)
{
  const int n = setup_.cells;
  if (physics_.thermal.model == ThermalModel::Off)
    return Vector::Zero(n);
  if (physics_.thermal.model == ThermalModel::Local) {
    if (!flash_ || flashSpeed_ != speed)
      flash_.emplace(n, setup_.cellSize, speed, physics_.thermal.material);
    flashSpeed_ = speed;
    return flash_->rise(contact_.traction.cwiseProduct(contact_.slip) * speed);
  }
  const double powerOverLoad =
      physics_.thermal.model == ThermalModel::Averaged
          ? setup_.meanFriction(contact_.mu, contact_.pressure) * creep * speed
          : frictionWork_ / setup_.hertz.load * speed;
  return Vector::Constant(n, meanTemperatureRise(powerOverLoad, setup_.hertz.hertzPressure,
                                                 setup_.hertz.halfWidth, speed,
                                                 physics_.thermal.material));
}

/// The hardness falls with the temperature, that of each cell where it is known, else the contact's
/// mean: solve again where it binds.
void FrozenCreep::renewPressure(const FrictionLaw &law, double part)
{
  const double mean = contact_.temperature.dot(contact_.pressure) / contact_.pressure.sum();
  NormalContactOptions options;
  options.start = contact_.pressure / setup_.hertz.modulus;
  if (!domain_)
    domain_.emplace(setup_.cells, Boundary::Free);
  NormalContactProblem problem = setup_.problem(physics_.pressureLimit(law, mean));
  problem.cellLimits = physics_.pressureLimits(law, contact_.temperature) / setup_.hertz.modulus;
  if (coupling_ != 0.0) {
    const Vector opening =
        couplingDisplacement(coupling_, contact_.traction / setup_.hertz.modulus);
    opening_ += part * (opening - opening_);
    problem.profile += opening_;
  }
  const NormalContactResult normal = solveNormalContact(*domain_, problem, options);
  checkInsideDomain(normal.pressure);
  contact_.pressure = normal.pressure * setup_.hertz.modulus;
  contact_.intervals = contactIntervals(normal, Boundary::Free);
}

// Throws Error where a pressure that was kept is above the hardness by more than mostExcess.
void FrozenCreep::checkExcess(const FrictionLaw &law, double speed, double creep) const
{
  const double mean = contact_.temperature.dot(contact_.pressure) / contact_.pressure.sum();
  Vector limits = physics_.pressureLimits(law, contact_.temperature);
  if (limits.size() == 0)
    limits = Vector::Constant(setup_.cells, physics_.pressureLimit(law, mean));
  const double excess = (contact_.pressure.array() / limits.array()).maxCoeff() - 1.0;
  if (excess > mostExcess)
    throw Error(ExitCode::NotConverged,
                fmt::format("creep {:g} at {:g} m/s: temperature and pressure do not settle: the "
                            "pressure of a cell jumps, to {:.2g} % above its hardness",
                            creep, speed, 100.0 * excess));
}

// The temperature rise Theta is the unknown of a fixed point Theta -> mu, p -> T -> Theta, and with
// a memory what friction has fallen to in each cell, r -> mu -> slip -> r; a step is the larger of
// both, in units of their tolerances. Of unlike bodies the pressure takes part: it is renewed with
// the traction of the turn before, and the end waits until it has settled; where it moves no less
// than in the turn before, as edges do that come and go by a cell, less of the gap's change is
// taken. Friction falls with strength where strength falls with Theta, so steps mostly alternate
// and shrink; where they grow, the step is halved for good, which tames any slope that is finite.
// It does not tame a jump: where a cell opens or closes as the hardness falls, the pressure of its
// neighbours changes by a finite amount, and Theta may end on either side of it. So from some
// iterations on a step that is no shorter also keeps the pressure, which then answers a temperature
// of a few tenths of a kelvin beside the last one.
CreepPoint FrozenCreep::solve(const FrictionLaw &law, double speed, double signedCreep)
{
  const double creep = std::abs(signedCreep);
  coupling_ = signedCreep < 0.0 ? -setup_.coupling : setup_.coupling;
  const bool couples = coupling_ != 0.0;
  const bool heats = physics_.hasFeedback(law);
  const bool remembers = memory_ && law.dependsOnSpeed();
  const bool needsTraction = couples || remembers ||
                             physics_.thermal.model == ThermalModel::Local ||
                             physics_.thermal.model == ThermalModel::AveragedPower;
  const double settled = temperatureTolerance * physics_.strengthOf(law).vanishingTemperature;
  memoryRatio_ = Vector::Ones(setup_.cells);
  if (law.growsWithTemperature()) // the point before may have settled hot
    contact_.temperature.setZero();
  double part = 1.0, lastStep = 0.0, opened = 1.0, lastMoved = 0.0;
  opening_ = Vector::Zero(setup_.cells);
  bool jumps = false;
  int iteration = 1;
  for (;; ++iteration) {
    const Vector formerPressure = contact_.pressure;
    if (((physics_.hardnessLimit && heats) || couples) && iteration > 1 && !jumps)
      try {
        renewPressure(law, opened);
      } catch (const Error &error) {
        if (error.code() != ExitCode::BadInput)
          throw;
        // beyond the domain by its own heat or traction: other points may well stay inside
        throw Error(ExitCode::NotConverged,
                    fmt::format("creep {:g} at {:g} m/s: {}", creep, speed, error.what()));
      }
    const double moved = (contact_.pressure - formerPressure).norm() / formerPressure.norm();
    const bool pressed = !couples || (iteration > 1 && moved <= couplingTolerance);
    if (iteration > 2 && moved >= lastMoved)
      opened *= 0.5;
    lastMoved = moved;
    contact_.mu = muNow(law, creep * speed);
    if (needsTraction)
      roll(creep);
    Vector remembered = memoryRatio_;
    if (remembers)
      remembered =
          memory_->steady(law, contact_.pressure, contact_.temperature, speed, contact_.slip);
    const Vector next = temperatureFrom(speed, creep);
    const double heatStep = heats ? (next - contact_.temperature).cwiseAbs().maxCoeff() : 0.0;
    if (!heats)
      contact_.temperature = next;
    if (!heats && !remembers && !couples)
      break;
    const double memoryStep = (remembered - memoryRatio_).cwiseAbs().maxCoeff();
    const double step = std::max(heatStep / settled, memoryStep / memoryTolerance);
    if (step <= 1.0 && pressed)
      break;
    if (iteration >= maxIterations)
      throw Error(
          ExitCode::NotConverged,
          fmt::format("creep {:g} at {:g} m/s: {} do not settle after {} iterations (last step "
                      "{:.2e} K, {:.2e} of mu by its memory)",
                      creep, speed,
                      step > 1.0 ? "temperature and friction"
                                 : "pressure and traction of unlike bodies",
                      iteration, heatStep, memoryStep));
    if (iteration > 1 && step > 1.0 && step >= lastStep) {
      const bool begins = physics_.hardnessLimit && !jumps && iteration > settling;
      jumps = jumps || begins;
      part = begins ? 1.0 : 0.5 * part;
    }
    lastStep = step;
    contact_.temperature += part * (next - contact_.temperature);
    memoryRatio_ += part * (remembered - memoryRatio_);
  }
  if (jumps)
    checkExcess(law, speed, creep);
  if (!needsTraction)
    roll(creep);
  const double hottest = contact_.temperature.maxCoeff();
  physics_.checkStrength(law, hottest, speed, creep);

  CreepPoint point;
  static_cast<LineValues &>(point) =
      lineValues(setup_, tractionRatio(), contact_.traction, contact_.pressure, contact_.mu,
                 contact_.temperature, contact_.state);
  point.frictionWork = frictionWork_;
  point.speed = speed;
  point.creep = creep;
  point.traction = point.tractionRatio * setup_.hertz.load;
  point.temperatureMaximum = physics_.thermal.model == ThermalModel::Local
                                 ? hottest
                                 : maximumOverMeanTemperature() * hottest;
  point.iterations = iteration;
  return point;
}

LawUse FrozenCreep::use(const FrictionLaw &law, double speed, double creep) const
{
  return law.use({contact_.pressure, creep * speed, contact_.temperature});
}

} // namespace wheelrail
