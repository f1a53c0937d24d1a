// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_PRINTABLE_H
#define MCAWR_SHARED_PRINTABLE_H

#include <string>
#include <string_view>

namespace mcawr {

/// A text as one line that a terminal shows and does not obey: control characters of ASCII and of
/// Unicode's C1 block, and bytes that are no UTF-8, become \n, \r, \t or \xNN. All else stays, the
/// backslash too, so that a text that went through once does not change again.
///
/// For whatever a message says of somebody else's file, argument or file name.
std::string printable(std::string_view text);

/// Makes a text of several lines printable: every '\n' stays.
std::string printableLines(std::string_view text);

/// A message without its middle where it is long: it quotes what stands in somebody else's file,
/// which may be all of it on one line. What is wrong stands at the end.
/// \return up to 400 bytes as they are; of more about the first 120 and the last 160, cut between
///         characters of UTF-8
std::string shortened(const std::string &text);

} // namespace mcawr
#endif
