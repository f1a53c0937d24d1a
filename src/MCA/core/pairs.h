// SPDX-License-Identifier: GPL-2.0-or-later
/// \file pairs.h
/// The pairs of a step as the passes see them: a view of the arrays that LinkList owns. No LAMMPS
/// type in here. All quantities in one consistent set of units.
#ifndef MCA_PAIRS_H
#define MCA_PAIRS_H

#include "laws/vector.h"

#include <cstdint>

namespace mca {

/// Pairs are worked on in blocks of this length, whose temporary rows stay in the first-level
/// cache.
constexpr int blockLength = 128;

/// Most shear components of a pair: one in the plane, a vector in space.
constexpr int maxShears = 3;

/// State of the pairs that outlives a step, one value a pair, each array on its own. In the plane
/// only the first component of the shears exists, the others are nullptr. Owned by LinkList.
struct PairState {
  /// link::worn, none, bulk, weld or healed, as a double, so that loops vectorise.
  double *kind;
  /// Plastic offset of the normal strain [-]; e = eps - plastic. An unlinked pair keeps it until
  /// eps > max(plastic, 0).
  double *plastic;
  /// Elastic shear [-], along t in the plane, a vector perpendicular to the normal in space; 0
  /// without a link.
  double *gamma[maxShears];
  /// Shear since linking, not reduced by plasticity [-]; the first of an unlinked contact: plastic
  /// work per volume while pressed together, where a law needs it [stress]. Out of date in pristine
  /// blocks.
  double *gammaTotal[maxShears];
};

/// Some pairs of a block, one bit each.
struct BlockMask {
  static constexpr int words = blockLength / 64;
  std::uint64_t bits[words];

  /// Adds those of another one.
  void add(const BlockMask &more)
  {
    for (int word = 0; word < words; word++)
      bits[word] |= more.bits[word];
  }

  /// Calls use(k) for each of them, in rising order; k counts within the block.
  template<class Use>
  void each(const Use &use) const
  {
    for (int word = 0; word < words; word++)
      for (std::uint64_t left = bits[word]; left; left &= left - 1)
        use(64 * word + __builtin_ctzll(left));
  }
};

/// What is known of all pairs of a block, so that most blocks take a short way. It never changes a
/// result, only the time that it takes. LinkList sets law, bulk, pristine and across, the strain
/// pass `breaks`, Step `flows` before the return pass, the force pass `moves` and `changes`;
/// LinkList::advance() brings bulk and pristine up to date.
struct Block {
  static constexpr int mixed = -1;
  int law;   ///< number of the law of all its pairs, or mixed
  bool bulk; ///< all its pairs are bulk links
  /// ... that never flowed: plastic is 0, and gammaTotal equals gamma, which alone is kept up to
  /// date.
  bool pristine;
  /// One of them reaches the breaking strain in this step; of bulk blocks under a criterion by
  /// strain.
  bool breaks;
  /// An automaton of it may flow: one of its own that does not know yet by how much, or a guest.
  bool flows;
  /// An automaton of it may have pressure against lack of room: one of its own that has, or a
  /// guest.
  bool crowded;
  bool moves;   ///< the next state differs from the present one; only then is it held in `next`
  bool changes; ///< ... in the kind of a pair
  /// All other pairs are bulk links with their elastic stress alone, or apart, and stay what they
  /// are. The strain pass finds those that touch or break by their strain, the force pass adds the
  /// others.
  BlockMask busy;
  /// Set by the return pass of blocks in which an automaton flows: pairs with one that does.
  BlockMask flowing;
  /// All its strains of the last strain pass are small enough for the short logarithm: so they will
  /// be in this one, else the long one gives the same. Of bulk blocks with plasticity isochoric.
  bool near;
  bool across; ///< one of them meets over a periodic face; else placeI, placeJ equal i, j
};

/// The pair list, or a part of it from a block's first pair on; arrays have `n` values, row numbers
/// three more, which repeat the last pair, so that loops may gather by fours. A view: LinkList owns
/// the arrays, and the view holds until the list is made anew. ratio, eps, normal and separation
/// are those of the last strain pass, `next` that of the last force pass.
struct Pairs {
  int n;
  /// Row numbers of the two automata, whose sums the pair adds to. Lists of a run are sorted by the
  /// lower ID, that of i, so that successive pairs mostly share it.
  const int *i, *j;
  const int *placeI, *placeJ; ///< rows of motion where they meet: of images, over a periodic face
  /// Number in the table of PairLaw, below LawTables::pairs.size().
  const int *law;
  PairState now, next;
  /// Unit normal from i to j [-]; in the plane two components, the third is 0.
  double *normal[3];
  double *ratio;      ///< r/d [-]
  double *eps;        ///< total normal strain, normalStrain() of it [-]
  double *separation; ///< normal velocity of j seen from i [length/time]; not of bulk blocks; of
                      ///< half a step ago, until viscous contacts are centred
  /// Elastic normal stress before the return [stress], of the last stress pass; 0 where they do not
  /// touch.
  double *sigma;
  Block *blocks; ///< of blockLength pairs each
};

/// Unit normal of pair k, from its first to its second automaton [-].
inline Vector normalOf(const Pairs &p, int k, bool plane)
{
  return {p.normal[0][k], p.normal[1][k], plane ? 0.0 : p.normal[2][k]};
}

} // namespace mca

#endif
