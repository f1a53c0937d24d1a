// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_MU_TABLE_H
#define WHEELRAIL_LAW_MU_TABLE_H

#include "base/monotone_curve.h"
#include "law/law_use.h"

#include <Eigen/Core>

#include <vector>

namespace wheelrail {

/// Friction coefficients of one material over p/sigma_0(T) and temperature, each temperature with
/// pressures of its own. ln mu is monotone between its neighbours (`base/monotone_curve.h`), over
/// ln(p/sigma_0) first and over the temperature then, with continuous derivatives. Beyond the
/// pressures of a row its slope decays: below to a constant mu, above to a constant friction stress
/// mu p. Beyond the temperatures the nearest row holds.
struct MuTable {
  struct Row {
    double temperature = 0.0;  ///< K
    std::vector<double> ratio; ///< p/sigma_0(T), > 0, rising, at least one
    std::vector<double> mu;    ///< > 0
    std::vector<double> muSe;  ///< standard errors, >= 0
  };
  std::vector<Row> rows; ///< temperatures rise, at least one
  /// mu goes like the sliding speed to a power that goes with the pressure, whatever the
  /// temperature; beyond the range of speeds that of the nearer end counts. Over ln(p/sigma_0) the
  /// power is a monotone curve, too, constant beyond its ends.
  struct SpeedPower {
    std::vector<double> ratio;      ///< p/sigma_0(T), > 0, rising; none: speed changes nothing
    std::vector<double> exponent;   ///< as many
    std::vector<double> exponentSe; ///< standard errors, >= 0
    Range range = {0.0, 0.0};       ///< m/s, where that is known; > 0 unless there is no exponent
    double reference = 0.0;         ///< m/s, of the values in the rows
  } speed;

  /// One value; for many see `MuCurves`.
  /// \param ratio         p/sigma_0, >= 0
  /// \param temperature   K
  /// \param slidingSpeed  m/s, >= 0
  double operator()(double ratio, double temperature, double slidingSpeed) const;

  /// Parameters of the table: the values of all rows in their order, and the exponents.
  Eigen::Index parameters() const;
  /// Standard errors of the parameters, in their order.
  Eigen::VectorXd standardErrors() const;
  /// \param change to be added to the parameters
  MuTable changed(const Eigen::VectorXd &change) const;
};

/// A table made ready for all cells of a contact, with the logarithms and slopes of its rows.
class MuCurves {
 public:
  explicit MuCurves(const MuTable &table);

  /// As `MuTable::operator()`.
  double operator()(double ratio, double temperature, double slidingSpeed) const;

 private:
  /// ln mu over ln(p/sigma_0) of a row: places, values, slopes there.
  struct Row {
    std::vector<double> place, value, slope;
    double at(double u) const;
  };

  std::vector<double> temperature_; ///< K
  std::vector<Row> rows_;
  MonotoneCurve speedExponent_; ///< over ln(p/sigma_0); empty where speed changes nothing
  double referenceSpeed_;
  Range speed_;
};

} // namespace wheelrail
#endif
