// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_READER_H
#define WHEELRAIL_CREEP_CASE_READER_H

#include "creep/case_file.h"

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace YAML {
class Node;
}

namespace wheelrail {

/// The values of a case file and of the changes from the command line, each checked against its
/// keyword in the table when it comes in: form, unit, range. What values mean together is none of
/// its business (case_file.cpp).
///
/// Everything that is wrong is an Error (BadInput) with file, line and keyword, or an Error (Usage)
/// that names --set.
class CaseReader {
 public:
  explicit CaseReader(std::string fileName) : file_(std::move(fileName)) {}

  /// Reads and checks the whole file; once, before any change.
  void readFile();
  /// "keyword=value", in place of what the file says.
  void change(const std::string &text);

  /// Throws what is wrong with a keyword's value, at its line of the file.
  [[noreturn]] void fail(const std::string &keyword, const std::string &problem) const;

  /// Is the keyword given, in the file or by a change?
  bool has(const std::string &name) const { return entries_.count(name) > 0; }
  /// Any keyword below a group? @param group without a dot
  bool hasGroup(const std::string &group) const;

  /// The value with its default filled in and recorded for `configuration`. Quantities are in the
  /// keyword's SI unit. A keyword without a default has to be there.
  const std::vector<std::string> &words(const std::string &name) { return use(name).words; }
  const std::vector<double> &numbers(const std::string &name) { return use(name).numbers; }
  double number(const std::string &name) { return numbers(name).front(); }
  const std::string &word(const std::string &name) { return words(name).front(); }
  bool flag(const std::string &name) { return word(name) == "true"; }
  int integer(const std::string &name) { return static_cast<int>(number(name)); }
  /// Of a keyword that takes a list elsewhere, where there may be one value only.
  double single(const std::string &name);
  /// A default that depends on other keywords; does nothing where the file has a value.
  void setDefault(const std::string &name, const std::string &value);
  /// @throws Error (BadInput) unless the keyword is given
  void require(const std::string &name) const;
  /// @throws Error (BadInput) for a keyword that is given and makes no sense together with
  ///         something else. @param with "contact.period: the surfaces are flat"
  void refuse(std::initializer_list<const char *> names, const std::string &with) const;

  /// What was used so far, as a case file.
  std::string configuration() const;

 private:
  /// A value as it stands in the file or on the command line, and the numbers it holds.
  struct Entry {
    std::vector<std::string> words;
    std::vector<double> numbers; ///< in the keyword's unit; empty where it takes words
    bool isList = false;
    int line = 0; ///< 0: from the command line
  };

  [[noreturn]] void fail(int line, const std::string &keyword, const std::string &problem) const;
  /// Takes in a node of YAML that stands at a keyword or group; "" is the whole file.
  void collect(const YAML::Node &node, const std::string &name);
  Entry entryOf(const YAML::Node &node, const Keyword &keyword) const;
  double checkedNumber(const Keyword &keyword, const std::string &word, int line) const;
  void checkWord(const Keyword &keyword, const std::string &word, int line) const;
  const Entry &use(const std::string &name);

  std::string file_;
  bool onCommandLine_ = false;
  std::map<std::string, Entry> entries_, used_;
};

/// The table's row of a keyword; null for other words.
const Keyword *findKeyword(const std::string &name);

/// The words that a keyword of kind Choice allows.
std::vector<std::string> choicesOf(const Keyword &keyword);

} // namespace wheelrail
#endif
