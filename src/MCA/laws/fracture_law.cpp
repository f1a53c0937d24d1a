// SPDX-License-Identifier: GPL-2.0-or-later
#include "fracture_law.h"

#include "linking.h"

#include <cstring>

namespace mca {

const std::array<CriterionInfo, FractureCriteria::size> &FractureLaw::criteria()
{
  static const auto table = [] {
    std::array<CriterionInfo, FractureCriteria::size> all{};
    int number = 0;
    FractureCriteria::each([&](auto criterion) {
      using C = decltype(criterion);
      all[number++] = {C::keyword,   C::strainOnly,     C::needsLocalStress, C::inSpace,
                       C::parameter, C::parameterRange, C::accepts};
    });
    return all;
  }();
  return table;
}

bool FractureLaw::take(const std::string &word)
{
  for (int k = 0; k < FractureCriteria::size; k++)
    if (word == criteria()[k].keyword) {
      number_ = k;
      return true;
    }
  return false;
}

std::vector<std::string> FractureLaw::words()
{
  std::vector<std::string> all;
  for (const CriterionInfo &c : criteria())
    all.emplace_back(c.keyword);
  return all;
}

std::string FractureLaw::allowed()
{
  std::string all;
  for (const std::string &word : words())
    all += (all.empty() ? "" : ", ") + word;
  return all;
}

double FractureLaw::parameter(const std::string &name) const
{
  for (int k = 0; k < FractureCriteria::size; k++)
    if (criteria()[k].parameter && name == criteria()[k].parameter)
      return parameter_[k].factor();
  throw std::invalid_argument("no criterion has a number " + name);
}

int FractureLaw::keeperOf(int criterion)
{
  const char *const name = criteria()[criterion].parameter;
  int k = 0;
  while (!criteria()[k].parameter || std::strcmp(criteria()[k].parameter, name) != 0)
    k++;
  return k;
}

std::string FractureLaw::problem() const
{
  for (int k = 0; k < FractureCriteria::size; k++) {
    const CriterionInfo &c = criteria()[k];
    if (!c.parameter || keeperOf(k) != k)
      continue;
    const bool used = criterion().parameter && keeperOf(number_) == k;
    std::string users = criterion().keyword;
    if (!used) {
      users.clear();
      for (const CriterionInfo &other : criteria())
        if (other.parameter && std::strcmp(other.parameter, c.parameter) == 0)
          users += (users.empty() ? "" : " or ") + std::string(other.keyword);
    }
    if (used == parameter_[k].isOff())
      return std::string("keyword ") + c.parameter + " and fracture " + users + " need each other";
    if (used && !criterion().accepts(parameter_[k].factor()))
      return std::string("keyword ") + c.parameter + ", value " + parameterWord(k) +
             ", allowed: a multiple of the strength " + criterion().parameterRange;
  }
  return "";
}

FractureLimits FractureLaw::limits(LinkMaterials materials) const
{
  const Threshold &parameter = parameter_[criterion().parameter ? keeperOf(number_) : number_];
  materials.parameter = parameter.isOff() ? 1.0 : parameter.factor();
  FractureLimits limits{};
  FractureCriteria::with(number_,
                         [&](auto criterion) { limits = decltype(criterion)::limits(materials); });
  return limits;
}

FractureLaw &FractureLaw::operator=(const std::string &word)
{
  if (!take(word))
    throw std::invalid_argument("fracture " + word);
  return *this;
}

bool bulkBreaks(const LinkLimits &limits, const LinkLoad &load)
{
  bool broken = false;
  FractureCriteria::with(limits.criterion, [&](auto criterion) {
    broken = breaks<decltype(criterion)>(load, limits.fracture);
  });
  return broken;
}

} // namespace mca
