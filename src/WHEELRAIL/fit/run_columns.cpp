// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/run_columns.h"

#include <algorithm>
#include <fmt/format.h>

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
  static const std::vector<RunColumn> table = {
      {"kappa1", own<&P::kappa1>, first(8)},
      {"kappa2", own<&P::kappa2>, first(8)},
      {"kappa3", own<&P::kappa3>, second(8)},
      {"mu", own<&P::mu>, first(6)},
      {"mu_se", own<&P::muSe>, first(4)},
      {"mu_se_own", own<&P::muOwn>, last(4)},
      {"t95", own<&P::t95>, notInCsv},
      {"n_eff", own<&P::nEff>, first(4)},
      {"t_start", own<&P::tStart>, first(6)},
      {"mu_grinding_in", own<&P::muGrindingIn>, first(6)},
      {"mu_eq2", own<&P::muEq2>, first(6)},
      {"correlation_time", own<&P::correlationTime>, notInCsv},
      {"mu_peak", own<&P::muPeak>, notInCsv},
      {"duration", own<&P::duration>, notInCsv},
      {"pressure", ofHead<&Head::pressure>, second(8)},
      {"velocity", ofHead<&Head::velocity>, second(8)},
      {"strength", ofHead<&Head::strength>, second(8)},
      {"youngs_modulus", youngsModulus, second(8), false},
      {"viscosity", ofHead<&Head::viscosity>, second(8)},
      {"poissons_ratio", ofHead<&Head::poissonsRatio>, last(8), false},
      {"density", ofHead<&Head::density>, last(8), false},
      {"breaking_strain", ofHead<&Head::breakingStrain>, last(8), false},
      {"seed", seed, second(wholeDigits), true, true},
      {"distance", ofHealth<&RunHealth::distance>, last(8)},
      {"start_distance", ofHealth<&RunHealth::startDistance>, notInCsv},
      {"gap", ofHealth<&RunHealth::gap>, last(6)},
      {"room", ofHealth<&RunHealth::room>, last(6)},
      {"least_room", ofHealth<&RunHealth::leastRoom>, notInCsv},
      {"lost", ofHealth<&RunHealth::lost>, last(6)},
      {"smooth", ofHealth<&RunHealth::smooth>, last(4)},
      {"fall", ofHealth<&RunHealth::fall>, notInCsv},
  };
  return table;
}

std::string runsAsCsv(const std::vector<FrictionRun> &runs)
{
  std::vector<RunColumn> columns;
  for (const RunColumn &column : runColumns())
    if (column.csv.digits > 0)
      columns.push_back(column);
  std::stable_sort(columns.begin(), columns.end(),
                   [](const RunColumn &a, const RunColumn &b) { return a.csv.rank < b.csv.rank; });
  std::string text = "# t_start in ns (nan: no stationary part found, mu of the second half), "
                     "pressure, strength and youngs_modulus in MPa, velocity in m/s, viscosity in "
                     "Pa s, density in kg/m^3, distance (slid in all) and gap in nm; the rest is "
                     "dimensionless\nfile";
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
