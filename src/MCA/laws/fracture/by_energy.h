// SPDX-License-Identifier: GPL-2.0-or-later
/// \file by_energy.h
/// fracture energy: the elastic energy of the link per volume reaches that of the strength,
///     psi >= sigma_0^2/(2E).
/// The volume of a link is its share of both cells, 2V/N = S d/dim in a packing of N contacts in
/// dim dimensions; its energy is its share of U of elasticity.h. So psi is the energy density of an
/// automaton all of whose contacts are strained like this one, the mean of both sides:
///     psi = 1/2 sum_{i,j} [ dim G (e^2 + gamma^2) + D sigma_mean^2/(2K) ],
/// and its mean over the contacts of an automaton in a homogeneous packing is the energy density of
/// the solid: sigma^2/(2E) in uniaxial tension. e and gamma are elastic, after the
/// return.
#ifndef MCA_LAWS_FRACTURE_BY_ENERGY_H
#define MCA_LAWS_FRACTURE_BY_ENERGY_H

#include "../fracture.h"

namespace mca {

/// Keyword fracture, value energy (doc/laws.md, Links). The criterion is ours: Bucher et al. state
/// none. Energy has no sign, so a link breaks under compression, too.
struct FractureByEnergy : FractureCriterion {
  /// All else is as FractureCriterion has it: it needs more than strains, but no local stress, acts
  /// in plane and space, and has no number of its own.
  static constexpr const char *keyword = "energy";

  /// The limit [stress], of unlike materials the lower one, and the factors of e^2 + gamma^2
  /// [stress] and of both mean stresses' squares [1/stress]: value[0] to value[3] in this order.
  /// \param m  with the moduli of the plane or of space; m.parameter is not read
  static FractureLimits limits(const LinkMaterials &m)
  {
    auto ofStrength = [](const Material &a) { return a.strength * a.strength / a.youngsModulus; };
    auto ofMean = [](const ElasticModuli &a) { return 0.25 * a.D / a.bulk; };
    return {{0.5 * std::min(ofStrength(m.i), ofStrength(m.j)),
             0.5 * m.dimension * (m.moduliI.shear + m.moduliJ.shear), ofMean(m.moduliI),
             ofMean(m.moduliJ)}};
  }

  /// psi [stress], the elastic energy of the link per volume, >= 0 for D >= 0. Exchange of both
  /// automata leaves it as it is, so that two ranks decide alike.
  /// \param load    elastic strains [-] and mean stresses [stress] after the return
  /// \param limits  of limits()
  static double density(const LinkLoad &load, const FractureLimits &limits)
  {
    return limits.value[1] * (load.e * load.e + load.gamma * load.gamma) +
           limits.value[2] * load.meanI * load.meanI + limits.value[3] * load.meanJ * load.meanJ;
  }

  /// Whether psi reaches the limit. Needs a LinkLoad: stresses after the return have to be known,
  /// so that all blocks go the kernel's longer way.
  template<class Load>
  static bool broken(const Load &load, const FractureLimits &limits)
  {
    return density(load, limits) >= limits.value[0];
  }
};

} // namespace mca

#endif
