// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/line_values.h"

#include "base/si.h"

#include <algorithm>

namespace wheelrail {

std::vector<Column<LineValues>> lineColumns()
{
  std::vector<Column<LineValues>> table = {{"traction_ratio", "1", 1.0, "T/N",
                                            kept<&LineValues::tractionRatio>, leading(10),
                                            leading(10)}};
  append(table, slidingColumns());
  table.push_back({"peak_traction", "MPa", MPa, "largest shear stress of the surface",
                   kept<&LineValues::peakTraction>, following(10)});
  table.push_back({"friction_work", "N/mm", newtonPerMm,
                   "heat by friction over the length rolled, of a mm across",
                   kept<&LineValues::frictionWork>, following(10)});
  return table;
}

double drivenWork(const Eigen::VectorXd &traction, double creep, const Eigen::VectorXd &imposed)
{
  return creep * traction.sum() + (imposed.size() > 0 ? traction.dot(imposed) : 0.0);
}

LineValues lineValues(const ContactSetup &setup, double tractionRatio,
                      const Eigen::VectorXd &traction, const Eigen::VectorXd &pressure,
                      const Eigen::VectorXd &mu, const Eigen::VectorXd &temperature,
                      const std::vector<Adhesion> &state)
{
  LineValues values;
  values.tractionRatio = tractionRatio;
  values.peakTraction = traction.cwiseAbs().maxCoeff();
  values.muMean = mu.dot(pressure) / pressure.sum();
  values.temperatureRise = setup.nominalMean(temperature);
  const auto apart = std::count(state.begin(), state.end(), Adhesion::Apart);
  values.setStick(static_cast<double>(std::count(state.begin(), state.end(), Adhesion::Stick)),
                  static_cast<double>(static_cast<std::ptrdiff_t>(state.size()) - apart));
  return values;
}

} // namespace wheelrail
