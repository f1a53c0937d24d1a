// SPDX-License-Identifier: GPL-2.0-or-later
/// \file friction_log_head.h
/// The head of the friction log (format `mca-friction 1`, doc/friction_log.md): what it says of its
/// run, and whether a log's head is that of a run. No LAMMPS type in here.
#ifndef MCA_FRICTION_LOG_HEAD_H
#define MCA_FRICTION_LOG_HEAD_H

#include "files/units.h"
#include "laws/interface.h"
#include "laws/material.h"

#include <string>
#include <vector>

namespace mca {

/// Everything that the log says about its run, in units of the run; the log has it in nm, ns, MPa
/// and SI.
struct LogHeader {
  /// In the run's units; its values go to the head one by one. Of several that of the least
  /// strength, as use() sorts them.
  Material material;
  /// The others, by their strength.
  std::vector<Material> otherMaterials;
  /// Which of all, `material` first, the driven layer is of.
  std::size_t driven = 0;
  /// Interfaces between types that have automata.
  Interfaces interfaces;
  /// Sorts the materials of a sample; equal ones count once.
  /// \param all     of all types that have automata, at least one
  /// \param driven  of the driven layer, one of them
  void use(const std::vector<Material> &all, const Material &driven);
  /// Normal pressure [stress] and sliding velocity; of variables the first values.
  double pressure = 0.0, velocity = 0.0;
  /// Box length in x, and h of the discs or the box length in z [length].
  double width = 0.0, thickness = 0.0;
  /// Its name: hex, fcc, hcp, sc.
  std::string packing;
  /// In the whole sample.
  long long automata = 0;
  /// Keyword-value pairs as LawSet::words() gives them; an odd last word is left out.
  std::vector<std::string> laws;
  /// [time]
  double timestep = 0.0;
  /// Steps in a row; what the input script calls the seed of its roughness.
  long long every = 0, seed = 0;
  /// As LAMMPS counts it, a date YYYYMMDD.
  int lammpsVersion = 0;
  /// Keys whose value is the first one only: a loading given by a variable, a width that follows
  /// the automata.
  std::vector<std::string> varying;
};

/// The lines of the head, in the units of the log.
/// \throw std::runtime_error  a number that no reader takes (friction_log_format.h), with its range
std::string headOf(const LogHeader &, const Units &);

/// What keeps a log from going on with this run.
/// \param head  the log's lines before that of the columns
/// \return empty, or one line: what is in the log and what in the run. Numbers agree to 1e-9. The
///         versions, the number of automata and what varies may differ.
std::string differenceFrom(const std::string &head, const LogHeader &, const Units &);

/// Version of the program, and of LAMMPS, in a head, for messages.
std::string versionsIn(const std::string &head);

} // namespace mca

#endif
