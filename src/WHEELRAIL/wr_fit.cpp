// SPDX-License-Identifier: GPL-2.0-or-later
// wr_fit: friction logs -> friction coefficients -> the law of Eq. 2. The command line only.

#include "base/errors.h"
#include "base/program.h"
#include "base/program_files.h"
#include "base/quantity.h"
#include "base/result_text.h"
#include "base/version.h"
#include "fit/fit_report.h"
#include "fit/measured_series.h"
#include "fit/plot_script.h"
#include "fit/read_runs.h"
#include "fit/run_columns.h"
#include "law/law_checksum.h"
#include "shared/output_file.h"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

using namespace wheelrail;

namespace {

constexpr const char *programName = "wr_fit";
constexpr const char *tableModel = "table"; ///< of a material, beside the models of a few numbers
/// Options that say nothing of a measured series.
constexpr std::array ofLogsOnly = {
    "--runs",           "--plot",       "--model",      "--material", "--solid-only",
    "--kappa3",         "--ductility",  "--kappa2-min", "--level",    "--include-drifting",
    "--start-distance", "--grinding-in"};
constexpr const char *examples = R"(
Examples:
  wr_fit run.friction
      the friction coefficient of one run, beside Eq. 2 (one log is no law: exit code 0)
  wr_fit campaign/ -o law.json --runs runs.csv --plot fit.png
      all *.friction below a folder: runs, fitted law, Figs. 7 and 8
  wr_fit paper36.tar.xz --model velocity -o law.json
      all *.friction of an archive of tools/campaign pack; no pressure term
  wr_fit campaign/ --model eq4 -o static.json
      the law without its velocity term, e.g. for runs at one speed
  wr_fit run.friction --start 40 --grinding-in 100
      average from 40 ns on; grinding-in over the first 100 ns
  wr_fit tribometer.csv
      a measured series: its columns time and mu; mean and standard error, no law

Exit codes: 0 ok (too few conditions for a law included), 1 internal, 2 usage, 3 bad input file,
4 enough conditions, but they do not determine the law (runs and report are written),
5 a file cannot be written.
)";

struct Settings {
  std::vector<std::string> logs;
  double kappa3 = 0.0, ductility = 0.0; ///< 0: not given
  std::string json, runs, plot, material;
  std::string model = nameOf(LawModel::Full);
  AveragingOptions averaging;
  FitOptions fit;
  std::vector<std::string> ofLogs; ///< those of `ofLogsOnly` that were given
  bool isLevelGiven = false;
  bool quiet = false;
};

/// Accepts the finite numbers of a range (CLI11's own ranges let nan pass).
/// \param unit for the message: " (ns)", or nothing
CLI::Validator number(const OptionRange &range, const std::string &unit = "")
{
  const std::string words = range.words + unit;
  const auto check = [=](const std::string &given) -> std::string {
    try {
      if (range.allows(parseNumber(given)))
        return "";
    } catch (const std::invalid_argument &) {
    }
    return fmt::format("'{}' is not allowed, must be a number {}", given, words);
  };
  return CLI::Validator(check, words);
}

void defineOptions(CLI::App &app, Settings &settings)
{
  app.set_version_flag("--version", std::string("wr_fit ") + versionText);
  app.footer(examples);
  app.add_option(
         "LOG", settings.logs,
         "friction logs, archives of them (*.tar.xz), or folders that are searched for *.friction; "
         "or measured series (*.csv) with columns time and mu")
      ->required();
  app.add_option("-o,--output", settings.json,
                 "JSON: the law file with the report; only the report when no law is fitted")
      ->check(nameOption())
      ->type_name("FILE");
  app.add_option("--runs,--points", settings.runs, "CSV: one row a run; --points is its older name")
      ->check(nameOption())
      ->type_name("FILE");
  app.add_option("--plot", settings.plot, "PNG: Figs. 7 and 8 with these runs (matplotlib)")
      ->check(nameOption())
      ->type_name("FILE");
  std::vector<std::string> models;
  for (LawModel model : lawModels)
    models.emplace_back(nameOf(model));
  for (LawModel model : boundedModels)
    models.emplace_back(nameOf(model));
  models.emplace_back(tableModel);
  app.add_option("--model", settings.model,
                 "law to fit: eq2, eq4 (no velocity term), velocity (no pressure term), constant, "
                 "eq2_kappa3 and velocity_kappa3 (times a power of kappa3 = E/sigma_0), "
                 "eq2_ductility (times one of the breaking strain over sigma_0/E); with "
                 "--material also bounded, bounded_kappa3, bounded_rate, bounded_velocity, "
                 "bounded_eq4 and bounded_eq2 (by the shear strength) and table")
      ->check(CLI::IsMember(models))
      ->type_name("MODEL")
      ->capture_default_str();
  app.add_option("--material", settings.material,
                 "potential file of the material that all runs are of, at whatever temperature: "
                 "the law is one of it")
      ->check(nameOption())
      ->type_name("FILE");
  app.add_flag("--solid-only", settings.fit.solidOnly,
               "leave out runs whose automata sank into each other");
  app.add_option("--kappa3", settings.kappa3,
                 "with a power of kappa3: E/sigma_0 of the material that the law file is for "
                 "[geometric mean of the conditions]")
      ->check(number(option_range::positive))
      ->type_name("NUMBER");
  app.add_option("--ductility", settings.ductility,
                 "with a power of the ductility: breaking strain times E/sigma_0 of the material "
                 "that the law file is for [geometric mean of the conditions]")
      ->check(number(option_range::positive))
      ->type_name("NUMBER");
  app.add_option("--kappa2-min", settings.fit.kappa2Min, "leave out runs with a smaller kappa2")
      ->check(number(option_range::notNegative))
      ->type_name("NUMBER")
      ->capture_default_str();
  app.add_option("--level", settings.fit.level, "level of the confidence intervals")
      ->check(number(option_range::level))
      ->type_name("NUMBER")
      ->capture_default_str();
  app.add_flag("--include-drifting", settings.fit.includeDrifting,
               "fit runs without a stationary part too (mean of their second half)");
  app.add_option("--start", settings.averaging.start,
                 "average from this time on (ns) instead of looking for the stationary part")
      ->check(number(option_range::notNegative, " (ns)"))
      ->type_name("NUMBER");
  app.add_option("--start-distance", settings.averaging.startDistance,
                 "the same as a distance of sliding (nm); with --start, the later of both")
      ->check(number(option_range::notNegative, " (nm)"))
      ->type_name("NUMBER");
  app.add_option("--grinding-in", settings.averaging.grindingIn,
                 "end of the grinding-in (ns) [start of the stationary part, at most 100]")
      ->check(number(option_range::positive, " (ns)"))
      ->type_name("NUMBER");
  app.add_flag("-q,--quiet", settings.quiet, "no report on the screen");
}

/// The runs of all logs; what is wrong with them is reported together, the last by the exception.
std::vector<FrictionRun> runsOf(const std::vector<FoundLog> &logs, const AveragingOptions &options)
{
  LogRuns read = readRuns(logs, options);
  for (const std::string &note : read.notes)
    complain(programName, note);
  if (read.problems.empty())
    return std::move(read.runs);
  for (std::size_t k = 0; k + 1 < read.problems.size(); ++k)
    complain(programName, read.problems[k].what());
  throw Error(read.problems.back());
}

/// The picture of the same JSON that -o gets.
/// \return why there is none; empty: it was added
std::string addPicture(const std::string &path, const std::string &json,
                       mcawr::OutputFiles &results)
{
  const auto ending = std::filesystem::path(path).extension().string();
  const Picture picture = makePicture("plot_fit.py", json, ending);
  if (picture.problem.empty())
    results.add(path, picture.bytes);
  return picture.problem;
}

/// Measured series have no condition, so that there is no law.
int runMeasured(const Settings &settings)
{
  if (!settings.ofLogs.empty())
    throw Error(ExitCode::Usage,
                fmt::format("{}: goes with friction logs, not with measured series",
                            settings.ofLogs.front()));
  if (!settings.json.empty())
    checkOutputs({{"-o", settings.json}}, settings.logs);
  std::vector<MeasuredMean> means;
  std::set<std::filesystem::path> seen;
  for (const std::string &path : settings.logs) {
    std::error_code error;
    const auto place = std::filesystem::weakly_canonical(path, error);
    if (error || seen.insert(place).second)
      means.push_back(meanOf(readMeasuredSeries(path), settings.averaging.start));
  }
  mcawr::OutputFiles results;
  if (!settings.json.empty())
    results.add(settings.json, jsonText("report", jsonReport(means)));
  results.commit();
  if (!settings.quiet)
    writeStandardOutput(textReport(means));
  return static_cast<int>(ExitCode::Ok);
}

int run(const Settings &settings)
{
  const auto measured = std::count_if(settings.logs.begin(), settings.logs.end(), isMeasuredSeries);
  if (measured == static_cast<long>(settings.logs.size()))
    return runMeasured(settings);
  if (measured > 0)
    throw Error(ExitCode::Usage, "LOG: measured series (*.csv) and friction logs do not go "
                                 "together: read them in two calls");
  FitOptions options = settings.fit;
  if (settings.kappa3 > 0.0)
    takeReference(options, ThirdNumber::Kappa3, settings.kappa3, "--kappa3");
  if (settings.ductility > 0.0)
    takeReference(options, ThirdNumber::Ductility, settings.ductility, "--ductility");
  if (settings.fit.table && settings.isLevelGiven)
    throw Error(ExitCode::Usage, "--level: goes with a fitted law, not with --model table, which "
                                 "has standard errors");
  checkMaterial(options, !settings.material.empty(), "--model " + settings.model, "--material");
  if (!settings.material.empty() && !settings.plot.empty())
    throw Error(ExitCode::Usage, "--plot: Figs. 7 and 8 are of Eq. 2, not of a --material");
  const auto logs = findFrictionLogs(settings.logs);
  std::vector<std::string> files;
  for (const auto &log : logs)
    files.push_back(log.onDisk());
  std::vector<RequestedOutput> outputs;
  for (const auto &[option, path] : std::vector<RequestedOutput>{
           {"-o", settings.json}, {"--runs", settings.runs}, {"--plot", settings.plot}})
    if (!path.empty())
      outputs.push_back({option, path});
  if (!settings.material.empty())
    files.push_back(settings.material);
  checkOutputs(outputs, files);
  if (const std::string ending = std::filesystem::path(settings.plot).extension().string();
      !ending.empty() && std::count(pictureEndings.begin(), pictureEndings.end(), ending) == 0)
    throw Error(ExitCode::Usage,
                fmt::format("--plot {}: '{}' is not a picture, allowed: {}", settings.plot, ending,
                            fmt::join(pictureEndings, ", ")));

  if (!settings.material.empty())
    options.material = readPotentialFile(settings.material);
  const auto analysis = analyseRuns(runsOf(logs, settings.averaging), options);
  const auto json = withChecksum(jsonText("report", jsonReport(analysis)));
  mcawr::OutputFiles results; // together or not at all
  std::string noPicture;
  if (!settings.plot.empty())
    noPicture = addPicture(settings.plot, json, results);
  if (!settings.runs.empty())
    results.add(settings.runs, runsAsCsv(analysis.runs));
  if (!settings.json.empty())
    results.add(settings.json, json);
  results.commit();
  std::error_code ignored;
  if (!noPicture.empty() && std::filesystem::is_regular_file(settings.plot, ignored))
    std::filesystem::remove(settings.plot, ignored); // of other logs
  if (!settings.quiet)
    writeStandardOutput(textReport(analysis));
  if (!analysis.mixture.empty())
    complain(programName, "warning: " + analysis.mixture);
  for (const std::string &warning : warningsOf(analysis))
    complain(programName, "warning: " + warning);
  if (analysis.notIdentifiable)
    complain(programName, fmt::format("{} cannot be fitted: {}", settings.model, analysis.whyNot));
  if (!noPicture.empty())
    throw Error(ExitCode::Io,
                fmt::format("{} was not made: {}; all else was", settings.plot, noPicture));
  return static_cast<int>(analysis.notIdentifiable ? ExitCode::NotConverged : ExitCode::Ok);
}

int body(int argc, char **argv)
{
  Settings settings;
  CLI::App app{"Friction logs (*.friction) -> friction coefficients with standard errors, and the "
               "law mu(kappa1, kappa2) of Eq. 2 fitted to them.",
               programName};
  defineOptions(app, settings);
  if (const auto code = parseCommandLine(app, argc, argv, "unexpected argument"))
    return *code;
  for (const char *option : ofLogsOnly)
    if (app.count(option) > 0)
      settings.ofLogs.emplace_back(option);
  settings.isLevelGiven = app.count("--level") > 0;
  settings.fit.table = settings.model == tableModel;
  for (LawModel model : lawModels)
    if (settings.model == nameOf(model))
      settings.fit.model = model;
  for (LawModel model : boundedModels)
    if (settings.model == nameOf(model))
      settings.fit.model = model;
  return run(settings);
}

} // namespace

int main(int argc, char **argv)
{
  return runProgram(programName, body, argc, argv);
}
