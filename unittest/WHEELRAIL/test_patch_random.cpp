// SPDX-License-Identifier: GPL-2.0-or-later
// Random cases over the whole range of what a user may ask: they converge, whatever the roughness,
// the share of the area in contact, Poisson's ratio, the friction, the creepages, the hardness
// limit and the friction's scatter from cell to cell are. (290 were run in development.)
#include "base/errors.h"
#include "contact/patch/solvers/transient.h"
#include "patch_cases.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace wheelrail;
using namespace patch_cases;
using Vector = Eigen::VectorXd;

namespace {

struct RandomCase {
  explicit RandomCase(unsigned seed) : random(seed) {}
  std::mt19937 random;
  double uniform() { return random() / 4294967296.0; }
  double between(double low, double high) { return low * std::pow(high / low, uniform()); }
  int whole(int low, int high) { return low + static_cast<int>(uniform() * (high - low)); }
};

struct RollingContact {
  ElasticPair pair;
  PatchGrid grid;
  Vector bound;
  double mu, load;
};

RollingContact randomContact(RandomCase &draw, unsigned seed)
{
  RollingContact c;
  c.pair = {1.0, 0.5 * draw.uniform()};
  const double a = draw.between(0.5, 2.0), b = 1.0 / a;
  const HertzEllipse h = hertzEllipseOfAxes(0.01, 1.0 / (1.0 - c.pair.nu), a, b);
  c.grid = centredGrid(draw.whole(24, 60), draw.whole(24, 60), 3.4 * a, 3.4 * b);
  const double slope = draw.uniform() < 0.3 ? 0.0 : draw.between(1e-3, 0.1);
  const double shortest = 8.0 * std::max(c.grid.dx, c.grid.dy);
  NormalContactProblem problem;
  problem.profile = sampled(c.grid, [&](double x, double y) { return h.gap(x, y); }) +
                    waves(c.grid, slope, shortest, std::max(1.5 * shortest, 2.0), seed);
  c.load = draw.between(0.01, 0.7) * h.load;
  problem.load = c.load / c.grid.cellArea();
  if (draw.uniform() < 0.4)
    problem.pressureLimit =
        (1.5 + 5.0 * draw.uniform()) * h.hertzPressure * std::cbrt(c.load / h.load);
  PatchHalfSpace space(c.grid, c.pair);
  c.mu = draw.between(0.03, 3.0);
  c.bound = c.mu * solveNormalContact(space, problem).pressure;
  if (draw.uniform() < 0.3)
    for (int i = 0; i < c.bound.size(); ++i)
      c.bound[i] *= 0.3 + 0.7 * draw.uniform();
  return c;
}

double fieldNorm(const TangentialField &field)
{
  return std::hypot(field.x.norm(), field.y.norm());
}

/// Length of the slip that the creepages alone make on the cells in contact. Where cells stick, the
/// solver leaves a slip of at most its tolerance times this norm, which against the traction makes
/// a power of either sign.
double rigidSlipNorm(const RollingContact &c, const Creepage &creepage)
{
  TangentialField slip{Vector::Zero(c.grid.cells()), Vector::Zero(c.grid.cells())};
  for (int i = 0; i < c.grid.cells(); ++i)
    if (c.bound[i] > 0.0) {
      slip.x[i] = creepage.xi - creepage.phi * c.grid.y(i / c.grid.nx);
      slip.y[i] = creepage.eta + creepage.phi * (c.grid.x(i % c.grid.nx) + 0.5 * c.grid.dx);
    }
  return fieldNorm(slip);
}

} // namespace

TEST(PatchRandom, Converges)
{
  int refused = 0;
  // 161: four cells that all stick under much spin; 241, 244: forces that jump by 80 % of what
  // friction carries
  std::vector<unsigned> seeds{161, 241, 244};
  for (unsigned seed = 1; seed <= 24; ++seed)
    seeds.push_back(seed);
  for (const unsigned seed : seeds) {
    RandomCase draw(seed);
    const RollingContact c = randomContact(draw, seed);
    const double creep = c.mu * c.load / c.pair.G * draw.between(1e-3, 10.0);
    const double direction = 6.28 * draw.uniform();
    const double spin = draw.uniform() < 0.5 ? 0.0 : draw.between(0.1, 10.0);
    const Creepage creepage{creep * std::cos(direction), creep * std::sin(direction), spin * creep};
    const double capacity = c.bound.sum() * c.grid.cellArea();
    SCOPED_TRACE(seed);
    try {
      TangentialProblem steady;
      steady.bound = c.bound;
      steady.creepage = creepage;
      TangentialSolver solver(c.grid, c.pair);
      const TangentialResult frozen = solver.solve(steady);
      const PatchSums sums = patchSums(c.grid, frozen);
      EXPECT_GE(sums.frictionalPower, -TangentialOptions().tolerance * fieldNorm(frozen.traction) *
                                          rigidSlipNorm(c, creepage) * c.grid.cellArea());
      EXPECT_LT(frozen.products, 120);
      const double share = std::hypot(sums.forceX, sums.forceY) / capacity;
      if (share < 0.99) { // beyond, the force hardly depends on the creepage
        steady.forceX = sums.forceX;
        steady.forceY = sums.forceY;
        steady.creepage.xi = steady.creepage.eta = 0.0;
        const TangentialResult driven = solver.solve(steady);
        EXPECT_NEAR(driven.creepage.xi, creepage.xi, 1e-3 * creep * (1.0 + spin));
        EXPECT_NEAR(driven.creepage.eta, creepage.eta, 1e-3 * creep * (1.0 + spin));
      }
      TransientPatch patch(c.grid, c.pair);
      TransientPatch::Step step;
      step.bound = c.bound;
      step.creepage = creepage;
      for (int i = 0; i < 6; ++i) {
        step.cells = 1 + draw.whole(0, 3);
        EXPECT_LT(patch.step(step).newtonSteps, 80);
      }
      step.forceX = 1.6 * capacity * (draw.uniform() - 0.5);
      step.forceY = 0.8 * capacity * (draw.uniform() - 0.5);
      step.creepage = {};
      for (int i = 0; i < 3; ++i) {
        const TangentialResult driven = patch.step(step);
        EXPECT_NEAR(patchSums(c.grid, driven).forceX, *step.forceX, 1e-5 * capacity);
        step.creepage = driven.creepage;
      }
    } catch (const Error &error) {
      EXPECT_EQ(error.code(), ExitCode::BadInput) << error.what(); // a box too small, said so
      ++refused;
    }
  }
  EXPECT_LT(refused, 6);
}
