#include "report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Json = nlohmann::ordered_json;

constexpr double mm = 1e-3, um = 1e-6, MPa = 1e6, newtonPerMm = 1e3;
constexpr double normal95 = 1.959964; ///< quantile of the normal distribution, 97.5 %

const char *nameOf(Adhesion state)
{
  switch (state) {
  case Adhesion::Stick:
    return "stick";
  case Adhesion::Slip:
    return "slip";
  case Adhesion::BackwardSlip:
    return "backward_slip";
  default:
    return "apart";
  }
}

bool severalProfiles(const CreepCurves &curves)
{
  return curves.contacts.size() > 1;
}

/// One curve: points of one profile at one speed.
struct Curve {
  const ContactSetup *contact;
  const CurvePoint *first, *last; ///< both included
};

std::vector<Curve> curvesOf(const Case &input, const CreepCurves &curves)
{
  std::vector<Curve> list;
  const std::size_t n = input.creep.size(), speeds = input.speed.size();
  for (std::size_t k = 0; k < curves.contacts.size() * speeds; ++k)
    list.push_back(
        {&curves.contacts[k / speeds], &curves.points[k * n], &curves.points[k * n + n - 1]});
  return list;
}

Json statisticsJson(const ProfileStatistics &s)
{
  return {{"step", s.step},
          {"rms_height_um", s.rmsHeight / um},
          {"rms_slope", s.rmsSlope},
          {"mean_wavelength_mm", s.meanWavelength / mm},
          {"shortest_wavelength_mm", s.shortestWavelength / mm},
          {"longest_wavelength_mm", s.longestWavelength / mm}};
}

Json contactJson(const ContactSetup &c)
{
  const NormalContactResult &normal = c.normal;
  Json json = {{"seed", c.seed},
               {"real_area_ratio", c.realAreaRatio()},
               {"real_contact_length_mm", c.realContactLength() / mm},
               {"micro_contacts", contactIntervals(normal.pressure, Boundary::Free).size()},
               {"peak_pressure_MPa", normal.peakPressure() * c.hertz.modulus / MPa},
               {"plastic_depth_um", normal.plasticDepth.maxCoeff() * c.cellSize / um},
               {"initial_slope_N_per_mm",
                initialSlope(c.hertz.modulus, c.realContactLength()) / newtonPerMm},
               {"iterations", normal.iterations},
               {"active_sets", normal.activeSets},
               {"residual", normal.residual},
               {"seconds", normal.seconds}};
  Json steps = Json::array();
  for (const ProfileStatistics &s : c.statistics)
    steps.push_back(statisticsJson(s));
  json["roughness"] = steps;
  return json;
}

Json curveJson(const Curve &curve)
{
  const CurvePoint *peak =
      std::max_element(curve.first, curve.last + 1, [](const CurvePoint &a, const CurvePoint &b) {
        return a.tractionRatio < b.tractionRatio;
      });
  return {{"seed", curve.contact->seed},
          {"speed_m_s", curve.first->speed},
          {"peak_traction_ratio", peak->tractionRatio},
          {"creep_at_peak", peak->creep},
          {"last_creep", curve.last->creep},
          {"last_over_peak",
           peak->tractionRatio > 0.0 ? curve.last->tractionRatio / peak->tractionRatio : 0.0},
          {"highest_temperature_K", curve.last->temperatureMaximum}};
}

} // namespace

std::string creepCsv(const Case &, const CreepCurves &curves)
{
  std::string text =
      "# speed: m/s; creep, ratios: 1; traction: N/mm; temperature_rise: K, mean over "
      "the nominal contact\n"
      "speed,creep,traction_ratio,traction,mu_mean,temperature_rise,iterations,"
      "stick_fraction";
  text += severalProfiles(curves) ? ",seed\n" : "\n";
  for (const CurvePoint &p : curves.points) {
    text += fmt::format("{:g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{},{:.6g}", p.speed, p.creep,
                        p.tractionRatio, p.traction / newtonPerMm, p.muMean, p.temperatureRise,
                        p.iterations, p.stickFraction);
    text += severalProfiles(curves) ? fmt::format(",{}\n", p.seed) : "\n";
  }
  return text;
}

std::string creepBandCsv(const CreepCurves &curves)
{
  std::string text = "# T/N with its standard error and 95 % interval from the covariance of the "
                     "friction law; speed: m/s\n"
                     "speed,creep,traction_ratio,standard_error,low,high";
  text += severalProfiles(curves) ? ",seed\n" : "\n";
  for (const CurvePoint &p : curves.points) {
    const double half = normal95 * p.tractionRatioError;
    text += fmt::format("{:g},{:.10g},{:.10g},{:.6g},{:.10g},{:.10g}", p.speed, p.creep,
                        p.tractionRatio, p.tractionRatioError, p.tractionRatio - half,
                        p.tractionRatio + half);
    text += severalProfiles(curves) ? fmt::format(",{}\n", p.seed) : "\n";
  }
  return text;
}

std::string contactCsv(const CreepCurves &curves)
{
  const ContactSetup &setup = curves.contacts.back();
  const ContactFields &f = curves.last;
  const CurvePoint &point = curves.points.back();
  std::string text =
      fmt::format("# speed {:g} m/s, creep {:g}; x: mm, leading edge at the largest x; pressure, "
                  "traction: MPa; slip: sliding/rolling speed; temperature: K\n"
                  "x,pressure,traction,mu,slip,state,temperature\n",
                  point.speed, point.creep);
  for (int i = 0; i < setup.cells; ++i)
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{},{:.6g}\n", setup.position(i) / mm,
                        f.pressure[i] / MPa, f.traction[i] / MPa, f.mu[i], f.slip[i],
                        nameOf(f.state[i]), f.temperature[i]);
  return text;
}

std::string summaryJson(const Case &input, const FrictionLaw &law, const CreepCurves &curves)
{
  const HertzContact &hertz = curves.contacts.front().hertz;
  Json json = {{"format", "wr_creep-summary 1"}, {"version", WHEELRAIL_VERSION}};
  json["case"] = input.text;
  json["law"] = toJson(law);
  json["hertz"] = {{"half_width_mm", hertz.halfWidth / mm},
                   {"pressure_MPa", hertz.hertzPressure / MPa},
                   {"contact_modulus_GPa", hertz.modulus / (1e3 * MPa)},
                   {"peclet_number",
                    input.thermal == ThermalModel::Off
                        ? 0.0
                        : input.speed.front() * hertz.halfWidth * input.material.density *
                              input.material.specificHeat / (2.0 * input.material.conductivity)}};
  json["cells"] = curves.contacts.front().cells;
  json["cell_size_mm"] = curves.contacts.front().cellSize / mm;
  for (const ContactSetup &contact : curves.contacts)
    json["contacts"].push_back(contactJson(contact));
  for (const Curve &curve : curvesOf(input, curves))
    json["curves"].push_back(curveJson(curve));
  json["points"] = curves.points.size();
  json["points_resumed"] = curves.resumed;
  json["seconds"] = curves.seconds;
  return json.dump(2) + "\n";
}

std::string shortReport(const Case &input, const CreepCurves &curves)
{
  const HertzContact &hertz = curves.contacts.front().hertz;
  std::string text =
      fmt::format("Hertz: half-width {:.4g} mm, pressure {:.4g} MPa; {} cells of {:.4g} um\n",
                  hertz.halfWidth / mm, hertz.hertzPressure / MPa, curves.contacts.front().cells,
                  curves.contacts.front().cellSize / um);
  for (const Curve &curve : curvesOf(input, curves)) {
    const Json j = curveJson(curve);
    const std::string profile =
        input.roughness == RoughnessKind::None
            ? ""
            : fmt::format("{}real area {:.1f} %, peak pressure {:.0f} MPa; ",
                          severalProfiles(curves) ? fmt::format("seed {}: ", curve.contact->seed)
                                                  : "",
                          100.0 * curve.contact->realAreaRatio(),
                          curve.contact->normal.peakPressure() * hertz.modulus / MPa);
    text +=
        fmt::format("{}{:g} m/s: T/N at most {:.4f} (creep {:.4g}), {:.4f} at creep {:g}\n",
                    profile, curve.first->speed, j["peak_traction_ratio"].get<double>(),
                    j["creep_at_peak"].get<double>(), curve.last->tractionRatio, curve.last->creep);
  }
  return text;
}

std::string detailedReport(const CreepCurves &curves)
{
  std::string text;
  for (const ContactSetup &c : curves.contacts) {
    for (const ProfileStatistics &s : c.statistics)
      text +=
          fmt::format("seed {}, {}: rms height {:.4g} um, rms slope {:.4g}, wavelengths {:.4g} to "
                      "{:.4g} mm, mean {:.4g} mm\n",
                      c.seed, s.step, s.rmsHeight / um, s.rmsSlope, s.shortestWavelength / mm,
                      s.longestWavelength / mm, s.meanWavelength / mm);
    text += fmt::format("normal contact: {} iterations, {} active sets, residual {:.1e}, {:.3f} s; "
                        "real area {:.2f} %, {} micro-contacts, peak {:.0f} MPa, plastic depth "
                        "{:.3g} um\n",
                        c.normal.iterations, c.normal.activeSets, c.normal.residual,
                        c.normal.seconds, 100.0 * c.realAreaRatio(),
                        contactIntervals(c.normal.pressure, Boundary::Free).size(),
                        c.normal.peakPressure() * c.hertz.modulus / MPa,
                        c.normal.plasticDepth.maxCoeff() * c.cellSize / um);
  }
  return text;
}

} // namespace wheelrail
