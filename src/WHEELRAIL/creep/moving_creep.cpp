#include "creep/moving_creep.h"

#include "base/errors.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double pressureTolerance = 1e-5; ///< the next step shifts the pressure by a cell anyway

/// Moved along with the material by one cell; what comes in is 0.
Vector movedAlong(const Vector &values)
{
  Vector moved = Vector::Zero(values.size());
  moved.head(values.size() - 1) = values.tail(values.size() - 1);
  return moved;
}

} // namespace

MovingCreep::MovingCreep(const Case &inputCase, const FrictionLaw &frictionLaw,
                         const ContactSetup &contactSetup)
    : input(inputCase), law(frictionLaw), setup(contactSetup),
      domain(contactSetup.cells, Boundary::Free), normal(contactSetup.normal)
{
}

void MovingCreep::solvePressure(int step, double temperature)
{
  NormalContactOptions options;
  options.tolerance = pressureTolerance;
  options.start = step ? movedAlong(normal.pressure) : normal.pressure;
  normal =
      solveNormalContact(domain, setup.problem(pressureLimit(input, temperature), step), options);
  checkInsideDomain(normal.pressure);
  contact.pressure = normal.pressure * setup.hertz.modulus;
}

/// Makes the window as large as this step's contact needs (never at the domain's ends); it never
/// shrinks.
void MovingCreep::fitWindow(std::vector<Roller> &rollers)
{
  int first = 0, last = setup.cells - 1;
  while (!(normal.pressure[first + 1] > 0.0))
    ++first; // one cell more: traction leaves the contact there
  while (!(normal.pressure[last] > 0.0))
    --last;
  int end = last + 1;
  if (window) {
    if (first >= windowBegin && end <= windowBegin + window->cells())
      return;
    first = std::min(first, windowBegin);
    end = std::max(end, windowBegin + window->cells());
  }
  const int cells = std::min(setup.cells, fastTransformSize(2 * (end - first)) / 2);
  const int begin = std::clamp((first + end - cells) / 2, 0, setup.cells - cells);
  window.emplace(cells, Boundary::Free);
  for (Roller &roller : rollers)
    roller.rolling.moveTo(*window, begin - windowBegin);
  windowBegin = begin;
}

void MovingCreep::roll(Roller &roller, double speed, bool counted)
{
  const Vector &p = contact.pressure;
  const int cells = window->cells();
  if (roller.heat)
    roller.temperature = movedAlong(roller.temperature);
  checkStrength(input, roller.temperature.maxCoeff(), speed, roller.creep);
  roller.mu = frictionCoefficient(input, law, p, roller.creep * speed, roller.temperature);
  roller.result = roller.rolling.step(
      roller.mu.cwiseProduct(normal.pressure).segment(windowBegin, cells), roller.creep);
  const double ratio = roller.result.force() / normal.pressure.sum();
  const double mu = roller.mu.dot(p) / p.sum();
  roller.pass.ratio += ratio;
  roller.pass.mu += mu;
  if (roller.heat) {
    Vector heat = Vector::Zero(setup.cells);
    heat.segment(windowBegin, cells) =
        roller.result.traction.cwiseProduct(roller.result.slip) * (setup.hertz.modulus * speed);
    roller.heat->step(heat);
    for (int i = 0; i < setup.cells; ++i)
      if (setup.isNominal(i) || (i >= windowBegin && i < windowBegin + cells))
        roller.temperature[i] = roller.heat->rise(i);
  }
  if (!counted)
    return;
  roller.counted.ratio += ratio;
  roller.counted.mu += mu;
  roller.counted.stick += roller.result.stickFraction();
  roller.counted.temperature += setup.nominalMean(roller.temperature);
  roller.hottest = std::max(roller.hottest, roller.temperature.maxCoeff());
}

void MovingCreep::endPass(Roller &roller, double speed, int steps)
{
  if (input.thermal == ThermalModel::Averaged || input.thermal == ThermalModel::AveragedPower) {
    const double heat =
        input.thermal == ThermalModel::Averaged ? roller.pass.mu : roller.pass.ratio;
    roller.temperature.setConstant(meanTemperatureRise(heat / steps, setup.hertz.hertzPressure,
                                                       roller.creep * speed, setup.hertz.halfWidth,
                                                       speed, input.material));
  }
  roller.pass = {};
}

CreepPoint MovingCreep::pointOf(const Roller &roller, double speed, int steps, int counted) const
{
  CreepPoint point;
  point.speed = speed;
  point.creep = roller.creep;
  point.tractionRatio = roller.counted.ratio / counted;
  point.traction = point.tractionRatio * setup.hertz.load;
  point.muMean = roller.counted.mu / counted;
  point.temperatureRise = roller.counted.temperature / counted;
  point.temperatureMaximum =
      roller.heat ? roller.hottest : maximumOverMeanTemperature() * roller.hottest;
  point.iterations = steps;
  point.stickFraction = roller.counted.stick / counted;
  return point;
}

std::vector<CreepPoint> MovingCreep::solve(double speed, const std::vector<double> &creeps,
                                           const std::function<bool()> &progress)
{
  const HertzContact &hertz = setup.hertz;
  const int pass = static_cast<int>(std::ceil(2.0 * hertz.halfWidth / setup.cellSize));
  const int steps = input.passes * pass;
  if (steps > setup.longestTravel())
    throw Error(
        ExitCode::BadInput,
        fmt::format("mode moving: {} passes need a profile of {:.3g} mm, there are {:.3g} mm",
                    input.passes, (setup.cells + steps) * setup.cellSize * 1e3,
                    (setup.cells + setup.longestTravel()) * setup.cellSize * 1e3));
  const double reference = input.referenceLength * hertz.halfWidth / setup.cellSize;
  std::vector<Roller> rollers;
  for (int step = 0; step < steps; ++step) {
    if (!progress())
      return {};
    double warmest = 0.0;
    for (const Roller &roller : rollers)
      warmest = std::max(warmest, setup.nominalMean(roller.temperature));
    solvePressure(step, warmest);
    fitWindow(rollers);
    for (std::size_t k = rollers.size(); k < creeps.size(); ++k) {
      rollers.push_back({creeps[k],
                         TransientRolling(*window, reference),
                         {},
                         Vector::Zero(setup.cells),
                         {},
                         {},
                         {},
                         {},
                         0.0});
      if (input.thermal == ThermalModel::Local)
        rollers.back().heat.emplace(setup.cells, setup.cellSize, speed, input.material);
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
  const Roller &last = rollers.back();
  const int cells = window->cells();
  contact.mu = last.mu;
  contact.temperature = last.temperature;
  if (last.heat)
    for (int i = 0; i < setup.cells; ++i)
      contact.temperature[i] = last.heat->rise(i);
  contact.traction = contact.slip = Vector::Zero(setup.cells);
  contact.traction.segment(windowBegin, cells) = last.result.traction * hertz.modulus;
  contact.slip.segment(windowBegin, cells) = last.result.slip;
  contact.state.assign(setup.cells, Adhesion::Apart);
  std::copy(last.result.state.begin(), last.result.state.end(),
            contact.state.begin() + windowBegin);
  return points;
}

} // namespace wheelrail
