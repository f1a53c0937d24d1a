// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/drive_sums.h"

namespace mca {

void DriveSums::add(const DrivenLayer &layer, const DrivenLayer::Stress &stress, double velocity,
                    double dt)
{
  displacement += velocity * dt;
  work += layer.work(stress.shear, velocity, dt);
  shearSum += stress.shear;
  normalSum += stress.normal;
  samples += 1.0;
}

LogRow DriveSums::row(const Totals &all, const State &now, long long step, double dt,
                      double pressure, const Units &units) const
{
  const double shear = all.shearSum / samples, normal = all.normalSum / samples;
  LogRow row;
  row.step = static_cast<double>(step);
  row.time = row.step * dt * units.time;
  row.displacement = displacement * units.length;
  row.shearStress = shear * units.stress;
  row.normalStress = normal * units.stress;
  row.mu = pressure > 0.0 ? shear / pressure : 0.0;
  row.links = all.links;
  row.broken = all.broken - brokenBefore;
  row.formed = all.formed - formedBefore;
  row.gap = (now.height - startHeight) * units.length;
  row.room = now.room;
  row.lost = now.lost;
  const double energy = units.stress * units.length * units.length * units.length;
  row.flowEnergy = now.dissipated[0] * energy;
  row.breakingEnergy = now.dissipated[1] * energy;
  row.contactEnergy = now.dissipated[2] * energy;
  return row;
}

void DriveSums::beginRow(const Totals &all)
{
  shearSum = normalSum = samples = 0.0;
  brokenBefore = all.broken;
  formedBefore = all.formed;
}

void DriveSums::gather(const Totals &all, bool first)
{
  work = first ? all.work : 0.0;
  shearSum = first ? all.shearSum : 0.0;
  normalSum = first ? all.normalSum : 0.0;
}

} // namespace mca
