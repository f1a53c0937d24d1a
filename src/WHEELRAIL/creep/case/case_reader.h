// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_CASE_READER_H
#define WHEELRAIL_CREEP_CASE_CASE_READER_H

#include "creep/case/keywords.h"

#include <functional>
#include <map>
#include <set>
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
/// Order of use: `readFile`, any number of `change`, then the values. What is read is recorded, so
/// that `configuration` can write it out with every default filled in.
class CaseReader {
 public:
  /// \param fileName path as messages name it; the file is not opened yet
  explicit CaseReader(std::string fileName) : file_(std::move(fileName)) {}

  /// Reads and checks the whole file; once, before any change.
  /// A word that is no keyword is an error that names the nearest one; so is a keyword given twice.
  void readFile();
  /// Reads and checks a text that stands in no file, or a tree that somebody else has built, whose
  /// values have no lines.
  void readText(const std::string &text);
  void readTree(const YAML::Node &root);
  /// "keyword=value", in place of what the file says.
  /// A change of a group's name ends what stands below it ("creep=[..]" ends creep.from), and a
  /// change below a group ends a plain value of the group ("roughness.seed=2" ends "roughness:
  /// none").
  void change(const std::string &text);
  /// A change whose value is a tree.
  /// \param given   the keyword or group, by whatever name it has
  /// \param option  "--set " where a command line asked for it; has to live as long as the reader
  void change(const std::string &given, const YAML::Node &value, const char *option = "");

  /// Throws what is wrong with a keyword's value, at its line of the file, or with the change's
  /// option. \param problem rest of the sentence: "must be above creep.from"
  [[noreturn]] void fail(const std::string &keyword, const std::string &problem) const;

  /// Is the keyword given, in the file or by a change?
  bool has(const std::string &name) const { return entries_.count(name) > 0; }
  /// Any keyword below a group?
  /// \param group  without a dot
  /// \return true for "creep" where creep.from is given
  bool hasGroup(const std::string &group) const;
  /// Has a change named the keyword or its group?
  bool isChanged(const std::string &name) const;

  /// The value with its default filled in and recorded for `configuration`. Quantities are in the
  /// keyword's SI unit. A keyword without a default has to be there.
  /// Words as they stand in the file; choices and switches were checked against the table.
  const std::vector<std::string> &words(const std::string &name) { return use(name).words; }
  const std::vector<double> &numbers(const std::string &name) { return use(name).numbers; }
  /// The first value where there are several: meant for keywords that take just one.
  double number(const std::string &name) { return numbers(name).front(); }
  const std::string &word(const std::string &name) { return words(name).front(); }
  bool flag(const std::string &name) { return word(name) == "true"; }
  int integer(const std::string &name) { return static_cast<int>(number(name)); }
  /// The default of a keyword that takes one number and has one, whatever is given; not recorded.
  double initial(const std::string &name) const;
  /// Value of a keyword that takes a list elsewhere, where only one is allowed.
  double single(const std::string &name);
  /// A default that depends on other keywords; does nothing where the file has a value.
  /// \param value in YAML, with its unit: checked as if it stood in the file
  void setDefault(const std::string &name, const std::string &value);
  /// \throws Error (BadInput) unless the keyword is given
  void require(const std::string &name) const;
  /// \throws Error (BadInput) for a keyword, or one of a group, that is given and makes no sense
  ///         together with something else
  /// \param with  that, with the reason: "contact.period: the surfaces are flat"
  void refuse(const std::string &name, const std::string &with) const;
  /// \throws Error (BadInput) for a keyword that is given and that nobody has asked for: what
  ///         would change nothing in silence
  /// \param mayStay  whether a keyword of the file may be such
  void refuseUnused(const std::function<bool(const std::string &name)> &mayStay) const;

  /// What was used so far, as a case file.
  /// Keywords in the order of the table; numbers in the words in which they were given.
  std::string configuration() const;

 private:
  /// A value as it stands in the file or on the command line, and the numbers it holds.
  struct Entry {
    std::vector<std::string> words;
    std::vector<double> numbers; ///< in the keyword's unit; empty where it takes words
    bool isList = false;
    int line = 0;                 ///< 0: from a change or a tree
    const char *option = nullptr; ///< of the change that it is from, "--set "; null: of none
  };

  [[noreturn]] void fail(int line, const std::string &keyword, const std::string &problem) const;
  /// Takes in a node of YAML that stands at a keyword or group; "" is the whole file.
  void collect(const YAML::Node &node, const std::string &name);
  /// Names the keyword of a group in braces whose value has a decimal comma.
  void refuseDecimalComma(const YAML::Node &map, const std::string &name) const;
  /// Checks a value, or each of a list, against the keyword's form.
  Entry entryOf(const YAML::Node &node, const Keyword &keyword) const;
  /// The number in the keyword's unit, within its range.
  double checkedNumber(const Keyword &keyword, const std::string &word, int line) const;
  /// Checks that kinds Choice and Switch have one of the words that are allowed.
  void checkWord(const Keyword &keyword, const std::string &word, int line) const;
  /// Keeps the name under which a keyword is given, for messages: an older one, or its own.
  void noteName(const std::string &name, const std::string &given);
  const std::string &givenName(const std::string &name) const;
  /// The value or its default, from now on part of `configuration`.
  const Entry &use(const std::string &name);

  std::string file_;
  const char *option_ = nullptr; ///< what names a change in messages; null: no change is read
  std::map<std::string, Entry> entries_, used_;
  std::set<std::string> changed_;            ///< what changes named, keywords and groups
  std::map<std::string, std::string> older_; ///< names under which keywords were given
};

/// The table's row of a keyword; null for other words.
/// \param name with dots, as in the table: "contact.radius"
const Keyword *findKeyword(const std::string &name);

/// The value, or 0 where it is nearer to 0 than the keyword tells apart.
double orZero(const Keyword &keyword, double value);

/// The words that a keyword of kind Choice allows.
/// \param keyword of kind Choice, or Switch, which allows true and false
std::vector<std::string> choicesOf(const Keyword &keyword);

} // namespace wheelrail
#endif
