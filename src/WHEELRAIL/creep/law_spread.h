#ifndef WHEELRAIL_CREEP_LAW_SPREAD_H
#define WHEELRAIL_CREEP_LAW_SPREAD_H

#include "creep/case_file.h"
#include "law/friction_law.h"

#include <vector>

namespace wheelrail {

/// What the uncertainty of the law makes of a result.
struct Band {
  double standardError = 0.0;
  double low = 0.0, high = 0.0; ///< 95 % interval
};

/// A law and others near it, with which a result is computed again to see how well the law
/// determines it. Linear: the law with each parameter a tenth of its standard error up and down;
/// the band is that of the derivatives and the covariance. Sampled: draws from the normal
/// distribution with the law's covariance; the band is their standard deviation and quantiles.
/// Draws that are no law, b or c < 0 (a pole) or mu <= 0 at some pressure within the fitted range
/// of kappa1, are drawn again. The case's uncertainty.seed alone decides the draws.
class LawSpread {
 public:
  /// @throws Error (NotConverged) when hardly any draw is a law
  LawSpread(const Case &input, const FrictionLaw &law);

  /// The law itself first. Just that one if it has no covariance.
  const std::vector<FrictionLaw> &laws() const { return variants; }
  bool any() const { return variants.size() > 1; }
  /// @param results one for each of `laws()`, in their order
  Band band(const std::vector<double> &results) const;
  /// Share of the draws that were drawn again.
  double redrawn() const { return redrawnShare; }

 private:
  void addNeighbours();
  void addSamples(int samples, std::uint64_t seed);

  UncertaintyMethod method;
  std::vector<FrictionLaw> variants;
  double redrawnShare = 0.0;
};

} // namespace wheelrail
#endif
