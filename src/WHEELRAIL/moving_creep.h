#ifndef WHEELRAIL_MOVING_CREEP_H
#define WHEELRAIL_MOVING_CREEP_H

#include "creep_point.h"

#include <functional>

namespace wheelrail {

/// Transient rolling: the roughness travels with the material, one cell a step. All creeps are
/// rolled together, since they share the pressures. Traction, friction and stick are means over the
/// last half of the passes; the temperature follows the mean traction of the pass before.
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
  const Case &input;
  const FrictionLaw &law;
  const ContactSetup &setup;
  ContactFields contact;
};

} // namespace wheelrail
#endif
