// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_blocks.h
/// The ways of a block of pairs through a pass, and the arrays of its pairs. For the kernel's
/// source only.
/// A block of up to blockLength pairs goes through a pass in one of four ways. A way is a template
/// argument, so that what it knows of its pairs (one law, no contacts, no plastic offset) is left
/// out of its loop by the compiler. The results of a pair do not depend on the way.
#ifndef MCA_KERNEL_BLOCKS_H
#define MCA_KERNEL_BLOCKS_H

#include "kernel_rows.h"
#include "laws/contact.h"
#include "laws/fracture_criteria.h"

// Inlines all that a function calls: loops vectorise only then. What a loop does to a pair stands
// in a lambda, since vectors that are declared in the loop itself would be kept in memory.
// Sanitizers instrument each copy, which takes a quarter of an hour to compile: they get calls.
#ifdef __SANITIZE_ADDRESS__
#define MCA_LOOP
#else
#define MCA_LOOP __attribute__((flatten))
#endif

namespace mca::MCA_ISA {
namespace {

// Ways of a block: of several laws (scalar), of one law, and of bulk links of one law, which are
// most of a sample: these know no contact, viscosity or weld, and no next state while nothing
// flows. Where none ever flowed, plastic offset and total shear are not read.
// Block says which way holds.
enum Way { SeveralLaws, OneLaw, Bulk, Pristine };

// Whether all pairs of a block of this way are bulk links of one law: no kind is read, nothing is
// unlinked.
constexpr bool onlyBulk(Way way)
{
  return way == Bulk || way == Pristine;
}

// The way of some of its pairs, whatever they are.
constexpr Way anyWay(Way way)
{
  return way == SeveralLaws ? SeveralLaws : OneLaw;
}

// A way as a type, so that a generic lambda can take it as a constant.
template<Way W>
struct WayOf {
  static constexpr Way way = W;
};

// Calls work(block, its way as a type, first pair, number of pairs) for all blocks in their order,
// one after the other: the decision is taken once for 128 pairs. The number is blockLength but for
// the last block, where columns hold the last pair again or what is left of the block before.
// \param p     a whole list or a part of it that begins with a block
// \param work  a generic lambda, compiled for each way; it may change the block's flags
template<class Work>
inline void eachBlock(const Pairs &p, const Work &work)
{
  Block *block = p.blocks;
  for (int first = 0; first < p.n; first += blockLength, block++) {
    const int n = lesser(blockLength, p.n - first);
    if (block->law == Block::mixed)
      work(*block, WayOf<SeveralLaws>(), first, n);
    else if (!block->bulk)
      work(*block, WayOf<OneLaw>(), first, n);
    else if (block->pristine)
      work(*block, WayOf<Pristine>(), first, n);
    else
      work(*block, WayOf<Bulk>(), first, n);
  }
}

// Calls work(criterion) with an object of the criterion's type. Laws of a run have one criterion,
// so that of the first pair holds for all; without pairs nothing is called. One decision a pass.
// \param laws  table of PairLaw
template<class Work>
inline void withCriterion(const Pairs &p, const PairLaw *laws, const Work &work)
{
  if (p.n > 0)
    FractureCriteria::with(laws[p.law[0]].limits.criterion, work);
}

// Rows of motion where the pairs of a block meet: those of periodic images for a block across a
// face, else those of the automata themselves. placesI() is of the first automaton, placesJ() of
// the second.
// \param first  first pair of the block
inline const int *placesI(const Pairs &p, const Block &block, int first)
{
  return (block.across ? p.placeI : p.i) + first;
}

// Likewise of the second automaton.
inline const int *placesJ(const Pairs &p, const Block &block, int first)
{
  return (block.across ? p.placeJ : p.j) + first;
}

// A quantity of a block's pairs: numbers in one array, or vectors in two or three. get() and set()
// take the number of a pair within the block, from 0; the constructor takes the arrays of all
// pairs, one for each component, and the first pair of the block. Captured by value in a loop's
// lambda, so that the pointers stay in registers.
template<class Value>
struct PairArray;

// One number a pair, as the shear in the plane: the only array that exists is that of component 0.
template<>
struct PairArray<double> {
  double *x;

  PairArray(double *const *arrays, int first) : x(arrays[0] + first) {}
  double get(int k) const { return x[k]; }
  void set(int k, double v) const { x[k] = v; }
};

// Two numbers a pair, as the normal in the plane; of three arrays the first two.
template<>
struct PairArray<PlaneVector> {
  double *x, *y;

  PairArray(double *const *arrays, int first) : x(arrays[0] + first), y(arrays[1] + first) {}
  PlaneVector get(int k) const { return {x[k], y[k]}; }
  void set(int k, const PlaneVector &v) const
  {
    x[k] = v.x;
    y[k] = v.y;
  }
};

// Three numbers a pair, as normals and shears in space.
template<>
struct PairArray<Vector> {
  double *x, *y, *z;

  PairArray(double *const *arrays, int first)
      : x(arrays[0] + first), y(arrays[1] + first), z(arrays[2] + first)
  {
  }
  Vector get(int k) const { return {x[k], y[k], z[k]}; }
  void set(int k, const Vector &v) const
  {
    x[k] = v.x;
    y[k] = v.y;
    z[k] = v.z;
  }
};

// One of two values without a branch: the first where `first` is 1, the second where it is 0. The
// forms differ, since each leaves its loop's other terms as they are, to the last bit.
// \param first  1 or 0, as double: link::linked() and the like
// \param a,b    both are computed. In the plane, shears are plain numbers [-].
inline double choose(double first, double a, double b)
{
  return first > 0.0 ? a : b;
}

// In space: a sum of both, each with its factor. Both have to be finite, else 0 times the other one
// is none.
inline Vector choose(double first, const Vector &a, const Vector &b)
{
  return first * a + (1.0 - first) * b;
}

// Whether two shears are equal in all components; +0 and -0 are, and what is no number is not.
// Without a branch.
inline bool equal(double a, double b)
{
  return a == b;
}

inline bool equal(const Vector &a, const Vector &b)
{
  return (a.x == b.x) & (a.y == b.y) & (a.z == b.z);
}

// The first component of the total shear of an unlinked contact holds its plastic work per volume
// while pressed together [stress], PairState::gammaTotal. In the plane that is the number itself,
// in space x.
inline const double &firstComponent(const double &a)
{
  return a;
}

inline const double &firstComponent(const Vector &a)
{
  return a.x;
}

inline double &firstComponent(double &a)
{
  return a;
}

inline double &firstComponent(Vector &a)
{
  return a.x;
}

// Brings the whole state of a block up to date, whose links will not be alike any more: the total
// shear, which a pristine block does not keep, becomes a copy of the elastic one. Called by the
// pass that knows that a link of the block breaks, before anything reads the total shear.
// \param p        pairs of the pass; first counts from their beginning
// \param first,n  pairs of the block
// \param shears   components of a shear
inline void leavePristine(const Pairs &p, Block &block, int first, int n, int shears)
{
  for (int m = 0; m < shears; m++)
    for (int k = first; k < first + n; k++)
      p.now.gammaTotal[m][k] = p.now.gamma[m][k];
  block.pristine = false;
}

// The centre of an automaton's return: the mean of sigma over the contacts that flow with it, by
// their weights [stress], 0 without any.
// \param response  row of the automaton, written
// \param stress    its row of the stress pass
// \param contacts  sum of the weights of those that flow with it
template<const RowLayout &ROWS>
inline void meanOfFlow(double *response, const double *stress, double contacts)
{
  response[ROWS.response.centre] = stress[ROWS.stress.flowing] / (contacts > 0.0 ? contacts : 1.0);
}

// Answers of one automaton of each pair with plasticity isochoric; see Answer of contact.h. Pairs
// past n are made up of the last one.
template<const RowLayout &ROWS>
struct RoomAnswers {
  Column mean, room, factor, centre;

  // All four values.
  // \param index     row of the automaton of each pair: Pairs::i or Pairs::j
  // \param response  ROWS.response.length values an automaton
  void gather(const int *index, int n, const double *response)
  {
    mca::MCA_ISA::gather(index, n, response, mean, room, factor, centre);
  }
  // The mean stresses alone, for the stress pass, when the other values are not known yet.
  void gatherMeans(const int *index, int n, const double *response)
  {
    gatherOne<ROWS.response.length>(index, n, response + ROWS.response.mean, mean);
  }
  Answer operator[](int k) const { return {mean[k], factor[k], centre[k], room[k]}; }
};

// What a pass over a block has changed, counted as doubles, since loops add them up as vectors.
// kinds > 0 has events looked for when the step is taken over, states > 0 has the next state copied
// then.
struct Changes {
  double kinds, states; // pairs whose kind, whose state as a whole changes
};

} // namespace
} // namespace mca::MCA_ISA

#endif
