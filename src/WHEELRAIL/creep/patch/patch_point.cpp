// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_point.h"

#include "base/errors.h"
#include "contact/patch/elasticity/patch_half_space.h"
#include "shared/pi.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <utility>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

using mcawr::pi;
constexpr double temperatureTolerance = 1e-7; ///< of the strength temperature
constexpr double memoryTolerance = 1e-5;      ///< of mu
constexpr double creepTolerance = 1e-6;       ///< of a creepage that is found, relative
constexpr int maxIterations = 100;

} // namespace

double rigidSlip(const PatchGrid &grid, const Vector &pressure, const Creepage &creepage)
{
  if (creepage.phi == 0.0)
    return std::hypot(creepage.xi, creepage.eta);
  double squares = 0.0;
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const double x = creepage.xi - creepage.phi * grid.y(iy);
      const double y = creepage.eta + creepage.phi * grid.x(ix);
      squares += pressure[grid.index(ix, iy)] * (x * x + y * y);
    }
  return std::sqrt(squares / pressure.sum());
}

// A row at y has the half-length a r and the pressure p0 r, r = sqrt(1 - y^2/b^2), so that Eq. 11
// gives it r^1.5 of the middle row's mean. Weighted with its length: integral of r^2.5 over that of
// r, Beta(1/2, 9/4)/(pi/2).
double meanOverEllipse()
{
  return std::sqrt(pi) * std::tgamma(2.25) / std::tgamma(2.75) / (0.5 * pi);
}

double meanTemperatureRise(double powerOverLoad, const HertzEllipse &hertz, double speed,
                           const ThermalMaterial &material)
{
  return meanOverEllipse() *
         meanTemperatureRise(powerOverLoad, hertz.hertzPressure, hertz.a, speed, material);
}

double largestTemperature(const ThermalSpecification &thermal, double hottest)
{
  return thermal.model == ThermalModel::Local
             ? hottest
             : thermal.bulk +
                   maximumOverMeanTemperature() / meanOverEllipse() * (hottest - thermal.bulk);
}

Vector frictionalHeat(const TangentialResult &result, double speed)
{
  return -speed * (result.traction.x.cwiseProduct(result.slip.x) +
                   result.traction.y.cwiseProduct(result.slip.y));
}

TangentialOptions FrozenPatch::defaultOptions()
{
  TangentialOptions options;
  options.tolerance = 1e-6;
  return options;
}

FrozenPatch::FrozenPatch(const CreepPhysics &physics, const PatchContact &contact, double spinPoint,
                         TangentialOptions options)
    : physics_(physics), contact_(contact), spinPoint_(spinPoint), options_(std::move(options)),
      solver_(contact.grid, contact.pair), coupling_(contact.grid, contact.pair)
{
  pressAnew();
  fields_.temperature = Vector::Constant(contact.grid.cells(), physics.thermal.bulk);
  memoryRatio_ = Vector::Ones(contact.grid.cells());
  if (physics.memoryLength > 0.0)
    memory_.emplace(contact.grid, physics.memoryLength);
}

Vector FrozenPatch::muNow(const FrictionLaw &law, double speed) const
{
  return contact_.across(
      memory_ ? SlipMemory::mu(law, fields_.pressure, fields_.temperature, memoryRatio_)
              : law.mu({fields_.pressure, slidingSpeed(speed), fields_.temperature}));
}

void FrozenPatch::pressAnew()
{
  fields_.pressure = contact_.normal.pressure;
  fields_.gap = contact_.normal.gap;
  approach_ = contact_.normal.approach;
}

TangentialResult FrozenPatch::roll(const PatchDrive &drive, const Creepage &guess)
{
  TangentialProblem problem;
  problem.bound = contact_.bound(fields_.mu, fields_.pressure);
  problem.creepage = drive.creepage;
  problem.forceX = drive.forceX;
  problem.forceY = drive.forceY;
  problem.spinPoint = spinPoint_;
  imposed_ = coupling_.tangential(fields_.pressure);
  problem.imposed = imposed_;
  problem.edge = contact_.edge(fields_.pressure, fields_.gap);
  if (drive.forceX)
    problem.creepage.xi = guess.xi;
  if (drive.forceY)
    problem.creepage.eta = guess.eta;
  TangentialOptions options = options_;
  if (warm_)
    options.start = std::move(result_.traction);
  result_ = {}; // on a fine grid each field counts
  return solver_.solve(problem, options);
}

/// Warm from the last solution; from coarse grids where that does not converge.
void FrozenPatch::rollWarmOrCold(const PatchDrive &drive)
{
  try {
    result_ = roll(drive, creepage_);
  } catch (const Error &error) {
    if (!warm_ || error.code() != ExitCode::NotConverged)
      throw;
    warm_ = false;
    result_ = roll(drive, {});
  }
  warm_ = true;
  creepage_ = result_.creepage;
  products_ += result_.products + result_.coarseProducts;
}

double FrozenPatch::slidingSpeed(double speed) const
{
  return speed * rigidSlip(contact_.grid, fields_.pressure, creepage_);
}

Vector FrozenPatch::temperatureFrom(double speed)
{
  const ThermalSpecification &thermal = physics_.thermal;
  const int n = contact_.grid.cells();
  switch (thermal.model) {
  case ThermalModel::Off:
    return Vector::Zero(n);
  case ThermalModel::Local:
    if (!flash_ || flashSpeed_ != speed)
      flash_.emplace(contact_.grid, contact_.grid.dx, speed, thermal.material);
    flashSpeed_ = speed;
    return flash_->rise(frictionalHeat(result_, speed)).array() + physics_.thermal.bulk;
  default:
    break;
  }
  const double powerOverLoad =
      thermal.model == ThermalModel::Averaged
          ? contact_.meanFriction(fields_.mu, fields_.pressure) * slidingSpeed(speed)
          : sums().drivingPower * speed / contact_.load;
  return Vector::Constant(n, thermal.bulk + meanTemperatureRise(powerOverLoad, contact_.hertz,
                                                                speed, thermal.material));
}

/// The normal contact once more, from the last pressure.
/// The hardness falls with the temperature, that of each cell where it is known, else the contact's
/// mean; unlike bodies' traction opens or closes the gap.
void FrozenPatch::renewPressure(const FrictionLaw &law)
{
  const double mean = fields_.temperature.dot(fields_.pressure) / fields_.pressure.sum();
  NormalContactOptions options;
  options.start = fields_.pressure;
  if (!space_)
    space_.emplace(contact_.grid, contact_.pair);
  NormalContactProblem problem = contact_.problem(physics_.pressureLimit(law, mean), contact_.load);
  problem.cellLimits = physics_.pressureLimits(law, fields_.temperature);
  if (coupling_.any())
    problem.profile += coupling_.normal(result_.traction);
  const NormalContactResult normal = solveNormalContact(*space_, problem, options);
  checkInsideBox(contact_.grid, normal.pressure);
  fields_.pressure = normal.pressure;
  fields_.gap = normal.gap;
  approach_ = normal.approach;
}

void FrozenPatch::failToSettle(double speed, int iterations, bool friction) const
{
  throw Error(ExitCode::NotConverged,
              fmt::format("creep {:g}, lateral {:g}, spin {:g} /m at {:g} m/s: {} do not settle "
                          "after {} iterations; {} there",
                          creepage_.xi, creepage_.eta, creepage_.phi, speed,
                          friction ? "temperature and friction" : "pressure and traction",
                          iterations,
                          friction ? "the friction law falls too steeply"
                                   : "the bodies are too unlike for the friction"));
}

PatchPoint FrozenPatch::solve(const FrictionLaw &law, double speed, const PatchDrive &drive)
{
  try {
    return settle(law, speed, drive);
  } catch (const ForceTooLarge &error) {
    if (!law.dependsOnSpeed())
      throw;
    return solveAlongCreep(law, speed, drive, error);
  }
}

// Where mu rises with speed the creepage of the point before may carry less than the force, and the
// one that carries it lies near full sliding, where a fixed point hardly settles. So the creepage
// along the larger force is given, from small ones to large ones until they carry it, and then
// between two of them.
PatchPoint FrozenPatch::solveAlongCreep(const FrictionLaw &law, double speed,
                                        const PatchDrive &drive, const ForceTooLarge &error)
{
  constexpr double first = 1e-6, largest = 10.0, tolerance = 1e-8; // of `creepUnder`
  const double x = drive.forceX.value_or(0.0), y = drive.forceY.value_or(0.0);
  const bool alongX = std::abs(x) >= std::abs(y);
  const double force = alongX ? x : y, wanted = std::abs(force), sign = force < 0.0 ? 1.0 : -1.0;
  double most = error.capacity, outer = 0.0;
  const Vector cold = Vector::Constant(contact_.grid.cells(), physics_.thermal.bulk);
  for (double creep = first; creep <= largest; creep *= 2.0) {
    const Vector mu = contact_.across(law.mu({fields_.pressure, speed * creep, cold}));
    const double carries = contact_.bound(mu, fields_.pressure).sum() * contact_.grid.cellArea();
    most = std::max(most, carries);
    if (outer == 0.0 && carries > error.force)
      outer = creep;
  }
  if (outer == 0.0)
    throw ForceTooLarge(error.force, most);
  int products = products_;
  PatchPoint point;
  const auto missing = [&](double creep) {
    PatchDrive given = drive;
    (alongX ? given.forceX : given.forceY).reset();
    (alongX ? given.creepage.xi : given.creepage.eta) = sign * creep;
    try {
      point = settle(law, speed, given);
    } catch (const ForceTooLarge &) { // the other force alone
      return -wanted;
    }
    products += point.products;
    return -sign * (alongX ? point.forceX : point.forceY) - wanted;
  };
  double inner = 0.0, innerMissing = missing(inner), outerMissing = missing(outer);
  while (outerMissing < 0.0 && outer < largest) {
    inner = outer;
    innerMissing = outerMissing;
    outer *= 2.0;
    outerMissing = missing(outer);
  }
  if (innerMissing > 0.0 || outerMissing < 0.0)
    throw ForceTooLarge(error.force, error.capacity);
  if (outerMissing > 0.0) {
    std::uintmax_t steps = 60;
    const auto close = [](double a, double b) { return std::abs(b - a) <= tolerance * b; };
    const auto [low, high] = boost::math::tools::toms748_solve(missing, inner, outer, innerMissing,
                                                               outerMissing, close, steps);
    missing(0.5 * (low + high));
  }
  point.products = products;
  return point;
}

// A fixed point, as in `FrozenCreep::solve`. One turn G leads from a temperature field to the one
// that follows from it: temperature -> mu and pressure -> traction -> heat -> temperature. What is
// sought is the field with G(Theta) = Theta. Where forces are given and mu depends on speed, the
// creepages that are found belong to the unknowns, too, since they decide the sliding speed.
//
// The iteration is Theta <- Theta + part (G(Theta) - Theta). Friction falls with temperature and
// less friction makes less heat, so that G has a negative slope g and plain turns (part = 1) jump
// to and fro across the solution; they converge while |g| < 1. With a part the error shrinks by |1
// - part (1 + |g|)| a turn. So the part begins at 1 and is halved whenever a step is no shorter
// than the one before; a law that falls too steeply even then is named by `failToSettle`. Newton's
// method would need the derivative of a solution of the tangential contact; a turn costs one such
// solution, and that begins at the last traction.
//
// The steps of temperature, of creepage and of what friction remembers are counted in units of
// their tolerances, and the largest one decides on the end and on halving. Of unlike bodies the
// pressure takes part: it is renewed with the traction of the turn before, and the end waits until
// it has settled.
PatchPoint FrozenPatch::settle(const FrictionLaw &law, double speed, const PatchDrive &drive)
{
  const bool found = drive.forceX || drive.forceY;
  const bool heats = physics_.hasFeedback(law);
  // creepages that are not known beforehand decide the sliding speed
  const bool slides = found && law.dependsOnSpeed();
  const bool couples = coupling_.any();
  const bool remembers = memory_ && law.dependsOnSpeed();
  const bool feedback = heats || slides || couples || remembers;
  const bool needsTraction = found || couples || remembers ||
                             physics_.thermal.model == ThermalModel::Local ||
                             physics_.thermal.model == ThermalModel::AveragedPower;
  products_ = 0;
  fields_.traction = fields_.slip = {};
  if (!drive.forceX)
    creepage_.xi = drive.creepage.xi;
  if (!drive.forceY)
    creepage_.eta = drive.creepage.eta;
  creepage_.phi = drive.creepage.phi;
  // without feedback one turn gives it; where friction grows the point before may have settled hot
  if (!feedback || law.growsWithTemperature())
    fields_.temperature.setConstant(physics_.thermal.bulk);
  double part = 1.0, lastStep = 0.0;
  int iteration = 0;
  while (true) {
    ++iteration;
    const Vector formerPressure = fields_.pressure;
    // the first turn takes the pressure of the start, without heat and without traction
    if (((physics_.hardnessLimit && heats) || couples) && iteration > 1)
      try {
        renewPressure(law);
      } catch (const Error &error) {
        if (error.code() != ExitCode::BadInput)
          throw;
        // beyond the box by its own heat or traction: other points may well stay inside
        throw Error(ExitCode::NotConverged,
                    fmt::format("creep {:g}, lateral {:g}, spin {:g} /m at {:g} m/s: {}",
                                creepage_.xi, creepage_.eta, creepage_.phi, speed, error.what()));
      }
    const bool pressed =
        !couples || (iteration > 1 && PatchCoupling::settled(formerPressure, fields_.pressure));
    const Creepage before = creepage_;
    fields_.mu = muNow(law, speed);
    if (needsTraction)
      rollWarmOrCold(drive);
    Vector remembered = memoryRatio_;
    if (remembers)
      remembered =
          memory_->steady(law, fields_.pressure, fields_.temperature, speed, result_.slip.length());
    const Vector next = temperatureFrom(speed);
    // of the temperature, and of the creepages as a share that counts as much
    const double heatStep =
        physics_.thermal.model == ThermalModel::Off
            ? 0.0 // then nothing needs a strength, and a physics may have none
            : (next - fields_.temperature).cwiseAbs().maxCoeff() /
                  (temperatureTolerance * physics_.strengthOf(law).vanishingTemperature);
    const double size = std::hypot(creepage_.xi, creepage_.eta);
    const double moved = std::hypot(creepage_.xi - before.xi, creepage_.eta - before.eta);
    const double creepStep = slides && moved > 0.0 ? moved / (creepTolerance * size) : 0.0;
    const double memoryStep = (remembered - memoryRatio_).cwiseAbs().maxCoeff() / memoryTolerance;
    const double step = std::max({heatStep, creepStep, memoryStep});
    if (!feedback) { // G does not depend on its argument: one turn is the solution
      fields_.temperature = next;
      break;
    }
    if (step <= 1.0 && pressed)
      break;
    if (iteration >= maxIterations)
      failToSettle(speed, iteration, step > 1.0);
    if (iteration > 1 && step > 1.0 && step >= lastStep)
      part *= 0.5;
    lastStep = step;
    fields_.temperature += part * (next - fields_.temperature);
    memoryRatio_ += part * (remembered - memoryRatio_);
    if (slides) {
      creepage_.xi = before.xi + part * (creepage_.xi - before.xi);
      creepage_.eta = before.eta + part * (creepage_.eta - before.eta);
    }
  }
  if (!needsTraction)
    rollWarmOrCold(drive);
  physics_.checkStrength(law, fields_.temperature.maxCoeff(), speed, creepage_.xi);
  fields_.traction = result_.traction;
  fields_.slip = result_.slip;
  fields_.state = result_.state;
  return pointOf(law, speed, iteration);
}

PatchSums FrozenPatch::sums() const
{
  PatchSums sums = patchSums(contact_.grid, result_);
  sums.drivingPower += couplingPower(contact_.grid, result_.traction, imposed_, imposed_);
  return sums;
}

PatchPoint FrozenPatch::pointOf(const FrictionLaw &law, double speed, int iterations) const
{
  const PatchSums sums = this->sums();
  PatchPoint point;
  static_cast<PatchValues &>(point) = patchValues(
      {contact_, sums, result_, physics_.wear, contact_.carried(contact_.load, fields_.pressure),
       approach_, result_.creepage, fields_.pressure, fields_.mu, fields_.temperature, speed});
  point.surface = contact_.surface.number;
  point.speed = speed;
  const double hottest = fields_.temperature.maxCoeff();
  point.temperatureMaximum = largestTemperature(physics_.thermal, hottest);
  point.iterations = iterations;
  point.products = products_;
  point.powerClosure = sums.powerClosure();
  point.use = law.use({fields_.pressure, slidingSpeed(speed), fields_.temperature});
  return point;
}

} // namespace wheelrail
