// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/moving_patch.h"

#include "base/errors.h"
#include "contact/patch/solvers/patch_sums.h"

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

// Neighbouring steps are alike, means of whole passes much less so: their scatter over
// sqrt(batches) is the error of the mean without a model of the correlation. Few batches make a
// rough error: n of them know it to 1/sqrt(2 (n - 1)), and Student's t takes the place of 1.96.
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

int MovingPatchSpecification::discardedPasses() const
{
  return std::min(start == RollingStart::Steady ? 2 : 4, passes / 2);
}

double rolledDistance(const MovingPatchSpecification &moving, const PatchSequence &sequence,
                      const HertzEllipse &hertz, double speed)
{
  return sequence.any() ? sequence.distanceAt(sequence.time.back(), speed)
                        : moving.passes * 2.0 * hertz.a;
}

/// Temperature per cell: one for the contact from the mean of the pass before, or rows of material
/// that remember the heat of their way.
struct MovingPatch::Temperature {
  Temperature(const CreepPhysics &physics, const PatchContact &contact, double speed)
      : values(Vector::Constant(contact.grid.cells(), physics.thermal.bulk)),
        bulk(physics.thermal.bulk)
  {
    if (physics.thermal.model == ThermalModel::Local)
      rows.assign(contact.grid.ny, TravellingHeat(contact.grid.nx, contact.grid.dx, speed,
                                                  physics.thermal.material));
  }

  /// As after rolling for long with the heat of a steady state.
  void startFrom(const PatchContact &contact, const PatchFields &steady, double speed)
  {
    values = steady.temperature;
    if (rows.empty())
      return;
    TangentialResult rolling;
    rolling.traction = steady.traction;
    rolling.slip = steady.slip;
    const Vector heat = frictionalHeat(rolling, speed);
    for (int k = 0; k < contact.grid.nx; ++k) // all material has gone through the box
      step(contact, heat, steady.pressure);
  }

  void step(const PatchContact &contact, const Vector &heat, const Vector &pressure)
  {
    const PatchGrid &grid = contact.grid;
    for (int iy = 0; iy < static_cast<int>(rows.size()); ++iy) {
      rows[iy].step(heat.segment(grid.index(0, iy), grid.nx));
      for (int ix = 0; ix < grid.nx; ++ix) {
        const int i = grid.index(ix, iy);
        values[i] = bulk + (pressure[i] > 0.0 || contact.isNominal(i) ? rows[iy].rise(ix) : 0.0);
      }
    }
  }

  Vector values; ///< K
  double bulk;   ///< K
  std::vector<TravellingHeat> rows;
  /// Sum over the pass, of Eq. 11; under another load than the contact's times the root of their
  /// ratio, as p0 sqrt(a) of Eq. 11 goes with it.
  double powerOverLoad = 0.0;
};

MovingPatch::MovingPatch(const CreepPhysics &physics, const MovingPatchSpecification &moving,
                         const PatchSequence &sequence, const FrictionLaw &law,
                         const PatchContact &contact, double spinPoint)
    : physics_(physics), moving_(moving), sequence_(sequence), law_(law), contact_(contact),
      spinPoint_(spinPoint), space_(contact.grid, contact.pair),
      coupling_(contact.grid, contact.pair), normal_(contact.normal),
      passSteps_(static_cast<int>(std::ceil(2.0 * contact.hertz.a / stepLength() * (1.0 - 1e-12))))
{
  if (physics.memoryLength > 0.0 && law.dependsOnSpeed())
    memory_.emplace(contact.grid, physics.memoryLength);
}

// How a step of one cell goes (`solve` loops over them). Rough surfaces that travel change the
// contact all the time, so that nothing is steady; what is reported are means over passes, a pass
// being the way of one contact length 2a, and their errors from the scatter of passes
// (`batchError`).
//
//   1. The surfaces travel by a cell, each at its body's speed (`travel`).
//   2. The pressure follows from the new gap (`press`). Its search begins at the pressure of the
//      step before moved by a cell, since asperities take theirs with them.
//   3. The tangential problem of the step is solved (`roll`): the displacement that each particle
//      had before it moved is known, the traction that it has now is not.
//   4. Of unlike bodies 2 and 3 take turns until the pressure settles (`PatchCoupling::settle`).
//   5. The heat of the step goes into the material, which takes it along.
//
// The first passes still remember how the contact began; they are rolled and left out of the means.

void MovingPatch::begin(TransientPatch &transient, Temperature &heat, double speed,
                        const PatchDrive &drive, double load)
{
  creepage_ = drive.creepage;
  if (load != contact_.load)
    press(load, 0.0, normal_.pressure, {});
  const TangentialField none{Vector::Zero(contact_.grid.cells()),
                             Vector::Zero(contact_.grid.cells())};
  imposed_ = coupling_.tangential(normal_.pressure);
  if (moving_.start == RollingStart::Rest) {
    transient.startFrom(none, imposed_); // pressed together without friction
    return;
  }
  if (moving_.start == RollingStart::Steady) {
    PatchContact pressed = contact_;
    if (load != contact_.load)
      pressed.hertz = hertzEllipse(load, contact_.hertz.modulus, contact_.hertz.curvatures);
    pressed.load = load;
    pressed.normal = normal_;
    FrozenPatch steady(physics_, pressed, spinPoint_);
    const PatchPoint point = steady.solve(law_, speed, drive);
    normal_.pressure = steady.fields().pressure;
    memoryRatio_ = steady.memoryRatio();
    imposed_ = coupling_.tangential(normal_.pressure);
    heat.startFrom(pressed, steady.fields(), speed);
    fields_.temperature = heat.values;
    transient.startFrom(steady.fields().traction, imposed_);
    creepage_ = point.creepage;
    products_ += point.products;
    return;
  }
  TransientPatch::Step shift;
  const Vector cold = Vector::Constant(contact_.grid.cells(), physics_.thermal.bulk);
  shift.bound =
      contact_.bound(contact_.across(law_.mu({normal_.pressure, 0.0, cold})), normal_.pressure);
  shift.cells = 0;
  shift.forceX = drive.forceX.value_or(0.0);
  shift.forceY = drive.forceY.value_or(0.0);
  shift.imposed = imposed_;
  products_ += transient.step(shift).products;
}

// Half of the rigid slip (xi - phi y, eta + phi x) is put on each body: the wheel's surface runs
// by xi/2 slower than the contact travels, the rail's by xi/2 faster, and they turn by phi/2
// against each other, so that their asperities pass each other as the slip has it. The mean of both
// goes straight, as the displacements do that are carried along. Between cells `RoughMap::window`
// interpolates the maps.
void MovingPatch::travel(const Creepage &creepage)
{
  const PatchGrid &grid = contact_.grid;
  const double alongX = 0.5 * grid.dx * creepage.xi, alongY = 0.5 * grid.dx * creepage.eta;
  wheel_.roll(grid, grid.dx - alongX, -alongY, 0.5 * creepage.phi);
  rail_.roll(grid, grid.dx + alongX, alongY, -0.5 * creepage.phi);
}

// A smooth contact under a constant load has one pressure; nothing is gained by finding it again at
// each step.
bool MovingPatch::pressureStays(double load) const
{
  const RoughPatch &surface = contact_.surface;
  const double former = normal_.pressure.sum() * contact_.grid.cellArea();
  return surface.wheel.isSmooth() && surface.rail.isSmooth() && !coupling_.any() &&
         std::abs(load - former) <= 1e-12 * load && !physics_.heatLimitsPressure();
}

void MovingPatch::press(double load, double distance, const Vector &start, const Vector &opening)
{
  NormalContactOptions options;
  options.tolerance = pressureTolerance;
  options.start = start;
  const double mean = fields_.temperature.dot(normal_.pressure) / normal_.pressure.sum();
  NormalContactProblem problem =
      contact_.problem(physics_.pressureLimit(law_, mean), load, wheel_, rail_);
  problem.cellLimits = // hot spots travel with the material
      physics_.pressureLimits(law_, shifted(contact_.grid, fields_.temperature, 1));
  if (opening.size() > 0)
    problem.profile += opening;
  try {
    normal_ = solveNormalContact(space_, problem, options);
    checkInsideBox(contact_.grid, normal_.pressure);
  } catch (const Error &error) {
    throw Error(error.code(),
                fmt::format("{} (after {:.4g} mm of rolling)", error.what(), distance * 1e3));
  }
}

// What depends on the traction that is sought is taken from the step before, the temperature and
// the creepages that belong to given forces: one tangential problem a step, where steady rolling
// needs a fixed point. It is one cell late, a cell being a small part of the contact.
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
  step.cells = moving_.stepCells;
  const double sliding = speed * rigidSlip(grid, normal_.pressure, step.creepage);
  if (!heat.rows.empty()) // what the friction coefficient sees is a cell behind
    heat.values = shifted(grid, heat.values, 1, 0, heat.bulk);
  if (memory_) // likewise
    memoryRatio_ = shifted(grid, memoryRatio_, 1, 0, 1.0);
  physics_.checkStrength(law_, heat.values.maxCoeff(), speed, step.creepage.xi);
  Vector mu;
  TangentialOptions options = TransientPatch::defaultOptions();
  const auto slide = [&] {
    mu = contact_.across(memory_ ? SlipMemory::mu(law_, normal_.pressure, heat.values, memoryRatio_)
                                 : law_.mu({normal_.pressure, sliding, heat.values}));
    step.bound = contact_.bound(mu, normal_.pressure);
    step.imposed = coupling_.tangential(normal_.pressure);
    step.edge = contact_.edge(normal_.pressure, normal_.gap);
    TangentialResult tried = transient.attempt(step, options);
    options.start = tried.traction;
    products_ += tried.products + tried.coarseProducts;
    return tried;
  };
  const TangentialResult result =
      coupling_.settle(normal_.pressure, slide, [&](const Vector &opening) {
        press(load, distance, normal_.pressure, opening);
      });
  transient.accept(step, result);
  if (memory_)
    memoryRatio_ = memory_->after(memoryRatio_, law_, normal_.pressure, heat.values, speed,
                                  result.slip.length());
  creepage_ = result.creepage;
  PatchSums sums = patchSums(grid, result);
  sums.drivingPower += couplingPower(grid, result.traction, step.imposed, imposed_);
  imposed_ = step.imposed;
  if (!heat.rows.empty())
    heat.step(contact_, frictionalHeat(result, speed), normal_.pressure);

  PatchStep row;
  const PatchSolution solved{
      contact_,         sums, result,      physics_.wear, load, normal_.approach, result.creepage,
      normal_.pressure, mu,   heat.values, speed};
  const Vector worn = wornRows(solved);
  static_cast<PatchValues &>(row) = patchValues(solved, worn);
  if (worn.size() > 0 && static_cast<int>(series().size()) >= discarded_)
    worn_ += worn;
  row.distance = distance;
  row.drivingPower = sums.drivingPower * speed;
  heat.powerOverLoad += (physics_.thermal.model == ThermalModel::Averaged
                             ? contact_.meanFriction(mu, normal_.pressure) * sliding
                             : row.drivingPower / load) *
                        std::sqrt(load / contact_.load);
  fields_ = {result.state, normal_.gap, normal_.pressure, result.traction,
             result.slip,  mu,          heat.values};
  return row;
}

PatchDrive MovingPatch::driveAt(double time, const PatchDrive &drive) const
{
  PatchDrive now = drive;
  now.creepage = {sequence_.at(sequence_.creep, time, drive.creepage.xi),
                  sequence_.at(sequence_.lateral, time, drive.creepage.eta),
                  sequence_.at(sequence_.spin, time, drive.creepage.phi)};
  if (drive.forceX)
    now.forceX = sequence_.at(sequence_.forceX, time, *drive.forceX);
  if (drive.forceY)
    now.forceY = sequence_.at(sequence_.forceY, time, *drive.forceY);
  return now;
}

int MovingPatch::stepsOf(double speed) const
{
  if (!sequence_.any())
    return moving_.passes * passSteps_;
  const double cells = rolledDistance(moving_, sequence_, contact_.hertz, speed) / stepLength();
  // a wheel that comes to rest never ends a step that begins before it
  const bool stops = !sequence_.speed.empty() && sequence_.lastOf(sequence_.speed) == 0.0;
  return std::max(1, static_cast<int>(stops ? std::floor(cells + 1e-9) : std::lround(cells)));
}

std::optional<PatchPoint> MovingPatch::solve(double speed, const PatchDrive &drive,
                                             const std::function<bool()> &goOn)
{
  const PatchGrid &grid = contact_.grid;
  const int steps = stepsOf(speed), cells = moving_.stepCells;
  history_ = {};
  discarded_ = steps - countedSteps();
  worn_ = Vector::Zero(grid.ny);
  normal_ = contact_.normal;
  wheel_ = rail_ = {};
  products_ = 0;
  hottest_ = physics_.thermal.bulk;
  memoryRatio_ = Vector::Ones(grid.cells());
  TransientPatch transient(grid, contact_.pair);
  Temperature heat(physics_, contact_, speed);
  fields_.temperature = heat.values;
  for (int step = 0; step < steps; ++step) {
    if (!goOn())
      return std::nullopt;
    const double distance = (step + 1) * stepLength(), former = history_.now;
    const double time = sequence_.timeAt(distance, speed);
    if (!sequence_.speed.empty())
      speed = stepLength() / (time - former);
    if (step == 0)
      begin(transient, heat, speed, driveAt(0.0, drive),
            sequence_.at(sequence_.load, 0.0, contact_.load));
    history_.now = time;
    const PatchDrive now = driveAt(time, drive);
    // the load of a sequence changes the pressure, not the grid or the nominal ellipse
    const double load = sequence_.at(sequence_.load, time, contact_.load);
    Creepage creepage = now.creepage; // those that are not known: of the step before
    if (drive.forceX)
      creepage.xi = creepage_.xi;
    if (drive.forceY)
      creepage.eta = creepage_.eta;
    for (int cell = 0; cell < cells; ++cell)
      travel(creepage);
    if (!pressureStays(load)) {
      const bool smooth = contact_.surface.wheel.isSmooth() && contact_.surface.rail.isSmooth();
      press(load, distance, smooth ? normal_.pressure : shifted(grid, normal_.pressure, cells),
            coupling_.normal(transient.traction()));
    }
    PatchStep row = roll(transient, heat, speed, now, distance, load);
    row.time = time;
    row.speed = speed;
    history_.add(row, sequence_.timeAt(distance + stepLength(), speed), sequence_, fields_);
    hottest_ = std::max(hottest_, heat.values.maxCoeff());
    if ((step + 1) % passSteps_ == 0) {
      const ThermalModel model = physics_.thermal.model;
      if (model == ThermalModel::Averaged || model == ThermalModel::AveragedPower)
        heat.values.setConstant(heat.bulk + meanTemperatureRise(heat.powerOverLoad / passSteps_,
                                                                contact_.hertz, speed,
                                                                physics_.thermal.material));
      heat.powerOverLoad = 0.0;
    }
  }
  history_.end(sequence_, fields_);
  return pointOf(speed);
}

// A pass has as many steps as a contact length has cells. A sequence has no steady part.
int MovingPatch::countedSteps() const
{
  return sequence_.any() ? 1 : (moving_.passes - moving_.discardedPasses()) * passSteps_;
}

PatchPoint MovingPatch::pointOf(double speed) const
{
  const int batches = sequence_.any() ? 0 : moving_.passes - moving_.discardedPasses();
  const auto counted = static_cast<std::size_t>(countedSteps());
  const auto column = [&](const auto &value) {
    std::vector<double> values;
    for (std::size_t k = series().size() - counted; k < series().size(); ++k)
      values.push_back(value(series()[k]));
    return values;
  };
  const auto error = [&](double PatchStep::*member) {
    return batchError(column([&](const PatchStep &s) { return s.*member; }), batches);
  };
  PatchPoint point;
  for (const Column<PatchValues> &one : patchValueColumns())
    one.value.set(point, meanOf(column(one.value.get)));
  point.wearDepth = worn_.maxCoeff() / static_cast<double>(counted);
  point.surface = contact_.surface.number;
  point.speed = speed;
  point.temperatureMaximum = largestTemperature(physics_.thermal, hottest_);
  point.iterations = static_cast<int>(series().size());
  point.products = products_;
  const double driving = meanOf(column([](const PatchStep &s) { return s.drivingPower; }));
  point.powerClosure = driving == 0.0 ? 1.0 : point.frictionalPower / driving;
  point.errorX = error(&PatchStep::forceX);
  point.errorY = error(&PatchStep::forceY);
  point.errorZ = error(&PatchStep::momentZ);
  const double sliding = speed * rigidSlip(contact_.grid, fields_.pressure, creepage_);
  point.use = law_.use({fields_.pressure, sliding, fields_.temperature});
  return point;
}

} // namespace wheelrail
