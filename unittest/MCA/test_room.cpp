// SPDX-License-Identifier: GPL-2.0-or-later
// Room of an automaton: what closeness reads of lattices that are sheared at constant volume, the
// force as the gradient of its energy, and the strain that broken links leave.
#include "laws/packing.h"
#include "laws/room.h"
#include "laws/strain.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <random>

using namespace mca;

namespace {

/// Periods of a lattice of one automaton a period, with d = 1, as columns.
Eigen::Matrix3d periods(const Packing &packing)
{
  Eigen::Matrix3d e;
  if (packing.dimension == 2)
    e << 1, 0.5, 0, 0, std::sqrt(3.0) / 2, 0, 0, 0, 100;
  else
    e << 1, 1, 0, 1, 0, 1, 0, 1, 1;
  return packing.dimension == 2 ? e : Eigen::Matrix3d(e / std::sqrt(2.0));
}

struct Reading {
  double nearest; ///< [d]
  double
      closeness; ///< volume strain as the sum of shares reads it, less than 0 where there is room
};

/// What a lattice deformed by F reads.
Reading read(const Packing &packing, const Eigen::Matrix3d &F)
{
  const Eigen::Matrix3d e = F * periods(packing);
  Reading all = {1e9, 0.0};
  double sum = 0.0;
  for (int a = -6; a <= 6; a++)
    for (int b = -6; b <= 6; b++)
      for (int c = packing.dimension == 2 ? 0 : -6; c <= (packing.dimension == 2 ? 0 : 6); c++) {
        if (a == 0 && b == 0 && c == 0)
          continue;
        const double r = (e * Eigen::Vector3d(a, b, c)).norm();
        all.nearest = std::min(all.nearest, r);
        sum += roomTaken(roomShare(r));
      }
  const double K = 1.0, weight = packing.stressWeight();
  // beyond the margin the pressure is K times the closeness less the margin; add packing to get
  // there
  const double far = packing.coordination;
  all.closeness = roomPressure(sum + far, K, weight, packing.dimension) + roomMargin -
                  0.4 * roomReach * weight * far;
  return all;
}

} // namespace

TEST(Room, APackingIsLeftAloneAndReadsItsVolumeStrain)
{
  for (const Packing &packing : {packing::hex, packing::fcc}) {
    const Reading whole = read(packing, Eigen::Matrix3d::Identity());
    EXPECT_NEAR(whole.closeness, 0.0, 1e-14);
    EXPECT_NEAR(whole.nearest, 1.0, 1e-14);
    for (const double strain : {1e-6, -1e-6}) {
      const Reading r = read(packing, (1.0 + strain) * Eigen::Matrix3d::Identity());
      EXPECT_NEAR(r.closeness / (-packing.dimension * strain), 1.0, 1e-5);
    }
    EXPECT_EQ(roomPressure(packing.coordination, 1e5, packing.stressWeight(), packing.dimension),
              0.0);
  }
}

TEST(Room, ReadsLatticesThatAreShearedAtConstantVolume)
{
  // the bounds that laws/room.h and doc/laws.md state
  std::mt19937 random(3);
  std::normal_distribution<> normal;
  for (const Packing &packing : {packing::hex, packing::fcc}) {
    const bool plane = packing.dimension == 2;
    double least = 0.0, most = 0.0;
    for (int k = 0; k < 4000; k++) {
      Eigen::Matrix3d rate = Eigen::Matrix3d::Zero();
      for (int m = 0; m < packing.dimension; m++)
        for (int n = 0; n < packing.dimension; n++)
          rate(m, n) = normal(random);
      const double trace = rate.trace() / packing.dimension;
      for (int m = 0; m < packing.dimension; m++)
        rate(m, m) -= trace;
      rate *= 1.2 * (k + 1) / 4000.0 / rate.norm();
      const Reading r = read(packing, rate.exp());
      if (r.nearest < (plane ? 0.8 : 0.9))
        continue;
      least = std::min(least, r.closeness);
      most = std::max(most, r.closeness);
    }
    EXPECT_GT(least, plane ? -0.003 : -0.02);
    EXPECT_LT(most, plane ? 0.01 : 0.008);
    EXPECT_LT(least, plane ? -0.002 : -0.01); // such lattices were met
  }
}

// The kernel takes the short one for blocks in which it is the long one to the last bit.
TEST(Room, ShortShareIsTheLongOneNear1)
{
  for (int k = -200; k <= 200; k++)
    if (const double ratio = 1.0 + 5e-4 * k; isNear1(ratio)) {
      EXPECT_EQ(roomTakenNear1(ratio), roomTaken(roomShare(ratio))) << ratio;
    }
}

TEST(Room, TheForceIsTheGradientOfTheEnergy)
{
  // one pair of automata in the plane, whose other neighbours stay
  const double K = 172e3, weight = packing::hex.stressWeight();
  const double others[] = {6.4, 7.1};                  // of what they take
  const auto pressure = [&](double eps, double rest) { // eps = ln(r/d)
    return roomPressure(rest + roomTaken(roomShare(std::exp(eps))), K, weight, 2);
  };
  const auto energy = [&](double eps) { // per S d: V = S d/(2w)
    double sum = 0.0;
    for (const double rest : others)
      sum += roomEnergy(pressure(eps, rest), K) / (2.0 * weight);
    return sum;
  };
  for (const double eps : {-0.6, -0.1, 0.0, 0.2, 0.33}) {
    const double h = 1e-6;
    const double stress =
        roomStress(std::exp(eps), pressure(eps, others[0]), pressure(eps, others[1]));
    EXPECT_LT(stress, 0.0);
    // tension positive: the energy falls as the pair parts
    EXPECT_NEAR(stress, (energy(eps + h) - energy(eps - h)) / (2.0 * h), 1e-6 * K);
  }
  EXPECT_EQ(roomStress(1.41, 1e3, 1e3), 0.0);
  EXPECT_EQ(roomStress(4.0, 1e3, 1e3), 0.0);
}

TEST(Room, WhatABrokenLinkLeavesIsLetGoOfWhereThatSetsEnergyFree)
{
  EXPECT_EQ(strainLeft(-0.01), 0.0);
  EXPECT_EQ(strainLeft(0.01), 0.01);
  EXPECT_EQ(keptStrain(0.01, -0.02), 0.01); // pressed: its mean stress would rise without it
  EXPECT_EQ(keptStrain(0.01, 0.0), 0.01);
  EXPECT_DOUBLE_EQ(keptStrain(0.01, 0.004), 0.008);
  EXPECT_EQ(keptStrain(0.01, 0.05), 0.0);
  for (const double kept : {1e-4, 0.01, 0.3})
    for (const double sum : {1e-5, 0.01, 1.0}) {
      const double after = sum - (kept - keptStrain(kept, sum));
      EXPECT_LT(after * after, sum * sum); // of which the energy of the mean stress is made
      EXPECT_GE(after, 0.0);
    }
}
