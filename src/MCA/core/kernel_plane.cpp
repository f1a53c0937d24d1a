// Compiled once for each instruction set; MCA_ISA names the set and its namespace. Everything a
// pass calls is inlined into it (see CMakeLists.txt), so no function compiled for a newer
// processor can be picked up by an older one.
#include "kernel_rows.h"

#include <cmath>

namespace mca {
namespace MCA_ISA {
namespace {

constexpr RowLayout rows = planeRows;

// Returns how many links of a bulk block reach the breaking strain.
template<Way WAY>
double strainBlock(const Pairs &p, const Block &block, int first, int n, double dt, double moves,
                   const PairLaw *laws, const double *motion, const double *spin, double *strains)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  double *const pgamma = p.now.gamma[0] + first, *const ptotal = p.now.gammaTotal[0] + first;
  double *const pnx = p.normal[0] + first, *const pny = p.normal[1] + first;
  double *const peps = p.eps + first, *const psep = p.separation + first;
  Column dxs, dys, dvxs, dvys, spins, es, bulks;
  gatherMotion(placesI(p, block, first), placesJ(p, block, first), n, motion, spin, dxs, dys, dvxs,
               dvys, spins);
  const double oneInvDiameter = laws[plaw[0]].invDiameter;
  const double breakingStrain2 = laws[plaw[0]].limits.bulkStrain2;
  double breaking = 0.0;
#pragma omp simd reduction(+ : breaking)
  for (int k = 0; k < n; k++) {
    const double invDiameter = WAY == SEVERAL_LAWS ? laws[plaw[k]].invDiameter : oneInvDiameter;
    const double dx = dxs[k], dy = dys[k], dvx = dvxs[k], dvy = dvys[k];
    const double r2 = dx * dx + dy * dy, r = std::sqrt(r2);
    const double stepN = (dvx * dx + dvy * dy) * dt, stepT = (dvy * dx - dvx * dy) * dt; // times r
    const double inverse = 1.0 / (r2 * (r2 - stepN));
    const double invR = r * (r2 - stepN) * inverse;
    const double nx = dx * invR, ny = dy * invR;
    const double turn = axisRotation(stepT * r2 * inverse);
    const double dgamma = moves * shearIncrement(turn, spins[k] * dt);
    const double eps = r * invDiameter - 1.0;
    const double e = WAY == PRISTINE ? eps : eps - pplastic[k];
    pnx[k] = nx;
    pny[k] = ny;
    peps[k] = eps;
    if (onlyBulk(WAY)) {
      const double gamma = pgamma[k] + dgamma;
      const double total = WAY == PRISTINE ? gamma : ptotal[k] + dgamma;
      pgamma[k] = gamma;
      if (WAY == BULK)
        ptotal[k] = total;
      breaking += breaksByStrain(eps, total, breakingStrain2) ? 1.0 : 0.0;
      es[k] = e;
      bulks[k] = 1.0;
    } else {
      const double kind = pkind[k];
      const bool linked = link::isLinked(kind);
      pgamma[k] = linked ? pgamma[k] + dgamma : 0.0;
      ptotal[k] += linked ? dgamma : 0.0;
      psep[k] = dvx * nx + dvy * ny;
      es[k] = (linked | (e < 0.0)) ? e : 0.0;
      bulks[k] = kind == link::bulk ? 1.0 : 0.0;
    }
  }
  if (onlyBulk(WAY) && breaking > 0.0) // what breaks under pressure becomes a viscous contact
    for (int k = 0; k < n; k++)
      psep[k] = dvxs[k] * pnx[k] + dvys[k] * pny[k];
  scatter(p.i + first, p.j + first, n, es, bulks, strains);
  return breaking;
}

void strainPass(const Pairs &p, double dt, bool moves, const PairLaw *laws, const double *motion,
                const double *spin, double *strains)
{
  const double moving = moves ? 1.0 : 0.0;
  eachBlock(p, laws, [&](Block &block, auto way, int first, int n) {
    const double breaking =
        strainBlock<way.way>(p, block, first, n, dt, moving, laws, motion, spin, strains);
    block.breaks = breaking > 0.0;
    if (way.way == PRISTINE && block.breaks)
      leavePristine(p, block, first, n, 1);
  });
}

void meanPass(int n, const int *type, const AutomatonLaw *laws, bool oneLaw, const double *strains,
              double *response)
{
  if (oneLaw) {
    const double bulkModulus = n > 0 ? laws[type[0]].bulkModulus : 0.0;
#pragma omp simd
    for (int i = 0; i < n; i++)
      response[rows.response.length * i + rows.response.mean] =
          meanStress(strains[rows.strain.length * i + rows.strain.sum], bulkModulus);
  } else {
    for (int i = 0; i < n; i++)
      response[rows.response.length * i + rows.response.mean] =
          meanStress(strains[rows.strain.length * i + rows.strain.sum], laws[type[i]].bulkModulus);
  }
}

template<Way WAY>
void stressBlock(const Pairs &p, int first, int n, const PairLaw *laws, const double *response,
                 double *stresses)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pgamma = p.now.gamma[0] + first, *const peps = p.eps + first;
  const double *const pnx = p.normal[0] + first, *const pny = p.normal[1] + first;
  Column meanI, meanJ, unused, xx, yy, xy, squares;
  gather(pi, n, response, meanI, unused);
  gather(pj, n, response, meanJ, unused);
  const PairLaw one = laws[plaw[0]];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const PairLaw &law = WAY == SEVERAL_LAWS ? laws[plaw[k]] : one;
    const double e = WAY == PRISTINE ? peps[k] : peps[k] - pplastic[k], gamma = pgamma[k];
    const double touching =
        onlyBulk(WAY) ? 1.0 : (link::isLinked(pkind[k]) | (e < 0.0) ? 1.0 : 0.0);
    const double sigma = touching * elasticStress(law, e, meanI[k], meanJ[k]);
    const StressTensor s = stressShare(sigma, law.twoG * gamma, pnx[k], pny[k]);
    xx[k] = s.xx;
    yy[k] = s.yy;
    xy[k] = s.xy;
    squares[k] = touching * e * e + gamma * gamma;
  }
  scatter(pi, pj, n, xx, yy, xy, squares, Row4{1.0, 1.0, 1.0, 1.0}, stresses);
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
    const StressTensor s = automatonStress(row[0], row[1], row[2],
                                           response[rows.response.length * i + rows.response.mean]);
    const RadialReturn back =
        radialReturn(stressIntensity(s), law.curve(kappa[i]), law.shearModulus);
    // without a bulk link there is nothing that could flow
    const double flows =
        law.yields * strains[rows.strain.length * i + rows.strain.bulks] > 0.0 ? 1.0 : 0.0;
    kappaNext[i] = kappa[i] + flows * back.strain;
    response[rows.response.length * i + rows.response.factor] = flows * back.factor + (1.0 - flows);
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

// Responses of both automata of each pair and the forces between them.
struct PairColumns {
  Column meanI, factorI, meanJ, factorJ;
  Column fx, fy, torque;

  // The shear force acts along t at the distance r; its moment tau S d/2 keeps U's gradient exact.
  void setForce(int k, const PairLaw &law, double normal, double shear, double eps, double nx,
                double ny)
  {
    const double fn = normal * law.area, ft = shear * law.area / (1.0 + eps);
    fx[k] = fn * nx - ft * ny;
    fy[k] = fn * ny + ft * nx;
    torque[k] = 0.5 * shear * law.area * law.diameter;
  }
};

template<Way WAY>
void returnBlock(const Pairs &p, int first, int n, const PairLaw *laws, const PairColumns &c,
                 double *taken)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pgamma = p.now.gamma[0] + first, *const peps = p.eps + first;
  const double *const pnx = p.normal[0] + first, *const pny = p.normal[1] + first;
  Column xx, yy, xy;
  const PairLaw one = laws[plaw[0]];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const PairLaw &law = WAY == SEVERAL_LAWS ? laws[plaw[k]] : one;
    const double e = WAY == PRISTINE ? peps[k] : peps[k] - pplastic[k];
    const double bulk = onlyBulk(WAY) || pkind[k] == link::bulk ? 1.0 : 0.0;
    const double factorI = c.factorI[k], factorJ = c.factorJ[k];
    const double trial = elasticStress(law, e, c.meanI[k], c.meanJ[k]);
    const double sigma = returnedStress(trial, c.meanI[k], factorI, c.meanJ[k], factorJ);
    const double tau = (0.5 * (factorI + factorJ) - 1.0) * law.twoG * pgamma[k];
    const StressTensor s = stressShare(bulk * (sigma - trial), bulk * tau, pnx[k], pny[k]);
    xx[k] = s.xx;
    yy[k] = s.yy;
    xy[k] = s.xy;
  }
  scatter(p.i + first, p.j + first, n, xx, yy, xy, xy, Row4{1.0, 1.0, 1.0, 1.0}, taken);
}

void returnPass(const Pairs &p, const PairLaw *laws, const double *response, double *taken)
{
  PairColumns c;
  eachBlock(p, laws, [&](Block &, auto way, int first, int n) {
    gather(p.i + first, n, response, c.meanI, c.factorI);
    gather(p.j + first, n, response, c.meanJ, c.factorJ);
    if (!allOne(n, c.factorI, c.factorJ))
      returnBlock<way.way>(p, first, n, laws, c, taken);
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
    const double mean = response[rows.response.length * i + rows.response.mean];
    const double *const row = stresses + rows.stress.length * i, *const less =
                                                                     taken + rows.stress.length * i;
    const StressTensor s = automatonStress(row[0], row[1], row[2], mean);
    const StressTensor after =
        automatonStress(row[0] + less[0], row[1] + less[1], row[2] + less[2], mean);
    const RadialReturn back = secondReturn(factor, stressIntensity(s), stressIntensity(after),
                                           law.curve(kappa[i]), law.shearModulus);
    kappaNext[i] = kappa[i] + back.strain;
    response[rows.response.length * i + rows.response.factor] = back.factor;
  }
}

template<Way WAY, bool LOCAL>
Changes forceBlock(const Pairs &p, int first, int n, const PairLaw *laws, const double *local,
                   PairColumns &c)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pgamma = p.now.gamma[0] + first, *const ptotal = p.now.gammaTotal[0] + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  double *const gamma1 = p.next.gamma[0] + first, *const total1 = p.next.gammaTotal[0] + first;
  const double *const pnx = p.normal[0] + first, *const pny = p.normal[1] + first;
  const double *const peps = p.eps + first, *const psep = p.separation + first;
  const PairLaw one = laws[plaw[0]];
  double kinds = 0.0, states = 0.0;
#pragma omp simd reduction(+ : kinds, states)
  for (int k = 0; k < n; k++) {
    const PairLaw &law = WAY == SEVERAL_LAWS ? laws[plaw[k]] : one;
    const double kind = pkind[k], plastic = pplastic[k], eps = peps[k];
    const double gamma = pgamma[k], total = ptotal[k];
    LocalStress around = {};
    double work = 0.0;
    if (LOCAL) {
      const double *const row = local + rows.local.length * k;
      const double mean = 0.5 * (c.meanI[k] + c.meanJ[k]);
      around = localStress(0.0, 0.0, row[0], row[1], row[2], mean, pnx[k], pny[k]);
      const bool works = !link::isLinked(kind) & (eps < plastic) & hasLinkWork(law.limits);
      work = works ? total + row[rows.local.work] : 0.0;
    }
    const ContactStress s =
        contactStress<LOCAL>(law, kind, eps, plastic, gamma, total, psep[k], c.meanI[k],
                             c.factorI[k], c.meanJ[k], c.factorJ[k], around, work);

    // next state; conditions as factors of 0 or 1, which vectorise
    const double linkedNext = link::linked(s.kindNext), stays = link::linked(kind) * linkedNext;
    const double flow = kind == link::bulk ? (s.trial - s.sigma) * law.invTwoG : 0.0;
    const double dented = plastic + flow;
    // once apart, both surfaces are whole again
    const double apart = eps > (dented > 0.0 ? dented : 0.0) ? 1.0 - linkedNext : 0.0;
    const double plasticNext = (1.0 - apart) * dented;
    // exactly the same where nothing flows, so that a pair's way does not depend on its block
    const double back = kind == link::bulk ? 0.5 * (c.factorI[k] + c.factorJ[k]) : 1.0;
    const double gammaNext = stays * back * gamma;
    const double totalNext = stays * total + (1.0 - linkedNext) * work;
    kind1[k] = s.kindNext;
    plastic1[k] = plasticNext;
    gamma1[k] = gammaNext;
    total1[k] = totalNext;
    kinds += kind == s.kindNext ? 0.0 : 1.0;
    states += kind == s.kindNext ? 0.0 : 1.0;
    states += plastic == plasticNext ? 0.0 : 1.0;
    states += gamma == gammaNext ? 0.0 : 1.0;
    states += total == totalNext ? 0.0 : 1.0;
    c.setForce(k, law, s.normal, s.shear, eps, pnx[k], pny[k]);
  }
  return {kinds, states};
}

// Bulk links of one law of which none breaks.
template<bool PRISTINE, bool FLOWS>
void bulkForceBlock(const Pairs &p, int first, int n, const PairLaw *laws, PairColumns &c)
{
  const double *const pplastic = p.now.plastic + first, *const pgamma = p.now.gamma[0] + first;
  const double *const ptotal = p.now.gammaTotal[0] + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  double *const gamma1 = p.next.gamma[0] + first, *const total1 = p.next.gammaTotal[0] + first;
  const double *const pnx = p.normal[0] + first, *const pny = p.normal[1] + first;
  const double *const peps = p.eps + first;
  const PairLaw law = laws[p.law[first]];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const double plastic = PRISTINE ? 0.0 : pplastic[k];
    const double eps = peps[k], meanI = c.meanI[k], meanJ = c.meanJ[k];
    const double trial = elasticStress(law, eps - plastic, meanI, meanJ);
    const double elasticShear = law.twoG * pgamma[k];
    if (FLOWS) {
      const double factorI = c.factorI[k], factorJ = c.factorJ[k];
      const double sigma = returnedStress(trial, meanI, factorI, meanJ, factorJ);
      const double back = 0.5 * (factorI + factorJ), tau = back * elasticShear;
      kind1[k] = link::bulk;
      plastic1[k] = plastic + (trial - sigma) * law.invTwoG;
      gamma1[k] = back * pgamma[k];
      total1[k] = PRISTINE ? pgamma[k] : ptotal[k];
      c.setForce(k, law, sigma, tau, eps, pnx[k], pny[k]);
    } else {
      c.setForce(k, law, trial, elasticShear, eps, pnx[k], pny[k]);
    }
  }
}

// Means of both automata of a block's pairs.
inline void gatherLocal(const int *pi, const int *pj, int n, const double *local, double *means)
{
  for (int k = 0; k < n; k++)
    *rowOf<Row4>(means, k) = 0.5 * (*rowOf<Row4>(local, pi[k]) + *rowOf<Row4>(local, pj[k]));
}

double forcePass(const Pairs &p, const PairLaw *laws, const double *response, const double *local,
                 double *forces)
{
  PairColumns c;
  alignas(64) double means[blockLength * rows.local.length];
  double changed = 0.0;
  eachBlock(p, laws, [&](Block &block, auto way, int first, int n) {
    constexpr bool pristine = way.way == PRISTINE;
    const int *const pi = p.i + first, *const pj = p.j + first;
    gather(pi, n, response, c.meanI, c.factorI);
    gather(pj, n, response, c.meanJ, c.factorJ);
    if (onlyBulk(way.way) && !block.breaks) {
      block.moves = !allOne(n, c.factorI, c.factorJ);
      if (block.moves)
        bulkForceBlock<pristine, true>(p, first, n, laws, c);
      else
        bulkForceBlock<pristine, false>(p, first, n, laws, c);
    } else {
      constexpr Way mixed = way.way == SEVERAL_LAWS ? SEVERAL_LAWS : ONE_LAW;
      if (local)
        gatherLocal(pi, pj, n, local, means);
      const Changes changes = local ? forceBlock<mixed, true>(p, first, n, laws, means, c)
                                    : forceBlock<mixed, false>(p, first, n, laws, nullptr, c);
      block.moves = changes.states > 0.0;
      changed += changes.kinds;
    }
    scatter(pi, pj, n, c.fx, c.fy, c.torque, c.torque, Row4{-1.0, -1.0, 1.0, 1.0}, forces);
  });
  return changed;
}

} // namespace

extern const Kernel plane = {MCA_ISA_NAME, 2,         rows,       strainPass,      meanPass,
                             stressPass,   yieldPass, returnPass, secondYieldPass, forcePass};

} // namespace MCA_ISA
} // namespace mca
