// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_MEASURED_FILE_H
#define WHEELRAIL_CONTACT_MEASURED_FILE_H

#include <Eigen/Core>

#include <string>

namespace wheelrail {

/// What a measured profile and a measured map have in common: files that are something else, and
/// heights that are none.

/// Refuses a transverse profile of wheel or rail, told by the ending of its name (.prr, .prw, .whl,
/// .ban, .slcs): it is the shape of the body, not its roughness.
/// \throws Error (BadInput) that says what the file is and where its radii go
void refuseTransverseProfile(const std::string &path);

/// Do heights at one end of their range stand for "not measured" (-9999, 0, the largest integer)?
/// They do where two or more are the same and further from all others than these are from each
/// other; a single one, where it is ten times as far.
/// \param heights m; NaN does not count
/// \param advice what to do about them, the end of the line
/// \return a line that says how many and which; empty: none do
std::string isolatedHeights(const std::string &path, const Eigen::VectorXd &heights,
                            const char *advice);

} // namespace wheelrail
#endif
