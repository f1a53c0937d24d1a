#include "critical_step.h"

#include "packing.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <limits>

namespace mca {

using Vector = Eigen::Vector3cd; // amplitudes of u_x/d, u_y/d and the rotation
using Matrix = Eigen::Matrix3cd;

// Largest squared frequency at one wave vector, from the energy of one automaton (elasticity.h),
// U = V [ (G/3) sum (|e|^2 + |gamma|^2) + D |sigma_mean|^2/(2K) ], thickness 1.
static double squaredFrequency(const Material &m, double D, double qx, double qy)
{
  const HexagonalPacking cell{m.diameter, 1.0};
  const double third = HexagonalPacking::stressWeight();
  Matrix energy = Matrix::Zero();
  Vector sum = Vector::Zero();
  for (int k = 0; k < HexagonalPacking::coordination; k++) {
    const double angle = k * std::acos(-1.0) / 3.0, nx = std::cos(angle), ny = std::sin(angle);
    const std::complex<double> phase = std::polar(1.0, qx * nx + qy * ny), step = phase - 1.0;
    const Vector normal(nx * step, ny * step, 0.0);
    const Vector shear(-ny * step, nx * step, -0.5 * (1.0 + phase));
    energy += third * m.shearModulus() * (normal * normal.adjoint() + shear * shear.adjoint());
    sum += normal;
  }
  energy += 0.5 * D * m.bulkModulus() * third * third * (sum * sum.adjoint());
  const double translational = cell.mass(m.density) * m.diameter * m.diameter;
  const Eigen::Vector3d inverseRoot =
      Eigen::Vector3d(translational, translational, cell.inertia(m.density))
          .cwiseSqrt()
          .cwiseInverse();
  const Matrix dynamical =
      2.0 * cell.cellVolume() * (inverseRoot.asDiagonal() * energy * inverseRoot.asDiagonal());
  return Eigen::SelfAdjointEigenSolver<Matrix>(dynamical, Eigen::EigenvaluesOnly).eigenvalues()(2);
}

CriticalStep criticalStep(const Material &m, double D, double viscosity)
{
  // A grid over the reciprocal cell that holds the zone's corners and the middles of its sides,
  // where the largest frequencies lie. Phases of both lattice vectors; opposite wave vectors agree.
  constexpr int grid = 12;
  const double mesh = 2.0 * std::acos(-1.0) / grid;
  double largest = 0.0;
  for (int a = 0; a <= grid / 2; a++)
    for (int b = 0; b < grid; b++) {
      const double qx = a * mesh, qy = (2.0 * b - a) * mesh / std::sqrt(3.0);
      largest = std::max(largest, squaredFrequency(m, D, qx, qy));
    }
  const HexagonalPacking cell{m.diameter, 1.0};
  const double damping = viscosity * cell.contactArea() / m.diameter;
  return {2.0 / std::sqrt(largest), damping > 0.0 ? cell.mass(m.density) / (3.0 * damping)
                                                  : std::numeric_limits<double>::infinity()};
}

} // namespace mca
