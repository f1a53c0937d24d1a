#include "fit/fit_analysis.h"

#include "base/errors.h"

#include <cmath>
#include <fmt/format.h>
#include <set>

namespace wheelrail {

namespace {

std::string whyLeftOut(const FrictionPoint &point, const FitOptions &options)
{
  if (point.kappa2 < options.kappa2_min)
    return fmt::format("kappa2 = {:.3g} < {:.3g}", point.kappa2, options.kappa2_min);
  if (!point.stationary() && !options.include_drifting)
    return "no stationary part";
  if (!std::isfinite(point.mu_se))
    return "too few rows for a standard error";
  if (point.mu <= 0.0)
    return "mu is not positive";
  return "";
}

/// A run that has two logs would count as two independent ones: the longer log stays, of equal ones
/// the first. To be settled before anything else is asked of a point: where the longer log drifts,
/// the shorter one does not show it.
void leaveOutCopies(std::vector<FrictionPoint> &points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      auto &first = points[i], &second = points[j];
      if (!first.left_out.empty() || !second.left_out.empty() || !sameRun(first, second))
        continue;
      const bool longer = second.duration > first.duration;
      (longer ? first : second).left_out =
          fmt::format("the run of {}", (longer ? second : first).file);
    }
}

/// In what the runs that are fitted differ though a law should not, with two examples.
std::string mixtureOf(const std::vector<FrictionPoint> &points)
{
  const FrictionPoint *first = nullptr, *other = nullptr;
  std::set<std::string> differing;
  const auto compare = [&](const FrictionPoint &a, const FrictionPoint &b) {
    for (const auto &[entry, value] : a.made_by) {
      const auto found = b.made_by.find(entry);
      if (found == b.made_by.end() || found->second != value)
        differing.insert(entry);
    }
  };
  for (const auto &p : points) {
    if (!p.left_out.empty())
      continue;
    if (!first)
      first = &p;
    compare(*first, p);
    compare(p, *first);
    if (!other && !differing.empty())
      other = &p;
  }
  if (!other)
    return "";
  return fmt::format("runs that differ in {} are taken together, such as {} and {}",
                     fmt::join(differing, ", "), first->file, other->file);
}

} // namespace

std::vector<LawPoint> FitAnalysis::fitted() const
{
  std::vector<LawPoint> result;
  for (const auto &p : points)
    if (p.left_out.empty())
      result.push_back({p.kappa1, p.kappa2, p.mu, p.mu_se, p.kappa3});
  return result;
}

FitAnalysis analysePoints(std::vector<FrictionPoint> points, const FitOptions &options)
{
  FitAnalysis analysis;
  analysis.options = options;
  analysis.points = std::move(points);
  leaveOutCopies(analysis.points);
  for (auto &p : analysis.points)
    if (p.left_out.empty())
      p.left_out = whyLeftOut(p, options);
  analysis.mixture = mixtureOf(analysis.points);

  const auto used = analysis.fitted();
  const auto obstacle = obstacleTo(options.model, used);
  if (obstacle.reason.empty()) {
    try {
      auto fit = fitLaw(options.model, used, options.level, options.kappa3);
      analysis.why_not = fit.not_identifiable;
      if (fit.not_identifiable.empty())
        analysis.fit = std::move(fit);
    } catch (const Error &error) {
      analysis.why_not = error.what();
    }
  } else {
    analysis.why_not = obstacle.reason;
  }
  analysis.not_identifiable = !analysis.fit && !obstacle.tooFew;

  for (LawModel model : lawModels) {
    ModelComparison entry;
    entry.model = model;
    entry.why_not = obstacleTo(model, used).reason;
    if (entry.why_not.empty()) {
      try {
        entry.fit = fitLaw(model, used, 0.0, options.kappa3);
        entry.why_not = entry.fit->not_identifiable;
        if (!entry.why_not.empty())
          entry.fit.reset();
      } catch (const Error &error) {
        entry.why_not = error.what();
      }
    }
    analysis.models.push_back(std::move(entry));
  }
  return analysis;
}

} // namespace wheelrail
