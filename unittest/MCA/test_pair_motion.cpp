// SPDX-License-Identifier: GPL-2.0-or-later
// The shear of a pair in space against rotations by Eigen, and against the plane's law.
#include "laws/elasticity.h"
#include "laws/pair_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

using namespace mca;

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector of(const Vector3d &v)
{
  return {v.x(), v.y(), v.z()};
}

Vector3d of(const Vector &v)
{
  return {v.x, v.y, v.z};
}

struct Pair {
  Vector3d distance, shear;

  /// Moves to a new distance while the material turns by phi.
  void move(const Vector3d &there, const Vector3d &phi)
  {
    const PairMotion m =
        pairMotion(of(there), 1 / there.norm(), of(Vector3d(there - distance)), of(phi));
    shear = of(carriedShear(m, of(shear)) + shearGrowth(m));
    distance = there;
  }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double size) { return std::uniform_real_distribution<>(-size, size)(engine_); }
  Vector3d vector(double size) { return {number(size), number(size), number(size)}; }
  Vector3d direction() { return vector(1).normalized(); }

 private:
  std::mt19937 engine_;
};

} // namespace

TEST(PairMotion, GibbsVectorIsTheTangentOfHalfTheAngle)
{
  Random random(1);
  for (int k = 0; k < 100; k++) {
    const Vector3d phi = random.vector(0.017);
    const Vector3d exact = std::tan(0.5 * phi.norm()) * phi.normalized();
    EXPECT_LT((of(gibbsVector(of(phi))) - exact).norm(), 1e-12 * exact.norm());
  }
}

TEST(PairMotion, EqualsRotationsOfTheTextbook)
{
  Random random(2);
  for (int k = 0; k < 1000; k++) {
    const Vector3d old = 2.5 * random.direction(), there = old + random.vector(0.02);
    const Vector3d n0 = old.normalized(), n = there.normalized(), phi = random.vector(0.01);
    Pair pair{old, n0.cross(random.vector(0.01))};
    const Eigen::Matrix3d turn = AngleAxisd(phi.norm(), phi.normalized()).toRotationMatrix();
    const Vector3d a = turn * n0;
    const Quaterniond swing = Quaterniond::FromTwoVectors(a, n);
    const double angle = std::atan2(a.cross(n).norm(), a.dot(n));
    const Vector3d way = (n * a.dot(n) - a).normalized();
    const Vector3d exact = swing * (turn * pair.shear) + angle * way;
    pair.move(there, phi);
    EXPECT_LT((pair.shear - exact).norm(), 1e-14);
    EXPECT_LT(std::abs(pair.shear.dot(n)), 1e-15);
  }
}

TEST(PairMotion, RigidRotationBy90DegreesAboutAnyAxisLeavesTheShear)
{
  Random random(3);
  const int steps = 1000;
  for (int k = 0; k < 50; k++) {
    const Vector3d axis = random.direction();
    Pair pair{random.number(2.5) * random.direction(), Vector3d::Zero()};
    pair.shear = pair.distance.normalized().cross(random.vector(0.01));
    const Vector3d start = pair.distance, before = pair.shear;
    const double quarter = std::acos(0.0);
    for (int s = 1; s <= steps; s++)
      pair.move(AngleAxisd(quarter * s / steps, axis) * start, quarter / steps * axis);
    const Vector3d turned = AngleAxisd(quarter, axis) * before;
    EXPECT_LT((pair.shear - turned).norm(), 1e-13);
  }
}

TEST(PairMotion, SpinAboutTheAxisTurnsTheShearWithIt)
{
  Pair pair{{0, 0, 2.5}, {0.01, 0, 0}};
  const int steps = 300;
  for (int s = 0; s < steps; s++)
    pair.move(pair.distance, {0, 0, std::acos(0.0) / steps});
  EXPECT_LT((pair.shear - Vector3d(0, 0.01, 0)).norm(), 1e-15);
}

TEST(PairMotion, IsThePlanesLawInAPlane)
{
  Random random(4);
  for (int k = 0; k < 100; k++) {
    const double alpha = random.number(3), turn = random.number(0.01), phi = random.number(0.01);
    const double r0 = 2.5 + random.number(0.02), r = 2.5 + random.number(0.02);
    auto at = [](double length, double angle) {
      return Vector3d(length * std::cos(angle), length * std::sin(angle), 0);
    };
    Pair pair{at(r0, alpha), Vector3d::Zero()};
    pair.move(at(r, alpha + turn), {0, 0, phi});
    const double stepN = r - r0 * std::cos(turn), stepT = r0 * std::sin(turn);
    const double growth = shearIncrement(axisRotation(stepT / (r - stepN)), 2 * phi);
    const Vector3d tangent = at(1, alpha + turn + std::acos(0.0));
    EXPECT_LT((pair.shear - growth * tangent).norm(), 1e-15);
  }
}

TEST(PairMotion, SmallMotionKeepsItsDigits)
{
  // a growth of 1e-12 at a distance of 2.5 to 1e-12 of itself
  const Vector3d there(2.5, 1e-12 * 2.5, -2e-12 * 2.5), step(0, 1e-12 * 2.5, -2e-12 * 2.5);
  const PairMotion m = pairMotion(of(there), 1 / there.norm(), of(step), of(Vector3d(0, 0, 4e-13)));
  const Vector growth = shearGrowth(m);
  EXPECT_NEAR(growth.y, 0.6e-12, 1e-24);
  EXPECT_NEAR(growth.z, -2e-12, 1e-24);
}

TEST(PairMotion, RestLeavesTheShearBitwise)
{
  const Vector gamma = {0.1, 0.2, 0.3}, n = {0.6, 0.8, 0.0}, zero = {0, 0, 0};
  const PairMotion m = pairMotion(n, 1.0, zero, zero);
  const Vector after = carriedShear(m, gamma) + shearGrowth(m);
  EXPECT_EQ(after.x, gamma.x);
  EXPECT_EQ(after.y, gamma.y);
  EXPECT_EQ(after.z, gamma.z);
}

TEST(PairMotion, ExchangeTurnsTheShearRound)
{
  Random random(5);
  const Vector3d old = 2.5 * random.direction(), there = old + random.vector(0.02);
  const Vector3d shear = old.cross(random.vector(0.004)), phi = random.vector(0.01);
  Pair pair{old, shear}, turned{-old, -shear};
  pair.move(there, phi);
  turned.move(-there, phi);
  EXPECT_EQ((pair.shear + turned.shear).norm(), 0.0);
}
