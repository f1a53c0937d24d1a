// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_SOFTENING_MATERIAL_H
#define WHEELRAIL_LAW_SOFTENING_MATERIAL_H

#include "base/monotone_curve.h"

#include <string>
#include <vector>

namespace wheelrail {

/// What friction takes of a material, over its temperature: linear between the temperatures in
/// simulations, and with a continuous derivative (`MonotoneCurve`) in a contact, which agrees at
/// the temperatures themselves.
struct SofteningMaterial {
  std::string name;                ///< where the numbers come from
  std::vector<double> temperature; ///< K, rising, at least one
  std::vector<double> strength;    ///< sigma_0, Pa, > 0, as many
  std::vector<double> modulus;     ///< E, Pa, > 0, as many
  double density = 0.0;            ///< kg/m3, > 0

  double strengthAt(double kelvin) const { return MonotoneCurve{temperature, strength}(kelvin); }
  double modulusAt(double kelvin) const { return MonotoneCurve{temperature, modulus}(kelvin); }

  /// The lowest temperature at which a simulation had this strength and modulus.
  /// \param sigma, E Pa
  /// \return K; nan where there is none, to a thousandth
  double temperatureOf(double sigma, double E) const;
};

/// Reads a potential file of the automata (doc/potential_file.md) in units nano, si, micro or cgs:
/// the lines temperature, strength, youngs_modulus and density; its other keywords are left to
/// those who use them. A file without temperatures has one, 293 K.
/// \throws Error (BadInput) with file, line and keyword
SofteningMaterial readPotentialFile(const std::string &path);

} // namespace wheelrail
#endif
