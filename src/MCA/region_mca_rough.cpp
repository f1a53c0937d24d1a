// SPDX-License-Identifier: GPL-2.0-or-later
#include "region_mca_rough.h"

#include "arguments.h"
#include "domain.h"
#include "error.h"

#include <cmath>
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
  origin = domain->boxlo[0];
  const std::string what = "Region mca/rough ";
  height = yscale * mca::number(lmp, what + "height", arg[3]);
  const double amplitude =
      yscale * mca::number(lmp, what + "amplitude", arg[4], mca::Sign::NotNegative);
  const double correlation =
      xscale * mca::number(lmp, what + "correlation", arg[5], mca::Sign::Positive);
  const bigint seed = mca::wholeNumber(lmp, what + "seed", arg[6], 1, MAXBIGINT);
  for (const double length : {height, amplitude})
    if (!(std::abs(length) < mca::RoughProfile::most * domain->xprd))
      error->all(FLERR, "Region mca/rough height {} or amplitude {}, allowed: below {} box lengths",
                 arg[3], arg[4], mca::RoughProfile::most);
  const double least = domain->xprd / mca::RoughProfile::most;
  if (!(correlation >= least && correlation <= domain->xprd))
    error->all(FLERR,
               "Region mca/rough correlation is '{}', {:.6g} in length units, allowed: from 1/{} "
               "of the box's length in x to that length, {:.6g} to {:.6g}",
               arg[5], correlation, mca::RoughProfile::most, least, domain->xprd);
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
  const bool under = y <= height + (*profile)(x - origin);
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
