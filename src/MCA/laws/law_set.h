/// \file law_set.h
/// Which laws act: the keywords of pair_style mca and their presets. No LAMMPS type in here.
#ifndef MCA_LAWS_LAW_SET_H
#define MCA_LAWS_LAW_SET_H

#include "automaton_law.h"
#include "contact.h"
#include "material.h"
#include "plane.h"

#include <limits>
#include <string>
#include <vector>

namespace mca {

/// A choice of exchangeable laws. Thresholds are multiples of the strength sigma_0; infinity
/// switches a transition off; negative values stand for a stress of the material.
struct LawSet {
  static constexpr double off = std::numeric_limits<double>::infinity();
  static constexpr double atElasticLimit = -1.0; ///< sigma_y1
  static constexpr double atHardness = -2.0;     ///< 3 sigma_y2 (Tabor)

  std::string preset = "b";
  std::string plane = "strain";         ///< or stress: what holds across the plane
  std::string elasticity = "many-body"; ///< or pairwise: plane Poisson's ratio 0
  std::string plasticity = "radial";    ///< or j2: volume-preserving, or none
  std::string fracture = "strain";      ///< of bulk links: strain, stress, equivalent,
                                        ///< drucker-prager or none
  double compressive_strength = off;    ///< of drucker-prager
  double link = atElasticLimit;         ///< compression that links an unlinked contact
  double weld = 1.0;                    ///< strength of welds; off: contacts become bulk links
  double heal = atHardness;             ///< compression that turns a weld into a bulk link
  double link_work = off;               ///< plastic work that links an unlinked contact, a multiple
                                        ///< of that up to the strength
  std::string viscosity = "normal";     ///< or none
  std::string steps = "corrected";      ///< secondReturn(), centredSeparation(); or plain

  /// Set A (one kind of link), set B (bulk links and welds, the default).
  static LawSet named(const std::string &preset);

  /// Takes keyword-value pairs as given to pair_style; a preset resets all that stands before it.
  /// \return an empty string, or one line: keyword, value, what is allowed.
  std::string parse(const std::vector<std::string> &words);

  /// The same as keyword-value pairs that parse() reads back.
  std::vector<std::string> words() const;

  /// Whether a law needs more of both automata than their mean stress and return: their averaged
  /// stress and their plastic work in the step.
  bool needsLocal() const;

  /// Whether automata flow.
  bool flows() const { return plasticity != "none"; }

  /// Whether each automaton has an elastic strain across the plane, which flow changes: with
  /// plasticity j2 in the plane. In space the return keeps the volume without one.
  /// \param dimension  2 or 3
  bool strainsAcross(int dimension) const { return dimension == 2 && plasticity == "j2"; }

  /// Whether unlinked contacts are viscous.
  bool isViscous() const { return viscosity != "none"; }

  /// Whether an automaton's return is done twice.
  bool returnsTwice() const { return steps == "corrected" && flows(); }

  /// Whether viscous contacts see the velocity of their step.
  bool centresViscosity() const { return steps == "corrected" && isViscous(); }

  /// The first of these laws that does not act in this dimension, as its keyword and value; empty
  /// if all do.
  std::string notInDimension(int dimension) const;
};

/// Moduli of a material under these laws.
ElasticModuli elasticModuli(const LawSet &, const Material &);

/// Laws of an automaton of this material.
AutomatonLaw makeAutomatonLaw(const LawSet &, const Material &, const Packing & = packing::hex);

/// Laws of an ordered pair of materials; of unlike materials the weaker decides fracture and
/// linking. \param thickness h [length] of a plane packing
PairLaw makePairLaw(const LawSet &, const Material &i, const Material &j, double thickness,
                    const Packing & = packing::hex);

} // namespace mca

#endif
