// SPDX-License-Identifier: GPL-2.0-or-later
#include "worn_contacts.h"

namespace mca {

double applyWornRule(const WornRule &rule, const Pairs &p, const Surfaces &surfaces, double dt)
{
  const bool slides = rule.is(WornRule::Slid), apart = rule.is(WornRule::Apart);
  const bool now = rule.is(WornRule::Now), never = rule.is(WornRule::Never);
  double more = 0.0;
  for (int k = 0; k < p.n; k++) {
    Block &block = p.blocks[k / blockLength];
    if (block.bulk && !block.moves)
      continue;
    const double before = p.now.kind[k], found = p.next.kind[k];
    double &next = p.next.kind[k], &slid = p.next.gammaTotal[0][k];
    if (link::isLinked(before)) {
      if (!now || link::isLinked(found))
        continue;
      next = link::none;
    } else if (before == link::worn) {
      const PairLaw &law = surfaces.laws[p.law[k]];
      double way = 0.0; // in diameters
      if (slides)
        way = p.now.gammaTotal[0][k] + length(surfaces.slip(p, k)) * dt * law.invDiameter;
      const bool open = p.eps[k] - p.now.plastic[k] >= 0.0, far = p.eps[k] >= law.breakingStrain;
      const bool fresh = now | far | (apart & open) | (slides & (way >= 1.0));
      const bool heals = found == link::bulk && !never;
      next = fresh ? link::none : heals ? link::bulk : link::worn;
      if (slides)
        slid = next == link::worn ? way : 0.0;
    } else {
      continue;
    }
    block.moves = true;
    more += (next == before ? 0.0 : 1.0) - (found == before ? 0.0 : 1.0);
  }
  return more;
}

} // namespace mca
