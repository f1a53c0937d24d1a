// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/wear.h"

#include "base/si.h"

namespace wheelrail {

double tGammaWear(double index)
{
  constexpr double severe = 10.4, catastrophic = 77.2; // N/mm2
  constexpr double mildSlope = 5.3, severeLoss = 55.0, steepSlope = 61.9;
  constexpr double microgramPerMetreMm2 = 1e-3; // in SI
  const double i = index / MPa;
  const double loss = i < severe          ? mildSlope * i
                      : i <= catastrophic ? severeLoss
                                          : severeLoss + steepSlope * (i - catastrophic);
  return microgramPerMetreMm2 * loss;
}

double WearLaw::depth(double pressure, double work, double slip) const
{
  switch (kind) {
  case Kind::Archard:
    return coefficient * pressure * slip / hardness;
  case Kind::TGamma:
    return tGammaWear(work) / density;
  default:
    return 0.0;
  }
}

} // namespace wheelrail
