// SPDX-License-Identifier: GPL-2.0-or-later
// wr_creep: a case file -> creep curves of rough rolling contact. The command line only.

#include "base/errors.h"
#include "base/program.h"
#include "base/program_files.h"
#include "base/result_text.h"
#include "base/version.h"
#include "creep/case/case_file.h"
#include "creep/line/creep_report.h"
#include "creep/patch/patch_report.h"
#include "creep/patch/patch_table.h"
#include "shared/output_file.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <unistd.h>

using namespace wheelrail;

namespace {

constexpr const char *programName = "wr_creep";
constexpr const char *journalName = "wr_creep.journal";

std::atomic<bool> interruptAsked{false};
void askToStop(int)
{
  interruptAsked = true;
}

struct Settings {
  std::string caseFile, folder = ".", polach, table;
  std::vector<std::string> changes;
  int threads = 0;
  bool quiet = false, verbose = false, printConfig = false;
};

/// What a keyword allows, of any kind.
std::string allowedOf(const Keyword &keyword)
{
  switch (keyword.kind) {
  case Keyword::Kind::Choice:
    return keyword.choices;
  case Keyword::Kind::Switch:
    return "true|false";
  case Keyword::Kind::Text:
  case Keyword::Kind::TextList:
    return "TEXT";
  default:
    return rangeOf(keyword);
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
    text += fmt::format("  {:<30} {}", keyword.name, allowedOf(keyword));
    if (*keyword.initial)
      text += fmt::format(" [{}]", keyword.initial);
    text += fmt::format("\n  {:<30}   {}\n", "", keyword.help);
  }
  return text + R"(
Exit codes: 0 ok, 1 internal, 2 usage, 3 bad input file, 4 not converged, 5 input/output,
6 interrupted (run the same command again to continue).
)";
}

void defineOptions(CLI::App &app, Settings &settings)
{
  app.set_version_flag("--version", std::string("wr_creep ") + versionText);
  app.footer(footer());
  app.add_option("CASE", settings.caseFile, "case file (YAML)")->required();
  app.add_option("-o,--output", settings.folder, "folder for the results")
      ->check(nameOption())
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--set", settings.changes, "change a keyword: contact.radius=\"0.46 m\"")
      ->type_name("KEYWORD=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  app.add_option("--threads", settings.threads, "threads for the sweep [all cores]")
      ->check(wholeNumberOption(1, 1024))
      ->type_name("N");
  app.add_option("--polach", settings.polach,
                 "fit Polach's law to the curves of a contact in a point; writes FILE (JSON) and "
                 "its points beside it (CSV)")
      ->check(nameOption())
      ->type_name("FILE");
  app.add_option("--table", settings.table,
                 "write the forces of a contact in a point as a table over load, speed, spin, "
                 "lateral and creep, for a multibody code (CSV)")
      ->check(nameOption())
      ->type_name("FILE");
  app.add_flag("--print-config", settings.printConfig, "print the complete case and stop");
  app.add_flag("-q,--quiet", settings.quiet, "nothing on the screen but errors and warnings");
  app.add_flag("-v,--verbose", settings.verbose,
               "iterations, residual and time of every normal contact too");
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
    std::fprintf(stderr, "%s%s: %d of %d points%s", onTerminal_ ? "\r" : "", programName, done,
                 total, onTerminal_ && done < total ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  const bool onTerminal_ = ::isatty(STDERR_FILENO) != 0;
  const std::chrono::milliseconds pause_{onTerminal_ ? 200 : 2000};
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What a sweep says of itself when its files are in place.
struct Report {
  std::string text, details; ///< for the screen; the second with --verbose
  std::string count;         ///< "21 points"
  double seconds;
};

/// The files of a case, and the report that is printed after they have appeared.
class Results {
 public:
  explicit Results(const Settings &settings) : settings_(settings) {}

  void add(const std::string &name, const std::string &content)
  {
    files.add(settings_.folder + "/" + name, content);
    names_ += (names_.empty() ? "" : ", ") + name;
  }
  void addTable(const std::string &name, const std::string &content)
  {
    add(name, finiteTable(name, content));
  }
  /// Puts all files in place, and only then takes the journal away.
  void finish(const Report &report, const Journal &journal)
  {
    files.commit();
    journal.remove();
    if (!settings_.quiet)
      writeStandardOutput(fmt::format("{}{}{} in {:.2f} s; written to {}/: {}\n",
                                      settings_.verbose ? report.details : "", report.text,
                                      report.count, report.seconds, settings_.folder, names_));
  }

  mcawr::OutputFiles files;

 private:
  const Settings &settings_;
  std::string names_;
};

/// A program run: what is asked for, and with what.
struct Task {
  const Settings &settings;
  const SweepOptions &options;
  Journal &journal;
  const std::string &text; ///< of the case
  const LawPointer &law;
};

std::string countOf(std::size_t points, int resumed)
{
  return fmt::format("{} points{}", points,
                     resumed ? fmt::format(" ({} of them from a run that ended early)", resumed)
                             : "");
}

/// Files that a case leaves in its folder.
std::vector<std::string> outputNames(const Case &input)
{
  if (const auto *patch = std::get_if<PatchSpecification>(&input.task)) {
    std::vector<std::string> names = fieldFileNames(*patch);
    names.insert(names.end(), {"creep.csv", "creep_band.csv", "static.csv", "series.csv",
                               "summary.json", journalName});
    return names;
  }
  std::vector<std::string> names = {"creep.csv", "creep.json", "creep_band.csv", journalName,
                                    "summary.json"};
  const auto addContacts = [&](const FieldSelection &fields, std::size_t points) {
    const int total = static_cast<int>(points);
    for (int number = 1; number <= total; ++number)
      if (fields.holds(number, total))
        names.push_back(contactFileName(fields, number));
  };
  if (const auto *still = std::get_if<StaticSpecification>(&input.task)) {
    names = {"static.csv", "summary.json"};
    addContacts(still->fields, still->forceRatio.size() * still->surface.profiles());
  } else {
    const auto &rolling = std::get<CreepSpecification>(input.task);
    addContacts(rolling.fields,
                rolling.creep.size() * rolling.speed.size() * rolling.surface.profiles());
  }
  return names;
}

void warn(const std::vector<std::string> &warnings)
{
  for (const std::string &warning : warnings)
    complain(programName, "warning: " + warning);
}

/// Names the points that have no results, when those of the others are in place.
/// @throws Error (NotConverged) if there are any
void reportFailures(const std::vector<std::string> &failures, std::size_t points)
{
  constexpr std::size_t most = 10;
  for (std::size_t k = 0; k < std::min(most, failures.size()); ++k)
    complain(programName, failures[k]);
  if (!failures.empty())
    throw Error(ExitCode::NotConverged,
                fmt::format("{} of {} points did not converge and {} left out{}; the others are "
                            "written",
                            failures.size(), points, failures.size() == 1 ? "is" : "are",
                            failures.size() > most ? " (summary.json names all)" : ""));
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
  if (!settings.table.empty())
    outputs.push_back({"--table", settings.table});
  checkOutputs(outputs, inputs);
}

void compute(const Task &task, const StaticSpecification &asked)
{
  const StaticCases cases = solveStaticCases(asked, *task.law, task.options);
  warn(cases.warnings);
  Results results(task.settings);
  results.addTable("static.csv", staticCsv(asked.surface, cases));
  for (const NamedTable &table : contactTables(asked, cases))
    results.addTable(table.name, table.text);
  results.add("summary.json", summaryJson(asked, task.text, *task.law, cases));
  results.finish({shortReport(asked, cases), detailedReport(asked.surface, cases.contacts),
                  fmt::format("{} forces", cases.points.size()), cases.seconds},
                 task.journal);
}

void compute(const Task &task, const CreepSpecification &asked)
{
  const CreepCurves curves = solveCreepCurves(asked, task.law, task.options);
  warn(curves.warnings);
  Results results(task.settings);
  results.addTable("creep.csv", creepCsv(asked.surface, curves));
  results.add("creep.json", creepJson(asked, curves));
  if (curves.hasBand)
    results.addTable("creep_band.csv", creepBandCsv(asked.surface, curves));
  for (const NamedTable &table : contactTables(asked, curves))
    results.addTable(table.name, table.text);
  results.add("summary.json", summaryJson(asked, task.text, *task.law, curves));
  results.finish({shortReport(asked, curves), detailedReport(asked.surface, curves.contacts),
                  countOf(curves.points.size(), curves.resumed), curves.seconds},
                 task.journal);
  reportFailures(failures(curves), curves.points.size());
}

/// Polach's law: parameters and the points they were fitted to.
/// @return what to print of it
std::string addPolachLaw(const Settings &settings, const PatchCurves &curves,
                         mcawr::OutputFiles &files)
{
  const PolachContact contact = polachContact(curves);
  const std::vector<PolachPoint> points = polachPoints(curves);
  const PolachChoice choice = choosePolach(points, contact);
  const std::string table = tableBeside(settings.polach);
  const std::string parameters = polachJson(choice, contact);
  files.add(table, finiteTable(table, polachCsv(choice, contact, points)));
  files.add(settings.polach, parameters);
  const PolachFit &fit = choice.best;
  std::string text = "Polach's law:";
  for (int k = 0; k < polachParameters; ++k) {
    const PolachParameters &p = fit.parameters;
    const double values[] = {p.mu0, p.A, p.B, p.kA, p.kS};
    text += fmt::format(" {} {:.4g}", polachParameterNames[k], values[k]);
  }
  return fmt::format("{}; residual {:.2g} of the load; written to {} and {}\n", text, fit.rms,
                     settings.polach, table);
}

void compute(const Task &task, const PatchSpecification &asked)
{
  const Settings &settings = task.settings;
  const PatchCurves curves = solvePatchCurves(asked, task.law, task.options);
  warn(curves.warnings);
  Results results(settings);
  addFields(results.files, settings.folder, asked, curves);
  results.addTable(asked.mode == PatchMode::Static ? "static.csv" : "creep.csv",
                   patchCsv(asked, curves));
  if (curves.hasBand)
    results.addTable("creep_band.csv", patchBandCsv(asked, curves));
  if (!curves.series.empty())
    results.addTable("series.csv", patchSeriesCsv(curves));
  results.add("summary.json", patchSummary(asked, task.text, *task.law, curves));
  // curves to which no law can be fitted are results all the same
  std::string polach, table;
  std::optional<Error> noPolach;
  try {
    if (!settings.polach.empty())
      polach = addPolachLaw(settings, curves, results.files);
  } catch (const Error &error) {
    noPolach = error;
  }
  if (!settings.table.empty()) {
    results.files.add(settings.table, finiteTable(settings.table, patchTable(asked, curves)));
    table = fmt::format("table of {} points written to {}\n", curves.points.size(), settings.table);
  }
  results.finish({patchShortReport(asked, curves), patchDetailedReport(curves),
                  countOf(curves.points.size(), curves.resumed), curves.seconds},
                 task.journal);
  if (!settings.quiet)
    writeStandardOutput(table + polach);
  if (noPolach)
    throw Error(*noPolach);
  reportFailures(failures(curves), curves.points.size());
}

/// --table is for rolling contacts in a point over a grid of creepages.
void checkTable(const Settings &settings, const Case &input)
{
  if (settings.table.empty())
    return;
  const auto *patch = std::get_if<PatchSpecification>(&input.task);
  if (!patch)
    throw Error(ExitCode::Usage, "--table: goes with a contact in a point (contact.load)");
  checkPatchTable(*patch);
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
  checkTable(settings, input);
  const LawPointer law = input.friction().read();
  const std::string identity = input.identity();
  prepareOutputFolder(settings.folder);
  checkInputsStay(settings, input);
  if (const std::string note = law->note(); !note.empty() && !settings.quiet)
    complain(programName, "note: " + note);

  Progress progress;
  Journal journal(settings.folder + "/" + journalName, identity,
                  [](const std::string &line) { complain(programName, "warning: " + line); });
  SweepOptions options;
  options.threads = settings.threads;
  options.journal = &journal;
  options.interrupted = [] { return interruptAsked.load(); };
  if (!settings.quiet)
    options.progress = [&](int done, int total) { progress(done, total); };
  const Task task{settings, options, journal, input.text, law};
  try {
    std::visit([&](const auto &asked) { compute(task, asked); }, input.task);
  } catch (const mcawr::OutputError &error) {
    throw Error(ExitCode::Io,
                fmt::format("{}; no result is written{}", error.what(), journal.whatIsKept()));
  }
}

int body(int argc, char **argv)
{
  CLI::App app("Creep curves of rough wheel/rail contact, on a line or in a point: friction, "
               "temperature and strength that depend on each other.",
               programName);
  Settings settings;
  defineOptions(app, settings);
  if (const auto code = parseCommandLine(app, argc, argv, "one case file is expected"))
    return *code;
  std::signal(SIGINT, askToStop);
  std::signal(SIGTERM, askToStop);
  run(settings);
  return static_cast<int>(ExitCode::Ok);
}

} // namespace

int main(int argc, char **argv)
{
  return runProgram(programName, body, argc, argv);
}
