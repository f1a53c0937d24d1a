// SPDX-License-Identifier: GPL-2.0-or-later
/// \file polach.h
/// friction.law polach: mu that falls with the sliding speed, as measured curves of locomotives do.
#ifndef WHEELRAIL_LAW_FORMS_POLACH_H
#define WHEELRAIL_LAW_FORMS_POLACH_H

#include "law/law_choice.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace wheelrail {

/// Friction that falls with sliding speed (O. Polach, Wear 258 (2005) 992):
/// mu = mu0 [(1 - A) exp(-B w) + A].
struct FallingFriction {
  double mu0 = 0.0; ///< at sliding speed 0, > 0
  double A = 1.0;   ///< limit at large sliding speed over mu0, 0 .. 1
  double B = 0.0;   ///< s/m, >= 0

  /// \param slidingSpeed w, m/s, >= 0
  double operator()(double slidingSpeed) const
  {
    return mu0 * ((1.0 - A) * std::exp(-B * slidingSpeed) + A);
  }
};

class PolachLaw : public FrictionLaw {
 public:
  static constexpr const char *word = "polach";
  static constexpr const char *named = "polach";

  static std::vector<LawKeyword> keywords()
  {
    using Kind = LawKeyword::Kind;
    return {{"friction.mu0", Kind::Number, "1", "", 1e-9, 10,
             "of the law polach: mu = mu0 ((1 - A) exp(-B w) + A) at a sliding speed w"},
            {"friction.A", Kind::Number, "1", "", 0, 1, "of the law polach"},
            {"friction.B", Kind::Quantity, "s/m", "", 0, 1e9, "of the law polach"}};
  }
  static bool isNamedBy(const LawName &name) { return name.word == word; }
  static LawChoice choose(const LawValues &values)
  {
    const FallingFriction falling{values["friction.mu0"], values["friction.A"],
                                  values["friction.B"]};
    LawChoice choice;
    choice.read = [falling] { return std::make_shared<PolachLaw>(falling); };
    return choice;
  }

  explicit PolachLaw(const FallingFriction &falling) : falling_(falling) {}

  Eigen::VectorXd mu(const FrictionState &state) const override
  {
    return Eigen::VectorXd::Constant(state.pressure.size(), falling_(std::abs(state.slidingSpeed)));
  }
  bool dependsOnSpeed() const override { return true; }
  bool dependsOnTemperature() const override { return false; }
  nlohmann::ordered_json json() const override
  {
    return {{"format", word}, {"mu0", falling_.mu0}, {"A", falling_.A}, {"B_s_m", falling_.B}};
  }

 private:
  FallingFriction falling_;
};

} // namespace wheelrail
#endif
