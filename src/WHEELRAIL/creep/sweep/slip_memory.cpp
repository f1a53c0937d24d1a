// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/slip_memory.h"

#include <cmath>

namespace wheelrail {

using Vector = Eigen::VectorXd;

double SlipMemory::left(const Vector &slip, int cell) const
{
  return std::exp(-std::abs(slip[cell]) * grid_.dx / length_);
}

// A law has one sliding speed a call: cells that slide are asked for one by one.
Vector SlipMemory::targets(const FrictionLaw &law, const Vector &pressure,
                           const Vector &temperature, double speed, const Vector &slip) const
{
  const Vector still = law.mu({pressure, 0.0, temperature});
  Vector ratio = Vector::Ones(pressure.size());
  Vector p(1), heat(1);
  for (int i = 0; i < pressure.size(); ++i) {
    const double slides = std::abs(slip[i]);
    if (!(pressure[i] > 0.0) || slides == 0.0)
      continue;
    p[0] = pressure[i];
    heat[0] = temperature[i];
    ratio[i] = law.mu({p, speed * slides, heat})[0] / still[i];
  }
  return ratio;
}

Vector SlipMemory::steady(const FrictionLaw &law, const Vector &pressure, const Vector &temperature,
                          double speed, const Vector &slip) const
{
  const Vector target = targets(law, pressure, temperature, speed, slip);
  Vector ratio = Vector::Ones(pressure.size());
  for (int iy = 0; iy < grid_.ny; ++iy) {
    double incoming = 1.0;
    for (int ix = grid_.nx - 1; ix >= 0; --ix) {
      const int i = grid_.index(ix, iy);
      const double rest = pressure[i] > 0.0 ? left(slip, i) : 1.0; // as in after()
      // the friction of a cell is that in its middle
      ratio[i] = target[i] + (incoming - target[i]) * std::sqrt(rest);
      incoming = target[i] + (incoming - target[i]) * rest;
    }
  }
  return ratio;
}

Vector SlipMemory::after(const Vector &before, const FrictionLaw &law, const Vector &pressure,
                         const Vector &temperature, double speed, const Vector &slip) const
{
  const Vector target = targets(law, pressure, temperature, speed, slip);
  Vector ratio = before;
  for (int i = 0; i < ratio.size(); ++i)
    if (pressure[i] > 0.0)
      ratio[i] = target[i] + (ratio[i] - target[i]) * left(slip, i);
  return ratio;
}

Vector SlipMemory::mu(const FrictionLaw &law, const Vector &pressure, const Vector &temperature,
                      const Vector &ratio)
{
  return law.mu({pressure, 0.0, temperature}).cwiseProduct(ratio);
}

} // namespace wheelrail
