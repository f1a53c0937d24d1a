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

inline int lesser(int a, int b) { return a < b ? a : b; }

template <int ROW> inline void addRow(double *to, const double *row)
{
  for (int m = 0; m < ROW; m++) to[m] += row[m];
}

template <bool ONE>
void strainBlock(const Pairs &p, int first, int n, const PairState &from, double dt,
                 const PairLaw *laws, const double *motion, double *rows)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const kind0 = from.kind + first, *const plastic0 = from.plastic + first;
  const double *const gamma0 = from.gamma + first, *const total0 = from.gammaTotal + first;
  double *const kind1 = p.now.kind + first, *const plastic1 = p.now.plastic + first;
  double *const gamma1 = p.now.gamma + first, *const total1 = p.now.gammaTotal + first;
  double *const pnx = p.nx + first, *const pny = p.ny + first;
  double *const peps = p.eps + first, *const psep = p.separation + first;
#pragma omp simd
  for (int k = 0; k < n; k++) {
    const double invDiameter = laws[ONE ? 0 : plaw[k]].invDiameter;
    const int a = motionRow * pi[k], b = motionRow * pj[k];
    const double dx = motion[b] - motion[a], dy = motion[b + 1] - motion[a + 1];
    const double r2 = dx * dx + dy * dy;
    const double r = std::sqrt(r2), invR = 1.0 / r;
    const double nx = dx * invR, ny = dy * invR;
    const double dvx = motion[b + 2] - motion[a + 2], dvy = motion[b + 3] - motion[a + 3];
    const double vn = dvx * nx + dvy * ny, vt = dvy * nx - dvx * ny;
    const double turn = axisRotation(r, vn * dt, vt * dt);
    const double dgamma = shearIncrement(turn, motion[a + 4] * dt, motion[b + 4] * dt);

    const double kind = kind0[k], plastic = plastic0[k];
    const double eps = r * invDiameter - 1.0, e = eps - plastic;
    const bool linked = kind != link::none;
    const double gamma = linked ? gamma0[k] + dgamma : 0.0;
    kind1[k] = kind;
    plastic1[k] = plastic;
    gamma1[k] = gamma;
    total1[k] = linked ? total0[k] + dgamma : 0.0;
    pnx[k] = nx;
    pny[k] = ny;
    peps[k] = eps;
    psep[k] = vn;

    const double touching = (linked | (e < 0.0)) ? 1.0 : 0.0;
    const ContactSums s = contactShare(e * touching, gamma, nx, ny);
    double *const row = rows + sumsRow * k;
    row[0] = s.Pxx;
    row[1] = s.Pyy;
    row[2] = s.Pxy;
    row[3] = s.Nxx * touching;
    row[4] = s.Nyy * touching;
    row[5] = s.Nxy * touching;
    row[6] = kind == link::bulk ? 1.0 : 0.0;
    row[7] = e * e * touching + gamma * gamma;
  }
}

void strainPass(const Pairs &p, double dt, const PairLaw *laws, bool oneLaw, const double *motion,
                double *sums)
{
  alignas(64) double rows[block * sumsRow];
  const PairState &from = dt > 0.0 ? p.next : p.now;
  for (int first = 0; first < p.n; first += block) {
    const int n = lesser(block, p.n - first);
    if (oneLaw)
      strainBlock<true>(p, first, n, from, dt, laws, motion, rows);
    else
      strainBlock<false>(p, first, n, from, dt, laws, motion, rows);
    for (int k = 0; k < n; k++) {
      addRow<sumsRow>(sums + sumsRow * p.i[first + k], rows + sumsRow * k);
      addRow<sumsRow>(sums + sumsRow * p.j[first + k], rows + sumsRow * k);
    }
  }
}

void yieldPass(int n, const int *type, const AutomatonLaw *laws, const double *sums,
               const double *kappa, double *kappaNext, double *response)
{
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = laws[type[i]];
    const double *const row = sums + sumsRow * i;
    const ContactSums s = {row[0], row[1], row[2], row[3], row[4], row[5]};
    const double mean = meanStress(s, law.bulkModulus);
    const StressTensor stress = automatonStress(s, 2.0 * law.shearModulus, law.D, mean);
    const RadialReturn back =
        radialReturn(stressIntensity(stress), law.curve(kappa[i]), law.shearModulus);
    // without a bulk link there is nothing that could flow
    const bool flows = law.yields * row[6] > 0.0;
    kappaNext[i] = kappa[i] + (flows ? back.strain : 0.0);
    response[responseRow * i] = mean;
    response[responseRow * i + 1] = flows ? back.factor : 1.0;
  }
}

template <bool ONE>
double forceBlock(const Pairs &p, int first, int n, const PairLaw *laws, const double *response,
                  double *rows)
{
  const int *const pi = p.i + first, *const pj = p.j + first, *const plaw = p.law + first;
  const double *const pkind = p.now.kind + first, *const pplastic = p.now.plastic + first;
  const double *const pgamma = p.now.gamma + first, *const ptotal = p.now.gammaTotal + first;
  double *const kind1 = p.next.kind + first, *const plastic1 = p.next.plastic + first;
  double *const gamma1 = p.next.gamma + first, *const total1 = p.next.gammaTotal + first;
  const double *const pnx = p.nx + first, *const pny = p.ny + first;
  const double *const peps = p.eps + first, *const psep = p.separation + first;
  const PairLaw one = laws[0];
  double changed = 0.0;
#pragma omp simd reduction(+ : changed)
  for (int k = 0; k < n; k++) {
    const PairLaw &law = ONE ? one : laws[plaw[k]];
    const int a = responseRow * pi[k], b = responseRow * pj[k];
    const double meanI = response[a], factorI = response[a + 1];
    const double meanJ = response[b], factorJ = response[b + 1];
    const double kind = pkind[k], plastic = pplastic[k], gamma = pgamma[k];
    const double eps = peps[k];
    const ContactStress s = contactStress(law, kind, eps - plastic, gamma, psep[k],
                                          meanI, factorI, meanJ, factorJ);

    // next state; conditions as factors of 0 or 1, which vectorise
    const double kindNext = nextKind(kind, s.sigma, s.tau, eps, ptotal[k], law.limits);
    const double linked = kind == link::none ? 0.0 : 1.0;
    const double linkedNext = kindNext == link::none ? 0.0 : 1.0;
    const double stays = linked * linkedNext;
    const double flow = kind == link::bulk ? (s.trial - s.sigma) / law.meanTwoG() : 0.0;
    const double dented = plastic + flow;
    // once apart, both surfaces are whole again
    const double apart = eps > (dented > 0.0 ? dented : 0.0) ? 1.0 - linkedNext : 0.0;
    kind1[k] = kindNext;
    plastic1[k] = (1.0 - apart) * dented;
    gamma1[k] = stays * s.tau / law.meanTwoG();
    total1[k] = stays * ptotal[k];
    changed += kind == kindNext ? 0.0 : 1.0;

    // The shear force acts along t at the distance r; its moment tau S d keeps U's gradient exact.
    const double fn = s.normal * law.area, ft = s.tau * law.area / (1.0 + eps);
    const double nx = pnx[k], ny = pny[k];
    double *const row = rows + forceRow * k;
    row[0] = fn * nx - ft * ny;
    row[1] = fn * ny + ft * nx;
    row[2] = 0.5 * s.tau * law.area * law.diameter;
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
    for (int k = 0; k < n; k++) {
      const double *const row = rows + forceRow * k;
      double *const fi = forces + forceRow * p.i[first + k];
      double *const fj = forces + forceRow * p.j[first + k];
      const double opposite[forceRow] = {-row[0], -row[1], row[2], row[3]};
      addRow<forceRow>(fi, row);
      addRow<forceRow>(fj, opposite);
    }
  }
  return changed;
}

}  // namespace

extern const Kernel kernel = {MCA_ISA_NAME, strainPass, yieldPass, forcePass};

}  // namespace MCA_ISA
}  // namespace mca
