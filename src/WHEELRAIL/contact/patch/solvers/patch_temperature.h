// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_TEMPERATURE_H
#define WHEELRAIL_PATCH_TEMPERATURE_H

#include "contact/contact_temperature.h"
#include "contact/half_space.h"

#include <vector>

namespace wheelrail {

/// Flash temperature over a patch. At a large Peclet number heat flows into the depth only, not
/// across the rolling direction: every row of cells is a line contact's problem of its own, solved
/// by FlashTemperature without an error of the order sqrt(cell). SI units.
/// The sums over a row are those of the line contact, so that grids of any width give the line's
/// temperature row by row. One object has one work buffer: use one per thread.
class PatchFlashTemperature {
 public:
  /// \param grid nx and ny count; lengths are not read
  /// \param cellLength along x, m
  /// \param speed rolling speed, m/s
  PatchFlashTemperature(const CellGrid &grid, double cellLength, double speed,
                        const ThermalMaterial &material);

  /// \param heat friction power per area of each cell, both bodies' together, W/m2
  /// \return temperature rise per cell, K
  /// Steady: heat and speed do not change while the material goes through the contact.
  /// Mean over each cell, exact for heat that is uniform on the cells; 0 ahead of the first heat.
  Eigen::VectorXd rise(const Eigen::VectorXd &heat);

 private:
  CellGrid grid_;
  FlashTemperature row_;
};

/// Flash temperature where heat changes in time (one step: the material moves on by a cell).
/// With heat that does not change it becomes `PatchFlashTemperature`, once every row of material
/// has gone through the box.
class PatchTravellingHeat {
 public:
  /// At the start no cell has taken up heat. Arguments as of `PatchFlashTemperature`.
  PatchTravellingHeat(const CellGrid &grid, double cellLength, double speed,
                      const ThermalMaterial &material);

  /// Material moves towards smaller x; what enters at the largest x is cold.
  /// \param heat now, one value a cell, x fastest
  void step(const Eigen::VectorXd &heat); ///< W/m2, both bodies'
  /// One value a cell, x fastest, also behind the contact.
  Eigen::VectorXd rise() const; ///< after the last step, K

 private:
  CellGrid grid_;
  std::vector<TravellingHeat> rows_;
};

} // namespace wheelrail
#endif
