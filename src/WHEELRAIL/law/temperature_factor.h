// SPDX-License-Identifier: GPL-2.0-or-later
/// \file temperature_factor.h
/// mu(T) for any law: its mu times a factor of the temperature rise.
#ifndef WHEELRAIL_LAW_TEMPERATURE_FACTOR_H
#define WHEELRAIL_LAW_TEMPERATURE_FACTOR_H

#include "law/friction_law.h"

namespace wheelrail {

/// 1 up to a temperature rise, `hot` from another on, linear between them, as friction that falls
/// with the temperature is mostly given (law 6 of CONTACT's user guide, E. A. H. Vollebregt).
struct TemperatureFactor {
  double hot = 1.0;              ///< mu where it is hot over that where it is cold, > 0
  double start = 0.0, end = 1.0; ///< rises, K, 0 <= start < end

  /// \param rise of the temperature, K
  double at(double rise) const;
};

/// The law that makes mu of another one and multiplies it. What else there is to know, parameters
/// and covariance among it, is the other one's.
LawPointer heatedLaw(LawPointer cold, const TemperatureFactor &factor);

} // namespace wheelrail
#endif
