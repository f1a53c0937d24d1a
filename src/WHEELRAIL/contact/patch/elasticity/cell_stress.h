// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_CELL_STRESS_H
#define WHEELRAIL_PATCH_CELL_STRESS_H

#include <array>

namespace wheelrail {

/// Components of a stress, in this order: xx, yy, zz, xy, yz, zx; z points into the body, tension
/// is positive.
enum StressComponent { StressXX, StressYY, StressZZ, StressXY, StressYZ, StressZX };
constexpr int stressComponents = 6;
using StressTensor = std::array<double, stressComponents>;

/// Stress in a half-space below a cell of its surface that is loaded uniformly by 1: exact closed
/// forms of the integrals of Boussinesq's and Cerruti's solutions over a rectangle (A. E. H. Love,
/// Phil. Trans. R. Soc. A 228 (1929) 377 for the pressure; of the potentials of K. L. Johnson,
/// Contact Mechanics, 1985, sec. 3.2, for the traction).
struct CellStress {
  StressTensor pressure; ///< of a pressure
  StressTensor alongX;   ///< of a traction on the body along x; along y it is that with x and y
                         ///< exchanged
};

/// \param x, y of the place, from the middle of the cell; any unit
/// \param z depth, > 0
/// \param nu Poisson's ratio of the body, 0 to 1/2
CellStress cellStress(double x, double y, double z, double dx, double dy, double nu);

/// Von Mises's equivalent stress, >= 0.
double vonMises(const StressTensor &stress);
/// Half the difference of the largest and the smallest principal stress, >= 0.
double maximumShear(const StressTensor &stress);

} // namespace wheelrail
#endif
