// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CASE_TEXT_H
#define WHEELRAIL_CASE_TEXT_H

#include "base/program_files.h"
#include "creep/case/case_file.h"

#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

/// Case files that are written down in a test.
namespace case_text {

/// Table 2 of the paper.
inline const std::string table2 = "contact: {load_per_length: 4000 N/mm, radius: 0.5 m,\n"
                                  "          youngs_modulus: 210 GPa, poissons_ratio: 0.3}\n";

inline wheelrail::Case read(const std::string &text, const std::vector<std::string> &changes = {})
{
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("wr-case-{}.yaml", ::getpid()))
          .string();
  wheelrail::writeOutputFile(path, text);
  const auto remove = [&] { std::filesystem::remove(path); };
  try {
    wheelrail::Case result = wheelrail::readCase(path, changes);
    remove();
    return result;
  } catch (...) {
    remove();
    throw;
  }
}

/// A case of rolling, and one without.
inline wheelrail::CreepSpecification rolling(const std::string &text,
                                             const std::vector<std::string> &changes = {})
{
  return std::get<wheelrail::CreepSpecification>(read(text, changes).task);
}
inline wheelrail::StaticSpecification still(const std::string &text,
                                            const std::vector<std::string> &changes = {})
{
  return std::get<wheelrail::StaticSpecification>(read(text, changes).task);
}

} // namespace case_text

#endif
