// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/case_reader.h"

#include "base/errors.h"
#include "base/quantity.h"
#include "base/text_lines.h"
#include "base/yaml_document.h"
#include "shared/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>
#include <stdexcept>
#include <yaml-cpp/yaml.h>

namespace wheelrail {
namespace {

using Kind = Keyword::Kind;

bool isGroup(const std::string &name)
{
  return std::any_of(keywords().begin(), keywords().end(), [&](const Keyword &keyword) {
    return std::string(keyword.name).rfind(name + ".", 0) == 0;
  });
}

std::vector<std::string> knownNames()
{
  std::vector<std::string> names;
  for (const Keyword &keyword : keywords()) {
    const std::string name = keyword.name;
    const std::string group = name.substr(0, name.find('.'));
    names.push_back(name);
    if (group != name && std::find(names.begin(), names.end(), group) == names.end())
      names.push_back(group);
  }
  return names;
}

std::vector<std::string> split(const std::string &text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);)
    parts.push_back(part);
  return parts;
}

bool takesList(Kind kind)
{
  return kind == Kind::NumberList || kind == Kind::QuantityList || kind == Kind::IntegerList ||
         kind == Kind::TextList || kind == Kind::RatioList;
}

bool takesNumbers(Kind kind)
{
  return kind != Kind::Text && kind != Kind::TextList && kind != Kind::Choice &&
         kind != Kind::Switch;
}

bool takesWholeNumbers(Kind kind)
{
  return kind == Kind::Integer || kind == Kind::IntegerList;
}

/// A value as YAML: plain, or in double quotes where its characters ask for it.
std::string quoted(const std::string &item)
{
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  const bool plain = !item.empty() && item.front() != ' ' && item.back() != ' ' && item != "-" &&
                     item.rfind("- ", 0) != 0 &&
                     item.find_first_of(":#{}[],&*?|<>=!%@`'\"\\") == std::string::npos &&
                     std::none_of(item.begin(), item.end(), isControl);
  if (plain)
    return item;
  std::string text = "\"";
  for (char c : item) {
    if (isControl(c)) {
      text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
      continue;
    }
    if (c == '"' || c == '\\')
      text += '\\';
    text += c;
  }
  return text + "\"";
}

bool isWhole(const std::string &word)
{
  const std::size_t first = word[0] == '-' || word[0] == '+' ? 1 : 0;
  return word.size() > first && word.find_first_not_of("0123456789", first) == std::string::npos;
}

/// Decimals in a list, as in "[0,1 %, 0,2 %]": a whole number, a comma without a blank, and digits
/// that have the unit alone, or a zero before them, or stand in a list with blanks elsewhere.
/// \return how they are written; empty: none
std::string decimalComma(const YAML::Node &list)
{
  bool allTight = true;
  std::string found, sure;
  for (std::size_t k = 0; k + 1 < list.size(); ++k) {
    const std::string whole = list[k].Scalar(), decimals = list[k + 1].Scalar();
    const int from = list[k].Mark().pos, to = list[k + 1].Mark().pos;
    if (from < 0 || to != from + static_cast<int>(whole.size()) + 1) {
      allTight = false;
      continue;
    }
    const std::size_t digits = std::min(decimals.find_first_not_of("0123456789"), decimals.size());
    if (!isWhole(whole) || digits == 0 || (digits < decimals.size() && decimals[digits] == '.'))
      continue;
    found = fmt::format("{},{}", whole, decimals);
    if (digits < decimals.size() || (digits > 1 && decimals[0] == '0'))
      sure = found;
  }
  return !sure.empty() || allTight ? sure : found;
}

} // namespace

const Keyword *findKeyword(const std::string &name)
{
  for (const Keyword &keyword : keywords())
    if (name == keyword.name)
      return &keyword;
  return nullptr;
}

double orZero(const Keyword &keyword, double value)
{
  return std::abs(value) < -keyword.smallest ? 0.0 : value;
}

std::vector<std::string> choicesOf(const Keyword &keyword)
{
  return split(keyword.kind == Kind::Switch ? "true|false" : keyword.choices, '|');
}

std::string rangeOf(const Keyword &keyword)
{
  std::string range = fmt::format("[{:.10g}, {:.10g}]", keyword.low, keyword.high);
  if (keyword.smallest > 0.0)
    range += fmt::format(", 0 and beyond {}", keyword.smallest);
  if (keyword.smallest < 0.0)
    range += fmt::format(", within {} of 0: 0", -keyword.smallest);
  return std::string(keyword.unit) == "1" ? range : fmt::format("{} {}", range, keyword.unit);
}

void CaseReader::fail(int line, const std::string &keyword, const std::string &problem) const
{
  if (!option_)
    throw badInput(file_, line, givenName(keyword), problem);
  throw Error(ExitCode::Usage, fmt::format("{}{}: {}", option_, givenName(keyword), problem));
}

void CaseReader::noteName(const std::string &name, const std::string &given)
{
  if (given == name)
    older_.erase(name);
  else
    older_[name] = given;
}

const std::string &CaseReader::givenName(const std::string &name) const
{
  const auto found = older_.find(name);
  return found == older_.end() ? name : found->second;
}

void CaseReader::fail(const std::string &keyword, const std::string &problem) const
{
  const auto found = entries_.find(keyword);
  const bool isThere = found != entries_.end(), isChange = isThere && found->second.option;
  throw badInput(file_, isThere ? found->second.line : 0,
                 (isChange ? found->second.option : "") + givenName(keyword), problem);
}

bool CaseReader::hasGroup(const std::string &group) const
{
  const auto next = entries_.lower_bound(group + ".");
  return next != entries_.end() && next->first.rfind(group + ".", 0) == 0;
}

bool CaseReader::isChanged(const std::string &name) const
{
  return changed_.count(name) > 0 || changed_.count(name.substr(0, name.find('.'))) > 0;
}

void CaseReader::readFile()
{
  readText(readTextFile(file_));
}

void CaseReader::readText(const std::string &text)
{
  try {
    readTree(yamlDocument(text));
  } catch (const YAML::Exception &problem) {
    throw badInput(file_, problem.mark.line + 1, "", problem.msg);
  }
}

void CaseReader::readTree(const YAML::Node &root)
{
  if (!root.IsMap())
    throw badInput(file_, 0, "", "is not a case file: 'keyword: value' lines are expected");
  collect(root, "");
}

void CaseReader::collect(const YAML::Node &node, const std::string &name)
{
  const int line = option_ ? 0 : node.Mark().line + 1;
  if (!name.empty() && !findKeyword(name) && !isGroup(name))
    fail(line, name, mcawr::unknownWord("keyword", name, knownNames()));
  if (node.IsMap()) {
    if (!name.empty() && !isGroup(name))
      fail(line, name, "has no keywords below it; a value is expected");
    refuseDecimalComma(node, name);
    for (const auto &pair : node) {
      const std::string key = pair.first.as<std::string>();
      const std::string given = name.empty() ? key : name + "." + key;
      const std::string full = presentName(given);
      noteName(full, given);
      const int keyLine = option_ ? 0 : pair.first.Mark().line + 1;
      if (!findKeyword(full) && !isGroup(full))
        fail(keyLine, full, mcawr::unknownWord("keyword", full, knownNames()));
      if (has(full) || hasGroup(full))
        fail(keyLine, full, "is given twice");
      const std::string group = full.substr(0, full.find('.'));
      if (group != full && has(group)) // "thermal: off" and "thermal.bulk: 20 K"
        fail(keyLine, full,
             fmt::format("does not go with {}: {}", group, entries_[group].words[0]));
      collect(pair.second, full);
    }
    return;
  }
  if (name.empty())
    fail(line, "", "is not a case file: 'keyword: value' lines are expected");
  const Keyword *keyword = findKeyword(name);
  if (!keyword)
    fail(line, name, "is not a value: it has keywords below it");
  Entry entry = entryOf(node, *keyword);
  entry.line = line;
  entry.option = option_;
  entries_[name] = std::move(entry);
}

// to YAML "{mu: 0,3}" is 0, and a key 3 without a value
void CaseReader::refuseDecimalComma(const YAML::Node &map, const std::string &name) const
{
  std::string before, value;
  for (const auto &pair : map) {
    const std::string key = pair.first.Scalar();
    if (pair.second.IsNull() && !key.empty() && std::isdigit(static_cast<unsigned char>(key[0])) &&
        !before.empty())
      fail(option_ ? 0 : pair.first.Mark().line + 1, name.empty() ? before : name + "." + before,
           fmt::format("'{},{}' has a decimal comma; a point is expected", value, key));
    before = key;
    value = pair.second.IsScalar() ? pair.second.Scalar() : "";
  }
}

CaseReader::Entry CaseReader::entryOf(const YAML::Node &node, const Keyword &keyword) const
{
  const int line = option_ ? 0 : node.Mark().line + 1;
  Entry entry;
  entry.isList = node.IsSequence();
  if (entry.isList) {
    for (const YAML::Node &item : node) {
      if (!item.IsScalar())
        fail(line, keyword.name, "a list of plain values is expected");
      entry.words.push_back(item.Scalar());
    }
    if (entry.words.empty())
      fail(line, keyword.name, "the list is empty");
    if (!takesList(keyword.kind))
      fail(line, keyword.name, "one value is expected, not a list");
    const std::string comma = takesWholeNumbers(keyword.kind) ? "" : decimalComma(node);
    if (takesNumbers(keyword.kind) && !comma.empty())
      fail(
          line, keyword.name,
          fmt::format("'{}' has a decimal comma; a point is expected, and a blank after each comma "
                      "of a list",
                      comma));
  } else {
    if (!node.IsScalar() || node.Scalar().empty())
      fail(line, keyword.name, "has no value");
    entry.words.push_back(node.Scalar());
  }
  for (const std::string &word : entry.words)
    if (takesNumbers(keyword.kind))
      entry.numbers.push_back(checkedNumber(keyword, word, line));
    else
      checkWord(keyword, word, line);
  return entry;
}

double CaseReader::checkedNumber(const Keyword &keyword, const std::string &word, int line) const
{
  double value = 0.0;
  try {
    const bool ratio = keyword.kind == Kind::Ratio || keyword.kind == Kind::RatioList;
    const bool isBare =
        keyword.kind == Kind::Unit && std::isalpha(static_cast<unsigned char>(word[0]));
    value = ratio ? parseRatio(word) : parseQuantity((isBare ? "1 " : "") + word, keyword.unit);
  } catch (const std::invalid_argument &problem) {
    fail(line, keyword.name, fmt::format("{}; allowed: {}", problem.what(), rangeOf(keyword)));
  }
  if (takesWholeNumbers(keyword.kind) && value != std::floor(value))
    fail(line, keyword.name,
         fmt::format("'{}' is not a whole number; allowed: {}", word, rangeOf(keyword)));
  value = orZero(keyword, value);
  const bool isTooSmall = value != 0.0 && std::abs(value) < keyword.smallest;
  if (value < keyword.low || value > keyword.high || isTooSmall)
    fail(line, keyword.name,
         fmt::format("'{}' is not in the allowed range {}", word, rangeOf(keyword)));
  return value;
}

void CaseReader::checkWord(const Keyword &keyword, const std::string &word, int line) const
{
  if (keyword.kind != Kind::Choice && keyword.kind != Kind::Switch)
    return;
  const std::vector<std::string> allowed = choicesOf(keyword);
  if (std::find(allowed.begin(), allowed.end(), word) != allowed.end())
    return;
  const std::string nearest = mcawr::nearestWord(word, allowed);
  fail(line, keyword.name,
       fmt::format("'{}' is not allowed; {}{}", word, fmt::join(allowed, ", "),
                   nearest.empty() ? "" : fmt::format("; nearest: '{}'", nearest)));
}

void CaseReader::change(const std::string &text)
{
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(ExitCode::Usage, fmt::format("--set {}: KEYWORD=VALUE is expected", text));
  const std::string name = text.substr(0, equals);
  constexpr const char *option = "--set ";
  try {
    change(name, yamlDocument(text.substr(equals + 1)), option);
  } catch (const YAML::Exception &problem) {
    throw Error(ExitCode::Usage, fmt::format("{}{}: {}", option, name, problem.msg));
  }
}

void CaseReader::change(const std::string &given, const YAML::Node &value, const char *option)
{
  const std::string name = presentName(given);
  noteName(name, given);
  changed_.insert(name);
  // "creep=[...]" replaces creep.from etc., "roughness.seed=2" ends "roughness: none"
  const std::string group = name.substr(0, name.find('.'));
  entries_.erase(name);
  if (group != name)
    entries_.erase(group);
  for (auto it = entries_.begin(); it != entries_.end();)
    it = it->first.rfind(name + ".", 0) == 0 ? entries_.erase(it) : std::next(it);
  option_ = option;
  collect(value, name);
  option_ = nullptr;
}

void CaseReader::require(const std::string &name) const
{
  if (!has(name))
    throw badInput(file_, 0, name, fmt::format("is missing ({})", findKeyword(name)->help));
}

void CaseReader::refuse(const std::string &name, const std::string &with) const
{
  if (has(name))
    fail(name, "does not go with " + with);
  if (hasGroup(name)) // the first keyword that is given
    fail(entries_.lower_bound(name + ".")->first, "does not go with " + with);
}

void CaseReader::refuseUnused(const std::function<bool(const std::string &name)> &mayStay) const
{
  for (const auto &[name, entry] : entries_)
    if (used_.count(name) == 0 && (entry.option || !mayStay(name)))
      fail(name, "is not used in this case: leave it out, or choose what needs it");
}

void CaseReader::setDefault(const std::string &name, const std::string &value)
{
  if (!has(name))
    entries_[name] = entryOf(YAML::Load(value), *findKeyword(name));
}

double CaseReader::initial(const std::string &name) const
{
  const Keyword &keyword = *findKeyword(name);
  return entryOf(YAML::Load(keyword.initial), keyword).numbers.front();
}

double CaseReader::single(const std::string &name)
{
  if (use(name).isList)
    fail(name, "one value is expected, not a list");
  return number(name);
}

// A default goes through the same checks as a value of the file, and both end in `used_`: what
// `configuration` writes is what was computed with.
const CaseReader::Entry &CaseReader::use(const std::string &name)
{
  const auto given = entries_.find(name);
  if (given != entries_.end())
    return used_[name] = given->second;
  const Keyword &keyword = *findKeyword(name);
  if (std::string(keyword.initial).empty())
    require(name);
  return used_[name] = entryOf(YAML::Load(keyword.initial), keyword);
}

std::string CaseReader::configuration() const
{
  std::string text, openGroup;
  for (const Keyword &keyword : keywords()) {
    const auto found = used_.find(keyword.name);
    if (found == used_.end())
      continue;
    const Entry &entry = found->second;
    std::string name = keyword.name;
    std::string indent;
    const auto dot = name.find('.');
    if (dot != std::string::npos) {
      const std::string group = name.substr(0, dot);
      if (group != openGroup)
        text += group + ":\n";
      openGroup = group;
      name = name.substr(dot + 1);
      indent = "  ";
    } else {
      openGroup.clear();
    }
    std::vector<std::string> parts;
    for (const std::string &item : entry.words)
      parts.push_back(quoted(item));
    const std::string value = fmt::format("{}", fmt::join(parts, ", "));
    text += indent + name + ": " + (entry.isList ? "[" + value + "]" : value) + "\n";
  }
  return text;
}

} // namespace wheelrail
