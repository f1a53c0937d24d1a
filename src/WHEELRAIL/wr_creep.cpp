// SPDX-License-Identifier: GPL-2.0-or-later
// wr_creep: a case file -> creep curves of rough rolling contact. The command line only.

#include "base/errors.h"
#include "base/output_file.h"
#include "creep/case_file.h"
#include "creep/creep_report.h"
#include "creep/patch/patch_report.h"
#include "shared/nearest_word.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

using namespace wheelrail;

namespace {

constexpr const char *journalName = "wr_creep.journal";

std::atomic<bool> interruptAsked{false};
void askToStop(int)
{
  interruptAsked = true;
}

struct Settings {
  std::string caseFile, folder = ".", polach;
  std::vector<std::string> changes;
  int threads = 0;
  bool quiet = false, verbose = false, printConfig = false;
};

std::string rangeOf(const Keyword &keyword)
{
  const std::string unit = std::string(keyword.unit) == "1" ? "" : std::string(" ") + keyword.unit;
  switch (keyword.kind) {
  case Keyword::Kind::Choice:
    return keyword.choices;
  case Keyword::Kind::Switch:
    return "true|false";
  case Keyword::Kind::Text:
  case Keyword::Kind::TextList:
    return "TEXT";
  default:
    return fmt::format("{}{}, {}]{}", keyword.lowOpen ? "(" : "[", keyword.low, keyword.high, unit);
  }
}

/// The footer of --help: worked examples, the table of keywords, exit codes.
std::string footer()
{
  std::string text = R"(
Examples:
  wr_creep table2.yaml -o out
      creep curves of the case: out/creep.csv, creep.json, contact.csv, summary.json
  wr_creep table2.yaml -o out --set speed="20 m/s" --set creep="[0.001, 0.01, 0.1]"
      the same case with other speeds and creeps
  wr_creep table2.yaml -o rough --set roughness="{hurst: 0.8, rms_slope: 0.02,
           wavelength_min: 0.1 mm, wavelength_max: 10 mm, seed: [1, 2, 3]}" --set points=4096
      three rough profiles
  wr_creep table2.yaml -o own --set friction.law=law.json
      a law fitted by wr_fit; its uncertainty goes to own/creep_band.csv
  wr_creep table2.yaml -o static --set mode=static --set static.force_ratio="[0.25, 0.5]"
      a tangential force without rolling: static/static.csv
  wr_creep table2.yaml --print-config
      the complete case with every default

Keywords of the case file (and of --set), allowed values, defaults:
)";
  for (const Keyword &keyword : keywords()) {
    text += fmt::format("  {:<30} {}", keyword.name, rangeOf(keyword));
    if (*keyword.initial)
      text += fmt::format(" [{}]", keyword.initial);
    text += fmt::format("\n  {:<30}   {}\n", "", keyword.help);
  }
  return text + R"(
Exit codes: 0 ok, 1 internal, 2 usage, 3 bad input file, 4 not converged, 5 input/output,
6 interrupted (the same command goes on where it stopped).
)";
}

void defineOptions(CLI::App &app, Settings &settings)
{
  app.set_version_flag("--version", "wr_creep " WHEELRAIL_VERSION);
  app.footer(footer());
  app.add_option("CASE", settings.caseFile, "case file (YAML)")->required();
  app.add_option("-o,--output", settings.folder, "folder for the results")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--set", settings.changes, "change a keyword: contact.radius=\"0.46 m\"")
      ->type_name("KEYWORD=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--threads", settings.threads, "threads for the sweep [all cores]")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_option("--polach", settings.polach,
                 "fit Polach's law to the curves of a contact in a point; writes FILE (JSON) and "
                 "its points beside it (CSV)")
      ->type_name("FILE");
  app.add_flag("--print-config", settings.printConfig, "print the complete case and stop");
  app.add_flag("-q,--quiet", settings.quiet, "nothing on the screen but errors");
  app.add_flag("-v,--verbose", settings.verbose,
               "iterations, residual and time of every normal contact too");
}

/// What to say of arguments that are no option: the nearest option there is.
std::string unknownOption(const CLI::App &app)
{
  std::vector<std::string> known;
  for (const auto *option : app.get_options())
    for (const auto &name : option->get_lnames())
      known.push_back("--" + name);
  for (const auto &given : app.remaining())
    if (given.substr(0, 1) == "-")
      return mcawr::unknownWord("option", given, known);
  return "one case file is expected";
}

/// Progress on stderr: one line that is written over on a terminal, a line now and then elsewhere.
class Progress {
 public:
  void operator()(int done, int total)
  {
    const auto now = std::chrono::steady_clock::now();
    if (done < total && now - last_ < pause_)
      return;
    last_ = now;
    fmt::print(stderr, "{}wr_creep: {} of {} points{}", onTerminal_ ? "\r" : "", done, total,
               onTerminal_ && done < total ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  const bool onTerminal_ = ::isatty(STDERR_FILENO) != 0;
  const std::chrono::milliseconds pause_{onTerminal_ ? 200 : 2000};
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

using Files = std::vector<std::pair<std::string, std::string>>; ///< name, content

/// Writes the files, then says what was computed.
void finish(const Settings &settings, const Files &files, const std::string &report,
            const std::string &details, const std::string &count, double seconds)
{
  std::string names;
  for (const auto &[name, content] : files) {
    writeOutputFile(settings.folder + "/" + name, content);
    names += (names.empty() ? "" : ", ") + name;
  }
  if (settings.quiet)
    return;
  writeStandardOutput(fmt::format("{}{}{} in {:.2f} s; written to {}/: {}\n",
                                  settings.verbose ? details : "", report, count, seconds,
                                  settings.folder, names));
}

/// Files that a case leaves in its folder.
std::vector<std::string> outputNames(const Case &input)
{
  if (const auto *patch = std::get_if<PatchSpecification>(&input.task)) {
    std::vector<std::string> names = fieldFileNames(*patch);
    names.insert(names.end(),
                 {"creep.csv", "static.csv", "series.csv", "summary.json", journalName});
    return names;
  }
  if (std::holds_alternative<StaticSpecification>(input.task))
    return {"static.csv", "contact.csv", "summary.json"};
  return {"creep.csv", "creep.json", "creep_band.csv", journalName, "contact.csv", "summary.json"};
}

/// The table that goes with a file of parameters: its name with the ending ".csv".
std::string tableBeside(const std::string &path)
{
  return std::filesystem::path(path).replace_extension(".csv").string();
}

/// A profile or law that lies in the folder for the results must not be written over.
void checkInputsStay(const Settings &settings, const Case &input)
{
  std::vector<std::string> inputs = input.files();
  inputs.push_back(settings.caseFile);
  std::vector<RequestedOutput> outputs;
  for (const std::string &name : outputNames(input))
    outputs.push_back({"-o", settings.folder + "/" + name});
  if (!settings.polach.empty()) {
    outputs.push_back({"--polach", settings.polach});
    outputs.push_back({"--polach", tableBeside(settings.polach)});
  }
  checkOutputs(outputs, inputs);
}

void compute(const Settings &settings, const SweepOptions &options, const std::string &text,
             const FrictionLaw &law, const StaticSpecification &asked)
{
  const StaticCases cases = solveStaticCases(asked, law, options);
  finish(settings,
         {{"static.csv", staticCsv(asked.surface, cases)},
          {"contact.csv", contactCsv(cases)},
          {"summary.json", summaryJson(asked, text, law, cases)}},
         shortReport(asked, cases), detailedReport(asked.surface, cases.contacts),
         fmt::format("{} forces", cases.points.size()), cases.seconds);
}

void compute(const Settings &settings, const SweepOptions &options, const std::string &text,
             const FrictionLaw &law, const CreepSpecification &asked)
{
  const CreepCurves curves = solveCreepCurves(asked, law, options);
  Files files = {{"creep.csv", creepCsv(asked.surface, curves)},
                 {"creep.json", creepJson(asked, curves)}};
  if (curves.hasBand)
    files.emplace_back("creep_band.csv", creepBandCsv(asked.surface, curves));
  files.emplace_back("contact.csv", contactCsv(curves));
  files.emplace_back("summary.json", summaryJson(asked, text, law, curves));
  const std::string resumed =
      curves.resumed
          ? fmt::format(" ({} of them from the run that was interrupted)", curves.resumed)
          : "";
  finish(settings, files, shortReport(asked, curves),
         detailedReport(asked.surface, curves.contacts),
         fmt::format("{} points{}", curves.points.size(), resumed), curves.seconds);
}

/// Polach's law: parameters and the points they were fitted to.
void fitPolachLaw(const Settings &settings, const PatchCurves &curves)
{
  const PolachContact contact = polachContact(curves);
  const std::vector<PolachPoint> points = polachPoints(curves);
  const PolachChoice choice = choosePolach(points, contact);
  writeOutputFile(settings.polach, polachJson(choice, contact));
  writeOutputFile(tableBeside(settings.polach), polachCsv(choice, contact, points));
  if (settings.quiet)
    return;
  const PolachFit &fit = choice.best;
  std::string text = "Polach's law:";
  for (int k = 0; k < polachParameters; ++k) {
    const PolachParameters &p = fit.parameters;
    const double values[] = {p.mu0, p.A, p.B, p.kA, p.kS};
    text += fmt::format(" {} {:.4g}", polachParameterNames[k], values[k]);
  }
  writeStandardOutput(fmt::format("{}; residual {:.2g} of the load; written to {} and {}\n", text,
                                  fit.rms, settings.polach, tableBeside(settings.polach)));
}

void compute(const Settings &settings, const SweepOptions &options, const std::string &text,
             const FrictionLaw &law, const PatchSpecification &asked)
{
  const PatchCurves curves = solvePatchCurves(asked, law, options);
  for (const std::string &warning : curves.warnings)
    fmt::print(stderr, "wr_creep: warning: {}\n", warning);
  writeFields(settings.folder, asked, curves);
  Files files;
  files.emplace_back(asked.mode == PatchMode::Static ? "static.csv" : "creep.csv",
                     patchCsv(asked, curves));
  if (!curves.series.empty())
    files.emplace_back("series.csv", patchSeriesCsv(curves));
  files.emplace_back("summary.json", patchSummary(asked, text, law, curves));
  const std::string resumed =
      curves.resumed
          ? fmt::format(" ({} of them from the run that was interrupted)", curves.resumed)
          : "";
  finish(settings, files, patchShortReport(asked, curves), patchDetailedReport(curves),
         fmt::format("{} points{}", curves.points.size(), resumed), curves.seconds);
  if (!settings.polach.empty())
    fitPolachLaw(settings, curves);
}

/// --polach is for rolling contacts in a point that have steady or mean forces.
void checkPolach(const Settings &settings, const Case &input)
{
  if (settings.polach.empty())
    return;
  const auto *patch = std::get_if<PatchSpecification>(&input.task);
  if (!patch || patch->mode == PatchMode::Static || patch->sequence.any())
    throw Error(ExitCode::Usage, "--polach: goes with a contact in a point (contact.load) that "
                                 "rolls, without a sequence");
}

void run(const Settings &settings)
{
  const Case input = readCase(settings.caseFile, settings.changes);
  if (settings.printConfig) {
    writeStandardOutput(input.text);
    return;
  }
  checkPolach(settings, input);
  const FrictionLaw law = readLaw(input.friction());
  prepareOutputFolder(settings.folder);
  checkInputsStay(settings, input);

  Progress progress;
  SweepOptions options;
  options.threads = settings.threads;
  options.journal = settings.folder + "/" + journalName;
  options.identity = input.text;
  options.interrupted = [] { return interruptAsked.load(); };
  if (!settings.quiet)
    options.progress = [&](int done, int total) { progress(done, total); };
  std::visit([&](const auto &asked) { compute(settings, options, input.text, law, asked); },
             input.task);
}

} // namespace

int main(int argc, char **argv)
{
  CLI::App app("Creep curves of rough wheel/rail contact, on a line or in a point: friction, "
               "temperature and strength that depend on each other.",
               "wr_creep");
  app.allow_extras();
  Settings settings;
  defineOptions(app, settings);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    if (error.get_exit_code() == 0)
      return app.exit(error);
    fmt::print(stderr, "wr_creep: {} (see wr_creep --help)\n", error.what());
    return static_cast<int>(ExitCode::Usage);
  }
  if (!app.remaining().empty()) {
    fmt::print(stderr, "wr_creep: {} (see wr_creep --help)\n", unknownOption(app));
    return static_cast<int>(ExitCode::Usage);
  }
  std::signal(SIGINT, askToStop);
  std::signal(SIGTERM, askToStop);
  try {
    run(settings);
  } catch (const Error &error) {
    fmt::print(stderr, "wr_creep: {}\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception &error) {
    fmt::print(stderr, "wr_creep: internal error: {}\n", error.what());
    return static_cast<int>(ExitCode::Internal);
  }
  return static_cast<int>(ExitCode::Ok);
}
