// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_PROGRAM_H
#define WHEELRAIL_BASE_PROGRAM_H

#include <optional>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): CLI11's own name
namespace CLI {
class App;
class Validator;
} // namespace CLI

/// What our programs do alike around their work: streams, command line, last words.
namespace wheelrail {

/// Runs a program. Whatever `body` throws becomes one line on stderr, "NAME: what is wrong", and an
/// exit code: that of an Error, Io for an mcawr::OutputError, Internal for everything else.
///
/// Before, the streams are put in order: writing to a stream that is closed, or to a pipe whose
/// reader has gone, fails instead of ending the program or going into a file of ours; so does a
/// file beyond the limit of its size. A library that calls abort() (FFTW does where it gets no
/// memory) ends the program with a line and Internal, too.
/// \param body takes the arguments of `main` and returns the exit code
/// \return exit code of the process
int runProgram(const char *name, int (*body)(int, char **), int argc, char **argv) noexcept;

/// A line on stderr, "NAME: text", shown as `mcawr::printable` does. A stderr that cannot be
/// written is no reason to stop: it is passed over.
void complain(const char *name, const std::string &text) noexcept;

/// Parses the command line. --help and --version are printed.
/// \param extra what to say of an argument too many that is no option
/// \return the exit code when the program is to end: Ok after --help and --version, Usage after a
///         mistake, which was said
/// \throws Error (Io) when help or version cannot be written
std::optional<int> parseCommandLine(CLI::App &app, int argc, char **argv, const char *extra);

/// A whole number in decimal digits (CLI11 itself takes 0x10 for 16 and 010 for 8).
CLI::Validator wholeNumberOption(int low, int high);

/// The name of a file or folder: anything but an empty text.
CLI::Validator nameOption();

} // namespace wheelrail
#endif
