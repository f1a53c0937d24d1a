// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_strain.h
/// The passes from places to mean stresses: strains of pairs, then what automata answer them. For
/// the kernel's source only.
#ifndef MCA_KERNEL_STRAIN_H
#define MCA_KERNEL_STRAIN_H

#include "kernel_few.h"
#include "kernel_plane.h"
#include "kernel_space.h"

namespace mca::MCA_ISA {
namespace {

// Whether the strains of these n pairs are small enough for short series.
inline bool allNear1(int n, const double *ratio)
{
  double far = 0.0;
#pragma omp simd reduction(+ : far)
  for (int k = 0; k < n; k++)
    far += isNear1(ratio[k]) ? 0.0 : 1.0;
  return far == 0.0;
}

// Returns how many links of a bulk block break by strain.
// Criterion: of a bulk block, if it decides by strain only; else void.
template<class D, Way W, class Criterion>
MCA_LOOP double strainBlock(const Pairs &p, Block &block, int first, int n,
                            const typename D::Time &time, const PairLaw *laws, const double *motion,
                            const double *spin, double *strains)
{
  using Shear = typename D::Shear;
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const PairArray<Shear> gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  double *const pratio = p.ratio + first, *const peps = p.eps + first;
  double *const psep = p.separation + first;
  typename D::Motion seen;
  Column es, flow, room;
  double *const taken = room.value; // of the room
  seen.gather(placesI(p, block, first), placesJ(p, block, first), n, motion, spin);
  const double oneInvDiameter = laws[plaw[0]].invDiameter;
  const double oneContactsFlow = laws[plaw[0]].contactsFlow;
  const FractureLimits limits = laws[plaw[0]].limits.fracture;
  const typename D::Time now = time;
  constexpr bool decidesHere = !std::is_void_v<Criterion>;
  constexpr bool knowsNear = D::keepsVolume && onlyBulk(W);
  // what follows from the strain; returns 1 for a link that breaks. total: shear of a bulk link
  auto strain = [=, &es, &flow](int k, double eps, const Shear &total) {
    const double e = W == Pristine ? eps : eps - pplastic[k];
    peps[k] = eps;
    if constexpr (onlyBulk(W)) {
      es.value[k] = e;
      flow.value[k] = 1.0;
      if constexpr (decidesHere)
        return breaks<Criterion>(LinkStrain<Shear>{eps, total}, limits) ? 1.0 : 0.0;
    } else {
      const double linked = link::linked(pkind[k]), pressed = isPressed(e) ? 1.0 : 0.0;
      es.value[k] = (linked > pressed ? linked : pressed) * e;
      flow.value[k] =
          flowing(W == SeveralLaws ? laws[plaw[k]].contactsFlow : oneContactsFlow, pkind[k], e);
    }
    return 0.0;
  };
  // near: std::true_type for short series
  auto move = [=, &seen](int k, auto near) {
    const double invDiameter = W == SeveralLaws ? laws[plaw[k]].invDiameter : oneInvDiameter;
    double r;
    const auto moved = seen.of(k, now, r);
    const Shear growth = shearGrowth(moved);
    const Shear gamma = carriedShear(moved, gammas.get(k)) + growth;
    const double ratio = r * invDiameter;
    const double eps = near.value ? logarithmNear1(ratio) : normalStrain(D::keepsVolume, ratio);
    normals.set(k, moved.normal);
    pratio[k] = ratio;
    if constexpr (D::keepsVolume)
      taken[k] = near.value ? roomTakenNear1(ratio) : roomTaken(roomShare(ratio));
    if constexpr (!decidesHere)
      psep[k] = dot(seen.velocity(k), moved.normal);
    if constexpr (onlyBulk(W)) {
      const Shear total = W == Pristine ? gamma : carriedShear(moved, totals.get(k)) + growth;
      gammas.set(k, gamma);
      if (W == Bulk)
        totals.set(k, total);
      return strain(k, eps, total);
    } else {
      const Shear old = totals.get(k), total = carriedShear(moved, old) + growth;
      const double linked = link::linked(pkind[k]);
      gammas.set(k, choose(linked, gamma, Shear{}));
      totals.set(k, choose(linked, total, old));
      return strain(k, eps, total);
    }
  };
  double breaking = 0.0;
  // NOLINTNEXTLINE(bugprone-branch-clone): they differ where knowsNear
  if (knowsNear && block.near) {
#pragma omp simd reduction(+ : breaking)
    for (int k = 0; k < n; k++)
      breaking += move(k, std::bool_constant<knowsNear>());
  } else {
#pragma omp simd reduction(+ : breaking)
    for (int k = 0; k < n; k++)
      breaking += move(k, std::false_type());
  }
  if (knowsNear) {
    const bool near = allNear1(n, pratio);
    if (block.near && !near) {
      breaking = 0.0;
#pragma omp simd reduction(+ : breaking)
      for (int k = 0; k < n; k++) {
        taken[k] = roomTaken(roomShare(pratio[k]));
        breaking += strain(k, logarithm(pratio[k]), W == Pristine ? gammas.get(k) : totals.get(k));
      }
    }
    block.near = near;
  }
  if (decidesHere && breaking > 0.0) // what breaks under pressure becomes a viscous contact
    for (int k = 0; k < n; k++)
      psep[k] = dot(seen.velocity(k), normals.get(k));
  if constexpr (D::keepsVolume) // the fourth value of a row is unused and takes the third again
    scatter(p.i + first, p.j + first, n, es, flow, room, room, Row4{1.0, 1.0, 1.0, 1.0}, strains);
  else
    scatter(p.i + first, p.j + first, n, es, flow, strains);
  return breaking;
}

template<class D>
void strainPass(const Pairs &p, double dt, bool moves, const PairLaw *laws, const double *motion,
                const double *spin, double *strains)
{
  const typename D::Time time(dt, moves);
  withCriterion(p, laws, [&](auto criterion) {
    using C = decltype(criterion);
    eachBlock(p, [&](Block &block, auto way, int first, int n) {
      // one loop for all that do not decide by strain
      using Known = std::conditional_t<C::strainOnly && onlyBulk(way.way), C, void>;
      const double breaking =
          strainBlock<D, way.way, Known>(p, block, first, n, time, laws, motion, spin, strains);
      block.breaks = breaking > 0.0;
      if constexpr (C::strainOnly)
        block.busy = onlyBulk(way.way) && !block.breaks
                         ? BlockMask{}
                         : busyPairs<D, way.way, C>(p, first, n, laws);
      if (way.way == Pristine && block.breaks)
        leavePristine(p, block, first, n, D::shears);
    });
  });
}

template<class D>
double meanPass(int n, const int *type, const AutomatonLaw *laws, bool oneLaw,
                const double *strains, double *response)
{
  constexpr RowLayout::Strain from = D::rows.strain;
  constexpr RowLayout::Response to = D::rows.response;
  // returns 1 for an automaton that lacks room
  auto mean = [=](int i, double bulkModulus, double weight) {
    response[to.length * i + to.mean] =
        meanStress(strains[from.length * i + from.sum], bulkModulus, weight);
    if constexpr (D::keepsVolume) {
      const double room = roomPressure(strains[from.length * i + from.room], bulkModulus, weight,
                                       D::rows.dimension);
      response[to.length * i + to.room] = room;
      return room == 0.0 ? 0.0 : 1.0;
    }
    return 0.0;
  };
  double crowded = 0.0;
  if (oneLaw && n > 0) {
    const double bulkModulus = laws[type[0]].bulkModulus, weight = laws[type[0]].weight;
#pragma omp simd reduction(+ : crowded)
    for (int i = 0; i < n; i++)
      crowded += mean(i, bulkModulus, weight);
  } else {
    for (int i = 0; i < n; i++)
      crowded += mean(i, laws[type[i]].bulkModulus, laws[type[i]].weight);
  }
  return crowded;
}

} // namespace
} // namespace mca::MCA_ISA

#endif
