// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_FRICTION_LOG_FORMAT_H
#define MCAWR_SHARED_FRICTION_LOG_FORMAT_H

#include <array>
#include <string>

/// The friction log, format `mca-friction 1` (doc/friction_log.md): all that its writer (the
/// plugin) and its reader (wr_fit) have to agree on.
///
/// A log is text. It begins with lines `# SECTION: {KEY: VALUE, ...}` which, without `# `, are one
/// YAML document, the head. Then follow one line with the names of the columns and the rows,
/// separated by blanks. Units are those of `units` below, whatever the units of the run.
namespace mcawr::friction_log {

constexpr const char *extension = ".friction";
constexpr const char *headMark = "#";            ///< first letter of every line of the head
constexpr const char *format = "mca-friction 1"; ///< value of the first line, `# format: ...`

/// "# format: mca-friction 1", the first line of every log.
std::string formatLine();

/// Sections of the head, in the order in which they are written; the first line, `format`, is
/// before them, and `tools/campaign pack` adds `campaign` after them.
namespace section {
constexpr const char *program = "program";
constexpr const char *units = "units";
constexpr const char *material = "material";
constexpr const char *loading = "loading";
constexpr const char *geometry = "geometry";
constexpr const char *laws = "laws";
constexpr const char *run = "run";
} // namespace section

/// Units of a quantity in the head's section `units`.
struct Unit {
  const char *quantity, *unit;
};
constexpr std::array<Unit, 6> units = {{{"time", "ns"},
                                        {"length", "nm"},
                                        {"stress", "MPa"},
                                        {"velocity", "m/s"},
                                        {"density", "kg/m3"},
                                        {"viscosity", "Pa s"}}};

/// What a number of the head or of a row may be.
enum class Range {
  Positive,      ///< 1/largest to largest
  NotNegative,   ///< 0, or 1/largest to largest
  PoissonsRatio, ///< between -1 and 1/2, both excluded
  Whole          ///< a whole number from 0 to largest
};
/// Far beyond any run in these units; products of several such numbers do not overflow.
constexpr double largest = 1e12;

bool isIn(Range range, double value);
/// The range in words: "> 0 (MPa), 1e-12 to 1e+12". @param unit empty for pure numbers
std::string describe(Range range, const std::string &unit);

/// A number in the head.
struct HeadNumber {
  const char *section, *key;
  const char *unit; ///< empty: pure number
  Range range;
};
/// Those that a reader needs; every log has them except `run: seed`.
namespace head {
constexpr HeadNumber youngsModulus = {section::material, "youngs_modulus", "MPa", Range::Positive};
constexpr HeadNumber poissonsRatio = {section::material, "poissons_ratio", "",
                                      Range::PoissonsRatio};
constexpr HeadNumber density = {section::material, "density", "kg/m3", Range::Positive};
constexpr HeadNumber strength = {section::material, "strength", "MPa", Range::Positive};
constexpr HeadNumber viscosity = {section::material, "viscosity", "Pa s", Range::NotNegative};
constexpr HeadNumber pressure = {section::loading, "pressure", "MPa", Range::Positive};
constexpr HeadNumber velocity = {section::loading, "velocity", "m/s", Range::NotNegative};
constexpr HeadNumber seed = {section::run, "seed", "", Range::Whole};
/// Those that say more about the run.
constexpr HeadNumber elasticLimit = {section::material, "elastic_limit", "MPa", Range::Positive};
constexpr HeadNumber yieldStrength = {section::material, "yield_strength", "MPa", Range::Positive};
constexpr HeadNumber yieldStrain = {section::material, "yield_strain", "", Range::Positive};
constexpr HeadNumber breakingStrain = {section::material, "breaking_strain", "", Range::Positive};
constexpr HeadNumber width = {section::geometry, "width", "nm", Range::Positive};
constexpr HeadNumber thickness = {section::geometry, "thickness", "nm", Range::Positive};
constexpr HeadNumber diameter = {section::geometry, "diameter", "nm", Range::Positive};
constexpr HeadNumber automata = {section::geometry, "automata", "", Range::Whole};
constexpr HeadNumber timestep = {section::run, "timestep", "ns", Range::Positive};
constexpr HeadNumber every = {section::run, "every", "", Range::Whole};
} // namespace head
/// Name of the packing in the section `geometry`: hex in a plane; fcc, hcp, sc in space.
constexpr const char *packingKey = "packing";
/// Sections that tell what computed the run: a reader keeps them word by word.
constexpr std::array<const char *, 2> madeBySections = {section::program, section::laws};

/// Columns of a row in the order in which they are written; a reader goes by their names.
enum Column {
  Step,         ///< strictly increasing, evenly spaced, whole, >= 0
  Time,         ///< ns, end of the row's interval
  Displacement, ///< nm, of the driven layer
  ShearStress,  ///< MPa, mean over the row
  NormalStress, ///< MPa, mean over the row
  Mu,           ///< mean shear stress over the prescribed pressure
  Links,        ///< number now
  Broken,       ///< in the row
  Formed,       ///< in the row
  Gap,          ///< nm
  Columns
};
constexpr std::array<const char *, Columns> columnNames = {
    "step", "time",  "displacement", "shear_stress", "normal_stress",
    "mu",   "links", "broken",       "formed",       "gap"};

/// "step time displacement ...", the line below the head.
std::string columnLine();

} // namespace mcawr::friction_log
#endif
