// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_FRICTION_LAW_H
#define WHEELRAIL_LAW_FRICTION_LAW_H

#include "law/law_use.h"
#include "law/strength.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace wheelrail {

class FrictionLaw;
/// A law that solvers on several threads share; it never changes.
using LawPointer = std::shared_ptr<const FrictionLaw>;
/// Makes a law of standard normal numbers, one for each parameter.
using LawDraws = std::function<LawPointer(const Eigen::VectorXd &)>;

/// What a contact knows when it asks for mu; SI units. Holds references: for the call only.
struct FrictionState {
  const Eigen::VectorXd &pressure;    ///< Pa, >= 0, one value a cell
  double slidingSpeed;                ///< m/s, of the whole contact; its sign does not count
  const Eigen::VectorXd &temperature; ///< rise, K, one value a cell
};

/// A friction law as a contact uses it, whatever it is made of. Those that there are stand in
/// law/forms/, and `law/friction_laws.h` lists them. A law is asked for all cells of a contact at a
/// time, so that no loop over cells makes a virtual call.
class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;
  FrictionLaw &operator=(const FrictionLaw &) = delete;

  /// The friction coefficient.
  /// \return mu > 0, one value a cell
  /// \throws Error (NotConverged) where the law gives mu <= 0: it does not hold that far from the
  ///         conditions it was fitted to
  virtual Eigen::VectorXd mu(const FrictionState &state) const = 0;

  /// Does mu depend on the sliding speed? Where forces are given, creep and mu are then found
  /// together.
  virtual bool dependsOnSpeed() const = 0;
  /// Does mu depend on the temperature? Then heat acts back on friction.
  virtual bool dependsOnTemperature() const = 0;
  /// May mu grow with the temperature? Then a contact may settle cold or hot.
  virtual bool growsWithTemperature() const { return false; }
  /// Does mu depend on sigma_0? Then a temperature that leaves no strength is no solution.
  virtual bool dependsOnStrength() const { return dependsOnTemperature(); }

  /// sigma_0 of the law's own material over the temperature rise; null: the law has none, and the
  /// case says it. Lives as long as the law.
  virtual const Strength *strength() const { return nullptr; }

  /// What the law is a function of, with the ranges it is known on. Empty: nothing that it could be
  /// used outside of.
  virtual std::vector<LawInput> inputs() const { return {}; }
  /// Where a contact asks for mu: a range for each of `inputs`; none where nothing touches.
  virtual LawUse use(const FrictionState & /*state*/) const { return {}; }
  /// One line that tells, with both ranges, what of a use lies outside of what the law is known on;
  /// empty where nothing does.
  virtual std::string warning(const LawUse & /*use*/) const { return ""; }

  /// The law as a summary tells it.
  virtual nlohmann::ordered_json json() const = 0;
  /// A line for the user about the file that the law was read from; mostly empty.
  virtual std::string note() const { return ""; }

  /// Standard errors of the parameters, which `fitted_law.h` takes from a covariance with all that
  /// follows; empty: none is known, and the rest is not asked for.
  virtual Eigen::VectorXd standardErrors() const { return {}; }
  /// The law with its parameters changed. \param change to be added to them, in their order
  virtual LawPointer changed(const Eigen::VectorXd &change) const;
  /// Variance of a result, to first order. \param derivative of the result by the parameters
  virtual double variance(const Eigen::VectorXd &derivative) const;
  /// Laws drawn from the normal distribution with the covariance; for as long as this one lives.
  virtual LawDraws draws() const;
  /// Are the parameters where the formula of the law holds, such as b, c >= 0? A derivative needs
  /// no more; mu > 0 is not asked for.
  virtual bool isDefined() const { return true; }
  /// Are the parameters those of a law at all? If not, draws from the covariance are drawn again.
  virtual bool isSound() const { return true; }
  /// What `isSound` asks for, for a message: "b, c >= 0, mu > 0".
  virtual const char *soundness() const { return "mu > 0"; }

 protected:
  FrictionLaw() = default;
  FrictionLaw(const FrictionLaw &) = default;
};

/// Where a law was used, for a summary: the ranges by their keys, in the order of the alphabet.
/// \param use of this law, not empty
nlohmann::ordered_json toJson(const FrictionLaw &law, const LawUse &use);

} // namespace wheelrail
#endif
