// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/measured_file.h"

#include "base/errors.h"
#include "base/file_ending.h"
#include "base/si.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {
namespace {

struct TransverseFormat {
  const char *ending, *what;
};
constexpr TransverseFormat transverseFormats[] = {
    {".prr", "of a rail (SIMPACK)"},
    {".prw", "of a wheel (SIMPACK)"},
    {".ban", "of a rail (MiniProf)"},
    {".whl", "of a wheel (MiniProf)"},
    {".slcs", "of a rail, slice by slice (CONTACT)"},
};

/// One end of the heights: its value, how many have it, and the next one towards the others.
struct Extreme {
  double value, next;
  long count = 0;
};

/// \param sign 1: the smallest, -1: the largest
Extreme extremeOf(const Eigen::VectorXd &heights, double sign)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Extreme found{infinity, infinity};
  for (const double height : heights) {
    const double h = sign * height; // NaN compares false
    if (h < found.value) {
      found.next = found.value;
      found.value = h;
      found.count = 1;
    } else if (h == found.value) {
      ++found.count;
    } else if (h < found.next) {
      found.next = h;
    }
  }
  found.value *= sign;
  found.next *= sign;
  return found;
}

} // namespace

void refuseTransverseProfile(const std::string &path)
{
  const std::string ending = fileEnding(path);
  for (const TransverseFormat &format : transverseFormats)
    if (ending == format.ending)
      throw badInput(
          path, 0, "",
          fmt::format("{} is a transverse profile {}: a shape, not roughness. Its radius "
                      "goes into contact.radii; roughness needs heights along the "
                      "rolling direction",
                      format.ending, format.what));
}

std::string isolatedHeights(const std::string &path, const Eigen::VectorXd &heights,
                            const char *advice)
{
  constexpr double farForOne = 10.0;
  const Extreme low = extremeOf(heights, 1.0), high = extremeOf(heights, -1.0);
  const double others = high.next - low.next; // range of what is neither
  if (!(others > 0.0) || !std::isfinite(others))
    return "";
  for (const Extreme &end : {low, high}) {
    const double gap = std::abs(end.next - end.value);
    if (gap > (end.count > 1 ? 1.0 : farForOne) * others)
      return fmt::format("roughness: {}: {} of the heights {} {:.6g} um, {:.4g} um away from all "
                         "others, which span {:.4g} um. {}",
                         path, end.count, end.count > 1 ? "are" : "is", end.value / um, gap / um,
                         others / um, advice);
  }
  return "";
}

} // namespace wheelrail
