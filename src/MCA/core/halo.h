// SPDX-License-Identifier: GPL-2.0-or-later
/// \file halo.h
/// What a rank needs of automata that other ranks own: one message from each rank, which comes in
/// while the inside of the sample is worked on. Ranks of one node read it from memory that they
/// share, which takes a third of the time of an MPI message; all others send MPI messages.
/// A rank's window holds one box for each neighbour of its node: a cache line with the number of
/// messages, then room for two messages of Exchange::mostValues values an automaton. Writers only
/// write to their own window, readers wait until the count has reached the message they are at.
#ifndef MCA_HALO_H
#define MCA_HALO_H

#include "exchange.h"

#include <mpi.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace mca {

/// The exchange between MPI ranks. All functions but alone() and the constructor are collective:
/// all ranks of the communicator call them in the same order.
class Halo : public Exchange {
 public:
  /// An automaton that another rank owns, and the row of its values here.
  struct Guest {
    /// Its owner, never this rank, and the row there, below the owner's number of own automata.
    int rank, home;
    /// Row here, from this rank's number of own automata on.
    int row;
  };

  /// No MPI yet: that begins with build().
  /// \param shares  false: MPI messages to and from all ranks, as if this one were alone on its
  ///                node
  explicit Halo(bool shares = true) : shares_(shares) {}
  /// Frees the shared window and the communicator of the node; has to come before
  /// MPI_Finalize.
  ~Halo() override;
  Halo(const Halo &) = delete;
  Halo &operator=(const Halo &) = delete;

  /// Tells all ranks what this one needs; called by all of them, and again whenever the lists of
  /// pairs are made anew. The window is kept as long as it is large enough. No message may be on
  /// its way.
  /// \param comm    communicator of the sample; the same one in all calls, and it outlives the halo
  /// \param guests  automata of other ranks, each once; none is allowed. Copied.
  void build(MPI_Comm comm, const std::vector<Guest> &guests);

  /// One rank alone, or not built yet; then messages need not be sent. A rank without guests among
  /// others is not alone: others may need its values.
  bool alone() const override { return onNode_.size() <= 1; }
  /// Writes or sends the values of own automata that other ranks need; see Exchange::begin().
  /// Returns without waiting for a reader: each box has room for two messages. The values are
  /// copied, so that `rows` may change before finish().
  void begin(const double *rows, int stride, int count) override;
  /// What this rank has sent since it was made.
  struct Sent {
    double messages = 0.0; ///< to one rank each
    double bytes = 0.0;
  };
  Sent sent() const { return sent_; }
  /// Waits for the values of all guests and stores them in their rows; all other rows stay. It
  /// spins for some 10 us, then leaves the core to others, since there may be more ranks than
  /// cores.
  /// \param stride,count  those of the begin() before
  void finish(double *rows, int stride, int count) override;

 private:
  /// Two messages in the memory of their writer, since the next one may come before this is read;
  /// taken in turns. All are nullptr for ranks of other nodes.
  struct Box {
    /// Number of messages written since build(), the last one included. Stored with release after
    /// the values, read with acquire before them.
    std::atomic<std::uint64_t> *written;
    /// Those of message m are in values[m % 2], `count` each automaton, in the order of
    /// Neighbour::needed.
    double *values[2];
  };
  /// A rank with which this one exchanges values, in either or both directions.
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
  /// Messages begun since the last build(), the same on all ranks.
  std::uint64_t messages_ = 0;
  Sent sent_;
  std::vector<Neighbour> neighbours_;
  std::vector<MPI_Request> requests_;

  /// Which ranks are of this node; once, by the first build().
  void findNode();
  /// Frees the window, if there is one.
  void closeWindow();
  /// Boxes with all neighbours of the node, each way.
  void share();
  /// Makes room for all own boxes, with as much again where the window has to grow, and empties
  /// them.
  /// \param at  by rank, set to the first cache line of the box for it
  void makeBoxes(std::vector<long> &at);
  /// A box in the window of a rank of this node.
  /// \param nodeRank  the rank within the node
  /// \param first     the box's first cache line there
  /// \param automata  so many automata are in its messages
  Box boxAt(int nodeRank, long first, std::size_t automata) const;
};

} // namespace mca

#endif
