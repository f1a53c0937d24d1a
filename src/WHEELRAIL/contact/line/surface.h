// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_SURFACE_H
#define WHEELRAIL_CONTACT_LINE_SURFACE_H

#include "contact/line/profile.h"
#include "contact/roughness_kind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

/// The rough surfaces of a line contact: generated profiles, one for each seed, or measured ones.
struct SurfaceSpecification {
  RoughnessKind kind = RoughnessKind::None;
  FractalSurface fractal;               ///< Fractal; its seed is replaced by each of `seeds`
  std::vector<std::uint64_t> seeds;     ///< Fractal: one profile each, at least one
  std::vector<std::string> rail, wheel; ///< Measured: files, one profile each; one list may be
                                        ///< empty, otherwise both are of the same length
  double cutoff = 0.0;                  ///< Measured: shorter waves are filtered out, m; 0: none
  int detrend = 1;                      ///< Measured: order of the polynomial taken off; -1: none

  std::size_t profiles() const; ///< number of profiles, >= 1
  /// What tells profiles apart: "seed" of generated ones, else "profile" (their number from 1 on).
  const char *profileName() const { return kind == RoughnessKind::Fractal ? "seed" : "profile"; }
};

/// One profile on the cells of a contact.
struct Surface {
  std::uint64_t profile = 0; ///< seed, or number of the measured profile from 1 on; 0: smooth
  /// Roughness to be taken off the gap, m. One value per cell; more where the material travels and
  /// the profile is measured. Empty: smooth.
  Eigen::VectorXd roughness;
  bool periodic = true;                      ///< the roughness goes on with its beginning
  std::vector<ProfileStatistics> statistics; ///< after every step of the preparation
  std::vector<std::string> remarks;          ///< lines for the user: `isolatedHeights`
};

/// \param index of the profile, below profiles()
/// \param cells number of cells, >= 1, of cellSize (m, > 0)
/// \param whole keep all of a measured profile, for material that travels through the contact
/// \throws Error (BadInput) for profiles that cannot be read or do not fit
Surface prepareSurface(const SurfaceSpecification &specification, std::size_t index, int cells,
                       double cellSize, bool whole);

} // namespace wheelrail
#endif
