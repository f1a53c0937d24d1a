// SPDX-License-Identifier: GPL-2.0-or-later
#include "driven_layer.h"

namespace mca {

DrivenLayer::Pull DrivenLayer::pull(const Arrays &a) const
{
  Pull sum;
  for (const int i : members) {
    sum.x += a.f[i][0];
    sum.y += a.f[i][1];
    sum.momentum += a.mass[i] * a.v[i][1];
  }
  return sum;
}

DrivenLayer::Stress DrivenLayer::stress(const Pull &pull) const
{
  const double unit = stressUnit / area;
  return {-pull.x * unit, pull.y * unit};
}

void DrivenLayer::carry(const Arrays &a, const Pull &whole, const Load &load) const
{
  const double weight = load.pressure * area / stressUnit;
  const double perMass = (whole.y - weight) / mass, vy = whole.momentum / mass;
  for (const int i : members) {
    a.f[i][0] = a.f[i][2] = a.v[i][2] = 0.0;
    for (int m = 0; m < 3; m++)
      a.torque[i][m] = a.omega[i][m] = 0.0;
    a.f[i][1] = perMass * a.mass[i];
    a.v[i][0] = load.velocity;
    a.v[i][1] = vy;
  }
}

} // namespace mca
