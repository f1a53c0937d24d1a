// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/program_files.h"
#include "base/result_text.h"
#include "fit/fit_report.h"
#include "fit/read_runs.h"
#include "fit/run_columns.h"
#include "law/law_checksum.h"
#include "law/softening_material.h"
#include "python/glue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <optional>

#include <pybind11/stl.h>

namespace wheelrail::python {
namespace {

namespace format = mcawr::friction_log;
using Number = std::optional<double>;

py::dict headOf(const FrictionLog &log)
{
  py::dict head;
  for (const format::HeadNumber &number : format::headNumbers)
    head[number.key] = log.head.*number.value;
  return head;
}

py::dict rowsOf(const FrictionLog &log)
{
  py::dict rows;
  const std::size_t count = log.hasState ? format::columns.size() : format::columnsNeeded;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> values;
    for (const format::Row &row : log.rows)
      values.push_back(row.*format::columns[k].value);
    rows[format::columns[k].name] = arrayOf(values);
  }
  return rows;
}

bool isPath(const py::object &given)
{
  return py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__");
}

/// One path or several.
std::vector<std::string> pathsOf(const py::object &given)
{
  if (isPath(given))
    return {pathOf(given)};
  std::vector<std::string> paths;
  for (const py::handle &one : given)
    paths.push_back(pathOf(py::reinterpret_borrow<py::object>(one)));
  return paths;
}

/// All that is wrong with logs as one error: the only one as it is, with its place.
[[noreturn]] void throwAll(const std::vector<Error> &problems)
{
  if (problems.size() == 1)
    throw Error(problems.front());
  std::vector<std::string> lines;
  for (const Error &problem : problems)
    lines.emplace_back(problem.what());
  throw Error(ExitCode::BadInput, fmt::format("{}", fmt::join(lines, "; ")));
}

std::vector<FrictionLog> readLogs(const py::object &paths)
{
  std::vector<FrictionLog> logs;
  std::vector<Error> problems;
  for (const FoundLog &found : findFrictionLogs(pathsOf(paths)))
    try {
      logs.push_back(found.read());
    } catch (const Error &error) {
      problems.push_back(error);
    }
  if (!problems.empty())
    throwAll(problems);
  return logs;
}

/// The runs of logs that were read before, and then those of paths: one of them, or several.
LogRuns runsOf(const py::object &given, const AveragingOptions &options)
{
  const bool isOne = isPath(given) || py::isinstance<FrictionLog>(given);
  std::vector<FrictionRun> runs;
  std::vector<std::string> paths;
  for (const py::handle &one : isOne ? py::object(py::make_tuple(given)) : given)
    if (py::isinstance<FrictionLog>(one))
      runs.push_back(frictionRun(one.cast<const FrictionLog &>(), options));
    else
      paths.push_back(pathOf(py::reinterpret_borrow<py::object>(one)));
  if (runs.empty() && paths.empty())
    throw Error(ExitCode::Usage, "logs: at least one log is needed");
  LogRuns read = readRuns(findFrictionLogs(paths), options);
  read.runs.insert(read.runs.begin(), runs.begin(), runs.end());
  return read;
}

void requireAllowed(const char *name, const Number &value, const OptionRange &range)
{
  if (value && !range.allows(*value))
    throw Error(ExitCode::Usage, fmt::format("{}: '{}' is not allowed, must be a number {}", name,
                                             *value, range.words));
}

/// What is fitted, into the options.
void choose(const std::string &name, FitOptions &options)
{
  constexpr const char *tableModel = "table";
  std::vector<std::string> names;
  options.table = name == tableModel;
  bool known = options.table;
  const auto look = [&](const auto &models) {
    for (const LawModel model : models) {
      names.emplace_back(nameOf(model));
      if (name == nameOf(model)) {
        options.model = model;
        known = true;
      }
    }
  };
  look(lawModels);
  look(boundedModels);
  names.emplace_back(tableModel);
  if (!known)
    throw Error(ExitCode::Usage,
                fmt::format("model: '{}' is not allowed; {}", name, fmt::join(names, ", ")));
  checkMaterial(options, options.material.has_value(), "model " + name, "a material");
}

struct Fit {
  FitAnalysis analysis;
  std::vector<std::string> notes;

  std::vector<std::string> warnings() const
  {
    std::vector<std::string> all = warningsOf(analysis);
    if (!analysis.mixture.empty())
      all.insert(all.begin(), analysis.mixture);
    return all;
  }
  /// The file that wr_fit -o writes.
  std::string file() const { return withChecksum(jsonText("report", jsonReport(analysis))); }
  py::dict runs() const
  {
    py::dict all;
    py::list files;
    for (const FrictionRun &point : analysis.runs)
      files.append(point.file);
    all["file"] = files;
    for (const RunColumn &column : runColumns()) {
      std::vector<double> values;
      for (const FrictionRun &point : analysis.runs)
        values.push_back(column.get(point));
      all[column.name] = arrayOf(values);
    }
    return all;
  }
  py::dict parameters() const
  {
    if (analysis.options.table)
      throw Error(ExitCode::Usage, "a table of all conditions has no parameters");
    if (!analysis.fit)
      throw Error(
          ExitCode::NotConverged,
          fmt::format("{} cannot be fitted: {}", nameOf(analysis.options.model), analysis.whyNot));
    const auto isFitted = parametersOf(analysis.fit->model);
    py::dict all;
    for (std::size_t k = 0; k < isFitted.size(); ++k)
      if (isFitted[k])
        all[parameterNames[k]] = analysis.fit->parameters[static_cast<Eigen::Index>(k)];
    return all;
  }
};

Fit fit(const py::object &logs, const std::string &model, const py::object &material,
        bool solidOnly, const Number &kappa3, const Number &ductility, double kappa2Min,
        const Number &level, bool includeDrifting, const Number &start, const Number &startDistance,
        const Number &grindingIn)
{
  requireAllowed("kappa3", kappa3, option_range::positive);
  requireAllowed("ductility", ductility, option_range::positive);
  requireAllowed("kappa2_min", kappa2Min, option_range::notNegative);
  requireAllowed("level", level, option_range::level);
  requireAllowed("start", start, option_range::notNegative);
  requireAllowed("start_distance", startDistance, option_range::notNegative);
  requireAllowed("grinding_in", grindingIn, option_range::positive);
  if (level && model == "table")
    throw Error(ExitCode::Usage, "level: goes with a fitted law, not with the model table, which "
                                 "has standard errors");
  FitOptions options;
  if (!material.is_none())
    options.material = readPotentialFile(pathOf(material));
  choose(model, options);
  if (kappa3)
    takeReference(options, ThirdNumber::Kappa3, *kappa3, "kappa3");
  if (ductility)
    takeReference(options, ThirdNumber::Ductility, *ductility, "ductility");
  options.solidOnly = solidOnly;
  options.kappa2Min = kappa2Min;
  options.level = level.value_or(options.level);
  options.includeDrifting = includeDrifting;
  LogRuns read = runsOf(logs, {start, startDistance, grindingIn});
  if (!read.problems.empty())
    throwAll(read.problems);
  return {analyseRuns(std::move(read.runs), options), std::move(read.notes)};
}

} // namespace

void addFit(py::module_ &module)
{
  py::class_<FrictionLog>(
      module, "FrictionLog",
      "A friction log of the plugin: ns, nm, MPa, m/s, kg/m3, Pa s, as the file.")
      .def_readonly("file", &FrictionLog::file, "The name of its file.")
      .def_readonly("note", &FrictionLog::note, "That a cut last line was dropped; or empty.")
      .def_readonly("made_by", &FrictionLog::madeBy, "What computed the run, word by word.")
      .def_readonly("condition", &FrictionLog::condition, "What was simulated, word by word.")
      .def_property_readonly("head", &headOf,
                             "The numbers of its head by their keys; 0: not stated.")
      .def_property_readonly("columns", &rowsOf, "Its columns by their names, one value a row.")
      .def_property_readonly("kappa1", &FrictionLog::kappa1, "rho E v^2/sigma_0^2, a pure number")
      .def_property_readonly("kappa2", &FrictionLog::kappa2, "p E/sigma_0^2, a pure number")
      .def_property_readonly("kappa3", &FrictionLog::kappa3, "E/sigma_0, a pure number");
  module.def(
      "read_logs", &readLogs, py::arg("paths"),
      "The friction logs that a path, or several, name: files, archives of them, and folders\n"
      "that are searched for *.friction, in alphabetical order. Raises BadInput that tells\n"
      "all that are wrong.");

  py::class_<Fit>(module, "Fit", "Runs of friction logs and the law fitted to them, as wr_fit.")
      .def_property_readonly(
          "runs", &Fit::runs,
          "One value a run for each column that wr_fit --runs writes, by their names, in the\n"
          "units of that file, and more that the report has.")
      .def_property_readonly(
          "parameters", &Fit::parameters,
          "The fitted parameters of the law. Raises NotConverged where the runs\n"
          "do not determine them.")
      .def_property_readonly(
          "why_not", [](const Fit &one) { return one.analysis.whyNot; },
          "Why no law was fitted; empty: one was.")
      .def_property_readonly(
          "report", [](const Fit &one) { return fromJson(one.file()); },
          "All that is known of it, as wr_fit -o writes it, as a dict.")
      .def_property_readonly(
          "text", [](const Fit &one) { return textReport(one.analysis); },
          "The report that wr_fit prints.")
      .def_readonly("notes", &Fit::notes, "Cut last lines that were dropped, one line each.")
      .def_property_readonly("warnings", &Fit::warnings,
                             "What is doubtful, one line each, as wr_fit prints it.")
      .def(
          "save",
          [](const Fit &one, const py::object &path) { writeOutputFile(pathOf(path), one.file()); },
          py::arg("path"),
          "Writes the law file, which friction.law of a case may name; only the report where no "
          "law\n"
          "was fitted.");
  module.def(
      "fit", &fit, py::arg("logs"), py::arg("model") = nameOf(LawModel::Full), py::kw_only(),
      py::arg("material") = py::none(), py::arg("solid_only") = false,
      py::arg("kappa3") = py::none(), py::arg("ductility") = py::none(),
      py::arg("kappa2_min") = FitOptions{}.kappa2Min, py::arg("level") = py::none(),
      py::arg("include_drifting") = false, py::arg("start") = py::none(),
      py::arg("start_distance") = py::none(), py::arg("grinding_in") = py::none(),
      "Friction coefficients of logs with standard errors, and the law fitted to them.\n\n"
      "logs: a path as of read_logs, a FrictionLog, or several of both, of which each FrictionLog\n"
      "comes before the paths. material: a potential file, for a law of one material. The others\n"
      "are the options of wr_fit: times in ns, lengths in nm. Raises BadInput, UsageError.");
}

} // namespace wheelrail::python
