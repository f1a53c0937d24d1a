// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_MATERIAL_LAW_H
#define WHEELRAIL_LAW_MATERIAL_LAW_H

#include "law/bounded_mu.h"
#include "law/law_use.h"
#include "law/mu_table.h"
#include "law/softening_material.h"

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace wheelrail {

/// mu(p, v, T) of one material, of which strength and modulus are known over the temperature: a
/// form with few parameters, or a table. It is what `wr_fit --material` writes;
/// law/forms/material.h is its use in a contact.
struct MaterialLaw {
  using Covariance = Eigen::Matrix<double, allParameters, allParameters>;

  SofteningMaterial material;

  LawParameters parameters = LawParameters::Zero(); ///< of the form, `boundedMu`
  double kappa3 = 1.0;                              ///< its reference, > 0
  std::optional<Covariance> covariance;             ///< of the form; absent: not known
  std::optional<MuTable> table;                     ///< in place of the form

  /// Ranges of what it was fitted on; absent where the source states none.
  std::optional<Range> pressureRange;    ///< p/sigma_0(T)
  std::optional<Range> temperatureRange; ///< K
  std::optional<Range> speedRange;       ///< m/s
  int n = 0;                             ///< conditions that were fitted; 0: not stated
  double rmsRelative = 0.0;              ///< root mean square of (mu - fit)/fit; 0 of a table
  std::map<std::string, Range> fittedOn; ///< as `KappaLaw::fittedOn`
  std::string source;                    ///< where the numbers come from
  std::string note;                      ///< as `KappaLaw::note`

  /// kappa1 to kappa3 of the material.
  /// \param pressure  Pa, >= 0
  /// \param speed     m/s
  /// \param kelvin    temperature, K
  Kappas kappas(double pressure, double speed, double kelvin) const;
  /// mu there.
  double operator()(double pressure, double speed, double kelvin) const;
  /// Does mu change with the sliding speed?
  bool dependsOnSpeed() const;
};

/// Is it a file of the format that `readMaterialLaw` reads? What cannot be read is not.
bool isMaterialLaw(const std::string &path);

/// A law file as `wr_fit --material` writes it (JSON, format "mca-friction-law 2"). Needed are the
/// format, the material (temperature, strength, youngs_modulus, density) and mu0 with the other
/// parameters, or table_temperature, table_pressure and table_mu; all else may be missing.
/// \throws Error (BadInput) as `readKappaLaw`
MaterialLaw readMaterialLaw(const std::string &path);

/// The law file's content without its checksum. `readMaterialLaw` reads it back to the last bit.
nlohmann::ordered_json toJson(const MaterialLaw &law);

} // namespace wheelrail
#endif
