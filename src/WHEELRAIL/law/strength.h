// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_STRENGTH_H
#define WHEELRAIL_LAW_STRENGTH_H

#include "base/monotone_curve.h"

#include <algorithm>
#include <memory>

namespace wheelrail {

/// Strength of the asperities, which falls with temperature: by the paper's Eq. 10, or as a table
/// of a material says; SI units.
struct Strength {
  double cold = 0.0;                 ///< sigma_0 at no temperature rise, Pa, > 0
  double vanishingTemperature = 0.0; ///< rise at which no strength is left, K, > 0; of a table the
                                     ///< rise at which it ends
  /// sigma_0 (Pa) over the temperature rise (K), up to which it never vanishes; null: Eq. 10.
  std::shared_ptr<const MonotoneCurve> table = nullptr;

  /// Eq. 10: sigma_0(Theta) = cold (1 - Theta/vanishingTemperature), or the table's value, Pa. Eq.
  /// 10 is kept above a thousandth of the cold strength, so that an iteration can pass through what
  /// a solution may not reach.
  /// \param rise Theta, K
  double at(double rise) const
  {
    if (table)
      return (*table)(rise);
    constexpr double weakest = 1e-3; // of the cold strength
    return cold * std::max(weakest, 1.0 - rise / vanishingTemperature);
  }

  /// Is no strength left? Never of a table.
  bool vanishesAt(double rise) const { return !table && rise >= vanishingTemperature; }

  /// 3 sigma_0(Theta), the pressure at which asperities yield (the paper, sec. 3), Pa.
  double hardnessAt(double rise) const
  {
    constexpr double hardnessOverStrength = 3.0;
    return hardnessOverStrength * at(rise);
  }
};

} // namespace wheelrail
#endif
