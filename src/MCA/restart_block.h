// SPDX-License-Identifier: GPL-2.0-or-later
/// \file restart_block.h
/// Checksums for what we write to a LAMMPS restart file: a block of text with its length (global
/// state), and the record of an automaton (state of a fix). A damaged file is refused, not read.
#ifndef LMP_MCA_RESTART_BLOCK_H
#define LMP_MCA_RESTART_BLOCK_H

#include "atom.h"
#include "error.h"

#include <cstdio>
#include <string>
#include <vector>

namespace mca {

/// FNV-1a checksum of 64 bits (Fowler, Noll, Vo; RFC draft-eastlake-fnv).
unsigned long long checksum(const void *bytes, size_t n);

/// Numbers as text that reads back to the same bits.
std::string exactText(const std::vector<double> &values);

/// The whole file on all ranks; rank 0 reads. Stops LAMMPS with one line when that fails.
/// \param what  names the file in the message
std::string fileText(LAMMPS_NS::LAMMPS *lmp, const std::string &path, const std::string &what);

/// Rank 0 writes.
void writeBlock(FILE *fp, const std::string &text);

/// Rank 0 reads, all ranks get the text. Stops LAMMPS with one line when the block is damaged.
/// \param what names the block in the message
std::string readBlock(LAMMPS_NS::LAMMPS *lmp, FILE *fp, const char *what);

/// A block that was written by blockBytes() to memory (global state of fixes): the same check.
std::string blockBytes(const std::string &text);
std::string readBlockBytes(LAMMPS_NS::LAMMPS *lmp, const char *bytes, const char *what);

/// Checksum of an automaton's record and of its ID, as a double that is a whole number.
double recordChecksum(const double *values, int n, LAMMPS_NS::tagint id);

/// A fix with per-automaton state whose records in restart files end with a checksum. Base is a
/// LAMMPS fix that packs its records in LAMMPS's way: the number of values comes first.
template<class Base>
class CheckedRestart : public Base {
 public:
  using Base::Base;

  int pack_restart(int i, double *buf) override
  {
    const int n = Base::pack_restart(i, buf);
    buf[0] = n + 1;
    buf[n] = recordChecksum(buf, n, this->atom->tag[i]);
    return n + 1;
  }

  void unpack_restart(int i, int nth) override
  {
    const double *record = this->atom->extra[i];
    const double *const end = record + this->atom->nextra_store;
    auto fits = [&end](const double *r) { return r < end && r[0] >= 2.0 && r[0] <= end - r; };
    bool good = fits(record);
    for (int m = 0; m < nth && good; m++) {
      record += static_cast<int>(record[0]);
      good = fits(record);
    }
    if (good) {
      const int n = static_cast<int>(record[0]) - 1;
      good = record[n] == recordChecksum(record, n, this->atom->tag[i]);
    }
    if (!good)
      this->error->one(FLERR,
                       "Restart file is damaged: the {} record of atom {} does not match its "
                       "checksum",
                       this->style, this->atom->tag[i]);
    Base::unpack_restart(i, nth);
  }

  int size_restart(int i) override { return Base::size_restart(i) + 1; }
  int maxsize_restart() override { return Base::maxsize_restart() + 1; }
};

} // namespace mca

#endif
