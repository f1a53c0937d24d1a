// SPDX-License-Identifier: GPL-2.0-or-later
// Fuzzing of every reader: falsified files, each of which has to be refused with one line or read
// as what it says. Readers run in a child, so that a crash or a hang is counted and the next
// execution goes on; any of them can be repeated alone (--only).

#include "mutator.h"
#include "readers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
extern "C" const char *__asan_default_options() // NOLINT(bugprone-reserved-identifier)
{
  return "detect_leaks=0:max_allocation_size_mb=4096:allocator_may_return_null=0";
}
#endif

namespace {

constexpr const char *usage = R"(Usage: fuzz_readers [--reader NAME] [--executions N] [--seed S]
                    [--only NUMBER [--save FILE]]
       fuzz_readers --list

Falsifies good files and has them read: every one is refused with one line, or read as what it says.

  --reader NAME   one reader only; without it, all of them
  --executions N  files for each reader [1000]
  --seed S        of the random numbers [1]
  --only NUMBER   this execution alone, in this process (for a debugger); says how it ended
  --save FILE     keeps its file
  --list          names of the readers

Exit codes: 0 nothing found, 1 something was, 2 usage.
)";

constexpr time_t hang = 30;              // seconds of processor time for one file
constexpr time_t blocked = 100;          // seconds for one file, whatever they are spent on
constexpr rlim_t mostMemory = 4UL << 30; // bytes; far beyond what a file of this size needs

struct Settings {
  std::string reader, save;
  std::uint64_t executions = 1000, seed = 1, only = 0;
  bool one = false, list = false;
};

/// A fault and the execution that showed it.
struct Seen {
  std::uint64_t number;
  char what[300];
};

/// What the child tells, in memory that the parent sees.
struct Tally {
  std::uint64_t number, accepted, refused, faults;
  int kinds; ///< of faults, which differ before their first colon
  std::array<Seen, 8> seen;
};

void note(Tally &tally, const std::string &fault)
{
  tally.faults++;
  const std::string kind = fault.substr(0, fault.find(':'));
  for (int k = 0; k < tally.kinds; k++)
    if (std::string(tally.seen[k].what).substr(0, kind.size()) == kind)
      return;
  if (tally.kinds < static_cast<int>(tally.seen.size())) {
    Seen &seen = tally.seen[tally.kinds++];
    seen.number = tally.number;
    std::snprintf(seen.what, sizeof(seen.what), "%s", fault.c_str());
  }
}

bool isOneLine(const std::string &text)
{
  return !text.empty() && std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 32 || c == 127;
  });
}

/// Empty when the reader did as it should.
std::string faultOf(const Reader &reader, const std::string &bytes, bool &accepted)
{
  accepted = false;
  try {
    reader.read(bytes);
    accepted = true;
    return "";
  } catch (const Refused &refusal) {
    return isOneLine(refusal.what()) ? "" : std::string("not one line: ") + refusal.what();
  } catch (const Fault &fault) {
    return fault.what();
  } catch (const std::exception &error) {
    return std::string("not for users: ") + typeid(error).name() + ": " + error.what();
  }
}

/// The child: executions from `first` on, until all are done or one kills it.
void work(const Reader &reader, const Settings &settings, std::uint64_t first, Tally &tally)
{
#if !defined(__SANITIZE_ADDRESS__)
  const rlimit memory = {mostMemory, mostMemory};
  setrlimit(RLIMIT_AS, &memory);
#endif
  Mutator mutate(reader.corpus, settings.seed);
  for (std::uint64_t k = first; k < settings.executions; k++) {
    tally.number = k;
    const itimerval limit = {{0, 0}, {hang, 0}}, longest = {{0, 0}, {blocked, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    setitimer(ITIMER_REAL, &longest, nullptr);
    bool accepted;
    const std::string fault = faultOf(reader, mutate(k), accepted);
    if (fault.empty())
      (accepted ? tally.accepted : tally.refused)++;
    else
      note(tally, fault);
  }
  tally.number = settings.executions;
}

std::string printable(const std::string &text)
{
  std::string line;
  for (const char c : text)
    line += static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  return line;
}

/// All executions of one reader, in as many children as crashes make needed.
/// \return whether anything was found
bool drill(const Reader &reader, const Settings &settings)
{
  const auto begin = std::chrono::steady_clock::now();
  auto *tally = static_cast<Tally *>(
      mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (tally == MAP_FAILED)
    throw std::runtime_error("no shared memory");
  *tally = {};
  std::uint64_t crashes = 0;
  while (tally->number < settings.executions) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0)
      throw std::runtime_error("no further process");
    if (child == 0) {
      work(reader, settings, tally->number, *tally);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (tally->number >= settings.executions)
      break;
    if (crashes++ < 5)
      std::printf("  %s, execution %llu: %s\n", reader.name.c_str(),
                  static_cast<unsigned long long>(tally->number),
                  !WIFSIGNALED(status)          ? "a sanitizer's finding"
                  : WTERMSIG(status) == SIGPROF ? "hangs"
                  : WTERMSIG(status) == SIGALRM ? "is blocked"
                                                : strsignal(WTERMSIG(status)));
    tally->number++;
  }
  for (int k = 0; k < tally->kinds; k++)
    std::printf("  %s, execution %llu: %s\n", reader.name.c_str(),
                static_cast<unsigned long long>(tally->seen[k].number),
                printable(tally->seen[k].what).c_str());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%-13s %9llu executions, seed %llu: %9llu accepted, %9llu refused, %llu faults, "
              "%llu crashes; %.1f s\n",
              reader.name.c_str(), static_cast<unsigned long long>(settings.executions),
              static_cast<unsigned long long>(settings.seed),
              static_cast<unsigned long long>(tally->accepted),
              static_cast<unsigned long long>(tally->refused),
              static_cast<unsigned long long>(tally->faults),
              static_cast<unsigned long long>(crashes), seconds);
  // a corpus that its own reader refuses would test nothing
  const bool idle = settings.executions >= 1000 && (tally->accepted == 0 || tally->refused == 0);
  if (idle)
    std::printf("  %s: all accepted, or all refused: the drill tests nothing\n",
                reader.name.c_str());
  const bool found = crashes > 0 || tally->faults > 0 || idle;
  munmap(tally, sizeof(Tally));
  return found;
}

bool repeatOne(const Reader &reader, const Settings &settings)
{
  const std::string bytes = Mutator(reader.corpus, settings.seed)(settings.only);
  if (!settings.save.empty())
    std::ofstream(settings.save, std::ios::binary) << bytes;
  bool accepted;
  const std::string fault = faultOf(reader, bytes, accepted);
  std::printf("%s\n", !fault.empty() ? printable(fault).c_str()
                      : accepted     ? "accepted"
                                     : "refused");
  return !fault.empty();
}

[[noreturn]] void wrongUsage(const std::string &why)
{
  std::fprintf(stderr, "fuzz_readers: %s; see --help\n", why.c_str());
  std::exit(2);
}

std::uint64_t wholeNumber(const std::string &option, const std::string &text)
{
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    wrongUsage(option + ": '" + text + "' is not allowed, must be a whole number >= 0");
  return value;
}

Settings settingsFrom(int argc, char **argv)
{
  Settings settings;
  for (int k = 1; k < argc; k += 2) {
    const std::string option = argv[k];
    if (option == "--help") {
      std::fputs(usage, stdout);
      std::exit(0);
    }
    if (option == "--list") {
      settings.list = true;
      k--;
      continue;
    }
    if (k + 1 == argc)
      wrongUsage(option + ": no value");
    const std::string value = argv[k + 1];
    if (option == "--reader")
      settings.reader = value;
    else if (option == "--save")
      settings.save = value;
    else if (option == "--executions")
      settings.executions = wholeNumber(option, value);
    else if (option == "--seed")
      settings.seed = wholeNumber(option, value);
    else if (option == "--only") {
      settings.only = wholeNumber(option, value);
      settings.one = true;
    } else
      wrongUsage("unknown option '" + option + "'");
  }
  return settings;
}

} // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): a drill that cannot run ends
int main(int argc, char **argv)
{
  const Settings settings = settingsFrom(argc, argv);
  std::vector<Reader> all = wheelrailReaders();
  for (Reader &reader : pluginReaders())
    all.push_back(std::move(reader));
  if (settings.list)
    for (const Reader &reader : all)
      std::printf("%s\n", reader.name.c_str());
  if (settings.list)
    return 0;
  bool known = false, found = false;
  for (const Reader &reader : all) {
    if (!settings.reader.empty() && settings.reader != reader.name)
      continue;
    known = true;
    if ((settings.one ? repeatOne : drill)(reader, settings))
      found = true;
  }
  if (!known)
    wrongUsage("unknown reader '" + settings.reader + "'");
  return found ? 1 : 0;
}
