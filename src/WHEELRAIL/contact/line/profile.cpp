// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/profile.h"

#include "base/errors.h"
#include "base/number_rows.h"
#include "base/quantity.h"
#include "base/random_number.h"
#include "base/text_lines.h"
#include "shared/pi.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

using mcawr::pi;
constexpr int fewestPoints = 16;
constexpr double fewestCellsPerWave = 4.0;
constexpr double largestPlace = 1e3;      ///< of heights and positions, m
constexpr double smallestSpacing = 1e-12; ///< of points, m

/// Units of a profile file: metres per unit of a column, and the spacing if it is stated.
struct ProfileHeader {
  double heightUnit = 0.0, positionUnit = 0.0, spacing = 0.0;
};

/// "# keyword: value"; other comments are free text.
/// \param isHead no numbers have been read yet
void readHeaderLine(std::string_view line, const std::string &path, int number, bool isHead,
                    ProfileHeader &header)
{
  const auto colon = line.find(':');
  if (colon == std::string_view::npos)
    return;
  const std::string keyword(trimmedView(line.substr(1, colon - 1)));
  const std::string value(trimmedView(line.substr(colon + 1)));
  double *target = keyword == "height"     ? &header.heightUnit
                   : keyword == "position" ? &header.positionUnit
                   : keyword == "spacing"  ? &header.spacing
                                           : nullptr;
  if (!target)
    return;
  if (!isHead || *target != 0.0)
    throw badInput(path, number, keyword, "is given once, before the numbers");
  try {
    *target = parseQuantity(target == &header.spacing ? value : "1 " + value, "m");
  } catch (const std::invalid_argument &problem) {
    throw badInput(path, number, keyword, problem.what());
  }
  if (target == &header.spacing && !(*target >= smallestSpacing && *target <= largestPlace))
    throw badInput(path, number, keyword,
                   fmt::format("'{}' is not in the allowed range [{}, {}] m", value,
                               smallestSpacing, largestPlace));
}

/// A height or a position in m, within what a profile may hold.
double inMetres(double value, double unit, const std::string &path, int number, const char *keyword)
{
  if (!(std::abs(value * unit) <= largestPlace))
    throw badInput(path, number, keyword,
                   fmt::format("{} is not allowed, must be within +-{} m", value, largestPlace));
  return value * unit;
}

/// Value at `place` (in points) on the straight lines between points.
double interpolated(const Vector &height, double place)
{
  const double last = static_cast<double>(height.size() - 1);
  const double inside = std::clamp(place, 0.0, last);
  const int left = std::min(static_cast<int>(inside), static_cast<int>(height.size()) - 2);
  const double part = inside - left;
  return (1.0 - part) * height[left] + part * height[left + 1];
}

Profile equallySpaced(const std::vector<double> &position, const std::vector<double> &height)
{
  const int n = static_cast<int>(position.size());
  Profile profile;
  profile.spacing = (position.back() - position.front()) / (n - 1);
  profile.height.resize(n);
  std::size_t next = 1;
  for (int i = 0; i < n; ++i) {
    const double x = position.front() + i * profile.spacing;
    while (next + 1 < position.size() && position[next] < x)
      ++next;
    const double part = (x - position[next - 1]) / (position[next] - position[next - 1]);
    profile.height[i] = height[next - 1] + part * (height[next] - height[next - 1]);
  }
  return profile;
}

} // namespace

ProfileStatistics profileStatistics(const std::string &step, const Profile &profile,
                                    double shortest, double longest)
{
  const Vector &z = profile.height;
  const double mean = z.mean();
  const double rmsHeight = std::sqrt((z.array() - mean).square().mean());
  const int n = static_cast<int>(z.size());
  const Vector slope = (z.tail(n - 1) - z.head(n - 1)) / profile.spacing;
  const double rmsSlope = std::sqrt(slope.squaredNorm() / (n - 1));
  return {step,
          rmsHeight,
          rmsSlope,
          rmsSlope > 0.0 ? 2.0 * pi * rmsHeight / rmsSlope : 0.0,
          std::max(shortest, 2.0 * profile.spacing),
          longest > 0.0 ? longest : profile.length()};
}

Profile readProfile(const std::string &path)
{
  const std::string text = readTextFile(path);
  LineReader lines(text);
  NumberRows row(path);
  ProfileHeader header;
  std::vector<double> first, second, values;
  std::size_t columns = 0;
  for (std::string_view raw; lines.next(raw);) {
    const int number = lines.number();
    const std::string_view line = trimmedView(raw);
    if (line.empty())
      continue;
    if (line[0] == '#') {
      readHeaderLine(line, path, number, columns == 0, header);
      continue;
    }
    if (columns == 0 && header.spacing > 0.0 && header.positionUnit == 0.0)
      row.expectOneColumn();
    values.clear();
    row.append(number, raw, false, values);
    if (columns == 0) {
      columns = values.size();
      if (header.heightUnit == 0.0)
        throw badInput(path, number, "height", "no line '# height: UNIT' before the numbers");
      if (columns == 1 && header.spacing == 0.0)
        throw badInput(path, number, "spacing",
                       "one column of heights needs a line '# spacing: NUMBER UNIT'");
      if (columns == 2 && header.positionUnit == 0.0)
        throw badInput(path, number, "position", "two columns need a line '# position: UNIT'");
    }
    if (values.size() != columns || columns > 2)
      throw badInput(path, number, "",
                     fmt::format("{} columns; one (height) or two (position, height) are allowed, "
                                 "the same in every line{}",
                                 values.size(), row.decimalHint()));
    if (columns == 2) {
      const double x = inMetres(values[0], header.positionUnit, path, number, "position");
      if (!first.empty() && x < first.back() + smallestSpacing)
        throw badInput(
            path, number, "position",
            fmt::format("{} does not increase by {} m or more", values[0], smallestSpacing));
      first.push_back(x);
    }
    second.push_back(inMetres(values.back(), header.heightUnit, path, number, "height"));
  }
  if (static_cast<int>(second.size()) < fewestPoints)
    throw badInput(path, 0, "",
                   fmt::format("{} points; at least {} are needed", second.size(), fewestPoints));
  if (columns == 2)
    return equallySpaced(first, second);
  return {header.spacing, Eigen::Map<Vector>(second.data(), static_cast<int>(second.size()))};
}

Profile detrended(const Profile &profile, int order)
{
  if (order < 0)
    return profile;
  const int n = static_cast<int>(profile.height.size());
  Eigen::MatrixXd basis(n, order + 1);
  for (int i = 0; i < n; ++i) // on -1 .. 1, where powers are well conditioned
    for (int power = 0; power <= order; ++power)
      basis(i, power) = std::pow(2.0 * i / (n - 1) - 1.0, power);
  const Vector c = basis.householderQr().solve(profile.height);
  return {profile.spacing, profile.height - basis * c};
}

Profile lowPassed(const Profile &profile, double cutoff, const std::string &path)
{
  if (cutoff < 2.0 * profile.spacing || cutoff > profile.length())
    throw badInput(path, 0, "roughness.cutoff",
                   fmt::format("{:.5g} mm must lie between two points of the profile, {:.5g} mm, "
                               "and its length, {:.5g} mm",
                               cutoff * 1e3, 2e3 * profile.spacing, profile.length() * 1e3));
  const double alpha = std::sqrt(std::log(2.0) / pi); // ISO 16610-21
  const double width = alpha * cutoff / profile.spacing;
  const int reach = static_cast<int>(std::ceil(2.0 * width)); // the weight is 3e-6 there
  const int n = static_cast<int>(profile.height.size());
  Vector weight(reach + 1);
  for (int m = 0; m <= reach; ++m)
    weight[m] = std::exp(-pi * std::pow(m / width, 2));
  Profile smooth{profile.spacing, Vector(n)};
  for (int i = 0; i < n; ++i) {
    double sum = 0.0, weights = 0.0;
    for (int j = std::max(0, i - reach); j <= std::min(n - 1, i + reach); ++j) {
      sum += weight[std::abs(i - j)] * profile.height[j];
      weights += weight[std::abs(i - j)];
    }
    smooth.height[i] = sum / weights;
  }
  return smooth;
}

Profile resampled(const Profile &profile, int cells, double cellSize, const std::string &path)
{
  const double points = static_cast<double>(profile.height.size() - 1);
  const double wanted = cells * cellSize / profile.spacing;
  if (wanted > points * (1.0 + 1e-12))
    throw badInput(path, 0, "",
                   fmt::format("the profile, {:.5g} mm, is shorter than the stretch that is "
                               "computed, {:.5g} mm (contact.domain, or contact.period)",
                               points * profile.spacing * 1e3, cells * cellSize * 1e3));
  const double begin = 0.5 * (points - wanted), step = cellSize / profile.spacing;
  const int samples = std::max(4, static_cast<int>(std::ceil(4.0 * step))); // midpoints in a cell
  Profile result{cellSize, Vector(cells)};
  for (int i = 0; i < cells; ++i) {
    double sum = 0.0;
    for (int k = 0; k < samples; ++k)
      sum += interpolated(profile.height, begin + step * (i + (k + 0.5) / samples));
    result.height[i] = sum / samples;
  }
  return result;
}

Profile fractalProfile(const FractalSurface &surface, int cells, double length)
{
  const double fewestWaves = std::ceil(length / surface.wavelengthMax * (1.0 - 1e-12));
  const double mostWaves = std::floor(length / surface.wavelengthMin * (1.0 + 1e-12));
  if (fewestWaves > mostWaves)
    throw Error(ExitCode::BadInput,
                fmt::format("roughness: no wave between {:.5g} and {:.5g} mm has a whole number "
                            "of periods in {:.5g} mm",
                            surface.wavelengthMin * 1e3, surface.wavelengthMax * 1e3,
                            length * 1e3));
  if (cells < fewestCellsPerWave * mostWaves)
    throw Error(ExitCode::BadInput,
                fmt::format("cells: {} cells on {:.5g} mm cannot carry waves of {:.5g} mm; at "
                            "least {:.0f} are needed, ten to a wave are better",
                            cells, length * 1e3, surface.wavelengthMin * 1e3,
                            fewestCellsPerWave * mostWaves));
  const int longest = static_cast<int>(fewestWaves), shortest = static_cast<int>(mostWaves);
  double squares = 0.0; // of what the amplitude is scaled by: mean square of slope or height
  std::vector<double> amplitude(shortest + 1, 0.0);
  for (int k = std::max(1, longest); k <= shortest; ++k) {
    amplitude[k] = std::pow(k, -(surface.hurst + 0.5));
    const double wave = surface.rmsSlope > 0.0 ? 2.0 * pi * k / length : 1.0;
    squares += 0.5 * std::pow(amplitude[k] * wave, 2);
  }
  const double wanted = surface.rmsSlope > 0.0 ? surface.rmsSlope : surface.rmsHeight;
  const double scale = wanted / std::sqrt(squares);

  Profile profile{length / cells, Vector::Zero(cells)};
  for (int k = std::max(1, longest); k <= shortest; ++k) {
    const double phase = 2.0 * pi * uniformNumber(surface.seed, static_cast<std::uint64_t>(k));
    const double step = 2.0 * pi * k / cells;
    for (int i = 0; i < cells; ++i)
      profile.height[i] += scale * amplitude[k] * std::cos(step * (i + 0.5) + phase);
  }
  return profile;
}

} // namespace wheelrail
