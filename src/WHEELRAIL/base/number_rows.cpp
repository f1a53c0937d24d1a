// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/number_rows.h"

#include "base/errors.h"
#include "base/quantity.h"
#include "shared/plain_number.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace wheelrail {
namespace {

constexpr const char *readCommas =
    "a decimal comma is read where semicolons or tabs stand between the numbers";

bool isDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The part of a number after its decimal comma: digits, and a power of ten perhaps.
bool looksFractional(std::string_view cell)
{
  return !cell.empty() && isDigit(cell[0]) && cell.find('.') == std::string_view::npos;
}

/// Are pairs of cells numbers that decimal commas have cut: "-0", "5" of "-0,5" and "0", "05" of
/// "0,05"? No row of whole numbers is written so, each second one without a sign.
bool looksCut(const std::vector<std::string_view> &cells)
{
  if (cells.size() % 2 != 0)
    return false;
  bool telling = false;
  for (std::size_t k = 0; k < cells.size(); k += 2) {
    const std::string_view whole = cells[k], part = cells[k + 1];
    if (whole.find('.') != std::string_view::npos || !looksFractional(part))
      return false;
    telling = telling || whole == "-0" || (part.size() > 1 && part[0] == '0' && isDigit(part[1]));
  }
  return telling;
}

std::string_view withoutEnds(std::string_view text, const char *blanks)
{
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

} // namespace

void NumberRows::chooseSeparator(int line, std::string_view row)
{
  const auto holds = [&](char c) { return row.find(c) != std::string_view::npos; };
  separator_ = holds(';') ? ';' : holds('\t') ? '\t' : holds(',') && !oneColumn_ ? ',' : ' ';
  if (separator_ != ',')
    return;
  // "0,5, 0,7": pairs of which the first comma has no blank behind it and the second one has
  std::vector<bool> blankBefore;
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at <= row.size();) {
    const std::size_t end = std::min(row.find(',', at), row.size());
    const std::string_view cell = row.substr(at, end - at);
    blankBefore.push_back(!cell.empty() && cell[0] == ' ');
    words.push_back(withoutEnds(cell, " \t"));
    at = end + 1;
  }
  bool pairs = words.size() >= 4 && words.size() % 2 == 0;
  for (std::size_t k = 1; k < words.size() && pairs; ++k)
    pairs = k % 2 ? !blankBefore[k] && looksFractional(words[k]) : blankBefore[k];
  if (pairs)
    refuseDecimalCommas(line);
}

void NumberRows::refuseDecimalCommas(int line) const
{
  throw badInput(path_, line, "",
                 fmt::format("decimal commas that cannot be told from separators; {}", readCommas));
}

std::string NumberRows::decimalHint() const
{
  return separator_ == ',' ? fmt::format(" ({})", readCommas) : "";
}

std::vector<std::string_view> NumberRows::cells(int line, std::string_view row)
{
  if (separator_ == '\0')
    chooseSeparator(line, row);
  std::vector<std::string_view> cells;
  const char *around = separator_ == '\t' ? " \r" : " \t\r";
  for (std::string_view rest = separator_ == ' ' ? withoutEnds(row, " \t\r") : row;;) {
    const std::size_t end = std::min(rest.find(separator_), rest.size());
    cells.push_back(withoutEnds(rest.substr(0, end), around));
    if (cells.back().empty())
      throw badInput(path_, line, fmt::format("column {}", cells.size()), "is empty");
    if (end == rest.size())
      return cells;
    rest.remove_prefix(end + 1);
    if (separator_ == ' ')
      rest = withoutEnds(rest, " \t\r");
  }
}

template<class Name>
double NumberRows::parsed(int line, std::string_view cell, const Name &column)
{
  const auto fail = [&](const std::string &problem) {
    throw badInput(path_, line, column(), problem);
  };
  const bool mayHaveComma = separator_ == ';' || separator_ == '\t' || oneColumn_;
  if (const auto comma = cell.find(','); comma != std::string_view::npos && mayHaveComma) {
    std::string withPoint(cell);
    withPoint[comma] = '.';
    const auto value = mcawr::plainNumber(withPoint);
    const bool digitsFollow = comma + 1 < cell.size() && isDigit(cell[comma + 1]);
    if (!value || !digitsFollow || cell.find('.') != std::string_view::npos)
      fail(fmt::format("'{}' is not a number with a decimal comma", cell));
    if (pointLine_ > 0)
      fail(fmt::format("'{}' has a decimal comma; line {} has a decimal point", cell, pointLine_));
    commaLine_ = commaLine_ > 0 ? commaLine_ : line;
    return *value;
  }
  const auto value = mcawr::plainNumber(cell);
  if (!value) {
    try {
      parseNumber(std::string(cell)); // says what is wrong
    } catch (const std::invalid_argument &problem) {
      const bool hint = std::any_of(cell.begin(), cell.end(), isDigit) &&
                        cell.find_first_of(", \t;") != std::string_view::npos;
      fail(hint ? fmt::format("{}; {}", problem.what(), readCommas) : problem.what());
    }
  }
  if (cell.find('.') != std::string_view::npos) {
    if (commaLine_ > 0)
      fail(fmt::format("'{}' has a decimal point; line {} has a decimal comma", cell, commaLine_));
    pointLine_ = pointLine_ > 0 ? pointLine_ : line;
  }
  return *value;
}

double NumberRows::number(int line, const std::string &column, std::string_view cell)
{
  return parsed(line, cell, [&] { return column; });
}

long NumberRows::append(int line, std::string_view row, bool unmeasured,
                        std::vector<double> &values)
{
  const std::vector<std::string_view> found = cells(line, row);
  if (separator_ == ',' && looksCut(found))
    refuseDecimalCommas(line);
  long count = 0;
  for (const std::string_view cell : found) {
    ++count;
    if (unmeasured && (cell == "nan" || cell == "NaN" || cell == "NAN"))
      values.push_back(std::numeric_limits<double>::quiet_NaN());
    else
      values.push_back(parsed(line, cell, [&] { return fmt::format("column {}", count); }));
  }
  return count;
}

} // namespace wheelrail
