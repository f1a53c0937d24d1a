// SPDX-License-Identifier: GPL-2.0-or-later
#include "core/link_list.h"
#include "laws/linking.h"

#include <gtest/gtest.h>

#include <cstdint>

using mca::LinkList;

TEST(LinkList, KeepsPairsAndStates)
{
  LinkList list;
  list.reset(3);
  EXPECT_EQ(list.size(), 0);
  const double first[] = {1, 0.1, 0.2, 0.3}, second[] = {2, -0.1, -0.2, -0.3};
  list.add(4, 7, 2, first);
  list.add(5, 6, 1, second);
  ASSERT_EQ(list.size(), 2);
  const mca::Pairs &p = list.pairs();
  EXPECT_EQ(p.i[0], 4);
  EXPECT_EQ(p.j[0], 7);
  EXPECT_EQ(p.law[1], 1);
  for (const bool next : {false, true}) {
    double state[LinkList::maxStateSize];
    list.getState(1, next, state);
    for (int m = 0; m < list.stateSize(); m++)
      EXPECT_EQ(state[m], second[m]);
  }
}

TEST(LinkList, AdvanceMakesTheNextStateThePresentOne)
{
  LinkList list;
  list.reset(1);
  const double state[] = {1, 0.1, 0.2, 0.3};
  list.add(0, 1, 0, state);
  const double later[] = {1, 0.1, 0.7, 0.8};
  for (int m = 0; m < list.stateSize(); m++) // as the force pass does
    (m == 0   ? list.pairs().next.kind
     : m == 1 ? list.pairs().next.plastic
     : m == 2 ? list.pairs().next.gamma[0]
              : list.pairs().next.gammaTotal[0])[0] = later[m];
  list.pairs().blocks[0].moves = true;
  double seen[LinkList::maxStateSize];
  list.getState(0, false, seen);
  EXPECT_EQ(seen[2], 0.2);
  list.advance();
  list.getState(0, false, seen);
  EXPECT_EQ(seen[2], 0.7);
  list.setState(0, state);
  for (const bool next : {false, true}) {
    list.getState(0, next, seen);
    EXPECT_EQ(seen[2], 0.2);
  }
}

TEST(LinkList, BlocksKnowWhetherAllPairsAreBulkLinksOfOneLaw)
{
  LinkList list;
  const int n = 3 * mca::blockLength;
  list.reset(n);
  for (int k = 0; k < n; k++) {
    const double state[] = {k == 5 ? mca::link::weld : mca::link::bulk, 0, 0, 0};
    list.add(k, k + 1, k == n - 1 ? 1 : 0, state);
  }
  const mca::Block *blocks = list.pairs().blocks;
  EXPECT_FALSE(blocks[0].bulk);
  EXPECT_TRUE(blocks[1].bulk);
  EXPECT_EQ(blocks[1].law, 0);
  EXPECT_EQ(blocks[2].law, mca::Block::mixed);
  const double unlinked[] = {mca::link::none, 0, 0, 0};
  list.setState(mca::blockLength, unlinked);
  EXPECT_FALSE(blocks[1].bulk);
}

TEST(LinkList, InSpaceShearsAreVectors)
{
  LinkList list(3);
  ASSERT_EQ(list.stateSize(), 8);
  list.reset(1);
  const double state[] = {1, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  list.add(0, 1, 0, state);
  double seen[LinkList::maxStateSize];
  list.getState(0, false, seen);
  for (int m = 0; m < 8; m++)
    EXPECT_EQ(seen[m], state[m]);
  EXPECT_EQ(list.pairs().now.gamma[2][0], 0.4);
  EXPECT_EQ(list.pairs().now.gammaTotal[0][0], 0.5);
}

TEST(LinkList, GrowsAndIsReusable)
{
  LinkList list;
  for (const int n : {1, 1000, 10, 5000}) {
    list.reset(n);
    for (int k = 0; k < n; k++) {
      const double state[] = {static_cast<double>(k % 3), 1.0 * k, 2.0 * k, 3.0 * k};
      list.add(k, k + 1, 0, state);
    }
    ASSERT_EQ(list.size(), n);
    for (int k = 0; k < n; k++) {
      double state[LinkList::maxStateSize];
      EXPECT_EQ(list.pairs().i[k], k);
      EXPECT_EQ(list.pairs().now.gammaTotal[0][k], 3.0 * k);
      list.getState(k, true, state);
      EXPECT_EQ(state[1], 1.0 * k);
      EXPECT_EQ(list.pairs().normal[0][k], 0.0);
    }
  }
  EXPECT_GT(list.bytes(), 5000 * 8 * 8);
}

TEST(LinkList, ArraysAreAligned)
{
  LinkList list;
  list.reset(100);
  for (const double *p : {list.pairs().normal[0], list.pairs().eps, list.pairs().now.kind})
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(p) % 64, 0u);
}

TEST(LinkList, PristineBlocksAreCompletedForReaders)
{
  LinkList list;
  list.reset(200);
  for (int k = 0; k < 200; k++) {
    // the second block has a link that flowed
    const double state[] = {mca::link::bulk, 0.0, 0.1, k == 150 ? 0.2 : 0.1};
    list.add(k, k + 1, 0, state);
  }
  const mca::Pairs first = list.part(0, 128), second = list.part(128, 72);
  EXPECT_EQ(second.i[0], 128);
  EXPECT_TRUE(first.blocks[0].pristine);
  EXPECT_FALSE(second.blocks[0].pristine);
  for (int k = 0; k < 128; k++)
    first.now.gamma[0][k] = 0.3; // as the kernel does
  double state[LinkList::maxStateSize];
  list.getState(7, false, state);
  EXPECT_EQ(state[3], 0.3);
  const double broken[] = {mca::link::worn, 0.0, 0.0, 0.0};
  list.setState(7, broken);
  EXPECT_FALSE(first.blocks[0].pristine);
  EXPECT_EQ(list.pairs().now.gammaTotal[0][7], 0.0);
  EXPECT_EQ(list.pairs().now.gammaTotal[0][8], 0.3);
  EXPECT_EQ(list.pairs().now.gammaTotal[0][130], 0.1);
}

TEST(LinkList, PlacesOfImages)
{
  LinkList list;
  list.reset(2);
  const double state[] = {mca::link::bulk, 0.0, 0.0, 0.0};
  list.add(0, 1, 0, state);
  list.add(0, 9, 0, state);
  list.setPlaces(0, 10);
  const mca::Pairs &p = list.pairs();
  EXPECT_EQ(p.placeJ[0], 1);
  EXPECT_EQ(p.j[1], 9);
  for (int k = 1; k < 5; k++) // padded
    EXPECT_EQ(p.placeJ[k], 10);
}

TEST(LinkList, BlocksKnowWhetherAPairMeetsOverThePeriod)
{
  LinkList list;
  list.reset(2 * mca::blockLength);
  const double state[] = {mca::link::bulk, 0.0, 0.0, 0.0};
  for (int k = 0; k < 2 * mca::blockLength; k++)
    list.add(k, k + 1, 0, state);
  list.setPlaces(2 * mca::blockLength - 1, 500);
  const mca::Pairs p = list.part(0, list.size());
  EXPECT_FALSE(p.blocks[0].across);
  EXPECT_TRUE(p.blocks[1].across);
}
