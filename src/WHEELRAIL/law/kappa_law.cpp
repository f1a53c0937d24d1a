// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/kappa_law.h"

#include "law/law_file.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace wheelrail {

namespace {

constexpr const char *lawFormat = "mca-friction-law 1";
constexpr double hardnessOverStrength = 3.0; // upper end of the pressures in Eq. 7

const std::vector<std::string> lawKeys = {"format",
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
                                          "ductility",
                                          "fitted_on",
                                          "source",
                                          "kappa1_range",
                                          "kappa2_range",
                                          "kappa3_range",
                                          "report"};

/// Load-weighted mean of 1/(1 + c kappa2) over 0 .. X, X = c kappa2(hardness), halved:
/// 1/X - ln(1 + X)/X^2 = sum over n of (-X)^n/(n + 2).
/// \param x >= 0
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

} // namespace

double kappa1(double density, double modulus, double speed, double strength)
{
  return density * modulus * speed * speed / (strength * strength);
}

double kappa2(double pressure, double modulus, double strength)
{
  return pressure * modulus / (strength * strength);
}

double KappaLaw::operator()(double kappa1, double kappa2) const
{
  return staticPart(kappa2) + mu1 * kappa1 / (1.0 + b * kappa1);
}

double KappaLaw::staticPart(double kappa2) const
{
  return mu0 + mu2 / (1.0 + c * kappa2);
}

// Eq. 7 with p = 3 sigma_0 t, t = 0 .. 1: kappa2 c = X t, and 2 integral of t/(1 + X t) dt is
// 2 [1/X - ln(1 + X)/X^2]. mu0 and the term of kappa1 do not depend on p.
double KappaLaw::averaged(double kappa1, double modulus, double strength) const
{
  const double x = hardnessOverStrength * c * modulus / strength;
  return mu0 + mu1 * kappa1 / (1.0 + b * kappa1) + 2.0 * mu2 * pressureAverage(x);
}

KappaLaw bucher2006()
{
  KappaLaw law;
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

KappaLaw readKappaLaw(const std::string &path)
{
  const LawFile file(path, lawKeys);
  const auto format = file.string("format");
  if (format != lawFormat)
    file.fail("format", fmt::format("'{}' cannot be read, must be '{}'", format, lawFormat));
  KappaLaw law;
  law.mu0 = file.number("mu0");
  law.mu1 = file.number("mu1");
  law.mu2 = file.number("mu2");
  law.b = file.nonNegative("b");
  law.c = file.nonNegative("c");
  if (const auto covariance = file.covariance("covariance", {"mu0", "mu1", "mu2", "b", "c"}))
    law.covariance = *covariance;
  law.n = file.has("n") ? file.count("n") : 0;
  law.rmsRelative = file.has("rms_relative") ? file.nonNegative("rms_relative") : 0.0;
  for (const auto &[key, range] : {std::pair{"kappa1_range", &law.kappa1Range},
                                   {"kappa2_range", &law.kappa2Range},
                                   {"kappa3_range", &law.kappa3Range}})
    if (file.has(key))
      *range = file.range(key);
  if (file.has("kappa3"))
    law.kappa3 = file.positive("kappa3");
  if (file.has("ductility"))
    law.ductility = file.positive("ductility");
  if (file.has("fitted_on"))
    law.fittedOn = file.ranges("fitted_on", {fittedQuantities.begin(), fittedQuantities.end()});
  law.source = file.has("source") ? file.string("source") : path;
  law.note = file.note();
  return law;
}

nlohmann::ordered_json toJson(const KappaLaw &law)
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
  if (law.ductility)
    json["ductility"] = *law.ductility;
  for (const char *quantity : fittedQuantities)
    if (const auto found = law.fittedOn.find(quantity); found != law.fittedOn.end())
      json["fitted_on"][quantity] = found->second;
  json["source"] = law.source;
  return json;
}

} // namespace wheelrail
