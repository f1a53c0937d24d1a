// SPDX-License-Identifier: GPL-2.0-or-later
/// \file automaton_states.h
/// What an automaton carries with it beside place, velocity and angular velocity: one table, from
/// which follow the custom properties of LAMMPS that hold these values, the words of restart files
/// and of mca_links files, and the attributes of compute mca/atom.
///
/// All of them move with their automaton between ranks, stand in restart files with a checksum and
/// in the files of mca_links, and end with it; a new automaton begins with 0. A state that is added
/// is a line of this table, beside the code that uses it, as
/// `pair->state(mca::stateNumber("kappa"))[i]`, and, if it is shown, its line on the page of
/// compute mca/atom. The order of the lines is that of restart files.
#ifndef MCA_AUTOMATON_STATES_H
#define MCA_AUTOMATON_STATES_H

#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mca {

/// Dimensions in which something exists: in none, in the plane, in space, in both. None is for what
/// compute mca/atom does not show.
enum class In { None, Plane, Space, Both };

/// Whether that is so in this dimension.
/// \param dimension  2 or 3; all but 2 counts as space
inline constexpr bool existsIn(In dimensions, int dimension)
{
  return dimensions == In::Both || dimensions == (dimension == 2 ? In::Plane : In::Space);
}

/// When a state is up to date.
enum class Upkeep {
  EveryStep, ///< after each step
  Commands,  ///< always: only commands change it
  /// After PairMCA::collect_changes(); a step keeps what it adds.
  Collected,
  /// After a run and when a restart file is written, for the next set-up.
  EndOfRun
};

/// A number that each automaton carries: a column of LAMMPS's custom values, type double, of own
/// automata and ghosts. PairMCA::state() gives it, nullptr where the state does not exist in the
/// dimension of the run.
struct AutomatonState {
  const char *name;      ///< of the property, d_mca_NAME, and in the files of mca_links
  In exists;             ///< dimensions in which automata carry it
  Upkeep upkeep;         ///< when it is up to date
  const char *attribute; ///< its name in compute mca/atom; nullptr: not shown there
  In shown;              ///< dimensions in which it is shown
  const char *unit;      ///< as the pages name it; empty for a plain number
  const char *meaning;   ///< as the page of compute mca/atom says it
  bool always = true;    ///< false: carried only where laws see angular velocities
};

/// The table. kappa is that of Plasticity in doc/laws.md; lag and rest are what pair_mca keeps of
/// the velocities between runs; of angular velocities only where forces depend on them.
inline constexpr AutomatonState automatonStates[] = {
    /// Begins with 0 and only grows; Step::commit() adds what the yield passes found.
    {"kappa", In::Both, Upkeep::EveryStep, "plastic", In::Both, "", "equivalent plastic strain"},
    /// Moved on by fix nve/mca, in the plane only: in space it stays 0.
    {"theta", In::Both, Upkeep::EveryStep, "theta", In::Plane, "radians",
     "angle of rotation since the beginning"},
    /// Kept by keepLag() of core/step.h: with them the set-up of the next run, whose velocities are
    /// half a step later than those of the last forces, computes these forces again to the last
    /// bit.
    {"lag_x", In::Both, Upkeep::EndOfRun, nullptr, In::None, "velocity units",
     "velocity less that which the forces saw"},
    {"lag_y", In::Both, Upkeep::EndOfRun, nullptr, In::None, "velocity units", "the same along y"},
    {"rest_x", In::Both, Upkeep::EndOfRun, nullptr, In::None, "velocity units",
     "what rounding took from the lag"},
    {"rest_y", In::Both, Upkeep::EndOfRun, nullptr, In::None, "velocity units", "the same along y"},
    {"lag_z", In::Space, Upkeep::EndOfRun, nullptr, In::None, "velocity units", "the same along z"},
    {"rest_z", In::Space, Upkeep::EndOfRun, nullptr, In::None, "velocity units",
     "the same along z"},
    /// Counted by mca_links create and read, less by delete; the damage of compute mca/atom is the
    /// share of them that no longer holds.
    {"links0", In::Both, Upkeep::Commands, nullptr, In::None, "", "number of original links"},
    /// Each link that breaks or forms counts once at either of its automata.
    {"broken", In::Both, Upkeep::Collected, "broken", In::Both, "",
     "number of its links that broke"},
    {"formed", In::Both, Upkeep::Collected, "formed", In::Both, "",
     "number of links that it formed by contact"},
    /// Begins with 0; Step::run() adds what breaking links leave and lets it go again.
    {"kept", In::Both, Upkeep::EveryStep, nullptr, In::None, "",
     "sum of normal strains that broken links left to its mean stress"},
    {"spin_lag_x", In::Space, Upkeep::EndOfRun, nullptr, In::None, "radians/time",
     "angular velocity less that which the forces saw", false},
    {"spin_lag_y", In::Space, Upkeep::EndOfRun, nullptr, In::None, "radians/time",
     "the same about y", false},
    {"spin_lag_z", In::Both, Upkeep::EndOfRun, nullptr, In::None, "radians/time",
     "the same about z", false},
    {"spin_rest_x", In::Space, Upkeep::EndOfRun, nullptr, In::None, "radians/time",
     "what rounding took from the lag", false},
    {"spin_rest_y", In::Space, Upkeep::EndOfRun, nullptr, In::None, "radians/time",
     "the same about y", false},
    {"spin_rest_z", In::Both, Upkeep::EndOfRun, nullptr, In::None, "radians/time",
     "the same about z", false},
};

/// Number of lines of the table, of those of both dimensions.
inline constexpr int stateCount = static_cast<int>(std::size(automatonStates));

/// Number of a state in the table, from 0; a name that is not there does not compile where the
/// number is a constexpr. In loops the number is taken once, before them.
/// \param name  without the prefix mca_
/// \throw std::logic_error  there is no such state, and the number is no constexpr
constexpr int stateNumber(std::string_view name)
{
  for (int k = 0; k < stateCount; k++)
    if (name == automatonStates[k].name)
      return k;
  throw std::logic_error("automata have no such state");
}

/// Name of the custom property of LAMMPS that holds a state, "mca_NAME", as atom->find_custom()
/// wants it; dumps show it as d_mca_NAME. All are of LAMMPS's type double.
inline std::string propertyName(const AutomatonState &state)
{
  return std::string("mca_") + state.name;
}

/// Words of fix property/atom for the states of a dimension: "d_mca_NAME" with blanks in between,
/// in the order of the table, hence in that of restart files.
/// \param dimension  2 or 3
/// \param always     those that are always carried, or the others
inline std::string propertyWords(int dimension, bool always = true)
{
  std::string words;
  for (const AutomatonState &state : automatonStates)
    if (existsIn(state.exists, dimension) && state.always == always)
      words += (words.empty() ? "d_" : " d_") + propertyName(state);
  return words;
}

} // namespace mca

#endif
