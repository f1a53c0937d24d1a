// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_values.h"

namespace wheelrail {

std::vector<Column<PatchValues>> patchValueColumns()
{
  using V = PatchValues;
  constexpr double mm = 1e-3, mm2 = 1e-6, MPa = 1e6, newtonMm = 1e-3, perMm = 1e3; // in SI
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
       nowhere, following(8)}};
  append(table, others);
  return table;
}

PatchValues patchValues(const PatchSolution &solved)
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
  return values;
}

} // namespace wheelrail
