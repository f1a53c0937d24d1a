// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_RESULT_HEAD_H
#define WHEELRAIL_CREEP_SWEEP_RESULT_HEAD_H

#include <string>
#include <vector>

namespace wheelrail {

/// A line of what every table and field of a run begins with.
struct HeadLine {
  std::string name;  ///< one lower-case word
  std::string value; ///< without an end of line
};
/// Program and version, axes and bodies, contact with its radii, a layer, friction law.
using ResultHead = std::vector<HeadLine>;

/// \param axes what x, y, a force and a creepage mean
/// \param caseText the complete case, as `CaseReader::configuration` writes it; its groups
///        `contact`, `layer` where there is one, and `friction` become a line each
ResultHead resultHead(const std::string &axes, const std::string &caseText);

/// "# axes: ...\n" for each line: the head of a table.
std::string tableHead(const ResultHead &head);

} // namespace wheelrail
#endif
