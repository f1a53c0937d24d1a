// Compiled once for each instruction set; MCA_ISA names the set and its namespace. Everything a
// pass calls is inlined into it (see CMakeLists.txt), so no function compiled for a newer
// processor can be picked up by an older one.
#include "kernel.h"

#include <cmath>

namespace mca {
namespace MCA_ISA {
namespace {

// Pairs are worked on in blocks whose temporary rows stay in the first-level cache.
constexpr int block = 128;

inline int lesser(int a, int b)
{
  return a < b ? a : b;
}

// Rows of the per-automaton arrays as vectors of the compiler: one load, one addition, one store.
typedef double Row2 __attribute__((vector_size(16), may_alias));
typedef double Row4 __attribute__((vector_size(32), may_alias));
typedef double Row8 __attribute__((vector_size(64), may_alias));

template<class Row>
constexpr int lengthOf = sizeof(Row) / sizeof(double);

template<class Row>
inline Row *rowOf(double *array, int i)
{
  return reinterpret_cast<Row *>(array) + i;
}

template<class Row>
inline const Row *rowOf(const double *array, int i)
{
  return reinterpret_cast<const Row *>(array) + i;
}

// Adds each pair's row to both of its automata, with the given signs for the second one. Pairs
// come sorted by i, so that its sum stays in a register.
template<class Row>
inline void addToBoth(const Pairs &p, int first, int n, const double *rows, const Row &signs,
                      double *sums)
{
  const int *const pi = p.i + first, *const pj = p.j + first;
  for (int k = 0; k < n;) {
    const int i = pi[k];
    Row sum = *rowOf<Row>(rows, k);
    *rowOf<Row>(sums, pj[k]) += sum * signs;
    for (k++; k < n && pi[k] == i; k++) {
      const Row row = *rowOf<Row>(rows, k);
      *rowOf<Row>(sums, pj[k]) += row * signs;
      sum += row;
    }
    *rowOf<Row>(sums, i) += sum;
  }
}

template<bool ONE>
void strainBlock(const Pairs &p, int first, int n, double dt, const PairLaw *laws,
                 const double *motion, double *rows)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  double *const pgamma = p.now.gamma + first, *const ptotal = p.now.gammaTotal + first;
  double *const pnx = p.nx + first, *const pny = p.ny + first;
  double *const peps = p.eps + first, *const psep = p.separation + first;
  // motion of j seen from i; the rotations add up
  alignas(64) double relative[block * motionRow];
  const Row8 signs = {-1.0, -1.0, -1.0, -1.0, 1.0, 0.0, 0.0, 0.0};
  for (int k = 0; k < n; k++)
    *rowOf<Row8>(relative, k) = *rowOf<Row8>(motion, pj[k]) + signs * *rowOf<Row8>(motion, pi[k]);
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const double invDiameter = laws[ONE ? 0 : plaw[k]].invDiameter;
    const double *const row8 = relative + motionRow * k;
    const double dx = row8[0], dy = row8[1], dvx = row8[2], dvy = row8[3], omegas = row8[4];
    const double r2 = dx * dx + dy * dy, r = std::sqrt(r2);
    const double stepN = (dvx * dx + dvy * dy) * dt, stepT = (dvy * dx - dvx * dy) * dt; // times r
    const double inverse = 1.0 / (r2 * (r2 - stepN));
    const double invR = r * (r2 - stepN) * inverse;
    const double nx = dx * invR, ny = dy * invR;
    const double turn = axisRotation(stepT * r2 * inverse);
    const double dgamma = shearIncrement(turn, omegas * dt);

    const double kind = pkind[k];
    const double eps = r * invDiameter - 1.0, e = eps - pplastic[k];
    const bool linked = link::isLinked(kind);
    const double gamma = linked ? pgamma[k] + dgamma : 0.0;
    pgamma[k] = gamma;
    ptotal[k] = linked ? ptotal[k] + dgamma : 0.0;
    pnx[k] = nx;
    pny[k] = ny;
    peps[k] = eps;
    psep[k] = dvx * nx + dvy * ny;

    double *const row = rows + strainRow * k;
    row[0] = (linked | (e < 0.0)) ? e : 0.0;
    row[1] = kind == link::bulk ? 1.0 : 0.0;
  }
}

void strainPass(const Pairs &p, double dt, const PairLaw *laws, bool oneLaw, const double *motion,
                double *strains)
{
  alignas(64) double rows[block * strainRow];
  for (int first = 0; first < p.n; first += block) {
    const int n = lesser(block, p.n - first);
    if (oneLaw)
      strainBlock<true>(p, first, n, dt, laws, motion, rows);
    else
      strainBlock<false>(p, first, n, dt, laws, motion, rows);
    addToBoth(p, first, n, rows, Row2{1.0, 1.0}, strains);
  }
}

void meanPass(int n, const int *type, const AutomatonLaw *laws, const double *strains,
              double *response)
{
  for (int i = 0; i < n; i++) {
    response[responseRow * i] = meanStress(strains[strainRow * i], laws[type[i]].bulkModulus);
    response[responseRow * i + 1] = 1.0;
  }
}

// Responses of both automata of a block's pairs side by side: those of i, those of j.
inline void gatherResponses(const Pairs &p, int first, int n, const double *response, double *both)
{
  for (int k = 0; k < n; k++) {
    *rowOf<Row2>(both, 2 * k) = *rowOf<Row2>(response, p.i[first + k]);
    *rowOf<Row2>(both, 2 * k + 1) = *rowOf<Row2>(response, p.j[first + k]);
  }
}

template<bool ONE>
void stressBlock(const Pairs &p, int first, int n, const PairLaw *laws, const double *response,
                 double *rows)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pgamma = p.now.gamma + first, *const peps = p.eps + first;
  const double *const pnx = p.nx + first, *const pny = p.ny + first;
  alignas(64) double both[block * 2 * responseRow];
  gatherResponses(p, first, n, response, both);
  const PairLaw one = laws[0];
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const PairLaw &law = ONE ? one : laws[plaw[k]];
    const double meanI = both[4 * k], meanJ = both[4 * k + 2];
    const double e = peps[k] - pplastic[k], gamma = pgamma[k];
    const double touching = link::isLinked(pkind[k]) | (e < 0.0) ? 1.0 : 0.0;
    const double sigma = touching * elasticStress(law, e, meanI, meanJ);
    const StressTensor s = stressShare(sigma, law.twoG * gamma, pnx[k], pny[k]);
    double *const row = rows + stressRow * k;
    row[0] = s.xx;
    row[1] = s.yy;
    row[2] = s.xy;
    row[3] = touching * e * e + gamma * gamma;
  }
}

void stressPass(const Pairs &p, const PairLaw *laws, bool oneLaw, const double *response,
                double *stresses)
{
  alignas(64) double rows[block * stressRow];
  for (int first = 0; first < p.n; first += block) {
    const int n = lesser(block, p.n - first);
    if (oneLaw)
      stressBlock<true>(p, first, n, laws, response, rows);
    else
      stressBlock<false>(p, first, n, laws, response, rows);
    addToBoth(p, first, n, rows, Row4{1.0, 1.0, 1.0, 1.0}, stresses);
  }
}

void yieldPass(int n, const int *type, const AutomatonLaw *laws, const double *strains,
               const double *stresses, const double *kappa, double *kappaNext, double *response)
{
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = laws[type[i]];
    const double *const row = stresses + stressRow * i;
    const StressTensor s = automatonStress(row[0], row[1], row[2], response[responseRow * i]);
    const RadialReturn back =
        radialReturn(stressIntensity(s), law.curve(kappa[i]), law.shearModulus);
    // without a bulk link there is nothing that could flow
    const bool flows = law.yields * strains[strainRow * i + 1] > 0.0;
    kappaNext[i] = kappa[i] + (flows ? back.strain : 0.0);
    response[responseRow * i + 1] = flows ? back.factor : 1.0;
  }
}

template<bool ONE>
double forceBlock(const Pairs &p, int first, int n, const PairLaw *laws, const double *response,
                  double *rows)
{
  const int *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pgamma = p.now.gamma + first, *const ptotal = p.now.gammaTotal + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  double *const gamma1 = p.next.gamma + first, *const total1 = p.next.gammaTotal + first;
  const double *const pnx = p.nx + first, *const pny = p.ny + first;
  const double *const peps = p.eps + first, *const psep = p.separation + first;
  alignas(64) double both[block * 2 * responseRow];
  gatherResponses(p, first, n, response, both);
  const PairLaw one = laws[0];
  double changed = 0.0;
#pragma omp simd reduction(+ : changed)
  for (int k = 0; k < n; k++) {
    const PairLaw &law = ONE ? one : laws[plaw[k]];
    const double meanI = both[4 * k], factorI = both[4 * k + 1];
    const double meanJ = both[4 * k + 2], factorJ = both[4 * k + 3];
    const double kind = pkind[k], plastic = pplastic[k], eps = peps[k], total = ptotal[k];
    const ContactStress s = contactStress(law, kind, eps, plastic, pgamma[k], total, psep[k], meanI,
                                          factorI, meanJ, factorJ);

    // next state; conditions as factors of 0 or 1, which vectorise
    const double linkedNext = link::linked(s.kindNext), stays = link::linked(kind) * linkedNext;
    const double flow = kind == link::bulk ? (s.trial - s.sigma) * law.invTwoG : 0.0;
    const double dented = plastic + flow;
    // once apart, both surfaces are whole again
    const double apart = eps > (dented > 0.0 ? dented : 0.0) ? 1.0 - linkedNext : 0.0;
    kind1[k] = s.kindNext;
    plastic1[k] = (1.0 - apart) * dented;
    gamma1[k] = stays * s.tau * law.invTwoG;
    total1[k] = stays * total;
    changed += kind == s.kindNext ? 0.0 : 1.0;

    // The shear force acts along t at the distance r; its moment tau S d/2 keeps U's gradient
    // exact.
    const double fn = s.normal * law.area, ft = s.shear * law.area / (1.0 + eps);
    const double nx = pnx[k], ny = pny[k];
    double *const row = rows + forceRow * k;
    row[0] = fn * nx - ft * ny;
    row[1] = fn * ny + ft * nx;
    row[2] = 0.5 * s.shear * law.area * law.diameter;
    row[3] = 0.0;
  }
  return changed;
}

double forcePass(const Pairs &p, const PairLaw *laws, bool oneLaw, const double *response,
                 double *forces)
{
  alignas(64) double rows[block * forceRow];
  double changed = 0.0;
  for (int first = 0; first < p.n; first += block) {
    const int n = lesser(block, p.n - first);
    changed += oneLaw ? forceBlock<true>(p, first, n, laws, response, rows)
                      : forceBlock<false>(p, first, n, laws, response, rows);
    addToBoth(p, first, n, rows, Row4{-1.0, -1.0, 1.0, 1.0}, forces);
  }
  return changed;
}

} // namespace

extern const Kernel kernel = {MCA_ISA_NAME, strainPass, meanPass, stressPass, yieldPass, forcePass};

} // namespace MCA_ISA
} // namespace mca
