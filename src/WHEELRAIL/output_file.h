#ifndef WHEELRAIL_OUTPUT_FILE_H
#define WHEELRAIL_OUTPUT_FILE_H

#include <string>

namespace wheelrail {

/// The whole text of an input file.
/// @throws Error (BadInput) when it is missing, a folder, empty or cannot be read
std::string readInputFile(const std::string &path);

/// Writes a file whole or not at all: a temporary file beside it, fsync, rename. Whatever stood
/// under `path` before stays untouched until the new content is safely on disk.
/// @throws Error (Io) with the system's reason; the temporary file is removed
void writeOutputFile(const std::string &path, const std::string &content);

/// Makes the folder (and its parents) and checks that files can be written into it, so that a
/// long computation does not end at an unwritable folder.
/// @throws Error (Io)
void prepareOutputFolder(const std::string &path);

} // namespace wheelrail
#endif
