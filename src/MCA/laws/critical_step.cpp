// SPDX-License-Identifier: GPL-2.0-or-later
#include "critical_step.h"

#include "fracture.h"
#include "shared/pi.h"
#include "vector.h"
#include "viscosity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace mca {

namespace {

using Complex = std::complex<double>;

constexpr int freedomsOfOne = 6;                   // u/d and the rotation of an automaton
constexpr int mostFreedoms = 2 * freedomsOfOne;    // hcp has two automata in its period
using Factors = std::array<Complex, mostFreedoms>; // of the freedoms in a sum of them

struct Neighbour {
  int from, to; // numbers in the lattice's basis
  Vector normal;
};

Vector vector(const Lattice::Point &p)
{
  return {p.x, p.y, p.z};
}

std::vector<Neighbour> neighboursIn(const Lattice &lattice, int dimension)
{
  const int layers = dimension == 2 ? 0 : 2;
  std::vector<Neighbour> all;
  const int size = static_cast<int>(lattice.basis.size());
  for (int from = 0; from < size; from++)
    for (int to = 0; to < size; to++)
      for (int a = -2; a <= 2; a++)
        for (int b = -2; b <= 2; b++)
          for (int c = -layers; c <= layers; c++) {
            const Vector n = vector(lattice.basis[to]) - vector(lattice.basis[from]) +
                             a * vector(lattice.edges[0]) + b * vector(lattice.edges[1]) +
                             c * vector(lattice.edges[2]);
            if (std::abs(length(n) - 1.0) < 1e-6)
              all.push_back({from, to, n});
          }
  return all;
}

// A quadratic form of the freedoms: a sum of squares |row|^2.
class Form {
 public:
  explicit Form(int freedoms) : n_(freedoms) {}

  void add(double factor, const Factors &row)
  {
    for (int i = 0; i < n_; i++)
      for (int k = 0; k < n_; k++)
        a_[i][k] += factor * std::conj(row[i]) * row[k];
  }

  void scale(const std::array<double, mostFreedoms> &factor)
  {
    for (int i = 0; i < n_; i++)
      for (int k = 0; k < n_; k++)
        a_[i][k] *= factor[i] * factor[k];
  }

  // The largest eigenvalue, but at least `known`: the p-th root of the trace of the p-th power,
  // p = 1, 2, 4 ..., which falls to it. It exceeds it by a factor of n^(1/p) at most.
  double largest(double known) const
  {
    constexpr int squarings = 44; // n^(1/p) - 1 < 2e-13
    Form power = *this;
    double bound = 1.0, root = 1.0;
    for (int k = 0; k <= squarings; k++, root *= 0.5) {
      const double trace = power.trace();
      bound *= std::pow(trace, root);
      if (bound <= known)
        return known;
      power = power.squared(1.0 / trace);
    }
    return bound;
  }

 private:
  double trace() const
  {
    double sum = 0.0;
    for (int i = 0; i < n_; i++)
      sum += a_[i][i].real();
    return sum;
  }

  // The square of this form times a factor; Hermitian as this is.
  Form squared(double factor) const
  {
    Form square(n_);
    for (int i = 0; i < n_; i++)
      for (int k = 0; k <= i; k++) {
        Complex sum = 0.0;
        for (int j = 0; j < n_; j++)
          sum += factor * a_[i][j] * (factor * std::conj(a_[k][j]));
        square.a_[i][k] = sum;
        square.a_[k][i] = std::conj(sum);
      }
    return square;
  }

  int n_;
  std::array<Factors, mostFreedoms> a_{};
};

// Normal strain of a pair, and its shear along the axes of space, in the amplitudes of both ends:
// e = n (u_j - u_i), gamma = (1 - n n)(u_j - u_i) + n x (theta_i + theta_j)/2, of the wave's phase.
struct PairStrain {
  Factors normal{};
  std::array<Factors, 3> shear{};

  PairStrain(const Neighbour &pair, Complex phase)
  {
    const double n[] = {pair.normal.x, pair.normal.y, pair.normal.z};
    const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
    const int from = freedomsOfOne * pair.from, to = freedomsOfOne * pair.to;
    for (int k = 0; k < 3; k++) {
      normal[from + k] -= n[k];
      normal[to + k] += phase * n[k];
      for (int i = 0; i < 3; i++) {
        const double across = (i == k ? 1.0 : 0.0) - n[i] * n[k];
        shear[i][from + k] -= across;
        shear[i][to + k] += phase * across;
        shear[i][from + 3 + k] += 0.5 * cross[i][k];
        shear[i][to + 3 + k] += phase * (0.5 * cross[i][k]);
      }
    }
  }
};

// 1/sqrt of the mass or moment of inertia of each freedom, 0 for those that do not move: in the
// plane all but u_x, u_y and the rotation about z.
std::array<double, mostFreedoms> inverseRoots(const Material &m, const Packing &packing)
{
  const Cell cell{packing, m.diameter};
  const double translational = cell.mass(m.density) * m.diameter * m.diameter;
  const double rotational = cell.inertia(m.density);
  std::array<double, mostFreedoms> roots{};
  for (int k = 0; k < mostFreedoms; k++) {
    const int direction = k % freedomsOfOne;
    if (packing.dimension == 3 || direction < 2 || direction == 5)
      roots[k] = 1.0 / std::sqrt(direction < 3 ? translational : rotational);
  }
  return roots;
}

// Energy of the lattice's period (elasticity.h) at one wave vector over the masses, whose
// eigenvalues are the squared frequencies: U = sum V [ w G sum (|e|^2 + |gamma|^2) +
// D |sigma_mean|^2/(2K) ], in the amplitudes of u/d and the rotation of each automaton.
// wave: phases of the place of an automaton, 1/d
Form dynamicalForm(const Material &m, double D, const Packing &packing,
                   const std::vector<Neighbour> &neighbours, int basis, const Vector &wave)
{
  const double weight = packing.stressWeight();
  const double perPeriod = 2.0 * Cell{packing, m.diameter}.cellVolume();
  Form form(freedomsOfOne * basis);
  std::array<Factors, 2> sums{}; // of e about each automaton
  for (const Neighbour &pair : neighbours) {
    const PairStrain strain(pair, std::polar(1.0, dot(wave, pair.normal)));
    const double factor = perPeriod * weight * m.shearModulus();
    form.add(factor, strain.normal);
    for (const Factors &shear : strain.shear)
      form.add(factor, shear);
    for (int k = 0; k < mostFreedoms; k++)
      sums[pair.from][k] += strain.normal[k];
  }
  for (const Factors &sum : sums)
    form.add(perPeriod * 0.5 * D * m.bulkModulus() * weight * weight, sum);
  form.scale(inverseRoots(m, packing));
  return form;
}

// Reciprocal edges of a lattice: b_i a_k = 1 for i = k, else 0.
std::array<Vector, 3> reciprocalOf(const Lattice &lattice)
{
  std::array<Vector, 3> reciprocal{};
  for (int k = 0; k < 3; k++) {
    const Vector normal =
        cross(vector(lattice.edges[(k + 1) % 3]), vector(lattice.edges[(k + 2) % 3]));
    reciprocal[k] = (1.0 / dot(vector(lattice.edges[k]), normal)) * normal;
  }
  return reciprocal;
}

} // namespace

// Both automata of a link move along its face and turn, in antiphase and alike: the energy
// 2 V w G gamma^2, gamma = u/r + theta, of masses m and moments of inertia J has the frequency
// omega^2 = 8 w G/rho (1/r^2 + m/(4 J)). Moved along their normal, 2 V w (G + D K w/2) ln(r)^2, it
// is 8 w/rho (G + D K w/2)/r^2; of strains that are not logarithmic it does not grow.
static double pressedStep(const Material &m, double D, const Packing &packing, bool isochoric)
{
  const double nearest = isochoric ? std::exp(collapseStrain) : 1.0 + collapseStrain;
  const double r = nearest * m.diameter, weight = packing.stressWeight();
  const double turning = 0.25 / (packing.inertia * m.diameter * m.diameter);
  const double shear = m.shearModulus() * (1.0 / (r * r) + turning);
  const double along = isochoric ? r : m.diameter;
  const double normal = (m.shearModulus() + 0.5 * D * m.bulkModulus() * weight) / (along * along);
  return 2.0 / std::sqrt(8.0 * weight * std::max(shear, normal) / m.density);
}

// What is damped fastest: its rate lambda [c/m], and the part of it that is centred.
struct Damping {
  double rate, share;
};

// Without slip: an automaton moves against all its neighbours.
static Damping dampingOfMoves(const Packing &packing)
{
  const double share = static_cast<double>(packing.dimension) / packing.coordination; // D/N
  return {2.0 / share, share};
}

// With slip: all automata turn alike, each contact slips by d omega x n. Since J is small that
// decays faster than any motion of the centres: for all modes, 2 N c/m bounds their part.
static Damping dampingOfTurns(const Packing &packing)
{
  return {0.5 * packing.slippingContacts() / packing.inertia, centredSlipShare};
}

CriticalStep criticalStep(const Material &m, double D, double viscosity, const Packing &packing,
                          bool slips, bool isochoric)
{
  // A grid over the reciprocal cell that holds the zone's corners and the middles of its sides and
  // faces, where the largest frequencies lie. Phases of the lattice's edges; opposite wave vectors
  // agree.
  constexpr int grid = 12;
  const double mesh = 2.0 * mcawr::pi / grid;
  const Lattice lattice = latticeOf(packing);
  const std::vector<Neighbour> neighbours = neighboursIn(lattice, packing.dimension);
  const std::array<Vector, 3> edges = reciprocalOf(lattice);
  const int basis = static_cast<int>(lattice.basis.size());
  const int last = packing.dimension == 2 ? 1 : grid;
  double largest = 0.0;
  for (int a = 0; a <= grid / 2; a++)
    for (int b = 0; b < grid; b++)
      for (int c = 0; c < last; c++) {
        const Vector wave = mesh * (a * edges[0] + b * edges[1] + c * edges[2]);
        largest = dynamicalForm(m, D, packing, neighbours, basis, wave).largest(largest);
      }
  const Damping fastest = slips ? dampingOfTurns(packing) : dampingOfMoves(packing);
  const Cell cell{packing, m.diameter};
  const double damping = viscosity * cell.contactArea() / m.diameter;
  const double viscous = damping > 0.0 ? 2.0 * cell.mass(m.density) / (fastest.rate * damping)
                                       : std::numeric_limits<double>::infinity();
  return {2.0 / std::sqrt(largest), viscous, pressedStep(m, D, packing, isochoric), fastest.share};
}

double CriticalStep::plain() const
{
  const double s = 0.5 * elastic / viscous;
  return elastic / (s + std::sqrt(1.0 + s * s));
}

// A mode of frequency omega and damping rate lambda' <= lambda, with s = share lambda dt/2 and
// q = lambda' dt/(2 (1 + s)), is stable while q < 1 and (omega^2 dt^2 + 2 lambda' dt)(1 - q) < 4.
// At the lambda' that is worst the latter is (dt/elastic)^2 + (sqrt(1 + s) - 1)^2 < 1.
double CriticalStep::centred() const
{
  double stable = 0.0, unstable = elastic;
  for (int k = 0; k < 60; k++) {
    const double dt = 0.5 * (stable + unstable), u = dt / elastic;
    const double more = std::sqrt(1.0 + share * dt / viscous) - 1.0;
    (u * u + more * more < 1.0 ? stable : unstable) = dt;
  }
  return std::min(unstable, viscous / (1.0 - share));
}

} // namespace mca
