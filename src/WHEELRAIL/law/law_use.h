// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_LAW_USE_H
#define WHEELRAIL_LAW_LAW_USE_H

#include "law/contact_friction.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace wheelrail {

/// Where contacts ask a law for mu: least and largest values over the cells in contact. kappa2 and
/// pressure leave out the half per cent of the load under the smallest and that under the largest
/// of them, so that the edges of a contact, where the pressure falls to 0, do not count.
struct LawUse {
  bool any = false; ///< false: a law that depends on nothing of this; the rest is 0
  Range kappa1{};   ///< of Eq. 2: 0 without its velocity term
  Range kappa2{};   ///< of Eq. 2
  Range kappa3{};   ///< of Eq. 2: E/sigma_0 at the temperatures that are reached
  Range pressure{}; ///< of a table: Pa
  Range speed{};    ///< of a table: sliding speed, m/s

  /// Widens the ranges by those of another contact.
  void include(const LawUse &other);
};

/// What one contact asks the law for.
/// @param pressure Pa, one value per cell; slidingSpeed m/s; temperature rise per cell, K
LawUse lawUse(const FrictionSpecification &friction, const Eigen::VectorXd &pressure,
              double slidingSpeed, const Eigen::VectorXd &temperature);

/// One line that tells, with both ranges, what lies outside of what the law was fitted on, or
/// beyond the table; empty where nothing does, or the law does not say what it was fitted on. A
/// fitted law may be passed by a tenth of the limit: its ranges are not known better.
std::string lawWarning(const FrictionSpecification &friction, const FrictionLaw &law,
                       const LawUse &use);

/// Of a summary: the ranges, in MPa and m/s. @param use with `any`
nlohmann::ordered_json toJson(const FrictionSpecification &friction, const LawUse &use);

} // namespace wheelrail

#endif
