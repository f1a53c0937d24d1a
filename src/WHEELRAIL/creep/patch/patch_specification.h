// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_SPECIFICATION_H
#define WHEELRAIL_CREEP_PATCH_SPECIFICATION_H

#include "creep/patch/moving_patch.h"
#include "creep/sweep/field_selection.h"
#include "creep/sweep/law_spread.h"
#include "law/law_choice.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace wheelrail {

/// How the surfaces behave: they stand still in the contact (steady rolling), travel through it
/// with the material, or do not roll at all. In frozen and static mode time plays no part.
enum class PatchMode { Frozen, Moving, Static };

/// A sweep over a point contact: everything with everything. SI units.
/// Every list has at least one value where its mode reads it. Of creepage and force of one
/// direction only one is given; in mode static only one of force ratio, shift and forces.
struct PatchSpecification {
  PatchContactSpecification contact;
  /// None, generated or measured; several surfaces multiply the points.
  RoughPatchSpecification roughness;
  LawChoice friction;
  /// Strength, temperature and limit of the pressure.
  CreepPhysics physics;
  PatchMode mode = PatchMode::Frozen;
  MovingPatchSpecification moving;          ///< of mode Moving
  PatchSequence sequence;                   ///< Moving; Static: stages, one after the other
  std::vector<double> creep, lateral;       ///< -; one value each where the force is given
  std::vector<double> spin;                 ///< 1/m
  std::vector<double> forceX, forceY;       ///< N; empty: the creepage is given
  std::vector<double> forceRatio;           ///< Static: -Fx/(sum of mu p), below 1
  std::vector<std::array<double, 2>> shift; ///< Static: of the wheel against the rail, m
  double twist = 0.0;                       ///< Static: turn that goes with the shift, rad
  std::vector<double> speed;                ///< m/s
  /// Points whose fields are kept and written; each costs eight doubles a cell.
  FieldSelection fields;
  /// Depths at which the stresses of these points are written, m, > 0; empty: none.
  std::vector<double> depths;
  bool sensitivities = true; ///< Kalker's coefficients of every contact
  /// How a covariance of the law becomes bands; not of mode Static.
  SpreadSpecification spread;
};

/// One point of the sweep before it is computed.
struct PatchTask {
  /// Contacts are numbered by surface, then load.
  std::size_t contact; ///< index in PatchCurves::contacts
  double speed = 0.0;  ///< m/s; 0 in mode static
  PatchDrive drive;    ///< Static: the shift as creepage, m
  /// Static: -Fx/(sum of mu p); absent where forces or a shift are given.
  std::optional<double> forceRatio;
};

/// The points in the order of the results.
/// The longitudinal creepage or force changes fastest, then lateral, spin, speed; then load and
/// surface. Number k of the results is element k - 1 here.
std::vector<PatchTask> patchTasks(const PatchSpecification &asked);

/// The point that fields are of, and when.
struct FieldPlace {
  int point;   ///< from 1 on
  int instant; ///< of `PatchSequence::fields`, from 1 on; 0: the point's end
};
/// One number for both, by which fields are kept: that of the point for its end.
/// \param points of the sweep
int fieldNumber(const FieldPlace &place, int points);
FieldPlace fieldPlace(int number, int points);

} // namespace wheelrail
#endif
