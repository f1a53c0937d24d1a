#include "creep_point.h"

#include "errors.h"

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
  return mu;
}

FrozenCreep::FrozenCreep(const Case &inputCase, const FrictionLaw &frictionLaw,
                         const ContactSetup &contactSetup)
    : input(inputCase), law(frictionLaw), setup(contactSetup),
      halfPlane(contactSetup.cells, Boundary::Free)
{
  restart();
}

void FrozenCreep::restart()
{
  normal = setup.normal;
  rolling = RollingOptions();
  contact.pressure = normal.pressure * setup.hertz.modulus;
  contact.temperature = Vector::Zero(setup.cells);
}

void FrozenCreep::roll(double creep)
{
  const Vector bound = contact.mu.cwiseProduct(contact.pressure) / setup.hertz.modulus;
  RollingResult result = solveFrozenRolling(halfPlane, bound, creep, rolling);
  contact.traction = result.traction * setup.hertz.modulus;
  contact.slip = result.slip;
  contact.state = result.state;
  rolling.start = std::move(result.state);
  rolling.startTraction = std::move(result.traction);
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
    FlashTemperature flash(n, setup.cellSize, speed, input.material);
    return flash.rise(contact.traction.cwiseProduct(contact.slip) * speed);
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
  options.start = normal.pressure;
  normal = solveNormalContact(halfPlane, setup.problem(pressureLimit(input, mean)), options);
  checkInsideDomain(normal.pressure);
  contact.pressure = normal.pressure * setup.hertz.modulus;
}

CreepPoint FrozenCreep::solve(double speed, double creep)
{
  const bool needsTraction =
      input.thermal == ThermalModel::Local || input.thermal == ThermalModel::AveragedPower;
  const bool feedback =
      input.thermal != ThermalModel::Off && (input.law != "constant" || input.hardnessLimit);
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
  if (feedback && hottest >= input.strengthTemperature)
    throw Error(
        ExitCode::NotConverged,
        fmt::format("creep {} at {} m/s: the temperature rise of {:.0f} K leaves no strength "
                    "(friction.strength_temperature is {} K)",
                    creep, speed, hottest, input.strengthTemperature));

  CreepPoint point;
  point.speed = speed;
  point.creep = creep;
  point.tractionRatio = tractionRatio();
  point.traction = point.tractionRatio * setup.hertz.load;
  point.muMean = meanMu();
  double sum = 0.0;
  int inside = 0;
  for (int i = 0; i < setup.cells; ++i) {
    if (std::abs(setup.position(i)) > setup.hertz.halfWidth)
      continue;
    sum += contact.temperature[i];
    ++inside;
  }
  point.temperatureRise = sum / inside;
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
