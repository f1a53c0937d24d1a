// SPDX-License-Identifier: GPL-2.0-or-later
#include "restart_block.h"

#include "comm.h"
#include "lammps.h"

#include <cstring>
#include <fstream>
#include <sstream>

using namespace LAMMPS_NS;

namespace mca {

namespace {
struct Head {
  unsigned long long length, sum;
};
constexpr unsigned long long longest = 1 << 24; // bytes; far beyond any block of ours
} // namespace

unsigned long long checksum(const void *bytes, size_t n)
{
  unsigned long long sum = 14695981039346656037ULL;
  for (const auto *c = static_cast<const unsigned char *>(bytes); n > 0; c++, n--)
    sum = (sum ^ *c) * 1099511628211ULL;
  return sum;
}

static unsigned long long checksum(const std::string &text)
{
  return checksum(text.data(), text.size());
}

double recordChecksum(const double *values, int n, tagint id)
{
  // the 53 bits that a double holds exactly
  const unsigned long long sum = checksum(values, n * sizeof(double)) + checksum(&id, sizeof(id));
  return static_cast<double>(sum >> 11);
}

std::string exactText(const std::vector<double> &values)
{
  std::ostringstream text;
  text.precision(17);
  for (const double value : values)
    text << value << ' ';
  return text.str();
}

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
    good = !path.empty() && in;
    if (good)
      text << in.rdbuf();
  }
  MPI_Bcast(&good, 1, MPI_INT, 0, lmp->world);
  if (!good)
    lmp->error->all(FLERR, "Cannot open {}", what);
  std::string all = text.str();
  broadcast(lmp, all);
  return all;
}

std::string blockBytes(const std::string &text)
{
  const Head head = {text.size(), checksum(text)};
  std::string bytes(reinterpret_cast<const char *>(&head), sizeof(head));
  return bytes + text;
}

void writeBlock(FILE *fp, const std::string &text)
{
  const std::string bytes = blockBytes(text);
  fwrite(bytes.data(), 1, bytes.size(), fp);
}

std::string readBlock(LAMMPS *lmp, FILE *fp, const char *what)
{
  Head head = {0, 0};
  std::string text;
  int good = 1;
  if (lmp->comm->me == 0) {
    good = fread(&head, sizeof(head), 1, fp) == 1 && head.length < longest;
    if (good) {
      text.resize(head.length);
      good = fread(text.data(), 1, text.size(), fp) == text.size() && checksum(text) == head.sum;
    }
  }
  MPI_Bcast(&good, 1, MPI_INT, 0, lmp->world);
  if (!good)
    lmp->error->all(FLERR,
                    "Restart file is damaged or truncated: the block of {} does not match "
                    "its checksum",
                    what);
  broadcast(lmp, text);
  return text;
}

std::string readBlockBytes(LAMMPS *lmp, const char *bytes, const char *what)
{
  Head head;
  std::memcpy(&head, bytes, sizeof(head));
  std::string text = head.length < longest ? std::string(bytes + sizeof(head), head.length) : "";
  if (head.length >= longest || checksum(text) != head.sum)
    lmp->error->all(FLERR, "Restart file is damaged: the block of {} does not match its checksum",
                    what);
  return text;
}

} // namespace mca
