// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/links_text.h"

#include "core/automaton_states.h"
#include "files/restart_format.h"
#include "laws/linking.h"
#include "shared/plain_number.h"
#include "shared/plain_text.h"
#include "shared/printable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

namespace mca {

namespace {

// what begins the comments of ours, and the line with the checksum of all others
constexpr const char *NAME = "# mca-links ", *MARK = "# mca-links 2";
constexpr const char *CHECKSUM = "# checksum ";

std::string checksumLine(const std::string &text)
{
  std::array<char, 16> digits;
  const char *end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                  checksum(text.data(), text.size()), 16)
                        .ptr;
  const std::string word(digits.data(), static_cast<std::size_t>(end - digits.data()));
  return CHECKSUM + std::string(digits.size() - word.size(), '0') + word + "\n";
}

std::string exact(double value)
{
  return mcawr::numberWord(value, 17);
}

// the words of a line, of which numbers are taken one by one
class Words {
 public:
  Words(const std::string &line, std::int64_t largestId)
      : in_(line), largestId_(static_cast<double>(largestId))
  {
  }
  std::string next()
  {
    std::string word;
    good_ = static_cast<bool>(in_ >> word) && good_;
    return word;
  }
  double number()
  {
    const auto value = mcawr::plainNumber(next());
    good_ = good_ && value;
    return value.value_or(0.0);
  }
  std::int64_t id()
  {
    const double value = number();
    good_ = good_ && value >= 1.0 && value <= largestId_ && value == std::floor(value);
    return good_ ? static_cast<std::int64_t>(value) : 0;
  }
  void require(bool holds) { good_ = good_ && holds; }
  // and nothing follows, but for a comment where the line is no comment itself
  bool ended()
  {
    std::string word;
    return good_ && (!(in_ >> word) || word[0] == '#');
  }

 private:
  std::istringstream in_;
  double largestId_;
  bool good_ = true;
};

// "# pair ..." and "# automaton ..." of mca_links write; false: another comment
bool parseComment(Words &words, const std::string &where, int stateSize, Links &links)
{
  const std::string what = words.next();
  if (what == "pair") {
    const std::int64_t i = words.id(), j = words.id();
    Links::Pair pair{std::vector<double>(stateSize), false};
    pair.state[0] = words.number();
    const double original = words.number();
    for (int m = 1; m < stateSize; m++)
      pair.state[m] = words.number();
    pair.original = original == 1.0;
    words.require(i != j && (original == 0.0 || original == 1.0) && link::isKind(pair.state[0]));
    words.require(links.pairs.emplace(std::minmax(i, j), pair).second);
  } else if (what == "automaton") {
    const std::int64_t i = words.id();
    const std::string name = words.next();
    const double value = words.number();
    const auto known =
        std::find_if(std::begin(automatonStates), std::end(automatonStates),
                     [&name](const AutomatonState &state) { return name == state.name; });
    if (known == std::end(automatonStates))
      throw LinksError(where + ": automata have no value " + name);
    links.automata[i].push_back({static_cast<int>(known - automatonStates), value});
  } else
    return false;
  return true;
}

// a line of the section Bonds of any data file
void parseBond(Words &words, int stateSize, Links &links)
{
  const double kind = words.number();
  const std::int64_t i = words.id(), j = words.id();
  Links::Pair pair{std::vector<double>(stateSize, 0.0), true};
  pair.state[0] = kind;
  words.require(i != j && link::isKind(kind) && link::isLinked(kind));
  words.require(links.pairs.emplace(std::minmax(i, j), pair).second);
}

Links parse(const std::string &text, int stateSize, std::int64_t largestId)
{
  Links links;
  std::istringstream lines(text);
  bool ours = false, bonds = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    number++;
    ours = ours || line.rfind(MARK, 0) == 0;
    if (line.find_first_not_of(" \t\r") == std::string::npos)
      continue;
    Words words(line, largestId);
    const std::string first = words.next();
    const std::string where = "line " + std::to_string(number) + ": " + line;
    if (ours && first == "#") {
      if (parseComment(words, where, stateSize, links) && !words.ended())
        throw LinksError(where + ", allowed: # pair id1 id2 kind original plastic shears, each "
                                 "pair once, or # automaton id name value");
    } else if (!ours && first[0] != '#') {
      if (first.find_first_not_of("0123456789") != std::string::npos)
        bonds = first == "Bonds";
      else if (bonds) {
        parseBond(words, stateSize, links);
        if (!words.ended())
          throw LinksError(where +
                           ", allowed in Bonds: ID, type 1 (bulk link), 2 (weld) or 3 (healed "
                           "link), both atoms, each pair once");
      }
    }
  }
  if (links.pairs.empty() && !ours)
    throw LinksError("neither comments of mca_links write nor a section Bonds");
  links.hasStates = ours;
  return links;
}

// A file of ours is as it was written: the line of its checksum, and the mark, are there.
bool isChanged(std::string text)
{
  const std::size_t at = text.find(std::string("\n") + CHECKSUM) + 1; // 0: none
  if (at == 0 && text.find(NAME) == std::string::npos)
    return false; // a data file of others
  const std::size_t end = text.find('\n', at) + 1;
  const std::string line = at == 0 || end == 0 ? "" : text.substr(at, end - at);
  text.erase(at, line.size());
  return line != checksumLine(text);
}

} // namespace

LinksError::LinksError(const std::string &line)
    : std::runtime_error(mcawr::printable(mcawr::shortened(line)))
{
}

bool Links::Pair::operator==(const Pair &other) const
{
  return state == other.state && original == other.original;
}

bool Links::Value::operator==(const Value &other) const
{
  return state == other.state && value == other.value;
}

std::string pairLine(std::int64_t i, std::int64_t j, const double *state, int size, bool original)
{
  std::string line = "# pair " + std::to_string(i) + " " + std::to_string(j) + " " +
                     std::to_string(static_cast<int>(state[0])) + (original ? " 1" : " 0");
  for (int m = 1; m < size; m++)
    line += " " + exact(state[m]);
  return line + "\n";
}

std::string automatonLine(std::int64_t id, int state, double value)
{
  return "# automaton " + std::to_string(id) + " " + automatonStates[state].name + " " +
         exact(value) + "\n";
}

std::string linksHead(const std::string &counts, const std::string &comments)
{
  return "LAMMPS data file by mca_links, for atom_style hybrid sphere bond; bond type = kind of "
         "link\n\n" +
         counts + "\n" + MARK +
         ": pair id1 id2 kind original plastic shears; automaton id name value\n" + comments;
}

std::string sealedLinks(std::string text)
{
  const std::string line = checksumLine(text);
  return text.insert(std::min(text.find(MARK), text.size()), line);
}

Links linksIn(const std::string &bytes, int stateSize, std::int64_t largestId)
{
  const auto [text, problem] = mcawr::plainText(bytes);
  if (!problem.empty())
    throw LinksError(problem);
  Links links = parse(text, stateSize, largestId);
  if (isChanged(text))
    throw LinksError("it does not match its checksum: it was cut or changed since mca_links write, "
                     "or is of another version");
  return links;
}

} // namespace mca
