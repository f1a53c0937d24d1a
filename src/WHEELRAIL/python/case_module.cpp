// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/quantity.h"
#include "creep/case/case_file.h"
#include "creep/line/creep_report.h"
#include "creep/patch/measured_fit.h"
#include "creep/patch/patch_report.h"
#include "python/glue.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <variant>

#include <pybind11/stl.h>

namespace wheelrail::python {
namespace {

/// Ends a sweep where Ctrl-C, or another signal, raised an exception in the thread that waits.
class Signals {
 public:
  bool raised()
  {
    if (!raised_ && std::this_thread::get_id() == waiting_) {
      const py::gil_scoped_acquire python;
      if (PyErr_CheckSignals() != 0) {
        error_.emplace();
        raised_ = true;
      }
    }
    return raised_;
  }
  /// To be called when the sweep has ended.
  void rethrow() const
  {
    if (error_)
      throw py::error_already_set(*error_);
  }

 private:
  std::thread::id waiting_ = std::this_thread::get_id();
  std::atomic<bool> raised_{false};
  std::optional<py::error_already_set> error_;
};

/// Numbers by the names of their columns, in SI units; nan where a point did not converge.
struct Columns {
  py::dict values, units;
};

/// Whether a file has a column.
template<class Point>
using Selection = std::function<bool(const Column<Point> &)>;

template<class Point>
bool converged(const Point &point)
{
  return point.converged();
}
bool converged(const PatchStep & /*step*/)
{
  return true;
}

template<class Point>
Columns columnsOfPoints(const std::vector<Column<Point>> &table, const std::vector<Point> &points,
                        const Selection<Point> &selected)
{
  Columns columns;
  for (const Column<Point> &column : table) {
    if (!selected(column))
      continue;
    std::vector<double> values;
    for (const Point &point : points)
      values.push_back(converged(point) ? column.value.get(point)
                                        : std::numeric_limits<double>::quiet_NaN());
    columns.values[column.name.c_str()] = arrayOf(values);
    columns.units[column.name.c_str()] = siUnit(column.unit);
  }
  return columns;
}

template<class Point>
std::vector<bool> convergedOf(const std::vector<Point> &points)
{
  std::vector<bool> list;
  for (const Point &point : points)
    list.push_back(point.converged());
  return list;
}

/// What a contact gives, whichever it is.
class Result {
 public:
  Result() = default;
  Result(const Result &) = delete;
  Result &operator=(const Result &) = delete;
  virtual ~Result() = default;
  virtual Columns columns() const = 0;
  virtual std::vector<bool> converged() const = 0;
  virtual std::vector<std::string> failures() const = 0;
  virtual const std::vector<std::string> &warnings() const = 0;
  virtual std::string summary() const = 0;
  virtual py::dict fields() const = 0;
  virtual py::dict series() const { return {}; }
  virtual std::string polach() const { refuseFit("polach()"); }
  virtual std::string fitMeasured(const std::string & /*path*/,
                                  const std::function<bool()> & /*goOn*/) const
  {
    refuseFit("fit_measured()");
  }
};

py::dict lineFields(const ContactSetup &setup, const ContactFields &fields)
{
  Eigen::VectorXd x(setup.cells), state(setup.cells);
  for (int i = 0; i < setup.cells; ++i) {
    x[i] = setup.position(i);
    state[i] = static_cast<double>(fields.state[static_cast<std::size_t>(i)]);
  }
  py::dict all;
  all["x"] = arrayOf(x);
  all["pressure"] = arrayOf(fields.pressure);
  all["traction"] = arrayOf(fields.traction);
  all["mu"] = arrayOf(fields.mu);
  all["slip"] = arrayOf(fields.slip);
  all["state"] = arrayOf(state);
  all["temperature"] = arrayOf(fields.temperature);
  return all;
}

template<class Curves>
py::dict lineFields(const Curves &curves)
{
  const std::size_t each = curves.points.size() / curves.contacts.size();
  py::dict all;
  for (const auto &[number, fields] : curves.fields)
    all[py::int_(number)] =
        lineFields(curves.contacts[static_cast<std::size_t>(number - 1) / each], fields);
  return all;
}

template<class Asked, class Curves>
class ResultOf : public Result {
 public:
  ResultOf(const Case &input, LawPointer itsLaw, Curves found)
      : asked(std::get<Asked>(input.task)), text(input.text), law(std::move(itsLaw)),
        curves(std::move(found))
  {
  }
  std::vector<bool> converged() const override { return convergedOf(curves.points); }
  const std::vector<std::string> &warnings() const override { return curves.warnings; }

 protected:
  const Asked asked;
  const std::string text;
  const LawPointer law;
  const Curves curves;
};

class LineResult final : public ResultOf<CreepSpecification, CreepCurves> {
 public:
  using ResultOf::ResultOf;
  Columns columns() const override
  {
    return columnsOfPoints<CurvePoint>(curveColumns(), curves.points, [&](const auto &c) {
      return c.creep.digits > 0 || c.name == "profile" || c.name == "temperature_max" ||
             (curves.hasBand && c.band.digits > 0);
    });
  }
  std::vector<std::string> failures() const override { return wheelrail::failures(curves); }
  std::string summary() const override { return summaryJson(asked, text, *law, curves, {}); }
  py::dict fields() const override { return lineFields(curves); }
};

class StaticResult final : public ResultOf<StaticSpecification, StaticCases> {
 public:
  using ResultOf::ResultOf;
  Columns columns() const override
  {
    return columnsOfPoints<StaticPoint>(staticColumns(), curves.points, [](const auto &c) {
      return c.still.digits > 0 || c.name == "profile";
    });
  }
  std::vector<std::string> failures() const override { return {}; }
  std::string summary() const override { return summaryJson(asked, text, *law, curves, {}); }
  py::dict fields() const override { return lineFields(curves); }
};

class PatchResult final : public ResultOf<PatchSpecification, PatchCurves> {
 public:
  using ResultOf::ResultOf;
  Columns columns() const override
  {
    return columnsOfPoints<PatchPoint>(patchColumns(), curves.points, [&](const auto &c) {
      const bool written = asked.mode == PatchMode::Static
                               ? c.still.digits > 0
                               : c.creep.digits > 0 || isOfMoving(c, asked);
      return written || c.name == "surface" || (wears() && c.wear.digits > 0) ||
             (curves.hasBand && c.band.digits > 0);
    });
  }
  std::vector<std::string> failures() const override { return wheelrail::failures(curves); }
  std::string summary() const override { return patchSummary(asked, text, *law, curves, {}); }
  py::dict fields() const override
  {
    const std::vector<PatchTask> tasks = patchTasks(asked);
    py::dict all;
    for (const auto &[number, fields] : curves.fields) {
      const FieldPlace place = fieldPlace(number, static_cast<int>(tasks.size()));
      const std::size_t contact = tasks[static_cast<std::size_t>(place.point - 1)].contact;
      const py::object key = place.instant == 0 ? py::object(py::int_(place.point))
                                                : py::make_tuple(place.point, place.instant);
      all[key] = fieldsOf(curves.contacts[contact].grid, fields);
    }
    return all;
  }
  py::dict series() const override
  {
    py::dict all;
    const auto written = [&](const auto &c) {
      return asked.mode == PatchMode::Static
                 ? c.stages.digits > 0
                 : c.series.digits > 0 || (wears() && c.wear.digits > 0);
    };
    for (const auto &[number, steps] : curves.series)
      all[py::int_(number)] = columnsOfPoints<PatchStep>(seriesColumns(), steps, written).values;
    return all;
  }
  std::string polach() const override
  {
    if (asked.mode == PatchMode::Static || asked.sequence.any())
      refuseFit("polach()");
    const PolachContact contact = polachContact(curves);
    return polachJson(choosePolach(polachPoints(curves), contact), contact);
  }
  std::string fitMeasured(const std::string &path, const std::function<bool()> &goOn) const override
  {
    if (asked.mode == PatchMode::Static || asked.sequence.any())
      refuseFit("fit_measured()");
    return measuredJson(
        wheelrail::fitMeasured(readMeasuredCurve(path, asked), asked, curves, *law, goOn), path);
  }

 private:
  bool wears() const
  {
    return asked.mode != PatchMode::Static && asked.physics.wear.kind != WearLaw::Kind::None;
  }
};

std::unique_ptr<Result> solveTask(const CreepSpecification &asked, const Case &input,
                                  const LawPointer &law, const SweepOptions &options)
{
  return std::make_unique<LineResult>(input, law, solveCreepCurves(asked, law, options));
}
std::unique_ptr<Result> solveTask(const StaticSpecification &asked, const Case &input,
                                  const LawPointer &law, const SweepOptions &options)
{
  return std::make_unique<StaticResult>(input, law, solveStaticCases(asked, *law, options));
}
std::unique_ptr<Result> solveTask(const PatchSpecification &asked, const Case &input,
                                  const LawPointer &law, const SweepOptions &options)
{
  return std::make_unique<PatchResult>(input, law, solvePatchCurves(asked, law, options));
}

std::unique_ptr<Result> solve(const Case &input, int threads, const py::object &progress)
{
  if (threads < 0 || threads > 1024)
    throw Error(ExitCode::Usage,
                fmt::format("threads: '{}' is not in the allowed range [0, 1024]", threads));
  SweepOptions options;
  options.threads = threads;
  Signals signals;
  options.interrupted = [&] { return signals.raised(); };
  if (!progress.is_none())
    options.progress = [&](int done, int total) {
      const py::gil_scoped_acquire python;
      progress(done, total);
    };
  std::unique_ptr<Result> result;
  try {
    const py::gil_scoped_release others;
    result = std::visit(
        [&](const auto &asked) {
          return solveTask(asked, input, input.open()->friction().read(), options);
        },
        input.task);
  } catch (const Error &error) {
    signals.rethrow();
    throw;
  }
  return result;
}

std::string fitMeasured(const Result &result, const std::string &path)
{
  Signals signals;
  try {
    const py::gil_scoped_release others;
    return result.fitMeasured(path, [&] { return !signals.raised(); });
  } catch (const Error &error) {
    signals.rethrow();
    throw;
  }
}

Case caseOf(const py::object &source, const std::optional<py::dict> &changes)
{
  const YAML::Node changed = changes ? treeOf(*changes) : YAML::Node(YAML::NodeType::Map);
  if (py::isinstance<py::dict>(source))
    return caseOfTree("case", treeOf(source), changed);
  return readChangedCase(pathOf(source), changed);
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The numbers of an argument. \throws Error (Usage) where one is not allowed
Eigen::VectorXd allowedNumbers(const char *name, const Numbers &given, double least)
{
  Eigen::VectorXd numbers = Eigen::Map<const Eigen::VectorXd>(given.data(), given.size());
  for (const double number : numbers)
    if (!std::isfinite(number) || number < least)
      throw Error(ExitCode::Usage, fmt::format("{}: '{}' is not allowed, must be a number{}", name,
                                               number, least == 0.0 ? " >= 0" : ""));
  return numbers;
}

/// A law of friction, apart from the case that names it.
struct Law {
  LawPointer law;
  Strength strength; ///< that it takes, if it takes any

  explicit Law(const Case &input)
      : law(input.open()->friction().read()),
        strength(std::visit([&](const auto &asked) { return asked.physics.strengthOf(*law); },
                            input.task))
  {
  }

  /// mu, in the shape that pressure and temperature have together.
  py::array mu(const py::object &pressure, double speed, const py::object &temperature) const
  {
    const py::list both =
        py::module_::import("numpy").attr("broadcast_arrays")(pressure, temperature);
    const Numbers p = Numbers(py::object(both[0])), rise = Numbers(py::object(both[1]));
    constexpr double any = -std::numeric_limits<double>::infinity();
    const Eigen::VectorXd pressures = allowedNumbers("pressure", p, 0.0);
    allowedNumbers("speed", Numbers(1, &speed), 0.0);
    const Eigen::VectorXd rises = allowedNumbers("temperature", rise, any);
    for (const double hot : rises)
      if (law->dependsOnStrength() && strength.vanishesAt(hot))
        throw Error(ExitCode::Usage,
                    fmt::format("temperature: '{}' is not allowed, it leaves no strength "
                                "(friction.strength_temperature is {:g} K)",
                                hot, strength.vanishingTemperature));
    const Eigen::VectorXd mu = law->mu({pressures, speed, rises});
    return Numbers(std::vector<py::ssize_t>(p.shape(), p.shape() + p.ndim()), mu.data());
  }
};

} // namespace

void addCase(py::module_ &module)
{
  py::class_<Law>(module, "Law", "A law of friction, as a case names it.")
      .def(
          "mu", &Law::mu, py::arg("pressure"), py::arg("speed"), py::arg("temperature") = 0.0,
          "The friction coefficient at pressures (Pa, one or an array), a sliding speed (m/s) and\n"
          "temperature rises (K, likewise). Raises UsageError for what is no finite number, a\n"
          "pressure or speed below 0, and a rise that leaves no strength.")
      .def_property_readonly(
          "description", [](const Law &law) { return fromJson(law.law->json().dump()); },
          "The law as summary.json tells it.");

  py::class_<Result> resultType( // before Case, whose help names it
      module, "Result",
      "What a case gives: one value a point, in the order of the case's lists, creep fastest.\n\n"
      "result[\"force_x\"] is a column by its name in creep.csv or static.csv, in SI units; "
      "points\n"
      "that did not converge are nan there.");

  py::class_<Case>(
      module, "Case",
      "What a case file of wr_creep asks for.\n\n"
      "source: the path of a case file, or a dict of keywords, or of groups of them, with their\n"
      "values: numbers (in the SI unit only where the keyword has none), texts with units as in "
      "the\n"
      "file, lists. changes: a dict that changes keywords, as --set does. All values are checked;\n"
      "what is wrong raises BadInput, or UsageError for a change.")
      .def(py::init(&caseOf), py::arg("source"), py::arg("changes") = py::none())
      .def_readonly("text", &Case::text, "The complete case, defaults included, as a case file.")
      .def_property_readonly("files", &Case::files, "The files that it reads.")
      .def_property_readonly(
          "law", [](const Case &input) { return Law(input); },
          "The law of friction; reads its file.")
      .def("solve", &solve, py::arg("threads") = 0, py::arg("progress") = py::none(),
           "Solves all operating points and returns the Result.\n\n"
           "threads: 0: all cores; results do not depend on it. progress: called with the number "
           "of\n"
           "points done and of all. Ctrl-C ends it. Raises what wr_creep ends with, NotConverged\n"
           "where no point at all converges.");

  const auto listOf = [](const std::vector<bool> &flags) {
    py::array_t<bool> array(static_cast<py::ssize_t>(flags.size()));
    std::copy(flags.begin(), flags.end(), array.mutable_data());
    return array;
  };
  resultType
      .def(
          "__getitem__",
          [](const Result &result, const std::string &name) {
            const py::dict values = result.columns().values;
            if (!values.contains(name))
              throw py::key_error(name);
            return py::object(values[name.c_str()]);
          },
          py::arg("name"), "A column by its name.")
      .def(
          "__len__", [](const Result &result) { return result.converged().size(); },
          "Number of points.")
      .def_property_readonly(
          "columns", [](const Result &result) { return result.columns().values; },
          "All columns by their names.")
      .def_property_readonly(
          "units", [](const Result &result) { return result.columns().units; },
          "Their units; \"1\": a pure number.")
      .def_property_readonly(
          "converged", [listOf](const Result &result) { return listOf(result.converged()); },
          "Which points converged.")
      .def_property_readonly("failures", &Result::failures,
                             "Why the others did not, one line each.")
      .def_property_readonly("warnings", &Result::warnings, "What is doubtful, one line each.")
      .def_property_readonly(
          "summary", [](const Result &result) { return fromJson(result.summary()); },
          "summary.json as a dict: law, contacts, Kalker's coefficients and so\n"
          "on, in the units of that file.")
      .def_property_readonly(
          "fields", &Result::fields,
          "By number of the point, from 1 on, a dict of arrays in SI units, with x and y of the\n"
          "cells' centres: [y, x] of a point contact, [x] of a line contact. `fields` of the case\n"
          "says of which points; those of `sequence.fields` are under (point, instant), from 1 on.")
      .def_property_readonly(
          "series", &Result::series,
          "Mode moving, and a sequence, of a point contact: by number of the\n"
          "point, a dict of columns with one value a step, or stage, in SI units.")
      .def(
          "polach", [](const Result &result) { return fromJson(result.polach()); },
          "Polach's law fitted to the points, as --polach writes it. Raises NotConverged where "
          "the\n"
          "points do not determine it, UsageError for another contact.")
      .def(
          "fit_measured",
          [](const Result &result, const std::string &path) {
            return fromJson(fitMeasured(result, path));
          },
          py::arg("path"),
          "Polach's form and an interfacial layer fitted to a measured traction curve (CSV: "
          "creep,\n"
          "speed, traction_ratio), as --fit-measured writes it in measured_fit.json. Raises\n"
          "NotConverged where the curve does not determine them, BadInput for a file that cannot "
          "be\n"
          "read, UsageError for another contact. Ctrl-C ends it.");
}

} // namespace wheelrail::python
