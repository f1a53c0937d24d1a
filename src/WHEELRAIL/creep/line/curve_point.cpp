// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/curve_point.h"

#include "base/si.h"

namespace wheelrail {
namespace {

using P = CurvePoint;

double tGammaOf(const P &point)
{
  return point.traction * point.creep;
}

std::vector<Column<P>> makeTable()
{
  const std::vector<PlacedColumn<P>> own = {
      {"", {"speed", "m/s", 1.0, "rolling speed", kept<&P::speed>, leading(6), leading(6)}},
      {"speed",
       {"creep", "1", 1.0, "sliding/rolling speed", kept<&P::creep>, leading(10), leading(10)}},
      {"traction_ratio", {"traction", "N/mm", newtonPerMm, "T", kept<&P::traction>, leading(10)}},
      {"temperature_rise",
       {"iterations", "1", 1.0, "of the fixed point; steps in mode moving", kept<&P::iterations>,
        leading(wholeDigits)}},
      {"peak_traction",
       {"temperature_max", "K", 1.0, "largest rise", kept<&P::temperatureMaximum>, following(10)}},
      {"temperature_max",
       {"t_gamma", "N/mm", newtonPerMm,
        "T times creep: work of the drive over the length rolled, of a mm across",
        derived(tGammaOf), following(10)}},
      // not in creep.csv
      {"friction_work", {"profile", "1", 1.0, "", kept<&P::profile>}},
      {"profile",
       {"standard_error", "1", 1.0, "of T/N, from the covariance of the law",
        kept<&P::band, &Band::standardError>, nowhere, leading(6)}},
      {"standard_error",
       {"low", "1", 1.0, "lower end of the 95 % interval of T/N", kept<&P::band, &Band::low>,
        nowhere, leading(10)}},
      {"low",
       {"high", "1", 1.0, "upper end of the 95 % interval of T/N", kept<&P::band, &Band::high>,
        nowhere, leading(10)}}};
  std::vector<Column<P>> table = extended(lineColumns(), own);
  for (Column<P> &column : table)
    column.still = column.series = nowhere; // a curve's point is in neither
  return table;
}

} // namespace

const std::vector<Column<CurvePoint>> &curveColumns()
{
  static const std::vector<Column<CurvePoint>> table = makeTable();
  return table;
}

} // namespace wheelrail
