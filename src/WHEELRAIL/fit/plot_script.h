// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_PLOT_SCRIPT_H
#define WHEELRAIL_FIT_PLOT_SCRIPT_H

#include <string>
#include <vector>

namespace wheelrail {

/// Runs a plot script of ours (Python, matplotlib) and waits for it.
///
/// The script is looked for beside the running program, then in ../share/mca-wheelrail from there.
/// The interpreter is $MCAWR_PYTHON, or /usr/bin/python3 (Debian's, which has Debian's matplotlib).
/// The script's own messages go to stderr.
/// @param name such as "plot_fit.py"
/// @return empty if the picture was made, else one line that says why not: a picture that is
///         missing must not spoil a computation
std::string runPlotScript(const std::string &name, const std::vector<std::string> &arguments);

} // namespace wheelrail

#endif
