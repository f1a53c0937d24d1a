// SPDX-License-Identifier: GPL-2.0-or-later
/// \file law_keywords.h
/// The exchangeable laws that are chosen by one keyword each, but for the criterion of fracture
/// (fracture_law.h). Each says what it is called, what it takes, where it acts and what follows
/// from the choice; the equations stand in the headers named.
#ifndef MCA_LAWS_LAW_KEYWORDS_H
#define MCA_LAWS_LAW_KEYWORDS_H

#include "keyword.h"

#include <algorithm>

namespace mca {

/// What holds across the plane; plane.h.
struct PlaneWords {
  static constexpr const char *keyword = "plane";
  enum Kind { Strain, Stress };
  static constexpr Option options[] = {{"strain"}, {"stress", false}};
};
using PlaneCondition = Choice<PlaneWords>;

/// With many-body a mean stress of all contacts, pairwise without: plane Poisson's ratio 0;
/// elasticity.h.
struct ElasticityWords {
  static constexpr const char *keyword = "elasticity";
  enum Kind { ManyBody, Pairwise };
  static constexpr Option options[] = {{"many-body"}, {"pairwise"}};
};
using Elasticity = Choice<ElasticityWords>;

/// Flow of automata; plasticity.h, plane.h. In space radial keeps the volume, and j2 is the same.
struct PlasticityWords {
  static constexpr const char *keyword = "plasticity";
  enum Kind { Radial, J2, None };
  static constexpr Option options[] = {{"radial"}, {"j2"}, {"none"}};
};
using Plasticity = Choice<PlasticityWords>;

/// Of unlinked contacts; viscosity.h.
struct ViscosityWords {
  static constexpr const char *keyword = "viscosity";
  enum Kind { Normal, None };
  static constexpr Option options[] = {{"normal"}, {"none"}};
};
using ViscosityLaw = Choice<ViscosityWords>;

/// secondReturn() and centredSeparation(), or neither.
struct StepsWords {
  static constexpr const char *keyword = "steps";
  enum Kind { Corrected, Plain };
  static constexpr Option options[] = {{"corrected"}, {"plain"}};
};
using Steps = Choice<StepsWords>;

// The transitions of linking.h; multiples of the strength sigma_0 of the weaker material.

/// Compression that links an unlinked contact.
struct LinkWords {
  static constexpr const char *keyword = "link", *materialStress = "elastic_limit";
  static Threshold initial() { return Threshold::ofMaterial(); }
  /// sigma_y1 [stress]
  static double stress(const Material &i, const Material &j)
  {
    return std::min(i.sigmaY1(), j.sigmaY1());
  }
};
using LinkLaw = ThresholdLaw<LinkWords>;

/// Strength of welds; off: contacts become bulk links at once.
struct WeldWords {
  static constexpr const char *keyword = "weld", *materialStress = nullptr;
  static Threshold initial() { return Threshold::times(1.0); }
};
using WeldLaw = ThresholdLaw<WeldWords>;

/// Compression that turns a weld into a bulk link.
struct HealWords {
  static constexpr const char *keyword = "heal", *materialStress = "hardness";
  static Threshold initial() { return Threshold::ofMaterial(); }
  /// 3 sigma_y2 (Tabor) [stress]
  static double stress(const Material &i, const Material &j)
  {
    return 3.0 * std::min(i.sigmaY2(), j.sigmaY2());
  }
};
using HealLaw = ThresholdLaw<HealWords>;

/// Plastic work that links an unlinked contact, a multiple of that up to the strength.
struct LinkWorkWords {
  static constexpr const char *keyword = "link_work", *materialStress = nullptr;
  static Threshold initial() { return Threshold::off(); }
};
using LinkWorkLaw = ThresholdLaw<LinkWorkWords>;

} // namespace mca

#endif
