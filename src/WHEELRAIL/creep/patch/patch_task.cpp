// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_task.h"

#include "base/result_text.h"
#include "creep/patch/patch_report.h"
#include "creep/patch/patch_table.h"

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
        refusePolach();
      outputs.push_back({"--polach", extra.polach});
      outputs.push_back({"--polach", tableBeside(extra.polach)});
    }
    if (!extra.table.empty()) {
      checkPatchTable(asked_);
      outputs.push_back({"--table", extra.table});
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
    write(outputsWith(&context), curves_, files);
    TaskReport report;
    report.text = patchShortReport(asked_, curves_);
    report.details = patchDetailedReport(curves_);
    report.count = countOf(curves_.points.size(), curves_.resumed);
    report.seconds = curves_.seconds;
    report.failures = failures(curves_);
    report.points = curves_.points.size();
    addExtra(context.extra, files, report);
    return report;
  }

 private:
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
        fileOf<PatchCurves>(asked_.mode == PatchMode::Static ? "static.csv" : "creep.csv",
                            [&](auto &c) { return patchCsv(asked_, c); }),
        fileOf<PatchCurves>(
            "creep_band.csv", [&](auto &c) { return patchBandCsv(asked_, c); },
            [](auto &c) { return c.hasBand; }),
        fileOf<PatchCurves>(
            "series.csv", [&](auto &c) { return patchSeriesCsv(asked_, c); },
            [](auto &c) { return !c.series.empty(); }),
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
