// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_FILE_ENDING_H
#define WHEELRAIL_BASE_FILE_ENDING_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace wheelrail {

/// The ending of a file's name in small letters, with its dot: ".csv"; empty: it has none.
inline std::string fileEnding(const std::string &path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

} // namespace wheelrail
#endif
