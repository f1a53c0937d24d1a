// SPDX-License-Identifier: GPL-2.0-or-later
// Speed of rolling contact in three dimensions, one thread:
//   wr_patch_benchmark --benchmark_repetitions=5 --benchmark_out=patch.json
// CPU time of a rough circular contact, nu .3, waves of a/4 to a, n x n cells over 1.7 x 2a:
//   steady/n      a creep 10 % above that of the tractions it starts from
//   steadyCold/n  the same without a start
//   transient/n   a step of moving roughness: normal contact, then traction
//   smooth/n      as steady, a Hertzian circle over 1.1 x 2a
//   wheel/n       a wheel's ellipse, n x 0.92 n cells over 1.1 x its axes, creep 1.2e-3, from
//                 nothing: influence of the cells, normal contact, traction
//   normal/n      pressure of a Hertzian circle over 1.1 x 2a, from nothing
//   normalRough/n that of the rough circle
//   force/n       a ball's shift under 0.657 mu N that rolls on under this force, 1.65 n steps of a
//                 cell, as CONTACT's example catt_to_cart, which has 34 cells a side
#include "contact/normal_contact.h"
#include "contact/patch/elasticity/hertz_ellipse.h"
#include "contact/patch/elasticity/patch_half_space.h"
#include "contact/patch/solvers/transient.h"
#include "contact/patch/surfaces/patch_surface.h"

#include <benchmark/benchmark.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {

constexpr double mu = 0.3, load = 0.01;
const ElasticPair pair{1.0, 0.3};
const double creepUnit = mu * load / pair.G;

struct RoughContact {
  explicit RoughContact(int n)
      : grid(centredGrid(n, n, 3.4, 3.4)), space(grid, pair),
        hertz(hertzEllipseOfAxes(load, pair.G / (1.0 - pair.nu), 1.0, 1.0)), heights(surface())
  {
  }
  static FractalPatch surface()
  {
    FractalPatch s;
    s.rmsSlope = 0.01;
    s.wavelengthMin = 0.25;
    s.wavelengthMax = 1.0;
    s.periodX = s.periodY = 4.0;
    return s;
  }
  /// Contact after the roughness has travelled by so many cells.
  void press(int travelled)
  {
    NormalContactProblem problem;
    problem.load = load / grid.cellArea();
    problem.profile = sampled(grid, [&](double x, double y) { return hertz.gap(x, y); }) -
                      heights.sampled(grid, travelled * grid.dx);
    NormalContactOptions options;
    if (pressure.size() > 0)
      options.start = shifted(grid, pressure, 1);
    pressure = solveNormalContact(space, problem, options).pressure;
  }

  PatchGrid grid;
  PatchHalfSpace space;
  HertzEllipse hertz;
  FractalHeights heights;
  Vector pressure;
};

void steady(benchmark::State &state, const PatchGrid &grid, const Vector &bound, bool warm)
{
  TangentialSolver solver(grid, pair);
  TangentialProblem problem;
  problem.bound = bound;
  problem.creepage.xi = 0.2 * creepUnit;
  TangentialOptions options;
  options.start = solver.solve(problem).traction;
  problem.creepage.xi *= 1.1;
  if (!warm)
    options.start = {};
  TangentialResult result;
  for (auto _ : state)
    result = solver.solve(problem, options);
  state.counters["products"] = result.products;
  state.counters["steps"] = result.newtonSteps;
  state.counters["cells"] = result.stickCells() + result.slipCells();
}

void steady(benchmark::State &state)
{
  RoughContact contact(static_cast<int>(state.range(0)));
  contact.press(0);
  steady(state, contact.grid, mu * contact.pressure, true);
}

void steadyCold(benchmark::State &state)
{
  RoughContact contact(static_cast<int>(state.range(0)));
  contact.press(0);
  steady(state, contact.grid, mu * contact.pressure, false);
}

void smooth(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  const PatchGrid grid = centredGrid(n, n, 2.2, 2.2);
  const HertzEllipse hertz = hertzEllipseOfAxes(load, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  steady(state, grid, sampled(grid, [&](double x, double y) { return mu * hertz.pressure(x, y); }),
         true);
}

void transient(benchmark::State &state)
{
  RoughContact contact(static_cast<int>(state.range(0)));
  contact.press(0);
  TangentialProblem frozen;
  frozen.bound = mu * contact.pressure;
  frozen.creepage.xi = 0.2 * creepUnit;
  TransientPatch patch(contact.grid, pair);
  patch.startFrom(TangentialSolver(contact.grid, pair).solve(frozen).traction);
  TransientPatch::Step step;
  step.creepage = frozen.creepage;
  int travelled = 0, products = 0;
  for (auto _ : state) {
    contact.press(++travelled);
    step.bound = mu * contact.pressure;
    products += patch.step(step).products;
  }
  state.counters["products"] = double(products) / travelled;
}

void normal(benchmark::State &state)
{
  const int n = static_cast<int>(state.range(0));
  const PatchGrid grid = centredGrid(n, n, 2.2, 2.2);
  const HertzEllipse hertz = hertzEllipseOfAxes(load, pair.G / (1.0 - pair.nu), 1.0, 1.0);
  PatchHalfSpace space(grid, pair);
  NormalContactProblem problem;
  problem.profile = sampled(grid, [&](double x, double y) { return hertz.gap(x, y); });
  problem.load = load / grid.cellArea();
  NormalContactResult result;
  for (auto _ : state)
    result = solveNormalContact(space, problem);
  state.counters["iterations"] = result.iterations;
  state.counters["cells"] = result.contactCells();
}

void normalRough(benchmark::State &state)
{
  RoughContact contact(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    contact.pressure.resize(0);
    contact.press(0);
  }
  state.counters["cells"] = static_cast<double>((contact.pressure.array() > 0.0).count());
}

/// The case of unittest/WHEELRAIL/test_patch_cases.cpp, on n x n cells.
void force(benchmark::State &state)
{
  const ElasticPair soft{1.0, 0.28};
  const double friction = 0.4013, ballLoad = 0.4705, curvature = 0.002963;
  const int n = static_cast<int>(state.range(0)), steps = n * 56 / 34;
  const PatchGrid grid = centredGrid(n, n, 8.5, 8.5);
  PatchHalfSpace space(grid, soft);
  NormalContactProblem problem;
  problem.profile = sampled(grid, [&](double x, double y) { return curvature * (x * x + y * y); });
  problem.load = ballLoad / grid.cellArea();
  const Vector bound = friction * solveNormalContact(space, problem).pressure;
  int products = 0;
  for (auto _ : state) {
    TransientPatch patch(grid, soft);
    TransientPatch::Step step;
    step.bound = bound;
    step.cells = 0;
    step.forceX = -0.657 * friction * ballLoad;
    step.forceY = 0.0;
    products = 0;
    for (int i = 0; i <= steps; ++i) {
      const TangentialResult result = patch.step(step);
      products += result.products;
      step.creepage = result.creepage;
      step.cells = 1;
    }
  }
  state.counters["products"] = double(products) / (steps + 1);
  state.counters["steps"] = steps;
}

/// The case of unittest/WHEELRAIL/test_patch_cases.cpp whose curve CONTACT publishes.
void wheel(benchmark::State &state)
{
  const ElasticPair steel{82000.0, 0.28};
  const double friction = 0.33, force = 106700.0, A = 0.8e-3;
  const HertzEllipse hertz =
      hertzEllipse(force, steel.G / (1.0 - steel.nu), {A, A / curvatureRatio(0.5)});
  const int nx = static_cast<int>(state.range(0));
  const PatchGrid grid = centredGrid(nx, nx * 11 / 12, 2.2 * hertz.a, 2.2 * hertz.b);
  TangentialResult result;
  for (auto _ : state) {
    PatchHalfSpace space(grid, steel);
    NormalContactProblem normal;
    normal.profile = sampled(grid, [&](double x, double y) { return hertz.gap(x, y); });
    normal.load = force / grid.cellArea();
    TangentialProblem problem;
    problem.bound = friction * solveNormalContact(space, normal).pressure;
    problem.creepage.xi = 1.2e-3;
    result = TangentialSolver(grid, steel).solve(problem);
  }
  state.counters["products"] = result.products;
  state.counters["cells"] = result.stickCells() + result.slipCells();
}

} // namespace

BENCHMARK(steady)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(steadyCold)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(smooth)->Arg(128)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(transient)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(wheel)->Arg(292)->Unit(benchmark::kMillisecond);
BENCHMARK(normal)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(normalRough)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(force)->Arg(35)->Arg(137)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
