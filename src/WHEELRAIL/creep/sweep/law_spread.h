// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_LAW_SPREAD_H
#define WHEELRAIL_CREEP_SWEEP_LAW_SPREAD_H

#include "law/friction_law.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail {

/// How a law's covariance is carried through to a result.
/// Linear is exact to first order in the standard errors, symmetric, and costs two results for each
/// parameter that has one; Sampled shows asymmetry too and costs `samples` results.
enum class UncertaintyMethod { Linear, Sampled };

/// How many laws stand for the spread.
/// Both numbers are read by the sampled method only.
struct SpreadSpecification {
  UncertaintyMethod method = UncertaintyMethod::Linear;
  int samples = 0;        ///< Sampled: laws drawn, > 1
  std::uint64_t seed = 0; ///< Sampled: alone decides the draws
};

/// What the uncertainty of the law makes of a result; in the result's unit.
/// Linear: half-width 1.96 standard errors; Sampled: quantiles.
struct Band {
  double standardError = 0.0;   ///< >= 0; 0 without a covariance
  double low = 0.0, high = 0.0; ///< 95 % interval
};

/// A law and others near it, with which a result is computed again to see how well the law
/// determines it. Linear: the law with each parameter a tenth of its standard error up and down;
/// the law itself without a standard error, and on a side that `FrictionLaw::isDefined` refuses.
/// The band is that of the derivatives and the covariance. Sampled: draws from the normal
/// distribution with the law's covariance; the band is their standard deviation and quantiles.
/// Draws that are no law (`FrictionLaw::isSound`) are drawn again.
class LawSpread {
 public:
  /// Just the law: no band.
  explicit LawSpread(LawPointer law) : variants_{std::move(law)} {}
  /// \param law its covariance is used, if it has one
  /// \throws Error (NotConverged) when hardly any draw is a law
  LawSpread(const SpreadSpecification &specification, const LawPointer &law);

  /// The law itself first. Just that one if it has no covariance. Where the same object stands
  /// again its result is known.
  const std::vector<LawPointer> &laws() const { return variants_; }
  /// Does the band depend on the result with a law? Not for those of a parameter that is left out.
  /// \param k  place in `laws()`
  bool counts(std::size_t k) const
  {
    return k == 0 || distances_.size() == 0 ||
           distances_[static_cast<Eigen::Index>(k - 1) / 2] > 0.0;
  }
  /// Does the law have a covariance to be carried through?
  bool any() const { return variants_.size() > 1; }
  /// \param results the quantity in question, computed with each of `laws()`, in their order
  /// \return in the unit of `results`
  Band band(const std::vector<double> &results) const;
  /// Share of the draws that were drawn again.
  /// 0 with the linear method. A large share says that the covariance reaches far into what is no
  /// law.
  double redrawn() const { return redrawnShare_; }
  /// A line for the user about parameters that the linear band leaves out; mostly empty.
  std::string warning() const;

 private:
  /// Two laws for each parameter, up and down.
  /// Where it ends between them, the law itself is one of both.
  void addNeighbours();
  /// Draws from the normal distribution, by the root of the correlation matrix.
  void addSamples(int samples, std::uint64_t seed);

  UncertaintyMethod method_ = UncertaintyMethod::Linear;
  std::vector<LawPointer> variants_;
  Eigen::VectorXd distances_; ///< Linear: of each parameter between its laws up and down
  double redrawnShare_ = 0.0;
};

} // namespace wheelrail
#endif
