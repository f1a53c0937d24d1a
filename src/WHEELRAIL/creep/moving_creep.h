#ifndef WHEELRAIL_CREEP_MOVING_CREEP_H
#define WHEELRAIL_CREEP_MOVING_CREEP_H

#include "creep/creep_point.h"

#include <functional>
#include <optional>

namespace wheelrail {

/// One creep on its way through the contact.
struct Roller {
  double creep;
  TransientRolling rolling;
  std::optional<TravellingHeat> heat;
  Eigen::VectorXd temperature, mu; ///< per cell; K
  RollingResult result;            ///< on the window
  struct Sums {
    double ratio = 0.0, mu = 0.0, stick = 0.0, temperature = 0.0;
  };
  Sums pass, counted; ///< over the pass, over the last half of all
  double hottest = 0.0;
};

/// Transient rolling: the roughness travels with the material, one cell a step. The creeps of a
/// call share the pressures and are rolled together; they do not influence each other, so a
/// pressure limit that depends on temperature wants one creep a call. Traction, friction and stick
/// are means over the last half of the passes. Eq. 11's temperature follows the mean of the pass
/// before; the local one is carried along by the material and is a cell behind in the friction
/// coefficient.
class MovingCreep {
 public:
  MovingCreep(const Case &input, const FrictionLaw &law, const ContactSetup &setup);

  /// @param progress called now and then; returns false to stop
  /// @return one point per creep; empty when stopped
  /// @throws Error (NotConverged), Error (BadInput) for a measured profile that is too short
  std::vector<CreepPoint> solve(double speed, const std::vector<double> &creeps,
                                const std::function<bool()> &progress);

  /// At the end, for the last creep.
  const ContactFields &fields() const { return contact; }

 private:
  void solvePressure(int step, double temperature);
  void fitWindow(std::vector<Roller> &rollers);
  void roll(Roller &roller, double speed, bool counted);
  void endPass(Roller &roller, double speed, int steps);
  CreepPoint pointOf(const Roller &roller, double speed, int steps, int counted) const;

  const Case &input;
  const FrictionLaw &law;
  const ContactSetup &setup;
  HalfPlane domain;                ///< for the pressure
  std::optional<HalfPlane> window; ///< for the traction: the cells in contact and a few more
  int windowBegin = 0;
  NormalContactResult normal;
  ContactFields contact;
};

} // namespace wheelrail
#endif
