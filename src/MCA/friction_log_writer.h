// SPDX-License-Identifier: GPL-2.0-or-later
/// \file friction_log_writer.h
/// Writes the friction log (format `mca-friction 1`, doc/friction_log.md). No LAMMPS type in here.
#ifndef MCA_FRICTION_LOG_WRITER_H
#define MCA_FRICTION_LOG_WRITER_H

#include "laws/material.h"
#include "units.h"

#include <cstdio>
#include <string>
#include <vector>

namespace mca {

/// Everything that the log says about its run; in units of the run.
struct LogHeader {
  Material material;
  double pressure, velocity; ///< loading
  double width, thickness;   ///< geometry
  std::string packing;       ///< its name: hex, fcc, hcp, sc
  long long automata;
  std::vector<std::string> laws; ///< keyword-value pairs of pair_style
  double timestep;
  long long every, seed;
  int lammpsVersion;
};

/// One row, in units of the log.
struct LogRow {
  long long step;
  double time, displacement, shearStress, normalStress, mu;
  double links, broken, formed, gap;
};

class FrictionLogWriter {
 public:
  ~FrictionLogWriter();

  /// Begins a new log (whole header at once), or continues one: rows after `step` are dropped.
  /// \throws std::runtime_error with one line when the file cannot be written or continued
  void begin(const std::string &path, const LogHeader &, const Units &);
  void resume(const std::string &path, long long step);

  /// Appends a row and flushes it.
  void write(const LogRow &);

  bool isOpen() const { return file_ != nullptr; }

 private:
  std::FILE *file_ = nullptr;
  std::string path_;
  void close();
  void replaceBy(const std::string &text);
};

} // namespace mca

#endif
