#include "link_list.h"

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
    double state[LinkList::stateSize];
    list.getState(1, next, state);
    for (int m = 0; m < LinkList::stateSize; m++)
      EXPECT_EQ(state[m], second[m]);
  }
}

TEST(LinkList, AdvanceMakesTheNextStateThePresentOne)
{
  LinkList list;
  list.reset(1);
  const double state[] = {1, 0.1, 0.2, 0.3};
  list.add(0, 1, 0, state);
  list.pairs().next.gamma[0] = 0.7;
  double seen[LinkList::stateSize];
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
      EXPECT_EQ(list.pairs().i[k], k);
      EXPECT_EQ(list.pairs().now.gammaTotal[k], 3.0 * k);
      EXPECT_EQ(list.pairs().next.plastic[k], 1.0 * k);
      EXPECT_EQ(list.pairs().nx[k], 0.0);
    }
  }
  EXPECT_GT(list.bytes(), 5000 * 8 * 8);
}

TEST(LinkList, ArraysAreAligned)
{
  LinkList list;
  list.reset(100);
  for (const double *p : {list.pairs().nx, list.pairs().eps, list.pairs().now.kind})
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(p) % 64, 0u);
}
