// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_law.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "law/law_checksum.h"
#include "shared/nearest_word.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace wheelrail {

namespace {

constexpr const char *lawFormat = "mca-friction-law 1";
constexpr const char *builtinName = "bucher2006";
constexpr double hardnessOverStrength = 3.0; // upper end of the pressures in Eq. 7

/// Load-weighted mean of 1/(1 + c kappa2) over 0 .. X, X = c kappa2(hardness), halved:
/// 1/X - ln(1 + X)/X^2 = sum over n of (-X)^n/(n + 2).
double pressureAverage(double x)
{
  // below, the closed form loses digits (relative error about eps/x); the series has 15 terms
  constexpr double seriesLimit = 0.1;
  if (x >= seriesLimit)
    return (x - std::log1p(x)) / (x * x);
  double sum = 0.0;
  double power = 1.0;
  for (int n = 0; n < 20; ++n, power *= -x)
    sum += power / (n + 2);
  return sum;
}

/// Of all numbers in a law file: products of several of them do not overflow, and no fit of logs
/// within their own range (shared/friction_log_format.h) leaves it.
constexpr double largest = 1e100;

/// Whether rounding of edited numbers explains the difference of x and y, in units of `scale`.
bool isNearly(double x, double y, double scale)
{
  constexpr double rounding = 1e-9;
  return std::abs(x - y) <= rounding * scale;
}

/// What keeps a matrix from being a covariance; empty: nothing. Elements count in standard errors
/// of their row and column: parameters differ by orders of magnitude.
std::string problemOf(const LawCovariance &covariance)
{
  if (covariance.diagonal().minCoeff() < 0.0)
    return "has a negative variance";
  LawCovariance correlation = LawCovariance::Identity();
  for (int i = 0; i < lawParameters; ++i)
    for (int j = 0; j < i; ++j) {
      const double scale = std::sqrt(covariance(i, i)) * std::sqrt(covariance(j, j));
      if (!isNearly(covariance(i, j), covariance(j, i), scale))
        return "is not symmetric";
      if (scale == 0.0 && covariance(i, j) != 0.0)
        return "has a covariance with a parameter whose variance is 0";
      if (scale > 0.0)
        correlation(i, j) = correlation(j, i) = covariance(i, j) / scale;
    }
  const Eigen::SelfAdjointEigenSolver<LawCovariance> eigen(correlation, Eigen::EigenvaluesOnly);
  constexpr double rounding = 1e-6; // of numbers with seven digits
  if (!(eigen.eigenvalues()[0] >= -rounding))
    return fmt::format(
        "is not positive semi-definite (an eigenvalue of the correlations is {:.3g})",
        eigen.eigenvalues()[0]);
  return "";
}

/// One law file being read: the parsed JSON with the text it came from, for line numbers.
class LawFile {
 public:
  explicit LawFile(std::string path) : fileName_(std::move(path)), text_(readInputFile(fileName_))
  {
    try {
      parse();
    } catch (const nlohmann::json::parse_error &error) {
      const auto end = std::min<size_t>(error.byte, text_.size());
      const auto line = 1 + std::count(text_.begin(), text_.begin() + end, '\n');
      throw badInput(fileName_, static_cast<int>(line), "", "not JSON, or cut short");
    } catch (const nlohmann::json::out_of_range &) {
      throw badInput(fileName_, 0, "", "holds a number beyond the range of double precision");
    }
    if (!json_.is_object())
      throw badInput(fileName_, 1, "", "not a JSON object");
    // what wr_fit writes when the points do not give a law
    if (json_.contains("reason") && json_["reason"].is_string())
      throw badInput(fileName_, 0, "", "no law was fitted: " + json_["reason"].get<std::string>());
    checkKeys();
    checkChecksum();
  }

  /// A line for the user; empty where the checksum fits.
  std::string note() const
  {
    return json_.contains("checksum")
               ? ""
               : fmt::format("{}: no checksum: a damaged number would not be noticed", fileName_);
  }

  double number(const char *key) const
  {
    const auto &value = at(key);
    if (!value.is_number())
      fail(key, "a number is expected, not " + shown(value));
    return checked(key, value);
  }

  double positive(const char *key) const
  {
    const double x = number(key);
    if (!(x > 0.0))
      fail(key, fmt::format("{} is not allowed, must be > 0", x));
    return x;
  }

  double nonNegative(const char *key) const
  {
    const double x = number(key);
    if (x < 0.0)
      fail(key, fmt::format("{} is not allowed, must be >= 0", x));
    return x;
  }

  bool has(const char *key) const { return json_.contains(key); }

  Range range(const char *key) const { return rangeOf(at(key), key); }

  std::map<std::string, Range> fittedOn() const
  {
    constexpr const char *key = "fitted_on";
    if (!at(key).is_object())
      fail(key, "ranges {\"pressure\": [0.5, 26], ...} are expected, not " + shown(at(key)));
    std::map<std::string, Range> ranges;
    const std::vector<std::string> known(fittedQuantities.begin(), fittedQuantities.end());
    for (const auto &item : at(key).items()) {
      if (std::find(known.begin(), known.end(), item.key()) == known.end())
        fail(key, mcawr::unknownWord("key", item.key(), known));
      ranges[item.key()] = rangeOf(item.value(), key);
    }
    return ranges;
  }

  std::optional<LawCovariance> covariance() const
  {
    constexpr const char *key = "covariance";
    if (!has(key) || at(key).is_null())
      return std::nullopt;
    if (!at(key).is_array() || at(key).size() != lawParameters)
      fail(key, "null or a 5 x 5 matrix for mu0, mu1, mu2, b, c is expected");
    LawCovariance result;
    for (int i = 0; i < lawParameters; ++i) {
      const auto row = numbers(at(key)[i], key, lawParameters);
      for (int j = 0; j < lawParameters; ++j)
        result(i, j) = row[j];
    }
    const std::string problem = problemOf(result);
    if (!problem.empty())
      fail(key, problem);
    return result;
  }

  std::string string(const char *key) const
  {
    if (!at(key).is_string())
      fail(key, "a text in quotes is expected, not " + shown(at(key)));
    return at(key).get<std::string>();
  }

  int count(const char *key) const
  {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    if (!at(key).is_number_unsigned() || at(key).get<std::uint64_t>() > most)
      fail(key,
           fmt::format("a whole number from 0 to {} is expected, not {}", most, shown(at(key))));
    return at(key).get<int>();
  }

  [[noreturn]] void fail(const std::string &key, const std::string &problem) const
  {
    throw badInput(fileName_, lineOf(key), key, problem);
  }

 private:
  /// A key that appears twice would take its last value; text that is nested without end would end
  /// the program where the values are looked at.
  void parse()
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

  /// The beginning of a value, for messages.
  static std::string shown(const nlohmann::json &value)
  {
    constexpr std::size_t longest = 60;
    const std::string text = value.dump(-1, ' ', true);
    return text.size() > longest ? text.substr(0, longest) + " ..." : text;
  }

  double checked(const char *key, const nlohmann::json &value) const
  {
    const double x = value.get<double>();
    if (!(std::abs(x) <= largest))
      fail(key, fmt::format("{} is not allowed, must be within +-{:g}", shown(value), largest));
    return x;
  }

  const nlohmann::json &at(const char *key) const
  {
    const auto found = json_.find(key);
    if (found == json_.end())
      throw badInput(fileName_, 0, key, "is missing");
    return *found;
  }

  Range rangeOf(const nlohmann::json &value, const char *key) const
  {
    const auto ends = numbers(value, key, 2);
    if (ends[0] < 0.0 || ends[1] < ends[0])
      fail(key, fmt::format("[{}, {}] is not a range of numbers >= 0", ends[0], ends[1]));
    return {ends[0], ends[1]};
  }

  std::vector<double> numbers(const nlohmann::json &value, const char *key, size_t size) const
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

  void checkKeys() const
  {
    static const std::vector<std::string> known = {"format",
                                                   "checksum",
                                                   "mu0",
                                                   "mu1",
                                                   "mu2",
                                                   "b",
                                                   "c",
                                                   "covariance",
                                                   "n",
                                                   "rms_relative",
                                                   "kappa3",
                                                   "fitted_on",
                                                   "source",
                                                   "kappa1_range",
                                                   "kappa2_range",
                                                   "kappa3_range",
                                                   "report"};
    for (const auto &item : json_.items())
      if (std::find(known.begin(), known.end(), item.key()) == known.end())
        throw badInput(fileName_, lineOf(item.key()), "",
                       mcawr::unknownWord("key", item.key(), known));
  }

  void checkChecksum() const
  {
    if (json_.contains("checksum") && !fitsChecksum(text_))
      fail("checksum", fmt::format("{} does not fit: the file was changed since wr_fit wrote it; "
                                   "to use a law that was edited, remove this line",
                                   shown(json_["checksum"])));
  }

  int lineOf(const std::string &key) const
  {
    const auto place = text_.find('"' + key + '"');
    if (place == std::string::npos)
      return 0;
    return 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + place, '\n'));
  }

  std::string fileName_, text_;
  nlohmann::json json_;
};

} // namespace

double kappa1(double density, double modulus, double speed, double strength)
{
  return density * modulus * speed * speed / (strength * strength);
}

double kappa2(double pressure, double modulus, double strength)
{
  return pressure * modulus / (strength * strength);
}

double FrictionLaw::operator()(double kappa1, double kappa2) const
{
  return staticPart(kappa2) + mu1 * kappa1 / (1.0 + b * kappa1);
}

double FrictionLaw::staticPart(double kappa2) const
{
  return mu0 + mu2 / (1.0 + c * kappa2);
}

// Eq. 7 with p = 3 sigma_0 t, t = 0 .. 1: kappa2 c = X t, and 2 integral of t/(1 + X t) dt is
// 2 [1/X - ln(1 + X)/X^2]. mu0 and the term of kappa1 do not depend on p.
double FrictionLaw::averaged(double kappa1, double modulus, double strength) const
{
  const double x = hardnessOverStrength * c * modulus / strength;
  return mu0 + mu1 * kappa1 / (1.0 + b * kappa1) + 2.0 * mu2 * pressureAverage(x);
}

FrictionLaw bucher2006()
{
  FrictionLaw law;
  law.mu0 = 0.15;
  law.mu1 = 0.0442; // Eq. 3; Eq. 9 misprints it as 0.1442
  law.mu2 = 0.3243;
  law.b = 0.195;
  law.c = 0.00212;
  law.n = 34;
  law.rmsRelative = 0.09;
  law.kappa1Range = {0.0, 19.0};
  law.kappa2Range = {2.0, 633.0};
  law.kappa3Range = {206e3 / 552.0, 206e3 / 92.0};
  law.fittedOn = {{"pressure", {0.5, 26.0}},
                  {"velocity", {1.0, 10.0}},
                  {"strength", {92.0, 552.0}},
                  {"youngs_modulus", {206e3, 206e3}}};
  law.source = "Bucher et al., Wear 261 (2006) 874, Eq. 3";
  return law;
}

bool isBuiltinLaw(const std::string &name)
{
  return name == builtinName;
}

FrictionLaw readFrictionLaw(const std::string &path)
{
  if (isBuiltinLaw(path))
    return bucher2006();
  const LawFile file(path);
  const auto format = file.string("format");
  if (format != lawFormat)
    file.fail("format", fmt::format("'{}' cannot be read, must be '{}'", format, lawFormat));
  FrictionLaw law;
  law.mu0 = file.number("mu0");
  law.mu1 = file.number("mu1");
  law.mu2 = file.number("mu2");
  law.b = file.nonNegative("b");
  law.c = file.nonNegative("c");
  law.covariance = file.covariance();
  law.n = file.has("n") ? file.count("n") : 0;
  law.rmsRelative = file.has("rms_relative") ? file.nonNegative("rms_relative") : 0.0;
  for (const auto &[key, range] : {std::pair{"kappa1_range", &law.kappa1Range},
                                   {"kappa2_range", &law.kappa2Range},
                                   {"kappa3_range", &law.kappa3Range}})
    if (file.has(key))
      *range = file.range(key);
  if (file.has("kappa3"))
    law.kappa3 = file.positive("kappa3");
  if (file.has("fitted_on"))
    law.fittedOn = file.fittedOn();
  law.source = file.has("source") ? file.string("source") : path;
  law.note = file.note();
  return law;
}

nlohmann::ordered_json toJson(const FrictionLaw &law)
{
  nlohmann::ordered_json json;
  json["format"] = lawFormat;
  json["mu0"] = law.mu0;
  json["mu1"] = law.mu1;
  json["mu2"] = law.mu2;
  json["b"] = law.b;
  json["c"] = law.c;
  json["covariance"] = nullptr;
  if (law.covariance) {
    auto rows = nlohmann::ordered_json::array();
    for (int i = 0; i < lawParameters; ++i) {
      auto row = nlohmann::ordered_json::array();
      for (int j = 0; j < lawParameters; ++j)
        row.push_back((*law.covariance)(i, j));
      rows.push_back(row);
    }
    json["covariance"] = rows;
  }
  json["n"] = law.n;
  json["rms_relative"] = law.rmsRelative;
  for (const auto &[key, range] : {std::pair{"kappa1_range", &law.kappa1Range},
                                   {"kappa2_range", &law.kappa2Range},
                                   {"kappa3_range", &law.kappa3Range}})
    if (*range)
      json[key] = **range;
  if (law.kappa3)
    json["kappa3"] = *law.kappa3;
  for (const char *quantity : fittedQuantities)
    if (const auto found = law.fittedOn.find(quantity); found != law.fittedOn.end())
      json["fitted_on"][quantity] = found->second;
  json["source"] = law.source;
  return json;
}

} // namespace wheelrail
