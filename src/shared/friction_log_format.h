// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_FRICTION_LOG_FORMAT_H
#define MCAWR_SHARED_FRICTION_LOG_FORMAT_H

#include <array>
#include <cstddef>
#include <stdexcept>
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
/// before them, and `tools/campaign pack` adds `campaignSection` after them.
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
/// \param value in the unit of its `HeadNumber`
bool isIn(Range range, double value);
/// Whether a number may stand in a row: finite, within +-largest; `step` is whole and >= 0.
bool isInRow(double value);
/// The range in words: "> 0 (MPa), 1e-12 to 1e+12".
/// \param unit empty for pure numbers
/// \return a half-sentence for messages: what is allowed
std::string describe(Range range, const std::string &unit);

/// What a log says of its run in numbers, in the units above; whole ones, too, are doubles, which
/// hold them exactly. `headNumbers` says where each stands in a log, and what it may be.
struct Head {
  double youngsModulus = 0.0, poissonsRatio = 0.0, density = 0.0;
  double elasticLimit = 0.0, yieldStrength = 0.0, yieldStrain = 0.0;
  double strength = 0.0, breakingStrain = 0.0, viscosity = 0.0;
  double pressure = 0.0, velocity = 0.0;
  double width = 0.0, thickness = 0.0, diameter = 0.0, automata = 0.0;
  double timestep = 0.0, every = 0.0, seed = 0.0;
};

/// A number in the head.
/// The reader refuses a number outside its range with file, line, key, value and `describe`'s
/// words.
struct HeadNumber {
  double Head::*value;
  const char *section, *key;
  const char *unit; ///< empty: pure number
  Range range;
  bool needed; ///< by readers: a log without it is refused; the others say more about the run
  const char *meaning;
};
/// In the order in which they are written; a section's stand together.
constexpr std::array<HeadNumber, 18> headNumbers = {{
    {&Head::youngsModulus, section::material, "youngs_modulus", "MPa", Range::Positive, true,
     "E, of all automata alike"},
    {&Head::poissonsRatio, section::material, "poissons_ratio", "", Range::PoissonsRatio, true,
     "nu"},
    {&Head::density, section::material, "density", "kg/m3", Range::Positive, true, "rho"},
    {&Head::elasticLimit, section::material, "elastic_limit", "MPa", Range::Positive, false,
     "first yield stress of the response function"},
    {&Head::yieldStrength, section::material, "yield_strength", "MPa", Range::Positive, false,
     "its second yield stress"},
    {&Head::yieldStrain, section::material, "yield_strain", "", Range::Positive, false,
     "total strain at the second yield stress"},
    {&Head::strength, section::material, "strength", "MPa", Range::Positive, true,
     "sigma_0 of Bucher et al. (2006), which all kappas are made with: kappa3 = E/sigma_0"},
    {&Head::breakingStrain, section::material, "breaking_strain", "", Range::Positive, false,
     "total strain at the strength"},
    {&Head::viscosity, section::material, "viscosity", "Pa s", Range::NotNegative, true,
     "eta; without viscosity 0"},
    {&Head::pressure, section::loading, "pressure", "MPa", Range::NotNegative, true,
     "prescribed normal stress p: kappa2 = p E/sigma_0^2; at 0 the column mu is 0"},
    {&Head::velocity, section::loading, "velocity", "m/s", Range::Signed, true,
     "of the driven layer along x, v: kappa1 = rho E v^2/sigma_0^2; the layer may be driven "
     "backwards, then shear stress and mu are negative"},
    {&Head::width, section::geometry, "width", "nm", Range::Positive, false, "of the sample in x"},
    {&Head::thickness, section::geometry, "thickness", "nm", Range::Positive, false,
     "of the sample in z, or of the discs"},
    {&Head::diameter, section::geometry, "diameter", "nm", Range::Positive, false,
     "of an automaton"},
    {&Head::automata, section::geometry, "automata", "", Range::Whole, false, "their number"},
    {&Head::timestep, section::run, "timestep", "ns", Range::Positive, false, "of the run"},
    {&Head::every, section::run, "every", "", Range::Whole, false, "steps in a row"},
    {&Head::seed, section::run, "seed", "", Range::SignedWhole, false,
     "of the random numbers; runs that differ in it only are replicates"},
}};
/// The row of one of them.
/// \throw std::logic_error  it has none
constexpr const HeadNumber &headNumber(double Head::*value)
{
  for (const HeadNumber &number : headNumbers)
    if (number.value == value)
      return number;
  throw std::logic_error("a number without a row in the head");
}

/// Where a sample has several materials, `material` is that of the least strength, which all kappas
/// are made with. Each other one, in the order of strength, has a section with the same keys behind
/// it: this name, then with `_2`, `_3` and so on. In all of them a last key says whether it is that
/// of the driven layer or of another part.
constexpr const char *otherMaterial = "other_material", *layerKey = "layer";
/// What two types of automata have of their own where they meet (pair_coeff interface): a section
/// for each, this name, then with `_2` and so on; a first key names the types, "1 2".
constexpr const char *interfaceSection = "interface", *typesKey = "types";
/// The section of packed logs, its key of the command that repeats the run, and that of the
/// temperature (K) at which a plan took the material, where it did.
constexpr const char *campaignSection = "campaign", *commandKey = "command",
                     *temperatureKey = "temperature";
/// The packing in the section `geometry`, before `automata`: hex in a plane; fcc, hcp, sc in space.
constexpr const char *packingKey = "packing";
/// Sections that tell what computed the run: a reader keeps them word by word.
constexpr std::array<const char *, 2> madeBySections = {section::program, section::laws};
/// What is simulated: runs that agree in these sections, in those above and in the time step are
/// replicas of one condition.
constexpr std::array<const char *, 3> conditionSections = {section::material, section::loading,
                                                           section::geometry};

/// A row: the mean over, or the state at the end of, the steps since the row before.
struct Row {
  double step = 0.0; ///< whole
  double time = 0.0, displacement = 0.0;
  double shearStress = 0.0, normalStress = 0.0, mu = 0.0;
  double links = 0.0, broken = 0.0, formed = 0.0, gap = 0.0;
  double room = 0.0, lost = 0.0;
  double flowEnergy = 0.0, breakingEnergy = 0.0, contactEnergy = 0.0;
};

/// What a row's number stands for; packing several rows to one takes means, sums or the last one.
enum class Over { End, Mean, Sum };

/// A column. The first `columnsNeeded` are in every log; readers take logs without the others.
struct Column {
  double Row::*value;
  const char *name;
  const char *unit; ///< empty: pure number
  Over over;
  int digits; ///< that are written
  const char *meaning;
};
/// In the order in which they are written; a reader goes by their names.
constexpr std::array<Column, 15> columns = {{
    {&Row::step, "step", "", Over::End, 15, "strictly increasing, evenly spaced, whole, >= 0"},
    {&Row::time, "time", "ns", Over::End, 10, "end of the row's interval"},
    {&Row::displacement, "displacement", "nm", Over::End, 10, "of the driven layer in x"},
    {&Row::shearStress, "shear_stress", "MPa", Over::Mean, 8, "on the driven layer, -F_x/A"},
    {&Row::normalStress, "normal_stress", "MPa", Over::Mean, 8, "on the driven layer, F_y/A"},
    {&Row::mu, "mu", "", Over::Mean, 8, "shear stress over the prescribed pressure"},
    {&Row::links, "links", "", Over::End, 10, "number of links of both kinds"},
    {&Row::broken, "broken", "", Over::Sum, 10, "links that broke"},
    {&Row::formed, "formed", "", Over::Sum, 10, "contacts that became links"},
    {&Row::gap, "gap", "nm", Over::End, 8, "rise of the driven layer since its start"},
    {&Row::room, "room", "", Over::End, 8,
     "area (in space: volume) of an automaton between the innermost held and driven rows over that "
     "in the unloaded solid; 0 where nothing is held"},
    {&Row::lost, "lost", "", Over::End, 10,
     "free automata above the driven, or below the held layer"},
    {&Row::flowEnergy, "flow_energy", "MPa nm3", Over::End, 10,
     "what plastic flow has dissipated, by compute mca/energy; without it 0, as the next two"},
    {&Row::breakingEnergy, "breaking_energy", "MPa nm3", Over::End, 10,
     "what the breaking of links has dissipated"},
    {&Row::contactEnergy, "contact_energy", "MPa nm3", Over::End, 10,
     "what unlinked contacts have dissipated"},
}};
constexpr std::size_t columnsNeeded = 10; ///< up to `gap`

/// Name of the column behind these, which finds damage and what was changed: CRC-32
/// (`RunningChecksum`) of all bytes of the file before the number, which is decimal. Readers take
/// logs without it.
constexpr const char *checkName = "check";
constexpr std::size_t columnsWritten = columns.size() + 1; ///< with it

/// "step time displacement ... check", the line below the head.
/// A reader finds its columns by the names in this line, whatever their order.
std::string columnLine();

} // namespace mcawr::friction_log
#endif
