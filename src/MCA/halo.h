/// \file halo.h
/// What a rank needs of automata that other ranks own: one message from each rank, which comes in
/// while the inside of the sample is worked on.
#ifndef MCA_HALO_H
#define MCA_HALO_H

#include <mpi.h>

#include <vector>

namespace mca {

class Halo {
 public:
  /// An automaton that another rank owns, and the row of its values here.
  struct Guest {
    int rank, home; ///< owner, and the row there
    int row;
  };

  /// Tells all ranks what this one needs; called by all of them.
  void build(MPI_Comm comm, const std::vector<Guest> &guests);

  /// Sends `count` values of each own automaton that is needed.
  /// \param rows  `stride` values an automaton, of which the first `count` are sent
  void begin(const double *rows, int stride, int count);

  /// Receives those of the guests.
  void finish(double *rows, int stride, int count);

 private:
  struct Neighbour {
    int rank;
    std::vector<int> needed, guests; ///< rows of own automata, of guests
    std::vector<double> out, in;
  };
  MPI_Comm comm_ = MPI_COMM_NULL;
  std::vector<Neighbour> neighbours_;
  std::vector<MPI_Request> requests_;
};

} // namespace mca

#endif
