// SPDX-License-Identifier: GPL-2.0-or-later
// The driven layer as a rigid body, the room that it leaves, and the row of the friction log.
#include "core/driven_layer.h"
#include "core/layer_room.h"
#include "files/drive_sums.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

/// Four automata, of which the layer has all but the second.
struct Layer : testing::Test {
  using Vector = double[3];
  Vector v[4] = {{1, 2, 3}, {9, 9, 9}, {-1, 0.5, 0}, {0, -1, 2}};
  Vector f[4] = {{10, -4, 1}, {7, 7, 7}, {-2, 6, 0}, {3, 1, -5}};
  Vector omega[4] = {{1, 1, 1}, {2, 2, 2}, {0, 0, 3}, {4, 0, 0}};
  Vector torque[4] = {{1, 0, 1}, {2, 2, 2}, {0, 5, 3}, {4, 0, 0}};
  double mass[4] = {2, 50, 1, 5};
  mca::DrivenLayer layer;
  mca::DrivenLayer::Arrays arrays{};

  void SetUp() override
  {
    layer.members = {0, 2, 3};
    layer.area = 20;
    layer.mass = 8;
    layer.stressUnit = 3;
    arrays.v = v;
    arrays.f = f;
    arrays.omega = omega;
    arrays.torque = torque;
    arrays.mass = mass;
  }
};

} // namespace

TEST_F(Layer, StressesAreForcesOverTheArea)
{
  const mca::DrivenLayer::Pull pull = layer.pull(arrays);
  EXPECT_EQ(pull.x, 11);
  EXPECT_EQ(pull.y, 3);
  EXPECT_EQ(pull.momentum, 2 * 2 + 0.5 - 5);
  const mca::DrivenLayer::Stress stress = layer.stress(pull);
  EXPECT_DOUBLE_EQ(stress.shear, -11.0 * 3 / 20); // against a motion in +x
  EXPECT_DOUBLE_EQ(stress.normal, 3.0 * 3 / 20);
}

TEST_F(Layer, MovesAsOneBodyUnderAllForcesAndThePressure)
{
  layer.carry(arrays, layer.pull(arrays), {0.25, 6});
  const double weight = 6 * 20.0 / 3;
  double force = 0, momentum = 0;
  for (const int i : layer.members) {
    EXPECT_EQ(v[i][0], 0.25);
    EXPECT_EQ(v[i][1], v[0][1]);
    EXPECT_DOUBLE_EQ(f[i][1] / mass[i], (3 - weight) / 8); // one acceleration
    EXPECT_EQ(f[i][0], 0);
    for (const double value : {f[i][2], v[i][2], omega[i][0], omega[i][2], torque[i][1]})
      EXPECT_EQ(value, 0);
    force += f[i][1];
    momentum += mass[i] * v[i][1];
  }
  EXPECT_DOUBLE_EQ(force, 3 - weight);
  EXPECT_DOUBLE_EQ(momentum, -0.5);
  for (const Vector *untouched : {v, omega, torque, f})
    EXPECT_EQ(untouched[1][0], untouched[1][1]);
  EXPECT_EQ(v[1][1], 9);
}

TEST_F(Layer, PartsOfTwoRanksMakeTheWhole)
{
  mca::DrivenLayer a = layer, b = layer;
  a.members = {0};
  b.members = {2, 3};
  const mca::DrivenLayer::Pull of = a.pull(arrays), with = b.pull(arrays);
  const mca::DrivenLayer::Pull all = {of.x + with.x, of.y + with.y, of.momentum + with.momentum};
  EXPECT_DOUBLE_EQ(layer.stress(all).shear, a.stress(of).shear + b.stress(with).shear);
  a.carry(arrays, all, {0.25, 6});
  b.carry(arrays, all, {0.25, 6});
  EXPECT_EQ(v[0][1], v[3][1]);
  EXPECT_DOUBLE_EQ(v[0][1], -0.5 / 8);
}

TEST_F(Layer, ARowIsTheMeanOfItsStepsInUnitsOfTheLog)
{
  mca::DriveSums sums;
  sums.startHeight = 2e-9;
  sums.brokenBefore = 5;
  for (const double shear : {1e6, 2e6, 6e6})
    sums.add(layer, {shear, 2 * shear}, 5.0, 1e-12);
  EXPECT_DOUBLE_EQ(sums.displacement, 3 * 5e-12);
  EXPECT_DOUBLE_EQ(sums.work, 9e6 * 20 / 3 * 5e-12); // force times way
  mca::DriveSums::Totals all;
  all.links = 100;
  all.broken = 7;
  all.formed = 2;
  all.shearSum = sums.shearSum;
  all.normalSum = sums.normalSum;
  mca::DriveSums::State now;
  now.height = 2.5e-9;
  now.room = 0.98;
  now.lost = 2;
  now.dissipated = {3e-15, 4e-15, 5e-15}; // Pa m3
  const mca::Units si = *mca::findUnits("si");
  const mca::LogRow row = sums.row(all, now, 40, 1e-12, 15e6, si);
  EXPECT_EQ(row.step, 40);
  EXPECT_DOUBLE_EQ(row.time, 0.04);
  EXPECT_DOUBLE_EQ(row.displacement, 0.015);
  EXPECT_DOUBLE_EQ(row.shearStress, 3);
  EXPECT_DOUBLE_EQ(row.normalStress, 6);
  EXPECT_DOUBLE_EQ(row.mu, 0.2);
  EXPECT_EQ(row.links, 100);
  EXPECT_EQ(row.broken, 2);
  EXPECT_EQ(row.formed, 2);
  EXPECT_NEAR(row.gap, 0.5, 1e-12);
  EXPECT_EQ(row.room, 0.98);
  EXPECT_EQ(row.lost, 2);
  EXPECT_NEAR(row.flowEnergy, 3e6, 1e-6);
  EXPECT_NEAR(row.breakingEnergy, 4e6, 1e-6);
  EXPECT_NEAR(row.contactEnergy, 5e6, 1e-6);
  EXPECT_EQ(sums.row(all, now, 40, 1e-12, 0.0, si).mu, 0);

  sums.beginRow(all);
  EXPECT_EQ(sums.samples, 0);
  EXPECT_EQ(sums.shearSum, 0);
  EXPECT_EQ(sums.row(all, now, 80, 1e-12, 15e6, si).broken, 0); // since this row
  EXPECT_DOUBLE_EQ(sums.displacement, 3 * 5e-12);
}

TEST_F(Layer, OneRankGoesOnWithThePartsOfAll)
{
  mca::DriveSums::Totals all;
  all.work = 3;
  all.shearSum = 4;
  all.normalSum = 5;
  mca::DriveSums first, other;
  first.work = 1;
  other.work = 2;
  first.gather(all, true);
  other.gather(all, false);
  EXPECT_EQ(first.work + other.work, 3);
  EXPECT_EQ(first.shearSum + other.shearSum, 4);
  EXPECT_EQ(first.normalSum + other.normalSum, 5);
}

namespace {

/// Rows of a column of automata that are `step` apart, three held, six free, three driven.
struct Column {
  double step = 2.0;
  mca::RigidLayers layers;
  mca::LayerContents contents;

  static mca::Part partOf(int row)
  {
    return row < 3 ? mca::Part::Held : row < 9 ? mca::Part::Free : mca::Part::Driven;
  }
  void fill(double lift = 0.0)
  {
    const auto y = [&](int row) { return step * row + (row < 9 ? 0.0 : lift); };
    for (int row = 0; row < 12; row++)
      layers.add(partOf(row), y(row));
    for (int row = 0; row < 12; row++)
      contents.add(layers, partOf(row), y(row), 8.0, 2.0);
  }
};

} // namespace

TEST(LayerRoom, IsOneInTheSolidAndGoesWithTheHeightBetweenTheInnermostRows)
{
  Column solid;
  solid.fill();
  EXPECT_DOUBLE_EQ(solid.contents.cells, 7 * 8.0); // six free, and half of one row on either side
  EXPECT_DOUBLE_EQ(mca::roomOf(solid.layers, solid.contents, 4.0), 1.0);
  Column pressed;
  pressed.fill(-0.7);
  EXPECT_DOUBLE_EQ(mca::roomOf(pressed.layers, pressed.contents, 4.0), (14 - 0.7) / 14);
}

TEST(LayerRoom, CountsThoseThatAreBetweenAndThoseThatLeft)
{
  Column column;
  column.fill();
  column.contents.add(column.layers, mca::Part::Free, 22.1, 8.0, 2.0);
  column.contents.add(column.layers, mca::Part::Free, -0.1, 8.0, 2.0);
  column.contents.add(column.layers, mca::Part::Free, -0.2, 8.0, 2.0);
  column.contents.add(column.layers, mca::Part::Free, 3.0, 8.0, 2.0); // among the held rows
  EXPECT_EQ(column.contents.above, 1);
  EXPECT_EQ(column.contents.below, 2);
  EXPECT_DOUBLE_EQ(column.contents.cells, 7 * 8.0);
}

TEST(LayerRoom, IsNotKnownWhereNothingIsHeld)
{
  mca::RigidLayers layers;
  layers.add(mca::Part::Driven, 5.0);
  mca::LayerContents contents;
  contents.add(layers, mca::Part::Free, 1.0, 8.0, 2.0);
  EXPECT_FALSE(layers.areApart());
  EXPECT_EQ(mca::roomOf(layers, contents, 4.0), 0.0);
  EXPECT_EQ(contents.below, 0);
}
