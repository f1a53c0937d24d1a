// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_SUBSURFACE_STRESS_H
#define WHEELRAIL_PATCH_SUBSURFACE_STRESS_H

#include "contact/patch/elasticity/cell_stress.h"
#include "contact/patch/elasticity/patch_half_space.h"

#include <array>

namespace wheelrail {

/// Stresses below the middles of all cells at one depth; as `StressComponent`, in the unit of the
/// pressure.
using StressField = std::array<Eigen::VectorXd, stressComponents>;

/// Stress in one body under what presses and shears its surface, exact for cells that are loaded
/// uniformly: products of Fourier transforms with the closed influence of a cell. One object has
/// one work buffer: use one per thread.
class SubsurfaceStress {
 public:
  /// \param nu of the body, 0 to 1/2
  SubsurfaceStress(const PatchGrid &grid, double nu);

  /// \param depth > 0, in the unit of the grid
  /// \param traction on this body: on the rail that on the wheel with the other sign
  /// Axes are x, y of the grid and z into the body: of the wheel a left-handed set.
  StressField at(double depth, const Eigen::VectorXd &pressure, const TangentialField &traction);

 private:
  void fillSpectra(double depth);

  PatchGrid grid_;
  double nu_;
  PlaneTransform transform_;
  std::array<std::array<Quarter, stressComponents>, 3> spectra_; ///< of pressure, x, y
};

/// The largest of a quantity over a plane, and where.
struct StressPeak {
  double value = 0.0; ///< in the unit of the stress
  double x = 0.0, y = 0.0;
};

/// What is asked of the stresses at one depth.
struct StressPeaks {
  StressPeak vonMises, maximumShear;
  StressPeak orthogonalShear; ///< of |zx|, along the way of rolling
};

/// \return the cells' middles count; unit of the stress and of the grid
StressPeaks stressPeaks(const PatchGrid &grid, const StressField &stress);

} // namespace wheelrail
#endif
