// SPDX-License-Identifier: GPL-2.0-or-later
/// \file law_set.h
/// Which laws act: the keywords of pair_style mca and their presets. No LAMMPS type in here.
#ifndef MCA_LAWS_LAW_SET_H
#define MCA_LAWS_LAW_SET_H

#include "automaton_law.h"
#include "contact.h"
#include "fracture_law.h"
#include "law_keywords.h"
#include "material.h"
#include "plane.h"

#include <string>
#include <vector>

namespace mca {

/// A choice of exchangeable laws, each a type that knows its keyword. By default set B.
struct LawSet {
  /// As given; the laws below may differ from it, as later keywords change them.
  std::string preset = "b";
  PlaneCondition plane;
  Elasticity elasticity;
  Plasticity plasticity;
  FractureLaw fracture;
  ViscosityLaw viscosity;
  Steps steps;
  LinkLaw link;
  WeldLaw weld;
  HealLaw heal;
  LinkWorkLaw linkWork;

  /// Calls visit(law) for each law: the one table of keywords, in the order of words().
  /// \param set  a LawSet, const or not; visit gets its members so
  template<class Set, class Visit>
  static void eachLaw(Set &set, Visit &&visit)
  {
    visit(set.plane);
    visit(set.elasticity);
    visit(set.plasticity);
    visit(set.fracture);
    visit(set.viscosity);
    visit(set.steps);
    visit(set.link);
    visit(set.weld);
    visit(set.heal);
    visit(set.linkWork);
  }

  /// A keyword with what it takes.
  struct Keyword {
    std::string name;
    std::vector<std::string> words; ///< beside a number, if it takes one
    bool takesNumber;               ///< > 0
    std::string allowed;            ///< for messages
  };

  /// All keywords of laws in the order of words(), preset first, for messages and for the check
  /// against the documentation.
  static std::vector<Keyword> keywords();

  /// Set "a" (one kind of link, at 2.35 sigma_0, no welds) or set "b" (bulk links and welds, the
  /// default); any other name gives the laws of set b.
  static LawSet named(const std::string &preset);

  /// Takes keyword-value pairs as given to pair_style; a preset resets all that stands before it.
  /// What does not go together is an error: heal without weld, plane stress with flow, a criterion
  /// of fracture without its number.
  /// \return an empty string, or one line: keyword, value, what is allowed.
  std::string parse(const std::vector<std::string> &words);

  /// The same as keyword-value pairs that parse() reads back.
  std::vector<std::string> words() const;

  /// Whether automata flow: all but plasticity none.
  bool flows() const { return !plasticity.is(Plasticity::None); }

  /// Whether each automaton has an elastic strain across the plane, which flow changes: with
  /// plasticity j2 in the plane. In space the return keeps the volume without one.
  /// \param dimension  2 or 3
  bool strainsAcross(int dimension) const
  {
    return dimension == 2 && plasticity.is(Plasticity::J2);
  }

  /// Whether unlinked contacts are viscous.
  bool isViscous() const { return !viscosity.is(ViscosityLaw::None); }

  /// Whether a law needs more of both automata than their mean stress and return: their averaged
  /// stress and their plastic work in the step.
  bool needsLocal() const { return fracture.criterion().needsLocalStress || !linkWork.isOff(); }

  /// Whether an automaton's return is done twice.
  bool returnsTwice() const { return steps.is(Steps::Corrected) && flows(); }

  /// Whether viscous contacts see the velocity of their step.
  bool centresViscosity() const { return steps.is(Steps::Corrected) && isViscous(); }

  /// The first of these laws that does not act in this dimension, as its keyword and value; empty
  /// if all do.
  std::string notInDimension(int dimension) const;
};

/// Moduli of a material under these laws: of plane strain, plane stress or space, with D = 0 for
/// the pairwise law.
ElasticModuli elasticModuli(const LawSet &, const Material &);

/// Laws of an automaton of this material.
/// \param packing  its contact weight q S/V [-] goes into the averaged stress
AutomatonLaw makeAutomatonLaw(const LawSet &, const Material &, const Packing & = packing::hex);

/// Laws of an ordered pair of materials; of unlike materials the weaker decides fracture and
/// linking, and diameter and viscosity are means (doc/laws.md, Unlike materials).
/// \param thickness  h [length] of a plane packing, > 0
PairLaw makePairLaw(const LawSet &, const Material &i, const Material &j, double thickness,
                    const Packing & = packing::hex);

} // namespace mca

#endif
