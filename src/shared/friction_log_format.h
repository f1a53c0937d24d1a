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
/// Everything here is a constant or a plain function, so that both programs are built from one
/// text; a change of the format needs a new number in `format`.
namespace mcawr::friction_log {

/// Ending of a log's file name.
constexpr const char *extension = ".friction";
constexpr const char *headMark = "#";            ///< first letter of every line of the head
constexpr const char *format = "mca-friction 1"; ///< value of the first line, `# format: ...`

/// "# format: mca-friction 1", the first line of every log.
std::string formatLine();

/// Sections of the head, in the order in which they are written; the first line, `format`, is
/// before them, and `tools/campaign pack` adds `campaign` after them.
/// Each section is one line of the head.
namespace section {
/// Name and version of what wrote the log.
constexpr const char *program = "program";
/// The table `units` below, so that a log can be read without this program.
constexpr const char *units = "units";
/// Elastic constants, strength, density, viscosity of the automata.
constexpr const char *material = "material";
/// Prescribed pressure and sliding velocity.
constexpr const char *loading = "loading";
/// Packing, size of the automata and of the sample.
constexpr const char *geometry = "geometry";
/// Interaction laws of the run: what was chosen, by keyword.
constexpr const char *laws = "laws";
/// Seed, time step and number of steps to a row.
constexpr const char *run = "run";
} // namespace section

/// Units of a quantity in the head's section `units`.
/// One system for all logs: numbers near 1 for samples of nanometres that slide at metres a second.
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
/// Every range refuses what is not finite.
enum class Range {
  Positive,      ///< 1/largest to largest
  NotNegative,   ///< 0, or 1/largest to largest
  Signed,        ///< 0, or 1/largest to largest of either sign
  PoissonsRatio, ///< between -1 and 1/2, both excluded
  Whole,         ///< a whole number from 0 to largest
  SignedWhole    ///< a whole number of either sign, at most largestWhole
};
/// Far beyond any run in these units; products of several such numbers do not overflow.
constexpr double largest = 1e12;
/// Below 2^53, so that a double holds every whole number up to it.
constexpr double largestWhole = 9e15;

/// One test for both sides: the plugin writes no log with a number outside its range, and wr_fit
/// reads every log whose numbers are within theirs.
/// @param value in the unit of its `HeadNumber`
bool isIn(Range range, double value);
/// The same for the numbers of a row: finite, within +-largest; `Step` is whole and >= 0.
bool isInRow(double value);
/// The range in words: "> 0 (MPa), 1e-12 to 1e+12". @param unit empty for pure numbers
/// @return a half-sentence for messages: what is allowed
std::string describe(Range range, const std::string &unit);

/// A number in the head.
/// The reader refuses a number outside its range with file, line, key, value and `describe`'s
/// words.
struct HeadNumber {
  const char *section, *key;
  const char *unit; ///< empty: pure number
  Range range;
};
/// Those that a reader needs; every log has them except `run: seed`.
namespace head {
/// E and Poisson's ratio: elastic constants of the material, of all automata alike.
constexpr HeadNumber youngsModulus = {section::material, "youngs_modulus", "MPa", Range::Positive};
constexpr HeadNumber poissonsRatio = {section::material, "poissons_ratio", "",
                                      Range::PoissonsRatio};
/// rho and eta of the material; without viscosity its number is 0.
constexpr HeadNumber density = {section::material, "density", "kg/m3", Range::Positive};
/// sigma_0 of the paper (Bucher et al. 2006), which all kappas are made with: kappa3 = E/sigma_0.
constexpr HeadNumber strength = {section::material, "strength", "MPa", Range::Positive};
constexpr HeadNumber viscosity = {section::material, "viscosity", "Pa s", Range::NotNegative};
/// Normal stress p that the run prescribes: kappa2 = p E/sigma_0^2. At 0 the column mu is 0.
constexpr HeadNumber pressure = {section::loading, "pressure", "MPa", Range::NotNegative};
/// Of the driven layer along x, v: kappa1 = rho E v^2/sigma_0^2. The layer may be driven backwards;
/// shear stress and mu are negative then.
constexpr HeadNumber velocity = {section::loading, "velocity", "m/s", Range::Signed};
/// Of the random numbers; runs that differ in it only are replicates.
constexpr HeadNumber seed = {section::run, "seed", "", Range::SignedWhole};
/// Those that say more about the run.
/// First and second yield stress of the response function and the strains that go with them.
constexpr HeadNumber elasticLimit = {section::material, "elastic_limit", "MPa", Range::Positive};
constexpr HeadNumber yieldStrength = {section::material, "yield_strength", "MPa", Range::Positive};
constexpr HeadNumber yieldStrain = {section::material, "yield_strain", "", Range::Positive};
constexpr HeadNumber breakingStrain = {section::material, "breaking_strain", "", Range::Positive};
/// Size of the sample and diameter of an automaton, nm; number of automata.
constexpr HeadNumber width = {section::geometry, "width", "nm", Range::Positive};
constexpr HeadNumber thickness = {section::geometry, "thickness", "nm", Range::Positive};
constexpr HeadNumber diameter = {section::geometry, "diameter", "nm", Range::Positive};
constexpr HeadNumber automata = {section::geometry, "automata", "", Range::Whole};
/// Time step of the run, and steps from one row to the next.
constexpr HeadNumber timestep = {section::run, "timestep", "ns", Range::Positive};
constexpr HeadNumber every = {section::run, "every", "", Range::Whole};
} // namespace head
/// Name of the packing in the section `geometry`: hex in a plane; fcc, hcp, sc in space.
constexpr const char *packingKey = "packing";
/// Sections that tell what computed the run: a reader keeps them word by word.
constexpr std::array<const char *, 2> madeBySections = {section::program, section::laws};
/// What is simulated: runs that agree in these sections, in those above and in the time step are
/// replicas of one condition.
constexpr std::array<const char *, 3> conditionSections = {section::material, section::loading,
                                                           section::geometry};
constexpr const char *timestepKey = "timestep"; ///< of the section `run`, ns

/// Columns of a row in the order in which they are written; a reader goes by their names.
/// A row is the mean over, or the state at the end of, the steps since the row before.
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
/// Element k is the name of Column k.
constexpr std::array<const char *, Columns> columnNames = {
    "step", "time",  "displacement", "shear_stress", "normal_stress",
    "mu",   "links", "broken",       "formed",       "gap"};

/// Name of the column behind these, which finds damage and what was changed: CRC-32
/// (`RunningChecksum`) of all bytes of the file before the number, which is decimal. Readers take
/// logs without it.
constexpr const char *checkName = "check";
constexpr int columnsWritten = Columns + 1; ///< with it

/// "step time displacement ... check", the line below the head.
/// A reader finds its columns by the names in this line, whatever their order.
std::string columnLine();

} // namespace mcawr::friction_log
#endif
