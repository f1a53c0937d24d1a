// SPDX-License-Identifier: GPL-2.0-or-later
// Surfaces that travel through the contact and turn on their way, against particles that are
// followed one by one; what the means of mode moving leave out.
#include "contact/patch/surfaces/rough_patch.h"
#include "creep/patch/moving_patch.h"
#include "shared/pi.h"

#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {

using mcawr::pi;

/// Heights that are known everywhere; they repeat after 4 x 3 with at least 16 cells a wave.
double height(double x, double y)
{
  const double kx = 2.0 * pi / 4.0, ky = 2.0 * pi / 3.0;
  return std::cos(3.0 * kx * x + 2.0 * ky * y) + 0.7 * std::sin(kx * x - 3.0 * ky * y) +
         0.5 * std::cos(4.0 * kx * x + 0.3);
}

const PatchGrid box = centredGrid(64, 48, 4.0, 3.0);

RoughMap mapOf()
{
  RoughMap map;
  map.nx = box.nx;
  map.ny = box.ny;
  map.height = sampled(box, height);
  return map;
}

/// One body's rigid motion in the contact: velocity relative to that of rolling.
struct Motion {
  double xi, eta;
  double phi; ///< of this body; it may change in time
  double wave;
  double spin(double rolled) const { return phi * (1.0 + wave * std::cos(1.7 * rolled)); }
};

struct Place {
  double x, y;
};

/// Where a particle was a way earlier: the exact velocity field, Runge and Kutta's rule of order 4.
Place before(Place p, const Motion &m, double rolled, double way, int steps)
{
  const auto velocity = [&](Place at, double when) {
    const double c = m.spin(when);
    return Place{-1.0 + m.xi - c * at.y, m.eta + c * at.x};
  };
  const double h = -way / steps;
  for (int k = 0; k < steps; ++k, rolled += h) {
    const Place a = velocity(p, rolled);
    const Place b = velocity({p.x + 0.5 * h * a.x, p.y + 0.5 * h * a.y}, rolled + 0.5 * h);
    const Place c = velocity({p.x + 0.5 * h * b.x, p.y + 0.5 * h * b.y}, rolled + 0.5 * h);
    const Place d = velocity({p.x + h * c.x, p.y + h * c.y}, rolled + h);
    p.x += h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x);
    p.y += h / 6.0 * (a.y + 2.0 * b.y + 2.0 * c.y + d.y);
  }
  return p;
}

/// Largest differences between the window and the heights of the particles that lie at the cells'
/// centres: with the turn, and without it.
struct Difference {
  double turned, straight;
};

Difference difference(const Motion &m, int steps)
{
  const RoughMap map = mapOf();
  Travel travel, straight;
  for (int step = 0; step < steps; ++step) {
    const double middle = (step + 0.5) * box.dx;
    travel.roll(box, box.dx * (1.0 - m.xi), -box.dx * m.eta, m.spin(middle));
    straight.roll(box, box.dx * (1.0 - m.xi), -box.dx * m.eta, 0.0);
  }
  const Vector heights = map.window(box, travel), plain = map.window(box, straight);
  Difference worst{0.0, 0.0};
  const double rolled = steps * box.dx;
  for (int ix = 0; ix < box.nx; ++ix)
    for (int iy = 0; iy < box.ny; ++iy) {
      // in the box since the start, or since the particle was in its last column
      const int inside = std::min(steps, box.nx - 1 - ix);
      const double way = inside * box.dx;
      const Place start = inside == 0 ? Place{box.x(ix), box.y(iy)}
                                      : before({box.x(ix), box.y(iy)}, m, rolled, way, 4 * inside);
      const double earlier = rolled - way;
      const double exact = height(start.x + earlier * (1.0 - m.xi), start.y - earlier * m.eta);
      const int i = box.index(ix, iy);
      worst.turned = std::max(worst.turned, std::abs(heights[i] - exact));
      worst.straight = std::max(worst.straight, std::abs(plain[i] - exact));
    }
  return worst;
}

} // namespace

TEST(PatchTravel, SpinTurnsTheMaterialOnItsWay)
{
  for (const int steps : {7, 100}) // soon after the start, and when all has come in since
    for (const double wave : {0.0, 0.6}) {
      // errors of the second order: a quarter at half of the creepages
      const Difference large = difference({0.004, -0.003, 0.02, wave}, steps);
      const Difference small = difference({0.002, -0.0015, 0.01, wave}, steps);
      EXPECT_GT(large.straight, 10.0 * large.turned);
      EXPECT_NEAR(small.straight, 0.5 * large.straight, 0.1 * large.straight);
      EXPECT_LT(small.turned, 0.3 * large.turned + 2e-4); // and what the interpolation leaves
    }
}

TEST(PatchTravel, WithoutSpinNothingTurns)
{
  const RoughMap map = mapOf();
  Travel travel;
  for (int step = 0; step < 5; ++step)
    travel.roll(box, box.dx, 0.0, 0.0);
  EXPECT_EQ(travel.turn.size(), 0);
  const Vector moved = map.window(box, travel);
  for (int iy = 0; iy < box.ny; ++iy)
    for (int ix = 0; ix < box.nx; ++ix)
      ASSERT_EQ(moved[box.index(ix, iy)], map.height[box.index((ix + 5) % box.nx, iy)]);
  // spin of 0 among others: the same code as with spin, the same heights
  travel.turn = travel.aside = Vector::Zero(box.nx);
  EXPECT_LT((map.window(box, travel) - moved).norm(), 1e-12 * moved.norm());
}

TEST(PatchTravel, TurnedMapsEndWhereTheyEnd)
{
  RoughMap map = mapOf();
  map.periodic = false;
  Travel travel;
  travel.turn = travel.aside = Vector::Zero(box.nx);
  EXPECT_EQ(map.window(box, travel), map.height);
  travel.turn[0] = 1e-3; // needs cells beyond the border
  EXPECT_THROW(map.window(box, travel), std::exception);
}

TEST(PatchTravel, PassesThatAreDiscarded)
{
  MovingPatchSpecification moving;
  EXPECT_EQ(moving.discardedPasses(), 2);
  moving.start = RollingStart::Rest;
  EXPECT_EQ(moving.discardedPasses(), 4);
  moving.passes = 6;
  EXPECT_EQ(moving.discardedPasses(), 3);
  moving.start = RollingStart::Steady;
  EXPECT_EQ(moving.discardedPasses(), 2);
  moving.passes = 2;
  EXPECT_EQ(moving.discardedPasses(), 1);
}
