// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_SURFACE_H
#define WHEELRAIL_PATCH_SURFACE_H

#include "contact/patch/elasticity/grid.h"

#include <cstdint>

namespace wheelrail {

/// A self-affine random surface in two dimensions: a sum of waves with random phases whose power
/// spectrum falls as k^-2(1 + H) between two wavelengths.
struct FractalPatch {
  /// H, 0 to 1: the larger, the smoother the surface looks at short wavelengths.
  double hurst = 0.8;
  double rmsSlope = 0.0;  ///< root mean square of the gradient's length; one of rmsSlope and
  double rmsHeight = 0.0; ///< rmsHeight (length) is > 0 and decides the amplitude
  double wavelengthMin = 0.0, wavelengthMax = 0.0; ///< length
  /// How many times longer features are along x than along y, at the same area (1: isotropic).
  /// The wavelengths' limits hold for the isotropic surface that is stretched so.
  double stretch = 1.0;
  double periodX = 0.0, periodY = 0.0; ///< the surface repeats with these lengths, > 0
  /// Alone decides the phases; surfaces of different seeds are independent.
  std::uint64_t seed = 1;
};

/// The waves of a FractalPatch. Phase and amplitude of each depend on (seed, wave) only: any grid,
/// at any place, samples the same surface, and a surface that has moved by any distance is exact.
/// Random numbers are counted, not drawn in turn, so that a phase depends on no other wave.
class FractalHeights {
 public:
  /// \throws Error (BadInput) when no wave with a whole number of periods lies between the
  ///         wavelengths, or neither or both of rmsSlope and rmsHeight are given
  /// \param surface periods and wavelengths in one unit, > 0; heights come in the same unit
  explicit FractalHeights(const FractalPatch &surface);

  /// Heights at the cells' centres, moved: those of the surface at (x + travelled, y).
  /// \throws Error (BadInput) for cells too long for the shortest wave, four a wave
  Eigen::VectorXd sampled(const PatchGrid &grid, double travelled = 0.0) const;

  /// Measures of the surface after scaling; one of the two is the value that was asked for.
  double rmsHeight() const { return rmsHeight_; }
  double rmsSlope() const { return rmsSlope_; }
  /// Number of the waves between the two wavelengths.
  int waves() const { return waves_; }

 private:
  double unitX_, unitY_;    ///< lowest wave numbers, 2 pi/period
  int highestX_, highestY_; ///< number of the highest waves
  double rmsHeight_ = 0.0, rmsSlope_ = 0.0;
  int waves_ = 0;
  /// Complex amplitude of wave (m, n) at (m + highestX, n); n >= 0 (the others are conjugates).
  Eigen::MatrixXcd amplitude_;
};

} // namespace wheelrail
#endif
