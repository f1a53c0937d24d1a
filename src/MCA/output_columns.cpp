// SPDX-License-Identifier: GPL-2.0-or-later
#include "output_columns.h"

#include "error.h"
#include "memory.h"
#include "shared/nearest_word.h"

#include <algorithm>

using namespace LAMMPS_NS;

OutputColumns::OutputColumns(LAMMPS *host, const std::string &style,
                             const std::vector<std::string> &known, int narg, char **arg)
    : Pointers(host)
{
  if (narg < 1) {
    std::string all;
    for (const auto &name : known)
      all += " " + name;
    error->all(FLERR, "{} needs at least one of:{}", style, all);
  }
  for (int k = 0; k < narg; k++) {
    const auto found = std::find(known.begin(), known.end(), arg[k]);
    if (found == known.end())
      error->all(FLERR, "{}: {}", style, mcawr::unknownWord("attribute", arg[k], known));
    attributes.push_back(static_cast<int>(found - known.begin()));
  }
}

OutputColumns::~OutputColumns()
{
  memory->destroy(vector);
  memory->destroy(array);
}

bool OutputColumns::has(int attribute) const
{
  return std::find(attributes.begin(), attributes.end(), attribute) != attributes.end();
}

void OutputColumns::grow(int rows)
{
  if (rows <= nmax)
    return;
  nmax = rows + rows / 8 + 16;
  if (size() == 1)
    memory->grow(vector, nmax, "mca:vector");
  else
    memory->grow(array, nmax, size(), "mca:array");
}
