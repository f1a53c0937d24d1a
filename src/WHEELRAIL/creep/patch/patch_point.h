// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_POINT_H
#define WHEELRAIL_CREEP_PATCH_POINT_H

#include "contact/patch/elasticity/patch_half_space.h"
#include "contact/patch/solvers/patch_coupling.h"
#include "contact/patch/solvers/patch_temperature.h"
#include "creep/patch/field_files.h"
#include "creep/patch/patch_values.h"
#include "creep/sweep/creep_physics.h"
#include "creep/sweep/law_spread.h"
#include "creep/sweep/slip_memory.h"

#include <cmath>
#include <optional>
#include <string>

namespace wheelrail {

/// What drives a patch: creepages, or forces with unknown creepages. SI units.
/// Where both forces are given, both creepages are found; the spin is always given.
struct PatchDrive {
  Creepage creepage;            ///< phi in 1/m; that of a given force is not read
  std::optional<double> forceX; ///< N; given: the longitudinal creepage is unknown
  std::optional<double> forceY; ///< N; given: the lateral creepage is unknown
};

/// What the covariance of the friction law leaves undetermined of a point; SI units, 0 without one.
struct PatchBands {
  Band tractionRatio;
  Band x, y; ///< of the force along x and y (N), or of the creepage there where the force is given
  Band momentZ;
};

/// One computed point; SI units.
/// What is not computed keeps the value here: the errors where nothing moves, for example.
struct PatchPoint : PatchValues {
  std::uint64_t surface = 0;         ///< seed, or number of the measured pair
  double speed = 0.0;                ///< m/s
  double temperatureMaximum = 0.0;   ///< K
  int iterations = 0;                ///< of the fixed point; steps where the contact moves
  int products = 0;                  ///< with the influence of the tractions, in all
  double powerClosure = 1.0;         ///< frictionalPower over what the drive gives
  double errorX = 0.0, errorY = 0.0; ///< standard errors of the forces where the contact
  double errorZ = 0.0;               ///< moves, and of the moment
  PatchBands bands;
  LawUse use;          ///< where mu was asked for; in mode moving in the last step
  std::string failure; ///< why it was not computed: the numbers are none; or empty

  bool converged() const { return failure.empty(); }
  double traction() const { return std::hypot(forceX, forceY); } ///< N
  /// Size of the tangential force over the load, >= 0.
  double tractionRatio() const { return traction() / load; }
};

/// All of an operating point: the table that creep.csv, static.csv and the journal follow from.
/// \return the same table in every call
const std::vector<Column<PatchPoint>> &patchColumns();

/// Load-weighted root mean square of the rigid slip, relative to the rolling speed: the creep of a
/// contact without spin.
/// \param pressure per cell, any unit, with a sum > 0
/// \param creepage phi in 1/unit of the grid's length; without spin the result is the length of
///         (xi, eta), whatever the pressure
double rigidSlip(const PatchGrid &grid, const Eigen::VectorXd &pressure, const Creepage &creepage);

/// Mean over an ellipse of Eq. 11, whose rows along x are line contacts with half-lengths and
/// pressures of their own, relative to that of the longest row: Beta(1/2, 9/4)/(pi/2).
/// A pure number, 0.795: where Eq. 11 is used, the mean over the ellipse is that much of the mean
/// over the longest row.
double meanOverEllipse();

/// Mean temperature rise of an ellipse (Eq. 11, row by row), K.
/// \param powerOverLoad friction's heat in a second over the load, m/s: mu times the sliding speed
///        where everything slides
/// \param hertz a along x (m) and p0 (Pa) of the smooth contact are read
/// \param speed v0, m/s, > 0
double meanTemperatureRise(double powerOverLoad, const HertzEllipse &hertz, double speed,
                           const ThermalMaterial &material);

/// The largest temperature of a contact, K.
/// \param hottest cell; of the averaged models they all are
double largestTemperature(const ThermalSpecification &thermal, double hottest);

/// Steady rolling on surfaces that stand still in the contact, with friction, temperature and
/// strength that depend on each other: a fixed point as of the line contact (`FrozenCreep`). At a
/// large Peclet number the rows along x do not exchange heat, so that the flash temperature of each
/// of them is that of the line.
/// The unknowns of the fixed point are the temperature rise and, where forces are given and
/// friction falls with sliding speed, the creepages; where it falls with the slip of each cell,
/// what it has fallen to; of unlike bodies the pressure, too, which the traction changes. A step
/// that comes out no smaller than the one before is halved from then on.
class FrozenPatch {
 public:
  /// Both must outlive the object.
  /// \param spinPoint `TangentialProblem::spinPoint`
  /// \param options of each tangential problem; the start is not read
  FrozenPatch(const CreepPhysics &physics, const PatchContact &contact, double spinPoint,
              TangentialOptions options = defaultOptions());
  static TangentialOptions defaultOptions(); ///< of a sweep

  /// Warm from the last call: tractions, creepages that were found, temperature.
  /// \throws Error (NotConverged), Error (BadInput) for a force that friction cannot carry
  /// \param speed v0, m/s, > 0
  /// \param drive a force that is given must be below the sum of mu p at some sliding speed
  PatchPoint solve(const FrictionLaw &law, double speed, const PatchDrive &drive);

  /// Takes load and pressure of the contact anew, which has been pressed otherwise since.
  void pressAnew();

  const PatchFields &fields() const { return fields_; } ///< in SI units, of the last call
  /// What friction has fallen to, see `SlipMemory`; ones without a memory.
  const Eigen::VectorXd &memoryRatio() const { return memoryRatio_; }

 private:
  /// `solve` from the point before.
  PatchPoint settle(const FrictionLaw &law, double speed, const PatchDrive &drive);
  /// Where friction carries the force only at a larger creepage than that of the point before.
  /// \param error what was said there
  PatchPoint solveAlongCreep(const FrictionLaw &law, double speed, const PatchDrive &drive,
                             const ForceTooLarge &error);
  /// One tangential problem under the present bound; unknown creepages are searched from `guess`.
  TangentialResult roll(const PatchDrive &drive, const Creepage &guess);
  void rollWarmOrCold(const PatchDrive &drive);
  /// Rise per cell that the present traction causes, K; one value everywhere with Eq. 11.
  Eigen::VectorXd temperatureFrom(double speed);
  /// mu of all cells at the present pressure, temperature and memory.
  Eigen::VectorXd muNow(const FrictionLaw &law, double speed) const;
  /// The normal contact anew, with what traction and temperature change in it.
  void renewPressure(const FrictionLaw &law);
  /// \param friction the law is at fault, or else the coupling of unlike bodies
  [[noreturn]] void failToSettle(double speed, int iterations, bool friction) const;
  /// Root mean square of the rigid slip times the rolling speed, m/s.
  double slidingSpeed(double speed) const;
  /// Sums of the last solution, with what unlike bodies' pressure gives.
  PatchSums sums() const;
  /// Iterations of the fixed point.
  PatchPoint pointOf(const FrictionLaw &law, double speed, int iterations) const;

  const CreepPhysics &physics_;
  const PatchContact &contact_;
  double spinPoint_;
  TangentialOptions options_;
  TangentialSolver solver_;
  TangentialResult result_;
  TangentialField imposed_; ///< by the pressure of unlike bodies, in `result_`
  bool warm_ = false;
  Creepage creepage_;
  std::optional<PatchHalfSpace> space_; ///< for the pressure, where it changes
  PatchCoupling coupling_;
  std::optional<PatchFlashTemperature> flash_;
  double flashSpeed_ = 0.0;
  std::optional<SlipMemory> memory_;
  Eigen::VectorXd memoryRatio_; ///< see `SlipMemory`
  double approach_ = 0.0;
  int products_ = 0;
  PatchFields fields_;
};

/// Heat by friction per cell at a rolling speed, W/m2.
/// -v0 q . s with the traction q (Pa) and the slip s relative to rolling; both bodies' together, as
/// `PatchFlashTemperature` takes it. About >= 0: q points against s.
/// \param speed v0, m/s
Eigen::VectorXd frictionalHeat(const TangentialResult &result, double speed);

} // namespace wheelrail
#endif
