// SPDX-License-Identifier: GPL-2.0-or-later
/// \file law_set.h
/// Which laws act: the keywords of pair_style mca and their presets. No LAMMPS type in here.
#ifndef MCA_LAWS_LAW_SET_H
#define MCA_LAWS_LAW_SET_H

#include "automaton_law.h"
#include "contact.h"
#include "fracture_law.h"
#include "interface.h"
#include "law_keywords.h"
#include "material.h"
#include "plane.h"

#include <string>
#include <vector>

namespace mca {

/// A choice of exchangeable laws, each a type that knows its keyword. By default set D. A value
/// like any other: it is copied, and what loops need of it is made from it by the functions below.
struct LawSet {
  /// As given; the laws below may differ from it, as later keywords change them.
  std::string preset = "d";
  PlaneCondition plane;
  Elasticity elasticity;
  Plasticity plasticity;
  FlowLaw flow;
  FractureLaw fracture;
  ViscosityLaw viscosity;
  ContactFrictionLaw friction;
  Steps steps;
  LinkLaw link;
  WeldLaw weld;
  HealLaw heal;
  HealedStrainLaw healedStrain;
  WornRule worn;
  LinkWorkLaw linkWork;

  /// Calls visit(law) for each law: the one table of keywords, in the order of words().
  /// \param set  a LawSet, const or not; visit gets its members so
  template<class Set, class Visit>
  static void eachLaw(Set &set, Visit &&visit)
  {
    visit(set.plane);
    visit(set.elasticity);
    visit(set.plasticity);
    visit(set.flow);
    visit(set.fracture);
    visit(set.viscosity);
    visit(set.friction);
    visit(set.steps);
    visit(set.link);
    visit(set.weld);
    visit(set.heal);
    visit(set.healedStrain);
    visit(set.worn);
    visit(set.linkWork);
  }

  /// A keyword with what it takes, as error messages and the check against doc/pair_mca.md want it.
  struct Keyword {
    /// As in the input script.
    std::string name;
    std::vector<std::string> words; ///< beside a number, if it takes one
    /// Beside the words it takes a number, which is > 0; of friction >= 0.
    bool takesNumber;
    std::string allowed; ///< for messages
  };

  /// All keywords of laws in the order of words(), preset first, then those of eachLaw(), then the
  /// criteria's own numbers (compressive_strength). packing, thickness and cutoff are no laws;
  /// PairMCA::settings() has them.
  static std::vector<Keyword> keywords();

  /// Set "a" (one kind of link, at 2.35 sigma_0, no welds), set "b" (bulk links and welds), set "c"
  /// (b whose unlinked contacts flow and resist slip and whose welds are weaker) or set "d" (c with
  /// plasticity isochoric, the default). Any other name gives the laws of set c.
  static LawSet named(const std::string &preset);

  /// Takes keyword-value pairs as given to pair_style; a preset resets all that stands before it.
  /// What does not go together is an error: heal without weld, healed_strain without heal, plane
  /// stress with flow, a criterion of fracture without its number.
  /// \param words  keyword, value, keyword, value, ...; those before a bad one have been taken, so
  ///               that the set is of no use after an error
  /// \return an empty string, or one line: keyword, value, what is allowed, or for a misspelt
  ///         keyword the nearest one
  std::string parse(const std::vector<std::string> &words);

  /// All laws as keyword-value pairs that parse() reads back, to the last bit of each number: what
  /// restart files and the heads of friction logs hold. The preset comes first, all others follow.
  std::vector<std::string> words() const;

  /// Whether automata flow: all but plasticity none. The longest step depends on it, too.
  bool flows() const { return !plasticity.is(Plasticity::None); }

  /// Whether flow keeps the volume and never makes energy: plasticity isochoric.
  bool keepsVolume() const { return plasticity.is(Plasticity::Isochoric); }

  /// Whether unlinked contacts are viscous.
  bool isViscous() const { return !viscosity.is(ViscosityLaw::None); }

  /// Whether their viscosity resists slip, too.
  bool resistsSlip() const { return viscosity.is(ViscosityLaw::Both); }

  /// Whether a law needs more of both automata than their mean stress and return: their averaged
  /// stress and their plastic work in the step, RowLayout::Local, which cost a message between
  /// ranks.
  bool needsLocal() const { return fracture.criterion().needsLocalStress || !linkWork.isOff(); }

  /// Whether an automaton's return is done twice, by secondReturn().
  bool returnsTwice() const { return steps.is(Steps::Corrected) && flows(); }

  /// Whether viscous contacts see the velocity of their step, by centredSeparation().
  bool centresViscosity() const { return steps.is(Steps::Corrected) && isViscous(); }

  /// The first of these laws that does not act in this dimension, as its keyword and value, such as
  /// "plane stress"; empty if all do. The box, hence the dimension, may come after the keywords: so
  /// this is no part of parse().
  /// \param dimension  2 or 3
  std::string notInDimension(int dimension) const;
};

/// Moduli of a material under these laws: of plane strain (and space) or of plane stress. The
/// pairwise law has D = 0, and with plane stress K' = 2G/3, that of a solid whose Lame constant is
/// 0.
ElasticModuli elasticModuli(const LawSet &, const Material &);

/// Laws of an automaton of this material, for passes over automata.
/// \param material  that checkMaterial() accepts, in units in which a stress is an energy per
///                  volume
/// \param packing   its contact weight q S/V [-] goes into the averaged stress
AutomatonLaw makeAutomatonLaw(const LawSet &, const Material &, const Packing & = packing::hex);

/// Laws of an ordered pair of materials; of unlike materials the weaker decides fracture and
/// linking, and diameter and viscosity are means (doc/laws.md, Unlike materials). The same units as
/// for makeAutomatonLaw().
/// \param i,j        of the first and the second automaton of a pair
/// \param thickness  h [length] of a plane packing, > 0; not used in space
/// \param packing    its contact area S and cell volume V
/// \param interface  what they have of their own, in the same units, which fits the laws
PairLaw makePairLaw(const LawSet &, const Material &i, const Material &j, double thickness,
                    const Packing & = packing::hex, const Interface & = {});

/// Viscosity of contacts under these laws [stress time]: of the interface, or the mean of both.
double contactViscosity(const LawSet &, const Material &i, const Material &j,
                        const Interface & = {});

} // namespace mca

#endif
