#include "base/quantity.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <mutex>
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

std::string trimmed(const std::string &text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The number that `text` starts with; `rest` is what follows it.
double leadingNumber(const std::string &text, std::string &rest)
{
  const std::string body = trimmed(text);
  char *end = nullptr;
  const double value = std::strtod(body.c_str(), &end);
  if (end == body.c_str())
    throw std::invalid_argument(fmt::format("'{}' is not a number", text));
  if (!std::isfinite(value))
    throw std::invalid_argument(fmt::format("'{}' is not finite", text));
  rest = trimmed(std::string(end));
  return value;
}

} // namespace

double parseNumber(const std::string &text)
{
  std::string rest;
  const double value = leadingNumber(text, rest);
  if (!rest.empty())
    throw std::invalid_argument(fmt::format("'{}' is not a plain number", text));
  return value;
}

double parseQuantity(const std::string &text, const std::string &unit)
{
  if (unit.empty() || unit == "1")
    return parseNumber(text);
  std::string rest;
  const double value = leadingNumber(text, rest);
  if (rest.empty())
    throw std::invalid_argument(fmt::format("'{}' has no unit; one like {} is needed", text, unit));

  const std::lock_guard<std::mutex> lock(udunitsMutex);
  const Unit given(ut_parse(unitSystem(), rest.c_str(), UT_UTF8));
  const Unit wanted(ut_parse(unitSystem(), unit.c_str(), UT_UTF8));
  if (!wanted)
    throw std::logic_error(fmt::format("UDUNITS-2 does not know '{}'", unit));
  if (!given)
    throw std::invalid_argument(fmt::format("'{}': '{}' is not a unit", text, rest));
  if (!ut_are_convertible(given.get(), wanted.get()))
    throw std::invalid_argument(
        fmt::format("'{}': '{}' is of another dimension than {}", text, rest, unit));
  const std::unique_ptr<cv_converter, ConverterDeleter> converter(
      ut_get_converter(given.get(), wanted.get()));
  if (cv_convert_double(converter.get(), 0.0) != 0.0)
    throw std::invalid_argument(
        fmt::format("'{}': a difference in {} is needed, not a scale with an offset", text, unit));
  const double converted = cv_convert_double(converter.get(), value);
  if (!std::isfinite(converted))
    throw std::invalid_argument(fmt::format("'{}' is not finite in {}", text, unit));
  return converted;
}

} // namespace wheelrail
