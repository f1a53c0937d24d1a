// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/si.h"
#include "creep/patch/patch_point.h"

namespace wheelrail {
namespace {

using P = PatchPoint;

double shiftX(const P &point)
{
  return point.creepage.xi;
}
double shiftY(const P &point)
{
  return point.creepage.eta;
}
double twist(const P &point)
{
  return point.creepage.phi;
}
double ratioOf(const P &point)
{
  return point.tractionRatio();
}
double tractionOf(const P &point)
{
  return point.traction();
}

/// For the journal only: creep_band.csv names them after what they are of.
template<Band PatchBands::*Of>
void addBand(std::vector<Column<P>> &table, const char *of)
{
  const auto name = [&](const char *end) { return fmt::format("{}_{}", of, end); };
  table.push_back(
      {name("standard_error"), "1", 1.0, "", kept<&P::bands, Of, &Band::standardError>});
  table.push_back({name("low"), "1", 1.0, "", kept<&P::bands, Of, &Band::low>});
  table.push_back({name("high"), "1", 1.0, "", kept<&P::bands, Of, &Band::high>});
}

std::vector<Column<P>> makeTable()
{
  const std::vector<PlacedColumn<P>> own = {
      {"", {"speed", "m/s", 1.0, "rolling speed", kept<&P::speed>, leading(6), leading(6)}},
      {"load",
       {"shift_x", "mm", mm, "of the wheel against the rail, along x", derived<P>(shiftX), nowhere,
        nowhere, leading(10)}},
      {"shift_x",
       {"shift_y", "mm", mm, "of the wheel against the rail, along y", derived<P>(shiftY), nowhere,
        nowhere, leading(10)}},
      {"shift_y",
       {"twist", "1", 1.0, "turn of the wheel against the rail, rad", derived(twist), nowhere,
        nowhere, following(10)}},
      {"creep",
       {"traction_ratio", "1", 1.0, "T/N", derived<P>(ratioOf), leading(10), leading(10),
        leading(10)}},
      {"traction_ratio",
       {"traction", "N", 1.0, "T, the length of the force", derived(tractionOf), leading(10)}},
      {"temperature_rise",
       {"iterations", "1", 1.0, "of the fixed point; steps in mode moving", kept<&P::iterations>,
        leading(wholeDigits)}},
      {"real_area",
       {"temperature_max", "K", 1.0, "largest rise", kept<&P::temperatureMaximum>, following(10)}}};
  std::vector<Column<P>> table = extended(patchValueColumns(), own);
  const std::vector<Column<P>> others = {
      {"power_closure", "1", 1.0, "power over that of the drive", kept<&P::powerClosure>,
       following(6)},
      {"products", "1", 1.0, "of the solver, a measure of work", kept<&P::products>,
       following(wholeDigits)},
      {"force_x_se", "N", 1.0, "standard error of force_x", kept<&P::errorX>, nowhere, nowhere,
       nowhere, nowhere, following(4)},
      {"force_y_se", "N", 1.0, "standard error of force_y", kept<&P::errorY>, nowhere, nowhere,
       nowhere, nowhere, following(4)},
      {"moment_z_se", "N mm", newtonMm, "standard error of moment_z", kept<&P::errorZ>, nowhere,
       nowhere, nowhere, nowhere, following(4)},
      {"surface", "1", 1.0, "", kept<&P::surface>}};
  append(table, others);
  const std::vector<Column<P>> bandOfRatio = {
      {"standard_error", "1", 1.0, "of T/N, from the covariance of the law",
       kept<&P::bands, &PatchBands::tractionRatio, &Band::standardError>, nowhere, leading(6)},
      {"low", "1", 1.0, "lower end of the 95 % interval of T/N",
       kept<&P::bands, &PatchBands::tractionRatio, &Band::low>, nowhere, leading(10)},
      {"high", "1", 1.0, "upper end of the 95 % interval of T/N",
       kept<&P::bands, &PatchBands::tractionRatio, &Band::high>, nowhere, leading(10)}};
  append(table, bandOfRatio);
  addBand<&PatchBands::x>(table, "x");
  addBand<&PatchBands::y>(table, "y");
  addBand<&PatchBands::momentZ>(table, "moment_z");
  return table;
}

} // namespace

const std::vector<Column<PatchPoint>> &patchColumns()
{
  static const std::vector<Column<P>> table = makeTable();
  return table;
}

} // namespace wheelrail
