// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_COMMA_LOCALE_H
#define MCAWR_COMMA_LOCALE_H

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>
#include <unistd.h>

/// As long as it lives, the program is in a locale that writes 1.234,5, as a host program may be
/// (Qt, Python's locale.setlocale): streams by a facet, C's functions by German, which is compiled
/// for the purpose where the system can ("localedef" and its sources).
class CommaLocale {
 public:
  CommaLocale()
      : streams_(std::locale::global(std::locale(std::locale::classic(), new Punctuation))),
        folder_(std::filesystem::temp_directory_path() / ("comma-" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(folder_);
    const std::string command =
        "localedef -i de_DE -f UTF-8 '" + (folder_ / "de_DE.UTF-8").string() + "' >/dev/null 2>&1";
    setenv("LOCPATH", folder_.c_str(), 1);
    inC_ = std::system(command.c_str()) == 0 && std::setlocale(LC_ALL, "de_DE.UTF-8");
  }
  ~CommaLocale()
  {
    std::setlocale(LC_ALL, "C");
    std::locale::global(streams_);
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder_);
  }
  CommaLocale(const CommaLocale &) = delete;
  CommaLocale &operator=(const CommaLocale &) = delete;
  /// Do C's functions write commas, too?
  bool inC() const { return inC_; }

 private:
  struct Punctuation : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale streams_;
  std::filesystem::path folder_;
  bool inC_ = false;
};

#endif
