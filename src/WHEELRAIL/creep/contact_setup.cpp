#include "creep/contact_setup.h"

#include "base/errors.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double weakest = 1e-3; ///< of the strength

/// One measured profile, from the file to the cells; every step leaves its statistics.
Vector measuredRoughness(const Case &input, const std::string &name, const std::string &path,
                         int cells, double cellSize, bool whole,
                         std::vector<ProfileStatistics> &statistics)
{
  Profile profile = readProfile(path);
  statistics.push_back(profileStatistics(name + ": as read", profile));
  profile = detrended(profile, input.detrend);
  statistics.push_back(profileStatistics(name + ": detrended", profile));
  if (input.cutoff > 0.0) {
    profile = lowPassed(profile, input.cutoff);
    statistics.push_back(profileStatistics(name + ": filtered", profile, input.cutoff));
  }
  const double usable = profile.length() - profile.spacing;
  const int wanted = whole ? std::max(cells, static_cast<int>(usable / cellSize)) : cells;
  profile = resampled(profile, wanted, cellSize);
  statistics.push_back(profileStatistics(name + ": resampled", profile, input.cutoff));
  return profile.height;
}

void prepareSurface(const Case &input, std::size_t index, ContactSetup &setup)
{
  const int cells = setup.cells;
  if (input.roughness == RoughnessKind::Fractal) {
    FractalSurface surface = input.surface;
    setup.profile = surface.seed = input.seeds[index];
    const Profile profile = fractalProfile(surface, cells, cells * setup.cellSize);
    setup.statistics.push_back(
        profileStatistics("generated", profile, surface.wavelengthMin, surface.wavelengthMax));
    setup.roughness = profile.height;
  }
  if (input.roughness == RoughnessKind::Measured) {
    const bool whole = input.mode == RollingMode::Moving;
    setup.periodic = false;
    setup.profile = index + 1;
    for (const auto &[name, files] : {std::pair{"rail", &input.rail}, {"wheel", &input.wheel}}) {
      if (files->empty())
        continue;
      const Vector height = measuredRoughness(input, name, files->at(index), cells, setup.cellSize,
                                              whole, setup.statistics);
      if (setup.roughness.size() == 0) {
        setup.roughness = height;
      } else {
        const auto common = std::min(setup.roughness.size(), height.size());
        setup.roughness = (setup.roughness.head(common) + height.head(common)).eval();
      }
    }
    const Profile sum{setup.cellSize, setup.roughness};
    setup.statistics.push_back(profileStatistics("sum of both", sum, input.cutoff));
  }
}

} // namespace

Vector ContactSetup::gap(int travel) const
{
  Vector gap(cells);
  for (int i = 0; i < cells; ++i) {
    const double x = position(i);
    gap[i] = x * x / (2.0 * hertz.radius);
    if (roughness.size() > 0)
      gap[i] -= roughness[(i + travel) % roughness.size()];
  }
  return gap / cellSize;
}

int ContactSetup::longestTravel() const
{
  if (periodic)
    return std::numeric_limits<int>::max();
  return static_cast<int>(roughness.size()) - cells;
}

NormalContactProblem ContactSetup::problem(double limit, int travel) const
{
  NormalContactProblem problem;
  problem.profile = gap(travel);
  problem.load = hertz.load / (hertz.modulus * cellSize);
  problem.pressureLimit = limit / hertz.modulus;
  return problem;
}

double ContactSetup::nominalMean(const Vector &values) const
{
  double sum = 0.0;
  int inside = 0;
  for (int i = 0; i < cells; ++i) {
    if (!isNominal(i))
      continue;
    sum += values[i];
    ++inside;
  }
  return sum / inside;
}

double ContactSetup::realContactLength() const
{
  return contactLength(contactIntervals(normal, boundary)) * cellSize;
}

double strengthAt(const Case &input, double temperatureRise)
{
  return input.strength * std::max(weakest, 1.0 - temperatureRise / input.strengthTemperature);
}

double pressureLimit(const Case &input, double temperatureRise)
{
  constexpr double hardnessOverStrength = 3.0; // the paper, sec. 3
  if (!input.hardnessLimit)
    return std::numeric_limits<double>::infinity();
  return hardnessOverStrength * strengthAt(input, temperatureRise);
}

bool hasFeedback(const Case &input)
{
  return input.thermal != ThermalModel::Off && (input.law != "constant" || input.hardnessLimit);
}

void checkStrength(const Case &input, double hottest, double speed, double creep)
{
  if (hasFeedback(input) && hottest >= input.strengthTemperature)
    throw Error(
        ExitCode::NotConverged,
        fmt::format("creep {} at {} m/s: the temperature rise of {:.0f} K leaves no strength "
                    "(friction.strength_temperature is {} K)",
                    creep, speed, hottest, input.strengthTemperature));
}

void checkInsideDomain(const Vector &pressure)
{
  if (pressure[0] > 0.0 || pressure[pressure.size() - 1] > 0.0)
    throw Error(ExitCode::BadInput,
                "contact.domain: the contact reaches the ends of the computed length; increase it");
}

ContactSetup prepareContact(const Case &input, std::size_t index)
{
  ContactSetup setup;
  const double modulus = contactModulus(input.youngsModulus, input.poissonsRatio);
  setup.cells = input.points;
  if (input.period > 0.0) {
    setup.boundary = Boundary::Periodic;
    setup.hertz = {input.load, input.radius, modulus, 0.5 * input.period,
                   input.load / input.period};
    setup.cellSize = input.period / input.points;
  } else {
    setup.hertz = hertzContact(input.load, input.radius, modulus);
    setup.cellSize = input.domain * setup.hertz.halfWidth / input.points;
  }
  prepareSurface(input, index, setup);
  HalfPlane halfPlane(setup.cells, setup.boundary);
  setup.normal = solveNormalContact(halfPlane, setup.problem(pressureLimit(input, 0.0)));
  if (setup.boundary == Boundary::Free)
    checkInsideDomain(setup.normal.pressure);
  return setup;
}

} // namespace wheelrail
