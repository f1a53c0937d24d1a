// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_LINE_VALUES_H
#define WHEELRAIL_CREEP_LINE_LINE_VALUES_H

#include "contact/line/contact_setup.h"
#include "contact/line/rolling_contact.h"
#include "creep/sweep/sliding_values.h"

namespace wheelrail {

/// What one solution of a rolling line contact gives; in mode moving the mean over steps. SI units.
struct LineValues : SlidingValues {
  double tractionRatio = 0.0; ///< T/N
  double peakTraction = 0.0;  ///< Pa
  double frictionWork = 0.0;  ///< heat over the length rolled and the length across, N/m
};

/// Their columns, in the order of creep.csv.
std::vector<Column<LineValues>> lineColumns();

/// What drives the slip of all cells, over the length rolled: creep and what the pressure of unlike
/// bodies adds. Bodies that roll steadily keep none of it, so that it is friction's heat; traction
/// times slip, summed over the cells, is that but for an error of the order of a cell.
/// \param imposed slip of each cell, of `couplingSlip`, or empty
/// \return in units of the traction times cells
double drivenWork(const Eigen::VectorXd &traction, double creep, const Eigen::VectorXd &imposed);

/// The values of one solution, all but the work of friction.
/// \param tractionRatio T/N
/// \param traction of all cells that may touch, Pa
/// \param pressure, mu, temperature one value per cell of the domain; Pa and K
/// \param state of all cells that may touch, at least one of which does
LineValues lineValues(const ContactSetup &setup, double tractionRatio,
                      const Eigen::VectorXd &traction, const Eigen::VectorXd &pressure,
                      const Eigen::VectorXd &mu, const Eigen::VectorXd &temperature,
                      const std::vector<Adhesion> &state);

} // namespace wheelrail
#endif
