// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_PROGRAM_FILES_H
#define WHEELRAIL_BASE_PROGRAM_FILES_H

#include <string>
#include <vector>

namespace wheelrail {

/// The whole text of an input file.
/// \throws Error (BadInput) when it is missing, a folder, empty or cannot be read
std::string readInputFile(const std::string &path);

/// Writes a file whole or not at all, as shared/output_file.h does.
/// \throws Error (Io) with the system's reason; the temporary file is removed
void writeOutputFile(const std::string &path, const std::string &content);

/// Prints lines, and makes sure that they arrived: a full disk is an error here too. Control
/// characters that came in with a name are shown, not obeyed (`mcawr::printableLines`).
/// \throws Error (Io)
void writeStandardOutput(const std::string &text);

/// A file that a command line asks for, and the option that names it.
struct RequestedOutput {
  std::string option, path;
};

/// To be called before a long computation. Looks at the disk: another name of a file is the same
/// file.
/// \throws Error (Usage) for an output that is one of the inputs or another output too; Error (Io)
///         for one that cannot be written
void checkOutputs(const std::vector<RequestedOutput> &outputs,
                  const std::vector<std::string> &inputs);

/// Makes the folder (and its parents) and checks that files can be written into it, so that a
/// long computation does not end at an unwritable folder.
/// \throws Error (Io)
void prepareOutputFolder(const std::string &path);

} // namespace wheelrail
#endif
