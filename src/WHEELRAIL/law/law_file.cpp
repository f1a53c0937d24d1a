// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/law_file.h"

#include "base/errors.h"
#include "base/text_lines.h"
#include "law/covariance.h"
#include "law/law_checksum.h"
#include "shared/nearest_word.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <set>

namespace wheelrail {

namespace {

/// Largest number in a law file: products of several of them do not overflow, and no fit of logs
/// within their own range (shared/friction_log_format.h) leaves it.
constexpr double largestNumber = 1e100;

/// Whether rounding of edited numbers explains the difference of x and y, in units of `scale`.
bool isNearly(double x, double y, double scale)
{
  constexpr double rounding = 1e-9;
  return std::abs(x - y) <= rounding * scale;
}

/// What keeps a matrix from being a covariance; empty: nothing. Elements count in standard errors
/// of their row and column: parameters differ by orders of magnitude.
std::string problemOf(const Eigen::MatrixXd &covariance)
{
  if (covariance.diagonal().minCoeff() < 0.0)
    return "has a negative variance";
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const double scale = std::sqrt(covariance(i, i)) * std::sqrt(covariance(j, j));
      if (!isNearly(covariance(i, j), covariance(j, i), scale))
        return "is not symmetric";
      if (scale == 0.0 && covariance(i, j) != 0.0)
        return "has a covariance with a parameter whose variance is 0";
      if (scale > 0.0)
        correlation(i, j) = correlation(j, i) = covariance(i, j) / scale;
    }
  const double least = leastEigenvalue(correlation);
  constexpr double rounding = 1e-6; // of numbers with seven digits
  if (!(least >= -rounding))
    return fmt::format(
        "is not positive semi-definite (an eigenvalue of the correlations is {:.3g})", least);
  return "";
}

/// The beginning of a value, for messages.
std::string shown(const nlohmann::json &value)
{
  constexpr std::size_t longest = 60;
  const std::string text = value.dump(-1, ' ', true);
  return text.size() > longest ? text.substr(0, longest) + " ..." : text;
}

} // namespace

LawFile::LawFile(std::string path, const std::vector<std::string> &keys)
    : fileName_(std::move(path)), text_(readTextFile(fileName_))
{
  try {
    parse();
  } catch (const nlohmann::json::parse_error &error) {
    const auto end = std::min<std::size_t>(error.byte, text_.size());
    const auto line = 1 + std::count(text_.begin(), text_.begin() + end, '\n');
    throw badInput(fileName_, static_cast<int>(line), "", "not JSON, or cut short");
  } catch (const nlohmann::json::out_of_range &) {
    throw badInput(fileName_, 0, "", "holds a number beyond the range of double precision");
  }
  if (!json_.is_object())
    throw badInput(fileName_, 1, "", "not a JSON object");
  // what wr_fit writes when the runs do not give a law
  if (json_.contains("reason") && json_["reason"].is_string())
    throw badInput(fileName_, 0, "", "no law was fitted: " + json_["reason"].get<std::string>());
  checkKeys(keys);
  checkChecksum();
}

void LawFile::parse()
{
  using Event = nlohmann::json::parse_event_t;
  constexpr int deepest = 32;
  std::vector<std::set<std::string>> keys; // of the objects that are open
  json_ = nlohmann::json::parse(text_, [&](int depth, Event event, const nlohmann::json &value) {
    if (depth > deepest)
      throw badInput(fileName_, 0, "", fmt::format("is nested deeper than {} levels", deepest));
    if (event == Event::object_start)
      keys.emplace_back();
    if (event == Event::object_end)
      keys.pop_back();
    if (event == Event::key && !keys.back().insert(value.get<std::string>()).second)
      fail(value.get<std::string>(), "appears twice");
    return true;
  });
}

void LawFile::checkKeys(const std::vector<std::string> &keys) const
{
  for (const auto &item : json_.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      throw badInput(fileName_, lineOf(item.key()), "",
                     mcawr::unknownWord("key", item.key(), keys));
}

void LawFile::checkChecksum() const
{
  if (json_.contains("checksum") && !fitsChecksum(text_))
    fail("checksum", fmt::format("{} does not fit: the file was changed since wr_fit wrote it; "
                                 "to use a law that was edited, remove this line",
                                 shown(json_["checksum"])));
}

std::string LawFile::note() const
{
  return json_.contains("checksum")
             ? ""
             : fmt::format("{}: no checksum: a damaged number would not be noticed", fileName_);
}

double LawFile::number(const std::string &key) const
{
  const auto &value = at(key);
  if (!value.is_number())
    fail(key, "a number is expected, not " + shown(value));
  return checked(key, value);
}

double LawFile::positive(const std::string &key) const
{
  const double x = number(key);
  if (!(x > 0.0))
    fail(key, fmt::format("{} is not allowed, must be > 0", x));
  return x;
}

double LawFile::nonNegative(const std::string &key) const
{
  const double x = number(key);
  if (x < 0.0)
    fail(key, fmt::format("{} is not allowed, must be >= 0", x));
  return x;
}

int LawFile::count(const std::string &key) const
{
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
  if (!at(key).is_number_unsigned() || at(key).get<std::uint64_t>() > most)
    fail(key, fmt::format("a whole number from 0 to {} is expected, not {}", most, shown(at(key))));
  return at(key).get<int>();
}

std::string LawFile::string(const std::string &key) const
{
  if (!at(key).is_string())
    fail(key, "a text in quotes is expected, not " + shown(at(key)));
  return at(key).get<std::string>();
}

std::vector<double> LawFile::numbers(const std::string &key) const
{
  return numbers(at(key), key, at(key).is_array() ? at(key).size() : 1);
}

std::vector<std::vector<double>> LawFile::lists(const std::string &key) const
{
  if (!at(key).is_array())
    fail(key, "a list of lists of numbers is expected, not " + shown(at(key)));
  std::vector<std::vector<double>> lists;
  for (const auto &list : at(key))
    lists.push_back(numbers(list, key, list.is_array() ? list.size() : 1));
  return lists;
}

Range LawFile::range(const std::string &key) const
{
  return rangeOf(at(key), key);
}

std::map<std::string, Range> LawFile::ranges(const std::string &key,
                                             const std::vector<std::string> &names) const
{
  if (!at(key).is_object())
    fail(key, "ranges {\"pressure\": [0.5, 26], ...} are expected, not " + shown(at(key)));
  std::map<std::string, Range> ranges;
  for (const auto &item : at(key).items()) {
    if (std::find(names.begin(), names.end(), item.key()) == names.end())
      fail(key, mcawr::unknownWord("key", item.key(), names));
    ranges[item.key()] = rangeOf(item.value(), key);
  }
  return ranges;
}

std::optional<Eigen::MatrixXd> LawFile::covariance(const std::string &key,
                                                   const std::vector<std::string> &parameters) const
{
  if (!has(key) || at(key).is_null())
    return std::nullopt;
  const std::size_t n = parameters.size();
  if (!at(key).is_array() || at(key).size() != n)
    fail(key, fmt::format("null or a {} x {} matrix for {} is expected", n, n,
                          fmt::join(parameters, ", ")));
  Eigen::MatrixXd result(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = numbers(at(key)[i], key, n);
    for (std::size_t j = 0; j < n; ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = row[j];
  }
  const std::string problem = problemOf(result);
  if (!problem.empty())
    fail(key, problem);
  return result;
}

void LawFile::fail(const std::string &key, const std::string &problem) const
{
  throw badInput(fileName_, lineOf(key), key, problem);
}

double LawFile::checked(const std::string &key, const nlohmann::json &value) const
{
  const double x = value.get<double>();
  if (!(std::abs(x) <= largestNumber))
    fail(key, fmt::format("{} is not allowed, must be within +-{:g}", shown(value), largestNumber));
  return x;
}

const nlohmann::json &LawFile::at(const std::string &key) const
{
  const auto found = json_.find(key);
  if (found == json_.end())
    throw badInput(fileName_, 0, key, "is missing");
  return *found;
}

Range LawFile::rangeOf(const nlohmann::json &value, const std::string &key) const
{
  const auto ends = numbers(value, key, 2);
  if (ends[0] < 0.0 || ends[1] < ends[0])
    fail(key, fmt::format("[{}, {}] is not a range of numbers >= 0", ends[0], ends[1]));
  return {ends[0], ends[1]};
}

std::vector<double> LawFile::numbers(const nlohmann::json &value, const std::string &key,
                                     std::size_t size) const
{
  if (!value.is_array() || value.size() != size)
    fail(key, fmt::format("a list of {} numbers is expected, not {}", size, shown(value)));
  std::vector<double> result;
  for (const auto &entry : value) {
    if (!entry.is_number())
      fail(key, "a number is expected, not " + shown(entry));
    result.push_back(checked(key, entry));
  }
  return result;
}

int LawFile::lineOf(const std::string &key) const
{
  const auto place = text_.find('"' + key + '"');
  if (place == std::string::npos)
    return 0;
  return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + place, '\n'));
}

} // namespace wheelrail
