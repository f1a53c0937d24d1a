// SPDX-License-Identifier: GPL-2.0-or-later
/// \file units.h
/// LAMMPS's unit styles. No LAMMPS type in here.
#ifndef MCA_UNITS_H
#define MCA_UNITS_H

#include <string>

namespace mca {

/// Factors from the units of a run to nm, ns, MPa, kg/m^3, m/s, Pa s.
struct Units {
  double length, time, stress;
  double nktv2p_mvv2e; ///< product of LAMMPS's own constants [-]; makes stress/density a velocity^2

  double density() const { return stress * 1e6 * nktv2p_mvv2e * (time / length) * (time / length); }
  double velocity() const { return length / time; }
  double viscosity() const { return stress * time * 1e-3; } // MPa ns = 1e-3 Pa s
};

/// \param style LAMMPS's unit style
/// \return nullptr when there are no such factors: lj has no units, in electron a velocity is not
/// a length over a time
const Units *findUnits(const std::string &style);

} // namespace mca

#endif
