// SPDX-License-Identifier: GPL-2.0-or-later
/// \file constant.h
/// friction.law constant: one mu, whatever the pressure, the speed and the temperature.
#ifndef WHEELRAIL_LAW_FORMS_CONSTANT_H
#define WHEELRAIL_LAW_FORMS_CONSTANT_H

#include "law/kappa_law.h"
#include "law/law_choice.h"

#include <nlohmann/json.hpp>

namespace wheelrail {

class ConstantLaw : public FrictionLaw {
 public:
  static constexpr const char *word = "constant";
  static constexpr const char *named = "constant";

  static std::vector<LawKeyword> keywords()
  {
    return {{"friction.mu", LawKeyword::Kind::Number, "1", "", 1e-9, 10, "of the law constant"}};
  }
  static bool isNamedBy(const LawName &name) { return name.word == word; }
  static LawChoice choose(const LawValues &values)
  {
    LawChoice choice;
    choice.read = [mu = values["friction.mu"]] { return std::make_shared<ConstantLaw>(mu); };
    return choice;
  }

  /// \param mu > 0
  explicit ConstantLaw(double mu) : mu_(mu) {}

  Eigen::VectorXd mu(const FrictionState &state) const override
  {
    return Eigen::VectorXd::Constant(state.pressure.size(), mu_);
  }
  bool dependsOnSpeed() const override { return false; }
  bool dependsOnTemperature() const override { return false; }

  /// As a law file: Eq. 2 with nothing but its mu0.
  nlohmann::ordered_json json() const override
  {
    KappaLaw law;
    law.mu0 = mu_;
    law.source = word;
    return toJson(law);
  }

 private:
  double mu_;
};

} // namespace wheelrail
#endif
