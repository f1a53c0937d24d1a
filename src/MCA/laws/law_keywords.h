// SPDX-License-Identifier: GPL-2.0-or-later
/// \file law_keywords.h
/// The exchangeable laws that are chosen by one keyword each, but for the criterion of fracture
/// (fracture_law.h). Each says what it is called, what it takes, where it acts and what follows
/// from the choice; the equations stand in the headers named.
///
/// Pages: doc/pair_mca.md has the keywords, doc/laws.md the equations and their sources. The first
/// word of each is the one of preset d, the default; law_set.h refuses what does not go together.
#ifndef MCA_LAWS_LAW_KEYWORDS_H
#define MCA_LAWS_LAW_KEYWORDS_H

#include "keyword.h"

#include <algorithm>

namespace mca {

/// What holds across the plane; plane.h and doc/laws.md, Elasticity. With strain the thickness
/// stays, and sigma_zz follows from Hooke's law; with stress sigma_zz = 0, and K and D are those of
/// plane stress. Stress has no meaning in space and needs plasticity none, since the return is that
/// of plane strain; LawSet::parse() refuses it otherwise.
struct PlaneWords {
  static constexpr const char *keyword = "plane";
  enum Kind { Strain, Stress };
  static constexpr Option options[] = {{"strain"}, {"stress", false}};
};
/// Keyword plane: "strain" (default) or "stress".
using PlaneCondition = Choice<PlaneWords>;

/// Normal stress of a contact; elasticity.h. With many-body it is 2G e + D sigma_mean, sigma_mean
/// the mean stress of all contacts of an automaton (Psakhie et al., Phys. Mesomech. 14 (2011) 224).
/// Pairwise has D = 0: then sigma = 2G e, and the plane Poisson's ratio is 0 whatever nu is.
struct ElasticityWords {
  static constexpr const char *keyword = "elasticity";
  enum Kind { ManyBody, Pairwise };
  static constexpr Option options[] = {{"many-body"}, {"pairwise"}};
};
/// Keyword elasticity: "many-body" (default) or "pairwise".
using Elasticity = Choice<ElasticityWords>;

/// Flow of automata (Psakhie et al., Phys. Mesomech. 14 (2011) 224); plasticity.h. Isochoric
/// keeps the volume and never makes energy: in the plane automata yield by the largest shear in it,
/// as a solid does that flows in plane strain; normal stresses return to their mean over the
/// contacts that flow; links lengthen by what their rotation in large shear feigns (contact.h,
/// shearStretch()); and automata resist lack of room (room.h). Radial returns the stresses of
/// contacts by the factor M = Y/sigma_int and in the plane changes the volume. None: M = 1, the
/// material is elastic, and a step may be longer, since no link is pressed to collapse.
struct PlasticityWords {
  static constexpr const char *keyword = "plasticity";
  enum Kind { Isochoric, Radial, None };
  static constexpr Option options[] = {{"isochoric"}, {"radial"}, {"none"}};
};
/// Keyword plasticity: "isochoric" (default), "radial" or "none".
using Plasticity = Choice<PlasticityWords>;

/// Which contacts of an automaton flow with it: its bulk links, or unlinked contacts that are
/// pressed, too; welds are brittle. Bucher et al. (2006), Fig. 5, is the response of an automaton;
/// whether of all its contacts is not said.
struct FlowWords {
  static constexpr const char *keyword = "flow";
  enum Kind { Contacts, Links };
  static constexpr Option options[] = {{"contacts"}, {"links"}};
};
/// Keyword flow: "contacts" (default) or "links".
using FlowLaw = Choice<FlowWords>;

/// Viscosity of unlinked contacts; viscosity.h. Normal resists the normal velocity with eta v_n/d
/// [stress], never as tension (Bucher et al. 2006, Table 1, "proportional to their relative
/// velocity"; the direction is our choice). Both also resists the slip of the two surfaces, with
/// the same eta. None is without damping, as if eta were 0. Links have no viscosity.
struct ViscosityWords {
  static constexpr const char *keyword = "viscosity";
  enum Kind { Both, Normal, None };
  static constexpr Option options[] = {{"both"}, {"normal"}, {"none"}};
};
/// Keyword viscosity: "both" (default), "normal" or "none".
using ViscosityLaw = Choice<ViscosityWords>;

/// Coulomb friction of unlinked contacts, coulomb.h: its coefficient mu. The paper's automata have
/// none, friction comes out of their links; grains, third bodies and whoever compares with other
/// codes of discrete elements need it.
struct FrictionWords {
  static constexpr const char *keyword = "friction", *range = "a coefficient >= 0";
};
/// Keyword friction: mu [-], >= 0; 0 (default) has no friction.
using ContactFrictionLaw = Coefficient<FrictionWords>;

/// Whether two things that a Verlet step knows too late are taken again (doc/laws.md, Corrected
/// steps). Corrected: secondReturn() of plasticity.h, one more pass over pairs and a message
/// between ranks, and centredSeparation() of viscosity.h, one message; friction depends less on the
/// step and longer steps are stable. Plain: neither.
struct StepsWords {
  static constexpr const char *keyword = "steps";
  enum Kind { Corrected, Plain };
  static constexpr Option options[] = {{"corrected"}, {"plain"}};
};
/// Keyword steps: "corrected" (default) or "plain".
using Steps = Choice<StepsWords>;

/// The first of the transitions of linking.h, whose multiples are of the strength sigma_0 of the
/// weaker material; "none" makes the limit infinite: nothing reaches it.
///
/// Compression that links an unlinked contact: -sigma >= limit; of a worn contact keyword worn
/// decides. The transition is ours, Bucher et al. leave it open; by default at the elastic
/// limit sigma_y1 of the weaker material. Preset a: 2.35 sigma_0, fitted to the paper's friction at
/// sigma_0 = 92 MPa.
struct LinkWords : OfStrength {
  static constexpr const char *keyword = "link", *materialStress = "elastic_limit";
  static Threshold initial() { return Threshold::ofMaterial(); }
  /// sigma_y1 of the weaker material [stress], the limit of "elastic_limit".
  /// \param i,j  both materials; the order does not count
  static double stress(const Material &i, const Material &j)
  {
    return std::min(i.sigmaY1(), j.sigmaY1());
  }
};
/// Keyword link: "elastic_limit" (default), a multiple of sigma_0 > 0, or "none".
using LinkLaw = ThresholdLaw<LinkWords>;

/// Strength of welds: max(sigma, 0)^2 + 3 tau^2 reaches the square of this stress, by default of
/// the elastic limit sigma_y1 of the weaker material, at which they form, too; ours. Preset b: of
/// the strength. Off: contacts become bulk links at once, and keyword heal has to be off, too,
/// which LawSet::parse() sees to. Preset a has it off.
struct WeldWords : OfStrength {
  static constexpr const char *keyword = "weld", *materialStress = "elastic_limit";
  static Threshold initial() { return Threshold::ofMaterial(); }
  /// The stress of keyword link [stress].
  static double stress(const Material &i, const Material &j) { return LinkWords::stress(i, j); }
};
/// Keyword weld: "elastic_limit" (default), a multiple of sigma_0 > 0, or "none".
using WeldLaw = ThresholdLaw<WeldWords>;

/// Compression that turns a weld or a worn contact into a bulk link, by default the hardness; ours.
/// Off: welds never become bulk links, and worn contacts have to be unloaded before they link
/// again.
struct HealWords : OfStrength {
  static constexpr const char *keyword = "heal", *materialStress = "hardness";
  static Threshold initial() { return Threshold::ofMaterial(); }
  /// The hardness 3 sigma_y2 (Tabor, The Hardness of Metals, 1951) of the material with the lower
  /// sigma_y2 [stress], the limit of "hardness".
  static double stress(const Material &i, const Material &j)
  {
    return 3.0 * std::min(i.sigmaY2(), j.sigmaY2());
  }
};
/// Keyword heal: "hardness" (default), a multiple of sigma_0 > 0, or "none".
using HealLaw = ThresholdLaw<HealWords>;

/// Strain intensity, that of fracture strain, at which a healed link breaks, whatever the criterion
/// of bulk links, which it obeys, too: a healed junction is the size of a contact and not of the
/// averaged body, so that it need not bear as much. By default as much: it is a bulk link. Ours.
struct HealedStrainWords {
  static constexpr const char *keyword = "healed_strain", *materialStress = "yield_strain";
  static constexpr const char *number = "a strain > 0";
  static Threshold initial() { return Threshold::off(); }
  /// eps_y2 of the material with the lower one [-], the limit of "yield_strain".
  static double strain(const Material &i, const Material &j)
  {
    return std::min(i.yieldStrain, j.yieldStrain);
  }
};
/// Keyword healed_strain: "yield_strain", a strain > 0, or "none" (default).
using HealedStrainLaw = ThresholdLaw<HealedStrainWords>;

/// When a contact whose link broke is as good as one that never was linked (linking.h): as soon as
/// it is unloaded below the limit of keyword link, or never; until then it links only by healing,
/// with never not at all. At the breaking distance it is forgotten by both rules, which are ours.
struct WornWords {
  static constexpr const char *keyword = "worn";
  enum Kind { Unloaded, Never };
  static constexpr Option options[] = {{"unloaded"}, {"never"}};
};
/// Keyword worn: "unloaded" (default) or "never".
using WornRule = Choice<WornWords>;

/// Plastic work per volume that links an unlinked contact, beside pressure: a multiple of that up
/// to the strength, the area below the yield curve; of unlike materials the lower one. The mean
/// work of both automata counts, since they are pressed together without a break. Off by default;
/// the criterion is ours. It needs one more message between ranks, of what automata have worked in
/// the step.
struct LinkWorkWords : OfStrength {
  static constexpr const char *keyword = "link_work", *materialStress = nullptr;
  static Threshold initial() { return Threshold::off(); }
};
/// Keyword link_work: a multiple > 0, or "none" (default).
using LinkWorkLaw = ThresholdLaw<LinkWorkWords>;

} // namespace mca

#endif
