// SPDX-License-Identifier: GPL-2.0-or-later
/// \file halo.h
/// What a rank needs of automata that other ranks own: one message from each rank, which comes in
/// while the inside of the sample is worked on. Ranks of one node read it from memory that they
/// share, which takes a third of the time of an MPI message; all others send MPI messages.
#ifndef MCA_HALO_H
#define MCA_HALO_H

#include "exchange.h"

#include <mpi.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace mca {

/// The exchange between MPI ranks. All functions but alone() are collective.
class Halo : public Exchange {
 public:
  /// An automaton that another rank owns, and the row of its values here.
  struct Guest {
    int rank, home; ///< owner, and the row there
    int row;
  };

  /// \param shares  false: MPI messages to and from all ranks, as if this one were alone on its
  /// node
  explicit Halo(bool shares = true) : shares_(shares) {}
  ~Halo() override;
  Halo(const Halo &) = delete;
  Halo &operator=(const Halo &) = delete;

  /// Tells all ranks what this one needs; called by all of them.
  void build(MPI_Comm comm, const std::vector<Guest> &guests);

  /// One rank alone, or not built yet.
  bool alone() const override { return onNode_.size() <= 1; }
  void begin(const double *rows, int stride, int count) override;
  void finish(double *rows, int stride, int count) override;

 private:
  /// In the memory of its writer; two messages, since the next one may come before this is read.
  struct Box {
    std::atomic<std::uint64_t> *written; ///< number of messages
    double *values[2];
  };
  struct Neighbour {
    int rank;
    std::vector<int> needed, guests; ///< rows of own automata, of guests
    std::vector<double> out, in;     ///< of MPI messages
    Box to{}, from{};                ///< of a rank of this node
  };
  bool shares_;
  MPI_Comm comm_ = MPI_COMM_NULL, node_ = MPI_COMM_NULL;
  MPI_Win window_ = MPI_WIN_NULL;
  std::vector<int> onNode_; ///< rank within the node of each rank; MPI_UNDEFINED elsewhere
  long capacity_ = 0;       ///< of each rank's part of the window [cache lines]
  std::uint64_t messages_ = 0;
  std::vector<Neighbour> neighbours_;
  std::vector<MPI_Request> requests_;

  void findNode();
  void closeWindow();
  void share();
  void makeBoxes(std::vector<long> &at);
  Box boxAt(int nodeRank, long line, std::size_t automata) const;
};

} // namespace mca

#endif
