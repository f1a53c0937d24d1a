// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/column_file.h"

#include "base/errors.h"
#include "base/number_rows.h"
#include "base/quantity.h"
#include "base/text_lines.h"
#include "shared/nearest_word.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {

namespace {

std::vector<std::string> namesOf(const std::vector<NeededColumn> &columns)
{
  std::vector<std::string> names;
  for (const NeededColumn &column : columns)
    names.push_back(column.name);
  return names;
}

/// \throws std::invalid_argument
double factorOf(const std::string &given, const std::string &unit)
{
  if (unit != "1")
    return parseQuantity("1 " + given, unit);
  if (given != "1" && given != "%")
    throw std::invalid_argument(fmt::format("'{}'; 1 and % are allowed", given));
  return given == "%" ? 0.01 : 1.0;
}

} // namespace

ColumnFile::ColumnFile(std::string path, std::vector<NeededColumn> columns)
    : path_(std::move(path)), columns_(std::move(columns)), unit_(columns_.size()),
      factor_(columns_.size(), 1.0)
{
  const std::string text = readTextFile(path_);
  LineReader lines(text);
  NumberRows reader(path_);
  for (std::string_view raw; lines.next(raw);) {
    const std::string_view line = trimmedView(raw);
    if (line.empty())
      continue;
    if (line[0] == '#')
      readUnit(lines.number(), line);
    else if (place_.empty())
      readNames(lines.number(), reader.cells(lines.number(), raw));
    else
      readRow(lines.number(), reader.cells(lines.number(), raw), reader);
  }
  if (rows.empty())
    fail(0, "", "holds no row of numbers");
}

std::string ColumnFile::asWritten(std::size_t column, double value) const
{
  return fmt::format("{:g} {}", value / factor_[column], unit_[column]);
}

void ColumnFile::fail(int line, const std::string &keyword, const std::string &problem) const
{
  throw badInput(path_, line, keyword, problem);
}

void ColumnFile::readUnit(int line, std::string_view text)
{
  const auto colon = text.find(':');
  if (colon == std::string_view::npos)
    return;
  const std::string_view word = trimmedView(text.substr(1, colon - 1));
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (columns_[k].name != word || columns_[k].unit.empty())
      continue;
    if (!rows.empty() || !unit_[k].empty())
      fail(line, columns_[k].name, "is given once, before the numbers");
    unit_[k] = trimmedView(text.substr(colon + 1));
    try {
      factor_[k] = factorOf(unit_[k], columns_[k].unit);
    } catch (const std::invalid_argument &problem) {
      fail(line, columns_[k].name, problem.what());
    }
  }
}

// A name with the unit in it becomes that of the column.
void ColumnFile::takePercent(int line, std::vector<std::string_view> &names)
{
  for (std::string_view &name : names)
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].unit != "1" || name != columns_[k].name + "_percent")
        continue;
      if (!unit_[k].empty())
        fail(line, columns_[k].name,
             fmt::format("its unit is given once, in '# {}: {}' or in the name '{}'",
                         columns_[k].name, unit_[k], name));
      unit_[k] = "%";
      factor_[k] = factorOf(unit_[k], columns_[k].unit);
      name = columns_[k].name;
    }
}

void ColumnFile::readNames(int line, std::vector<std::string_view> names)
{
  takePercent(line, names);
  cells_ = names.size();
  const std::vector<std::string> known = namesOf(columns_);
  for (const std::string_view name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      fail(line, "", mcawr::unknownWord("column", std::string(name), known));
  for (const NeededColumn &column : columns_) {
    const auto times = std::count(names.begin(), names.end(), column.name);
    if (times > 1 || (times == 0 && !column.otherwise))
      fail(line, "",
           fmt::format("the column '{}' is needed, once: {}", column.name, fmt::join(known, ",")));
    place_.push_back(static_cast<std::size_t>(std::find(names.begin(), names.end(), column.name) -
                                              names.begin()));
  }
  for (std::size_t k = 0; k < columns_.size(); ++k)
    if (columns_[k].needsUnit && place_[k] < cells_ && unit_[k].empty())
      fail(line, known[k], fmt::format("no line '# {}: UNIT' before the numbers", known[k]));
}

void ColumnFile::readRow(int line, const std::vector<std::string_view> &cells, NumberRows &reader)
{
  if (cells.size() != cells_)
    fail(line, "",
         fmt::format("{} cells; {} are expected{}", cells.size(), cells_, reader.decimalHint()));
  Row row{line, {}};
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const NeededColumn &column = columns_[k];
    if (place_[k] == cells_) {
      row.values.push_back(*column.otherwise);
      continue;
    }
    const std::string_view cell = cells[place_[k]];
    const double value = factor_[k] * reader.number(line, column.name, cell);
    if (value < 0.0 || (value == 0.0 && !column.mayBeZero) || value > column.largest) {
      const std::string unit = column.unit == "1" || column.unit.empty() ? "" : " " + column.unit;
      fail(line, column.name,
           fmt::format("'{}' is not allowed, must be {} and at most {:g}{}", cell,
                       column.mayBeZero ? ">= 0" : "> 0", column.largest, unit));
    }
    row.values.push_back(value);
  }
  rows.push_back(std::move(row));
}

} // namespace wheelrail
