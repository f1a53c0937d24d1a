// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/fit_report.h"

#include "fit/replicates.h"
#include "fit/run_columns.h"
#include "law/material_law.h"
#include "shared/printable.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace wheelrail {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *reportFormat = "mca-friction-report 1";

double standardError(const LawFit &fit, int k)
{
  return std::sqrt(fit.covariance(k, k));
}

/// Number of runs that are fitted.
std::size_t runsOf(const FitAnalysis &analysis)
{
  std::size_t runs = 0;
  for (const auto &condition : analysis.conditions)
    runs += condition.runs.size();
  return runs;
}

/// Ranges of what the fitted runs were made of, by the names and in the units of
/// `fittedQuantities`.
std::map<std::string, Range> fittedOn(const FitAnalysis &analysis)
{
  std::map<std::string, Range> ranges;
  for (const auto &condition : analysis.conditions) {
    const FrictionRun &run = analysis.runs[condition.runs.front()];
    for (const char *name : fittedQuantities) {
      const double value = std::abs(runColumn(name).get(run)); // a velocity may be negative
      const auto range = ranges.try_emplace(name, Range{value, value}).first;
      range->second = {std::min(range->second[0], value), std::max(range->second[1], value)};
    }
  }
  return ranges;
}

/// JSON has no nan and no infinity.
Json finite(double x)
{
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

double leastAicc(const FitAnalysis &analysis)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto &m : analysis.models)
    if (m.fit)
      least = std::min(least, m.fit->aicc);
  return least;
}

/// Our conditions against the paper's law: root mean square and mean of mu/Eq. 2 - 1.
struct AgainstPaper {
  int n = 0;
  double rms = 0.0;
  double mean = 0.0;
};

AgainstPaper againstPaper(const FitAnalysis &analysis)
{
  AgainstPaper result;
  for (const auto &condition : analysis.conditions) {
    const double paper = analysis.runs[condition.runs.front()].muEq2;
    const double difference = condition.mean.mu / paper - 1.0;
    ++result.n;
    result.mean += difference;
    result.rms += difference * difference;
  }
  if (result.n == 0)
    return result;
  result.mean /= result.n;
  result.rms = std::sqrt(result.rms / result.n);
  return result;
}

/// A number of the report; what is none is "-".
std::string shown(const char *format, double x)
{
  return std::isfinite(x) ? fmt::format(fmt::runtime(format), x) : "-";
}

std::string runLines(const FitAnalysis &analysis)
{
  size_t width = 4;
  for (const auto &run : analysis.runs)
    width = std::max(width, mcawr::printable(run.file).size());
  std::string text = fmt::format(
      "{:<{}} {:>9} {:>9} {:>7} {:>7} {:>6} {:>8} {:>8} {:>7} {:>8} {:>7} {:>6} {:>5} {:>6}\n",
      "file", width, "kappa1", "kappa2", "mu", "+-", "n_eff", "t_start", "grinding", "Eq. 2",
      "slid, nm", "gap, nm", "room", "lost", "smooth");
  for (const auto &run : analysis.runs) {
    text += fmt::format("{:<{}} {:>9.4g} {:>9.4g} {:>7.4f} {:>7} {:>6.0f} {:>8} {:>8} {:>7.4f}",
                        mcawr::printable(run.file), width, run.kappa1, run.kappa2, run.mu,
                        shown("{:.4f}", run.muSe), run.nEff, shown("{:.4g}", run.tStart),
                        shown("{:.4f}", run.muGrindingIn), run.muEq2);
    text += fmt::format(" {:>8.4g} {:>7.2f} {:>6} {:>5} {:>4.0f} %", run.health.distance,
                        run.health.gap, shown("{:.3f}", run.health.room),
                        shown("{:.0f}", run.health.lost), 100.0 * run.health.smooth);
    if (!run.note.empty())
      text += "  " + mcawr::printable(run.note);
    if (!run.leftOut.empty())
      text += fmt::format("  [left out: {}]", mcawr::printable(run.leftOut));
    text += "\n";
  }
  return text;
}

} // namespace

std::vector<std::string> warningsOf(const FitAnalysis &analysis)
{
  std::vector<std::pair<std::string, const RunHealth *>> runs;
  for (const auto &run : analysis.runs)
    runs.emplace_back(run.file, &run.health);
  return healthWarnings(runs);
}

namespace {

std::string replicateLines(const FitAnalysis &analysis)
{
  std::string text;
  for (const auto &g : replicateGroups(analysis.runs))
    text += fmt::format("Equal kappas: kappa1 {:.4g}, kappa2 {:.4g}: {} runs, mu {:.4f}, scatter "
                        "{:.1f} % (their errors explain {:.1f} %)\n",
                        g.kappa1, g.kappa2, g.n, g.mu, 100.0 * g.scatter, 100.0 * g.expected);
  return text;
}

std::string intervalText(const Interval &interval)
{
  const auto end = [](double value, bool open) {
    const bool bounded = std::isfinite(value);
    return open ? (bounded ? fmt::format("open at {:.4g}", value) : "open")
                : fmt::format("{:.4g}", value);
  };
  return end(interval.lower, interval.lowerOpen) + " .. " + end(interval.upper, interval.upperOpen);
}

/// How the seeds differ, or that it is not known; a line for each set of laws and each packing.
std::string seedLines(const FitAnalysis &analysis)
{
  std::string text;
  for (const SeedScatter &seeds : analysis.seeds) {
    if (analysis.seeds.size() > 1)
      text += fmt::format("Laws and packing of {}: ",
                          mcawr::printable(analysis.runs[seeds.runs[0]].file));
    text +=
        seeds.conditions == 0
            ? "No condition has two seeds: each error is what one run knows of itself, and not "
              "what another seed would differ by\n"
            : fmt::format("Seeds differ by {:.1f} % of mu beyond what each run knows of itself "
                          "({} condition{}, {} degree{} of freedom); every error holds it\n",
                          100.0 * seeds.share, seeds.conditions, seeds.conditions == 1 ? "" : "s",
                          seeds.freedom, seeds.freedom == 1 ? "" : "s");
  }
  return text;
}

Json seedsJson(const std::vector<SeedScatter> &all)
{
  Json json = Json::array();
  for (const SeedScatter &seeds : all)
    json.push_back({{"conditions", seeds.conditions},
                    {"freedom", seeds.freedom},
                    {"scatter", seeds.conditions > 0 ? Json(seeds.share) : Json(nullptr)},
                    {"runs", seeds.runs}});
  return json;
}

/// "a.friction and 2 other seeds"
std::string filesOf(const FitAnalysis &analysis, const FitCondition &condition)
{
  const std::string first = mcawr::printable(analysis.runs[condition.runs.front()].file);
  const std::size_t others = condition.runs.size() - 1;
  return others == 0 ? first
                     : fmt::format("{} and {} other seed{}", first, others, others == 1 ? "" : "s");
}

std::string fitLines(const FitAnalysis &analysis)
{
  const auto &fit = *analysis.fit;
  const auto free = parametersOf(fit.model);
  std::string formula = "mu0";
  if (free[1])
    formula += " + mu1 kappa1/(1 + b kappa1)";
  if (free[2])
    formula += " + mu2/(1 + c kappa2)";
  if (fit.reference > 0.0)
    formula =
        fmt::format("[{}] ({}/{:.5g})^n", formula, nameOf(thirdNumberOf(fit.model)), fit.reference);
  if (free[S])
    formula = fmt::format("(B^-q + ({} sigma_0/p)^-q)^(-1/q), B = {}",
                          free[S1] ? "[s + s1 kappa1/(1 + d kappa1)]" : "s", formula);
  std::string text =
      fmt::format("Fit of {}: mu = {}, {} conditions\n", nameOf(fit.model), formula, fit.law.n);
  const KappaLaw paper = bucher2006();
  const std::array<double, 6> papers = {paper.mu0, paper.mu1, paper.mu2, paper.b, paper.c, 0.0};
  for (int k = 0; k < fitParameters; ++k) {
    if (!free[k])
      continue;
    const std::string error =
        fit.atBound[k] ? "at its bound" : fmt::format("+- {:.3g}", standardError(fit, k));
    text += fmt::format("  {:<4} = {:>9.5g} {:<12} {:g} % interval {}{}\n", parameterNames[k],
                        fit.parameters[k], error, 100.0 * analysis.options.level,
                        intervalText(fit.intervals[k]),
                        k < S ? fmt::format("; paper {:.5g}", papers[k]) : "");
  }
  text +=
      fmt::format("  RMS of (mu - fit)/fit {:.2f} %, scatter beyond the standard errors {:.2f} %,"
                  " chi^2 {:.4g} with {} degrees of freedom, condition number {:.4g}\n",
                  100.0 * fit.law.rmsRelative, 100.0 * fit.scatter, fit.chiSquared, fit.freedom,
                  fit.conditionNumber);
  std::string outliers;
  for (size_t i = 0; i < analysis.conditions.size(); ++i) {
    if (std::abs(fit.studentised[i]) <= outlierLimit)
      continue;
    const FitCondition &condition = analysis.conditions[i];
    const double mu = condition.mean.mu;
    outliers += fmt::format("  outlier: {}: mu {:.4f}, fit {:.4f}, {:.1f} standard deviations\n",
                            filesOf(analysis, condition), mu, mu / (1.0 + fit.residuals[i]),
                            fit.studentised[i]);
  }
  return text + (outliers.empty()
                     ? fmt::format("  no outlier beyond {:.0f} standard deviations\n", outlierLimit)
                     : outliers);
}

/// mu over p/sigma_0 and temperature.
std::string tableLines(const MuTable &table)
{
  std::string text =
      fmt::format("Table of mu at {:g} m/s, p/sigma_0 in brackets\n", table.speed.reference);
  for (const MuTable::Row &row : table.rows) {
    text += fmt::format("  {:>6g} K", row.temperature);
    for (std::size_t k = 0; k < row.mu.size(); ++k)
      text += fmt::format("  [{:.3g}] {:.3f} +- {:.3f}", row.ratio[k], row.mu[k], row.muSe[k]);
    text += "\n";
  }
  const MuTable::SpeedPower &speed = table.speed;
  if (!speed.ratio.empty())
    text += fmt::format("  mu goes like v^m, {:g} to {:g} m/s, m:", speed.range[0], speed.range[1]);
  for (std::size_t k = 0; k < speed.ratio.size(); ++k)
    text += fmt::format("  [{:.3g}] {:.3f} +- {:.3f}", speed.ratio[k], speed.exponent[k],
                        speed.exponentSe[k]);
  text += speed.ratio.empty() ? "" : "\n";
  return text;
}

std::string modelLines(const FitAnalysis &analysis)
{
  std::string text = "Models (AICc relative to the best; more than 10 above it: no support)\n";
  const double least = leastAicc(analysis);
  for (const auto &m : analysis.models) {
    text += fmt::format("  {:<{}}", nameOf(m.model), analysis.options.material ? 17 : 15);
    if (m.fit)
      text += fmt::format(" RMS {:>6.2f} %  AICc {:>8}\n", 100.0 * m.fit->law.rmsRelative,
                          shown("{:+.1f}", m.fit->aicc - least));
    else
      text += fmt::format(" not fitted: {}\n", m.whyNot);
  }
  return text;
}

Json valueOf(const RunColumn &column, const FrictionRun &run)
{
  const double value = column.get(run);
  return column.whole ? Json(static_cast<long>(value)) : finite(value);
}

Json runJson(const FrictionRun &run)
{
  Json json;
  json["file"] = run.file;
  for (const RunColumn &column : runColumns())
    if (column.report != InReport::No)
      json[column.name] = valueOf(column, run);
  json["strengths"] = run.health.strengths;
  json["note"] = run.note;
  json["left_out"] = run.leftOut;
  return json;
}

/// What a condition's runs share, their mean, and what the fit makes of it.
Json conditionJson(const FitAnalysis &analysis, std::size_t i)
{
  const FitCondition &condition = analysis.conditions[i];
  Json json;
  for (const RunColumn &column : runColumns())
    if (column.report == InReport::AndConditions)
      json[column.name] = valueOf(column, analysis.runs[condition.runs.front()]);
  json["mu"] = condition.mean.mu;
  json["mu_se"] = condition.mean.muSe;
  json["own_error"] = condition.ownError;
  json["scatter"] = finite(condition.scatter);
  json["runs"] = condition.runs;
  if (analysis.options.material)
    json["temperature"] = analysis.runs[condition.runs.front()].temperature;
  if (!analysis.fit)
    return json;
  json["residual"] = analysis.fit->residuals[i];
  json["studentised"] = analysis.fit->studentised[i];
  json["leverage"] = analysis.fit->leverage[i];
  json["outlier"] = std::abs(analysis.fit->studentised[i]) > outlierLimit;
  return json;
}

Json fitJson(const FitAnalysis &analysis)
{
  const auto &fit = *analysis.fit;
  const auto free = parametersOf(fit.model);
  Json json;
  json["model"] = nameOf(fit.model);
  json["level"] = analysis.options.level;
  if (fit.reference > 0.0)
    json[nameOf(thirdNumberOf(fit.model))] = fit.reference;
  for (int k = 0; k < fitParameters; ++k) {
    if (!free[k])
      continue;
    Json entry;
    entry["value"] = fit.parameters[k];
    entry["standard_error"] = standardError(fit, k);
    entry["interval"] = {finite(fit.intervals[k].lower), finite(fit.intervals[k].upper)};
    entry["open"] = {fit.intervals[k].lowerOpen, fit.intervals[k].upperOpen};
    entry["at_bound"] = fit.atBound[k];
    json["parameters"][parameterNames[k]] = entry;
  }
  json["scatter"] = fit.scatter;
  json["chi_squared"] = fit.chiSquared;
  json["freedom"] = fit.freedom;
  json["condition_number"] = fit.conditionNumber;
  json["aicc"] = finite(fit.aicc);
  return json;
}

Json reportBody(const FitAnalysis &analysis)
{
  Json report;
  report["program"] = fmt::format("wr_fit {}", WHEELRAIL_VERSION);
  report["units"] = {{"time", "ns"}, {"stress", "MPa"}, {"velocity", "m/s"}, {"viscosity", "Pa s"}};
  report["kappa2_min"] = analysis.options.kappa2Min;
  if (!analysis.mixture.empty())
    report["warning"] = analysis.mixture;
  report["warnings"] = warningsOf(analysis);
  report["points"] = Json::array();
  for (const auto &run : analysis.runs)
    report["points"].push_back(runJson(run));
  report["seeds"] = seedsJson(analysis.seeds);
  report["conditions"] = Json::array();
  for (size_t i = 0; i < analysis.conditions.size(); ++i)
    report["conditions"].push_back(conditionJson(analysis, i));
  const auto paper = againstPaper(analysis);
  report["against_eq2"] = {{"n", paper.n}, {"rms_relative", paper.rms}, {"mean", paper.mean}};
  report["equal_kappas"] = Json::array();
  for (const auto &g : replicateGroups(analysis.runs))
    report["equal_kappas"].push_back({{"kappa1", g.kappa1},
                                      {"kappa2", g.kappa2},
                                      {"n", g.n},
                                      {"mu", g.mu},
                                      {"scatter", g.scatter},
                                      {"expected", g.expected}});
  if (analysis.fit)
    report["fit"] = fitJson(analysis);
  const double least = leastAicc(analysis);
  report["models"] = Json::array();
  for (const auto &m : analysis.models) {
    Json entry;
    entry["model"] = nameOf(m.model);
    if (m.fit) {
      entry["rms_relative"] = m.fit->law.rmsRelative;
      entry["aicc"] = finite(m.fit->aicc);
      entry["delta_aicc"] = finite(m.fit->aicc - least);
    } else {
      entry["why_not"] = m.whyNot;
    }
    report["models"].push_back(entry);
  }
  return report;
}

std::string sourceOf(const FitAnalysis &analysis, const char *model)
{
  return fmt::format("wr_fit {}, {} conditions from {} of {} runs, model {}", WHEELRAIL_VERSION,
                     analysis.conditions.size(), runsOf(analysis), analysis.runs.size(), model);
}

/// The law of the material, where all runs are of one.
MaterialLaw lawOfMaterial(const FitAnalysis &analysis)
{
  MaterialLaw law;
  law.material = *analysis.options.material;
  law.n = static_cast<int>(analysis.conditions.size());
  law.fittedOn = fittedOn(analysis);
  const auto widen = [](std::optional<Range> &range, double value) {
    range = range ? Range{std::min((*range)[0], value), std::max((*range)[1], value)}
                  : Range{value, value};
  };
  for (const FitCondition &condition : analysis.conditions) {
    const FrictionRun &run = analysis.runs[condition.runs.front()];
    widen(law.pressureRange, condition.mean.kappa2 / condition.mean.kappa3);
    widen(law.temperatureRange, run.temperature);
    widen(law.speedRange, std::abs(run.head.velocity));
  }
  if (analysis.table) {
    law.table = analysis.table;
    law.source = sourceOf(analysis, "table");
    return law;
  }
  const LawFit &fit = *analysis.fit;
  law.parameters = fit.parameters;
  law.covariance = fit.covariance;
  if (fit.reference > 0.0)
    law.kappa3 = fit.reference;
  law.rmsRelative = fit.law.rmsRelative;
  law.source = sourceOf(analysis, nameOf(fit.model));
  return law;
}

} // namespace

std::string textReport(const FitAnalysis &analysis)
{
  auto text = runLines(analysis);
  if (const auto n = analysis.conditions.size(); n > 0)
    text += fmt::format("{} run{} of {} condition{}; those that differ in the seed only are one "
                        "condition\n",
                        runsOf(analysis), runsOf(analysis) == 1 ? "" : "s", n, n == 1 ? "" : "s") +
            seedLines(analysis);
  const auto paper = againstPaper(analysis);
  if (paper.n > 0)
    text += fmt::format("Against Eq. 2 with the paper's numbers: RMS {:.1f} %, mean {:+.1f} % ({} "
                        "condition{})\n",
                        100.0 * paper.rms, 100.0 * paper.mean, paper.n, paper.n == 1 ? "" : "s");
  text += replicateLines(analysis);
  if (analysis.fit)
    text += fitLines(analysis);
  else if (analysis.table)
    text += tableLines(*analysis.table);
  else
    text += fmt::format("No law fitted: {}.\n", mcawr::printable(analysis.whyNot));
  if (analysis.fit || analysis.table || analysis.notIdentifiable)
    text += modelLines(analysis);
  return text;
}

Json jsonReport(const FitAnalysis &analysis)
{
  Json json;
  if (analysis.options.material && (analysis.fit || analysis.table)) {
    json = toJson(lawOfMaterial(analysis));
  } else if (analysis.fit) {
    KappaLaw law = analysis.fit->law;
    law.source = sourceOf(analysis, nameOf(analysis.fit->model));
    law.fittedOn = fittedOn(analysis);
    if (analysis.fit->reference > 0.0)
      law.source += fmt::format(" at {} = {:.8g}", nameOf(thirdNumberOf(analysis.fit->model)),
                                analysis.fit->reference);
    json = toJson(law);
  } else {
    json["format"] = reportFormat;
    json["reason"] = analysis.whyNot;
  }
  json["report"] = reportBody(analysis);
  return json;
}

} // namespace wheelrail
