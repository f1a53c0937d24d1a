// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_FIT_ANALYSIS_H
#define WHEELRAIL_FIT_FIT_ANALYSIS_H

#include "fit/fit_condition.h"
#include "fit/friction_run.h"
#include "fit/law_fit.h"
#include "fit/seed_scatter.h"
#include "law/mu_table.h"
#include "law/softening_material.h"

#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// What wr_fit is asked for beside the logs.
/// Kappas are pure numbers: kappa2 = p E/sigma_0^2, kappa3 = E/sigma_0.
struct FitOptions {
  /// What `fit` is; the comparison runs through all models.
  LawModel model = LawModel::Full;
  double level = 0.95;          ///< of the confidence intervals
  double reference = 0.0;       ///< of a model with a power; 0: geometric mean of the conditions
  double kappa2Min = 2.0;       ///< runs below are left out (the paper's rule)
  bool includeDrifting = false; ///< fit runs without a stationary part too
  bool solidOnly = false;       ///< leave out runs whose automata sank into each other
  /// The material that all runs are of: the law is one of it, and may be bounded by its strength.
  std::optional<SofteningMaterial> material;
  bool table = false; ///< with a material: the law is a table of all conditions, `model` unused
};

/// A bounded model and a table are of a material; a power of the ductility is not.
/// \param hasMaterial one is given, read or not
/// \param model, material as the user named them: "--model bounded", "--material"
/// \throws Error (Usage) where they do not go together
void checkMaterial(const FitOptions &options, bool hasMaterial, const std::string &model,
                   const std::string &material);
/// Takes the value of kappa3, or of the ductility, at which a law with its power is to hold.
/// \param option as the user named it
/// \throws Error (Usage) where the model of the options has no such power
void takeReference(FitOptions &options, ThirdNumber number, double value,
                   const std::string &option);

/// One line of the model comparison.
/// Compared by AICc over the same conditions: the smaller, the better.
struct ModelComparison {
  LawModel model = LawModel::Full;
  std::optional<LawFit> fit;
  /// Empty if it was; a fit whose parameters cannot be told apart counts as none.
  std::string whyNot; ///< why it could not be fitted
};

/// Everything that wr_fit finds out.
/// A second log of the same run is left out, so that it does not count twice: the longer one stays.
struct FitAnalysis {
  FitOptions options;
  std::vector<FrictionRun> runs; ///< all; leftOut says which are not fitted
  /// Between the runs of a condition, for each set of laws; part of muSe of the runs.
  std::vector<SeedScatter> seeds;
  /// What is fitted: the runs that are not left out, replicas as one.
  std::vector<FitCondition> conditions;
  std::optional<LawFit> fit;    ///< its vectors run over the conditions
  std::optional<MuTable> table; ///< in its place, where that is asked for
  std::string whyNot;           ///< why there is no law
  std::string mixture;          ///< one line if runs of other laws or programs are taken together
  /// There are enough conditions, but they do not determine the parameters.
  bool notIdentifiable = false;
  /// All of `lawModels`, of a material `boundedModels` too, in their order.
  std::vector<ModelComparison> models;

  /// The means of the conditions, in order.
  std::vector<ConditionMean> fitted() const;
};

/// Marks the runs to leave out, fits, compares models. That a law cannot be fitted is no error:
/// `whyNot` says why, and the comparison holds the models that can.
/// \param runs of `frictionRun`, at least one
/// \param options of the command line, ranges checked there
/// \return with either `fit`, `table` or `whyNot`, and one comparison for each model
/// \throws Error (BadInput) as `placeInMaterial`
FitAnalysis analyseRuns(std::vector<FrictionRun> runs, const FitOptions &options);

} // namespace wheelrail

#endif
