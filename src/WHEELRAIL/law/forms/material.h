// SPDX-License-Identifier: GPL-2.0-or-later
/// \file material.h
/// friction.law FILE of `wr_fit --material`: mu(p, v, T) of one material (law/material_law.h), with
/// the pressure and the temperature of each cell.
#ifndef WHEELRAIL_LAW_FORMS_MATERIAL_H
#define WHEELRAIL_LAW_FORMS_MATERIAL_H

#include "law/fitted_law.h"
#include "law/law_choice.h"
#include "law/material_law.h"
#include "law/strength.h"

namespace wheelrail {

class LawOfMaterial : public FittedLaw<Eigen::Dynamic> {
 public:
  static constexpr const char *word = "law of a material";
  static constexpr const char *named = "a law file of wr_fit --material";

  static std::vector<LawKeyword> keywords();
  /// By the format of the file: one that is not there yet, or not readable, belongs to Eq. 2.
  static bool isNamedBy(const LawName &name) { return isMaterialLaw(name.path); }
  static LawChoice choose(const LawValues &values);

  /// \param name of the file, for messages
  /// \param ambient temperature of the bodies away from the contact, K
  LawOfMaterial(std::string name, MaterialLaw law, double ambient);

  Eigen::VectorXd mu(const FrictionState &state) const override;
  bool dependsOnSpeed() const override { return law_.dependsOnSpeed(); }
  bool dependsOnTemperature() const override { return true; }
  const Strength *strength() const override { return &strength_; }

  std::vector<LawInput> inputs() const override;
  LawUse use(const FrictionState &state) const override;
  /// A limit may be passed by a tenth: the ranges are not known better.
  std::string warning(const LawUse &use) const override;

  nlohmann::ordered_json json() const override;
  std::string note() const override { return law_.note; }

  LawPointer changed(const Eigen::VectorXd &change) const override;
  /// b, c, s >= 0 and a bend q >= 1; mu > 0 in a table.
  bool isDefined() const override;
  /// And mu > 0 at every pressure, at the material's temperatures and the speeds of the fit.
  bool isSound() const override;
  const char *soundness() const override { return "b, c, s >= 0, q >= 1, mu > 0"; }

 private:
  std::string name_;
  MaterialLaw law_;
  double ambient_;
  Strength strength_;
  MonotoneCurve modulus_;          ///< Pa over the temperature rise
  std::optional<MuCurves> curves_; ///< of the law's table
};

} // namespace wheelrail
#endif
