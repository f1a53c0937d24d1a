// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_TEXT_LINES_H
#define WHEELRAIL_BASE_TEXT_LINES_H

#include <string>
#include <string_view>

namespace wheelrail {

/// The bytes of a file as plain text (`mcawr::plainText`): UTF-8 without a mark, '\n' at the ends.
/// \param path for the message
/// \throws Error (BadInput) for what is no text, or text in a code that must be saved anew
std::string plainTextOf(const std::string &path, std::string_view bytes);

/// `plainTextOf` of a whole input file. \throws Error (BadInput), also as `readInputFile`
std::string readTextFile(const std::string &path);

/// Without blanks at either end.
std::string_view trimmedView(std::string_view text);

/// Lines of a plain text, without their ends, counted from 1.
/// The text must outlive the reader and the lines that it gives.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  /// \return false at the end
  /// \param line a view into the text, set unless the text is at its end
  bool next(std::string_view &line);
  int number() const { return number_; } ///< of the line last given

 private:
  std::string_view rest_;
  int number_ = 0;
};

} // namespace wheelrail
#endif
