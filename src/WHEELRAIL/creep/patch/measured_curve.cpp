// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/measured_curve.h"

#include "base/errors.h"
#include "base/number_rows.h"
#include "base/quantity.h"
#include "base/text_lines.h"
#include "shared/nearest_word.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>

namespace wheelrail {
namespace {

enum Column { Creep, Speed, Ratio, Columns };
const std::vector<std::string> names = {"creep", "speed", "traction_ratio"};
constexpr std::array<double, Columns> largest = {10.0, 1000.0, 10.0}; ///< -, m/s, -

class CurveFile {
 public:
  explicit CurveFile(const std::string &path) : path_(path), rows_(path)
  {
    const std::string text = readTextFile(path);
    LineReader lines(text);
    for (std::string_view raw; lines.next(raw);) {
      line_ = lines.number();
      const std::string_view line = trimmedView(raw);
      if (line.empty())
        continue;
      if (line[0] == '#')
        readUnit(line);
      else if (place_.empty())
        readNames(rows_.cells(line_, raw));
      else
        readRow(rows_.cells(line_, raw));
    }
    line_ = 0;
    if (curve.empty())
      fail("", "holds no row of numbers");
  }

  std::vector<MeasuredTraction> curve;

 private:
  [[noreturn]] void fail(const std::string &column, const std::string &problem) const
  {
    throw badInput(path_, line_, column, problem);
  }

  void readUnit(std::string_view line)
  {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
      return;
    const std::string word(trimmedView(line.substr(1, colon - 1)));
    const std::string unit(trimmedView(line.substr(colon + 1)));
    if (word != "speed" && word != "creep")
      return;
    if (!curve.empty())
      fail(word, "is given before the numbers");
    try {
      if (word == "speed")
        factor_[Speed] = parseQuantity("1 " + unit, "m/s");
      else if (unit == "%")
        factor_[Creep] = 0.01;
      else if (unit != "1")
        fail(word, fmt::format("'{}'; 1 and % are allowed", unit));
    } catch (const std::invalid_argument &problem) {
      fail(word, problem.what());
    }
  }

  void readNames(const std::vector<std::string_view> &cells)
  {
    for (const std::string_view cell : cells)
      if (std::find(names.begin(), names.end(), cell) == names.end())
        fail("", mcawr::unknownWord("column", std::string(cell), names));
    for (const std::string &name : names) {
      if (std::count(cells.begin(), cells.end(), name) != 1)
        fail("", fmt::format("the column '{}' is needed, once: creep,speed,traction_ratio", name));
      place_.push_back(
          static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) - cells.begin()));
    }
    if (factor_[Speed] == 0.0)
      fail("speed", "no line '# speed: UNIT' before the numbers");
  }

  void readRow(const std::vector<std::string_view> &cells)
  {
    if (cells.size() != Columns)
      fail("", fmt::format("{} cells; {} are expected{}", cells.size(), int(Columns),
                           rows_.decimalHint()));
    std::array<double, Columns> row{};
    for (int column = 0; column < Columns; ++column) {
      const std::string_view cell = cells[place_[column]];
      row[column] = factor_[column] * rows_.number(line_, names[column], cell);
      if (!(row[column] > 0.0) || row[column] > largest[column])
        fail(names[column], fmt::format("'{}' is not allowed, must be > 0 and at most {:g}{}", cell,
                                        largest[column], column == Speed ? " m/s" : ""));
    }
    curve.push_back({row[Creep], row[Speed], row[Ratio]});
  }

  std::string path_;
  NumberRows rows_;
  int line_ = 0;
  std::array<double, Columns> factor_ = {1.0, 0.0, 1.0}; ///< SI units per unit of the file
  std::vector<std::size_t> place_; ///< of each column in a row; empty: no line of names yet
};

} // namespace

std::vector<MeasuredTraction> readMeasuredCurve(const std::string &path)
{
  return CurveFile(path).curve;
}

} // namespace wheelrail
