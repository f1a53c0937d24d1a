// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_LAW_USE_H
#define WHEELRAIL_LAW_LAW_USE_H

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

using Range = std::array<double, 2>; ///< least and largest value

/// One of the quantities that a law is a function of.
struct LawInput {
  std::string key;            ///< of summary.json, with its unit: "pressure_MPa"
  std::string words;          ///< of a warning: "pressure in MPa"
  std::optional<Range> known; ///< where the law is known, in that unit; absent: not stated
};

/// Where contacts ask a law for mu: least and largest values over the cells in contact, one range
/// for each of the law's inputs, in their order and units. Empty: nothing was asked, or the law has
/// no inputs.
struct LawUse {
  std::vector<Range> ranges;

  /// Widens the ranges by those of another contact under the same law.
  void include(const LawUse &other);
};

/// Least and largest value, but for the half per cent of the load under the smallest values and
/// that under the largest: so the edges of a contact, where the pressure falls to 0, do not count.
/// \param value, load one for each cell in contact, at least one; load > 0
Range loadedRange(const std::vector<double> &value, const std::vector<double> &load);

/// Share of the load that `loadedRange` leaves out at either end.
constexpr double leftOutLoad = 0.005;

/// The inputs whose known range is passed, with both ranges, for a warning:
/// "kappa1 0 (0.2 to 19), kappa2 44 to 620 (2 to 300)"; empty: none is.
/// \param tolerance share of a limit by which it may be passed
std::string outsideOf(const std::vector<LawInput> &inputs, const LawUse &use, double tolerance);

/// The warning of a fitted law that is used a tenth beyond the limits of what it was fitted on;
/// empty: it is not.
/// \param name of the law, as the case has it
std::string fitWarning(const std::string &name, const std::vector<LawInput> &inputs,
                       const LawUse &use);

} // namespace wheelrail
#endif
