// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/surface.h"

#include "contact/measured_file.h"

#include <algorithm>

namespace wheelrail {
namespace {

constexpr double mostCells = 1 << 26; ///< of a profile that travels; the rest of it is not used

/// One measured profile, from the file to the cells; every step leaves its statistics.
Eigen::VectorXd measuredRoughness(const SurfaceSpecification &specification,
                                  const std::string &name, const std::string &path, int cells,
                                  double cellSize, bool whole, Surface &surface)
{
  refuseTransverseProfile(path);
  Profile profile = readProfile(path);
  if (const std::string doubt = isolatedHeights(
          path, profile.height, "Interpolate or cut the profile where nothing was measured");
      !doubt.empty())
    surface.remarks.push_back(doubt);
  std::vector<ProfileStatistics> &statistics = surface.statistics;
  statistics.push_back(profileStatistics(name + ": as read", profile));
  profile = detrended(profile, specification.detrend);
  statistics.push_back(profileStatistics(name + ": detrended", profile));
  if (specification.cutoff > 0.0) {
    profile = lowPassed(profile, specification.cutoff, path);
    statistics.push_back(profileStatistics(name + ": filtered", profile, specification.cutoff));
  }
  const double usable = profile.length() - profile.spacing;
  const double most = std::min(usable / cellSize, mostCells);
  const int wanted = whole ? std::max(cells, static_cast<int>(most)) : cells;
  profile = resampled(profile, wanted, cellSize, path);
  statistics.push_back(profileStatistics(name + ": resampled", profile, specification.cutoff));
  return profile.height;
}

Surface generatedSurface(const SurfaceSpecification &specification, std::size_t index, int cells,
                         double cellSize)
{
  Surface surface;
  FractalSurface fractal = specification.fractal;
  surface.profile = fractal.seed = specification.seeds[index];
  const Profile profile = fractalProfile(fractal, cells, cells * cellSize);
  surface.statistics.push_back(
      profileStatistics("generated", profile, fractal.wavelengthMin, fractal.wavelengthMax));
  surface.roughness = profile.height;
  return surface;
}

/// The sum of rail and wheel, as long as the shorter one.
Surface measuredSurface(const SurfaceSpecification &specification, std::size_t index, int cells,
                        double cellSize, bool whole)
{
  Surface surface;
  surface.periodic = false;
  surface.profile = index + 1;
  for (const auto &[name, files] :
       {std::pair{"rail", &specification.rail}, {"wheel", &specification.wheel}}) {
    if (files->empty())
      continue;
    const Eigen::VectorXd height =
        measuredRoughness(specification, name, files->at(index), cells, cellSize, whole, surface);
    if (surface.roughness.size() == 0) {
      surface.roughness = height;
    } else {
      const auto common = std::min(surface.roughness.size(), height.size());
      surface.roughness = (surface.roughness.head(common) + height.head(common)).eval();
    }
  }
  const Profile sum{cellSize, surface.roughness};
  surface.statistics.push_back(profileStatistics("sum of both", sum, specification.cutoff));
  return surface;
}

} // namespace

std::size_t SurfaceSpecification::profiles() const
{
  return std::max({std::size_t{1}, seeds.size(), rail.size(), wheel.size()});
}

Surface prepareSurface(const SurfaceSpecification &specification, std::size_t index, int cells,
                       double cellSize, bool whole)
{
  switch (specification.kind) {
  case RoughnessKind::Fractal:
    return generatedSurface(specification, index, cells, cellSize);
  case RoughnessKind::Measured:
    return measuredSurface(specification, index, cells, cellSize, whole);
  default:
    return {};
  }
}

} // namespace wheelrail
