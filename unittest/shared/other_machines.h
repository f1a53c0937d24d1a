// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_OTHER_MACHINES_H
#define MCAWR_OTHER_MACHINES_H

#include <string>
#include <utility>
#include <vector>

/// (what it is, bytes): a text of ASCII as other machines and editors save it.
inline std::vector<std::pair<std::string, std::string>> asOtherMachinesSave(const std::string &text)
{
  std::string windows, mac, little = "\xff\xfe", big = "\xfe\xff";
  for (const char c : text) {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
    little += {c, '\0'};
    big += {'\0', c};
  }
  return {{"CRLF", windows},
          {"CR", mac},
          {"a mark of UTF-8", "\xef\xbb\xbf" + text},
          {"UTF-16, low byte first", little},
          {"UTF-16, high byte first", big}};
}

/// The text in UTF-16 without a mark, which is refused.
inline std::string withoutMark(const std::string &text)
{
  return asOtherMachinesSave(text)[3].second.substr(2);
}

#endif
