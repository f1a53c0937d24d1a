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
BENCHMARK_MAIN();
