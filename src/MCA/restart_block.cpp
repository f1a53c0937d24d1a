// SPDX-License-Identifier: GPL-2.0-or-later
#include "restart_block.h"

#include "comm.h"
#include "lammps.h"

#include <fstream>
#include <sstream>

using namespace LAMMPS_NS;

namespace mca {

static void broadcast(LAMMPS *lmp, std::string &text)
{
  unsigned long long length = text.size();
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG_LONG, 0, lmp->world);
  text.resize(length);
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, 0, lmp->world);
}

std::string fileText(LAMMPS *lmp, const std::string &path, const std::string &what)
{
  std::ostringstream text;
  int good = 1;
  if (lmp->comm->me == 0) {
    std::ifstream in(path, std::ios::binary);
    text << in.rdbuf();
    good = !path.empty() && in.is_open() && !in.bad();
  }
  MPI_Bcast(&good, 1, MPI_INT, 0, lmp->world);
  if (!good)
    lmp->error->all(FLERR, "Cannot open {}", what);
  std::string all = text.str();
  broadcast(lmp, all);
  return all;
}

void checkSeal(LAMMPS *lmp, FILE *fp)
{
  std::string problem = lmp->comm->me == 0 ? FileSeal::problem(fp) : "";
  broadcast(lmp, problem);
  if (!problem.empty())
    lmp->error->all(FLERR, "{}", problem);
}

std::string blockText(LAMMPS *lmp, FILE *fp, const char *what)
{
  std::optional<std::string> block;
  if (lmp->comm->me == 0)
    block = readBlock(fp);
  int good = block ? 1 : 0;
  MPI_Bcast(&good, 1, MPI_INT, 0, lmp->world);
  if (!good)
    lmp->error->all(FLERR,
                    "Restart file is damaged or truncated: the block of {} does not match "
                    "its checksum",
                    what);
  std::string text = block.value_or("");
  broadcast(lmp, text);
  return text;
}

std::string fixBlockText(LAMMPS *lmp, const char *bytes, const char *what)
{
  const std::optional<std::string> block = fixBlockIn(bytes, longestBlock);
  if (!block)
    lmp->error->all(FLERR, "Restart file is damaged: the block of {} does not match its checksum",
                    what);
  return *block;
}

} // namespace mca
