// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact/line/contact_interval.h"

#include "contact/edge_share.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr int shortestFitted = 30;     // cells
constexpr double trustedMisfit = 2e-4; // rough intervals are no polynomials

/// How far inside the outer face of the edge cell p^2 vanishes, in cells: zero of a cubic fitted
/// to p^2. The fit leaves out the cells next to the edge, whose pressure depends on where in them
/// the edge lies (by 20 % in the first, 2 % in the second, 0.1 % in the third); a longer interval
/// can afford to leave out more.
std::optional<double> fittedInset(const Vector &pressure, int edge, int inward, int cells)
{
  if (cells < shortestFitted)
    return std::nullopt;
  const int skipped = 2 + cells / 50, used = 8 + cells / 50;
  constexpr int order = 3;
  Eigen::MatrixXd basis(used, order + 1);
  Vector squares(used);
  for (int k = 0; k < used; ++k) {
    const int cell = skipped + k; // counted from the edge
    for (int power = 0; power <= order; ++power)
      basis(k, power) = std::pow(cell, power);
    squares[k] = std::pow(pressure[edge + inward * cell], 2);
  }
  const Vector c = basis.householderQr().solve(squares);
  if ((basis * c - squares).norm() > trustedMisfit * squares.norm())
    return std::nullopt;
  double t = 0.0; // Newton from the edge cell's centre
  for (int step = 0; step < 8; ++step) {
    const double slope = c[1] + t * (2.0 * c[2] + 3.0 * c[3] * t);
    if (!(slope > 0.0))
      return std::nullopt; // not an edge with a square root
    t -= (c[0] + t * (c[1] + t * (c[2] + t * c[3]))) / slope;
  }
  return std::clamp(t + 0.5, -0.5, 0.9);
}

/// Inset from the pressure of the edge cell and the gap of its neighbour.
double localInset(double pressure, double gap)
{
  constexpr double farthest = 0.49; // some of the cell stays
  return std::min(shareApart(pressure, gap) - 0.5, farthest);
}

} // namespace

std::vector<ContactInterval> contactIntervals(const NormalContactResult &contact, Boundary boundary)
{
  const Vector &pressure = contact.pressure;
  const int n = static_cast<int>(pressure.size());
  const auto inset = [&](int edge, int inward, int cells) {
    // 0, the cell's outer face, where nothing is known of the edge: at the end of the line, at a
    // periodic line without a gap, at the pressure limit.
    int outside = edge - inward;
    if (boundary == Boundary::Periodic)
      outside = (outside + n) % n;
    if (outside < 0 || outside >= n || pressure[outside] > 0.0 ||
        contact.state[edge] == CellState::Plastic)
      return 0.0;
    const auto fitted = fittedInset(pressure, edge, inward, cells);
    return fitted ? *fitted : localInset(pressure[edge], contact.gap[outside]);
  };
  std::vector<ContactInterval> intervals;
  for (int i = 0; i < n; ++i) {
    if (!(pressure[i] > 0.0))
      continue;
    const int first = i;
    while (i + 1 < n && pressure[i + 1] > 0.0)
      ++i;
    const int cells = i - first + 1;
    intervals.push_back(
        {first, i, first - 0.5 + inset(first, 1, cells), i + 0.5 - inset(i, -1, cells)});
  }
  return intervals;
}

double contactLength(const std::vector<ContactInterval> &intervals)
{
  double sum = 0.0;
  for (const ContactInterval &interval : intervals)
    sum += interval.length();
  return sum;
}

} // namespace wheelrail
