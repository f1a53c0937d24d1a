// SPDX-License-Identifier: GPL-2.0-or-later
/// \file units.h
/// LAMMPS's unit styles. No LAMMPS type in here.
#ifndef MCA_UNITS_H
#define MCA_UNITS_H

#include <string>

namespace mca {

/// Factors from the units of a run to nm, ns, MPa, kg/m^3, m/s, Pa s: those of friction logs, and
/// by which potential files in one unit style are read in another.
struct Units {
  /// nm, ns and MPa in one unit of the run.
  double length, time, stress;
  double nktv2p_mvv2e; ///< product of LAMMPS's own constants [-]; makes stress/density a velocity^2

  /// kg/m^3 in one unit of density of the run, as its equation of motion has it: in metal and real
  /// a density times a squared velocity is no pressure unit, which nktv2p_mvv2e mends.
  double density() const { return stress * 1e6 * nktv2p_mvv2e * (time / length) * (time / length); }
  /// m/s in one unit, nm/ns.
  double velocity() const { return length / time; }
  /// Pa s in one unit of stress times time.
  double viscosity() const { return stress * time * 1e-3; }
};

/// \param style  LAMMPS's unit style
/// \return nullptr when there are no such factors: lj has no units, in electron a velocity is not a
/// length over a time. Lives as long as the program
const Units *findUnits(const std::string &style);

} // namespace mca

#endif
