// SPDX-License-Identifier: GPL-2.0-or-later
// Every friction law has its paragraph on the page of wr_creep, with its keywords.
#include "law/friction_laws.h"

#include <fstream>
#include <gmock/gmock.h>
#include <set>
#include <sstream>

using namespace wheelrail;
using testing::HasSubstr;

namespace {

/// The section "Friction laws" of the page, by paragraphs; those of laws begin with their word.
std::map<std::string, std::string> paragraphs()
{
  std::ifstream file(PROJECT_SOURCE "/doc/wr_creep.md");
  EXPECT_TRUE(file.good());
  std::map<std::string, std::string> all;
  bool inside = false;
  std::string word;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("##", 0) == 0)
      inside = line == "#### Friction laws";
    if (!inside)
      continue;
    if (line.empty())
      word.clear();
    else if (word.empty() && line.rfind("*`", 0) == 0)
      word = line.substr(2, line.find('`', 2) - 2);
    if (!word.empty())
      all[word] += line + "\n";
  }
  return all;
}

} // namespace

TEST(LawDocs, EveryLawHasItsParagraphWithItsKeywords)
{
  auto written = paragraphs();
  for (const LawForm &form : lawForms()) {
    const std::string &text = written[form.word];
    EXPECT_NE(text, "") << "no paragraph begins with *`" << form.word << "`";
    for (const LawKeyword &keyword : form.keywords)
      EXPECT_THAT(text, HasSubstr("`" + std::string(keyword.name) + "`")) << form.word;
    written.erase(form.word);
  }
  for (const auto &[word, text] : written)
    ADD_FAILURE() << word << " is no law";
}
