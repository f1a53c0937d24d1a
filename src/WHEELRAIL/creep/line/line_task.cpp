// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/line_task.h"

#include "creep/line/creep_report.h"

#include <fmt/format.h>

namespace wheelrail {
namespace {

std::vector<std::string> filesOf(const SurfaceSpecification &surface)
{
  std::vector<std::string> files = surface.rail;
  files.insert(files.end(), surface.wheel.begin(), surface.wheel.end());
  return files;
}

constexpr const char *rollingAxes =
    "x along the rolling direction; traction and T act on the rail; creep and slip are the wheel's "
    "against the rail along x: creep > 0 brakes, creep < 0 drives";
constexpr const char *staticAxes =
    "x along the force; traction and T act on the body that it pushes; without rolling";

/// The fields along the contact of the points that were asked for.
template<class Asked, class Curves>
void addContacts(Outputs<Curves> &outputs, const Asked &asked, std::size_t points)
{
  const int total = static_cast<int>(points);
  for (int number = 1; number <= total; ++number)
    if (asked.fields.holds(number, total))
      outputs.push_back(
          fileOf<Curves>(contactFileName(asked.fields, number),
                         [number](const Curves &curves) { return contactTable(curves, number); }));
}

class RollingTask : public CreepTask {
 public:
  explicit RollingTask(const CreepSpecification &asked) : asked_(asked) {}
  const LawChoice &friction() const override { return asked_.friction; }
  std::string axes() const override { return rollingAxes; }
  std::vector<std::string> files() const override { return filesOf(asked_.surface); }
  std::vector<std::string> outputs() const override { return namesOf(outputsWith(nullptr)); }
  std::vector<std::string> solve(const LawPointer &law, const SweepOptions &options) override
  {
    curves_ = solveCreepCurves(asked_, law, options);
    return curves_.warnings;
  }
  TaskReport report(const ReportContext &context, ResultFiles &files) const override
  {
    write(outputsWith(&context), curves_, files);
    TaskReport report;
    report.text = shortReport(asked_, curves_);
    report.details = detailedReport(asked_.surface, curves_.contacts);
    report.count = countOf(curves_.points.size(), curves_.resumed);
    report.seconds = curves_.seconds;
    report.failures = failures(curves_);
    report.points = curves_.points.size();
    return report;
  }

 private:
  /// \param context null: for the names only
  Outputs<CreepCurves> outputsWith(const ReportContext *context) const
  {
    Outputs<CreepCurves> outputs = {
        fileOf<CreepCurves>("creep.csv", [&](auto &c) { return creepCsv(asked_.surface, c); }),
        fileOf<CreepCurves>("creep.json", [&](auto &c) { return creepJson(asked_, c); }),
        fileOf<CreepCurves>(
            "creep_band.csv", [&](auto &c) { return creepBandCsv(asked_.surface, c); },
            [](auto &c) { return c.hasBand; })};
    addContacts(outputs, asked_,
                asked_.drives().size() * asked_.speed.size() * asked_.surface.profiles());
    outputs.push_back(summaryOf<CreepCurves>([=](auto &c, auto &files) {
      return summaryJson(asked_, context->text, context->law, c, files);
    }));
    return outputs;
  }

  CreepSpecification asked_;
  CreepCurves curves_;
};

class StaticTask : public CreepTask {
 public:
  explicit StaticTask(const StaticSpecification &asked) : asked_(asked) {}
  const LawChoice &friction() const override { return asked_.friction; }
  std::string axes() const override { return staticAxes; }
  std::vector<std::string> files() const override { return filesOf(asked_.surface); }
  std::vector<std::string> outputs() const override { return namesOf(outputsWith(nullptr)); }
  std::vector<std::string> solve(const LawPointer &law, const SweepOptions &options) override
  {
    cases_ = solveStaticCases(asked_, *law, options);
    return cases_.warnings;
  }
  TaskReport report(const ReportContext &context, ResultFiles &files) const override
  {
    write(outputsWith(&context), cases_, files);
    TaskReport report;
    report.text = shortReport(asked_, cases_);
    report.details = detailedReport(asked_.surface, cases_.contacts);
    report.count = fmt::format("{} forces", cases_.points.size());
    report.seconds = cases_.seconds;
    report.points = cases_.points.size();
    return report;
  }

 private:
  /// \param context null: for the names only
  Outputs<StaticCases> outputsWith(const ReportContext *context) const
  {
    Outputs<StaticCases> outputs = {
        fileOf<StaticCases>("static.csv", [&](auto &c) { return staticCsv(asked_.surface, c); })};
    addContacts(outputs, asked_, asked_.forceRatio.size() * asked_.surface.profiles());
    outputs.push_back(summaryOf<StaticCases>([=](auto &c, auto &files) {
      return summaryJson(asked_, context->text, context->law, c, files);
    }));
    return outputs;
  }

  StaticSpecification asked_;
  StaticCases cases_;
};

} // namespace

std::unique_ptr<CreepTask> taskOf(const CreepSpecification &asked)
{
  return std::make_unique<RollingTask>(asked);
}

std::unique_ptr<CreepTask> taskOf(const StaticSpecification &asked)
{
  return std::make_unique<StaticTask>(asked);
}

} // namespace wheelrail
