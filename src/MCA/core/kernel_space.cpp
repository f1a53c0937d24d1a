// The kernel in space, on the pattern of kernel_plane.cpp. Shears are vectors; all else that
// decides on a contact depends on their lengths only.
#include "kernel_rows.h"
#include "laws/pair_motion.h"

#include <cmath>

namespace mca {
namespace MCA_ISA {
namespace {

constexpr RowLayout rows = spaceRows;

// Vectors of a block's pairs in three arrays.
struct Vectors {
  double *x, *y, *z;

  Vectors(double *const *arrays, int first)
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

// Rows of eight values as two of four.
inline const Row4 &half(const double *array, int i, int which)
{
  return *rowOf<Row4>(array, 2 * i + which);
}

// Motion of j seen from i and the sum of both angular velocities of each pair, as columns. Pairs
// past n are made up of the last one.
struct Motion {
  Column x, y, z, vx, vy, vz, wx, wy, wz;

  Vector distance(int k) const { return {x.value[k], y.value[k], z.value[k]}; }
  Vector velocity(int k) const { return {vx.value[k], vy.value[k], vz.value[k]}; }
  Vector omegas(int k) const { return {wx.value[k], wy.value[k], wz.value[k]}; }

  void gather(const int *pi, const int *pj, int n, const double *motion, const double *spin)
  {
    const Row4 signs = {-1.0, -1.0, 1.0, 1.0};
    for (int k = 0; k < n; k += 4) {
      Row4 a[4], b[4];
      for (int m = 0; m < 4; m++) {
        const int i = pi[k + m], j = pj[k + m];
        a[m] = half(motion, j, 0) - half(motion, i, 0);
        b[m] = half(motion, j, 1) + signs * half(motion, i, 1);
        wz[k + m] = spin[i] + spin[j];
      }
      store(a, k, x, y, z, vx);
      store(b, k, vy, vz, wx, wy);
    }
  }

 private:
  static void store(Row4 *r, int k, Column &c0, Column &c1, Column &c2, Column &c3)
  {
    transpose(r[0], r[1], r[2], r[3]);
    *rowOf<Row4>(c0.value + k, 0) = r[0];
    *rowOf<Row4>(c1.value + k, 0) = r[1];
    *rowOf<Row4>(c2.value + k, 0) = r[2];
    *rowOf<Row4>(c3.value + k, 0) = r[3];
  }
};

// Responses of one automaton of each pair. Pairs past n are made up of the last one.
struct Responses {
  Column mean, factor, centre;

  void gather(const int *index, int n, const double *response)
  {
    for (int k = 0; k < n; k += 4) {
      Row4 r[4];
      for (int m = 0; m < 4; m++)
        r[m] = *rowOf<Row4>(response, index[k + m]);
      transpose(r[0], r[1], r[2], r[3]);
      *rowOf<Row4>(mean.value + k, 0) = r[0];
      *rowOf<Row4>(factor.value + k, 0) = r[1];
      *rowOf<Row4>(centre.value + k, 0) = r[2];
    }
  }
};

// Eight values of each pair, which go as a row to both of its automata: the first `turned` of them
// with the opposite sign to the second one.
struct Shares {
  Column c[8];

  template<int TURNED>
  void scatter(const int *pi, const int *pj, int n, double *sums) const
  {
    Row4 signs[2];
    for (int m = 0; m < 8; m++)
      signs[m / 4][m % 4] = m < TURNED ? -1.0 : 1.0;
    // pairs come sorted by i, so that its sum stays in registers
    int last = pi[0];
    Row4 sumA = {}, sumB = {};
    auto flush = [&]() {
      *rowOf<Row4>(sums, 2 * last) += sumA;
      *rowOf<Row4>(sums, 2 * last + 1) += sumB;
    };
    for (int k = 0; k < n; k += 4) {
      Row4 a[4], b[4];
      for (int m = 0; m < 4; m++) {
        a[m] = *rowOf<Row4>(c[m].value + k, 0);
        b[m] = *rowOf<Row4>(c[4 + m].value + k, 0);
      }
      transpose(a[0], a[1], a[2], a[3]);
      transpose(b[0], b[1], b[2], b[3]);
      const int end = lesser(4, n - k);
      for (int m = 0; m < end; m++) {
        if (pi[k + m] != last) {
          flush();
          last = pi[k + m];
          sumA = sumB = Row4{};
        }
        sumA += a[m];
        sumB += b[m];
        const int j = 2 * pj[k + m];
        *rowOf<Row4>(sums, j) += signs[0] * a[m];
        *rowOf<Row4>(sums, j + 1) += signs[1] * b[m];
      }
    }
    flush();
  }
};

// Returns how many links of a bulk block reach the breaking strain.
template<Way WAY>
double strainBlock(const Pairs &p, const Block &block, int first, int n, double dt,
                   const PairLaw *laws, const double *motion, const double *spin, double *strains)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const Vectors gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const Vectors normals(p.normal, first);
  double *const peps = p.eps + first, *const psep = p.separation + first;
  Motion seen;
  Column es, bulks;
  seen.gather(placesI(p, block, first), placesJ(p, block, first), n, motion, spin);
  const double oneInvDiameter = laws[plaw[0]].invDiameter;
  const double breakingStrain2 = laws[plaw[0]].limits.bulkStrain2;
  const double halfStep = 0.5 * dt;
  // returns 1 for a link that reaches the breaking strain
  auto move = [=, &seen, &es, &bulks](int k) {
    const double invDiameter = WAY == SEVERAL_LAWS ? laws[plaw[k]].invDiameter : oneInvDiameter;
    const Vector distance = seen.distance(k), velocity = seen.velocity(k);
    const Vector omegas = seen.omegas(k);
    // the root and the division side by side
    const double r2 = dot(distance, distance), r = std::sqrt(r2), invR = r * (1.0 / r2);
    const PairMotion moved = pairMotion(distance, invR, dt * velocity, halfStep * omegas);
    const Vector growth = shearGrowth(moved);
    const Vector gamma = carriedShear(moved, gammas.get(k)) + growth;
    const Vector total = WAY == PRISTINE ? gamma : carriedShear(moved, totals.get(k)) + growth;
    const double eps = r * invDiameter - 1.0;
    const double e = WAY == PRISTINE ? eps : eps - pplastic[k];
    normals.set(k, moved.normal);
    peps[k] = eps;
    if (onlyBulk(WAY)) {
      gammas.set(k, gamma);
      if (WAY == BULK)
        totals.set(k, total);
      es.value[k] = e;
      bulks.value[k] = 1.0;
      return breaksByStrain(eps, total, breakingStrain2) ? 1.0 : 0.0;
    } else {
      const double linked = link::linked(pkind[k]), pressed = e < 0.0 ? 1.0 : 0.0;
      gammas.set(k, linked * gamma);
      totals.set(k, linked * total);
      psep[k] = dot(velocity, moved.normal);
      es.value[k] = (linked > pressed ? linked : pressed) * e;
      bulks.value[k] = pkind[k] == link::bulk ? 1.0 : 0.0;
      return 0.0;
    }
  };
  double breaking = 0.0;
#pragma omp simd reduction(+ : breaking)
  for (int k = 0; k < n; k++)
    breaking += move(k);
  if (onlyBulk(WAY) && breaking > 0.0) // what breaks under pressure becomes a viscous contact
    for (int k = 0; k < n; k++)
      psep[k] = dot({seen.vx[k], seen.vy[k], seen.vz[k]}, normals.get(k));
  scatter(p.i + first, p.j + first, n, es, bulks, strains);
  return breaking;
}

void strainPass(const Pairs &p, double step, bool moves, const PairLaw *laws, const double *motion,
                const double *spin, double *strains)
{
  const double dt = moves ? step : 0.0; // normals do not depend on it
  eachBlock(p, laws, [&](Block &block, auto way, int first, int n) {
    const double breaking =
        strainBlock<way.way>(p, block, first, n, dt, laws, motion, spin, strains);
    block.breaks = breaking > 0.0;
    if (way.way == PRISTINE && block.breaks)
      leavePristine(p, block, first, n, 3);
  });
}

void meanPass(int n, const int *type, const AutomatonLaw *laws, bool /*oneLaw*/,
              const double *strains, double *response)
{
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = laws[type[i]];
    response[rows.response.length * i + rows.response.mean] =
        meanStress(strains[rows.strain.length * i + rows.strain.sum], law.bulkModulus, law.weight);
  }
}

template<Way WAY>
void stressBlock(const Pairs &p, int first, int n, const PairLaw *laws, const double *response,
                 double *stresses)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first;
  const Vectors gammas(p.now.gamma, first), normals(p.normal, first);
  Column meanI, meanJ;
  Shares shares;
  for (int k = 0; k < n; k++) {
    meanI[k] = response[rows.response.length * pi[k]];
    meanJ[k] = response[rows.response.length * pj[k]];
  }
  const PairLaw one = laws[plaw[0]];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const PairLaw &law = WAY == SEVERAL_LAWS ? laws[plaw[k]] : one;
    const double e = WAY == PRISTINE ? peps[k] : peps[k] - pplastic[k];
    const Vector gamma = gammas.get(k);
    const double linked = onlyBulk(WAY) ? 1.0 : link::linked(pkind[k]);
    const double pressed = onlyBulk(WAY) || e < 0.0 ? 1.0 : 0.0;
    const double touching = linked > pressed ? linked : pressed;
    const double sigma = touching * elasticStress(law, e, meanI[k], meanJ[k]);
    const StressTensor s = stressShare(sigma, law.twoG * gamma, normals.get(k));
    shares.c[0][k] = s.xx;
    shares.c[1][k] = s.yy;
    shares.c[2][k] = s.xy;
    shares.c[3][k] = s.zz;
    shares.c[4][k] = s.xz;
    shares.c[5][k] = s.yz;
    shares.c[6][k] = touching * e * e + dot(gamma, gamma);
    shares.c[7][k] = onlyBulk(WAY) || pkind[k] == link::bulk ? sigma : 0.0;
  }
  shares.scatter<0>(pi, pj, n, stresses);
}

void stressPass(const Pairs &p, const PairLaw *laws, const double *response, double *stresses)
{
  eachBlock(p, laws, [&](Block &, auto way, int first, int n) {
    stressBlock<way.way>(p, first, n, laws, response, stresses);
  });
}

template<bool ONE>
double yieldLoop(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                 const double *stresses, const double *kappa, double *kappaNext, double *response)
{
  const AutomatonLaw one = laws[type[0]];
  double flowing = 0.0;
#pragma omp simd reduction(+ : flowing)
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = ONE ? one : laws[type[i]];
    const double *const row = stresses + rows.stress.length * i;
    const StressTensor s = weighted(row, law.weight);
    const RadialReturn back =
        radialReturn(stressIntensity(s), law.curve(kappa[i]), law.shearModulus);
    // without a bulk link there is nothing that could flow
    const double bulks = strains[rows.strain.length * i + rows.strain.bulks];
    const double flows = law.yields * bulks > 0.0 ? 1.0 : 0.0;
    kappaNext[i] = kappa[i] + flows * back.strain;
    response[rows.response.length * i + rows.response.factor] = flows * back.factor + (1.0 - flows);
    response[rows.response.length * i + rows.response.centre] =
        row[rows.stress.bulkSum] / (bulks > 0.0 ? bulks : 1.0);
    flowing += kappaNext[i] == kappa[i] ? 0.0 : 1.0;
  }
  return flowing;
}

double yieldPass(int n, const int *type, const AutomatonLaw *laws, bool oneLaw,
                 const double *strains, const double *stresses, const double *kappa,
                 double *kappaNext, double *response)
{
  if (n == 0)
    return 0.0;
  return oneLaw ? yieldLoop<true>(n, type, laws, strains, stresses, kappa, kappaNext, response)
                : yieldLoop<false>(n, type, laws, strains, stresses, kappa, kappaNext, response);
}

// Responses of both automata of each pair, and force and torque on the first one.
struct PairColumns {
  Responses ofI, ofJ;
  Shares shares; // the last two unused

  PairColumns()
  {
    for (int k = 0; k < blockLength; k++)
      shares.c[6][k] = shares.c[7][k] = 0.0;
  }

  // The shear force acts at the distance r; its moment (d/2) n x tau S keeps U's gradient exact.
  void setForce(int k, const PairLaw &law, double normal, const Vector &shear, double eps,
                const Vector &n)
  {
    const Vector force = law.area * (normal * n + 1.0 / (1.0 + eps) * shear);
    const Vector torque = 0.5 * law.area * law.diameter * cross(n, shear);
    shares.c[0][k] = force.x;
    shares.c[1][k] = force.y;
    shares.c[2][k] = force.z;
    shares.c[3][k] = torque.x;
    shares.c[4][k] = torque.y;
    shares.c[5][k] = torque.z;
  }
};

template<Way WAY>
void returnBlock(const Pairs &p, int first, int n, const PairLaw *laws, const Responses &ofI,
                 const Responses &ofJ, Shares &shares)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first;
  const Vectors gammas(p.now.gamma, first), normals(p.normal, first);
  const PairLaw one = laws[plaw[0]];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const PairLaw &law = WAY == SEVERAL_LAWS ? laws[plaw[k]] : one;
    const double e = WAY == PRISTINE ? peps[k] : peps[k] - pplastic[k];
    const double bulk = onlyBulk(WAY) || pkind[k] == link::bulk ? 1.0 : 0.0;
    const double factorI = ofI.factor[k], factorJ = ofJ.factor[k];
    const double trial = elasticStress(law, e, ofI.mean[k], ofJ.mean[k]);
    const double sigma = returnedStress(trial, ofI.centre[k], factorI, ofJ.centre[k], factorJ);
    const double tau = bulk * (0.5 * (factorI + factorJ) - 1.0) * law.twoG;
    const StressTensor s = stressShare(bulk * (sigma - trial), tau * gammas.get(k), normals.get(k));
    shares.c[0][k] = s.xx;
    shares.c[1][k] = s.yy;
    shares.c[2][k] = s.xy;
    shares.c[3][k] = s.zz;
    shares.c[4][k] = s.xz;
    shares.c[5][k] = s.yz;
  }
}

void returnPass(const Pairs &p, const PairLaw *laws, const double *response, double *taken)
{
  PairColumns c;
  eachBlock(p, laws, [&](Block &, auto way, int first, int n) {
    const int *const pi = p.i + first, *const pj = p.j + first;
    c.ofI.gather(pi, n, response);
    c.ofJ.gather(pj, n, response);
    if (allOne(n, c.ofI.factor, c.ofJ.factor))
      return;
    returnBlock<way.way>(p, first, n, laws, c.ofI, c.ofJ, c.shares);
    c.shares.scatter<0>(pi, pj, n, taken);
  });
}

void secondYieldPass(int n, const int *type, const AutomatonLaw *laws, const double *stresses,
                     const double *taken, const double *kappa, double *kappaNext, double *response)
{
  for (int i = 0; i < n; i++) {
    const double factor = response[rows.response.length * i + rows.response.factor];
    if (factor == 1.0)
      continue;
    const AutomatonLaw &law = laws[type[i]];
    const double *const row = stresses + rows.stress.length * i;
    const double *const less = taken + rows.stress.length * i;
    double after[6];
    for (int m = 0; m < 6; m++)
      after[m] = row[m] + less[m];
    const RadialReturn back = secondReturn(factor, stressIntensity(weighted(row, law.weight)),
                                           stressIntensity(weighted(after, law.weight)),
                                           law.curve(kappa[i]), law.shearModulus);
    kappaNext[i] = kappa[i] + back.strain;
    response[rows.response.length * i + rows.response.factor] = back.factor;
  }
}

template<Way WAY>
Changes forceBlock(const Pairs &p, int first, int n, const PairLaw *laws, PairColumns &c)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const peps = p.eps + first, *const psep = p.separation + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  const Vectors gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const Vectors gammas1(p.next.gamma, first), totals1(p.next.gammaTotal, first);
  const Vectors normals(p.normal, first);
  const PairLaw one = laws[plaw[0]];
  double kinds = 0.0, states = 0.0;
#pragma omp simd reduction(+ : kinds, states)
  for (int k = 0; k < n; k++) {
    const PairLaw &law = WAY == SEVERAL_LAWS ? laws[plaw[k]] : one;
    const double kind = pkind[k], plastic = pplastic[k], eps = peps[k];
    const Vector gamma = gammas.get(k), total = totals.get(k);
    const double shear = length(gamma), elasticShear = law.twoG * shear;
    const ContactStress s = contactStress(
        law, kind, eps, plastic, shear, length(total), psep[k], c.ofI.mean[k], c.ofI.factor[k],
        c.ofJ.mean[k], c.ofJ.factor[k], ReturnCentre{c.ofI.centre[k], c.ofJ.centre[k]});
    // what is left of the elastic shear stress, exactly 1 where nothing flows
    const double divisor = shear > 0.0 ? elasticShear : 1.0;
    const double kept = s.tau / divisor, acting = s.shear / divisor;

    // next state; conditions as factors of 0 or 1, which vectorise
    const double linkedNext = link::linked(s.kindNext), stays = link::linked(kind) * linkedNext;
    const double flow = kind == link::bulk ? (s.trial - s.sigma) * law.invTwoG : 0.0;
    const double dented = plastic + flow;
    // once apart, both surfaces are whole again
    const double apart = eps > (dented > 0.0 ? dented : 0.0) ? 1.0 - linkedNext : 0.0;
    const double plasticNext = (1.0 - apart) * dented;
    const double keeps = stays * kept;
    kind1[k] = s.kindNext;
    plastic1[k] = plasticNext;
    gammas1.set(k, keeps * gamma);
    totals1.set(k, stays * total);
    kinds += kind == s.kindNext ? 0.0 : 1.0;
    states += kind == s.kindNext ? 0.0 : 1.0;
    states += plastic == plasticNext ? 0.0 : 1.0;
    states += keeps * shear == shear ? 0.0 : 1.0;
    c.setForce(k, law, s.normal, acting * law.twoG * gamma, eps, normals.get(k));
  }
  return {kinds, states};
}

// Bulk links of one law of which none breaks.
template<bool PRISTINE, bool FLOWS>
void bulkForceBlock(const Pairs &p, int first, int n, const PairLaw *laws, PairColumns &c)
{
  const double *const pplastic = p.now.plastic + first, *const peps = p.eps + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  const Vectors gammas(p.now.gamma, first), totals(p.now.gammaTotal, first);
  const Vectors gammas1(p.next.gamma, first), totals1(p.next.gammaTotal, first);
  const Vectors normals(p.normal, first);
  const PairLaw law = laws[p.law[first]];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const double plastic = PRISTINE ? 0.0 : pplastic[k], eps = peps[k];
    const double trial = elasticStress(law, eps - plastic, c.ofI.mean[k], c.ofJ.mean[k]);
    const Vector gamma = gammas.get(k), normal = normals.get(k);
    if (FLOWS) {
      const double factorI = c.ofI.factor[k], factorJ = c.ofJ.factor[k];
      const double sigma =
          returnedStress(trial, c.ofI.centre[k], factorI, c.ofJ.centre[k], factorJ);
      const double factor = 0.5 * (factorI + factorJ);
      kind1[k] = link::bulk;
      plastic1[k] = plastic + (trial - sigma) * law.invTwoG;
      gammas1.set(k, factor * gamma);
      totals1.set(k, PRISTINE ? gamma : totals.get(k));
      c.setForce(k, law, sigma, factor * law.twoG * gamma, eps, normal);
    } else {
      c.setForce(k, law, trial, law.twoG * gamma, eps, normal);
    }
  }
}

double forcePass(const Pairs &p, const PairLaw *laws, const double *response,
                 const double * /*local: of laws in the plane*/, double *forces)
{
  PairColumns c;
  double changed = 0.0;
  eachBlock(p, laws, [&](Block &block, auto way, int first, int n) {
    constexpr bool pristine = way.way == PRISTINE;
    const int *const pi = p.i + first, *const pj = p.j + first;
    c.ofI.gather(pi, n, response);
    c.ofJ.gather(pj, n, response);
    if (onlyBulk(way.way) && !block.breaks) {
      block.moves = !allOne(n, c.ofI.factor, c.ofJ.factor);
      if (block.moves)
        bulkForceBlock<pristine, true>(p, first, n, laws, c);
      else
        bulkForceBlock<pristine, false>(p, first, n, laws, c);
    } else {
      constexpr Way mixed = way.way == SEVERAL_LAWS ? SEVERAL_LAWS : ONE_LAW;
      const Changes changes = forceBlock<mixed>(p, first, n, laws, c);
      block.moves = changes.states > 0.0;
      changed += changes.kinds;
    }
    c.shares.scatter<3>(pi, pj, n, forces);
  });
  return changed;
}

} // namespace

extern const Kernel space = {MCA_ISA_NAME, 3,         rows,       strainPass,      meanPass,
                             stressPass,   yieldPass, returnPass, secondYieldPass, forcePass};

} // namespace MCA_ISA
} // namespace mca
