// SPDX-License-Identifier: GPL-2.0-or-later
// Which spans of rows the blocks of a list touch, against a look at every pair.
#include "core/link_list.h"
#include "core/row_spans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace {

using testing::UnorderedElementsAreArray;

/// Pairs k of rows first(k) and second(k).
template<class First, class Second>
mca::LinkList pairs(int n, const First &first, const Second &second)
{
  mca::LinkList list(1);
  list.reset(n);
  const double state[] = {0.0, 0.0, 0.0, 0.0};
  for (int k = 0; k < n; k++)
    list.add(first(k), second(k), 0, state);
  return list;
}

std::vector<int> spansOf(const mca::RowSpans &spans, int block)
{
  return {spans.of(block).begin(), spans.of(block).end()};
}

TEST(RowSpans, NamesEverySpanOfABlockOnce)
{
  constexpr int own = 200, rows = 250, n = 300;
  const auto first = [](int k) { return k * 7 % own; };
  const auto second = [](int k) { return (k * 31 + 11) % rows; };
  mca::LinkList list = pairs(n, first, second);
  mca::RowSpans spans;
  spans.begin(list.part(0, n), own, rows);
  EXPECT_EQ(spans.own(), 4);
  EXPECT_EQ(spans.size(), 5);
  for (int block = 0; block * mca::blockLength < n; block++) {
    std::set<int> expected;
    for (int k = block * mca::blockLength; k < std::min((block + 1) * mca::blockLength, n); k++)
      for (const int row : {first(k), second(k)})
        for (int s = 0; s < spans.size(); s++)
          if (spans.first(s) <= row && row < spans.last(s))
            expected.insert(s);
    EXPECT_THAT(spansOf(spans, block), UnorderedElementsAreArray(expected));
  }
}

TEST(RowSpans, CoverAllRowsInTheirOrder)
{
  for (const int own : {0, 1, 63, 64, 65, 200})
    for (const int guests : {0, 1, 100}) {
      mca::LinkList none(1);
      none.reset(0);
      mca::RowSpans spans;
      spans.begin(none.part(0, 0), own, own + guests);
      int row = 0;
      for (int s = 0; s < spans.size(); s++) {
        EXPECT_EQ(spans.first(s), row);
        EXPECT_GT(spans.last(s), row);
        row = spans.last(s);
        if (s == spans.own() - 1) {
          EXPECT_EQ(row, own);
        }
      }
      EXPECT_EQ(row, own + guests) << own;
    }
}

TEST(RowSpans, OfAFewPairsTouchOnlyTheirOwn)
{
  mca::LinkList list = pairs(
      3, [](int k) { return 130 + k; }, [](int k) { return 135 + k; });
  mca::RowSpans spans;
  spans.begin(list.part(0, 3), 1000, 1000);
  EXPECT_EQ(spansOf(spans, 0), std::vector<int>{2});
}

} // namespace
