// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/patch/elasticity/cell_stress.h"

#include "shared/pi.h"

#include <Eigen/Dense>
#include <cmath>

namespace wheelrail {
namespace {

using mcawr::pi;

/// R + t with R^2 = t^2 + rest, without loss of digits where t < 0.
double sumWith(double t, double R, double rest)
{
  return t > 0.0 ? R + t : rest / (R - t);
}

// Antiderivatives in x and y, 2 pi times. With the potentials V = integral of p/R, chi = integral
// of p ln(R + z) the pressure gives (Love; a comma differentiates)
//   xx = 2 nu V,z - z V,xx - (1 - 2 nu) chi,xx   zz = V,z - z V,zz   zx = -z V,xz
//   xy = -(1 - 2 nu) chi,xy - z V,xy
// and a traction along x, with F = chi and F1 = integral of q (z ln(R + z) - R), F1,z = F,
//   xx = 2 (1 + nu) V,x + 2 nu F1,xxx - z F,xxx  yy = 2 nu V,x + 2 nu F1,xyy - z F,xyy
//   zz = -z V,xz   xy = V,y + 2 nu F1,xxy - z F,xxy   yz = -z V,xy   zx = V,z - z V,xx
// All potentials are harmonic. Their derivatives, integrated once over x and y:
CellStress corner(double x, double y, double z, double nu)
{
  const double R = std::sqrt(x * x + y * y + z * z), Rz = R + z;
  const double Rx = sumWith(x, R, y * y + z * z), Ry = sumWith(y, R, x * x + z * z);
  const double Vx = std::log(Ry), Vy = std::log(Rx), Vz = -std::atan2(x * y, z * R);
  const double vXX = x / (R * Ry), vYY = y / (R * Rx), vZZ = -vXX - vYY;
  const double vXY = 1.0 / R, vYZ = z / (R * Rx), vXZ = z / (R * Ry);
  const double product = x * y * (x * x + y * y) / Rz;
  const double chiXX = std::atan2(product, x * x * R + z * y * y);
  const double chiYY = std::atan2(product, y * y * R + z * x * x);
  const double chiXY = std::log(Rz);
  const double f1XXY = -x / Rz, f1XYY = -y / Rz, f1XXX = -Vx - f1XYY;
  const double fXXY = x / (R * Rz), fXYY = y / (R * Rz), fXXX = -fXYY - vXZ;
  const double less = 1.0 - 2.0 * nu;
  return {{2.0 * nu * Vz - z * vXX - less * chiXX, 2.0 * nu * Vz - z * vYY - less * chiYY,
           Vz - z * vZZ, -less * chiXY - z * vXY, -z * vYZ, -z * vXZ},
          {2.0 * (1.0 + nu) * Vx + 2.0 * nu * f1XXX - z * fXXX,
           2.0 * nu * Vx + 2.0 * nu * f1XYY - z * fXYY, -z * vXZ, Vy + 2.0 * nu * f1XXY - z * fXXY,
           -z * vXY, Vz - z * vXX}};
}

} // namespace

CellStress cellStress(double x, double y, double z, double dx, double dy, double nu)
{
  const double left = x - 0.5 * dx, right = x + 0.5 * dx;
  const double below = y - 0.5 * dy, above = y + 0.5 * dy;
  const CellStress a = corner(right, above, z, nu), b = corner(left, above, z, nu);
  const CellStress c = corner(right, below, z, nu), d = corner(left, below, z, nu);
  CellStress sum{};
  const auto add = [](const StressTensor &i, const StressTensor &j, const StressTensor &k,
                      const StressTensor &l,
                      int n) { return ((i[n] - j[n]) - (k[n] - l[n])) / (2.0 * pi); };
  for (int n = 0; n < stressComponents; ++n) {
    sum.pressure[n] = add(a.pressure, b.pressure, c.pressure, d.pressure, n);
    sum.alongX[n] = add(a.alongX, b.alongX, c.alongX, d.alongX, n);
  }
  return sum;
}

double vonMises(const StressTensor &s)
{
  const double a = s[StressXX] - s[StressYY], b = s[StressYY] - s[StressZZ];
  const double c = s[StressZZ] - s[StressXX];
  const double shear =
      s[StressXY] * s[StressXY] + s[StressYZ] * s[StressYZ] + s[StressZX] * s[StressZX];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * shear);
}

double maximumShear(const StressTensor &s)
{
  Eigen::Matrix3d matrix;
  matrix << s[StressXX], s[StressXY], s[StressZX], s[StressXY], s[StressYY], s[StressYZ],
      s[StressZX], s[StressYZ], s[StressZZ];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrix, Eigen::EigenvaluesOnly);
  return 0.5 * (solver.eigenvalues()[2] - solver.eigenvalues()[0]);
}

} // namespace wheelrail
