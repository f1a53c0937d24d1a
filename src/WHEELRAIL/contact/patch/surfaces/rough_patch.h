// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_ROUGH_PATCH_H
#define WHEELRAIL_ROUGH_PATCH_H

#include "contact/patch/surfaces/height_map_preparation.h"
#include "contact/patch/surfaces/patch_surface.h"
#include "contact/roughness_kind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

/// How far the material of one body has travelled: what lies at (x, y) now is the map's at
/// (x + this x + y turn, y + this y - aside), to first order in the creepages.
/// Both surfaces of a rolling contact travel by nearly the same way along x. Spin turns them about
/// the origin while they are in the box, against each other: the angle and the way aside belong to
/// the material of a column and move on with it. What comes in at the leading border has neither,
/// so that nothing piles up from one length of the contact to the next, and a wheel's or a rail's
/// lay stays along the way.
struct Travel {
  double x = 0.0, y = 0.0; ///< m; towards smaller x is along the way
  Eigen::VectorXd turn;    ///< rad, per column of the box; empty: nothing turns
  Eigen::VectorXd aside;   ///< m towards larger y, per column; as long as `turn`

  /// One more step of a cell, with the velocity (-wayX - turning dx y, -wayY + turning dx x).
  /// \param wayX, wayY of the step, m
  /// \param turning this body's share of the spin, 1/m: the angle by which it turns (from x to y)
  ///        over the distance rolled
  void roll(const PatchGrid &box, double wayX, double wayY, double turning);
};

/// Heights of one body on the cells of a contact, and of what else travels through it: cell (0, 0)
/// of the contact's box is cell (firstX, firstY) of the map at the start. Heights are positive
/// outwards from the body, m.
/// Larger than the box where the material travels; a map that is not periodic must hold the whole
/// way.
struct RoughMap {
  int nx = 0, ny = 0; ///< 0: smooth
  int firstX = 0, firstY = 0;
  bool periodic = true;
  Eigen::VectorXd height;

  /// No heights at all.
  bool isSmooth() const { return nx == 0; }

  /// The box's heights after a way. Between cells Lagrange's polynomial through six of them in
  /// each direction: waves of eight cells come out at most 0.1 % too low.
  /// \throws Error (BadInput) when the way leads out of a map that is not periodic
  /// \param travel whole cells without a turn are exact
  /// \return one height for each cell of the box, m
  Eigen::VectorXd window(const PatchGrid &box, const Travel &travel) const;

 private:
  Eigen::VectorXd straightWindow(const PatchGrid &box, const Travel &travel) const;
  /// Every cell at a place of its own.
  Eigen::VectorXd turnedWindow(const PatchGrid &box, const Travel &travel) const;
};

/// The surfaces of both bodies.
struct RoughPatchSpecification {
  RoughnessKind kind = RoughnessKind::None;
  FractalPatch fractal; ///< of both bodies together; seed and periods are set for each surface
  std::vector<std::uint64_t> seeds; ///< Fractal: one surface each
  /// Fractal: the period along x in lengths of the box; 0: 1, and enough for the travel.
  int boxes = 0;
  std::vector<std::string> rail, wheel;   ///< Measured: files; one list may be empty
  HeightMapPreparation railMap, wheelMap; ///< Measured: how the maps are prepared

  /// Number of seeds or of pairs of maps; 1 where the contact is smooth.
  std::size_t surfaces() const;
  const char *surfaceName() const { return kind == RoughnessKind::Fractal ? "seed" : "surface"; }
};

/// Both surfaces of one contact.
struct RoughPatch {
  std::uint64_t number = 0; ///< seed, or number of the pair of maps from 1 on; 0: smooth
  RoughMap wheel, rail;
  double shortestWave = 0.0;                   ///< m; 0: not known
  std::vector<HeightMapStatistics> statistics; ///< after every step of the preparation
  std::vector<std::string> remarks;            ///< what was done to the maps that a user must know
};

/// Cells to the shortest wave; fewer are warned of.
/// Eight leave an error of about 5 % in the slope with frozen, 0.5 % with moving roughness.
constexpr double advisedCellsPerWave = 8.0;

/// Generated surfaces: each body has one of its own, of the same statistics and with 1/sqrt(2) of
/// the slope and height, from numbers that the seed decides; they repeat with the height of the box
/// and a whole number of its lengths.
/// \param index of the surface, below surfaces()
/// \param travel m, how far the material will move
/// \throws Error (BadInput) for maps that cannot be read or do not fit, waves that the cells cannot
///         carry
/// \param box cells and lengths in m
RoughPatch prepareRoughPatch(const RoughPatchSpecification &specification, std::size_t index,
                             const PatchGrid &box, double travel);

} // namespace wheelrail
#endif
