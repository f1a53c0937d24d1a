#include "halo.h"

#include <algorithm>

namespace mca {

void Halo::build(MPI_Comm comm, const std::vector<Guest> &guests)
{
  comm_ = comm;
  int ranks;
  MPI_Comm_size(comm, &ranks);
  std::vector<std::vector<int>> homes(ranks), rows(ranks);
  for (const Guest &g : guests) {
    homes[g.rank].push_back(g.home);
    rows[g.rank].push_back(g.row);
  }
  std::vector<int> wanted(ranks), needed(ranks);
  for (int r = 0; r < ranks; r++)
    wanted[r] = static_cast<int>(homes[r].size());
  MPI_Alltoall(wanted.data(), 1, MPI_INT, needed.data(), 1, MPI_INT, comm);

  neighbours_.clear();
  for (int r = 0; r < ranks; r++)
    if (wanted[r] + needed[r] > 0)
      neighbours_.push_back({r, std::vector<int>(needed[r]), rows[r], {}, {}});
  requests_.resize(2 * neighbours_.size());
  for (size_t m = 0; m < neighbours_.size(); m++) {
    Neighbour &to = neighbours_[m];
    MPI_Irecv(to.needed.data(), needed[to.rank], MPI_INT, to.rank, 0, comm, &requests_[2 * m]);
    MPI_Isend(homes[to.rank].data(), wanted[to.rank], MPI_INT, to.rank, 0, comm,
              &requests_[2 * m + 1]);
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
}

void Halo::begin(const double *rows, int stride, int count)
{
  for (size_t m = 0; m < neighbours_.size(); m++) {
    Neighbour &to = neighbours_[m];
    to.in.resize(to.guests.size() * count);
    MPI_Irecv(to.in.data(), static_cast<int>(to.in.size()), MPI_DOUBLE, to.rank, 1, comm_,
              &requests_[2 * m]);
    to.out.resize(to.needed.size() * count);
    double *out = to.out.data();
    for (const int row : to.needed)
      for (int k = 0; k < count; k++)
        *out++ = rows[static_cast<size_t>(row) * stride + k];
    MPI_Isend(to.out.data(), static_cast<int>(to.out.size()), MPI_DOUBLE, to.rank, 1, comm_,
              &requests_[2 * m + 1]);
  }
}

void Halo::finish(double *rows, int stride, int count)
{
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  for (const Neighbour &from : neighbours_) {
    const double *values = from.in.data();
    for (const int row : from.guests)
      for (int k = 0; k < count; k++)
        rows[static_cast<size_t>(row) * stride + k] = *values++;
  }
}

} // namespace mca
