// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/case/help.h"

#include "creep/case/keywords.h"

#include <fmt/format.h>

namespace wheelrail {
namespace {

/// What a keyword allows, of any kind.
std::string allowedOf(const Keyword &keyword)
{
  switch (keyword.kind) {
  case Keyword::Kind::Choice:
    return keyword.choices;
  case Keyword::Kind::Switch:
    return "true|false";
  case Keyword::Kind::Text:
  case Keyword::Kind::TextList:
    return "TEXT";
  default:
    return rangeOf(keyword);
  }
}

} // namespace

std::string caseHelp()
{
  std::string text = R"(
Examples:
  wr_creep table2.yaml -o out
      creep curves of the case: out/creep.csv, creep.json, contact.csv, summary.json
  wr_creep table2.yaml -o out --set speed="20 m/s" --set creep="[0.001, 0.01, 0.1]"
      the same case with other speeds and creeps
  wr_creep table2.yaml -o rough --set roughness="{hurst: 0.8, rms_slope: 0.02,
           wavelength_min: 0.1 mm, wavelength_max: 10 mm, seed: [1, 2, 3]}" --set cells=4096
      three rough profiles
  wr_creep table2.yaml -o own --set friction.law=law.json
      a law fitted by wr_fit; its uncertainty goes to own/creep_band.csv
  wr_creep table2.yaml -o static --set mode=static --set static.force_ratio="[0.25, 0.5]"
      a tangential force without rolling: static/static.csv
  wr_creep table2.yaml --print-config
      the complete case with every default

Keywords of the case file (and of --set), allowed values, defaults:
)";
  for (const Keyword &keyword : keywords()) {
    text += fmt::format("  {:<30} {}", keyword.name, allowedOf(keyword));
    if (*keyword.initial)
      text += fmt::format(" [{}]", keyword.initial);
    text += fmt::format("\n  {:<30}   {}{}\n", "", scopeWords(keyword), keyword.help);
  }
  return text + R"(
Exit codes: 0 ok, 1 internal, 2 usage, 3 bad input file, 4 not converged, 5 input/output,
6 interrupted (run the same command again to continue).
)";
}

} // namespace wheelrail
