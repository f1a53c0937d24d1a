// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/moving_patch.h"

#include "base/errors.h"
#include "contact/patch/patch_sums.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double pressureTolerance = 1e-6; ///< the next step shifts the pressure by a cell anyway

double meanOf(const std::vector<double> &values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

double PatchSequence::at(const std::vector<double> &values, double seconds, double constant) const
{
  if (values.empty())
    return constant;
  const auto after = std::upper_bound(time.begin(), time.end(), seconds);
  if (after == time.begin())
    return values.front();
  if (after == time.end())
    return values.back();
  const auto k = static_cast<std::size_t>(after - time.begin());
  const double part = (seconds - time[k - 1]) / (time[k] - time[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

double batchError(const std::vector<double> &series, int batches)
{
  if (batches < 2 || static_cast<int>(series.size()) < batches)
    return 0.0;
  const std::size_t length = series.size() / batches; // what does not fill a batch is at the start
  std::vector<double> means;
  auto from = series.end() - static_cast<std::ptrdiff_t>(length * batches);
  for (int k = 0; k < batches; ++k, from += static_cast<std::ptrdiff_t>(length))
    means.push_back(meanOf({from, from + static_cast<std::ptrdiff_t>(length)}));
  const double mean = meanOf(means);
  double squares = 0.0;
  for (double value : means)
    squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (batches - 1) / batches);
}

double rolledDistance(const MovingPatchSpecification &moving, const PatchSequence &sequence,
                      const HertzEllipse &hertz, double speed)
{
  return sequence.any() ? sequence.time.back() * speed : moving.passes * 2.0 * hertz.a;
}

/// Temperature per cell: one for the contact from the mean of the pass before, or rows of material
/// that remember the heat of their way.
struct MovingPatch::Temperature {
  Temperature(const CreepPhysics &physics, const PatchContact &contact, double speed)
      : values(Vector::Zero(contact.grid.cells()))
  {
    if (physics.thermal.model == ThermalModel::Local)
      rows.assign(contact.grid.ny, TravellingHeat(contact.grid.nx, contact.grid.dx, speed,
                                                  physics.thermal.material));
  }

  void step(const PatchContact &contact, const Vector &heat, const Vector &pressure)
  {
    const PatchGrid &grid = contact.grid;
    for (int iy = 0; iy < static_cast<int>(rows.size()); ++iy) {
      rows[iy].step(heat.segment(grid.index(0, iy), grid.nx));
      for (int ix = 0; ix < grid.nx; ++ix) {
        const int i = grid.index(ix, iy);
        values[i] = pressure[i] > 0.0 || contact.isNominal(i) ? rows[iy].rise(ix) : 0.0;
      }
    }
  }

  Vector values; ///< K
  std::vector<TravellingHeat> rows;
  double ratio = 0.0, slidingSpeed = 0.0; ///< sums over the pass
};

MovingPatch::MovingPatch(const CreepPhysics &physics, const MovingPatchSpecification &moving,
                         const PatchSequence &sequence, const FrictionLaw &law,
                         const PatchContact &contact, double spinPoint)
    : physics_(physics), moving_(moving), sequence_(sequence), law_(law), contact_(contact),
      spinPoint_(spinPoint), space_(contact.grid, contact.pair), normal_(contact.normal),
      passSteps_(
          static_cast<int>(std::ceil(2.0 * contact.hertz.a / contact.grid.dx * (1.0 - 1e-12))))
{
}

/// The traction and the creepages that the first step goes on from.
void MovingPatch::begin(TransientPatch &transient, double speed, const PatchDrive &drive)
{
  creepage_ = drive.creepage;
  if (moving_.start == RollingStart::Rest)
    return;
  if (moving_.start == RollingStart::Steady) {
    FrozenPatch steady(physics_, contact_, spinPoint_);
    const PatchPoint point = steady.solve(law_, speed, drive);
    transient.startFrom(steady.fields().traction);
    creepage_ = point.creepage;
    products_ += point.products;
    return;
  }
  TransientPatch::Step shift;
  shift.bound = frictionCoefficient(physics_.friction, law_, normal_.pressure, 0.0,
                                    Vector::Zero(contact_.grid.cells()))
                    .cwiseProduct(normal_.pressure);
  shift.cells = 0;
  shift.forceX = drive.forceX.value_or(0.0);
  shift.forceY = drive.forceY.value_or(0.0);
  products_ += transient.step(shift).products;
}

void MovingPatch::press(int step, double load, double distance, const Creepage &creepage)
{
  if (step > 0) {
    const double way = contact_.grid.dx;
    wheel_ = {wheel_.x + way * (1.0 - 0.5 * creepage.xi), wheel_.y - 0.5 * way * creepage.eta};
    rail_ = {rail_.x + way * (1.0 + 0.5 * creepage.xi), rail_.y + 0.5 * way * creepage.eta};
  }
  const RoughPatch &surface = contact_.surface;
  const bool smooth = surface.wheel.isSmooth() && surface.rail.isSmooth();
  const double former = normal_.pressure.sum() * contact_.grid.cellArea();
  const bool sameLoad = std::abs(load - former) <= 1e-12 * load;
  if (smooth && sameLoad && !(physics_.hardnessLimit && physics_.hasFeedback()))
    return;
  NormalContactOptions options;
  options.tolerance = pressureTolerance;
  options.start =
      smooth ? normal_.pressure : shifted(contact_.grid, normal_.pressure, step > 0 ? 1 : 0);
  const double mean = fields_.temperature.dot(normal_.pressure) / normal_.pressure.sum();
  try {
    normal_ = solveNormalContact(
        space_, contact_.problem(physics_.pressureLimit(mean), load, wheel_, rail_), options);
    checkInsideBox(contact_.grid, normal_.pressure);
  } catch (const Error &error) {
    throw Error(error.code(),
                fmt::format("{} (after {:.4g} mm of rolling)", error.what(), distance * 1e3));
  }
}

PatchStep MovingPatch::roll(TransientPatch &transient, Temperature &heat, double speed,
                            const PatchDrive &drive, double distance, double load)
{
  const PatchGrid &grid = contact_.grid;
  TransientPatch::Step step;
  step.creepage = drive.creepage;
  if (drive.forceX)
    step.creepage.xi = creepage_.xi;
  if (drive.forceY)
    step.creepage.eta = creepage_.eta;
  step.forceX = drive.forceX;
  step.forceY = drive.forceY;
  step.spinPoint = spinPoint_;
  const double sliding = speed * rigidSlip(grid, normal_.pressure, step.creepage);
  if (!heat.rows.empty()) // what the friction coefficient sees is a cell behind
    heat.values = shifted(grid, heat.values, 1);
  physics_.checkStrength(heat.values.maxCoeff(), speed, step.creepage.xi);
  const Vector mu =
      frictionCoefficient(physics_.friction, law_, normal_.pressure, sliding, heat.values);
  step.bound = mu.cwiseProduct(normal_.pressure);
  const TangentialResult result = transient.step(step);
  creepage_ = result.creepage;
  products_ += result.products + result.coarseProducts;
  const PatchSums sums = patchSums(grid, result);
  if (!heat.rows.empty())
    heat.step(contact_, frictionalHeat(result, speed), normal_.pressure);

  PatchStep row;
  row.distance = distance;
  row.load = load;
  row.creepage = result.creepage;
  row.forceX = sums.forceX;
  row.forceY = sums.forceY;
  row.momentZ = sums.momentZ;
  row.muMean = mu.dot(normal_.pressure) / normal_.pressure.sum();
  row.temperatureRise = contact_.nominalMean(heat.values);
  row.stickFraction = sums.stickArea / sums.contactArea;
  row.approach = normal_.approach;
  row.peakPressure = normal_.peakPressure();
  row.realArea = contact_.realArea(normal_.pressure);
  row.frictionalPower = sums.frictionalPower * speed;
  heat.ratio += physics_.thermal.model == ThermalModel::AveragedPower && sliding > 0.0
                    ? sums.drivingPower * speed / (load * sliding)
                    : row.muMean;
  heat.slidingSpeed += sliding;
  fields_ = {result.state, normal_.gap, normal_.pressure, result.traction,
             result.slip,  mu,          heat.values};
  return row;
}

std::optional<PatchPoint> MovingPatch::solve(double speed, const PatchDrive &drive,
                                             const std::function<bool()> &goOn)
{
  const PatchGrid &grid = contact_.grid;
  const double way = rolledDistance(moving_, sequence_, contact_.hertz, speed);
  const int steps = sequence_.any() ? std::max(1, static_cast<int>(std::lround(way / grid.dx)))
                                    : moving_.passes * passSteps_;
  series_.clear();
  normal_ = contact_.normal;
  wheel_ = rail_ = {};
  products_ = 0;
  hottest_ = 0.0;
  TransientPatch transient(grid, contact_.pair);
  Temperature heat(physics_, contact_, speed);
  fields_.temperature = heat.values;
  for (int step = 0; step < steps; ++step) {
    if (!goOn())
      return std::nullopt;
    const double distance = (step + 1) * grid.dx, time = distance / speed;
    PatchDrive now = drive;
    now.creepage = {sequence_.at(sequence_.creep, time, drive.creepage.xi),
                    sequence_.at(sequence_.lateral, time, drive.creepage.eta),
                    sequence_.at(sequence_.spin, time, drive.creepage.phi)};
    if (step == 0) {
      PatchDrive first = drive;
      first.creepage = {sequence_.at(sequence_.creep, 0.0, drive.creepage.xi),
                        sequence_.at(sequence_.lateral, 0.0, drive.creepage.eta),
                        sequence_.at(sequence_.spin, 0.0, drive.creepage.phi)};
      begin(transient, speed, first);
    }
    const double load = sequence_.at(sequence_.load, time, contact_.load);
    Creepage travel = now.creepage; // those that are not known: of the step before
    if (drive.forceX)
      travel.xi = creepage_.xi;
    if (drive.forceY)
      travel.eta = creepage_.eta;
    press(step + 1, load, distance, travel);
    series_.push_back(roll(transient, heat, speed, now, distance, load));
    hottest_ = std::max(hottest_, heat.values.maxCoeff());
    if ((step + 1) % passSteps_ == 0) {
      const ThermalModel model = physics_.thermal.model;
      if (model == ThermalModel::Averaged || model == ThermalModel::AveragedPower)
        heat.values.setConstant(meanTemperatureRise(heat.ratio / passSteps_, contact_.hertz,
                                                    heat.slidingSpeed / passSteps_, speed,
                                                    physics_.thermal.material));
      heat.ratio = heat.slidingSpeed = 0.0;
    }
  }
  return pointOf(speed);
}

PatchPoint MovingPatch::pointOf(double speed) const
{
  // a sequence has no steady part: its last step stands for it
  const std::size_t counted = sequence_.any() ? 1 : series_.size() - series_.size() / 2;
  const auto column = [&](auto value) {
    std::vector<double> values;
    for (std::size_t k = series_.size() - counted; k < series_.size(); ++k)
      values.push_back(value(series_[k]));
    return values;
  };
  const auto mean = [&](double PatchStep::*member) {
    return meanOf(column([&](const PatchStep &s) { return s.*member; }));
  };
  const int batches = static_cast<int>(counted) / passSteps_;
  const auto error = [&](double PatchStep::*member) {
    return batchError(column([&](const PatchStep &s) { return s.*member; }), batches);
  };
  PatchPoint point;
  point.surface = contact_.surface.number;
  point.load = mean(&PatchStep::load);
  point.speed = speed;
  point.creepage = {meanOf(column([](const PatchStep &s) { return s.creepage.xi; })),
                    meanOf(column([](const PatchStep &s) { return s.creepage.eta; })),
                    meanOf(column([](const PatchStep &s) { return s.creepage.phi; }))};
  point.forceX = mean(&PatchStep::forceX);
  point.forceY = mean(&PatchStep::forceY);
  point.momentZ = mean(&PatchStep::momentZ);
  point.muMean = mean(&PatchStep::muMean);
  point.temperatureRise = mean(&PatchStep::temperatureRise);
  point.temperatureMaximum = physics_.thermal.model == ThermalModel::Local
                                 ? hottest_
                                 : maximumOverMeanTemperature() / meanOverEllipse() * hottest_;
  point.iterations = static_cast<int>(series_.size());
  point.products = products_;
  point.stickFraction = mean(&PatchStep::stickFraction);
  point.approach = mean(&PatchStep::approach);
  point.peakPressure = mean(&PatchStep::peakPressure);
  point.realArea = mean(&PatchStep::realArea);
  point.frictionalPower = mean(&PatchStep::frictionalPower);
  const double driving = -speed * meanOf(column([](const PatchStep &s) {
    return s.creepage.xi * s.forceX + s.creepage.eta * s.forceY + s.creepage.phi * s.momentZ;
  }));
  point.powerClosure = driving == 0.0 ? 1.0 : point.frictionalPower / driving;
  point.errorX = error(&PatchStep::forceX);
  point.errorY = error(&PatchStep::forceY);
  point.errorZ = error(&PatchStep::momentZ);
  return point;
}

} // namespace wheelrail
