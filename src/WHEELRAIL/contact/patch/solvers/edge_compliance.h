// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_EDGE_COMPLIANCE_H
#define WHEELRAIL_PATCH_EDGE_COMPLIANCE_H

#include "contact/patch/solvers/tangential.h"

namespace wheelrail {

/// Leading edges of a contact placed inside their cells, for rolling by one cell: forces of
/// smooth contacts are then some five to ten times nearer to their limit than with whole cells.
///
/// As on a line (`solveFrozenRolling`): the traction of a cell acts at its centre and its slip is
/// that half a cell further on, as with a load at 1/4 and an equation at 3/4 of a panel from 1/4
/// cell behind the centre to 3/4 before it. With an edge at the cell's face the leading panel is
/// too long by 1/4 cell, and forces are too large in the first order of the cells. A panel of which
/// only the share w lies in contact gets the compliance 2 (1 - w)/w times that of a line: (1 -
/// nu)/G across the edge (plane strain), 1/G along it (antiplane), times dx cos(angle of the edge's
/// normal to x), the way of one cell across the edge. A stretch of one cell has 4 (1 - w)/(pi w).
///
/// Where in its cell an edge lies follows from pressure and gap (`shareApart`), its direction from
/// the cells in contact around it. Trailing edges, where a contact slips, need nothing.
/// \param pressure, gap of the normal contact, per cell of the grid
/// \return displacement over traction per cell; zero but at leading edges
EdgeCompliance edgeCompliance(const PatchGrid &grid, const ElasticPair &pair,
                              const Eigen::VectorXd &pressure, const Eigen::VectorXd &gap);

} // namespace wheelrail
#endif
