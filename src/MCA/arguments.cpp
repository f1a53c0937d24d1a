// SPDX-License-Identifier: GPL-2.0-or-later
#include "arguments.h"

#include "error.h"
#include "lammps.h"
#include "shared/plain_number.h"

#include <charconv>
#include <cmath>
#include <optional>

using namespace LAMMPS_NS;

namespace mca {

template<class Whole>
static std::optional<Whole> plainWhole(const std::string &word)
{
  const char *const first = word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-');
  const char *const last = word.data() + word.size();
  Whole value = 0;
  const auto [end, problem] = std::from_chars(first, last, value);
  if (problem != std::errc() || end != last)
    return std::nullopt;
  return value;
}

double number(LAMMPS *lmp, const std::string &what, const std::string &word, Sign sign,
              const std::string &more)
{
  const auto value = mcawr::plainNumber(word);
  constexpr double largest = 1e60;
  const double size = value ? std::abs(*value) : largest;
  const bool ordinary = size <= largest && size >= 1.0 / largest;
  const bool fits = value && (*value == 0.0 ? sign != Sign::Positive
                                            : ordinary && (sign == Sign::Any || *value > 0.0));
  if (!fits)
    lmp->error->all(FLERR, "{} is '{}', allowed: a finite number{}{}{}", what, word,
                    sign == Sign::Positive      ? " > 0"
                    : sign == Sign::NotNegative ? " >= 0"
                                                : "",
                    more, value && !ordinary ? ", of size 1e-60 to 1e60" : "");
  return *value;
}

bigint wholeNumber(LAMMPS *lmp, const std::string &what, const std::string &word, bigint least,
                   bigint most)
{
  const auto value = plainWhole<bigint>(word);
  if (!value || *value < least || *value > most)
    lmp->error->all(FLERR, "{} is '{}', allowed: a whole number from {} to {}", what, word, least,
                    most);
  return *value;
}

TypeRange typeRange(LAMMPS *lmp, const std::string &what, const std::string &word, int most)
{
  const size_t star = word.find('*');
  const std::string first = word.substr(0, star);
  const std::string last = star == std::string::npos ? first : word.substr(star + 1);
  const bool open = star != std::string::npos;
  const auto from = open && first.empty() ? 1 : plainWhole<int>(first);
  const auto to = open && last.empty() ? most : plainWhole<int>(last);
  if (!from || !to || *from < 1 || *from > *to || *to > most)
    lmp->error->all(FLERR, "{} is '{}', allowed: types from 1 to {} as n, *, n*, *n or m*n", what,
                    word, most);
  return {*from, *to};
}

} // namespace mca
