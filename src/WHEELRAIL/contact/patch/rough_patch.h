// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_ROUGH_PATCH_H
#define WHEELRAIL_ROUGH_PATCH_H

#include "contact/line/surface.h"
#include "contact/patch/height_map_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

/// How far material has travelled, m: what lies at x now was at x + x of this (towards smaller x
/// is along the way), and the same across.
struct Travel {
  double x = 0.0, y = 0.0;
};

/// Heights of one body on the cells of a contact, and of what else travels through it: cell (0, 0)
/// of the contact's box is cell (firstX, firstY) of the map at the start. Heights are positive
/// outwards from the body, m.
struct RoughMap {
  int nx = 0, ny = 0; ///< 0: smooth
  int firstX = 0, firstY = 0;
  bool periodic = true;
  Eigen::VectorXd height;

  bool isSmooth() const { return nx == 0; }

  /// The box's heights after a way. Between cells Lagrange's polynomial through six of them in
  /// each direction: of a wave of eight cells it keeps 0.1 %.
  /// @throws Error (BadInput) when the way leads out of a map that is not periodic
  Eigen::VectorXd window(const PatchGrid &box, const Travel &travel) const;
};

/// A self-affine random surface: the power spectrum of its two-dimensional heights falls as
/// q^-(2 + 2 H), q^2 = (anisotropy kx)^2 + ky^2, between two wavelengths (across the rolling
/// direction; along it they are `anisotropy` times as long: grooves along x where it is large).
struct FractalPatch {
  double hurst = 0.8;
  double rmsSlope = 0.0;  ///< of the gradient (Sdq of ISO 25178), or
  double rmsHeight = 0.0; ///< m (Sq); one of both is > 0
  double wavelengthMin = 0.0, wavelengthMax = 0.0; ///< m
  double anisotropy = 1.0;
  /// The map's period along x in lengths of the box; 0: 1, and enough for the travel.
  int boxes = 0;
};

/// The surfaces of both bodies.
struct RoughPatchSpecification {
  RoughnessKind kind = RoughnessKind::None;
  FractalPatch fractal;
  std::vector<std::uint64_t> seeds;     ///< Fractal: one surface each
  std::vector<std::string> rail, wheel; ///< Measured: files; one list may be empty
  HeightMapPreparation railMap, wheelMap; ///< Measured: the scale is that of npy files

  std::size_t surfaces() const;
  const char *surfaceName() const { return kind == RoughnessKind::Fractal ? "seed" : "surface"; }
};

/// Both surfaces of one contact.
struct RoughPatch {
  std::uint64_t number = 0; ///< seed, or number of the pair of maps from 1 on; 0: smooth
  RoughMap wheel, rail;
  double shortestWave = 0.0; ///< m; 0: not known
  std::vector<HeightMapStatistics> statistics; ///< after every step of the preparation
  std::vector<std::string> remarks; ///< what was done to the maps that a user must know
};

/// Fewest cells to the shortest wave: below the first it is refused, below the second warned of.
constexpr double fewestCellsPerWave = 4.0, advisedCellsPerWave = 8.0;

/// @param index of the surface, below surfaces()
/// @param travel m, how far the material will move
/// @throws Error (BadInput) for maps that cannot be read or do not fit, waves that the cells cannot
///         carry
RoughPatch prepareRoughPatch(const RoughPatchSpecification &specification, std::size_t index,
                             const PatchGrid &box, double travel);

/// Wheel and rail of a generated surface. Each wave belongs to one of the bodies, by lot, so that
/// their sum is the surface of the seed, whichever way each of them travels. The seed alone decides
/// phases and lots, wave by wave: another number of cells samples the same surface.
/// @throws Error (BadInput) when no wave fits into the box, or the cells cannot carry the shortest
RoughPatch fractalPatch(const FractalPatch &fractal, std::uint64_t seed, const PatchGrid &box,
                        double travel);

} // namespace wheelrail
#endif
