// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/friction_log.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "base/text_lines.h"
#include "base/yaml_document.h"
#include "fit/stationarity.h"
#include "law/kappa_law.h"
#include "shared/nearest_word.h"
#include "shared/plain_number.h"
#include "shared/running_checksum.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <set>
#include <string_view>
#include <yaml-cpp/yaml.h>

namespace wheelrail {

namespace {

namespace format = mcawr::friction_log;

// mu is printed rounded, as shear_stress is
constexpr double muTolerance = 1e-3;

std::vector<std::string_view> splitLines(const std::string &text)
{
  std::vector<std::string_view> lines;
  size_t begin = 0;
  while (begin < text.size()) {
    size_t end = text.find('\n', begin);
    if (end == std::string::npos)
      end = text.size();
    lines.emplace_back(text.data() + begin, end - begin);
    begin = end + 1;
  }
  return lines;
}

std::vector<std::string_view> splitWords(std::string_view line)
{
  std::vector<std::string_view> words;
  size_t begin = 0;
  while ((begin = line.find_first_not_of(" \t", begin)) != std::string_view::npos) {
    const size_t end = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

/// The YAML head of a log, with the line of everything in the file.
class Header {
 public:
  Header(const std::string &file, const std::string &yaml) : fileName_(file)
  {
    try {
      root_ = yamlDocument(yaml);
    } catch (const YAML::Exception &error) {
      throw badInput(fileName_, error.mark.line + 1, "", "the head is not YAML: " + error.msg);
    }
    if (!root_.IsMap())
      throw badInput(
          fileName_, 1, "",
          fmt::format("not a friction log: the head must begin with '{}'", format::formatLine()));
    checkKeys(root_);
    for (const auto &entry : root_)
      if (entry.second.IsMap())
        checkKeys(entry.second);
  }

  std::string text(const std::string &key) const
  {
    const auto node = find(root_, "", key);
    if (!node.IsScalar())
      throw badInput(fileName_, lineOf(node), key, "one value is expected");
    return node.Scalar();
  }

  std::string text(const std::string &section, const std::string &key) const
  {
    const auto node = find(root_, "", section);
    if (!node.IsMap())
      throw badInput(fileName_, lineOf(node), section, "{key: value, ...} expected");
    const auto value = find(node, section, key);
    if (!value.IsScalar())
      throw badInput(fileName_, lineOf(value), key, "one value is expected");
    return value.Scalar();
  }

  int line(const std::string &section) const { return lineOf(root_[section]); }

  /// \param section where it stands; nullptr: in its own
  double number(const format::HeadNumber &wanted, const char *section = nullptr) const
  {
    const std::string home = section ? section : wanted.section;
    const auto given = text(home, wanted.key);
    const auto x = mcawr::plainNumber(given);
    if (!x || !format::isIn(wanted.range, *x))
      throw badInput(fileName_, line(home), fmt::format("{}: {}", home, wanted.key),
                     fmt::format("'{}' is not allowed, must be a number {}", given,
                                 format::describe(wanted.range, wanted.unit)));
    return *x;
  }

  /// \throws Error (BadInput) where it is none
  double positive(const char *section, const char *key) const
  {
    const auto given = text(section, key);
    const auto x = mcawr::plainNumber(given);
    if (!x || !format::isIn(format::Range::Positive, *x))
      throw badInput(fileName_, line(section), fmt::format("{}: {}", section, key),
                     fmt::format("'{}' is not allowed, must be a number {}", given,
                                 format::describe(format::Range::Positive, "")));
    return *x;
  }

  std::vector<std::string> sections() const
  {
    std::vector<std::string> names;
    for (const auto &entry : root_)
      names.push_back(entry.first.Scalar());
    return names;
  }

  bool has(const std::string &section, const std::string &key) const
  {
    return root_[section] && root_[section].IsMap() && root_[section][key];
  }

  /// A section as it stands there; empty where there is none.
  std::string wording(const std::string &section) const
  {
    return root_[section] ? YAML::Dump(root_[section]) : std::string();
  }

  /// Adds the values of a section under "section.key".
  void collect(const std::string &section, std::map<std::string, std::string> &values) const
  {
    if (!root_[section])
      return;
    if (!root_[section].IsMap())
      throw badInput(fileName_, line(section), section, "{key: value, ...} expected");
    for (const auto &entry : root_[section]) {
      if (!entry.first.IsScalar() || !entry.second.IsScalar())
        throw badInput(fileName_, line(section), section, "one value for each key is expected");
      values[section + "." + entry.first.Scalar()] = entry.second.Scalar();
    }
  }

 private:
  void checkKeys(const YAML::Node &map) const
  {
    std::set<std::string> seen;
    std::string before, value; // of the entry before
    for (const auto &entry : map) {
      const std::string key = entry.first.Scalar();
      // to YAML "velocity: 0,5" is 0, and a key 5 without a value
      if (entry.second.IsNull() && !key.empty() && std::isdigit(static_cast<unsigned char>(key[0])))
        throw badInput(fileName_, lineOf(entry.first), before,
                       fmt::format("'{},{}' has a decimal comma; a point is expected", value, key));
      if (!seen.insert(key).second)
        throw badInput(fileName_, lineOf(entry.first), key, "appears twice in the head");
      before = key;
      value = entry.second.IsScalar() ? entry.second.Scalar() : "";
    }
  }

  static int lineOf(const YAML::Node &node) { return node.Mark().line + 1; }

  YAML::Node find(const YAML::Node &node, const std::string &section, const std::string &key) const
  {
    if (node[key])
      return node[key];
    // a misspelt key is the likely reason: name the one that comes nearest
    std::vector<std::string> present;
    for (const auto &entry : node)
      present.push_back(entry.first.Scalar());
    const auto nearest = mcawr::nearestWord(key, present);
    std::string problem = fmt::format("'{}' is missing", key);
    if (!nearest.empty())
      problem += fmt::format("; '{}' is unknown, the nearest known one is '{}'", nearest, key);
    throw badInput(fileName_, section.empty() ? 0 : lineOf(node), section, problem);
  }

  std::string fileName_;
  YAML::Node root_;
};

void readHeader(const Header &header, FrictionLog &log)
{
  const auto given = header.text("format");
  if (given != format::format)
    throw badInput(log.file, header.line("format"), "format",
                   fmt::format("'{}' cannot be read, must be '{}'", given, format::format));
  for (const auto &[quantity, unit] : format::units) {
    const auto stated = header.text(format::section::units, quantity);
    if (stated != unit)
      throw badInput(log.file, header.line(format::section::units),
                     fmt::format("{}: {}", format::section::units, quantity),
                     fmt::format("'{}' is not allowed, must be '{}'", stated, unit));
  }
  for (const format::HeadNumber &number : format::headNumbers)
    if (number.needed || header.has(number.section, number.key))
      log.head.*number.value = header.number(number);
  for (const auto *section : format::madeBySections)
    header.collect(section, log.madeBy);
  if (header.has(format::section::geometry, format::packingKey))
    log.packing = header.text(format::section::geometry, format::packingKey);
  if (header.has(format::campaignSection, format::commandKey))
    log.command = header.text(format::campaignSection, format::commandKey);
  if (header.has(format::campaignSection, format::temperatureKey))
    log.temperature = header.positive(format::campaignSection, format::temperatureKey);
  for (const auto *section : format::conditionSections)
    log.condition[section] = header.wording(section);
  for (const std::string &section : header.sections())
    if (section.compare(0, std::strlen(format::interfaceSection), format::interfaceSection) == 0)
      log.condition[section] = header.wording(section);
    else if (section.compare(0, std::strlen(format::otherMaterial), format::otherMaterial) == 0) {
      log.condition[section] = header.wording(section);
      log.otherStrengths.push_back(
          header.number(format::headNumber(&format::Head::strength), section.c_str()));
    }
  constexpr const format::HeadNumber &timestep = format::headNumber(&format::Head::timestep);
  if (header.has(timestep.section, timestep.key))
    log.condition[timestep.key] = header.text(timestep.section, timestep.key);
}

/// Where each of our columns stands; further columns are allowed and skipped.
using Places = std::array<size_t, format::columns.size()>;
constexpr size_t isMissing = std::string::npos;
Places readColumns(const FrictionLog &log, int line, std::string_view text)
{
  const auto words = splitWords(text);
  const std::vector<std::string> names(words.begin(), words.end());
  Places place{};
  for (size_t i = 0; i < place.size(); ++i) {
    const std::string name = format::columns[i].name;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() && i >= format::columnsNeeded) {
      place[i] = isMissing;
      continue;
    }
    if (found == names.end()) {
      const auto nearest = mcawr::nearestWord(name, names);
      std::string problem = fmt::format("column '{}' is missing", name);
      if (!nearest.empty())
        problem += fmt::format("; the nearest of those given is '{}'", nearest);
      throw badInput(log.file, line, "", problem);
    }
    if (std::count(found, names.end(), name) > 1)
      throw badInput(log.file, line, "", fmt::format("column '{}' is there twice", name));
    place[i] = found - names.begin();
  }
  return place;
}

double readNumber(const FrictionLog &log, int line, const char *column, std::string_view word)
{
  const auto x = mcawr::plainNumber(word);
  if (!x)
    throw badInput(log.file, line, column, fmt::format("'{}' is not a finite number", word));
  if (!format::isInRow(*x))
    throw badInput(
        log.file, line, column,
        fmt::format("'{}' is not allowed, must be within +-{:g}", word, format::largest));
  return *x;
}

void addRow(FrictionLog &log, int line, const format::Row &row)
{
  const auto step = static_cast<long>(row.step);
  if (static_cast<double>(step) != row.step || step < 0)
    throw badInput(log.file, line, "step", fmt::format("{} is not a whole number >= 0", row.step));
  if (!log.step.empty()) {
    if (step <= log.step.back() || row.time <= log.time.back())
      throw badInput(log.file, line, "step",
                     fmt::format("step {} (time {} ns) follows step {} (time {} ns): must increase",
                                 step, row.time, log.step.back(), log.time.back()));
    if (log.step.size() > 1) {
      const long every = log.step[1] - log.step[0];
      const double interval = log.time[1] - log.time[0];
      if (step - log.step.back() != every ||
          std::abs(row.time - log.time.back() - interval) > spacingTolerance * interval)
        throw badInput(log.file, line, "step",
                       fmt::format("rows must be evenly spaced: {} steps and {:.4g} ns since the "
                                   "row before, {} steps and {:.4g} ns at the start of the log",
                                   step - log.step.back(), row.time - log.time.back(), every,
                                   interval));
    }
  }
  const double expected = log.head.pressure > 0.0 ? row.shearStress / log.head.pressure : 0.0;
  if (std::abs(row.mu - expected) > muTolerance * (1.0 + std::abs(expected)))
    throw badInput(log.file, line, "mu",
                   fmt::format("{} is not shear_stress/pressure = {:.6g} with the pressure of {} "
                               "MPa stated in the head",
                               row.mu, expected, log.head.pressure));
  log.step.push_back(step);
  log.time.push_back(row.time);
  log.mu.push_back(log.head.velocity < 0.0 ? -row.mu : row.mu);
  log.rows.push_back(row);
}

/// The column `check`: whether all before it is as it was written.
class RowCheck {
 public:
  /// \param text of the whole file, which has to outlive this
  /// \param names of the columns
  RowCheck(const std::string &path, std::string_view text,
           const std::vector<std::string_view> &names)
      : path_(path), text_(text),
        place_(std::find(names.begin(), names.end(), format::checkName) - names.begin())
  {
  }
  /// \param words of a row, within the text, in the order of the file's rows
  void row(int line, const std::vector<std::string_view> &words)
  {
    if (place_ >= words.size())
      return;
    const std::string_view word = words[place_];
    const auto end = static_cast<std::size_t>(word.data() - text_.data());
    sum_.add(text_.substr(done_, end - done_));
    done_ = end;
    if (word != std::to_string(sum_.value()))
      throw badInput(
          path_, line, format::checkName,
          fmt::format("{} does not fit: the head, or a row up to here, was changed since "
                      "it was written (without the column '{}' it is read all the same)",
                      word, format::checkName));
  }

 private:
  std::string path_;
  std::string_view text_;
  std::size_t place_, done_ = 0;
  mcawr::RunningChecksum sum_; ///< of the first `done_` bytes
};

void dropStateBeforeFirstStep(FrictionLog &log)
{
  if (log.step.empty() || log.step.front() != 0)
    return;
  log.step.erase(log.step.begin());
  log.time.erase(log.time.begin());
  log.mu.erase(log.mu.begin());
  log.rows.erase(log.rows.begin());
}

} // namespace

double FrictionLog::kappa1() const
{
  constexpr double pascal = 1e6; // per MPa
  return wheelrail::kappa1(head.density, head.youngsModulus * pascal, head.velocity,
                           head.strength * pascal);
}

double FrictionLog::kappa2() const
{
  return wheelrail::kappa2(head.pressure, head.youngsModulus, head.strength);
}

double FrictionLog::kappa3() const
{
  return head.youngsModulus / head.strength;
}

double FrictionLog::interval() const
{
  if (time.size() < 2)
    return time.empty() ? 0.0 : time.front();
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

double FrictionLog::origin() const
{
  const double begin = time.front() - interval();
  constexpr double rounding = 1e-6;
  return std::abs(begin) < rounding * interval() ? 0.0 : begin;
}

FrictionLog readFrictionLog(const std::string &path)
{
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored))
    throw badInput(path, 0, "", "is not a regular file"); // reading a pipe might never end
  return parseFrictionLog(path, readInputFile(path));
}

FrictionLog parseFrictionLog(const std::string &file, const std::string &bytes)
{
  const std::string text = plainTextOf(file, bytes);
  if (text.empty())
    throw badInput(file, 0, "", "is empty");
  FrictionLog log;
  log.file = file;
  const auto lines = splitLines(text);
  const bool lastLineEnded = text.back() == '\n';

  size_t i = 0;
  std::string yaml;
  for (; i < lines.size() && lines[i].substr(0, 1) == format::headMark; ++i) {
    auto line = lines[i].substr(1);
    if (line.substr(0, 1) == " ")
      line.remove_prefix(1);
    yaml.append(line).append("\n");
  }
  readHeader(Header(file, yaml), log);
  if (i == lines.size() || (i + 1 == lines.size() && !lastLineEnded))
    throw badInput(file, static_cast<int>(lines.size()), "", "cut short: no line of column names");
  const auto place = readColumns(log, static_cast<int>(i + 1), lines[i]);
  log.hasState = std::count(place.begin(), place.end(), isMissing) == 0;
  const auto names = splitWords(lines[i]);
  RowCheck check(file, text, names);

  for (++i; i < lines.size(); ++i) {
    const int number = static_cast<int>(i + 1);
    const bool last = i + 1 == lines.size();
    const auto words = splitWords(lines[i]);
    if (last && !lastLineEnded) {
      log.note = fmt::format("{}:{}: the last line was cut while it was written; it is left out",
                             file, number);
      break;
    }
    if (words.size() != names.size())
      throw badInput(file, number, "",
                     fmt::format("{} columns, {} are expected", words.size(), names.size()));
    check.row(number, words);
    format::Row row;
    for (size_t c = 0; c < place.size(); ++c) {
      const format::Column &column = format::columns[c];
      if (place[c] != isMissing)
        row.*column.value = readNumber(log, number, column.name, words[place[c]]);
    }
    addRow(log, number, row);
  }
  dropStateBeforeFirstStep(log);
  if (log.step.empty())
    throw badInput(file, static_cast<int>(lines.size()), "", "holds no row after step 0");
  return log;
}

} // namespace wheelrail
