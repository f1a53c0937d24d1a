// SPDX-License-Identifier: GPL-2.0-or-later
// Every keyword of a law and every word that it takes stands on the page of pair_style mca, and
// nothing else stands there; each criterion of fracture stands on the page of the laws.
#include "laws/law_set.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

using mca::LawSet;
using testing::HasSubstr;

namespace {

std::string page(const std::string &name)
{
  std::ifstream file(std::string(PROJECT_SOURCE) + "/doc/" + name);
  EXPECT_TRUE(file.good()) << name;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> linesOf(const std::string &text)
{
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    all.push_back(line);
  return all;
}

std::string section(const std::string &text, const std::string &title)
{
  const size_t from = text.find("\n## " + title + "\n");
  EXPECT_NE(from, std::string::npos) << title;
  return text.substr(from, text.find("\n## ", from + 4) - from);
}

std::vector<std::string> split(const std::string &text, const std::string &separator)
{
  std::vector<std::string> all;
  size_t from = 0;
  for (size_t to; (to = text.find(separator, from)) != std::string::npos;
       from = to + separator.size())
    all.push_back(text.substr(from, to - from));
  all.push_back(text.substr(from));
  return all;
}

const std::set<std::string> notLaws = {"packing", "thickness", "cutoff"};

std::string paragraphsOf(const std::string &keyword)
{
  std::string found;
  bool inside = false;
  for (const std::string &line : linesOf(section(page("pair_mca.md"), "Description"))) {
    if (line.rfind("*" + keyword + "*", 0) == 0)
      inside = true;
    else if (inside && line.rfind('*', 0) == 0 && line.find('*', 1) != std::string::npos)
      for (const LawSet::Keyword &other : LawSet::keywords())
        if (other.name != keyword && line.rfind("*" + other.name + "*", 0) == 0)
          inside = false;
    if (inside)
      found += line + "\n";
  }
  return found;
}

} // namespace

TEST(LawDocs, SyntaxHasEveryKeywordAndWord)
{
  std::map<std::string, std::set<std::string>> written;
  const std::string between = " value = ";
  for (const std::string &line : linesOf(section(page("pair_mca.md"), "Syntax"))) {
    const size_t at = line.find(between);
    if (at == std::string::npos || line.find(' ') != at)
      continue;
    const auto values = split(line.substr(at + between.size()), " or ");
    written[line.substr(0, at)] = {values.begin(), values.end()};
  }
  for (const LawSet::Keyword &keyword : LawSet::keywords()) {
    std::set<std::string> words(keyword.words.begin(), keyword.words.end());
    if (keyword.takesNumber)
      words.insert("factor");
    EXPECT_EQ(written[keyword.name], words) << keyword.name;
    written.erase(keyword.name);
  }
  for (const auto &[keyword, values] : written)
    EXPECT_EQ(notLaws.count(keyword), 1u) << keyword << " is no keyword";
}

TEST(LawDocs, DescriptionHasAParagraphOfEveryKeywordWithItsWords)
{
  for (const LawSet::Keyword &keyword : LawSet::keywords()) {
    const std::string text = paragraphsOf(keyword.name);
    EXPECT_NE(text, "") << "no paragraph begins with *" << keyword.name << "*";
    for (const std::string &word : keyword.words)
      EXPECT_THAT(text, HasSubstr("*" + word + "*")) << keyword.name;
  }
}

TEST(LawDocs, TableOfPresetsIsThatOfTheLaws)
{
  const std::vector<std::string> presets = {"a", "b", "c", "d"};
  std::map<std::string, std::vector<std::string>> rows; // word of each preset
  for (const std::string &line : linesOf(section(page("pair_mca.md"), "Description")))
    if (line.rfind("| *", 0) == 0) {
      auto cells = split(line, " | ");
      ASSERT_EQ(cells.size(), 1 + presets.size()) << line;
      cells.back() = split(cells.back(), " |")[0];
      rows[cells[0].substr(3, cells[0].size() - 4)] = {cells.begin() + 1, cells.end()};
    }
  for (size_t p = 0; p < presets.size(); p++) {
    const std::vector<std::string> words = LawSet::named(presets[p]).words();
    for (size_t k = 2; k < words.size(); k += 2) { // after the preset itself
      const std::string &word = words[k + 1];
      ASSERT_EQ(rows.count(words[k]), 1u) << words[k];
      const std::string &written = rows[words[k]][p];
      EXPECT_TRUE(written == word ||
                  (std::isdigit(word[0]) && std::stod(written) == std::stod(word)))
          << words[k] << ": " << written;
    }
  }
  EXPECT_EQ(rows.size(), LawSet::named("c").words().size() / 2 - 1);
}

TEST(LawDocs, PageOfTheLawsHasEveryCriterion)
{
  const std::string laws = section(page("laws.md"), "Links");
  for (const auto &criterion : mca::FractureLaw::criteria())
    if (std::string(criterion.keyword) != "none") {
      EXPECT_THAT(laws, HasSubstr("*fracture " + std::string(criterion.keyword) + "*"));
    }
}
