// SPDX-License-Identifier: GPL-2.0-or-later
#include "reference_laws.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace reference {

double meanWeight(const mca::LawSet &laws, const mca::Material &m)
{
  return laws.elasticity.word() == "many-body" ? 1 - 2 * shearModulus(m) / (3 * bulkModulus(m)) : 0;
}

double shearModulus(const mca::Material &m)
{
  return m.youngsModulus / 2 / (1 + m.poissonsRatio);
}

double bulkModulus(const mca::Material &m)
{
  return m.youngsModulus / 3 / (1 - 2 * m.poissonsRatio);
}

double yieldStress(const mca::Material &m, double kappa)
{
  const double s1 = m.elasticLimit * m.strength, s2 = m.yieldStrength * m.strength;
  const double k2 = m.yieldStrain - s2 / m.youngsModulus;
  const double k3 = m.breakingStrain - m.strength / m.youngsModulus;
  if (kappa < k2)
    return s1 + (s2 - s1) * kappa / k2;
  if (kappa < k3)
    return s2 + (m.strength - s2) * (kappa - k2) / (k3 - k2);
  return m.strength;
}

// its integral by trapezoids between the kinks
double plasticWork(const mca::Material &m, double kappa)
{
  const double k2 = m.yieldStrain - m.yieldStrength * m.strength / m.youngsModulus;
  const double k3 = m.breakingStrain - m.strength / m.youngsModulus;
  double sum = 0, from = 0;
  for (const double to : {std::fmin(kappa, k2), std::fmin(kappa, k3), kappa}) {
    if (to > from) {
      sum += (yieldStress(m, from) + yieldStress(m, to)) / 2 * (to - from);
      from = to;
    }
  }
  return sum;
}

static double workToStrength(const mca::Material &m)
{
  return plasticWork(m, m.breakingStrain - m.strength / m.youngsModulus);
}

// a limit from its word
template<class Law>
static double times(const Law &law, double unit, double named)
{
  const std::string word = law.word();
  if (word == "none")
    return std::numeric_limits<double>::infinity();
  return std::isdigit(word[0]) ? std::stod(word) * unit : named;
}

static double strengthOf(const LinkView &l)
{
  return std::fmin(l.a.strength, l.b.strength);
}

// max(sigma, 0)^2 + 3 tau^2, its root
static double intensityOf(double sigma, double tau)
{
  const double tension = std::fmax(sigma, 0);
  return std::sqrt(tension * tension + 3 * tau * tau);
}

// [(a+1)/2 sigma_eq + 3(a-1)/2 sigma_mean]/a of the local stress: what it is worth as a tension
static double tensionOf(const LinkView &l, double ratio)
{
  const double mean = l.stress.trace() / 3;
  const Eigen::Matrix3d deviator = l.stress - mean * Eigen::Matrix3d::Identity();
  const double equivalent = std::sqrt(1.5) * deviator.norm();
  return ((ratio + 1) / 2 * equivalent + 3 * (ratio - 1) / 2 * mean) / ratio;
}

// largest and least principal stress in the form of Coulomb's law
static double coulombOf(const LinkView &l, double ratio)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(l.stress, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2] - solver.eigenvalues()[0] / ratio;
}

std::map<std::string, std::function<bool(const LinkView &)>> &criteria()
{
  static std::map<std::string, std::function<bool(const LinkView &)>> all = {
      {"none", [](const LinkView &) { return false; }},
      {"strain",
       [](const LinkView &l) {
         const double opening = std::fmax(l.eps, 0);
         const double limit = std::fmin(l.a.breakingStrain, l.b.breakingStrain);
         return opening * opening + 4.0 / 3 * l.gammaTotal * l.gammaTotal >= limit * limit;
       }},
      {"stress", [](const LinkView &l) { return intensityOf(l.sigma, l.tau) >= strengthOf(l); }},
      {"equivalent", [](const LinkView &l) { return tensionOf(l, 1) >= strengthOf(l); }},
      {"drucker-prager",
       [](const LinkView &l) {
         return tensionOf(l, l.laws.fracture.parameter("compressive_strength")) >= strengthOf(l);
       }},
      {"mohr-coulomb", [](const LinkView &l) {
         return coulombOf(l, l.laws.fracture.parameter("compressive_strength")) >= strengthOf(l);
       }}};
  return all;
}

bool bulkBreaks(const LinkView &l)
{
  const std::string word = l.laws.fracture.word();
  const auto criterion = criteria().find(word);
  if (criterion == criteria().end())
    throw std::logic_error("fracture " + word + " is missing in criteria() of " __FILE__);
  return l.eps <= -0.9 || criterion->second(l);
}

bool healedBreaks(const LinkView &l)
{
  const double opening = std::fmax(l.eps, 0);
  const double limit = times(l.laws.healedStrain, 1, std::fmin(l.a.yieldStrain, l.b.yieldStrain));
  return std::sqrt(opening * opening + 4.0 / 3 * l.gammaTotal * l.gammaTotal) >= limit;
}

double nextKind(const mca::LawSet &laws, const mca::Material &ma, const mca::Material &mb,
                double kind, double sigma, double tau, bool bulkBreaks, bool healedBreaks,
                double work, double room)
{
  const double strength = std::fmin(ma.strength, mb.strength);
  const double hardness =
      3 * std::fmin(ma.yieldStrength * ma.strength, mb.yieldStrength * mb.strength);
  const bool welding = laws.weld.word() != "none";
  const double healed = laws.healedStrain.isOff() ? 1 : 3;
  const bool heals =
      -sigma - room >= times(laws.heal, strength, hardness) && !bulkBreaks && !healedBreaks;
  if (kind == 1)
    return bulkBreaks ? -1 : 1;
  if (kind == 3)
    return bulkBreaks || healedBreaks ? -1 : 3;
  const double limitOfElasticity =
      std::fmin(ma.elasticLimit * ma.strength, mb.elasticLimit * mb.strength);
  if (kind == 2) {
    if (intensityOf(sigma, tau) >= times(laws.weld, strength, limitOfElasticity))
      return -1;
    return heals ? healed : 2;
  }
  const double enough = times(laws.linkWork, std::fmin(workToStrength(ma), workToStrength(mb)), 0);
  if (-sigma - room < times(laws.link, strength, limitOfElasticity) && work < enough)
    return 0;
  if (kind == -1)
    return heals ? healed : -1;
  return welding ? 2 : 1;
}

bool keepsVolume(const mca::LawSet &laws)
{
  return laws.plasticity.word() == "isochoric";
}

double flowWeight(const mca::LawSet &laws, const mca::Material &a, const mca::Material &b,
                  double kind, double e)
{
  if (kind == 1 || kind == 3)
    return 1;
  if (kind == 2 || laws.flow.word() != "contacts" || !pressed(e))
    return 0;
  const double limit = std::fmax(a.elasticLimit * a.strength, b.elasticLimit * b.strength);
  return keepsVolume(laws) ? std::fmin(1, -e * (shearModulus(a) + shearModulus(b)) / limit) : 1;
}

// D K/G, by which what neighbours flow counts
static double manyBody(const mca::LawSet &laws, const mca::Material &m)
{
  return meanWeight(laws, m) * bulkModulus(m) / shearModulus(m);
}

double mostReturned(const mca::LawSet &laws, const mca::Material &m, int dimension)
{
  if (!keepsVolume(laws))
    return 1;
  return std::fmin(1, 1.6 / (1 + 1.5 * dimension * manyBody(laws, m) / 8));
}

double strainOfWork(double squares, double intensity, double modulus)
{
  const double mostOfWork = 1.5 * intensity / 3 / modulus;
  return std::clamp(squares / 2 / modulus / intensity, 0.0, mostOfWork);
}

double stretched(const LinkView &l, double sigma, double longer, double released)
{
  if (sigma == 0)
    return 0;
  const double many = std::fmax(manyBody(l.laws, l.a), manyBody(l.laws, l.b));
  const double most = 0.4 / (1 + 1.5 * l.dimension * many / 2) * std::fabs(sigma);
  const double twoG = shearModulus(l.a) + shearModulus(l.b), less = twoG * longer;
  const bool nearer = less * sigma > 0; // to 0; else the shear pays for it
  const double limit = nearer ? most : std::fmin(most, twoG * released / 2 / std::fabs(sigma));
  return sigma - std::copysign(std::fmin(std::fabs(less), limit), less);
}

double flownUnlinked(const LinkView &l, double sigma, double trial, double plastic)
{
  const double longer = std::fmax(l.a.breakingStrain, l.b.breakingStrain) - plastic;
  const double twoG = shearModulus(l.a) + shearModulus(l.b), shorter = 0.9 + plastic;
  const double highest = keepsVolume(l.laws) ? std::fmax(trial, 0) : 0;
  sigma = std::fmax(std::fmin(sigma, highest), trial - twoG * std::fmax(longer, 0));
  return std::fmin(sigma, trial + twoG * std::fmax(shorter, 0));
}

double normalStrain(const mca::LawSet &laws, double ratio)
{
  return keepsVolume(laws) ? std::log(ratio) : ratio - 1;
}

double actingArea(const mca::LawSet &laws, double area, double ratio)
{
  return keepsVolume(laws) ? area / ratio : area;
}

double roomTaken(double ratio)
{
  const double a = std::fmax(0, 1 - (ratio - 1) / 0.4);
  return a < 1.5 ? 1.5 * std::pow(a, 3) - 0.5 * std::pow(a, 4)
                 : 2.53125 + 3.375 * (a - 1.5); // straight on, nearer than 0.8 d
}

double roomPressure(const mca::LawSet &laws, const mca::Material &m, double taken, int dimension,
                    int coordination)
{
  const double closeness = 0.16 * dimension * (taken / coordination - 1);
  return keepsVolume(laws) ? bulkModulus(m) * std::fmax(0, closeness - 0.01) : 0;
}

double roomStress(double ratio, double pressureA, double pressureB)
{
  const double a = std::fmin(1.5, std::fmax(0, 1 - (ratio - 1) / 0.4));
  return -(pressureA + pressureB) / 2 * (4.5 * a * a - 2 * a * a * a) / 2.5 * ratio;
}

bool pressed(double e)
{
  return e < -1e-9;
}

double unlinkedStress(const mca::LawSet &laws, double elastic, double viscous)
{
  return std::fmin(keepsVolume(laws) ? std::fmax(elastic, 0) : 0, elastic + viscous);
}

double keptNext(const mca::LawSet &laws, double kept, double sum)
{
  return keepsVolume(laws) ? kept - std::fmin(kept, std::fmax(sum, 0) / 2) : kept;
}

double wornKind(const mca::LawSet &laws, double kind, double next, bool far)
{
  if (kind != -1 || laws.worn.word() == "unloaded")
    return next;
  return far ? 0 : -1;
}

} // namespace reference
