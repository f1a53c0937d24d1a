// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_CONTACT_INTERVAL_H
#define WHEELRAIL_CONTACT_LINE_CONTACT_INTERVAL_H

#include "contact/line/halfplane.h"
#include "contact/normal_contact.h"

#include <vector>

namespace wheelrail {

/// One stretch of neighbouring cells in contact.
struct ContactInterval {
  int first, last;    ///< cells, both included
  double left, right; ///< edges; cell i spans i - 1/2 .. i + 1/2
  double length() const { return right - left; }
  void shift(int cells) { first += cells, last += cells, left += cells, right += cells; }
};

/// The stretches that are in contact, from left to right.
///
/// Intervals of cells with pressure > 0, their edges placed inside cells. Counting cells makes
/// every interval too long by 0.35 cells on average. At an edge the pressure inside is
/// K sqrt(distance) and the gap outside (4/3) (K/E*) distance^(3/2) (Johnson, sec. 4.2 and 5.1):
/// the last cell's pressure and its neighbour's gap place it to 0.07 cells, however short the
/// interval. Long smooth intervals do better with a polynomial fitted to p^2: a hundredth of a
/// cell. Edges at the pressure limit have no such root and stay at the face of their cell.
std::vector<ContactInterval> contactIntervals(const NormalContactResult &contact,
                                              Boundary boundary);

/// Sum of the intervals' lengths, in cells.
double contactLength(const std::vector<ContactInterval> &intervals);

} // namespace wheelrail
#endif
