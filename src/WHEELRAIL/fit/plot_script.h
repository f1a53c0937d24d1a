// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_FIT_PLOT_SCRIPT_H
#define WHEELRAIL_FIT_PLOT_SCRIPT_H

#include <array>
#include <string>

namespace wheelrail {

/// A picture, or why there is none.
struct Picture {
  std::string bytes;   ///< content of the picture's file
  std::string problem; ///< one line; empty: the picture was made
};

/// Endings of pictures that matplotlib writes, with their dot.
inline constexpr std::array pictureEndings = {".png", ".pdf",  ".svg", ".eps",  ".ps",
                                              ".jpg", ".jpeg", ".tif", ".tiff", ".webp"};

/// Runs a plot script of ours (Python, matplotlib) and waits for it. Data and picture go through
/// memory: no file is written.
///
/// The script is looked for beside the running program, then in ../share/mca-wheelrail from there.
/// The interpreter is $MCAWR_PYTHON, or /usr/bin/python3 (Debian's, which has Debian's matplotlib).
/// The script's own messages go to stderr.
/// \param name such as "plot_fit.py"
/// \param json the data that the script is given
/// \param ending of the picture's name, with its dot: decides the format; empty: PNG
/// \return never throws for a picture that cannot be made: it must not spoil a computation
Picture makePicture(const std::string &name, const std::string &json, const std::string &ending);

} // namespace wheelrail

#endif
