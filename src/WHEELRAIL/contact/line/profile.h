// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_PROFILE_H
#define WHEELRAIL_CONTACT_LINE_PROFILE_H

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

/// Heights of a surface along the rolling direction at equal spacing; SI units (m), positive
/// outwards from the body.
struct Profile {
  double spacing = 0.0; ///< m, > 0
  Eigen::VectorXd height;

  double length() const { return spacing * static_cast<double>(height.size()); }
};

/// What a step of preparation left, printed after each of them.
struct ProfileStatistics {
  std::string step;          ///< such as "rail: as read"
  double rmsHeight;          ///< about the mean, m
  double rmsSlope;           ///< of neighbouring points
  double meanWavelength;     ///< 2 pi rmsHeight/rmsSlope, m
  double shortestWavelength; ///< that the points can carry, or the cut-off if longer, m
  double longestWavelength;  ///< m
};

/// \param shortest cut-off applied so far, 0: none
/// \param longest wavelength put in, 0: the length
ProfileStatistics profileStatistics(const std::string &step, const Profile &profile,
                                    double shortest = 0.0, double longest = 0.0);

/// A measured profile as text or CSV. Header lines begin with '#' and state the units:
///   # height: um                 and either
///   # spacing: 5 um              (then one column: heights), or
///   # position: mm               (then two columns: position, height; increasing positions)
/// Columns are separated as `NumberRows` reads them. Unequal positions are interpolated to equal
/// ones of the same number.
/// \throws Error (BadInput) with file and line: units that are missing, wrong or given twice, text
///         or nothing where a number is expected, nan, inf, a number beyond 1000 m, a wrong number
///         of columns, positions that do not increase, fewer than 16 points
Profile readProfile(const std::string &path);

/// Takes off the least-squares polynomial of this order: 0 mean, 1 line, 2 parabola (the form of
/// the wheel); anything below 0 leaves the profile alone.
Profile detrended(const Profile &profile, int order);

/// Takes out wavelengths below the cut-off with the Gaussian filter of ISO 16610-21 (half of the
/// amplitude is left at the cut-off); near the ends the weights are normalised again.
/// \param path of the profile, for messages
/// \throws Error (BadInput) for a cut-off below two points or above the length
Profile lowPassed(const Profile &profile, double cutoff, const std::string &path);

/// The middle part of the profile on `cells` cells of size `cellSize`: the mean over each cell of
/// the straight lines between points.
/// \param path of the profile, for messages
/// \throws Error (BadInput) when the profile is shorter than the cells
Profile resampled(const Profile &profile, int cells, double cellSize, const std::string &path);

/// A self-affine random profile: the power spectrum falls as k^-(1 + 2 H) between the two
/// wavelengths, phases are random.
struct FractalSurface {
  double hurst = 0.8;
  double rmsSlope = 0.0;  ///< one of rmsSlope and rmsHeight is > 0 and decides the amplitude
  double rmsHeight = 0.0; ///< m
  double wavelengthMin = 0.0, wavelengthMax = 0.0; ///< m
  std::uint64_t seed = 1;
};

/// One period of `length` on `cells` cells: waves with a whole number of periods in it. The seed
/// alone decides phases, wave by wave from the longest: another number of cells samples the same
/// profile, a smaller wavelengthMin adds to it.
/// \throws Error (BadInput) when no wave fits, or the cells cannot carry the shortest (4 a wave)
Profile fractalProfile(const FractalSurface &surface, int cells, double length);

} // namespace wheelrail
#endif
