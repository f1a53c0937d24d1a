// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_NUMBER_ROWS_H
#define WHEELRAIL_BASE_NUMBER_ROWS_H

#include <string>
#include <string_view>
#include <vector>

namespace wheelrail {

/// Rows of numbers of a text file, read strictly: one separator in the whole file, no empty cell,
/// one decimal sign.
///
/// The first row decides the separator: a semicolon where it holds one, else a tab, else a comma,
/// else blanks. Blanks around a separator do not count. Where a semicolon or a tab separates, a
/// decimal comma is read ("0,5"), as half of Europe's spreadsheets write it; then no number of the
/// file may have a decimal point. Where commas or blanks separate, a decimal comma cannot be told
/// from a separator: a row that looks so is refused and named.
class NumberRows {
 public:
  /// \param path for messages
  explicit NumberRows(std::string path) : path_(std::move(path)) {}

  /// Before the first row: it has one column, so that a comma in it is a decimal one.
  void expectOneColumn() { oneColumn_ = true; }

  /// Cells of a row, in words or numbers. The row must outlive them.
  /// \param line of the file, from 1 on, for messages
  /// \throws Error (BadInput) for an empty cell
  std::vector<std::string_view> cells(int line, std::string_view row);

  /// \param column as the message shall name it: "column 3", "mu"
  /// \return finite
  /// \throws Error (BadInput) for what is no number of this file
  double number(int line, const std::string &column, std::string_view cell);

  /// Adds the numbers of a row. \return how many
  /// \param unmeasured is "nan" allowed, and read as NaN?
  /// \throws Error (BadInput)
  long append(int line, std::string_view row, bool unmeasured, std::vector<double> &values);

  /// To be added to a message about a number of columns: empty, or that decimal commas may be why.
  std::string decimalHint() const;

 private:
  /// \param column gives its name, for a message
  template<class Name>
  double parsed(int line, std::string_view cell, const Name &column);
  void chooseSeparator(int line, std::string_view row);
  void refuseDecimalCommas(int line) const;

  std::string path_;
  char separator_ = '\0'; ///< '\0': not known yet
  bool oneColumn_ = false;
  int commaLine_ = 0, pointLine_ = 0; ///< where the first decimal comma and point stand; 0: none
};

} // namespace wheelrail
#endif
