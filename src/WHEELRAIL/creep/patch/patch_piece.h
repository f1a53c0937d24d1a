// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_PIECE_H
#define WHEELRAIL_CREEP_PATCH_PIECE_H

#include "creep/patch/patch_specification.h"
#include "creep/sweep/law_spread.h"

#include <functional>
#include <map>
#include <vector>

namespace wheelrail {

/// Neighbouring points of one contact at one speed, solved in order by one thread.
struct PatchPiece {
  std::size_t first, count; ///< of the tasks
};

/// What a piece leaves; series by number of the point, from 1 on, fields by `fieldNumber`.
struct PatchPieceResult {
  std::vector<PatchPoint> points; ///< empty when interrupted
  std::map<int, PatchFields> fields;
  std::map<int, std::vector<PatchStep>> series; ///< of mode Moving, and of sequences
};

/// Solves the points of a piece. Steady rolling goes warm from point to point; in the other modes
/// each point begins anew. Where the law has a covariance, every point is solved with the laws
/// near it too, without any influence on its own result.
/// \param tasks all of the sweep's
/// \param goOn asked often; false to stop
/// A point that does not converge stays without numbers, and the next one begins cold.
/// \throws what the points throw beside that
PatchPieceResult solvePatchPiece(const PatchSpecification &asked, const LawSpread &spread,
                                 const PatchContact &contact, const std::vector<PatchTask> &tasks,
                                 const PatchPiece &piece, const std::function<bool()> &goOn);

} // namespace wheelrail
#endif
