// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_analysis.h"

#include "base/errors.h"
#include "fit/material_fit.h"

#include <cmath>
#include <fmt/format.h>
#include <set>

namespace wheelrail {

namespace {

std::string whyLeftOut(const FrictionRun &run, const FitOptions &options)
{
  if (options.solidOnly && run.health.room < run.health.leastRoom)
    return fmt::format("no solid: room {:.3f} < {:.3f}", run.health.room, run.health.leastRoom);
  if (run.kappa2 < options.kappa2Min)
    return fmt::format("kappa2 = {:.3g} < {:.3g}", run.kappa2, options.kappa2Min);
  if (!run.stationary() && !options.includeDrifting)
    return "no stationary part";
  if (!std::isfinite(run.muSe))
    return "too few rows for a standard error";
  if (run.mu <= 0.0)
    return "mu is not positive";
  return "";
}

/// A run that has two logs would count as two independent ones: the longer log stays, of equal ones
/// the first. To be settled before anything else is asked of a run: where the longer log drifts,
/// the shorter one does not show it.
void leaveOutCopies(std::vector<FrictionRun> &runs)
{
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = i + 1; j < runs.size(); ++j) {
      auto &first = runs[i], &second = runs[j];
      if (!first.leftOut.empty() || !second.leftOut.empty() || !sameRun(first, second))
        continue;
      const bool longer = second.duration > first.duration;
      (longer ? first : second).leftOut = fmt::format(
          "the run of {}{}", (longer ? second : first).file,
          first.seed() == second.seed() ? "" : ", whose other seed gave the same blocks");
    }
}

/// In what the runs that are fitted differ though a law should not, with two examples.
std::string mixtureOf(const std::vector<FrictionRun> &runs)
{
  const FrictionRun *first = nullptr, *other = nullptr;
  std::set<std::string> differing;
  const auto compare = [&](const FrictionRun &a, const FrictionRun &b) {
    for (const auto &[entry, value] : a.madeBy) {
      const auto found = b.madeBy.find(entry);
      if (found == b.madeBy.end() || found->second != value)
        differing.insert(entry);
    }
  };
  for (const auto &run : runs) {
    if (!run.leftOut.empty())
      continue;
    if (!first)
      first = &run;
    compare(*first, run);
    compare(run, *first);
    if (!other && !differing.empty())
      other = &run;
  }
  if (!other)
    return "";
  return fmt::format("runs that differ in {} are taken together, such as {} and {}",
                     fmt::join(differing, ", "), first->file, other->file);
}

/// The law of `options.model`, or why there is none.
void fitModel(FitAnalysis &analysis, const std::vector<ConditionMean> &used)
{
  const FitOptions &options = analysis.options;
  const auto obstacle = obstacleTo(options.model, used);
  if (obstacle.reason.empty()) {
    try {
      auto fit = fitLaw(options.model, used, options.level, options.reference);
      analysis.whyNot = fit.notIdentifiable;
      if (fit.notIdentifiable.empty())
        analysis.fit = std::move(fit);
    } catch (const Error &error) {
      analysis.whyNot = error.what();
    }
  } else {
    analysis.whyNot = obstacle.reason;
  }
  analysis.notIdentifiable = !analysis.fit && !obstacle.tooFew;
}

/// The table of all conditions, or why there is none.
void fitTable(FitAnalysis &analysis)
{
  if (analysis.conditions.empty()) {
    analysis.whyNot = "no condition is left for a table";
    return;
  }
  try {
    analysis.table = tableOf(analysis.conditions, analysis.runs);
  } catch (const Error &error) {
    analysis.whyNot = error.what();
    analysis.notIdentifiable = true;
  }
}

} // namespace

void checkMaterial(const FitOptions &options, bool hasMaterial, const std::string &model,
                   const std::string &material)
{
  if (!hasMaterial && (options.table || isBounded(options.model)))
    throw Error(ExitCode::Usage,
                fmt::format("{}: needs {}, whose strength it takes", model, material));
  if (hasMaterial && !options.table && thirdNumberOf(options.model) == ThirdNumber::Ductility)
    throw Error(
        ExitCode::Usage,
        fmt::format("{}: does not go with {}, which has one breaking strain: {} is the same", model,
                    material, nameOf(LawModel::Kappa3)));
}

void takeReference(FitOptions &options, ThirdNumber number, double value, const std::string &option)
{
  std::vector<std::string> having;
  const auto collect = [&](const auto &models) {
    for (const LawModel model : models)
      if (thirdNumberOf(model) == number)
        having.emplace_back(nameOf(model));
  };
  collect(lawModels);
  collect(boundedModels);
  if (options.table || thirdNumberOf(options.model) != number)
    throw Error(ExitCode::Usage,
                fmt::format("{}: goes with {}, not with {}", option, fmt::join(having, ", "),
                            options.table ? "table" : nameOf(options.model)));
  options.reference = value;
}

std::vector<ConditionMean> FitAnalysis::fitted() const
{
  std::vector<ConditionMean> result;
  for (const auto &condition : conditions)
    result.push_back(condition.mean);
  return result;
}

FitAnalysis analyseRuns(std::vector<FrictionRun> runs, const FitOptions &options)
{
  FitAnalysis analysis;
  analysis.options = options;
  analysis.runs = std::move(runs);
  if (options.material)
    placeInMaterial(analysis.runs, *options.material);
  leaveOutCopies(analysis.runs);
  for (auto &run : analysis.runs)
    if (run.leftOut.empty())
      run.leftOut = whyLeftOut(run, options);
  analysis.mixture = mixtureOf(analysis.runs);

  analysis.seeds = seedScatters(analysis.runs, conditionsOf(analysis.runs));
  for (const SeedScatter &scatter : analysis.seeds)
    addSeedScatter(analysis.runs, scatter);
  analysis.conditions = conditionsOf(analysis.runs);
  const auto used = analysis.fitted();
  if (options.table)
    fitTable(analysis);
  else
    fitModel(analysis, used);
  std::vector<LawModel> models(lawModels.begin(), lawModels.end());
  if (options.material)
    models.insert(models.end(), boundedModels.begin(), boundedModels.end());
  for (LawModel model : models) {
    ModelComparison entry;
    entry.model = model;
    entry.whyNot = obstacleTo(model, used).reason;
    if (entry.whyNot.empty()) {
      try {
        entry.fit = fitLaw(model, used, 0.0);
        entry.whyNot = entry.fit->notIdentifiable;
        if (!entry.whyNot.empty())
          entry.fit.reset();
      } catch (const Error &error) {
        entry.whyNot = error.what();
      }
    }
    analysis.models.push_back(std::move(entry));
  }
  return analysis;
}

} // namespace wheelrail
