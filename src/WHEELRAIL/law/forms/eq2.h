// SPDX-License-Identifier: GPL-2.0-or-later
/// \file eq2.h
/// friction.law bucher2006, or a law file of wr_fit: Eq. 2 (law/kappa_law.h), in each cell or as
/// its mean over all pressures, for the steel of a contact.
#ifndef WHEELRAIL_LAW_FORMS_EQ2_H
#define WHEELRAIL_LAW_FORMS_EQ2_H

#include "law/fitted_law.h"
#include "law/kappa_law.h"
#include "law/law_choice.h"
#include "law/strength.h"

namespace wheelrail {

/// What scales Eq. 2 in a contact; SI units.
struct Eq2Scale {
  bool local = false;       ///< true: mu from the pressure of each cell; false: mean of the law
                            ///< over pressures from 0 to the hardness (Eq. 7)
  bool velocityTerm = true; ///< false: kappa1 = 0 whatever the sliding speed
  Strength strength;        ///< sigma_0 of kappa1, kappa2 and kappa3
  double modulus = 0.0;     ///< E of kappa1 and kappa2, Pa, > 0
  double density = 0.0;     ///< rho of kappa1, kg/m3, > 0
};

class Eq2Law : public FittedLaw<lawParameters> {
 public:
  static constexpr const char *word = "bucher2006";
  static constexpr const char *named = "bucher2006 (Eqs. 2, 3), or a law file of wr_fit";

  static std::vector<LawKeyword> keywords();
  /// Whatever no other law is named by: the last one of the list.
  static bool isNamedBy(const LawName & /*name*/) { return true; }
  static LawChoice choose(const LawValues &values);

  /// \param name of the law, for messages: bucher2006, or the path of its file
  Eq2Law(std::string name, KappaLaw law, const Eq2Scale &scale)
      : FittedLaw(law.covariance), name_(std::move(name)), law_(std::move(law)), scale_(scale)
  {
  }

  Eigen::VectorXd mu(const FrictionState &state) const override;
  bool dependsOnSpeed() const override { return scale_.velocityTerm; }
  bool dependsOnTemperature() const override { return true; }

  std::vector<LawInput> inputs() const override;
  LawUse use(const FrictionState &state) const override;
  /// A limit may be passed by a tenth: the ranges are not known better.
  std::string warning(const LawUse &use) const override;

  nlohmann::ordered_json json() const override;
  std::string note() const override { return law_.note; }

  /// \param change of mu0, mu1, mu2, b, c
  LawPointer changed(const Eigen::VectorXd &change) const override;
  /// b, c >= 0, that is no pole.
  bool isDefined() const override;
  /// And mu > 0 at every pressure within the fitted range of kappa1.
  bool isSound() const override;
  const char *soundness() const override { return "b, c >= 0, mu > 0"; }

 private:
  double kappa1At(double speed, double strength) const
  {
    return kappa1(scale_.density, scale_.modulus, speed, strength);
  }

  std::string name_;
  KappaLaw law_;
  Eq2Scale scale_;
};

} // namespace wheelrail
#endif
