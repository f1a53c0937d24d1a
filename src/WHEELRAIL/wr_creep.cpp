// SPDX-License-Identifier: GPL-2.0-or-later
// wr_creep: a case file -> creep curves of rough rolling contact. The command line only.

#include "base/errors.h"
#include "base/program.h"
#include "base/program_files.h"
#include "base/progress.h"
#include "base/version.h"
#include "creep/case/case_file.h"
#include "creep/case/help.h"
#include "shared/output_file.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <fmt/format.h>
#include <memory>
#include <string>

using namespace wheelrail;

namespace {

constexpr const char *programName = "wr_creep";

std::atomic<bool> interruptAsked{false};
void askToStop(int)
{
  interruptAsked = true;
}

struct Settings {
  std::string caseFile, folder = ".";
  ExtraFiles extra;
  std::vector<std::string> changes;
  int threads = 0;
  bool quiet = false, verbose = false, printConfig = false;
};

void defineOptions(CLI::App &app, Settings &settings)
{
  app.set_version_flag("--version", std::string("wr_creep ") + versionText);
  app.footer(caseHelp());
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
  for (const ExtraFileOption &option : extraFileOptions)
    app.add_option(option.name, settings.extra.*option.file, option.help)
        ->check(nameOption())
        ->type_name("FILE");
  app.add_flag("--print-config", settings.printConfig, "print the complete case and stop");
  app.add_flag("-q,--quiet", settings.quiet, "nothing on the screen but errors and warnings");
  app.add_flag("-v,--verbose", settings.verbose,
               "iterations, residual and time of every normal contact too");
}

void warn(const std::vector<std::string> &warnings)
{
  for (const std::string &warning : warnings)
    complain(programName, "warning: " + warning);
}

/// All files that the run reads.
std::vector<std::string> inputsOf(const Settings &settings, const Case &input)
{
  std::vector<std::string> inputs = input.inputs();
  if (!settings.extra.measured.empty())
    inputs.push_back(settings.extra.measured);
  return inputs;
}

/// Puts all files in place, and only then takes the journal away and says what was found.
void finish(const Settings &settings, const Case &input, const TaskReport &report,
            ResultFiles &files, const Journal &journal)
{
  files.commit(inputsOf(settings, input));
  warn(report.warnings);
  journal.remove();
  if (!settings.quiet)
    writeStandardOutput(screenText(report, files, settings.verbose));
  if (report.shortfall)
    throw Error(*report.shortfall);
  reportFailures(programName, report);
}

void run(const Settings &settings)
{
  const Case input = readCase(settings.caseFile, settings.changes);
  if (settings.printConfig) {
    writeStandardOutput(input.text);
    return;
  }
  const std::unique_ptr<CreepTask> task = input.open();
  std::vector<RequestedOutput> outputs = task->extraOutputs(settings.extra);
  const LawPointer law = task->friction().read();
  const std::string identity = input.identity();
  prepareOutputFolder(settings.folder);
  for (const RequestedOutput &output : folderOutputs(*task, settings.folder))
    outputs.push_back(output);
  checkOutputs(outputs, inputsOf(settings, input)); // may lie in the folder, and stay
  if (const std::string note = law->note(); !note.empty() && !settings.quiet)
    complain(programName, "note: " + note);

  Progress progress(programName);
  Journal journal(settings.folder + "/" + journalName, identity,
                  [](const std::string &line) { complain(programName, "warning: " + line); });
  SweepOptions options;
  options.threads = settings.threads;
  options.journal = &journal;
  options.interrupted = [] { return interruptAsked.load(); };
  if (!settings.quiet)
    options.progress = [&](int done, int total) { progress(done, total); };
  try {
    warn(task->solve(law, options));
    ResultFiles files(settings.folder, resultHead(task->axes(), input.text));
    const ReportContext context{input.text, *law, settings.extra,
                                [&] { return !options.stopped(); }};
    finish(settings, input, task->report(context, files), files, journal);
  } catch (const mcawr::OutputError &error) {
    throw Error(ExitCode::Io,
                fmt::format("{}; no result is written{}", error.what(), journal.whatIsKept()));
  }
}

int body(int argc, char **argv)
{
  CLI::App app("Creep curves of rough wheel/rail contact, line or point contact: friction, "
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
