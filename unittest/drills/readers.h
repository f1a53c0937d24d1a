// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef DRILLS_READERS_H
#define DRILLS_READERS_H

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

/// A file that a reader refuses, with its line for the user: what is expected.
class Refused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that a reader should not have taken, or that it took for another: a fault.
class Fault : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A reader of files of the project's programs, as the drills call it.
struct Reader {
  std::string name;
  std::vector<std::string> corpus; ///< good files
  /// Reads the bytes and checks what it got. Returns when the file was accepted and is what it
  /// seems; throws Refused, Fault, or anything else, which is a fault too.
  std::function<void(const std::string &)> read;
};

/// \throws Fault
inline void require(bool good, const std::string &what)
{
  if (!good)
    throw Fault(what);
}

/// Contents of the project's files of this ending in a folder, in the order of their names.
std::vector<std::string> filesOf(const std::string &folder, const std::string &ending);

/// Readers of wr_fit and wr_creep.
std::vector<Reader> wheelrailReaders();
/// Readers of the plugin, without LAMMPS.
std::vector<Reader> pluginReaders();

#endif
