// SPDX-License-Identifier: GPL-2.0-or-later
#include "halo.h"

#include <algorithm>
#include <new>
#include <thread>

namespace mca {

static constexpr long line = 64; // bytes of a cache line

// Lines of a box: the count, then both messages.
static long messageLines(std::size_t automata)
{
  return static_cast<long>((automata * Halo::mostValues * sizeof(double) + line - 1) / line);
}

static long boxLines(std::size_t automata)
{
  return 1 + 2 * messageLines(automata);
}

Halo::~Halo()
{
  closeWindow();
  if (node_ != MPI_COMM_NULL)
    MPI_Comm_free(&node_);
}

void Halo::closeWindow()
{
  if (window_ == MPI_WIN_NULL)
    return;
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

void Halo::findNode()
{
  int ranks;
  MPI_Comm_size(comm_, &ranks);
  onNode_.assign(ranks, MPI_UNDEFINED);
  MPI_Comm_split_type(comm_, shares_ ? MPI_COMM_TYPE_SHARED : MPI_UNDEFINED, 0, MPI_INFO_NULL,
                      &node_);
  if (!shares_)
    return;
  std::vector<int> all(ranks);
  for (int r = 0; r < ranks; r++)
    all[r] = r;
  MPI_Group ours, nodes;
  MPI_Comm_group(comm_, &ours);
  MPI_Comm_group(node_, &nodes);
  MPI_Group_translate_ranks(ours, ranks, all.data(), nodes, onNode_.data());
  MPI_Group_free(&ours);
  MPI_Group_free(&nodes);
}

void Halo::build(MPI_Comm comm, const std::vector<Guest> &guests)
{
  if (comm_ == MPI_COMM_NULL) {
    comm_ = comm;
    findNode();
  }
  const auto ranks = onNode_.size();
  std::vector<std::vector<int>> homes(ranks), rows(ranks);
  for (const Guest &g : guests) {
    homes[g.rank].push_back(g.home);
    rows[g.rank].push_back(g.row);
  }
  std::vector<int> wanted(ranks), needed(ranks);
  for (size_t r = 0; r < ranks; r++)
    wanted[r] = static_cast<int>(homes[r].size());
  MPI_Alltoall(wanted.data(), 1, MPI_INT, needed.data(), 1, MPI_INT, comm);

  neighbours_.clear();
  for (size_t r = 0; r < ranks; r++)
    if (wanted[r] + needed[r] > 0)
      neighbours_.push_back({static_cast<int>(r), std::vector<int>(needed[r]), rows[r], {}, {}});
  requests_.assign(2 * neighbours_.size(), MPI_REQUEST_NULL);
  for (size_t m = 0; m < neighbours_.size(); m++) {
    Neighbour &to = neighbours_[m];
    MPI_Irecv(to.needed.data(), needed[to.rank], MPI_INT, to.rank, 0, comm, &requests_[2 * m]);
    MPI_Isend(homes[to.rank].data(), wanted[to.rank], MPI_INT, to.rank, 0, comm,
              &requests_[2 * m + 1]);
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  share();
}

// With each neighbour of the node, a box in either's part of the window.
void Halo::share()
{
  std::vector<long> at(onNode_.size(), 0), theirs(onNode_.size());
  if (shares_)
    makeBoxes(at);
  // nobody looks into a box before all are empty
  MPI_Alltoall(at.data(), 1, MPI_LONG, theirs.data(), 1, MPI_LONG, comm_);
  for (Neighbour &n : neighbours_)
    if (onNode_[n.rank] != MPI_UNDEFINED)
      n.from = boxAt(onNode_[n.rank], theirs[n.rank], n.guests.size());
}

// at: by rank, the first line of the box for it in this rank's part.
void Halo::makeBoxes(std::vector<long> &at)
{
  long lines = 0, most;
  for (const Neighbour &n : neighbours_)
    if (onNode_[n.rank] != MPI_UNDEFINED) {
      at[n.rank] = lines;
      lines += boxLines(n.needed.size());
    }
  MPI_Allreduce(&lines, &most, 1, MPI_LONG, MPI_MAX, node_);
  if (most > capacity_) {
    closeWindow();
    capacity_ = 2 * most;
    void *own;
    MPI_Win_allocate_shared(capacity_ * line, 1, MPI_INFO_NULL, node_, &own, &window_);
    MPI_Win_lock_all(MPI_MODE_NOCHECK, window_);
  }
  int self;
  MPI_Comm_rank(node_, &self);
  messages_ = 0;
  for (Neighbour &n : neighbours_)
    if (onNode_[n.rank] != MPI_UNDEFINED) {
      n.to = boxAt(self, at[n.rank], n.needed.size());
      new (n.to.written) std::atomic<std::uint64_t>(0);
    }
}

Halo::Box Halo::boxAt(int nodeRank, long first, std::size_t automata) const
{
  MPI_Aint size;
  int unit;
  void *base;
  MPI_Win_shared_query(window_, nodeRank, &size, &unit, &base);
  char *const bytes = static_cast<char *>(base) + first * line;
  auto *const values = reinterpret_cast<double *>(bytes + line);
  const long length = messageLines(automata) * line / static_cast<long>(sizeof(double));
  return {reinterpret_cast<std::atomic<std::uint64_t> *>(bytes), {values, values + length}};
}

static void pack(const std::vector<int> &automata, const double *rows, int stride, int count,
                 double *out)
{
  for (const int row : automata)
    for (int k = 0; k < count; k++)
      *out++ = rows[static_cast<size_t>(row) * stride + k];
}

static void unpack(const std::vector<int> &automata, const double *in, int stride, int count,
                   double *rows)
{
  for (const int row : automata)
    for (int k = 0; k < count; k++)
      rows[static_cast<size_t>(row) * stride + k] = *in++;
}

// Message m stands in half m % 2 of a box, and its count is stored after its values (release), read
// before them (acquire). Two halves are enough, without a word from reader to writer: a rank writes
// message m + 2 over message m only after its finish() of m + 1, which waited until its neighbour
// had begun m + 1, hence had finished m and read it. Neighbours wait for each other even where
// values go one way only: each has a box for the other, with a count alone if it has nothing to
// say.
void Halo::begin(const double *rows, int stride, int count)
{
  messages_++;
  for (size_t m = 0; m < neighbours_.size(); m++) {
    Neighbour &to = neighbours_[m];
    sent_.messages += 1.0;
    sent_.bytes += static_cast<double>(to.needed.size() * count * sizeof(double));
    if (to.to.written) {
      pack(to.needed, rows, stride, count, to.to.values[messages_ % 2]);
      to.to.written->store(messages_, std::memory_order_release);
      continue;
    }
    to.in.resize(to.guests.size() * count);
    MPI_Irecv(to.in.data(), static_cast<int>(to.in.size()), MPI_DOUBLE, to.rank, 1, comm_,
              &requests_[2 * m]);
    to.out.resize(to.needed.size() * count);
    pack(to.needed, rows, stride, count, to.out.data());
    MPI_Isend(to.out.data(), static_cast<int>(to.out.size()), MPI_DOUBLE, to.rank, 1, comm_,
              &requests_[2 * m + 1]);
  }
}

// Spins, and leaves its core to others only after some 10 us: ranks may be more than cores.
static void await(const std::atomic<std::uint64_t> &written, std::uint64_t message)
{
  for (int k = 0; written.load(std::memory_order_acquire) < message; k++)
    if (k > 2000)
      std::this_thread::yield();
}

void Halo::finish(double *rows, int stride, int count)
{
  for (const Neighbour &from : neighbours_)
    if (from.from.written) {
      await(*from.from.written, messages_);
      unpack(from.guests, from.from.values[messages_ % 2], stride, count, rows);
    }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  for (const Neighbour &from : neighbours_)
    if (!from.from.written)
      unpack(from.guests, from.in.data(), stride, count, rows);
}

} // namespace mca
