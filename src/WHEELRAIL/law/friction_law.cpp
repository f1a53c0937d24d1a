// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_law.h"

#include "base/errors.h"
#include "base/output_file.h"
#include "shared/nearest_word.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
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

/// One law file being read: the parsed JSON with the text it came from, for line numbers.
class LawFile {
 public:
  explicit LawFile(std::string path) : fileName_(std::move(path)), text_(readInputFile(fileName_))
  {
    try {
      json_ = nlohmann::json::parse(text_);
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
  }

  double number(const char *key) const
  {
    const auto &value = at(key);
    if (!value.is_number())
      fail(key, "a number is expected, not " + value.dump());
    const double x = value.get<double>();
    if (!std::isfinite(x))
      fail(key, "a finite number is expected, not " + value.dump());
    return x;
  }

  double nonNegative(const char *key) const
  {
    const double x = number(key);
    if (x < 0.0)
      fail(key, fmt::format("{} is not allowed, must be >= 0", x));
    return x;
  }

  std::array<double, 2> range(const char *key) const
  {
    const auto values = numbers(at(key), key, 2);
    if (values[0] < 0.0 || values[1] < values[0])
      fail(key, fmt::format("[{}, {}] is not a range of numbers >= 0", values[0], values[1]));
    return {values[0], values[1]};
  }

  std::optional<LawCovariance> covariance() const
  {
    constexpr const char *key = "covariance";
    if (at(key).is_null())
      return std::nullopt;
    if (!at(key).is_array() || at(key).size() != lawParameters)
      fail(key, "null or a 5 x 5 matrix for mu0, mu1, mu2, b, c is expected");
    LawCovariance result;
    for (int i = 0; i < lawParameters; ++i) {
      const auto row = numbers(at(key)[i], key, lawParameters);
      for (int j = 0; j < lawParameters; ++j)
        result(i, j) = row[j];
    }
    // as written by us it is symmetric to the last bit; allow for edited files
    if ((result - result.transpose()).norm() > 1e-9 * result.norm())
      fail(key, "is not symmetric");
    if (result.diagonal().minCoeff() < 0.0)
      fail(key, "has a negative variance");
    return result;
  }

  std::string string(const char *key) const
  {
    if (!at(key).is_string())
      fail(key, "a text in quotes is expected, not " + at(key).dump());
    return at(key).get<std::string>();
  }

  int count(const char *key) const
  {
    if (!at(key).is_number_unsigned())
      fail(key, "a whole number >= 0 is expected");
    return at(key).get<int>();
  }

  [[noreturn]] void fail(const std::string &key, const std::string &problem) const
  {
    throw badInput(fileName_, lineOf(key), key, problem);
  }

 private:
  const nlohmann::json &at(const char *key) const
  {
    const auto found = json_.find(key);
    if (found == json_.end())
      throw badInput(fileName_, 0, key, "is missing");
    return *found;
  }

  std::vector<double> numbers(const nlohmann::json &value, const char *key, size_t size) const
  {
    if (!value.is_array() || value.size() != size)
      fail(key, fmt::format("a list of {} numbers is expected, not {}", size, value.dump()));
    std::vector<double> result;
    for (const auto &entry : value) {
      if (!entry.is_number())
        fail(key, "a number is expected, not " + entry.dump());
      result.push_back(entry.get<double>());
      if (!std::isfinite(result.back()))
        fail(key, "a finite number is expected");
    }
    return result;
  }

  void checkKeys() const
  {
    static const std::vector<std::string> known = {
        "format", "mu0",          "mu1",          "mu2",          "b",      "c",     "covariance",
        "n",      "rms_relative", "kappa1_range", "kappa2_range", "source", "report"};
    for (const auto &item : json_.items())
      if (std::find(known.begin(), known.end(), item.key()) == known.end())
        throw badInput(fileName_, lineOf(item.key()), "",
                       mcawr::unknownWord("key", item.key(), known));
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
  law.n = file.count("n");
  law.rmsRelative = file.nonNegative("rms_relative");
  law.kappa1Range = file.range("kappa1_range");
  law.kappa2Range = file.range("kappa2_range");
  law.source = file.string("source");
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
  json["kappa1_range"] = law.kappa1Range;
  json["kappa2_range"] = law.kappa2Range;
  json["source"] = law.source;
  return json;
}

} // namespace wheelrail
