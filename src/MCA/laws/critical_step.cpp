// SPDX-License-Identifier: GPL-2.0-or-later
#include "critical_step.h"

#include "fracture.h"
#include "shared/pi.h"
#include "viscosity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <complex>
#include <limits>
#include <vector>

namespace mca {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

struct Neighbour {
  int from, to; // numbers in the lattice's basis
  Vector3d normal;
};

Vector3d vector(const Lattice::Point &p)
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
            const Vector3d n = vector(lattice.basis[to]) - vector(lattice.basis[from]) +
                               a * vector(lattice.edges[0]) + b * vector(lattice.edges[1]) +
                               c * vector(lattice.edges[2]);
            if (std::abs(n.norm() - 1.0) < 1e-6)
              all.push_back({from, to, n});
          }
  return all;
}

Matrix3d crossWith(const Vector3d &n) // n x
{
  Matrix3d m;
  m << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return m;
}

} // namespace

// Largest squared frequency at one wave vector, from the energy of the lattice's period
// (elasticity.h), U = sum V [ w G sum (|e|^2 + |gamma|^2) + D |sigma_mean|^2/(2K) ], in the
// amplitudes of u/d and the rotation of each automaton. In the plane only u_x, u_y and the
// rotation about z move.
static double squaredFrequency(const Material &m, double D, const Packing &packing,
                               const std::vector<Neighbour> &neighbours, int basis,
                               const Vector3d &wave)
{
  const Cell cell{packing, m.diameter};
  const double weight = packing.stressWeight();
  const bool plane = packing.dimension == 2;
  const int freedoms = 6 * basis;
  Matrix energy = Matrix::Zero(freedoms, freedoms), sums = Matrix::Zero(basis, freedoms);
  for (const Neighbour &pair : neighbours) {
    const Vector3d &n = pair.normal;
    const Complex phase = std::polar(1.0, wave.dot(n));
    Matrix step = Matrix::Zero(3, freedoms), turn = Matrix::Zero(3, freedoms);
    step.middleCols<3>(6 * pair.from) -= Matrix3d::Identity();
    step.middleCols<3>(6 * pair.to) += phase * Matrix3d::Identity();
    turn.middleCols<3>(6 * pair.from + 3) += 0.5 * crossWith(n);
    turn.middleCols<3>(6 * pair.to + 3) += phase * (0.5 * crossWith(n));
    const Matrix normal = n.transpose() * step;
    const Matrix shear = (Matrix3d::Identity() - n * n.transpose()) * step + turn;
    energy += weight * m.shearModulus() * (normal.adjoint() * normal + shear.adjoint() * shear);
    sums.row(pair.from) += normal;
  }
  energy += 0.5 * D * m.bulkModulus() * weight * weight * (sums.adjoint() * sums);

  const double translational = cell.mass(m.density) * m.diameter * m.diameter;
  const double rotational = cell.inertia(m.density);
  Eigen::VectorXd inverseRoot = Eigen::VectorXd::Zero(freedoms);
  for (int k = 0; k < freedoms; k++) {
    const int direction = k % 6;
    if (!plane || direction < 2 || direction == 5)
      inverseRoot(k) = 1.0 / std::sqrt(direction < 3 ? translational : rotational);
  }
  const Matrix dynamical =
      2.0 * cell.cellVolume() * (inverseRoot.asDiagonal() * energy * inverseRoot.asDiagonal());
  return Eigen::SelfAdjointEigenSolver<Matrix>(dynamical, Eigen::EigenvaluesOnly)
      .eigenvalues()(freedoms - 1);
}

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
  Matrix3d edges;
  for (int k = 0; k < 3; k++)
    edges.row(k) = vector(lattice.edges[k]);
  const Matrix3d reciprocal = edges.inverse();
  const int last = packing.dimension == 2 ? 1 : grid;
  double largest = 0.0;
  for (int a = 0; a <= grid / 2; a++)
    for (int b = 0; b < grid; b++)
      for (int c = 0; c < last; c++) {
        const Vector3d wave = reciprocal * (mesh * Vector3d(a, b, c));
        largest = std::max(largest, squaredFrequency(m, D, packing, neighbours,
                                                     static_cast<int>(lattice.basis.size()), wave));
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
