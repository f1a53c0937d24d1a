// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/friction_log_head.h"

#include "shared/friction_log_format.h"
#include "shared/plain_number.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace mca {

namespace format = mcawr::friction_log;

// YAML 1.1 takes a number with an exponent for text unless it has a point
static std::string number(double value)
{
  std::ostringstream text;
  text.precision(12);
  text << value;
  std::string word = text.str();
  const auto exponent = word.find('e');
  if (exponent != std::string::npos && word.find('.') == std::string::npos)
    word.insert(exponent, ".0");
  return word;
}

namespace {

/// One line of the head, "# NAME: {KEY: VALUE, ...}".
class Section {
 public:
  explicit Section(const std::string &name) : line_(std::string(format::headMark) + " " + name) {}

  void add(const std::string &key, const std::string &value)
  {
    line_ += (empty_ ? ": {" : ", ") + key + ": " + value;
    empty_ = false;
  }
  void add(const format::HeadNumber &what, double value)
  {
    check(what, value, number(value));
    add(what.key, number(value));
  }
  void add(const format::HeadNumber &what, long long value)
  {
    check(what, static_cast<double>(value), std::to_string(value));
    add(what.key, std::to_string(value));
  }

  std::string line() const { return line_ + (empty_ ? ": {}\n" : "}\n"); }

 private:
  std::string line_;
  bool empty_ = true;

  static void check(const format::HeadNumber &what, double value, const std::string &word)
  {
    if (!format::isIn(what.range, value))
      throw std::runtime_error(
          std::string(what.key) + " is " + word +
          ", allowed in a friction log: " + format::describe(what.range, what.unit));
  }
};

std::string materialLine(const Material &m, const Units &u)
{
  Section section(format::section::material);
  section.add(format::head::youngsModulus, m.youngsModulus * u.stress);
  section.add(format::head::poissonsRatio, m.poissonsRatio);
  section.add(format::head::density, m.density * u.density());
  section.add(format::head::elasticLimit, m.sigmaY1() * u.stress);
  section.add(format::head::yieldStrength, m.sigmaY2() * u.stress);
  section.add(format::head::yieldStrain, m.yieldStrain);
  section.add(format::head::strength, m.strength * u.stress);
  section.add(format::head::breakingStrain, m.breakingStrain);
  section.add(format::head::viscosity, m.viscosity * u.viscosity());
  return section.line();
}

/// A value of a head.
struct Entry {
  std::string section, key, value;
};

// "# NAME: {KEY: VALUE, ...}" in each line but the first, which names the format
std::vector<Entry> entriesOf(const std::string &head)
{
  std::vector<Entry> all;
  std::istringstream lines(head);
  for (std::string line; std::getline(lines, line);) {
    const auto colon = line.find(": {");
    if (colon == std::string::npos || line.size() < 2 || line.back() != '}')
      continue;
    const std::string section = line.substr(2, colon - 2);
    std::istringstream pairs(line.substr(colon + 3, line.size() - colon - 4) + ", ");
    std::string pair;
    while (std::getline(pairs >> std::ws, pair, ',')) {
      const auto end = pair.find(": ");
      if (end != std::string::npos)
        all.push_back({section, pair.substr(0, end), pair.substr(end + 2)});
    }
  }
  return all;
}

bool agree(const std::string &a, const std::string &b)
{
  constexpr double roundOff = 1e-9; // of twelve digits, and of a box that was read from a file
  const auto x = mcawr::plainNumber(a), y = mcawr::plainNumber(b);
  return a == b || (x && y && std::abs(*x - *y) <= roundOff * std::max(std::abs(*x), std::abs(*y)));
}

const Entry *find(const std::vector<Entry> &all, const Entry &named)
{
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry &e) {
    return e.section == named.section && e.key == named.key;
  });
  return found == all.end() ? nullptr : &*found;
}

} // namespace

std::string headOf(const LogHeader &h, const Units &u)
{
  namespace names = format::section;
  Section program(names::program), units(names::units), loading(names::loading),
      geometry(names::geometry), laws(names::laws), run(names::run);
  program.add("name", "mca-wheelrail");
  program.add("version", MCA_VERSION);
  program.add("lammps", std::to_string(h.lammpsVersion));
  for (const auto &[quantity, unit] : format::units)
    units.add(quantity, unit);
  loading.add(format::head::pressure, h.pressure * u.stress);
  loading.add(format::head::velocity, h.velocity * u.velocity());
  geometry.add(format::head::width, h.width * u.length);
  geometry.add(format::head::thickness, h.thickness * u.length);
  geometry.add(format::head::diameter, h.material.diameter * u.length);
  geometry.add(format::packingKey, h.packing);
  geometry.add(format::head::automata, h.automata);
  for (size_t k = 0; k + 1 < h.laws.size(); k += 2)
    laws.add(h.laws[k], h.laws[k + 1]);
  run.add(format::head::timestep, h.timestep * u.time);
  run.add(format::head::every, h.every);
  run.add(format::head::seed, h.seed);
  return format::formatLine() + "\n" + program.line() + units.line() + materialLine(h.material, u) +
         loading.line() + geometry.line() + laws.line() + run.line();
}

std::string differenceFrom(const std::string &head, const LogHeader &header, const Units &units)
{
  const std::vector<Entry> there = entriesOf(head), here = entriesOf(headOf(header, units));
  std::vector<std::string> varying = header.varying;
  varying.emplace_back(format::head::automata.key);
  auto counts = [&](const Entry &e) {
    return e.section != format::section::program &&
           std::find(varying.begin(), varying.end(), e.key) == varying.end();
  };
  for (const Entry &e : here)
    if (const Entry *other = find(there, e); counts(e) && !(other && agree(other->value, e.value)))
      return e.section + ": " + e.key + " is " + (other ? other->value : "missing") +
             " in the log, " + e.value + " in this run";
  for (const Entry &e : there)
    if (counts(e) && !find(here, e))
      return e.section + ": " + e.key + " is " + e.value + " in the log, not in this run";
  return "";
}

std::string versionsIn(const std::string &head)
{
  std::string versions;
  for (const Entry &e : entriesOf(head))
    if (e.section == format::section::program)
      versions += (versions.empty() ? "" : " ") + e.key + " " + e.value;
  return versions;
}

} // namespace mca
