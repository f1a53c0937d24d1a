#ifndef WHEELRAIL_CREEP_CREEP_POINT_H
#define WHEELRAIL_CREEP_CREEP_POINT_H

#include "contact/line/contact_temperature.h"
#include "contact/line/rolling_contact.h"
#include "creep/contact_setup.h"

#include <optional>

namespace wheelrail {

/// One point of a creep curve; SI units.
struct CreepPoint {
  double speed = 0.0; ///< v0, m/s
  double creep = 0.0;
  double tractionRatio = 0.0;      ///< T/N
  double traction = 0.0;           ///< T, N/m
  double muMean = 0.0;             ///< load-weighted mean of mu
  double temperatureRise = 0.0;    ///< mean over the nominal contact, K
  double temperatureMaximum = 0.0; ///< K; that of Eq. 11's profile where Eq. 11 is the model
  int iterations = 0;              ///< of the fixed point mu - T - Theta - sigma_0
  double stickFraction = 0.0;      ///< of the cells in contact
};

/// Everything along the contact, per cell; SI units.
struct ContactFields {
  Eigen::VectorXd pressure, traction, mu, slip, temperature;
  std::vector<Adhesion> state;
  std::vector<ContactInterval> intervals; ///< stretches in contact, in cells
};

/// Friction coefficient per cell from pressure (Pa), sliding speed (m/s) and temperature rise (K).
Eigen::VectorXd frictionCoefficient(const Case &input, const FrictionLaw &law,
                                    const Eigen::VectorXd &pressure, double slidingSpeed,
                                    const Eigen::VectorXd &temperature);

/// Steady rolling on a frozen profile with friction, temperature and strength that depend on each
/// other. The temperature rise is the unknown of a fixed-point iteration; where a step comes out
/// larger than the one before, it is halved from then on.
class FrozenCreep {
 public:
  FrozenCreep(const Case &input, const ContactSetup &setup);

  /// Warm from the last call: the set of stick cells and the temperature.
  /// @throws Error (NotConverged)
  CreepPoint solve(const FrictionLaw &law, double speed, double creep);

  /// Of the last call; `startFrom` makes the next one start from them.
  const ContactFields &fields() const { return contact; }
  void startFrom(const ContactFields &fields) { contact = fields; }

 private:
  void roll(double creep);
  double meanMu() const;
  double tractionRatio() const { return contact.traction.sum() / contact.pressure.sum(); }
  Eigen::VectorXd temperatureFrom(double speed, double creep);
  void limitPressure();

  const Case &input;
  const ContactSetup &setup;
  std::optional<HalfPlane> domain; ///< for the pressure, where it changes with temperature
  std::optional<HalfPlane> window; ///< the cells in contact and a few more: all that rolling needs
  std::optional<FlashTemperature> flash;
  double flashSpeed = 0.0;
  ContactFields contact;
};

} // namespace wheelrail
#endif
