// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/quantity.h"

#include "shared/plain_number.h"
#include "shared/printable.h"

#include <algorithm>
#include <cctype>
#include <clocale>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <regex>
#include <stdexcept>
#include <udunits2.h>

namespace wheelrail {
namespace {

struct SystemDeleter {
  void operator()(ut_system *system) const { ut_free_system(system); }
};
struct UnitDeleter {
  void operator()(ut_unit *unit) const { ut_free(unit); }
};
struct ConverterDeleter {
  void operator()(cv_converter *converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;

std::mutex udunitsMutex; // the library keeps global state

/// The thread in C's own locale, whatever a host program chose: UDUNITS-2 reads the numbers of its
/// database and of units by the locale.
class PlainLocale {
 public:
  PlainLocale() : plain_(newlocale(LC_ALL_MASK, "C", nullptr)), before_(uselocale(plain_)) {}
  ~PlainLocale()
  {
    uselocale(before_);
    freelocale(plain_);
  }
  PlainLocale(const PlainLocale &) = delete;
  PlainLocale &operator=(const PlainLocale &) = delete;

 private:
  locale_t plain_, before_;
};

/// What is wrong with a text, as one line that shows it.
[[noreturn]] void refuse(const std::string &problem)
{
  throw std::invalid_argument(mcawr::printable(problem));
}

ut_system *unitSystem()
{
  static const std::unique_ptr<ut_system, SystemDeleter> system = [] {
    ut_set_error_message_handler(ut_ignore);
    return std::unique_ptr<ut_system, SystemDeleter>(ut_read_xml(nullptr));
  }();
  if (!system)
    throw std::runtime_error("UDUNITS-2 cannot read its unit database");
  return system.get();
}

/// Without blanks at both ends, among them those that do not break a line: the thin one between a
/// number and its unit is what SI asks for, and what text processors write.
std::string trimmed(std::string text)
{
  for (const char *blank : {"\u00a0", "\u2009", "\u202f"})
    for (std::size_t at; (at = text.find(blank)) != std::string::npos;)
      text.replace(at, std::strlen(blank), " ");
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The number that `text` starts with; `rest` is what follows it.
double leadingNumber(const std::string &text, std::string &rest)
{
  const std::string body = trimmed(text);
  const auto number = mcawr::leadingNumber(body);
  if (!number) {
    // "nan", "inf" and 1e999 are numbers of a kind; the message says what is wrong with them
    const auto first = std::min(body.find_first_not_of("+-."), body.size());
    const std::string word = body.substr(first, 3);
    if (std::isdigit(static_cast<unsigned char>(word[0])))
      refuse(fmt::format("'{}' is beyond the range of double precision", text));
    refuse(fmt::format(
        word == "nan" || word == "inf" ? "'{}' is not finite" : "'{}' is not a number", text));
  }
  rest = trimmed(std::string(number->rest));
  return number->value;
}

/// Does a unit hold a number that is no exponent ("500 N/mm" of "1 500 N/mm")? UDUNITS-2 would take
/// it for a factor. Exponents follow a letter, or its '^', '**' or sign: m2, m^2, m**2, s-1, m^-3.
/// The 1 of "1/mm" is none.
bool holdsNumber(const std::string &unit)
{
  for (std::size_t i = unit.rfind("1/", 0) == 0 ? 2 : 0; i < unit.size(); ++i) {
    if (!std::isdigit(static_cast<unsigned char>(unit[i])))
      continue;
    std::size_t before = i;
    while (before > 0 && std::strchr("+-^*", unit[before - 1]))
      --before;
    if (before == 0 || !std::isalpha(static_cast<unsigned char>(unit[before - 1])))
      return true;
    if (unit.substr(before, i - before) == "*") // a product, m*2
      return true;
    while (i + 1 < unit.size() && std::isdigit(static_cast<unsigned char>(unit[i + 1])))
      ++i;
  }
  return false;
}

} // namespace

double parseNumber(const std::string &text)
{
  std::string rest;
  const double value = leadingNumber(text, rest);
  if (!rest.empty())
    refuse(fmt::format("'{}' is not a plain number", text));
  return value;
}

double parseRatio(const std::string &text)
{
  std::string rest;
  const double value = leadingNumber(text, rest);
  if (!rest.empty() && rest != "%")
    refuse(fmt::format("'{}' is neither a plain number nor one with a per cent sign", text));
  return rest.empty() ? value : value / 100.0;
}

double parseQuantity(const std::string &text, const std::string &unit)
{
  if (unit.empty() || unit == "1")
    return parseNumber(text);
  std::string rest;
  const double value = leadingNumber(text, rest);
  if (rest.empty())
    refuse(fmt::format("'{}' has no unit; one like {} is needed", text, unit));
  if (holdsNumber(rest))
    refuse(fmt::format("'{}' is not one number with a unit like {}; '{}' holds a second number",
                       text, unit, rest));

  const std::lock_guard<std::mutex> lock(udunitsMutex);
  const PlainLocale plain;
  const Unit given(ut_parse(unitSystem(), rest.c_str(), UT_UTF8));
  const Unit wanted(ut_parse(unitSystem(), unit.c_str(), UT_UTF8));
  if (!wanted)
    throw std::logic_error(fmt::format("UDUNITS-2 does not know '{}'", unit));
  if (!given)
    refuse(fmt::format("'{}': '{}' is not a unit", text, rest));
  if (!ut_are_convertible(given.get(), wanted.get()))
    refuse(fmt::format("'{}': '{}' is of another dimension than {}", text, rest, unit));
  const std::unique_ptr<cv_converter, ConverterDeleter> converter(
      ut_get_converter(given.get(), wanted.get()));
  // 0 of a unit with an offset is not 0 of the other: 0 degC is 273.15 K
  if (cv_convert_double(converter.get(), 0.0) != 0.0)
    refuse(fmt::format("'{}': must be given in {}, not on a scale with another zero", text, unit));
  const double converted = cv_convert_double(converter.get(), value);
  if (!std::isfinite(converted))
    refuse(fmt::format("'{}' is not finite in {}", text, unit));
  return converted;
}

std::string siUnit(const std::string &unit)
{
  static const std::regex prefixed("(^|[ /])[kMGmun](m|N|Pa|W|s|J)");
  return std::regex_replace(unit, prefixed, "$1$2");
}

} // namespace wheelrail
