// SPDX-License-Identifier: GPL-2.0-or-later
// Run by mpirun on any number of ranks.
#include "core/halo.h"

#include <gtest/gtest.h>

#include <vector>

using mca::Halo;

namespace {

constexpr int own = 5, stride = Halo::mostValues;

double value(int rank, int row, int k, int message)
{
  return 1e4 * rank + 100.0 * row + 10.0 * message + k;
}

// Rank `me` needs more of some ranks than of others, and of three ranks nothing of the one before
// it.
std::vector<Halo::Guest> guestsOf(int me, int ranks, int times)
{
  std::vector<Halo::Guest> guests;
  int row = own;
  for (int r = 0; r < ranks; r++)
    if (r != me && (ranks == 2 || (r + 1) % ranks != me))
      for (int n = 0; n < times * (1 + r); n++)
        guests.push_back({r, (n + me) % own, row++});
  return guests;
}

/// Which ranks are of one node; each other one is of its own.
enum class Node { EveryRank, AllButTheLast, None };

class HaloTest : public testing::TestWithParam<Node> {};

TEST_P(HaloTest, BringsTheValuesOfEachGuest)
{
  int me, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &me);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const Node node = GetParam();
  Halo halo(node == Node::EveryRank || (node == Node::AllButTheLast && me < ranks - 1));
  int wrong = 0;
  double guestsTimesCounts = 0.0;
  for (const int times : {1, 7, 40, 2, 0, 3}) {
    const auto guests = guestsOf(me, ranks, times);
    halo.build(MPI_COMM_WORLD, guests);
    std::vector<double> rows((own + guests.size()) * stride);
    for (int message = 1; message <= 30; message++) {
      const int count = 1 + message % Halo::mostValues;
      std::fill(rows.begin(), rows.end(), -1.0);
      for (int row = 0; row < own; row++)
        for (int k = 0; k < stride; k++)
          rows[row * stride + k] = value(me, row, k, message);
      halo.begin(rows.data(), stride, count);
      halo.finish(rows.data(), stride, count);
      guestsTimesCounts += static_cast<double>(guests.size() * count);
      for (const Halo::Guest &g : guests)
        for (int k = 0; k < stride; k++)
          wrong +=
              rows[g.row * stride + k] != (k < count ? value(g.rank, g.home, k, message) : -1.0);
    }
  }
  // at the end: the other ranks wait for this one
  EXPECT_EQ(wrong, 0) << "rank " << me;
  // all that is received was sent
  double sent = halo.sent().bytes, received = guestsTimesCounts * sizeof(double);
  MPI_Allreduce(MPI_IN_PLACE, &sent, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, &received, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(sent, received);
  EXPECT_EQ(halo.sent().messages > 0.0, ranks > 1);
}

INSTANTIATE_TEST_SUITE_P(SharedMemoryMessagesOrBoth, HaloTest,
                         testing::Values(Node::EveryRank, Node::AllButTheLast, Node::None));

} // namespace

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  MPI_Finalize();
  return failed;
}
