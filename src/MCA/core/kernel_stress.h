// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_stress.h
/// The passes from mean stresses to radial returns: stresses of pairs, how automata yield, and what
/// that takes. For the kernel's source only.
#ifndef MCA_KERNEL_STRESS_H
#define MCA_KERNEL_STRESS_H

#include "kernel_few.h"
#include "kernel_plane.h"
#include "kernel_space.h"

namespace mca::MCA_ISA {
namespace {

// Elastic stresses and forces. All that a pair answers that neither touches, flows nor breaks is in
// them, and of the others a part.
template<class D, Way W>
MCA_LOOP void stressBlock(const Pairs &p, int first, int n, const PairLaw *laws,
                          const double *response, typename D::Answers &ofI,
                          typename D::Answers &ofJ, typename D::Shares &shares,
                          typename D::Forces &forces)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first, *const pratio = p.ratio + first;
  double *const psigma = p.sigma + first;
  const PairArray<typename D::Shear> gammas(p.now.gamma, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  ofI.gatherMeans(pi, n, response);
  ofJ.gatherMeans(pj, n, response);
  const PairLaw one = laws[plaw[0]];
  auto share = [=, &one, &ofI, &ofJ, &shares, &forces](int k) {
    const PairLaw &law = W == SeveralLaws ? laws[plaw[k]] : one;
    const double e = W == Pristine ? peps[k] : peps[k] - pplastic[k];
    const typename D::Shear tau = law.twoG * gammas.get(k);
    const typename D::Normal normal = normals.get(k);
    const double linked = onlyBulk(W) ? 1.0 : link::linked(pkind[k]);
    const double pressed = onlyBulk(W) || isPressed(e) ? 1.0 : 0.0;
    const double touching = linked > pressed ? linked : pressed;
    const double sigma = touching * elasticStress(law, e, ofI.mean[k], ofJ.mean[k]);
    psigma[k] = sigma;
    shares.set(k, sigma, tau, normal);
    forces.set(k, contactForce(law, sigma, tau, pratio[k], normal));
    shares.setFlowing(k, onlyBulk(W) ? sigma : flowing(law.contactsFlow, pkind[k], e) * sigma);
  };
#pragma omp simd
  for (int k = 0; k < n; k++)
    share(k);
}

template<class D>
void stressPass(const Pairs &p, const PairLaw *laws, const double *response, double *sums)
{
  typename D::Answers ofI, ofJ;
  typename D::Shares shares;
  typename D::Forces forces;
  eachBlock(p, [&](Block &, auto way, int first, int n) {
    stressBlock<D, way.way>(p, first, n, laws, response, ofI, ofJ, shares, forces);
    scatterBoth<D::rows.dimension>(p.i + first, p.j + first, n, shares.row, forces.row, sums);
  });
}

// How many automata may have an intensity above their yield stress: 0 where no one has. By squares,
// which need no root, less than rounding can make of them.
template<class D, bool ONE>
MCA_LOOP double aboveLoop(int n, const int *type, const AutomatonLaw *laws, const double *stresses,
                          const double *kappa, const double *response)
{
  constexpr RowLayout rows = D::rows;
  constexpr double rounding = 1e-12;
  const AutomatonLaw one = laws[type[0]];
  double above = 0.0;
#pragma omp simd reduction(+ : above)
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = ONE ? one : laws[type[i]];
    const double mean = response[rows.response.length * i + rows.response.mean];
    const double *const tensor = stresses + rows.stress.length * i + rows.stress.tensor;
    const double limit = law.curve(kappa[i]);
    above += squaredIntensity(D::averaged(law, tensor, mean)) > (1.0 - rounding) * limit * limit
                 ? 1.0
                 : 0.0;
  }
  return above;
}

template<class D, bool ONE>
MCA_LOOP double yieldLoop(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                          const double *stresses, const double *kappa, double *kappaNext,
                          double *response)
{
  constexpr RowLayout rows = D::rows;
  const AutomatonLaw one = laws[type[0]];
  double flowing = 0.0;
#pragma omp simd reduction(+ : flowing)
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = ONE ? one : laws[type[i]];
    const double *const row = stresses + rows.stress.length * i;
    double *const answer = response + rows.response.length * i;
    const StressTensor s = D::averaged(law, row + rows.stress.tensor, answer[rows.response.mean]);
    const RadialReturn back =
        radialReturn(stressIntensity(s), law.curve(kappa[i]), law.shearModulus, law.mostReturn);
    // without a contact that flows with it an automaton cannot flow
    const double contacts = strains[rows.strain.length * i + rows.strain.flowing];
    const double flows = law.yields * contacts > 0.0 ? 1.0 : 0.0;
    kappaNext[i] = kappa[i] + flows * (contacts < 1.0 ? contacts : 1.0) * back.strain;
    answer[rows.response.factor] = flows * back.factor + (1.0 - flows);
    D::setCentre(answer, row, contacts);
    const bool rests = (kappaNext[i] == kappa[i]) & (answer[rows.response.factor] == 1.0);
    flowing += rests ? 0.0 : 1.0;
  }
  return flowing;
}

template<class D>
double yieldPass(int n, const int *type, const AutomatonLaw *laws, bool oneLaw, bool flowed,
                 const double *strains, const double *stresses, const double *kappa,
                 double *kappaNext, double *response)
{
  if (n == 0)
    return 0.0;
  // mostly no automaton of a span yields, and then what it answered stays
  const double above = oneLaw ? aboveLoop<D, true>(n, type, laws, stresses, kappa, response)
                              : aboveLoop<D, false>(n, type, laws, stresses, kappa, response);
  if (above > 0.0)
    return oneLaw
               ? yieldLoop<D, true>(n, type, laws, strains, stresses, kappa, kappaNext, response)
               : yieldLoop<D, false>(n, type, laws, strains, stresses, kappa, kappaNext, response);
  constexpr double none[D::rows.stress.length] = {};
  for (int i = 0; i < n && flowed; i++) {
    double *const answer = response + D::rows.response.length * i;
    answer[D::rows.response.factor] = 1.0;
    D::setCentre(answer, none, 0.0);
  }
  return 0.0;
}

template<class D, Way W>
MCA_LOOP void returnBlock(const Pairs &p, int first, int n, const PairLaw *laws,
                          const double *response, typename D::Answers &ofI,
                          typename D::Answers &ofJ, typename D::Shares &shares)
{
  ofI.gather(p.i + first, n, response);
  ofJ.gather(p.j + first, n, response);
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first;
  const PairArray<typename D::Shear> gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  const PairLaw one = laws[plaw[0]];
  auto share = [=, &one, &ofI, &ofJ, &shares](int k) {
    const PairLaw &law = W == SeveralLaws ? laws[plaw[k]] : one;
    const double e = W == Pristine ? peps[k] : peps[k] - pplastic[k];
    const double linked = onlyBulk(W) ? 1.0 : link::linked(pkind[k]);
    const double flows = onlyBulk(W) ? 1.0 : flowing(law.contactsFlow, pkind[k], e);
    const Answer i = ofI[k], j = ofJ[k];
    const double left = returnedShare(i, j);
    const typename D::Shear gamma = gammas.get(k);
    const Stretch stretch =
        D::stretch(left, gamma, [&] { return W == Pristine ? gamma : linked * totals.get(k); });
    const double trial = elasticStress(law, e, i.mean, j.mean);
    const double plastic = W == Pristine ? 0.0 : pplastic[k];
    const double sigma = flowedStress(law, trial, plastic, flows, stretch, linked, i, j);
    const double tau = (flows > 0.0 ? 1.0 : 0.0) * (left - 1.0) * law.twoG;
    shares.set(k, flows > 0.0 ? sigma - trial : 0.0, tau * gamma, normals.get(k));
    if constexpr (D::keepsVolume) {
      const double shear = law.twoG * law.twoG * dot(gamma, gamma);
      const double returned = returnedStress(trial, flows, i, j);
      const double off = linked * stretchedOff(law, returned, stretch);
      const double stretched = left < 1.0 ? returned * off / (1.0 - left) : 0.0;
      shares.setFlowing(k, flows > 0.0 ? flows * trial * trial + shear + stretched : 0.0);
    }
  };
#pragma omp simd
  for (int k = 0; k < n; k++)
    share(k);
}

template<class D>
void returnPass(const Pairs &p, const PairLaw *laws, const double *response, double *taken)
{
  typename D::Answers ofI, ofJ;
  typename D::Shares shares;
  Column missing;
  Picked<D> few;
  eachBlock(p, [&](Block &block, auto way, int first, int n) {
    if (!block.flows)
      return;
    // of a pair that does not flow nothing is taken
    block.flowing = flowingPairs<D>(p, first, n, response, missing);
    few.choose(block.flowing);
    const bool pristine = way.way == Pristine;
    if (few.count() == 0)
      return;
    if (few.count() > Picked<D>::most) {
      returnBlock<D, way.way>(p, first, n, laws, response, ofI, ofJ, shares);
      shares.row.template scatter<0>(p.i + first, p.j + first, n, taken);
      return;
    }
    few.copy(p, first, pristine);
    returnBlock<D, way.way>(few.pairs(), 0, few.padded(), laws, response, ofI, ofJ, shares);
    shares.row.template scatter<0>(few.pairs().i, few.pairs().j, few.count(), taken);
  });
}

template<class D>
void secondYieldPass(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                     const double *stresses, const double *taken, const double *kappa,
                     double *kappaNext, double *response)
{
  constexpr RowLayout rows = D::rows;
  for (int i = 0; i < n; i++) {
    double *const answer = response + rows.response.length * i;
    const double factor = answer[rows.response.factor], mean = answer[rows.response.mean];
    if (factor == 1.0)
      continue;
    const AutomatonLaw &law = laws[type[i]];
    const double *const row = stresses + rows.stress.length * i + rows.stress.tensor;
    const double *const less = taken + rows.taken.length * i + rows.stress.tensor;
    double after[rows.components];
    for (int m = 0; m < rows.components; m++)
      after[m] = row[m] + less[m];
    const double intensity = stressIntensity(D::averaged(law, row, mean));
    const RadialReturn back =
        secondReturn(factor, intensity, stressIntensity(D::averaged(law, after, mean)),
                     law.curve(kappa[i]), law.shearModulus, law.mostReturn);
    double strain;
    if constexpr (D::keepsVolume) {
      // sum f (sigma - centre)^2 = sum f sigma^2 - centre sum f sigma
      const double squares =
          taken[rows.taken.length * i + rows.stress.flowing] -
          answer[rows.response.centre] * stresses[rows.stress.length * i + rows.stress.flowing];
      strain = strainOfWork(1.0 - back.factor, squares, intensity, law.shearModulus, law.weight);
    } else {
      const double contacts = strains[rows.strain.length * i + rows.strain.flowing];
      strain = (contacts < 1.0 ? contacts : 1.0) * back.strain;
    }
    kappaNext[i] = kappa[i] + strain;
    answer[rows.response.factor] = back.factor;
  }
}

} // namespace
} // namespace mca::MCA_ISA

#endif
