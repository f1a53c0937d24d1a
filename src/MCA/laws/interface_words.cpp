// SPDX-License-Identifier: GPL-2.0-or-later
#include "interface_words.h"

#include "shared/nearest_word.h"
#include "shared/plain_number.h"

#include <algorithm>
#include <iterator>

namespace mca {

namespace {

struct Quantity {
  const char *keyword;
  std::optional<double> Interface::*value;
  bool (*accepts)(double);
  const char *allowed;
};

constexpr double least = 1e-60, most = 1e60; // as of a material

constexpr Quantity quantities[] = {
    {"strength", &Interface::strength, [](double x) { return x >= least && x <= most; },
     "> 0, 1e-60 to 1e60"},
    {"breaking_strain", &Interface::breakingStrain, [](double x) { return x > 0.0 && x < 0.5; },
     "> 0 and < 0.5"},
    {"viscosity", &Interface::viscosity,
     [](double x) { return x == 0.0 || (x >= least && x <= most); }, ">= 0, 0 or 1e-60 to 1e60"},
    {FrictionWords::keyword, &Interface::friction, [](double x) { return x >= 0.0; },
     FrictionWords::range},
};
constexpr const char *linkKeywords[] = {LinkWords::keyword, WeldWords::keyword, HealWords::keyword,
                                        HealedStrainWords::keyword, WornWords::keyword};

std::string bad(const std::string &keyword, const std::string &value, const std::string &allowed)
{
  return "interface " + keyword + " is '" + value + "', allowed: " + allowed;
}

} // namespace

std::vector<std::string> wordsOf(const Interface &interface)
{
  std::vector<std::string> all;
  for (const Quantity &q : quantities)
    if (const auto &value = interface.*q.value)
      all.insert(all.end(), {q.keyword, mcawr::numberWord(*value, 17)});
  all.insert(all.end(), interface.links.begin(), interface.links.end());
  return all;
}

std::string readInterface(const std::vector<std::string> &words, const LawSet &laws,
                          Interface &interface)
{
  Interface read;
  for (std::size_t k = 0; k < words.size(); k += 2) {
    const std::string &keyword = words[k];
    if (k + 1 == words.size())
      return "interface keyword " + keyword + " has no value";
    const std::string &value = words[k + 1];
    const auto *const q = std::find_if(std::begin(quantities), std::end(quantities),
                                       [&](const Quantity &one) { return keyword == one.keyword; });
    if (q != std::end(quantities)) {
      const auto number = mcawr::plainNumber(value);
      if (!number || !q->accepts(*number))
        return bad(keyword, value, q->allowed);
      read.*q->value = number;
    } else if (std::find(std::begin(linkKeywords), std::end(linkKeywords), keyword) !=
               std::end(linkKeywords)) {
      read.links.insert(read.links.end(), {keyword, value});
    } else {
      std::vector<std::string> known;
      for (const Quantity &one : quantities)
        known.emplace_back(one.keyword);
      known.insert(known.end(), std::begin(linkKeywords), std::end(linkKeywords));
      return mcawr::unknownWord("interface keyword", keyword, known);
    }
  }
  std::string wrong = problemOf(read, laws);
  if (wrong.empty())
    interface = read;
  return wrong;
}

std::string problemOf(const Interface &interface, const LawSet &laws)
{
  LawSet own = laws;
  if (std::string wrong = own.parse(interface.links); !wrong.empty())
    return "interface: " + wrong;
  // what was given for nothing was meant otherwise
  const std::string criterion = laws.fracture.word();
  if (criterion == "strain" && interface.strength && !interface.breakingStrain)
    return "interface strength alone breaks no link: by fracture strain links break at "
           "breaking_strain, give it, too";
  if (criterion != "strain" && criterion != "none" && interface.breakingStrain &&
      !interface.strength)
    return "interface breaking_strain alone breaks no link: by fracture " + criterion +
           " links break by the strength, give it, too";
  return "";
}

} // namespace mca
