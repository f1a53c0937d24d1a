// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_CREEP_CURVE_H
#define WHEELRAIL_CREEP_LINE_CREEP_CURVE_H

#include "creep/line/curve_point.h"
#include "creep/line/moving_creep.h"
#include "creep/sweep/field_selection.h"
#include "creep/sweep/law_spread.h"
#include "creep/sweep/sweep.h"
#include "law/law_choice.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace wheelrail {

/// What a sweep gives.
/// Every point is there, converged or not, or `solveCreepCurves` has thrown. SI units.
struct CreepCurves {
  std::vector<ContactSetup> contacts; ///< one per profile
  std::vector<CurvePoint> points;     ///< by profile, then speed, then creep
  bool hasBand = false;               ///< the law has a covariance
  double redrawn = 0.0;               ///< share of the sampled laws that had to be drawn again
  /// Along the contact, by number of the point, from 1 on: those that were asked for and converged.
  std::map<int, ContactFields> fields;
  LawUse use;                        ///< where all points together asked for mu
  std::vector<std::string> warnings; ///< one line each
  int resumed = 0;                   ///< points taken over from an interrupted run
  double seconds = 0.0;              ///< that it took, contacts included
};

/// Does the roughness stay in the contact, or travel with the material?
/// Frozen lowers the initial slope in proportion to the real contact length: (pi E*/4) times that
/// length. With travelling roughness the slope is nearly that of the smooth contact.
enum class RollingMode { Frozen, Moving };

/// A sweep of creeps and speeds over profiles, all of it; SI units.
struct CreepSpecification {
  LineContactSpecification contact; ///< rolling needs a radius: no period
  /// Roughness and profiles: each profile gives a curve of its own.
  SurfaceSpecification surface;
  LawChoice friction;
  /// Strength, temperature and limit of the pressure.
  CreepPhysics physics;
  RollingMode mode = RollingMode::Frozen;
  MovingSpecification moving; ///< of mode Moving
  /// The order of the lists is that of the results.
  std::vector<double> creep; ///< sliding/rolling speed; positive: the wheel brakes
  std::vector<double> force; ///< T, N/m, in place of creeps, which are found; of mode Frozen
  std::vector<double> speed; ///< rolling speeds v0, m/s, > 0, at least one
  /// How a covariance of the law becomes a band of T/N.
  SpreadSpecification spread;
  FieldSelection fields; ///< points whose fields along the contact are kept

  /// The list that is not empty.
  const std::vector<double> &drives() const { return force.empty() ? creep : force; }
};

/// All creeps at all speeds on all profiles. The work is cut into pieces of a few neighbouring
/// creeps, each started cold and solved in order, whatever the number of threads: so the result is
/// the same to the last bit on one thread or many, in one go or resumed. A negative creep is the
/// mirror image of the positive one: the same friction, heat and pressure, traction and slip turned
/// around. Under a force the creep is found with the law itself; a band is that at this creep. A
/// point that does not converge leaves the others untouched; the next one of its piece starts cold.
/// \param law of the specification's friction (`LawChoice::read`); its covariance, if it has one,
///        is carried through (`LawSpread`)
/// \throws Error (Interrupted) when asked to stop, Error (NotConverged) where no point converges,
///         and what else the points throw
/// \param options threads, journal, progress, interruption; none of them changes a number
/// \return points in the order of the specification: creep changes fastest
CreepCurves solveCreepCurves(const CreepSpecification &specification, const LawPointer &law,
                             const SweepOptions &options = {});

} // namespace wheelrail
#endif
