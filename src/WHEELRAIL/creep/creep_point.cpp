#include "creep/creep_point.h"

#include "base/errors.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double temperatureTolerance = 1e-9; ///< of the strength temperature
constexpr int maxIterations = 100;

} // namespace

Vector frictionCoefficient(const Case &input, const FrictionLaw &law, const Vector &pressure,
                           double slidingSpeed, const Vector &temperature)
{
  const auto n = pressure.size();
  if (input.law == "constant")
    return Vector::Constant(n, input.mu);
  const double speed = input.velocityTerm ? slidingSpeed : 0.0;
  const auto kappa1At = [&](double strength) {
    return kappa1(input.frictionDensity, input.frictionModulus, speed, strength);
  };
  Vector mu(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i > 0 && !input.local && temperature[i] == temperature[i - 1]) {
      mu[i] = mu[i - 1];
      continue;
    }
    const double strength = strengthAt(input, temperature[i]);
    mu[i] = input.local
                ? law(kappa1At(strength), kappa2(pressure[i], input.frictionModulus, strength))
                : law.averaged(kappa1At(strength), input.frictionModulus, strength);
  }
  if (!(mu.minCoeff() > 0.0))
    throw Error(
        ExitCode::NotConverged,
        fmt::format("friction.law: mu = {:.4g} at a sliding speed of {:g} m/s; the law does "
                    "not hold that far from the points it was fitted to",
                    mu.minCoeff(), slidingSpeed));
  return mu;
}

FrozenCreep::FrozenCreep(const Case &inputCase, const ContactSetup &contactSetup)
    : input(inputCase), setup(contactSetup)
{
  contact.intervals = contactIntervals(setup.normal, Boundary::Free);
  contact.pressure = setup.normal.pressure * setup.hertz.modulus;
  contact.traction = contact.temperature = contact.slip = Vector::Zero(setup.cells);
  contact.state.assign(setup.cells, Adhesion::Apart);
}

void FrozenCreep::roll(double creep)
{
  const std::vector<ContactInterval> &intervals = contact.intervals;
  const int needed = intervals.back().last - intervals.front().first + 1;
  if (!window || window->cells() < needed)
    window.emplace(std::min(setup.cells, fastTransformSize(2 * needed) / 2), Boundary::Free);
  const int cells = window->cells();
  const int first = std::min(intervals.front().first, setup.cells - cells);
  const double modulus = setup.hertz.modulus;

  RollingOptions options;
  options.start.assign(contact.state.begin() + first, contact.state.begin() + first + cells);
  options.startTraction = contact.traction.segment(first, cells) / modulus;
  options.contact = intervals;
  for (ContactInterval &interval : options.contact)
    interval.shift(-first);
  const Vector bound = contact.mu.cwiseProduct(contact.pressure).segment(first, cells) / modulus;
  const RollingResult result = solveFrozenRolling(*window, bound, creep, options);
  contact.traction.setZero();
  contact.slip.setZero();
  contact.state.assign(setup.cells, Adhesion::Apart);
  contact.traction.segment(first, cells) = result.traction * modulus;
  contact.slip.segment(first, cells) = result.slip;
  std::copy(result.state.begin(), result.state.end(), contact.state.begin() + first);
}

double FrozenCreep::meanMu() const
{
  return contact.mu.dot(contact.pressure) / contact.pressure.sum();
}

Vector FrozenCreep::temperatureFrom(double speed, double creep)
{
  const int n = setup.cells;
  if (input.thermal == ThermalModel::Off)
    return Vector::Zero(n);
  if (input.thermal == ThermalModel::Local) {
    if (!flash || flashSpeed != speed)
      flash.emplace(n, setup.cellSize, speed, input.material);
    flashSpeed = speed;
    return flash->rise(contact.traction.cwiseProduct(contact.slip) * speed);
  }
  const double ratio = input.thermal == ThermalModel::Averaged ? meanMu() : tractionRatio();
  return Vector::Constant(n, meanTemperatureRise(ratio, setup.hertz.hertzPressure, creep * speed,
                                                 setup.hertz.halfWidth, speed, input.material));
}

/// The hardness falls with the mean temperature of the contact: solve again where it binds.
void FrozenCreep::limitPressure()
{
  const double mean = contact.temperature.dot(contact.pressure) / contact.pressure.sum();
  NormalContactOptions options;
  options.start = contact.pressure / setup.hertz.modulus;
  if (!domain)
    domain.emplace(setup.cells, Boundary::Free);
  const NormalContactResult normal =
      solveNormalContact(*domain, setup.problem(pressureLimit(input, mean)), options);
  checkInsideDomain(normal.pressure);
  contact.pressure = normal.pressure * setup.hertz.modulus;
  contact.intervals = contactIntervals(normal, Boundary::Free);
}

CreepPoint FrozenCreep::solve(const FrictionLaw &law, double speed, double creep)
{
  const bool needsTraction =
      input.thermal == ThermalModel::Local || input.thermal == ThermalModel::AveragedPower;
  const bool feedback = hasFeedback(input);
  double part = 1.0, lastStep = 0.0;
  int iteration = 1;
  for (;; ++iteration) {
    if (input.hardnessLimit && iteration > 1)
      limitPressure();
    contact.mu =
        frictionCoefficient(input, law, contact.pressure, creep * speed, contact.temperature);
    if (needsTraction)
      roll(creep);
    const Vector next = temperatureFrom(speed, creep);
    const double step = (next - contact.temperature).cwiseAbs().maxCoeff();
    if (!feedback) {
      contact.temperature = next;
      break;
    }
    if (step <= temperatureTolerance * input.strengthTemperature)
      break;
    if (iteration >= maxIterations)
      throw Error(ExitCode::NotConverged,
                  fmt::format("creep {} at {} m/s: temperature and friction do not settle after {} "
                              "iterations (last step {:.2e} K)",
                              creep, speed, iteration, step));
    if (iteration > 1 && step >= lastStep)
      part *= 0.5;
    lastStep = step;
    contact.temperature += part * (next - contact.temperature);
  }
  if (!needsTraction)
    roll(creep);
  const double hottest = contact.temperature.maxCoeff();
  checkStrength(input, hottest, speed, creep);

  CreepPoint point;
  point.speed = speed;
  point.creep = creep;
  point.tractionRatio = tractionRatio();
  point.traction = point.tractionRatio * setup.hertz.load;
  point.muMean = meanMu();
  point.temperatureRise = setup.nominalMean(contact.temperature);
  point.temperatureMaximum =
      input.thermal == ThermalModel::Local ? hottest : maximumOverMeanTemperature() * hottest;
  point.iterations = iteration;
  const auto touching = std::count_if(contact.state.begin(), contact.state.end(),
                                      [](Adhesion s) { return s != Adhesion::Apart; });
  point.stickFraction =
      double(std::count(contact.state.begin(), contact.state.end(), Adhesion::Stick)) / touching;
  return point;
}

} // namespace wheelrail
