// SPDX-License-Identifier: GPL-2.0-or-later
/// \file link_list.h
/// The pair list in the kernel's form: one array a quantity, in the order of LAMMPS's half
/// neighbor list.
#ifndef MCA_LINK_LIST_H
#define MCA_LINK_LIST_H

#include "pairs.h"
#include "row_array.h"

#include <utility>
#include <vector>

namespace mca {

/// Owns the arrays of a Pairs view. Pairs are numbered from 0 in the order in which they were
/// added, which is the order of all sums. Each array of row numbers ends with three copies of the
/// last pair's, since the kernel gathers four pairs at a time. Filled by reset() and add(), when
/// LAMMPS has built its neighbor list; numbers and views hold until the next reset(). Numbers of
/// pairs are not checked.
class LinkList {
 public:
  /// \param shears  shear components of a pair: 1 in the plane, 3 in space
  explicit LinkList(int shears = 1);

  /// State of a pair that the kernel knows: kind, plastic, gamma, gammaTotal; 4 doubles in the
  /// plane, 8 in space.
  int stateSize() const { return 2 + 2 * shears_; }
  static constexpr int maxStateSize = 2 + 2 * maxShears;

  /// What is kept with the automata while there is no pair list: the state, 1 for an original link,
  /// and the normal (up to its sign), by which a pair that was turned between runs is known. In
  /// doubles: 8 in the plane, 12 in space.
  int storedSize() const { return stateSize() + 4; }
  static constexpr int maxStoredSize = maxStateSize + 4;

  /// Empties the list and makes room for n pairs. More than n must not be added. Memory only grows.
  /// \throw std::bad_alloc  there is not so much memory
  void reset(int n);

  /// Appends a pair; its state becomes both the present and the next one.
  /// \param i,j    rows of both automata
  /// \param law    number in the table of PairLaw
  /// \param state  stateSize() values: kind, plastic offset, elastic shears (unlinked: of
  ///               friction), total shears
  void add(int i, int j, int law, const double *state);

  /// Adds a link with all that is kept, storedSize() values, as getStored() wrote them.
  /// \param exchanged  kept as the pair (j, i)
  void addStored(int i, int j, int law, bool exchanged, const double *stored);

  /// The last pair that was added meets over a periodic face; otherwise its places are i and j.
  /// \param placeI,placeJ  rows of motion of the images that meet
  void setPlaces(int placeI, int placeJ);

  /// Copies what is kept of pair k, with the present (or the next) state, to storedSize() doubles.
  /// \param exchanged  as the pair (j, i): in space its shears turn round
  void getStored(int k, bool next, bool exchanged, double *stored) const;

  /// Nothing of this pair needs to be kept: all values of its state are 0, as of a pair that never
  /// was in contact. A pair that is not in the list of the last build begins so.
  /// \param next  of the next state, else of the present one
  bool blank(int k, bool next) const;

  /// A link of the sample as it was made, not one that formed later; it ends with its breaking.
  bool original(int k) const { return original_[k] > 0.0; }
  /// As getStored() gives it; the strain pass of the next evaluation finds it anew.
  /// \param normal  unit vector from i to j
  void setNormal(int k, const Vector &normal);
  /// Makes pair k an original link, or not.
  void setOriginal(int k, bool is) { original_[k] = is ? 1.0 : 0.0; }

  /// Present and next states, normals and strains; complete for readers. Only the next states of
  /// blocks that move are held (Block::moves): getState() reads either.
  const Pairs &pairs() const
  {
    if (stale_)
      completeAll();
    return view_;
  }

  /// n pairs from the first one of a block on, for the kernel, which may change their states. From
  /// then on the list counts as changed, and pairs() completes it again.
  /// \param first  a multiple of blockLength
  /// \param n      whole blocks, or as many as there are up to the end of the list
  Pairs part(int first, int n);

  /// Number of pairs added since reset().
  int size() const { return view_.n; }

  /// Rows of both automata of pair k.
  int i(int k) const { return i_[k]; }
  int j(int k) const { return j_[k]; }
  /// Rows of the images of both that meet: i and j but for pairs over a periodic face.
  int placeI(int k) const { return placeI_[k]; }
  int placeJ(int k) const { return placeJ_[k]; }

  /// Makes the next state the present one; only blocks that move are copied, and then no longer
  /// move. Once a step, before its strain pass.
  void advance();

  /// Copies the present (or the next) state of pair k to stateSize() doubles, in the order of
  /// add(). The next one of a block that does not move is the present one.
  void getState(int k, bool next, double *state) const;

  /// Sets both the present and the next state of pair k, in the order of add(). The block's way
  /// follows.
  void setState(int k, const double *given);
  /// Turns the shears of a state round, as exchange of i and j does in space.
  void exchange(double *state) const;

  /// The elastic shear of an unlinked contact with friction [-], as that of a link; what a
  /// dimension does not have is 0. Few pairs have one. In the states of pairs it stands in the
  /// place of their elastic shears, hence in restart files, too.
  struct Spring {
    int pair;
    double now[maxShears], next[maxShears];
  };
  /// In the order of pairs.
  const std::vector<Spring> &springs() const { return springs_; }
  /// The spring of pair k, or nullptr.
  const Spring *spring(int k) const;
  /// Takes the place of all springs.
  /// \param springs  of pairs that are unlinked at present, in their order
  void setSprings(std::vector<Spring> &&springs) { springs_ = std::move(springs); }

  /// Memory held [bytes].
  double bytes() const;

 private:
  int shears_;
  std::vector<Spring> springs_;
  AlignedArray values_; // of all pairs, one quantity after the other
  std::vector<int> i_, j_, placeI_, placeJ_, law_;
  std::vector<double> original_;
  std::vector<Block> blocks_;
  mutable bool stale_ = false;       // the kernel may have changed what pairs() completes
  std::vector<double *> now_, next_; // the arrays of both states, in the order of getState()
  Pairs view_{};

  /// Gives the pairs of a pristine block their total shears, which equal the elastic ones. Const,
  /// since no reader sees a difference.
  void complete(int block) const;
  void completeAll() const;
  void takeSpring(int k, double *state);
};

} // namespace mca

#endif
