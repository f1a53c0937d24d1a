// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_CREEP_POINT_H
#define WHEELRAIL_CREEP_LINE_CREEP_POINT_H

#include "creep/line/line_values.h"
#include "creep/sweep/creep_physics.h"
#include "creep/sweep/slip_memory.h"

#include <optional>

namespace wheelrail {

/// One point of a creep curve; SI units.
struct CreepPoint : LineValues {
  double speed = 0.0;              ///< v0, m/s
  double creep = 0.0;              ///< sliding / rolling speed
  double traction = 0.0;           ///< T, N/m
  double temperatureMaximum = 0.0; ///< K; that of Eq. 11's profile where Eq. 11 is the model
  int iterations = 0;              ///< of the fixed point mu - T - Theta - sigma_0
  LawUse use;                      ///< in mode moving: where mu was asked for in the last step
};

/// Everything along the contact, one value per cell of the domain; SI units.
/// Cells lie as in `ContactSetup`, from the trailing to the leading side.
struct ContactFields {
  Eigen::VectorXd pressure;    ///< Pa, >= 0
  Eigen::VectorXd traction;    ///< Pa, positive for positive creep
  Eigen::VectorXd mu;          ///< friction coefficient
  Eigen::VectorXd slip;        ///< sliding distance / rolling distance
  Eigen::VectorXd temperature; ///< rise, K
  std::vector<Adhesion> state;
  std::vector<ContactInterval> intervals; ///< stretches in contact, in cells
};

/// Steady rolling on a frozen profile with friction, temperature and strength that depend on each
/// other. The temperature rise is the unknown of a fixed-point iteration; where a step comes out
/// larger than the one before, it is halved from then on.
/// The local model of temperature takes the heat from traction and slip, cell by cell; Eq. 11 takes
/// one value for the contact. With a memory friction falls with the slip of each cell, which the
/// iteration then finds, too. A pressure limit that falls with temperature follows the rise of each
/// cell, of Eq. 11 the load-weighted mean, and the normal contact is solved again; so it is for
/// unlike bodies, whose traction opens or closes the gap.
class FrozenCreep {
 public:
  /// Starts from the normal contact of the setup, without traction and temperature. Both must
  /// outlive the object.
  /// \param setup  of a Free boundary
  FrozenCreep(const CreepPhysics &physics, const ContactSetup &setup);

  /// Warm from the last call: the set of stick cells and the temperature.
  /// \param speed v0, m/s, > 0
  /// \param signedCreep  A A negative one gives the mirror image, which has the size of the
  ///        creep and, of unlike bodies, wheel and rail exchanged
  /// \throws Error (NotConverged), also when a softer contact reaches the ends of the domain
  /// \return the point, its fields in `fields()`
  CreepPoint solve(const FrictionLaw &law, double speed, double signedCreep);

  /// Where the last call asked its law for mu.
  /// \param law, speed, creep  those of the call
  LawUse use(const FrictionLaw &law, double speed, double creep) const;

  /// Fields of the last call; `startFrom` makes the next one start from them.
  /// SI units, over the whole domain.
  const ContactFields &fields() const { return contact_; }
  /// \param fields of a point nearby, on the same domain
  void startFrom(const ContactFields &fields) { contact_ = fields; }

 private:
  /// Traction, slip and state under the present friction and pressure; warm from the last ones.
  void roll(double creep);
  /// T/N: sum of the traction over that of the pressure.
  double tractionRatio() const { return contact_.traction.sum() / contact_.pressure.sum(); }
  /// Rise per cell that the present traction causes, K.
  Eigen::VectorXd temperatureFrom(double speed, double creep);
  /// Normal contact again, under the hardness at the present temperature and, of unlike bodies,
  /// with the gap that the traction opens.
  /// \param part of the change of that gap that is taken
  void renewPressure(const FrictionLaw &law, double part);
  void checkExcess(const FrictionLaw &law, double speed, double creep) const;
  /// mu of all cells at the present pressure, temperature and memory.
  Eigen::VectorXd muNow(const FrictionLaw &law, double slidingSpeed) const;

  const CreepPhysics &physics_;
  const ContactSetup &setup_;
  std::optional<HalfPlane> domain_; ///< for the pressure, where it changes with temperature
  std::optional<HalfPlane> window_; ///< the cells in contact and a few more: all that rolling needs
  std::optional<FlashTemperature> flash_;
  double flashSpeed_ = 0.0;
  std::optional<SlipMemory> memory_;
  Eigen::VectorXd memoryRatio_; ///< see `SlipMemory`
  ContactFields contact_;
  double frictionWork_ = 0.0; ///< of `contact_`, N/m
  Eigen::VectorXd opening_;   ///< of the gap, by the traction of unlike bodies, in cells
  double coupling_ = 0.0; ///< of the image that is solved: `ContactSetup::coupling`, or less that
};

} // namespace wheelrail
#endif
