// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_few.h
/// The few pairs of a block that do more than carry their elastic stress, as a block of their own:
/// contacts that touch, links that flow or break. For the kernel's source only.
/// The loops of kernel_force.h work on what is picked here as on any block, so that a pair's result
/// does not depend on how it came in.
#ifndef MCA_KERNEL_FEW_H
#define MCA_KERNEL_FEW_H

#include "kernel_blocks.h"

#include <cstdint>

namespace mca::MCA_ISA {
namespace {

// Sets the bits of a block's pairs k < n for which which(k) is true.
template<class Which>
inline BlockMask maskOf(int n, const Which &which)
{
  BlockMask mask{};
  for (int word = 0; word < BlockMask::words; word++) {
    const int from = 64 * word, to = lesser(from + 64, n);
    std::uint64_t bits = 0;
#pragma omp simd reduction(| : bits)
    for (int k = from; k < to; k++)
      bits |= static_cast<std::uint64_t>(which(k) ? 1 : 0) << (k - from);
    mask.bits[word] = bits;
  }
  return mask;
}

// The first n pairs of a block.
inline BlockMask maskOfFirst(int n)
{
  BlockMask mask{};
  for (int word = 0; word < BlockMask::words; word++) {
    const int left = n - 64 * word;
    if (left > 0)
      mask.bits[word] = ~std::uint64_t{0} >> (left < 64 ? 64 - left : 0);
  }
  return mask;
}

// What is missing of M of both automata of each pair [-]: 0 where neither flows.
template<class D>
inline void gatherFlow(const int *pi, const int *pj, int n, const double *response, Column &missing)
{
  constexpr RowLayout::Response at = D::rows.response;
  Column ofJ;
  gatherOne<at.length>(pi, n, response + at.factor, missing);
  gatherOne<at.length>(pj, n, response + at.factor, ofJ);
  for (int k = 0; k < n; k++)
    missing[k] = (1.0 - missing[k]) + (1.0 - ofJ[k]);
}

// Pairs with an automaton that flows.
// \param missing  a column for the loop
template<class D>
MCA_CALLED BlockMask flowingPairs(const Pairs &p, int first, int n, const double *response,
                                  Column &missing)
{
  gatherFlow<D>(p.i + first, p.j + first, n, response, missing);
  return maskOf(n, [&](int k) { return missing[k] != 0.0; });
}

// Pairs that are neither bulk links that hold, nor apart for good or with a dent that they keep.
// With those that flow they are all that do more than bear their elastic stress. Criterion: decides
// by strain only; void: which bulk links break is not looked at.
template<class D, Way W, class Criterion>
MCA_LOOP BlockMask busyPairs(const Pairs &p, int first, int n, const PairLaw *laws)
{
  using Shear = typename D::Shear;
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first;
  const PairArray<Shear> totals(W == Pristine ? p.now.gamma : p.now.gammaTotal, first);
  const LinkLimits one = laws[plaw[0]].limits;
  return maskOf(n, [=, &one](int k) {
    const LinkLimits &limits = W == SeveralLaws ? laws[plaw[k]].limits : one;
    const double kind = pkind[k], eps = peps[k], plastic = pplastic[k];
    const Shear total = totals.get(k);
    const bool bulk = onlyBulk(W) || kind == link::bulk;
    bool breaking = false;
    if constexpr (!std::is_void_v<Criterion>)
      breaking = breaks<Criterion>(LinkStrain<Shear>{eps, total}, limits.fracture);
    const bool keepsDent = (plastic == 0.0) | (eps <= (plastic > 0.0 ? plastic : 0.0));
    const bool apart = (kind == link::none) & !isPressed(eps - plastic) & keepsDent &
                       equal(total, Shear{}) & (limits.linkPressure > 0.0);
    return !((bulk & !breaking) | apart);
  });
}

// Bulk links that break by a criterion of stresses if neither of their automata flows.
// \param local        means of both automata of each pair, of gatherMeans(); only for criteria that
//                     need the local stress
// \param meanI,meanJ  mean stresses of both [stress]
template<class D, Way W, class Criterion>
MCA_LOOP BlockMask breakingLinks(const Pairs &p, int first, int n, const PairLaw *laws,
                                 const double *local, const Column &meanI, const Column &meanJ)
{
  using Shear = typename D::Shear;
  constexpr RowLayout::Local at = D::rows.local;
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first, *const psigma = p.sigma + first;
  const PairArray<Shear> gammas(p.now.gamma, first);
  const PairArray<Shear> totals(W == Pristine ? p.now.gamma : p.now.gammaTotal, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  const PairLaw one = laws[plaw[0]];
  auto breaking = [=, &one, &meanI, &meanJ](int k) {
    const PairLaw &law = W == SeveralLaws ? laws[plaw[k]] : one;
    Contact c{};
    c.kind = link::bulk;
    c.eps = peps[k];
    c.plastic = W == Pristine ? 0.0 : pplastic[k];
    c.gammaTotal = shearSize(totals.get(k));
    const Answer i = {meanI[k], 1.0, 0.0, 0.0}, j = {meanJ[k], 1.0, 0.0, 0.0};
    LocalStress face = {};
    if (Criterion::needsLocalStress)
      face = faceStress(D::localTensor(local + at.length * k + at.tensor, 0.5 * (i.mean + j.mean)),
                        normals.get(k));
    const ElasticStresses s = {psigma[k], psigma[k], law.twoG * shearSize(gammas.get(k))};
    return (onlyBulk(W) | (pkind[k] == link::bulk)) &
           breaks<Criterion>(linkLoad(law, c, s, i, j, face), law.limits.fracture);
  };
  double broken = 0.0;
#pragma omp simd reduction(+ : broken)
  for (int k = 0; k < n; k++)
    broken += breaking(k) ? 1.0 : 0.0;
  return broken == 0.0 ? BlockMask{} : maskOf(n, breaking);
}

// Some pairs of a block: their numbers in it, and copies of what the loops read.
template<class D>
class Picked {
 public:
  // More pairs of a block than these are not few: it is worked on as a whole.
  static constexpr int most = blockLength / 2;

  // Chooses the pairs of a mask.
  MCA_CALLED void choose(const BlockMask &mask)
  {
    count_ = 0;
    mask.each([this](int k) { number_[count_++] = k; });
  }

  // Copies the chosen ones, at least one.
  // \param p,first   the block
  // \param pristine  it keeps no total shear of its own
  MCA_CALLED void copy(const Pairs &p, int first, bool pristine)
  {
    padded_ = (count_ + group - 1) / group * group;
    for (int k = count_; k < padded_; k++)
      number_[k] = number_[count_ - 1];
    double *const *const totals = pristine ? p.now.gamma : p.now.gammaTotal;
    for (int k = 0; k < padded_; k++) {
      const int from = first + number_[k];
      i_[k] = p.i[from];
      j_[k] = p.j[from];
      law_[k] = p.law[from];
      kind_[k] = p.now.kind[from];
      plastic_[k] = p.now.plastic[from];
      eps_[k] = p.eps[from];
      ratio_[k] = p.ratio[from];
      sigma_[k] = p.sigma[from];
      separation_[k] = p.separation[from];
      for (int m = 0; m < D::shears; m++) {
        gamma_[m][k] = p.now.gamma[m][from];
        total_[m][k] = totals[m][from];
      }
      for (int m = 0; m < D::rows.dimension; m++)
        normal_[m][k] = p.normal[m][from];
    }
  }

  int count() const { return count_; }
  // Up to a whole group the last pair again.
  int padded() const { return padded_; }
  int number(int k) const { return number_[k]; }

  // They as a block of a list, from its pair 0 on; next states come into columns of this object.
  Pairs pairs()
  {
    Pairs p{};
    p.n = padded_;
    p.i = i_;
    p.j = j_;
    p.law = law_;
    p.eps = eps_.value;
    p.ratio = ratio_.value;
    p.sigma = sigma_.value;
    p.separation = separation_.value;
    p.now.kind = kind_.value;
    p.now.plastic = plastic_.value;
    p.next.kind = kindNext_.value;
    p.next.plastic = plasticNext_.value;
    for (int m = 0; m < D::shears; m++) {
      p.now.gamma[m] = gamma_[m].value;
      p.now.gammaTotal[m] = total_[m].value;
      p.next.gamma[m] = gammaNext_[m].value;
      p.next.gammaTotal[m] = totalNext_[m].value;
    }
    for (int m = 0; m < D::rows.dimension; m++)
      p.normal[m] = normal_[m].value;
    return p;
  }

  // How many change their kind.
  double changes() const
  {
    double changed = 0.0;
    for (int k = 0; k < count_; k++)
      changed += kind_[k] == kindNext_[k] ? 0.0 : 1.0;
    return changed;
  }

  // Writes the next state of the whole block: theirs, of all others the present one.
  MCA_CALLED void putNext(const Pairs &p, int first, int n, bool pristine) const
  {
    const PairState &now = p.now, &next = p.next;
    auto copy = [=](const double *from, double *to) {
      for (int k = first; k < first + n; k++)
        to[k] = from[k];
    };
    copy(now.kind, next.kind);
    copy(now.plastic, next.plastic);
    for (int m = 0; m < D::shears; m++) {
      copy(now.gamma[m], next.gamma[m]);
      copy(pristine ? now.gamma[m] : now.gammaTotal[m], next.gammaTotal[m]);
    }
    for (int k = 0; k < count_; k++) {
      const int to = first + number_[k];
      next.kind[to] = kindNext_[k];
      next.plastic[to] = plasticNext_[k];
      for (int m = 0; m < D::shears; m++) {
        next.gamma[m][to] = gammaNext_[m][k];
        next.gammaTotal[m][to] = totalNext_[m][k];
      }
    }
  }

 private:
  // Pairs that are worked on at the same time; those picked are filled up to whole groups, since
  // the rest of a loop that is no whole vector takes as long as the vectors.
  static constexpr int group = 8;

  int count_ = 0, padded_ = 0;
  int number_[blockLength], i_[blockLength], j_[blockLength], law_[blockLength];
  Column kind_, plastic_, eps_, ratio_, sigma_, separation_, kindNext_, plasticNext_;
  Column gamma_[D::shears], total_[D::shears], gammaNext_[D::shears], totalNext_[D::shears];
  Column normal_[D::rows.dimension];
};

} // namespace
} // namespace mca::MCA_ISA

#endif
