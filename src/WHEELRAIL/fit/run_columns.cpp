// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/run_columns.h"

#include "base/unit_groups.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {
namespace {

using P = FrictionRun;

constexpr InCsv notInCsv{};
constexpr InCsv first(int digits)
{
  return {digits, 0};
}
constexpr InCsv second(int digits)
{
  return {digits, 1};
}
constexpr InCsv last(int digits)
{
  return {digits, 2};
}
constexpr int wholeDigits = 17; // all that a whole number may have

template<auto Member>
double own(const P &run)
{
  return run.*Member;
}
template<auto Member>
double ofHead(const P &run)
{
  return run.head.*Member;
}
template<auto Member>
double ofHealth(const P &run)
{
  return run.health.*Member;
}
double youngsModulus(const P &run)
{
  return run.youngsModulus();
}
double ductility(const P &run)
{
  return run.ductility();
}
double seed(const P &run)
{
  return static_cast<double>(run.seed());
}

/// A field of a CSV line, in quotes where its own characters ask for it (RFC 4180).
std::string csvField(const std::string &text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

} // namespace

const std::vector<RunColumn> &runColumns()
{
  using Head = mcawr::friction_log::Head;
  constexpr auto shared = InReport::AndConditions;
  static const std::vector<RunColumn> table = {
      {"kappa1", "1", own<&P::kappa1>, first(8), shared},
      {"kappa2", "1", own<&P::kappa2>, first(8), shared},
      {"kappa3", "1", own<&P::kappa3>, second(8), shared},
      {"mu", "1", own<&P::mu>, first(6)},
      {"mu_se", "1", own<&P::muSe>, first(4)},
      {"mu_se_own", "1", own<&P::muOwn>, last(4)},
      {"t95", "1", own<&P::t95>, notInCsv, shared},
      {"n_eff", "1", own<&P::nEff>, first(4)},
      {"t_start", "ns", own<&P::tStart>, first(6)},
      {"mu_grinding_in", "1", own<&P::muGrindingIn>, first(6)},
      {"mu_eq2", "1", own<&P::muEq2>, first(6), shared},
      {"correlation_time", "ns", own<&P::correlationTime>, notInCsv},
      {"mu_peak", "1", own<&P::muPeak>, notInCsv},
      {"duration", "ns", own<&P::duration>, notInCsv},
      {"pressure", "MPa", ofHead<&Head::pressure>, second(8), shared},
      {"velocity", "m/s", ofHead<&Head::velocity>, second(8), shared},
      {"strength", "MPa", ofHead<&Head::strength>, second(8), shared},
      {"youngs_modulus", "MPa", youngsModulus, second(8), InReport::No},
      {"viscosity", "Pa s", ofHead<&Head::viscosity>, second(8), shared},
      {"poissons_ratio", "1", ofHead<&Head::poissonsRatio>, last(8), InReport::No},
      {"density", "kg/m^3", ofHead<&Head::density>, last(8), InReport::No},
      {"breaking_strain", "1", ofHead<&Head::breakingStrain>, last(8), InReport::No},
      {"ductility", "1", ductility, last(8), shared},
      {"temperature", "K", own<&P::temperature>, last(6), InReport::No},
      {"seed", "1", seed, second(wholeDigits), InReport::Runs, true},
      {"distance", "nm", ofHealth<&RunHealth::distance>, last(8)},
      {"start_distance", "nm", ofHealth<&RunHealth::startDistance>, notInCsv},
      {"gap", "nm", ofHealth<&RunHealth::gap>, last(6)},
      {"room", "1", ofHealth<&RunHealth::room>, last(6)},
      {"least_room", "1", ofHealth<&RunHealth::leastRoom>, notInCsv},
      {"lost", "1", ofHealth<&RunHealth::lost>, last(6)},
      {"smooth", "1", ofHealth<&RunHealth::smooth>, last(4)},
      {"junctions", "1", ofHealth<&RunHealth::junctions>, notInCsv},
      {"drift", "1", ofHealth<&RunHealth::drift>, notInCsv},
      {"fall", "1", ofHealth<&RunHealth::fall>, notInCsv},
  };
  return table;
}

const RunColumn &runColumn(const std::string &name)
{
  for (const RunColumn &column : runColumns())
    if (column.name == name)
      return column;
  throw std::out_of_range("runColumn: no column " + name);
}

std::string runsAsCsv(const std::vector<FrictionRun> &runs)
{
  std::vector<RunColumn> columns;
  for (const RunColumn &column : runColumns())
    if (column.csv.digits > 0)
      columns.push_back(column);
  std::stable_sort(columns.begin(), columns.end(),
                   [](const RunColumn &a, const RunColumn &b) { return a.csv.rank < b.csv.rank; });
  std::vector<NamedUnit> units;
  for (const RunColumn &column : columns)
    units.push_back({column.name, column.unit});
  std::string text = "# " + unitsText(units) +
                     "; t_start is nan where there is no stationary part, mu is that of the second "
                     "half; temperature is nan where it is not known\nfile";
  for (const RunColumn &column : columns)
    text += fmt::format(",{}", column.name);
  text += "\n";
  for (const FrictionRun &run : runs) {
    text += csvField(run.file);
    for (const RunColumn &column : columns)
      text += fmt::format(",{:.{}g}", column.get(run), column.csv.digits);
    text += "\n";
  }
  return text;
}

} // namespace wheelrail
