// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_laws.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace wheelrail {

bool LawForm::reads(const std::string &keyword) const
{
  return std::any_of(keywords.begin(), keywords.end(),
                     [&](const LawKeyword &own) { return keyword == own.name; });
}

const std::vector<LawForm> &lawForms()
{
  static const std::vector<LawForm> forms = FrictionLaws::forms();
  return forms;
}

const LawForm &lawFormOf(const LawName &name)
{
  return *std::find_if(lawForms().begin(), lawForms().end(),
                       [&](const LawForm &form) { return form.isNamedBy(name); });
}

std::string lawNames()
{
  std::vector<std::string> names;
  for (const LawForm &form : lawForms())
    names.emplace_back(form.named);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<LawKeyword> lawKeywords()
{
  std::vector<LawKeyword> all;
  for (const LawForm &form : lawForms())
    for (const LawKeyword &keyword : form.keywords)
      if (std::none_of(all.begin(), all.end(), [&](const LawKeyword &other) {
            return std::string(other.name) == keyword.name;
          }))
        all.push_back(keyword);
  return all;
}

std::string lawsWith(const std::string &keyword)
{
  std::vector<std::string> words;
  for (const LawForm &form : lawForms())
    if (form.reads(keyword))
      words.push_back(fmt::format("'law: {}'", form.word));
  return fmt::format("{}", fmt::join(words, " or "));
}

} // namespace wheelrail
