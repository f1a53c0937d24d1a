// SPDX-License-Identifier: GPL-2.0-or-later
// The passes, for the plane and for space. Compiled once for each instruction set; MCA_ISA names
// the set and its namespace. Everything a pass calls is inlined into it (see CMakeLists.txt), so no
// function compiled for a newer processor can be picked up by an older one.
//
// The physics stands in laws/. Here a block's pairs are gathered to columns, a loop applies the
// laws to each, and the results are added to both automata. Each loop exists once for each way that
// a block may go, with all that the way knows left out by the compiler.
#include "kernel.h"

#include "kernel_few.h"
#include "kernel_plane.h"
#include "kernel_space.h"

#include <cmath>

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

// Whether the strains of these n pairs are small enough for the short logarithm.
inline bool allNear1(int n, const double *ratio)
{
  double far = 0.0;
#pragma omp simd reduction(+ : far)
  for (int k = 0; k < n; k++)
    far += isNear1(ratio[k]) ? 0.0 : 1.0;
  return far == 0.0;
}

// Returns how many links of a bulk block break by strain.
// Criterion: of bulk links, if it decides by strain only; else void.
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
  // Criterion is void where links do not break by what is known here
  constexpr bool decidesHere = onlyBulk(W) && !std::is_void_v<Criterion>;
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
  // near: std::true_type for the short logarithm
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
      taken[k] = roomTaken(roomShare(ratio));
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
      for (int k = 0; k < n; k++)
        breaking += strain(k, logarithm(pratio[k]), W == Pristine ? gammas.get(k) : totals.get(k));
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
    // all that do not decide by strain have the same loops
    using Known = std::conditional_t<C::strainOnly, C, void>;
    eachBlock(p, [&](Block &block, auto way, int first, int n) {
      const double breaking =
          strainBlock<D, way.way, Known>(p, block, first, n, time, laws, motion, spin, strains);
      block.breaks = breaking > 0.0;
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

template<class D, Way W>
MCA_LOOP void stressBlock(const Pairs &p, int first, int n, const PairLaw *laws,
                          const double *response, double *stresses)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first;
  double *const psigma = p.sigma + first;
  const PairArray<typename D::Shear> gammas(p.now.gamma, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  typename D::Answers ofI, ofJ;
  typename D::Shares shares;
  ofI.gatherMeans(pi, n, response);
  ofJ.gatherMeans(pj, n, response);
  const PairLaw one = laws[plaw[0]];
  auto share = [=, &one, &ofI, &ofJ, &shares](int k) {
    const PairLaw &law = W == SeveralLaws ? laws[plaw[k]] : one;
    const double e = W == Pristine ? peps[k] : peps[k] - pplastic[k];
    const typename D::Shear gamma = gammas.get(k);
    const double linked = onlyBulk(W) ? 1.0 : link::linked(pkind[k]);
    const double pressed = onlyBulk(W) || isPressed(e) ? 1.0 : 0.0;
    const double touching = linked > pressed ? linked : pressed;
    const double sigma = touching * elasticStress(law, e, ofI.mean[k], ofJ.mean[k]);
    psigma[k] = sigma;
    shares.set(k, sigma, law.twoG * gamma, normals.get(k));
    shares.setFlowing(k, onlyBulk(W) ? sigma : flowing(law.contactsFlow, pkind[k], e) * sigma);
  };
#pragma omp simd
  for (int k = 0; k < n; k++)
    share(k);
  shares.scatter(pi, pj, n, stresses);
}

template<class D>
void stressPass(const Pairs &p, const PairLaw *laws, const double *response, double *stresses)
{
  eachBlock(p, [&](Block &, auto way, int first, int n) {
    stressBlock<D, way.way>(p, first, n, laws, response, stresses);
  });
}

// What an automaton answers where it does not flow, and whether its intensity is above the yield
// stress: 0 where no one's is.
template<class D, bool ONE>
MCA_LOOP double restLoop(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                         const double *stresses, const double *kappa, double *kappaNext,
                         double *response)
{
  constexpr RowLayout rows = D::rows;
  const AutomatonLaw one = laws[type[0]];
  double above = 0.0;
#pragma omp simd reduction(+ : above)
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = ONE ? one : laws[type[i]];
    const double *const row = stresses + rows.stress.length * i;
    double *const answer = response + rows.response.length * i;
    const StressTensor s = D::averaged(law, row + rows.stress.tensor, answer[rows.response.mean]);
    const double contacts = strains[rows.strain.length * i + rows.strain.flowing];
    kappaNext[i] = kappa[i];
    answer[rows.response.factor] = 1.0;
    D::setCentre(answer, row, contacts);
    above += stressIntensity(s) > law.curve(kappa[i]) ? 1.0 : 0.0;
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
double yieldPass(int n, const int *type, const AutomatonLaw *laws, bool oneLaw,
                 const double *strains, const double *stresses, const double *kappa,
                 double *kappaNext, double *response)
{
  if (n == 0)
    return 0.0;
  // mostly no automaton of a span yields, and then the divisions of the return are not needed
  const double above =
      oneLaw ? restLoop<D, true>(n, type, laws, strains, stresses, kappa, kappaNext, response)
             : restLoop<D, false>(n, type, laws, strains, stresses, kappa, kappaNext, response);
  if (above == 0.0)
    return 0.0;
  return oneLaw ? yieldLoop<D, true>(n, type, laws, strains, stresses, kappa, kappaNext, response)
                : yieldLoop<D, false>(n, type, laws, strains, stresses, kappa, kappaNext, response);
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
  typename D::Shares shares{};
  Column missing;
  Picked<D> few;
  eachBlock(p, [&](const Block &block, auto way, int first, int n) {
    if (!block.flows)
      return;
    // of a pair that does not flow nothing is taken
    gatherFlow<D>(p.i + first, p.j + first, n, response, missing);
    few.choose(maskOf(n, [&](int k) { return missing[k] != 0.0; }));
    const bool pristine = way.way == Pristine;
    if (few.count() == 0)
      return;
    if (few.count() > Picked<D>::most) {
      returnBlock<D, way.way>(p, first, n, laws, response, ofI, ofJ, shares);
      shares.scatter(p.i + first, p.j + first, n, taken);
      return;
    }
    few.copy(p, first, pristine);
    returnBlock<D, way.way>(few.pairs(), 0, few.padded(), laws, response, ofI, ofJ, shares);
    shares.scatter(few.pairs().i, few.pairs().j, few.count(), taken);
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
    const double *const less = taken + rows.stress.length * i + rows.stress.tensor;
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
      const int sum = rows.stress.length * i + rows.stress.flowing;
      const double squares = taken[sum] - answer[rows.response.centre] * stresses[sum];
      strain = strainOfWork(1.0 - back.factor, squares, intensity, law.shearModulus, law.weight);
    } else {
      const double contacts = strains[rows.strain.length * i + rows.strain.flowing];
      strain = (contacts < 1.0 ? contacts : 1.0) * back.strain;
    }
    kappaNext[i] = kappa[i] + strain;
    answer[rows.response.factor] = back.factor;
  }
}

// One block, pair by pair without a branch: stresses after the return, the next kind, the force and
// the next state. All next states are written; whether they count is what the sums of differences
// say.
// LOCAL: criteria of local stress or of plastic work act.
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
  const double *const psep = p.separation + first;
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
    forces.set(k, contactForce(law, s.normal, shear.acting, pratio[k], normals.get(k)));
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

// Bulk links of one law. The next state is written where something flows, else it is the present
// one.
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
      forces.set(k, contactForce(law, sigma + room, returnedShear(left, law.twoG, gamma), ratio,
                                 normals.get(k)));
    } else {
      forces.set(k, contactForce(law, trial + room, law.twoG * gamma, ratio, normals.get(k)));
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

// Bulk links that break by strain only, of which none breaks or flows and whose automata have room:
// all that they answer is in the stress of the stress pass. Pairs that are apart have none.
template<class D, Way W>
MCA_LOOP void elasticForceBlock(const Pairs &p, int first, int n, const PairLaw *laws,
                                typename D::Forces &forces)
{
  const double *const pratio = p.ratio + first, *const psigma = p.sigma + first;
  const PairArray<typename D::Shear> gammas(p.now.gamma, first);
  const PairArray<typename D::Normal> normals(p.normal, first);
  const int *const plaw = p.law + first;
  const PairLaw one = laws[plaw[0]];
  auto answer = [=, &one, &forces](int k) {
    const PairLaw &law = W == SeveralLaws ? laws[plaw[k]] : one;
    forces.set(k,
               contactForce(law, psigma[k], law.twoG * gammas.get(k), pratio[k], normals.get(k)));
  };
#pragma omp simd
  for (int k = 0; k < n; k++)
    answer(k);
}

template<class D>
class ForcePassOf {
 public:
  ForcePassOf(const PairLaw *laws, const double *response, const double *local, double *forces)
      : laws_(laws), response_(response), local_(local), forces_(forces)
  {
  }

  // Returns how many pairs of the block change their kind.
  template<class Criterion, Way W>
  double work(const Pairs &p, Block &block, int first, int n)
  {
    const int *const pi = p.i + first, *const pj = p.j + first;
    const bool bulk = onlyBulk(W) && !block.breaks;
    double changed = 0.0;
    bool done = false;
    if constexpr (Criterion::strainOnly)
      done = !block.crowded && (!local_ || (bulk && !block.flows)) &&
             workFew<Criterion, W>(p, block, first, n, changed);
    if (!done) {
      block.busy = maskOf(n, [](int) { return true; });
      ofI_.gather(pi, n, response_);
      ofJ_.gather(pj, n, response_);
      if (Criterion::needsLocalStress || (local_ && !bulk))
        gatherMeans<D::rows.local.length>(pi, pj, n, local_, means_);
      if (!bulk || !workBulk<Criterion, W>(p, block, first, n))
        changed = workAny<Criterion, W>(p, block, first, n);
    }
    own_.scatter(pi, pj, n, forces_);
    return changed;
  }

 private:
  const PairLaw *laws_;
  const double *response_, *local_;
  double *forces_;
  typename D::Answers ofI_, ofJ_;
  typename D::Forces own_;
  typename D::Forces theirs_; // of the few
  Column missing_;
  Picked<D> few_;
  alignas(64) double means_[blockLength * D::rows.local.length];

  // Elastic forces for all, then those of the few pairs that do more. Returns false if these are
  // many; then nothing is done.
  template<class Criterion, Way W>
  bool workFew(const Pairs &p, Block &block, int first, int n, double &changed)
  {
    constexpr bool pristine = W == Pristine;
    block.busy = onlyBulk(W) && !block.breaks && !block.flows
                     ? BlockMask{}
                     : busyPairs<Criterion, W>(p, block, first, n);
    few_.choose(block.busy);
    if (few_.count() > Picked<D>::most)
      return false;
    block.moves = block.changes = false;
    elasticForceBlock<D, W>(p, first, n, laws_, own_);
    if (few_.count() == 0)
      return true;
    few_.copy(p, first, pristine);
    const Pairs picked = few_.pairs();
    ofI_.gather(picked.i, few_.padded(), response_);
    ofJ_.gather(picked.j, few_.padded(), response_);
    const double states = answerFew<Criterion, W>(block, picked);
    for (int k = 0; k < few_.count(); k++)
      own_.take(few_.number(k), theirs_, k);
    if (states > 0.0) {
      few_.putNext(p, first, n, pristine);
      changed = few_.changes();
      block.moves = true;
      block.changes = changed > 0.0;
    }
    return true;
  }

  // What the few answer, by the loops that a whole block of this way takes. Returns whether a state
  // changes: > 0.
  template<class Criterion, Way W>
  double answerFew(const Block &block, const Pairs &few)
  {
    if constexpr (onlyBulk(W))
      if (!block.breaks) { // so they flow
        bulkForceBlock<D, W == Pristine, true, void>(few, 0, few.n, laws_, nullptr, ofI_, ofJ_,
                                                     theirs_);
        return 1.0;
      }
    return forceBlock<D, anyWay(W), Criterion, false>(few, 0, few.n, laws_, nullptr, ofI_, ofJ_,
                                                      theirs_)
        .states;
  }

  // Pairs that are neither bulk links with their elastic stress alone, nor apart for good or with a
  // dent that they keep.
  template<class Criterion, Way W>
  BlockMask busyPairs(const Pairs &p, const Block &block, int first, int n)
  {
    using Shear = typename D::Shear;
    if (block.flows)
      gatherFlow<D>(p.i + first, p.j + first, n, response_, missing_);
    else
      missing_ = Column{};
    const int *const plaw = p.law + first;
    const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
    const double *const peps = p.eps + first;
    const PairArray<Shear> totals(W == Pristine ? p.now.gamma : p.now.gammaTotal, first);
    const LinkLimits one = laws_[plaw[0]].limits;
    return maskOf(n, [=, &one](int k) {
      const LinkLimits &limits = W == SeveralLaws ? laws_[plaw[k]].limits : one;
      const double kind = pkind[k], eps = peps[k], plastic = pplastic[k];
      const Shear total = totals.get(k);
      const bool bulk = onlyBulk(W) || kind == link::bulk;
      const bool breaking = breaks<Criterion>(LinkStrain<Shear>{eps, total}, limits.fracture);
      const bool keepsDent = (plastic == 0.0) | (eps <= (plastic > 0.0 ? plastic : 0.0));
      const bool apart = (kind == link::none) & !isPressed(eps - plastic) & keepsDent &
                         equal(total, Shear{}) & (limits.linkPressure > 0.0);
      return !((bulk & !breaking & (missing_[k] == 0.0)) | apart);
    });
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
                                                p, first, n, laws_, means_, ofI_, ofJ_, own_)
                                          : bulkForceBlock<D, pristine, false, Open>(
                                                p, first, n, laws_, means_, ofI_, ofJ_, own_);
      if (breaking == 0.0)
        return true;
      if (pristine)
        leavePristine(p, block, first, n, D::shears);
      if (local_ && !Criterion::needsLocalStress)
        gatherMeans<D::rows.local.length>(p.i + first, p.j + first, n, local_, means_);
    }
    return false;
  }

  template<class Criterion, Way W>
  double workAny(const Pairs &p, Block &block, int first, int n)
  {
    constexpr Way mixed = anyWay(W);
    Changes changes{};
    if (Criterion::needsLocalStress || local_)
      changes = forceBlock<D, mixed, Criterion, true>(p, first, n, laws_, means_, ofI_, ofJ_, own_);
    else if constexpr (!Criterion::needsLocalStress)
      changes =
          forceBlock<D, mixed, Criterion, false>(p, first, n, laws_, nullptr, ofI_, ofJ_, own_);
    block.moves = changes.states > 0.0;
    block.changes = changes.kinds > 0.0;
    return changes.kinds;
  }
};

template<class D>
double forcePass(const Pairs &p, const PairLaw *laws, const double *response, const double *local,
                 double *forces) // NOLINT(readability-non-const-parameter): a template writes them
{
  ForcePassOf<D> pass(laws, response, local, forces);
  double changed = 0.0;
  withCriterion(p, laws, [&](auto criterion) {
    eachBlock(p, [&](Block &block, auto way, int first, int n) {
      changed += pass.template work<decltype(criterion), way.way>(p, block, first, n);
    });
  });
  return changed;
}

template<class D>
constexpr Kernel kernelOf(const Kernel *keepsVolume)
{
  Kernel k{};
  k.name = MCA_ISA_NAME;
  k.dimension = D::rows.dimension;
  k.rows = D::rows;
  k.strain = strainPass<D>;
  k.mean = meanPass<D>;
  k.stress = stressPass<D>;
  k.yield = yieldPass<D>;
  k.returns = returnPass<D>;
  k.yieldAgain = secondYieldPass<D>;
  k.force = forcePass<D>;
  k.keepsVolume = keepsVolume;
  return k;
}

constexpr Kernel planeIsochoric = kernelOf<PlaneIsochoric>(nullptr),
                 spaceIsochoric = kernelOf<SpaceIsochoric>(nullptr);

} // namespace

extern const Kernel plane = kernelOf<Plane>(&planeIsochoric);
extern const Kernel space = kernelOf<Space>(&spaceIsochoric);

} // namespace mca::MCA_ISA
