// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_EDGE_SHARE_H
#define WHEELRAIL_CONTACT_EDGE_SHARE_H

namespace wheelrail {

/// Where the edge of a contact lies between the centres of the last cell in contact and its
/// neighbour apart: the share of that way, 0 to 1, that is apart. A pressure K sqrt(distance)
/// inside and a gap (4/3) (K/E*) distance^(3/2) outside (Johnson, Contact Mechanics, sec. 4.2 and
/// 5.1) have one edge that fits both. Off by 0.07 cells, since the pressure of the last cell
/// depends on where in it the edge lies.
/// \param pressure of the last cell, > 0, in units of E*
/// \param gap of its neighbour, >= 0, in units of the way
double shareApart(double pressure, double gap);

} // namespace wheelrail
#endif
