/// \file restart_block.h
/// A block of text in a LAMMPS restart file, with its length and a checksum, so that a damaged
/// file is refused instead of read.
#ifndef LMP_MCA_RESTART_BLOCK_H
#define LMP_MCA_RESTART_BLOCK_H

#include <cstdio>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace mca {

/// FNV-1a checksum of 64 bits (Fowler, Noll, Vo; RFC draft-eastlake-fnv).
unsigned long long checksum(const std::string &text);

/// Numbers as text that reads back to the same bits.
std::string exactText(const std::vector<double> &values);

/// Rank 0 writes.
void writeBlock(FILE *fp, const std::string &text);

/// Rank 0 reads, all ranks get the text. Stops LAMMPS with one line when the block is damaged.
/// \param what names the block in the message
std::string readBlock(LAMMPS_NS::LAMMPS *lmp, FILE *fp, const char *what);

/// A block that was written by blockBytes() to memory (global state of fixes): the same check.
std::string blockBytes(const std::string &text);
std::string readBlockBytes(LAMMPS_NS::LAMMPS *lmp, const char *bytes, const char *what);

} // namespace mca

#endif
