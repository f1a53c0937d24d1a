#include "moving_creep.h"

#include "errors.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double pressureTolerance = 1e-6; ///< the next step shifts the pressure by a cell anyway

/// One creep on its way through the contact.
struct Roller {
  TransientRolling rolling;
  double temperature = 0.0, ratioOfPass = 0.0, muOfPass = 0.0; ///< sums over the pass for the two
  double ratio = 0.0, mu = 0.0, stick = 0.0;                   ///< sums over the last half
  Vector coefficient;
  RollingResult result;
};

/// The pressure of the step before, moved along with the material, to start from.
Vector movedAlong(const Vector &pressure)
{
  Vector moved = Vector::Zero(pressure.size());
  moved.head(pressure.size() - 1) = pressure.tail(pressure.size() - 1);
  return moved;
}

} // namespace

MovingCreep::MovingCreep(const Case &inputCase, const FrictionLaw &frictionLaw,
                         const ContactSetup &contactSetup)
    : input(inputCase), law(frictionLaw), setup(contactSetup)
{
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
  HalfPlane halfPlane(setup.cells, Boundary::Free);
  const double reference = input.referenceLength * hertz.halfWidth / setup.cellSize;
  std::vector<Roller> rollers;
  for (std::size_t k = 0; k < creeps.size(); ++k)
    rollers.push_back({TransientRolling(halfPlane, reference), 0, 0, 0, 0, 0, 0, {}, {}});

  NormalContactOptions options;
  options.tolerance = pressureTolerance;
  options.start = setup.normal.pressure;
  Vector pressure;
  for (int step = 0; step < steps; ++step) {
    if (!progress())
      return {};
    double warmest = 0.0;
    for (const Roller &roller : rollers)
      warmest = std::max(warmest, roller.temperature);
    const NormalContactResult normal =
        solveNormalContact(halfPlane, setup.problem(pressureLimit(input, warmest), step), options);
    checkInsideDomain(normal.pressure);
    options.start = movedAlong(normal.pressure);
    pressure = normal.pressure * hertz.modulus;
    for (std::size_t k = 0; k < creeps.size(); ++k) {
      Roller &roller = rollers[k];
      roller.coefficient = frictionCoefficient(input, law, pressure, creeps[k] * speed,
                                               Vector::Constant(setup.cells, roller.temperature));
      roller.result =
          roller.rolling.step(roller.coefficient.cwiseProduct(normal.pressure), creeps[k]);
      const double ratio = roller.result.force() / normal.pressure.sum();
      const double mu = roller.coefficient.dot(pressure) / pressure.sum();
      roller.ratioOfPass += ratio;
      roller.muOfPass += mu;
      if (step >= steps / 2) {
        roller.ratio += ratio;
        roller.mu += mu;
        roller.stick += roller.result.stickFraction();
      }
      if ((step + 1) % pass != 0)
        continue;
      if (input.thermal != ThermalModel::Off) {
        const double heat =
            input.thermal == ThermalModel::Averaged ? roller.muOfPass : roller.ratioOfPass;
        roller.temperature =
            meanTemperatureRise(heat / pass, hertz.hertzPressure, creeps[k] * speed,
                                hertz.halfWidth, speed, input.material);
      }
      roller.ratioOfPass = roller.muOfPass = 0.0;
    }
  }

  std::vector<CreepPoint> points;
  const double counted = steps - steps / 2;
  for (std::size_t k = 0; k < creeps.size(); ++k) {
    const Roller &roller = rollers[k];
    CreepPoint point;
    point.speed = speed;
    point.creep = creeps[k];
    point.tractionRatio = roller.ratio / counted;
    point.traction = point.tractionRatio * hertz.load;
    point.muMean = roller.mu / counted;
    point.temperatureRise = roller.temperature;
    point.temperatureMaximum = maximumOverMeanTemperature() * roller.temperature;
    point.iterations = steps;
    point.stickFraction = roller.stick / counted;
    points.push_back(point);
  }
  const Roller &last = rollers.back();
  contact.pressure = pressure;
  contact.traction = last.result.traction * hertz.modulus;
  contact.mu = last.coefficient;
  contact.slip = last.result.slip;
  contact.state = last.result.state;
  contact.temperature = Vector::Constant(setup.cells, last.temperature);
  return points;
}

} // namespace wheelrail
