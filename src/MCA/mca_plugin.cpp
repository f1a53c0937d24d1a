// SPDX-License-Identifier: GPL-2.0-or-later
// Registers the styles with the LAMMPS that loads this plugin, after checking that it is the one
// the plugin was built for: classes are shared, so another version would corrupt memory.

#include "lammpsplugin.h"

#include "lammps.h"
#include "version.h"

#include "compute_mca_atom.h"
#include "compute_mca_energy.h"
#include "compute_mca_fragment_atom.h"
#include "compute_mca_link_local.h"
#include "fix_mca_drive.h"
#include "fix_mca_energy.h"
#include "fix_mca_events.h"
#include "fix_mca_history.h"
#include "fix_mca_state.h"
#include "fix_nve_mca.h"
#include "mca_links.h"
#include "pair_mca.h"
#include "region_mca_rough.h"

#include <cstdio>
#include <cstring>
#include <mpi.h>
#include <string>
#include <utility>

using namespace LAMMPS_NS;

// How the MPI library that this file was compiled for begins its own description
#if defined(OMPI_MAJOR_VERSION)
#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
static const char *const MPI_BUILT_FOR = "Open MPI v" TEXT(OMPI_MAJOR_VERSION) ".";
#elif defined(MPICH_VERSION)
static const char *const MPI_BUILT_FOR = "MPICH";
#else
static const char *const MPI_BUILT_FOR = "";
#endif

extern "C" {
int lammps_version(void *handle);
int lammps_extract_setting(void *handle, const char *name);
}

template<class Style>
static void *fromInstance(void *lmp)
{
  return new Style(static_cast<LAMMPS *>(lmp));
}

template<class Style>
static void *fromArguments(void *lmp, int narg, char **arg)
{
  return new Style(static_cast<LAMMPS *>(lmp), narg, arg);
}

// the library's own words up to the first comma, e.g. "Open MPI v4.1.4"
static std::string mpiLibrary()
{
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length;
  MPI_Get_library_version(text, &length);
  return std::string(text, std::strcspn(text, ",\n"));
}

static std::string mismatch(void *lmp)
{
  auto differ = [](const std::string &what, const std::string &built, const std::string &host) {
    return what + ": built for " + built + ", loaded into " + host;
  };
  const int version = lammps_version(lmp);
  if (version != LMP_VERNUM)
    return differ("LAMMPS version", std::to_string(LMP_VERNUM), std::to_string(version));
  const std::pair<const char *, size_t> integers[] = {
      {"tagint", sizeof(tagint)}, {"bigint", sizeof(bigint)}, {"imageint", sizeof(imageint)}};
  for (const auto &[name, size] : integers) {
    const int host = lammps_extract_setting(lmp, name);
    if (host != static_cast<int>(size))
      return differ(std::string("size of ") + name, std::to_string(size), std::to_string(host));
  }
  const std::string library = mpiLibrary();
  if (library.compare(0, std::strlen(MPI_BUILT_FOR), MPI_BUILT_FOR) != 0)
    return differ("MPI library", MPI_BUILT_FOR, library);
  return "";
}

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc)
{
  // nothing of LAMMPS's C++ interface is touched before the versions are known to match
  const std::string problem = mismatch(lmp);
  if (!problem.empty()) {
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0)
      std::fprintf(stderr,
                   "ERROR: mcaplugin.so does not fit this LAMMPS and registers no style: %s. Build "
                   "it again with -DLAMMPS_ROOT= of this LAMMPS\n",
                   problem.c_str());
    return;
  }

  auto registerPlugin = reinterpret_cast<lammpsplugin_regfunc>(regfunc);
  lammpsplugin_t plugin;
  plugin.version = LAMMPS_VERSION;
  plugin.author = "MCA-WHEELRAIL";
  plugin.handle = handle;
  auto add = [&](const char *style, const char *name, const char *info) {
    plugin.style = style;
    plugin.name = name;
    plugin.info = info;
    registerPlugin(&plugin, lmp);
  };

  plugin.creator.v1 = fromInstance<PairMCA>;
  add("pair", "mca", "movable cellular automata, pair style mca");
  plugin.creator.v1 = fromInstance<MCALinks>;
  add("command", "mca_links", "movable cellular automata, command mca_links");
  plugin.creator.v2 = fromArguments<FixMCAHistory>;
  add("fix", "MCA_HISTORY", "movable cellular automata, state of pairs");
  plugin.creator.v2 = fromArguments<FixMCAState>;
  add("fix", "MCA_STATE", "movable cellular automata, state of automata");
  plugin.creator.v2 = fromArguments<FixNVEMCA>;
  add("fix", "nve/mca", "movable cellular automata, fix nve/mca");
  plugin.creator.v2 = fromArguments<FixMCADrive>;
  add("fix", "mca/drive", "movable cellular automata, fix mca/drive");
  plugin.creator.v2 = fromArguments<FixMCAEvents>;
  add("fix", "mca/events", "movable cellular automata, fix mca/events");
  plugin.creator.v2 = fromArguments<ComputeMCAAtom>;
  add("compute", "mca/atom", "movable cellular automata, compute mca/atom");
  plugin.creator.v2 = fromArguments<FixMCAEnergy>;
  add("fix", "MCA_ENERGY", "movable cellular automata, account of compute mca/energy");
  plugin.creator.v2 = fromArguments<ComputeMCAEnergy>;
  add("compute", "mca/energy", "movable cellular automata, compute mca/energy");
  plugin.creator.v2 = fromArguments<ComputeMCAFragmentAtom>;
  add("compute", "mca/fragment/atom", "movable cellular automata, compute mca/fragment/atom");
  plugin.creator.v2 = fromArguments<ComputeMCALinkLocal>;
  add("compute", "mca/link/local", "movable cellular automata, compute mca/link/local");
  plugin.creator.v2 = fromArguments<RegionMCARough>;
  add("region", "mca/rough", "rough half-plane, region mca/rough");
}
