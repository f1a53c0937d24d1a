// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_COLUMN_FILE_H
#define WHEELRAIL_BASE_COLUMN_FILE_H

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wheelrail {

class NumberRows;

/// A column that a file has to have.
struct NeededColumn {
  std::string name;
  std::string unit; ///< in which numbers are handed on: "Pa"; "1" for a ratio; "" for a number
  bool needsUnit;   ///< whether a line "# NAME: UNIT" has to say the file's unit
  bool mayBeZero;   ///< numbers are >= 0, not > 0
  double largest;   ///< in `unit`
  /// Value in all rows of a file without this column; absent: the column is needed.
  std::optional<double> otherwise = std::nullopt;
};

/// Named columns of numbers (CSV) with their units in comments:
///
///     # pressure: MPa
///     pressure,speed,mu
///     500,1,0.4
///
/// A unit stands once, before the numbers; of a ratio it is 1 or %, else as UDUNITS-2 spells it. A
/// column NAME_percent is the ratio NAME in %. Comments without a column's name are free text.
/// Columns may stand in any order, and each has to be there once, but for those that have a value
/// `otherwise`. Rows are read by `NumberRows`.
class ColumnFile {
 public:
  /// \param columns in the order in which numbers are handed on
  /// \throws Error (BadInput) for a file that cannot be read, that is not as said above, that holds
  ///         a number out of range, or no row
  ColumnFile(std::string path, std::vector<NeededColumn> columns);

  struct Row {
    int line; ///< of the file, from 1 on
    std::vector<double> values;
  };
  std::vector<Row> rows; ///< not empty

  /// A number of a row in the unit of the file, with that unit: "500 MPa".
  std::string asWritten(std::size_t column, double value) const;

  /// \param line 0: of the whole file
  [[noreturn]] void fail(int line, const std::string &keyword, const std::string &problem) const;

 private:
  void readUnit(int line, std::string_view text);
  void readNames(int line, std::vector<std::string_view> names);
  void takePercent(int line, std::vector<std::string_view> &names);
  void readRow(int line, const std::vector<std::string_view> &cells, NumberRows &reader);

  std::string path_;
  std::vector<NeededColumn> columns_;
  std::vector<std::string> unit_;  ///< of the file; empty: not given
  std::vector<double> factor_;     ///< units handed on per unit of the file
  std::vector<std::size_t> place_; ///< of each column in a row; empty: no line of names yet
  std::size_t cells_ = 0;          ///< of a row
};

} // namespace wheelrail
#endif
