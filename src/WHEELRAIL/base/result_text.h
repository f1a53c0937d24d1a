// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_RESULT_TEXT_H
#define WHEELRAIL_BASE_RESULT_TEXT_H

#include <nlohmann/json_fwd.hpp>
#include <string>

/// The last check of what programs write: no nan and no infinity gets into a file unseen.
namespace wheelrail {

/// The text of a JSON file, with an end of line. Bytes that are no UTF-8 (of a file's name) are
/// replaced by U+FFFD.
/// \param indent blanks of each level; -1: all in one line
/// \throws Error (NotConverged) for a number that is not finite: "NAME: /contacts/0/seconds is
///         nan"; a number that may be missing is null
std::string jsonText(const std::string &name, const nlohmann::ordered_json &json, int indent = 2);

/// Checks that a table has finite numbers only: '#' lines, a line of column names, rows of cells.
/// \return the table
/// \throws Error (NotConverged) that names column and row
const std::string &finiteTable(const std::string &name, const std::string &table);

/// And for a journal's rows. \return whether all numbers are finite
bool isFinite(const nlohmann::json &json);

} // namespace wheelrail
#endif
