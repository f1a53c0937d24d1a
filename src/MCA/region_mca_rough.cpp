// SPDX-License-Identifier: GPL-2.0-or-later
#include "region_mca_rough.h"

#include "domain.h"
#include "error.h"

#include <cstring>

using namespace LAMMPS_NS;

/* region ID mca/rough below|above height amplitude correlation seed [region keywords] */

RegionMCARough::RegionMCARough(LAMMPS *host, int narg, char **arg) : Region(host, narg, arg)
{
  if (narg < 7)
    error->all(FLERR, "Region mca/rough needs: below|above height amplitude correlation seed");
  if (strcmp(arg[2], "below") != 0 && strcmp(arg[2], "above") != 0)
    error->all(FLERR, "Region mca/rough side is {}, allowed: below, above", arg[2]);
  if (!domain->box_exist)
    error->all(FLERR, "Region mca/rough must follow create_box or read_data, whose length in x is "
                      "its period");
  options(narg - 7, &arg[7]);
  below = strcmp(arg[2], "below") == 0;
  height = yscale * utils::numeric(FLERR, arg[3], false, lmp);
  const double amplitude = yscale * utils::numeric(FLERR, arg[4], false, lmp);
  const double correlation = xscale * utils::numeric(FLERR, arg[5], false, lmp);
  const bigint seed = utils::bnumeric(FLERR, arg[6], false, lmp);
  if (!(amplitude >= 0.0))
    error->all(FLERR, "Region mca/rough amplitude is {}, allowed: >= 0", arg[4]);
  if (!(correlation > 0.0))
    error->all(FLERR, "Region mca/rough correlation is {}, allowed: > 0", arg[5]);
  if (seed <= 0)
    error->all(FLERR, "Region mca/rough seed is {}, allowed: a whole number > 0", arg[6]);
  profile = std::make_unique<mca::RoughProfile>(domain->xprd, amplitude, correlation, seed);

  bboxflag = 0;
  cmax = tmax = 1;
  contact = new Contact[cmax];
}

RegionMCARough::~RegionMCARough()
{
  delete[] contact;
}

int RegionMCARough::inside(double x, double y, double /*z*/)
{
  const bool under = y <= height + (*profile)(x - domain->boxlo[0]);
  return under == below ? 1 : 0;
}

int RegionMCARough::surface_interior(double * /*x*/, double /*cutoff*/)
{
  error->one(FLERR, "Region mca/rough cannot be used as a wall");
  return 0;
}

int RegionMCARough::surface_exterior(double *x, double cutoff)
{
  return surface_interior(x, cutoff);
}
