// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_SLIDING_VALUES_H
#define WHEELRAIL_CREEP_SWEEP_SLIDING_VALUES_H

#include "creep/sweep/columns.h"

namespace wheelrail {

/// What friction does in a contact, whatever its shape; SI units.
struct SlidingValues {
  double muMean = 0.0;          ///< load-weighted mean of mu
  double temperatureRise = 0.0; ///< mean over the nominal contact, K
  double stickFraction = 0.0;   ///< of the cells in contact, 0 .. 1

  /// From numbers of cells, or their areas: those that stick, and those in contact, > 0.
  void setStick(double sticking, double touching) { stickFraction = sticking / touching; }
};

/// Their columns, in the order of creep.csv.
inline std::vector<Column<SlidingValues>> slidingColumns()
{
  return {{"mu_mean", "1", 1.0, "friction coefficient, weighted with the load",
           kept<&SlidingValues::muMean>, leading(10), nowhere, leading(10), following(8)},
          {"temperature_rise", "K", 1.0, "mean over the nominal contact",
           kept<&SlidingValues::temperatureRise>, leading(10), nowhere, nowhere, following(8)},
          {"stick_fraction", "1", 1.0,
           "of the cells in contact; one minus it is the share that slips",
           kept<&SlidingValues::stickFraction>, leading(6), nowhere, leading(6), following(6)}};
}

} // namespace wheelrail
#endif
