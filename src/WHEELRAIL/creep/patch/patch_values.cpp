// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_values.h"

#include "base/si.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {

// While the contact rolls over a place, it lies under each cell for the way dx.
Eigen::VectorXd wornRows(const PatchSolution &solved)
{
  if (solved.wear.kind == WearLaw::Kind::None)
    return {};
  const PatchGrid &grid = solved.contact.grid;
  const TangentialField &q = solved.tangential.traction, &s = solved.tangential.slip;
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(grid.ny);
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix) {
      const int i = grid.index(ix, iy);
      const double work = -(q.x[i] * s.x[i] + q.y[i] * s.y[i]);
      rows[iy] += grid.dx * solved.wear.depth(solved.pressure[i], std::max(0.0, work),
                                              std::hypot(s.x[i], s.y[i]));
    }
  return rows;
}

std::vector<Column<PatchValues>> patchValueColumns()
{
  using V = PatchValues;
  constexpr double perMm = 1e3, mm3PerM = 1e-9; // in SI
  // name, unit, meaning; in creep.csv, creep_band.csv, static.csv, series.csv
  std::vector<Column<V>> table = {
      {"load", "N", 1.0, "normal force", kept<&V::load>, following(10), following(10), leading(10),
       following(10)},
      {"creep", "1", 1.0, "longitudinal creep", kept<&V::creepage, &Creepage::xi>, leading(10),
       leading(10), nowhere, following(10)},
      {"lateral", "1", 1.0, "lateral creep", kept<&V::creepage, &Creepage::eta>, following(10),
       following(10), nowhere, following(10)},
      {"spin", "1/mm", perMm, "turn over the length rolled", kept<&V::creepage, &Creepage::phi>,
       following(10), following(10), nowhere, following(10)},
      {"force_x", "N", 1.0, "on the wheel, along x", kept<&V::forceX>, following(10), nowhere,
       following(10), following(10)},
      {"force_y", "N", 1.0, "on the wheel, along y", kept<&V::forceY>, following(10), nowhere,
       following(10), following(10)},
      {"moment_z", "N mm", newtonMm, "on the wheel", kept<&V::momentZ>, following(10), nowhere,
       following(10), following(10)}};
  append(table, slidingColumns());
  const std::vector<Column<V>> others = {
      {"approach", "mm", mm, "of the bodies", kept<&V::approach>, following(10), nowhere,
       following(10), following(10)},
      {"peak_pressure", "MPa", MPa, "largest pressure", kept<&V::peakPressure>, following(10),
       nowhere, following(10), following(8)},
      {"real_area", "mm2", mm2, "of the cells in contact", kept<&V::realArea>, following(10),
       nowhere, following(10), following(8)},
      {"power", "W", 1.0, "heat by friction", kept<&V::frictionalPower>, following(10), nowhere,
       nowhere, following(8)},
      {"friction_work", "N m/m", 1.0, "heat by friction over the length rolled",
       kept<&V::frictionWork>, following(10), nowhere, nowhere, following(8)},
      {"t_gamma", "N m/m", 1.0, "forces and moment times creepages and spin, against them",
       kept<&V::tGamma>, following(10), nowhere, nowhere, following(8)},
      {"peak_traction", "MPa", MPa, "largest shear stress of the surface", kept<&V::peakTraction>,
       following(10), nowhere, following(10), following(8)},
      {"wear_volume", "mm3/m", mm3PerM, "worn off over the length rolled", kept<&V::wearVolume>,
       nowhere, nowhere, nowhere, nowhere, nowhere, nowhere, following(6)},
      {"wear_depth", "nm", nm, "worn off by one passage, across the track where it is most",
       kept<&V::wearDepth>, nowhere, nowhere, nowhere, nowhere, nowhere, nowhere, following(6)}};
  append(table, others);
  return table;
}

PatchValues patchValues(const PatchSolution &solved, const Eigen::VectorXd &worn)
{
  const PatchSums &sums = solved.sums;
  PatchValues values;
  values.load = solved.load;
  values.creepage = solved.creepage;
  values.forceX = sums.forceX;
  values.forceY = sums.forceY;
  values.momentZ = sums.momentZ;
  values.muMean = solved.mu.dot(solved.pressure) / solved.pressure.sum();
  values.temperatureRise = solved.contact.nominalMean(solved.temperature);
  values.setStick(sums.stickArea, sums.contactArea);
  values.approach = solved.approach;
  values.peakPressure = solved.pressure.maxCoeff();
  values.realArea = solved.contact.realArea(solved.pressure);
  values.frictionalPower = sums.frictionalPower * solved.speed;
  values.frictionWork = sums.frictionalPower;
  const Creepage &creep = solved.creepage;
  values.tGamma =
      0.0 - (creep.xi * sums.forceX + creep.eta * sums.forceY + creep.phi * sums.momentZ);
  const TangentialField &q = solved.tangential.traction;
  values.peakTraction = std::sqrt((q.x.array().square() + q.y.array().square()).maxCoeff());
  if (worn.size() > 0) {
    values.wearVolume = worn.sum() * solved.contact.grid.dy;
    values.wearDepth = worn.maxCoeff();
  }
  return values;
}

} // namespace wheelrail
