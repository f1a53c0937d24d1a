// SPDX-License-Identifier: GPL-2.0-or-later
#include "keyword.h"

#include "shared/plain_number.h"

#include <charconv>
#include <limits>

namespace mca {

double Threshold::factor() const
{
  if (kind_ != Kind::Factor)
    throw std::logic_error("this threshold is no multiple");
  return factor_;
}

double Threshold::limit(double unit, double ofMaterial) const
{
  return isOff()          ? std::numeric_limits<double>::infinity()
         : isOfMaterial() ? ofMaterial
                          : factor_ * unit;
}

std::string Threshold::word(const char *name) const
{
  if (isOff())
    return "none";
  if (isOfMaterial())
    return name;
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), factor_).ptr);
}

bool Threshold::take(const std::string &word, const char *name)
{
  const auto number = mcawr::plainNumber(word);
  if (word == "none")
    *this = off();
  else if (name && word == name)
    *this = ofMaterial();
  else if (number && *number > 0.0)
    *this = times(*number);
  else
    return false;
  return true;
}

std::string Threshold::allowed(const char *name, const char *number)
{
  return std::string(number) + ", " + (name ? std::string(name) + ", " : "") + "none";
}

} // namespace mca
