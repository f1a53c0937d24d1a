// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/friction_log_head.h"

#include "laws/interface_words.h"
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
  std::string word = mcawr::numberWord(value, 12);
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
    const bool whole =
        what.range == format::Range::Whole || what.range == format::Range::SignedWhole;
    const std::string word = whole ? std::to_string(static_cast<long long>(value)) : number(value);
    if (!format::isIn(what.range, value))
      throw std::runtime_error(
          std::string(what.key) + " is " + word +
          ", allowed in a friction log: " + format::describe(what.range, what.unit));
    add(what.key, word);
  }
  std::string line() const { return line_ + (empty_ ? ": {}\n" : "}\n"); }

 private:
  std::string line_;
  bool empty_ = true;
};

/// The head's numbers of a material.
format::Head numbersOf(const Material &material, const Units &u)
{
  format::Head n;
  n.youngsModulus = material.youngsModulus * u.stress;
  n.poissonsRatio = material.poissonsRatio;
  n.density = material.density * u.density();
  n.elasticLimit = material.sigmaY1() * u.stress;
  n.yieldStrength = material.sigmaY2() * u.stress;
  n.yieldStrain = material.yieldStrain;
  n.strength = material.strength * u.stress;
  n.breakingStrain = material.breakingStrain;
  n.viscosity = material.viscosity * u.viscosity();
  n.diameter = material.diameter * u.length;
  return n;
}

format::Head numbersOf(const LogHeader &h, const Units &u)
{
  format::Head n = numbersOf(h.material, u);
  n.pressure = h.pressure * u.stress;
  n.velocity = h.velocity * u.velocity();
  n.width = h.width * u.length;
  n.thickness = h.thickness * u.length;
  n.automata = static_cast<double>(h.automata);
  n.timestep = h.timestep * u.time;
  n.every = static_cast<double>(h.every);
  n.seed = static_cast<double>(h.seed);
  return n;
}

/// The line of a section of numbers.
/// \param section  whose numbers they are
/// \param title    the name that it has in the head
/// \param word     that stands among them: of the geometry the packing, before the number of
///                 automata; of a material what is made of it, at the end, or empty
std::string numbersLine(const char *section, const std::string &title, const format::Head &numbers,
                        const std::string &word)
{
  Section line(title);
  for (const format::HeadNumber &number : format::headNumbers) {
    if (std::string(number.section) != section)
      continue;
    if (number.value == &format::Head::automata)
      line.add(format::packingKey, word);
    line.add(number, numbers.*number.value);
  }
  if (std::string(section) == format::section::material && !word.empty())
    line.add(format::layerKey, word);
  return line.line();
}

/// Keywords and values as pair_coeff takes them, in the units of the log.
std::string interfaceLine(const std::string &title, const std::pair<int, int> &types,
                          const Interface &of, const Units &u)
{
  Section line(title);
  line.add(format::typesKey, std::to_string(types.first) + " " + std::to_string(types.second));
  Interface inLog = of;
  if (inLog.strength)
    *inLog.strength *= u.stress;
  if (inLog.viscosity)
    *inLog.viscosity *= u.viscosity();
  const std::vector<std::string> words = wordsOf(inLog);
  for (std::size_t k = 0; k + 1 < words.size(); k += 2) {
    const auto value = mcawr::plainNumber(words[k + 1]);
    line.add(words[k], value ? number(*value) : words[k + 1]);
  }
  return line.line();
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

void LogHeader::use(const std::vector<Material> &all, const Material &ofDriven)
{
  std::vector<Material> sorted;
  for (const Material &one : all)
    if (std::find(sorted.begin(), sorted.end(), one) == sorted.end())
      sorted.push_back(one);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Material &a, const Material &b) { return a.strength < b.strength; });
  driven = std::find(sorted.begin(), sorted.end(), ofDriven) - sorted.begin();
  material = sorted.front();
  otherMaterials.assign(sorted.begin() + 1, sorted.end());
}

std::string headOf(const LogHeader &h, const Units &u)
{
  namespace names = format::section;
  Section program(names::program), units(names::units), laws(names::laws);
  program.add("name", "mca-wheelrail");
  program.add("version", MCA_VERSION);
  program.add("lammps", std::to_string(h.lammpsVersion));
  for (const auto &[quantity, unit] : format::units)
    units.add(quantity, unit);
  for (size_t k = 0; k + 1 < h.laws.size(); k += 2)
    laws.add(h.laws[k], h.laws[k + 1]);
  const format::Head numbers = numbersOf(h, u);
  auto line = [&](const char *name) { return numbersLine(name, name, numbers, h.packing); };
  auto part = [&](std::size_t material) {
    return h.otherMaterials.empty() ? "" : material == h.driven ? "driven" : "other";
  };
  std::string materials = numbersLine(names::material, names::material, numbers, part(0));
  for (std::size_t k = 1; k <= h.otherMaterials.size(); k++)
    materials +=
        numbersLine(names::material, format::otherMaterial + (k > 1 ? "_" + std::to_string(k) : ""),
                    numbersOf(h.otherMaterials[k - 1], u), part(k));
  std::string interfaces;
  int count = 0;
  for (const auto &[types, interface] : h.interfaces) {
    const std::string more = ++count > 1 ? "_" + std::to_string(count) : "";
    interfaces += interfaceLine(format::interfaceSection + more, types, interface, u);
  }
  return format::formatLine() + "\n" + program.line() + units.line() + materials + interfaces +
         line(names::loading) + line(names::geometry) + laws.line() + line(names::run);
}

std::string differenceFrom(const std::string &head, const LogHeader &header, const Units &units)
{
  const std::vector<Entry> there = entriesOf(head), here = entriesOf(headOf(header, units));
  std::vector<std::string> varying = header.varying;
  varying.emplace_back(format::headNumber(&format::Head::automata).key);
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
