// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/result_text.h"

#include "base/errors.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace wheelrail {
namespace {

[[noreturn]] void failFinite(const std::string &name, const std::string &place,
                             const std::string &value)
{
  throw Error(ExitCode::NotConverged,
              fmt::format("{}: {} is {}: the numbers of the case are beyond what double precision "
                          "can compute with",
                          name, place, value));
}

/// \param fail called with the place of the first number that is not finite, and the number
template<class Json, class Fail>
void search(const Json &json, const std::string &place, const Fail &fail)
{
  if (json.is_number_float() && !std::isfinite(json.template get<double>()))
    fail(place, json.template get<double>());
  if (json.is_structured())
    for (const auto &item : json.items())
      search(item.value(), place + "/" + item.key(), fail);
}

std::vector<std::string> cellsOf(const std::string &line)
{
  std::istringstream in(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(in, cell, ',');)
    cells.push_back(cell);
  return cells;
}

} // namespace

std::string jsonText(const std::string &name, const nlohmann::ordered_json &json, int indent)
{
  search(json, "", [&](const std::string &place, double value) {
    failFinite(name, place, fmt::format("{}", value));
  });
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

const std::string &finiteTable(const std::string &name, const std::string &table)
{
  std::istringstream lines(table);
  std::vector<std::string> columns;
  int row = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind('#', 0) == 0)
      continue;
    const std::vector<std::string> cells = cellsOf(line);
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    ++row;
    for (std::size_t k = 0; k < cells.size(); ++k)
      for (const char *word : {"nan", "-nan", "inf", "-inf"})
        if (cells[k] == word)
          failFinite(name, fmt::format("{} of row {}", columns.at(k), row), word);
  }
  return table;
}

bool isFinite(const nlohmann::json &json)
{
  bool finite = true;
  search(json, "", [&](const std::string &, double) { finite = false; });
  return finite;
}

} // namespace wheelrail
