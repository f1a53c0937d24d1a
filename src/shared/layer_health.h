// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_LAYER_HEALTH_H
#define MCAWR_SHARED_LAYER_HEALTH_H

/// When a sliding layer is no solid any more, or too narrow for its load: the bounds that the
/// plugin, while it runs, and wr_fit, from the log, warn by. doc/friction_log.md says what they
/// mean.
namespace mcawr::layer_health {

/// A layer may shrink by this beyond its elastic compression p/K: what plasticity isochoric, which
/// keeps the volume, stays within at every pressure that it was tested at (1.9 %).
constexpr double sinkAllowance = 0.03;

/// Least room (friction_log::Row::room) of a layer that is a solid: 1 - p/K - sinkAllowance.
/// \param pressure, bulkModulus  of one unit; p >= 0, K > 0
/// \return pure number, at most 1 - sinkAllowance
constexpr double leastRoom(double pressure, double bulkModulus)
{
  return 1.0 - pressure / bulkModulus - sinkAllowance;
}

/// What flow, breaking and unlinked contacts dissipate never falls; by this share of the work done
/// it may, since contacts that touch or part within a step find up to 3e-4 of it too much or too
/// little.
constexpr double fallAllowance = 1e-3;

/// Junctions, contacts pressed to the linking pressure, that should carry the load: with fewer mu
/// scatters, and in fragments of less than 160 automata in a layer it was 46 % smaller to 25 %
/// larger than in those of 320 (doc/how_chosen.md, The width).
constexpr double leastJunctions = 10.0;

/// Junctions that carry a load at once, p A/(sigma_link a) of automata of the area a.
/// \param pressure, linkPressure  of one unit; p >= 0, sigma_link > 0, infinite where nothing links
/// \param places  automata side by side that the fragment has room for: W/d in the plane, A/d^2 in
///                space
constexpr double junctions(double pressure, double linkPressure, double places)
{
  return places * pressure / linkPressure;
}

/// Share of the way worn smooth beyond which a warning is given.
constexpr double smoothLimit = 0.05;

/// How much of its way a layer slid without a link broken: phases count in which it slid by an
/// automaton's diameter at least.
class SmoothSliding {
 public:
  /// \param way     slid since the row before, >= 0 [length]
  /// \param broken  links that broke meanwhile
  /// \param diameter  of an automaton [length], the same in all calls
  void add(double way, double broken, double diameter)
  {
    way_ += way;
    const double before = phase_ >= diameter ? phase_ : 0.0; // counted already
    phase_ = broken == 0.0 ? phase_ + way : 0.0;
    smooth_ += phase_ >= diameter ? phase_ - before : 0.0;
  }
  double way() const { return way_; } ///< in all [length]
  /// Share of it that was smooth [-]; 0 before anything slid.
  double share() const { return way_ > 0.0 ? smooth_ / way_ : 0.0; }

 private:
  double way_ = 0.0, phase_ = 0.0, smooth_ = 0.0;
};

} // namespace mcawr::layer_health

#endif
