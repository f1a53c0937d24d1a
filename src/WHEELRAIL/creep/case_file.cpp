#include "creep/case_file.h"

#include "base/errors.h"
#include "base/nearest_word.h"
#include "base/output_file.h"
#include "base/quantity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <yaml-cpp/yaml.h>

namespace wheelrail {
namespace {

using Kind = Keyword::Kind;

/// A value as it stands in the file or on the command line.
struct Entry {
  std::vector<std::string> items;
  bool isList = false;
  int line = 0; ///< 0: from the command line
};
using Entries = std::map<std::string, Entry>;

const Keyword *findKeyword(const std::string &name)
{
  for (const Keyword &keyword : keywords())
    if (name == keyword.name)
      return &keyword;
  return nullptr;
}

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

/// Throws what is wrong with a keyword, at its line of the file or in --set.
class Reader {
 public:
  Reader(std::string fileName) : file(std::move(fileName)) {}

  [[noreturn]] void fail(int line, const std::string &keyword, const std::string &problem) const
  {
    if (line > 0 || !onCommandLine)
      throw badInput(file, line, keyword, problem);
    throw Error(ExitCode::Usage, fmt::format("--set {}: {}", keyword, problem));
  }

  void collect(const YAML::Node &node, const std::string &name);
  void change(const std::string &text);

  bool has(const std::string &name) const { return entries.count(name) > 0; }
  bool hasGroup(const std::string &group) const
  {
    const auto next = entries.lower_bound(group + ".");
    return next != entries.end() && next->first.rfind(group + ".", 0) == 0;
  }
  int lineOf(const std::string &name) const
  {
    const auto found = entries.find(name);
    return found == entries.end() ? 0 : found->second.line;
  }

  /// The value with its default filled in and recorded for --print-config.
  std::vector<std::string> items(const std::string &name);
  std::vector<double> numbers(const std::string &name);
  double number(const std::string &name) { return numbers(name).front(); }
  std::string word(const std::string &name) { return items(name).front(); }
  bool flag(const std::string &name) { return word(name) == "true"; }
  void require(const std::string &name) const;
  /// Keywords that make no sense together with something else.
  void refuse(std::initializer_list<const char *> names, const std::string &with) const;

  std::string configuration() const;

  bool onCommandLine = false;

 private:
  void checkForm(const Keyword &keyword, const Entry &entry) const;

  std::string file;
  Entries entries, used;
};

void Reader::collect(const YAML::Node &node, const std::string &name)
{
  const int line = onCommandLine ? 0 : node.Mark().line + 1;
  const bool known = name.empty() || findKeyword(name) || isGroup(name);
  if (!known)
    fail(line, name, unknownWord("keyword", name, nearestWord(name, knownNames())));
  if (node.IsMap()) {
    if (!name.empty() && !isGroup(name))
      fail(line, name, "has no keywords below it; a value is expected");
    for (const auto &pair : node) {
      const std::string key = pair.first.as<std::string>();
      const std::string full = name.empty() ? key : name + "." + key;
      const int keyLine = onCommandLine ? 0 : pair.first.Mark().line + 1;
      if (!findKeyword(full) && !isGroup(full))
        fail(keyLine, full, unknownWord("keyword", full, nearestWord(full, knownNames())));
      if (has(full) || hasGroup(full))
        fail(keyLine, full, "is given twice");
      collect(pair.second, full);
    }
    return;
  }
  if (name.empty())
    fail(line, "", "is not a case file: 'keyword: value' lines are expected");
  if (!findKeyword(name))
    fail(line, name, "is not a value: it has keywords below it");
  Entry entry;
  entry.line = line;
  entry.isList = node.IsSequence();
  if (entry.isList) {
    for (const YAML::Node &item : node) {
      if (!item.IsScalar())
        fail(line, name, "a list of plain values is expected");
      entry.items.push_back(item.Scalar());
    }
    if (entry.items.empty())
      fail(line, name, "the list is empty");
  } else {
    if (!node.IsScalar() || node.Scalar().empty())
      fail(line, name, "has no value");
    entry.items.push_back(node.Scalar());
  }
  checkForm(*findKeyword(name), entry);
  entries[name] = entry;
}

void Reader::change(const std::string &text)
{
  const auto equals = text.find('=');
  if (equals == std::string::npos)
    throw Error(ExitCode::Usage, fmt::format("--set {}: KEYWORD=VALUE is expected", text));
  const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
  // "creep=[...]" replaces creep.from etc., "roughness.seed=2" ends "roughness: none"
  const std::string group = name.substr(0, name.find('.'));
  entries.erase(name);
  if (group != name)
    entries.erase(group);
  else
    for (auto it = entries.begin(); it != entries.end();)
      it = it->first.rfind(name + ".", 0) == 0 ? entries.erase(it) : std::next(it);
  try {
    collect(YAML::Load(value), name);
  } catch (const YAML::Exception &problem) {
    fail(0, name, problem.msg);
  }
}

void Reader::checkForm(const Keyword &keyword, const Entry &entry) const
{
  const bool listAllowed = keyword.kind == Kind::NumberList || keyword.kind == Kind::QuantityList ||
                           keyword.kind == Kind::IntegerList || keyword.kind == Kind::TextList;
  if (entry.isList && !listAllowed)
    fail(entry.line, keyword.name, "one value is expected, not a list");
  for (const std::string &item : entry.items) {
    if (keyword.kind == Kind::Text || keyword.kind == Kind::TextList)
      continue;
    if (keyword.kind == Kind::Choice || keyword.kind == Kind::Switch) {
      const std::string choices = keyword.kind == Kind::Switch ? "true|false" : keyword.choices;
      const std::vector<std::string> allowed = split(choices, '|');
      if (std::find(allowed.begin(), allowed.end(), item) == allowed.end())
        fail(entry.line, keyword.name,
             fmt::format("'{}' is not allowed; {}; nearest: '{}'", item, fmt::join(allowed, ", "),
                         nearestWord(item, allowed)));
      continue;
    }
    double value = 0.0;
    try {
      value = parseQuantity(item, keyword.unit);
    } catch (const std::invalid_argument &problem) {
      fail(entry.line, keyword.name, problem.what());
    }
    const bool whole = keyword.kind == Kind::Integer || keyword.kind == Kind::IntegerList;
    if (whole && value != std::floor(value))
      fail(entry.line, keyword.name, fmt::format("'{}' is not a whole number", item));
    if (value < keyword.low || value > keyword.high || (keyword.lowOpen && value == keyword.low))
      fail(entry.line, keyword.name,
           fmt::format("'{}' is not in the allowed range {}{}, {}] {}", item,
                       keyword.lowOpen ? "(" : "[", keyword.low, keyword.high,
                       std::string(keyword.unit) == "1" ? "" : keyword.unit));
  }
}

void Reader::require(const std::string &name) const
{
  if (has(name))
    return;
  throw badInput(file, 0, name, fmt::format("is missing ({})", findKeyword(name)->help));
}

void Reader::refuse(std::initializer_list<const char *> names, const std::string &with) const
{
  for (const char *name : names)
    if (has(name))
      fail(lineOf(name), name, "does not go with " + with);
}

std::vector<std::string> Reader::items(const std::string &name)
{
  const Keyword &keyword = *findKeyword(name);
  if (!has(name)) {
    if (std::string(keyword.initial).empty())
      require(name);
    Entry entry;
    const YAML::Node node = YAML::Load(keyword.initial);
    entry.isList = node.IsSequence();
    if (entry.isList)
      for (const YAML::Node &item : node)
        entry.items.push_back(item.Scalar());
    else
      entry.items.push_back(keyword.initial);
    used[name] = entry;
    return entry.items;
  }
  used[name] = entries.at(name);
  return used[name].items;
}

std::vector<double> Reader::numbers(const std::string &name)
{
  std::vector<double> values;
  for (const std::string &item : items(name))
    values.push_back(parseQuantity(item, findKeyword(name)->unit));
  return values;
}

std::string quoted(const std::string &item)
{
  const bool plain =
      !item.empty() && item.find_first_of(":#{}[],&*?|<>=!%@`'\"\\") == std::string::npos;
  if (plain)
    return item;
  std::string text = "\"";
  for (char c : item) {
    if (c == '"' || c == '\\')
      text += '\\';
    text += c;
  }
  return text + "\"";
}

std::string Reader::configuration() const
{
  std::string text, openGroup;
  for (const Keyword &keyword : keywords()) {
    const auto found = used.find(keyword.name);
    if (found == used.end())
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
    for (const std::string &item : entry.items)
      parts.push_back(quoted(item));
    const std::string value = fmt::format("{}", fmt::join(parts, ", "));
    text += indent + name + ": " + (entry.isList ? "[" + value + "]" : value) + "\n";
  }
  return text;
}

void readContact(Reader &reader, Case &c)
{
  for (const char *name :
       {"contact.load_per_length", "contact.youngs_modulus", "contact.poissons_ratio"})
    reader.require(name);
  c.load = reader.number("contact.load_per_length");
  if (reader.has("contact.period")) {
    reader.refuse({"contact.radius", "contact.domain"}, "contact.period: the surfaces are flat");
    c.period = reader.number("contact.period");
    c.radius = std::numeric_limits<double>::infinity();
  } else {
    c.radius = reader.number("contact.radius");
    c.domain = reader.number("contact.domain");
  }
  c.youngsModulus = reader.number("contact.youngs_modulus");
  c.poissonsRatio = reader.number("contact.poissons_ratio");
  c.hardnessLimit = reader.flag("contact.hardness_limit");
  c.points = static_cast<int>(reader.number("points"));
}

void readRoughness(Reader &reader, Case &c)
{
  const bool measured = reader.has("roughness.rail") || reader.has("roughness.wheel");
  if (!reader.hasGroup("roughness")) {
    reader.items("roughness");
    return;
  }
  if (measured) {
    reader.refuse({"roughness.hurst", "roughness.rms_slope", "roughness.rms_height",
                   "roughness.wavelength_min", "roughness.wavelength_max", "roughness.seed"},
                  "measured profiles (roughness.rail, roughness.wheel)");
    c.roughness = RoughnessKind::Measured;
    if (reader.has("roughness.rail"))
      c.rail = reader.items("roughness.rail");
    if (reader.has("roughness.wheel"))
      c.wheel = reader.items("roughness.wheel");
    if (!c.rail.empty() && !c.wheel.empty() && c.rail.size() != c.wheel.size())
      reader.fail(reader.lineOf("roughness.wheel"), "roughness.wheel",
                  fmt::format("{} files; as many as of roughness.rail, {}, are expected",
                              c.wheel.size(), c.rail.size()));
    if (reader.has("roughness.cutoff"))
      c.cutoff = reader.number("roughness.cutoff");
    const std::vector<std::string> orders = split(findKeyword("roughness.detrend")->choices, '|');
    const std::string order = reader.word("roughness.detrend");
    c.detrend =
        static_cast<int>(std::find(orders.begin(), orders.end(), order) - orders.begin()) - 1;
    return;
  }
  reader.refuse({"roughness.cutoff", "roughness.detrend"}, "a generated profile");
  for (const char *name :
       {"roughness.hurst", "roughness.wavelength_min", "roughness.wavelength_max"})
    reader.require(name);
  c.roughness = RoughnessKind::Fractal;
  c.surface.hurst = reader.number("roughness.hurst");
  if (reader.has("roughness.rms_slope") == reader.has("roughness.rms_height"))
    reader.fail(reader.lineOf("roughness.rms_slope"), "roughness",
                "one of rms_slope and rms_height is needed, not both");
  if (reader.has("roughness.rms_slope"))
    c.surface.rmsSlope = reader.number("roughness.rms_slope");
  else
    c.surface.rmsHeight = reader.number("roughness.rms_height");
  c.surface.wavelengthMin = reader.number("roughness.wavelength_min");
  c.surface.wavelengthMax = reader.number("roughness.wavelength_max");
  if (c.surface.wavelengthMin > c.surface.wavelengthMax)
    reader.fail(reader.lineOf("roughness.wavelength_min"), "roughness.wavelength_min",
                "is above wavelength_max");
  for (double seed : reader.numbers("roughness.seed"))
    c.seeds.push_back(static_cast<std::uint64_t>(seed));
}

void readFriction(Reader &reader, Case &c)
{
  c.law = reader.word("friction.law");
  if (c.law == "constant") {
    c.mu = reader.number("friction.mu");
  } else {
    if (reader.has("friction.mu"))
      reader.fail(reader.lineOf("friction.mu"), "friction.mu", "goes with 'law: constant' only");
    c.local = reader.flag("friction.local");
    c.velocityTerm = reader.flag("friction.velocity_term");
    c.frictionModulus = reader.number("friction.modulus");
    c.frictionDensity = reader.number("friction.density");
  }
  c.strength = reader.number("friction.strength");
  c.strengthTemperature = reader.number("friction.strength_temperature");
}

void readThermal(Reader &reader, Case &c)
{
  if (reader.has("thermal")) {
    reader.items("thermal");
    c.thermal = ThermalModel::Off;
    return;
  }
  c.material = {reader.number("thermal.conductivity"), reader.number("thermal.density"),
                reader.number("thermal.specific_heat")};
  const std::string model = reader.word("thermal.model");
  c.thermal = model == "local"            ? ThermalModel::Local
              : model == "averaged_power" ? ThermalModel::AveragedPower
                                          : ThermalModel::Averaged;
}

void readCreeps(Reader &reader, Case &c)
{
  c.speed = reader.numbers("speed");
  if (!reader.hasGroup("creep")) {
    c.creep = reader.numbers("creep");
    return;
  }
  const double from = reader.number("creep.from"), to = reader.number("creep.to");
  const int n = static_cast<int>(reader.number("creep.n"));
  const bool logarithmic = reader.word("creep.spacing") == "log";
  if (to < from || (n > 1 && to == from))
    reader.fail(reader.lineOf("creep.to"), "creep.to", "must be above creep.from");
  if (logarithmic && !(from > 0.0))
    reader.fail(reader.lineOf("creep.from"), "creep.from", "must be positive when spacing is log");
  for (int i = 0; i < n; ++i) {
    const double part = n > 1 ? double(i) / (n - 1) : 0.0;
    c.creep.push_back(logarithmic ? from * std::pow(to / from, part) : from + part * (to - from));
  }
  c.creep.back() = n > 1 ? to : from;
}

/// Rolling, or the static case; what the other one needs is left alone.
void readMode(Reader &reader, Case &c)
{
  const std::string mode = reader.word("mode");
  if (mode != "static") {
    c.mode = mode == "moving" ? RollingMode::Moving : RollingMode::Frozen;
    reader.refuse({"contact.period"}, "mode " + mode + ": rolling needs a radius");
    readThermal(reader, c);
    readCreeps(reader, c);
    if (c.mode == RollingMode::Moving) {
      c.passes = static_cast<int>(reader.number("moving.passes"));
      c.referenceLength = reader.number("moving.reference_length");
    }
    return;
  }
  c.mode = RollingMode::Static;
  c.thermal = ThermalModel::Off;
  reader.require("static.force_ratio");
  c.forceRatio = reader.numbers("static.force_ratio");
  if (c.local)
    reader.fail(reader.lineOf("friction.local"), "friction.local",
                "mode static needs one friction coefficient for the whole contact: false");
  if (c.hardnessLimit && *std::max_element(c.forceRatio.begin(), c.forceRatio.end()) > 0.0)
    reader.fail(reader.lineOf("contact.hardness_limit"), "contact.hardness_limit",
                "mode static needs elastic contact, false, for a static.force_ratio above 0");
}

void readUncertainty(Reader &reader, Case &c)
{
  if (c.law == "constant" || c.mode == RollingMode::Static)
    return; // no covariance, or none that matters
  c.uncertainty = reader.word("uncertainty.method") == "sampled" ? UncertaintyMethod::Sampled
                                                                 : UncertaintyMethod::Linear;
  if (c.uncertainty == UncertaintyMethod::Linear)
    return;
  c.uncertaintySamples = static_cast<int>(reader.number("uncertainty.samples"));
  c.uncertaintySeed = static_cast<std::uint64_t>(reader.number("uncertainty.seed"));
}

/// Profile and law files are named from the folder of the case file.
std::string besideCase(const std::string &path, const std::string &caseFile)
{
  const std::filesystem::path given(path);
  if (given.is_absolute() || std::filesystem::exists(given))
    return path;
  return (std::filesystem::path(caseFile).parent_path() / given).string();
}

} // namespace

std::size_t Case::profiles() const
{
  return std::max({std::size_t{1}, seeds.size(), rail.size(), wheel.size()});
}

Case readCase(const std::string &path, const std::vector<std::string> &changes)
{
  Reader reader(path);
  const std::string text = readInputFile(path);
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap())
      throw badInput(path, 0, "", "is not a case file: 'keyword: value' lines are expected");
    reader.collect(root, "");
  } catch (const YAML::Exception &problem) {
    throw badInput(path, problem.mark.line + 1, "", problem.msg);
  }
  reader.onCommandLine = true;
  for (const std::string &change : changes)
    reader.change(change);
  reader.onCommandLine = false;

  Case result;
  readContact(reader, result);
  readRoughness(reader, result);
  readFriction(reader, result);
  readMode(reader, result);
  readUncertainty(reader, result);
  result.text = reader.configuration();
  for (auto *files : {&result.rail, &result.wheel})
    for (std::string &file : *files)
      file = besideCase(file, path);
  if (result.law != "constant" && result.law != "bucher2006")
    result.law = besideCase(result.law, path);
  return result;
}

} // namespace wheelrail
