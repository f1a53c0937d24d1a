// SPDX-License-Identifier: GPL-2.0-or-later
/// \file restart_block.h
/// What restart_format.h reads, on all ranks of a LAMMPS, which stops with one line where a part of
/// the file is damaged.
#ifndef LMP_MCA_RESTART_BLOCK_H
#define LMP_MCA_RESTART_BLOCK_H

#include "atom.h"
#include "error.h"
#include "files/restart_format.h"

#include <cstdio>
#include <string>

namespace mca {

/// The whole file on all ranks; rank 0 reads. Called by all ranks. Stops LAMMPS with one line when
/// that fails.
/// \param path  empty: as if the file could not be opened
/// \param what  names the file in the message
std::string fileText(LAMMPS_NS::LAMMPS *lmp, const std::string &path, const std::string &what);

/// Rank 0 reads the whole restart file against its checksum, and goes on behind it; called by all.
/// \param fp  open on rank 0, at the place of FileSeal
void checkSeal(LAMMPS_NS::LAMMPS *lmp, FILE *fp);

/// Rank 0 reads a block, all ranks get its text; called by all.
/// \param fp    open on rank 0, at the block's beginning; afterwards behind its end
/// \param what  names the block in the message
std::string blockText(LAMMPS_NS::LAMMPS *lmp, FILE *fp, const char *what);

/// The text of a fix's block, shorter than longestBlock. LAMMPS does not tell how long its memory
/// is; the checksum of the file has made sure that it is as it was written.
/// \param bytes  of LAMMPS, on every rank; the block begins there
std::string fixBlockText(LAMMPS_NS::LAMMPS *lmp, const char *bytes, const char *what);

/// What a function of restart_format.h reads; its RestartError stops LAMMPS. Called by all ranks.
template<class Read>
auto readOrStop(LAMMPS_NS::LAMMPS *lmp, Read read)
{
  try {
    return read();
  } catch (const RestartError &error) {
    lmp->error->all(FLERR, "{}", error.what());
  }
}

/// A fix with per-automaton state whose records in restart files end with a checksum. The ID is in
/// it, so that a record that came to another automaton is found, too.
/// \tparam Base  a LAMMPS fix that packs its records in LAMMPS's way: the number of values comes
///               first
template<class Base>
class CheckedRestart : public Base {
 public:
  using Base::Base;

  /// \return length of the record in doubles, the checksum included
  int pack_restart(int i, double *buf) override
  {
    const int n = Base::pack_restart(i, buf);
    buf[0] = n + 1;
    buf[n] = recordChecksum(buf, n, this->atom->tag[i]);
    return n + 1;
  }

  /// Checks the record before Base sees it; what is damaged stops LAMMPS with the ID of the atom.
  /// \param i    own atom
  /// \param nth  number of this fix's record among those of the atom, in atom->extra
  void unpack_restart(int i, int nth) override
  {
    const LAMMPS_NS::Atom &own = *this->atom;
    const auto record = checkedRecord(own.extra[i], own.nextra_store, nth, own.tag[i]);
    if (!record)
      this->error->one(
          FLERR,
          "Restart file is damaged: the {} record of atom {} does not match its "
          "checksum; or delete_atoms came between read_restart and the first run: give "
          "run 0 before it",
          this->style, own.tag[i]);
    if (!isSound(*record))
      this->error->one(FLERR,
                       "Restart file is damaged: the {} record of atom {} is of another length, or "
                       "holds what is no state",
                       this->style, own.tag[i]);
    Base::unpack_restart(i, nth);
  }

  /// One double more than Base's.
  int size_restart(int i) override { return Base::size_restart(i) + 1; }
  int maxsize_restart() override { return Base::maxsize_restart() + 1; }

 protected:
  /// Whether Base can take the record.
  virtual bool isSound(const Record &) const = 0;
};

} // namespace mca

#endif
