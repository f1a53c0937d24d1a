// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_force.h
/// The pass from returns to forces and next states. For the kernel's source only.
/// The elastic forces of all pairs come from the stress pass. What is added here is all that a pair
/// answers beside them, by the differences of its stresses: exactly nothing where it neither
/// touches, flows, breaks nor lacks room, so that a sum does not depend on the ways of its blocks.
#ifndef MCA_KERNEL_FORCE_H
#define MCA_KERNEL_FORCE_H

#include "kernel_few.h"
#include "kernel_plane.h"
#include "kernel_space.h"

namespace mca::MCA_ISA {
namespace {

// One block, pair by pair without a branch: stresses after the return, the next kind, what that
// adds to the elastic force, and the next state. All next states are written; whether they count is
// what the sums of differences say. LOCAL: criteria of local stress or of plastic work act.
template<class D, Way W, class Criterion, bool LOCAL>
MCA_LOOP Changes forceBlock(const Pairs &p, int first, int n, const PairLaw *laws,
                            const double *local, const typename D::Answers &ofI,
                            const typename D::Answers &ofJ, typename D::Forces &forces)
{
  using Shear = typename D::Shear;
  constexpr RowLayout::Local at = D::rows.local;
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pratio = p.ratio + first, *const peps = p.eps + first;
  const double *const psep = p.separation + first, *const psigma = p.sigma + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  const PairArray<Shear> gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const PairArray<Shear> gammas1(p.next.gamma, first), totals1(p.next.gammaTotal, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  const PairLaw one = laws[plaw[0]];
  // returns how much of its state changes
  auto answer = [=, &one, &ofI, &ofJ, &forces](int k) {
    const PairLaw &law = W == SeveralLaws ? laws[plaw[k]] : one;
    const double kind = pkind[k], plastic = pplastic[k], eps = peps[k];
    const Shear gamma = gammas.get(k);
    const Answer i = ofI[k], j = ofJ[k];
    const double linked = link::linked(kind);
    const Shear stored = totals.get(k), total = linked * stored; // else it holds plastic work
    LocalStress face = {};
    double work = 0.0;
    if (LOCAL) {
      const double *const row = local + at.length * k;
      const double pressed = isPressed(eps - plastic) ? 1.0 : 0.0;
      if (Criterion::needsLocalStress)
        face = faceStress(D::localTensor(row + at.tensor, 0.5 * (i.mean + j.mean)), normals.get(k));
      work = (1.0 - linked) * pressed * law.limits.countsWork *
             (firstComponent(stored) + row[at.work]);
    }
    const double size = shearSize(gamma), share = returnedShare(i, j);
    const Stretch stretch = D::stretch(share, gamma, [&] { return total; });
    Contact c;
    c.kind = kind;
    c.ratio = pratio[k];
    c.eps = eps;
    c.plastic = plastic;
    c.gamma = size;
    c.gammaTotal = shearSize(total);
    c.separation = psep[k];
    c.stretch = stretch;
    const ContactStress s =
        contactStress<Criterion>(law, c, i, j, face, LOCAL && work >= law.limits.linkWork);
    // exactly the same where nothing flows, so that a pair's way does not depend on its block
    const double left = flowing(law.contactsFlow, kind, eps - plastic) > 0.0 ? share : 1.0;
    const ShearAnswer<Shear> shear = shearAnswer(law, gamma, size, s, left);
    NextState<Shear> next = nextState(law, c, s, gamma, total, shear.left);
    firstComponent(next.gammaTotal) += (1.0 - link::linked(s.kindNext)) * work;
    kind1[k] = s.kindNext;
    plastic1[k] = next.plastic;
    gammas1.set(k, next.gamma);
    totals1.set(k, next.gammaTotal);
    forces.set(k, contactForce(law, s.normal - psigma[k], shear.acting - law.twoG * gamma,
                               pratio[k], normals.get(k)));
    return (kind == s.kindNext ? 0.0 : 1.0) + (plastic == next.plastic ? 0.0 : 1.0) +
           (equal(gamma, next.gamma) ? 0.0 : 1.0) + (equal(stored, next.gammaTotal) ? 0.0 : 1.0);
  };
  double kinds = 0.0, states = 0.0;
#pragma omp simd reduction(+ : states)
  for (int k = 0; k < n; k++)
    states += answer(k);
#pragma omp simd reduction(+ : kinds)
  for (int k = 0; k < n; k++)
    kinds += pkind[k] == kind1[k] ? 0.0 : 1.0;
  return {kinds, states};
}

// Bulk links of one law: what they add to their elastic forces. The next state is written where
// something flows, else it is the present one.
// Criterion: by which a link may break, known from here on; void where the strain pass knew that
//            none does. Returns how many break.
template<class D, bool PristineBlock, bool Flows, class Criterion>
MCA_LOOP double bulkForceBlock(const Pairs &p, int first, int n, const PairLaw *laws,
                               const double *local, const typename D::Answers &ofI,
                               const typename D::Answers &ofJ, typename D::Forces &forces)
{
  using Shear = typename D::Shear;
  constexpr RowLayout::Local at = D::rows.local;
  const double *const pplastic = p.now.plastic + first, *const peps = p.eps + first;
  const double *const pratio = p.ratio + first, *const psigma = p.sigma + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  const PairArray<Shear> gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const PairArray<Shear> gammas1(p.next.gamma, first), totals1(p.next.gammaTotal, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  const PairLaw law = laws[p.law[first]];
  auto answer = [=, &law, &ofI, &ofJ, &forces](int k) {
    const double plastic = PristineBlock ? 0.0 : pplastic[k], ratio = pratio[k];
    const double trial = psigma[k];
    const Shear gamma = gammas.get(k);
    const Shear total = PristineBlock ? gamma : totals.get(k);
    const Answer i = ofI[k], j = ofJ[k];
    double room = 0.0, sigma = trial, left = 1.0;
    if constexpr (D::keepsVolume)
      room = roomStress(ratio, i.room, j.room);
    if (Flows) {
      left = returnedShare(i, j);
      const Stretch stretch = D::stretch(left, gamma, [&] { return total; });
      sigma = flowedStress(law, trial, plastic, 1.0, stretch, 1.0, i, j);
      kind1[k] = link::bulk;
      plastic1[k] = plastic + (trial - sigma) * law.invTwoG;
      gammas1.set(k, left * gamma);
      totals1.set(k, total);
      const Shear less = returnedShear(left, law.twoG, gamma) - law.twoG * gamma;
      forces.set(k, contactForce(law, sigma + room - trial, less, ratio, normals.get(k)));
    } else {
      forces.set(k, contactForce(law, room, Shear{}, ratio, normals.get(k)));
    }
    if constexpr (std::is_void_v<Criterion>) {
      return 0.0;
    } else {
      Contact c{};
      c.kind = link::bulk;
      c.eps = peps[k];
      c.plastic = plastic;
      c.gammaTotal = shearSize(total);
      LocalStress face = {};
      if (Criterion::needsLocalStress)
        face =
            faceStress(D::localTensor(local + at.length * k + at.tensor, 0.5 * (i.mean + j.mean)),
                       normals.get(k));
      const double tau = law.twoG * shearSize(gamma);
      const ElasticStresses s = {trial, sigma, Flows ? left * tau : tau};
      return breaks<Criterion>(linkLoad(law, c, s, i, j, face), law.limits.fracture) ? 1.0 : 0.0;
    }
  };
  double breaking = 0.0;
#pragma omp simd reduction(+ : breaking)
  for (int k = 0; k < n; k++)
    breaking += answer(k);
  return breaking;
}

template<class D>
class ForcePassOf {
 public:
  ForcePassOf(const PairLaw *laws, const double *response, bool returned, const double *local,
              double *forces)
      : laws_(laws), response_(response), returned_(returned), local_(local), forces_(forces)
  {
  }

  // Returns how many pairs of the block change their kind.
  template<class Criterion, Way W>
  double work(const Pairs &p, Block &block, int first, int n)
  {
    const int *const pi = p.i + first, *const pj = p.j + first;
    const bool bulk = onlyBulk(W) && !block.breaks;
    double changed = 0.0;
    if (!block.crowded && workFew<Criterion, W>(p, block, first, n, changed))
      return changed;
    block.busy = maskOfFirst(n);
    gather(pi, pj, n);
    if (Criterion::needsLocalStress || (local_ && !bulk))
      gatherMeans<D::rows.local.length>(pi, pj, n, local_, means_);
    if (!bulk || !workBulk<Criterion, W>(p, block, first, n))
      changed = workAny<Criterion, W>(p, block, first, n);
    else if (!block.moves && !block.crowded)
      return 0.0;
    add(pi, pj, n);
    return changed;
  }

 private:
  const PairLaw *laws_;
  const double *response_;
  bool returned_;
  const double *local_;
  double *forces_;
  typename D::Answers ofI_, ofJ_;
  typename D::Forces more_; // than the elastic forces
  Column missing_;
  Picked<D> few_;
  alignas(64) double means_[blockLength * D::rows.local.length];

  // What both automata of n pairs answer.
  MCA_CALLED void gather(const int *pi, const int *pj, int n)
  {
    ofI_.gather(pi, n, response_);
    ofJ_.gather(pj, n, response_);
  }

  // Adds what the first n pairs have in more_.
  MCA_CALLED void add(const int *pi, const int *pj, int n)
  {
    constexpr RowLayout rows = D::rows;
    more_.row.template scatter<rows.dimension, rows.force.length / 4>(pi, pj, n,
                                                                      forces_ + rows.force.force);
  }

  // Only the few pairs that do more than bear elastic stresses. Returns false if these are many;
  // then nothing is done.
  template<class Criterion, Way W>
  bool workFew(const Pairs &p, Block &block, int first, int n, double &changed)
  {
    constexpr bool pristine = W == Pristine;
    if constexpr (!Criterion::strainOnly) {
      block.busy = busyPairs<D, W, void>(p, first, n, laws_);
      block.busy.add(breaking<Criterion, W>(p, first, n));
    }
    if (block.flows)
      block.busy.add(returned_ ? block.flowing : flowingPairs<D>(p, first, n, response_, missing_));
    few_.choose(block.busy);
    if (few_.count() > Picked<D>::most)
      return false;
    block.moves = block.changes = false;
    if (few_.count() == 0)
      return true;
    few_.copy(p, first, pristine);
    const Pairs picked = few_.pairs();
    gather(picked.i, picked.j, few_.padded());
    const double states = answerFew<Criterion, W>(block, picked);
    add(picked.i, picked.j, few_.count());
    if (states > 0.0) {
      few_.putNext(p, first, n, pristine);
      changed = few_.changes();
      block.moves = true;
      block.changes = changed > 0.0;
      if (pristine && block.changes)
        leavePristine(p, block, first, n, D::shears);
    }
    return true;
  }

  // Links of a block that break by a criterion of stresses though nothing flows.
  template<class Criterion, Way W>
  BlockMask breaking(const Pairs &p, int first, int n)
  {
    const int *const pi = p.i + first, *const pj = p.j + first;
    if (Criterion::needsLocalStress)
      gatherMeans<D::rows.local.length>(pi, pj, n, local_, means_);
    ofI_.gatherMeans(pi, n, response_);
    ofJ_.gatherMeans(pj, n, response_);
    return breakingLinks<D, W, Criterion>(p, first, n, laws_, means_, ofI_.mean, ofJ_.mean);
  }

  // What the few answer, by the loops that a whole block of this way takes. Returns whether a state
  // changes: > 0.
  template<class Criterion, Way W>
  double answerFew(const Block &block, const Pairs &few)
  {
    if constexpr (onlyBulk(W) && Criterion::strainOnly)
      if (!block.breaks) { // so they flow
        bulkForceBlock<D, W == Pristine, true, void>(few, 0, few.n, laws_, nullptr, ofI_, ofJ_,
                                                     more_);
        return 1.0;
      }
    if (local_)
      gatherMeans<D::rows.local.length>(few.i, few.j, few.n, local_, means_);
    return forcesOfAny<Criterion, anyWay(W)>(few, 0, few.n).states;
  }

  // Returns false if a link breaks; then the block has to go another way.
  template<class Criterion, Way W>
  bool workBulk(const Pairs &p, Block &block, int first, int n)
  {
    if constexpr (onlyBulk(W)) {
      using Open = std::conditional_t<Criterion::strainOnly, void, Criterion>;
      constexpr bool pristine = W == Pristine;
      block.moves = block.flows && !allOne(n, ofI_.factor, ofJ_.factor);
      block.changes = false;
      const double breaking = block.moves ? bulkForceBlock<D, pristine, true, Open>(
                                                p, first, n, laws_, means_, ofI_, ofJ_, more_)
                                          : bulkForceBlock<D, pristine, false, Open>(
                                                p, first, n, laws_, means_, ofI_, ofJ_, more_);
      if (breaking == 0.0)
        return true;
      if (pristine)
        leavePristine(p, block, first, n, D::shears);
      if (local_ && !Criterion::needsLocalStress)
        gatherMeans<D::rows.local.length>(p.i + first, p.j + first, n, local_, means_);
    }
    return false;
  }

  // Pairs of any kind; means_ holds theirs where criteria of local stress or plastic work act.
  template<class Criterion, Way W>
  Changes forcesOfAny(const Pairs &p, int first, int n)
  {
    if constexpr (!Criterion::needsLocalStress)
      if (!local_)
        return forceBlock<D, W, Criterion, false>(p, first, n, laws_, nullptr, ofI_, ofJ_, more_);
    return forceBlock<D, W, Criterion, true>(p, first, n, laws_, means_, ofI_, ofJ_, more_);
  }

  template<class Criterion, Way W>
  double workAny(const Pairs &p, Block &block, int first, int n)
  {
    const Changes changes = forcesOfAny<Criterion, anyWay(W)>(p, first, n);
    block.moves = changes.states > 0.0;
    block.changes = changes.kinds > 0.0;
    return changes.kinds;
  }
};

template<class D>
double forcePass(const Pairs &p, const PairLaw *laws, const double *response, bool returned,
                 const double *local,
                 double *forces) // NOLINT(readability-non-const-parameter): a template writes them
{
  ForcePassOf<D> pass(laws, response, returned, local, forces);
  double changed = 0.0;
  withCriterion(p, laws, [&](auto criterion) {
    eachBlock(p, [&](Block &block, auto way, int first, int n) {
      changed += pass.template work<decltype(criterion), way.way>(p, block, first, n);
    });
  });
  return changed;
}

} // namespace
} // namespace mca::MCA_ISA

#endif
