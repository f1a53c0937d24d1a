// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_task.h"

#include "base/result_text.h"
#include "creep/patch/measured_fit.h"
#include "creep/patch/patch_report.h"
#include "creep/patch/patch_table.h"
#include "creep/patch/subsurface_report.h"
#include "creep/sweep/plausibility.h"

#include <filesystem>
#include <fmt/format.h>

namespace wheelrail {
namespace {

/// The table that goes with a file of parameters: its name with the ending ".csv".
std::string tableBeside(const std::string &path)
{
  return std::filesystem::path(path).replace_extension(".csv").string();
}

/// Polach's law: parameters and the points they were fitted to.
/// \return what to print of it
std::string addPolachLaw(const std::string &path, const PatchCurves &curves, ResultFiles &files,
                         std::vector<std::string> &warnings)
{
  const PolachContact contact = polachContact(curves);
  const std::vector<PolachPoint> points = polachPoints(curves);
  const PolachChoice choice = choosePolach(points, contact);
  if (!choice.warning.empty())
    warnings.push_back(choice.warning);
  const std::string table = tableBeside(path);
  const std::string parameters = polachJson(choice, contact);
  files.addElsewhere(table, tableHead(files.head()) +
                                finiteTable(table, polachCsv(choice, contact, points)));
  files.addElsewhere(path, parameters);
  const PolachFit &fit = choice.best;
  std::string text = "Polach's law:";
  for (int k = 0; k < polachParameters; ++k) {
    const PolachParameters &p = fit.parameters;
    const double values[] = {p.mu0, p.A, p.B, p.kA, p.kS};
    text += fmt::format(" {} {:.4g}", polachParameterNames[k], values[k]);
  }
  return fmt::format("{}; residual {:.2g} of the load; written to {} and {}\n", text, fit.rms, path,
                     table);
}

constexpr const char *rollingAxes =
    "x along the rolling direction, y to its left, z up; traction, forces and moment act on the "
    "wheel; creepages and slip are the wheel's against the rail: creep > 0 brakes, creep < 0 "
    "drives";
constexpr const char *staticAxes =
    "x, y in the plane of contact, z up; traction, forces and moment act on the wheel; shift and "
    "slip are the wheel's against the rail; without rolling";

class PatchCreepTask : public CreepTask {
 public:
  explicit PatchCreepTask(const PatchSpecification &asked) : asked_(asked) {}
  const LawChoice &friction() const override { return asked_.friction; }
  std::string axes() const override
  {
    return asked_.mode == PatchMode::Static ? staticAxes : rollingAxes;
  }
  std::vector<std::string> files() const override
  {
    std::vector<std::string> files = asked_.roughness.rail;
    files.insert(files.end(), asked_.roughness.wheel.begin(), asked_.roughness.wheel.end());
    return files;
  }
  std::vector<std::string> outputs() const override { return namesOf(outputsWith(nullptr)); }
  std::vector<RequestedOutput> extraOutputs(const ExtraFiles &extra) const override
  {
    std::vector<RequestedOutput> outputs;
    if (!extra.polach.empty()) {
      if (asked_.mode == PatchMode::Static || asked_.sequence.any())
        refuseFit("--polach");
      outputs.push_back({"--polach", extra.polach});
      outputs.push_back({"--polach", tableBeside(extra.polach)});
    }
    if (!extra.table.empty()) {
      checkPatchTable(asked_);
      outputs.push_back({"--table", extra.table});
    }
    if (!extra.measured.empty()) {
      if (asked_.mode == PatchMode::Static || asked_.sequence.any())
        refuseFit("--fit-measured");
      readMeasuredCurve(extra.measured, asked_); // a fault is said before the sweep
    }
    return outputs;
  }
  std::vector<std::string> solve(const LawPointer &law, const SweepOptions &options) override
  {
    curves_ = solvePatchCurves(asked_, law, options);
    return curves_.warnings;
  }
  TaskReport report(const ReportContext &context, ResultFiles &files) const override
  {
    TaskReport report;
    std::string measured; // before the summary, which names all files
    try {
      if (!context.extra.measured.empty())
        measured = addMeasuredFit(context, files, report.warnings);
    } catch (const Error &error) {
      if (error.code() == ExitCode::Interrupted)
        throw;
      report.shortfall = error;
    }
    write(outputsWith(&context), curves_, files);
    report.text = patchShortReport(asked_, curves_);
    report.details = patchDetailedReport(curves_);
    report.count = countOf(curves_.points.size(), curves_.resumed);
    report.seconds = curves_.seconds;
    report.failures = failures(curves_);
    report.points = curves_.points.size();
    addExtra(context.extra, files, report);
    report.extra += measured;
    return report;
  }

 private:
  /// The first contact of the case beside the curve. \return what to print of it
  std::string addMeasuredFit(const ReportContext &context, ResultFiles &files,
                             std::vector<std::string> &warnings) const
  {
    const std::string &path = context.extra.measured;
    const std::vector<MeasuredTraction> curve = readMeasuredCurve(path, asked_);
    std::vector<double> creeps;
    for (const MeasuredTraction &one : curve)
      creeps.push_back(one.creep);
    addDoubt(warnings, creepDoubt(path + ": creep", creeps));
    const MeasuredFit fit = fitMeasured(curve, asked_, curves_, context.law, context.goOn);
    if (fit.uncoupled)
      warnings.emplace_back(
          "--fit-measured: the fit of a layer leaves out that the bodies are unlike");
    files.add("measured_fit.csv", measuredCsv(fit, curve));
    files.add("measured_fit.json", measuredJson(fit, path));
    const MeasuredParameter &compliance = fit.layer.parameters.back();
    return fmt::format("{}: T/N predicted within {:.2g} (rms); Polach's form {:.2g}; with a layer "
                       "of {:.3g} m/Pa, {:.0f} % of the initial slope, {:.2g}\n",
                       path, fit.predictedRms, fit.polach.rms, compliance.value,
                       100.0 * fit.slopeShare, fit.layer.rms);
  }

  void addExtra(const ExtraFiles &extra, ResultFiles &files, TaskReport &report) const
  {
    std::string polach;
    // curves to which no law can be fitted are results all the same
    try {
      if (!extra.polach.empty())
        polach = addPolachLaw(extra.polach, curves_, files, report.warnings);
    } catch (const Error &error) {
      report.shortfall = error;
    }
    if (!extra.table.empty()) {
      files.addElsewhere(extra.table,
                         finiteTable(extra.table, patchTable(asked_, curves_, files.head())));
      report.extra = fmt::format("table of {} operating points written to {}\n",
                                 curves_.points.size(), extra.table);
    }
    report.extra += polach;
  }

  /// One for each operating point whose fields are kept.
  std::vector<std::string> subsurfaceNames() const
  {
    std::vector<std::string> names;
    const int total = static_cast<int>(patchTasks(asked_).size());
    for (int number = 1; number <= total && !asked_.depths.empty(); ++number)
      if (asked_.fields.holds(number, total))
        names.push_back(subsurfaceName(number));
    return names;
  }

  /// \param context null: for the names only
  Outputs<PatchCurves> outputsWith(const ReportContext *context) const
  {
    Outputs<PatchCurves> outputs = {
        {fieldFileNames(asked_),
         [&](auto &c, ResultFiles &files) {
           addFields(files, asked_, c);
           for (const auto &[number, fields] : c.fields)
             files.note(fieldFileNames(fieldPlace(number, static_cast<int>(c.points.size()))));
         }},
        {subsurfaceNames(),
         [&](auto &c, ResultFiles &files) {
           const std::vector<PatchTask> tasks = patchTasks(asked_);
           for (const auto &[number, fields] : c.fields) {
             const FieldPlace place = fieldPlace(number, static_cast<int>(tasks.size()));
             if (!asked_.depths.empty() && place.instant == 0)
               files.add(subsurfaceName(place.point),
                         subsurfaceCsv(asked_, c.contacts[tasks[place.point - 1].contact], fields));
           }
         }},
        fileOf<PatchCurves>(asked_.mode == PatchMode::Static ? "static.csv" : "creep.csv",
                            [&](auto &c) { return patchCsv(asked_, c); }),
        fileOf<PatchCurves>(
            "creep_band.csv", [&](auto &c) { return patchBandCsv(asked_, c); },
            [](auto &c) { return c.hasBand; }),
        fileOf<PatchCurves>(
            "series.csv", [&](auto &c) { return patchSeriesCsv(asked_, c); },
            [](auto &c) { return !c.series.empty(); }),
        {{"measured_fit.csv", "measured_fit.json"}, [](auto &, ResultFiles &) {}}, // see `report`
        summaryOf<PatchCurves>([=](auto &c, auto &files) {
          return patchSummary(asked_, context->text, context->law, c, files);
        })};
    return outputs;
  }

  PatchSpecification asked_;
  PatchCurves curves_;
};

} // namespace

std::unique_ptr<CreepTask> taskOf(const PatchSpecification &asked)
{
  return std::make_unique<PatchCreepTask>(asked);
}

} // namespace wheelrail
