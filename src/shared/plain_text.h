// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_PLAIN_TEXT_H
#define MCAWR_SHARED_PLAIN_TEXT_H

#include <string>
#include <string_view>

namespace mcawr {

/// A text as its readers want it: UTF-8 without a byte order mark, lines that end with '\n'.
struct PlainText {
  std::string text;
  /// Empty, or why it is no text that can be read: "is UTF-16 without a byte order mark; ...".
  std::string problem;
};

/// Reads what other machines write: lines that end with "\r\n" (Windows) or '\r' (old Macs), UTF-8
/// and UTF-16 with a byte order mark, Latin-1 (whatever is no UTF-8: the micro sign is 0xb5 there).
/// What has been plain once stays as it is.
/// \param bytes of the whole file
/// \return a problem for UTF-16 without a mark, UTF-32, and bytes that are 0, which no text has
PlainText plainText(std::string_view bytes);

/// Do they begin with a byte order mark, of UTF-8, UTF-16 or UTF-32?
bool hasTextMark(std::string_view bytes);

} // namespace mcawr
#endif
