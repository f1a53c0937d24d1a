#ifndef WHEELRAIL_FIT_FIT_ANALYSIS_H
#define WHEELRAIL_FIT_FIT_ANALYSIS_H

#include "fit/friction_point.h"
#include "fit/law_fit.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

struct FitOptions {
  LawModel model = LawModel::Full;
  double level = 0.95;           ///< of the confidence intervals
  double kappa3 = 0.0;           ///< reference of the model Kappa3; 0: geometric mean of the points
  double kappa2_min = 2.0;       ///< points below are left out (the paper's rule)
  bool include_drifting = false; ///< fit points without a stationary part too
};

/// One line of the model comparison.
struct ModelComparison {
  LawModel model = LawModel::Full;
  std::optional<LawFit> fit;
  std::string why_not; ///< why it could not be fitted
};

/// Everything that wr_fit finds out.
struct FitAnalysis {
  FitOptions options;
  std::vector<FrictionPoint> points; ///< all; left_out says which are not fitted
  std::optional<LawFit> fit;         ///< its vectors run over the points that are not left out
  std::string why_not;               ///< why there is no fit
  std::string mixture; ///< one line if runs of other laws or programs are taken together
  /// There are enough points, but they do not determine the parameters.
  bool not_identifiable = false;
  std::vector<ModelComparison> models;

  /// The points that are fitted, in order.
  std::vector<LawPoint> fitted() const;
};

/// Marks the points to leave out, fits, compares models.
FitAnalysis analysePoints(std::vector<FrictionPoint> points, const FitOptions &options);

/// The report for people.
std::string textReport(const FitAnalysis &analysis);

/// The law file (format "mca-friction-law 1", with everything else under "report"), or, when no law
/// was fitted, the same report under format "mca-friction-report 1" with the reason.
nlohmann::ordered_json jsonReport(const FitAnalysis &analysis);

} // namespace wheelrail

#endif
