// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/measured_fit.h"

#include "base/errors.h"
#include "base/least_squares.h"
#include "base/result_text.h"
#include "base/si.h"
#include "base/statistics.h"
#include "creep/patch/patch_report.h"
#include "law/forms/constant.h"
#include "law/forms/polach.h"

#include <algorithm>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double leastMu0 = 1e-3, largestMu0 = 2.0;

double rmsOf(const std::vector<MeasuredTraction> &curve, const std::vector<double> &ratio,
             int parameters)
{
  double squares = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k)
    squares += std::pow(ratio[k] - curve[k].tractionRatio, 2);
  return std::sqrt(squares / (double(curve.size()) - parameters));
}

/// A model of a curve by its parameters, for least squares.
class CurveModel {
 public:
  struct Parameter {
    const char *name, *unit;
    double low, high;
    double start;
  };

  CurveModel(const std::vector<MeasuredTraction> &curve, std::vector<Parameter> parameters,
             std::function<std::vector<double>(const Vector &)> ratios)
      : curve_(curve), parameters_(std::move(parameters)), ratios_(std::move(ratios))
  {
  }

  LeastSquaresProblem problem() const
  {
    LeastSquaresProblem problem;
    const auto n = static_cast<int>(parameters_.size());
    problem.parameters = n;
    problem.residuals = static_cast<int>(curve_.size());
    problem.lower = problem.upper = Vector(n);
    for (int k = 0; k < n; ++k) {
      problem.lower[k] = parameters_[k].low;
      problem.upper[k] = parameters_[k].high;
    }
    problem.evaluate = [this](const Vector &x, Vector &r, Eigen::MatrixXd *jacobian) {
      return evaluate(x, r, jacobian);
    };
    return problem;
  }

  /// Intervals are those of the profile of the sum of squares.
  /// \param starts beside the one that each parameter has
  MeasuredModel fit(const char *what, std::vector<Vector> starts = {}) const
  {
    const auto n = static_cast<int>(parameters_.size());
    const int freedom = static_cast<int>(curve_.size()) - n;
    if (freedom < 1)
      throw Error(ExitCode::NotConverged,
                  fmt::format("--fit-measured: {} values; {} with its {} parameters needs at least "
                              "{}",
                              curve_.size(), what, n, n + 1));
    const LeastSquaresProblem problem = this->problem();
    Vector start(n);
    for (int k = 0; k < n; ++k)
      start[k] = parameters_[k].start;
    starts.push_back(start);
    const LeastSquaresSolution solution = solveLeastSquares(problem, starts);
    if (!solution.converged)
      throw Error(ExitCode::NotConverged,
                  fmt::format("--fit-measured: {}: {}", what, solution.message));
    MeasuredModel model;
    model.tractionRatio = ratios_(solution.x);
    model.rms = rmsOf(curve_, model.tractionRatio, n);
    std::vector<bool> fixed;
    for (int k = 0; k < n; ++k)
      fixed.push_back(atBound(solution.x[k], k));
    const Identifiability analysis = analyseJacobian(solution.jacobian, fixed);
    const double t = studentQuantile(0.975, freedom);
    for (int k = 0; k < n; ++k) {
      const Parameter &p = parameters_[k];
      const double error = model.rms * std::sqrt(analysis.covariance(k, k)), x = solution.x[k];
      MeasuredParameter one{p.name, p.unit, x, x - t * error, x + t * error, false, false};
      if (fixed[k] || !(error > 0.0) || analysis.conditionNumber > worstCondition) {
        one.low = p.low;
        one.high = p.high;
        one.lowOpen = one.highOpen = true; // the curve does not say
      } else {
        const Interval interval =
            profileInterval(problem, solution, k, error, std::pow(t * model.rms, 2));
        one.low = interval.lower;
        one.high = interval.upper;
        one.lowOpen = interval.lowerOpen;
        one.highOpen = interval.upperOpen;
      }
      if (one.low < p.low) {
        one.low = p.low;
        one.lowOpen = true;
      }
      if (one.high > p.high) {
        one.high = p.high;
        one.highOpen = true;
      }
      model.parameters.push_back(one);
    }
    return model;
  }

 private:
  bool atBound(double x, int k) const
  {
    const Parameter &p = parameters_[k];
    const double near = 1e-6 * std::max(std::abs(x), 1e-6 * (p.high - p.low));
    return x - p.low <= near || p.high - x <= near;
  }

  bool residuals(const Vector &x, Vector &r) const
  {
    try {
      const std::vector<double> ratio = ratios_(x);
      for (std::size_t k = 0; k < curve_.size(); ++k)
        r[static_cast<Eigen::Index>(k)] = ratio[k] - curve_[k].tractionRatio;
    } catch (const Error &error) {
      if (error.code() != ExitCode::NotConverged)
        throw;
      return false;
    }
    return r.allFinite();
  }

  /// Central differences that are wide beside the solver's tolerance.
  bool evaluate(const Vector &x, Vector &r, Eigen::MatrixXd *jacobian) const
  {
    if (!residuals(x, r))
      return false;
    if (!jacobian)
      return true;
    for (int k = 0; k < x.size(); ++k) {
      const Parameter &p = parameters_[k];
      const double step = 1e-3 * std::max(std::abs(x[k]), 1e-2 * std::abs(p.start));
      Vector low = x, high = x, a(r.size()), b(r.size());
      low[k] = std::max(p.low, x[k] - step);
      high[k] = std::min(p.high, x[k] + step);
      if (!(high[k] > low[k]) || !residuals(low, a) || !residuals(high, b))
        return false;
      jacobian->col(k) = (b - a) / (high[k] - low[k]);
    }
    return true;
  }

  const std::vector<MeasuredTraction> &curve_;
  std::vector<Parameter> parameters_;
  std::function<std::vector<double>(const Vector &)> ratios_;
};

void requireToGoOn(const std::function<bool()> &goOn)
{
  if (!goOn())
    throw Error(ExitCode::Interrupted, "interrupted in the fit of the measured curve; run the "
                                       "same command again");
}

/// T/N of a contact at all values of a curve. \throws Error (NotConverged)
std::vector<double> solved(const std::vector<MeasuredTraction> &curve, const CreepPhysics &physics,
                           const PatchContact &contact, double spinPoint, const FrictionLaw &law,
                           const std::function<bool()> &goOn)
{
  std::vector<std::size_t> order(curve.size()); // neighbours start warm from each other
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    return std::pair(curve[i].speed, curve[i].creep) < std::pair(curve[k].speed, curve[k].creep);
  });
  FrozenPatch rolling(physics, contact, spinPoint);
  std::vector<double> ratios(curve.size());
  for (const std::size_t k : order) {
    requireToGoOn(goOn);
    PatchDrive drive;
    drive.creepage.xi = curve[k].creep;
    ratios[k] = rolling.solve(law, curve[k].speed, drive).tractionRatio();
  }
  return ratios;
}

/// The fit of Polach's form begins where that of points does, and goes on to the intervals.
MeasuredModel polachModel(const std::vector<MeasuredTraction> &curve, const PolachContact &contact,
                          const PolachFit &first)
{
  const PolachParameters &p = first.parameters;
  double fastest = 0.0;
  for (const MeasuredTraction &value : curve)
    fastest = std::max(fastest, value.creep * value.speed);
  std::vector<CurveModel::Parameter> parameters = {{"mu0", "1", leastMu0, largestMu0, p.mu0}};
  const bool falling = first.friction == PolachFriction::Falling;
  if (falling) {
    parameters.push_back({"A", "1", 0.0, 1.0, p.A});
    parameters.push_back({"B", "s/m", 0.0, 1e4 / fastest, p.B});
  }
  parameters.push_back({"kA", "1", 1e-3, 1e2, p.kA});
  parameters.push_back({"kS", "1", 1e-3, 1e2, p.kS});
  const CurveModel model(curve, parameters, [&](const Vector &x) {
    const PolachParameters now = falling ? PolachParameters{x[0], x[1], x[2], x[3], x[4]}
                                         : PolachParameters{x[0], 1.0, 0.0, x[1], x[2]};
    std::vector<double> ratios;
    for (const MeasuredTraction &value : curve)
      ratios.push_back(
          -polachForce(now, contact, {value.creep, 0.0, 0.0, value.speed, contact.load}).x /
          contact.load);
    return ratios;
  });
  return model.fit("Polach's form");
}

/// Compliance at which a layer alone is as stiff as the half-spaces of an ellipse: 8 a/(3 G C11).
double compliance(const PolachContact &c)
{
  return 8.0 * c.a * mm / (3.0 * c.shearModulus * MPa * c.kalker.c11);
}

/// T/N over mu of a contact whose cells all have one mu: elasticity is linear and the pressure does
/// not change, so that it depends on creep/mu and on the layer alone. Solved on a grid of both, and
/// interpolated: by cubic splines in log(creep/mu), by cubics in the share of the initial slope
/// that the layer leaves of the ellipse's.
class SlidingShare {
 public:
  SlidingShare(const PatchContact &contact, double spinPoint, double linearCreep,
               double layerCompliance, const std::function<bool()> &goOn)
      : unit_(linearCreep)
  {
    CreepPhysics physics; // one mu, and no heat
    physics.thermal.model = ThermalModel::Off;
    for (const double share : shares) {
      PatchContact layered = contact;
      layered.pair.layer = layerCompliance * (1.0 / share - 1.0);
      FrozenPatch rolling(physics, layered, spinPoint);
      std::vector<double> ratios;
      for (int k = 0; k < creeps; ++k) {
        requireToGoOn(goOn);
        PatchDrive drive;
        drive.creepage.xi = unit_ * least * std::pow(10.0, double(k) / perDecade);
        ratios.push_back(rolling.solve(ConstantLaw(1.0), 1.0, drive).tractionRatio());
      }
      slopes_.push_back(ratios.front() / least);
      curves_.emplace_back(ratios.begin(), ratios.end(), 0.0, 1.0 / perDecade);
    }
  }

  static constexpr double leastShare = 0.05;

  /// \param scaledCreep creep/mu, >= 0 \param share leastShare .. 1
  double operator()(double scaledCreep, double share) const
  {
    const auto above = std::upper_bound(std::begin(shares), std::end(shares), share);
    const auto first = std::clamp<std::ptrdiff_t>(above - std::begin(shares) - 2, 0,
                                                  std::ptrdiff_t(std::size(shares)) - 4);
    double sum = 0.0; // Lagrange's cubic through four shares
    for (auto k = first; k < first + 4; ++k) {
      double weight = 1.0;
      for (auto m = first; m < first + 4; ++m)
        if (m != k)
          weight *= (share - shares[m]) / (shares[k] - shares[m]);
      sum += weight * at(scaledCreep / unit_, static_cast<std::size_t>(k));
    }
    return sum;
  }

 private:
  double at(double x, std::size_t k) const
  {
    if (x <= least)
      return slopes_[k] * x;
    const double place = std::log10(x / least), last = double(creeps - 1) / perDecade;
    return curves_[k](std::min(place, last));
  }

  static constexpr double shares[] = {leastShare, 0.1, 0.17, 0.27, 0.4, 0.57, 0.78, 1.0};
  static constexpr double least = 0.02; ///< of the creep that would slide by Kalker's slope
  static constexpr int perDecade = 8, creeps = 4 * perDecade + 1;
  double unit_;
  std::vector<double> slopes_;
  std::vector<boost::math::interpolators::cardinal_cubic_b_spline<double>> curves_;
};

MeasuredModel layerModel(const std::vector<MeasuredTraction> &curve, const PatchContact &contact,
                         double spinPoint, const PolachContact &ellipse, const PolachFit &first,
                         const std::function<bool()> &goOn)
{
  const PolachParameters &p = first.parameters;
  const bool falling = first.friction == PolachFriction::Falling;
  const double unit = compliance(ellipse);
  const SlidingShare share(contact, spinPoint,
                           ellipse.load /
                               (ellipse.shearModulus * ellipse.a * ellipse.b * ellipse.kalker.c11),
                           unit, goOn);
  double fastest = 0.0;
  for (const MeasuredTraction &value : curve)
    fastest = std::max(fastest, value.creep * value.speed);
  std::vector<CurveModel::Parameter> parameters = {{"mu0", "1", leastMu0, largestMu0, p.mu0}};
  if (falling) {
    parameters.push_back({"A", "1", 0.0, 1.0, p.A});
    parameters.push_back({"B", "s/m", 0.0, 1e4 / fastest, p.B});
  }
  parameters.push_back({"compliance", "m/Pa", SlidingShare::leastShare, 1.0,
                        std::clamp(0.5 * (p.kA + p.kS), 0.1, 0.95)});
  const CurveModel model(curve, parameters, [&](const Vector &x) {
    const FallingFriction friction{x[0], falling ? x[1] : 1.0, falling ? x[2] : 0.0};
    std::vector<double> ratios;
    for (const MeasuredTraction &value : curve) {
      const double mu = friction(value.creep * value.speed);
      ratios.push_back(mu * share(value.creep / mu, x[x.size() - 1]));
    }
    return ratios;
  });
  // Where friction falls soon, a stiff layer and a soft one may look alike.
  std::vector<Vector> starts;
  for (const double fall : {0.3, 3.0, 30.0})
    for (const double left : {0.2, 0.5, 0.9})
      if (falling)
        starts.push_back((Vector(4) << p.mu0, 0.5, fall / fastest, left).finished());
  MeasuredModel fit = model.fit("the layer", starts);
  MeasuredParameter &last = fit.parameters.back(); // a small share is a soft layer
  const auto softness = [unit](double left) { return unit * (1.0 / left - 1.0); };
  last.value = softness(last.value);
  std::tie(last.low, last.high) = std::pair(softness(last.high), softness(last.low));
  std::swap(last.lowOpen, last.highOpen);
  return fit;
}

nlohmann::ordered_json modelJson(const MeasuredModel &model)
{
  nlohmann::ordered_json json;
  for (const MeasuredParameter &p : model.parameters) {
    json[p.name] = {{"value", p.value}, {"unit", p.unit}, {"low", nullptr}, {"high", nullptr}};
    if (!p.lowOpen)
      json[p.name]["low"] = p.low;
    if (!p.highOpen)
      json[p.name]["high"] = p.high;
  }
  json["rms_traction_ratio"] = model.rms;
  return json;
}

} // namespace

MeasuredFit fitMeasured(const std::vector<MeasuredTraction> &curve, const CreepPhysics &physics,
                        const PatchContact &contact, double spinPoint, const FrictionLaw &law,
                        const PolachContact &ellipse, const std::function<bool()> &goOn)
{
  MeasuredFit fit;
  fit.predicted = solved(curve, physics, contact, spinPoint, law, goOn);
  fit.predictedRms = rmsOf(curve, fit.predicted, 0);
  std::vector<PolachPoint> points;
  for (const MeasuredTraction &value : curve)
    points.push_back({{value.creep, 0.0, 0.0, value.speed, ellipse.load},
                      -value.tractionRatio * ellipse.load,
                      0.0});
  const PolachFit first = choosePolach(points, ellipse).best;
  fit.polach = polachModel(curve, ellipse, first);
  PatchContact bare = contact;
  bare.pair.layer = 0.0;
  bare.yieldStress = std::numeric_limits<double>::infinity();
  bare.pair.K = 0.0; // else pressure slips too, and T/N over mu depends on more than creep/mu
  fit.uncoupled = contact.pair.K != 0.0;
  fit.layer = layerModel(curve, bare, spinPoint, ellipse, first, goOn);
  const double unit = compliance(ellipse);
  fit.slopeShare = unit / (unit + fit.layer.parameters.back().value);
  return fit;
}

MeasuredFit fitMeasured(const std::vector<MeasuredTraction> &curve, const PatchSpecification &asked,
                        const PatchCurves &curves, const FrictionLaw &law,
                        const std::function<bool()> &goOn)
{
  return fitMeasured(curve, asked.physics, curves.contacts.front(), asked.contact.spinPoint, law,
                     polachContact(curves), goOn);
}

std::vector<MeasuredTraction> readMeasuredCurve(const std::string &path,
                                                const PatchSpecification &asked)
{
  constexpr std::size_t fewest = 4; // one more than Polach's law with constant friction fits
  std::vector<MeasuredTraction> curve = readMeasuredCurve(
      path, asked.speed.size() == 1 ? std::optional(asked.speed[0]) : std::nullopt);
  if (curve.size() < fewest)
    throw badInput(path, 0, "",
                   fmt::format("{} of the at least {} values that --fit-measured needs",
                               curve.size(), fewest));
  return curve;
}

std::string measuredJson(const MeasuredFit &fit, const std::string &path)
{
  nlohmann::ordered_json json = {{"format", "wr_creep-measured 1"}, {"version", WHEELRAIL_VERSION}};
  json["measured"] = path;
  json["values"] = fit.predicted.size();
  json["intervals"] = "95 %, of least squares; null: the curve sets no limit";
  json["predicted"] = {{"fitted", "nothing"}, {"rms_traction_ratio", fit.predictedRms}};
  json["polach"] = modelJson(fit.polach);
  json["layer"] = modelJson(fit.layer);
  json["layer"]["share_of_initial_slope"] = fit.slopeShare;
  if (fit.uncoupled)
    json["layer"]["left_out"] = "the coupling of unlike bodies";
  return jsonText("measured_fit.json", json);
}

std::string measuredCsv(const MeasuredFit &fit, const std::vector<MeasuredTraction> &curve)
{
  std::string text =
      "# T/N measured, as the case predicts it, by both fits; speed: m/s; others: 1\n"
      "creep,speed,measured,predicted,polach,layer\n";
  for (std::size_t k = 0; k < curve.size(); ++k)
    text += fmt::format("{:.8g},{:.6g},{:.8g},{:.8g},{:.8g},{:.8g}\n", curve[k].creep,
                        curve[k].speed, curve[k].tractionRatio, fit.predicted[k],
                        fit.polach.tractionRatio[k], fit.layer.tractionRatio[k]);
  return text;
}

} // namespace wheelrail
