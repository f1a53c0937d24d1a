// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/creep_report.h"

#include "base/result_text.h"
#include "base/si.h"
#include "creep/sweep/quotation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Json = nlohmann::ordered_json;

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

/// The columns of a file, and that of the profiles when there are several.
template<class Point>
FileColumns<Point> withProfile(FileColumns<Point> columns, const SurfaceSpecification &surface)
{
  if (surface.profiles() > 1)
    columns.push_back({{surface.profileName(), "1", 1.0, "", kept<&Point::profile>}, wholeDigits});
  return columns;
}

/// One curve: points of one profile at one speed, those that converged; at least one.
struct Curve {
  const ContactSetup *contact;
  std::vector<const CurvePoint *> points;
};

std::vector<Curve> curvesOf(const CreepSpecification &asked, const CreepCurves &curves)
{
  std::vector<Curve> list;
  const std::size_t n = asked.drives().size(), speeds = asked.speed.size();
  for (std::size_t k = 0; k < curves.contacts.size() * speeds; ++k) {
    Curve curve{&curves.contacts[k / speeds], {}};
    for (std::size_t i = k * n; i < (k + 1) * n; ++i)
      if (curves.points[i].converged())
        curve.points.push_back(&curves.points[i]);
    if (!curve.points.empty())
      list.push_back(curve);
  }
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

Json contactJson(const SurfaceSpecification &surface, const ContactSetup &c)
{
  const NormalContactResult &normal = c.normal;
  Json json = {{surface.profileName(), c.surface.profile},
               {"real_area_ratio", c.realAreaRatio()},
               {"real_contact_length_mm", c.realContactLength() / mm},
               {"micro_contacts", contactIntervals(normal, c.boundary).size()},
               {"peak_pressure_MPa", normal.peakPressure() * c.hertz.modulus / MPa},
               {"plastic_depth_um", normal.plasticDepth.maxCoeff() * c.cellSize / um},
               {"iterations", normal.iterations},
               {"active_sets", normal.activeSets},
               {"residual", normal.residual},
               {"seconds", normal.seconds}};
  Json steps = Json::array();
  for (const ProfileStatistics &s : c.surface.statistics)
    steps.push_back(statisticsJson(s));
  json["roughness"] = steps;
  if (c.boundary == Boundary::Free)
    json["initial_slope_N_per_mm"] =
        initialSlope(c.hertz.modulus, c.realContactLength()) / newtonPerMm;
  return json;
}

Json curveJson(const SurfaceSpecification &surface, const Curve &curve)
{
  const CurvePoint &last = *curve.points.back();
  const CurvePoint &peak = **std::max_element(
      curve.points.begin(), curve.points.end(), [](const CurvePoint *a, const CurvePoint *b) {
        return std::abs(a->tractionRatio) < std::abs(b->tractionRatio);
      });
  return {
      {surface.profileName(), curve.contact->surface.profile},
      {"speed_m_s", last.speed},
      {"peak_traction_ratio", peak.tractionRatio},
      {"creep_at_peak", peak.creep},
      {"last_creep", last.creep},
      {"last_over_peak", peak.tractionRatio != 0.0 ? last.tractionRatio / peak.tractionRatio : 0.0},
      {"highest_temperature_K", last.temperatureMaximum}};
}

} // namespace

std::string creepCsv(const SurfaceSpecification &surface, const CreepCurves &curves)
{
  return csvOf(withProfile(columnsOf(curveColumns(), &Column<CurvePoint>::creep), surface),
               curves.points);
}

std::string creepJson(const CreepSpecification &asked, const CreepCurves &curves)
{
  const SurfaceSpecification &surface = asked.surface;
  FileColumns<CurvePoint> columns = columnsOf(curveColumns(), &Column<CurvePoint>::creep);
  Json json = {
      {"format", "wr_creep-curves 1"}, {"units", unitsOf(columns)}, {"curves", Json::array()}};
  // the speed is the curve's
  const FileColumn<CurvePoint> speed = columns.front();
  columns.erase(columns.begin());
  if (curves.hasBand)
    for (const auto &column : columnsOf(curveColumns(), &Column<CurvePoint>::band))
      if (column.column.creep.digits == 0) // not yet there
        columns.push_back(column);
  for (const Curve &curve : curvesOf(asked, curves)) {
    Json one = {{surface.profileName(), curve.contact->surface.profile},
                {speed.column.name, speed.valueOf(*curve.points.front())}};
    for (const FileColumn<CurvePoint> &column : columns)
      for (const CurvePoint *p : curve.points)
        one[column.column.name].push_back(jsonValue<Json>(column, *p));
    json["curves"].push_back(one);
  }
  return jsonText("creep.json", json, -1);
}

std::string creepBandCsv(const SurfaceSpecification &surface, const CreepCurves &curves)
{
  return csvOf(withProfile(columnsOf(curveColumns(), &Column<CurvePoint>::band), surface),
               curves.points);
}

namespace {

/// \param fields null: the point did not converge
std::string fieldTable(const ContactSetup &setup, const ContactFields *fields,
                       const std::string &what)
{
  std::string text =
      fmt::format("# {}{}; x: mm, leading edge at the largest x; pressure, traction: MPa; slip: "
                  "sliding/rolling speed; temperature: K\n"
                  "x,pressure,traction,mu,slip,state,temperature\n",
                  what, fields ? "" : ", which did not converge");
  if (!fields)
    return text;
  const ContactFields &f = *fields;
  for (int i = 0; i < setup.cells; ++i)
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{},{:.6g}\n", setup.position(i) / mm,
                        f.pressure[i] / MPa, f.traction[i] / MPa, f.mu[i], f.slip[i],
                        nameOf(f.state[i]), f.temperature[i]);
  return text;
}

/// \param what words for the first line
template<class Curves>
std::string contactTableOf(const Curves &curves, int number, const std::string &what)
{
  const std::size_t pointsOfContact = curves.points.size() / curves.contacts.size();
  const auto place = static_cast<std::size_t>(number - 1);
  const auto found = curves.fields.find(number);
  return fieldTable(curves.contacts[place / pointsOfContact],
                    found == curves.fields.end() ? nullptr : &found->second, what);
}

std::string placeOf(const CurvePoint &point)
{
  return fmt::format("speed {:g} m/s, creep {:g}", point.speed, point.creep);
}

} // namespace

std::string contactFileName(const FieldSelection &asked, int number)
{
  return asked.kind == FieldSelection::Kind::Last ? "contact.csv"
                                                  : fmt::format("contact_{:04d}.csv", number);
}

std::string contactTable(const CreepCurves &curves, int number)
{
  return contactTableOf(curves, number, placeOf(curves.points.at(number - 1)));
}

std::string contactTable(const StaticCases &cases, int number)
{
  return contactTableOf(
      cases, number,
      fmt::format("static, T/(mu N) = {:g}", cases.points.at(number - 1).forceRatio));
}

std::vector<std::string> failures(const CreepCurves &curves)
{
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < curves.points.size(); ++k)
    if (const CurvePoint &point = curves.points[k]; !point.converged())
      lines.push_back(fmt::format("point {} ({}): {}", k + 1, placeOf(point), point.failure));
  return lines;
}

std::string staticCsv(const SurfaceSpecification &surface, const StaticCases &cases)
{
  return csvOf(withProfile(columnsOf(staticColumns(), &Column<StaticPoint>::still), surface),
               cases.points);
}

namespace {

/// What every summary begins with: case, law and its use, nominal contact, contacts.
template<class Curves>
Json summaryHead(const SurfaceSpecification &surface, const std::string &text,
                 const FrictionLaw &law, const Curves &curves,
                 const std::vector<std::string> &files)
{
  const std::vector<ContactSetup> &contacts = curves.contacts;
  const ContactSetup &first = contacts.front();
  const HertzContact &hertz = first.hertz;
  Json json = {{"format", "wr_creep-summary 1"}, {"version", WHEELRAIL_VERSION}};
  json["case"] = text;
  json["law"] = law.json();
  if (!curves.use.ranges.empty())
    json["law_use"] = toJson(law, curves.use);
  json["warnings"] = curves.warnings;
  json["files"] = files;
  if (first.boundary == Boundary::Periodic)
    json["periodic"] = {{"period_mm", 2.0 * hertz.halfWidth / mm},
                        {"mean_pressure_MPa", hertz.hertzPressure / MPa},
                        {"contact_modulus_GPa", hertz.modulus / (1e3 * MPa)}};
  else
    json["hertz"] = {{"half_width_mm", hertz.halfWidth / mm},
                     {"pressure_MPa", hertz.hertzPressure / MPa},
                     {"contact_modulus_GPa", hertz.modulus / (1e3 * MPa)}};
  json["cells"] = first.cells;
  json["cell_size_mm"] = first.cellSize / mm;
  for (const ContactSetup &contact : contacts)
    json["contacts"].push_back(contactJson(surface, contact));
  return json;
}

std::string nominalContact(const ContactSetup &setup)
{
  const std::string cells =
      fmt::format("{} cells of {:.4g} um\n", setup.cells, setup.cellSize / um);
  if (setup.boundary == Boundary::Periodic)
    return fmt::format("period {:.4g} mm, mean pressure {:.4g} MPa; ",
                       2.0 * setup.hertz.halfWidth / mm, setup.hertz.hertzPressure / MPa) +
           cells;
  return fmt::format("Hertz: half-width {:.4g} mm, pressure {:.4g} MPa; ",
                     setup.hertz.halfWidth / mm, setup.hertz.hertzPressure / MPa) +
         cells;
}

/// Statistics after every step of the preparation, and what the contact made of the profile.
std::string profileReport(const SurfaceSpecification &surface, const ContactSetup &c)
{
  std::string text;
  const std::string name = surface.profiles() > 1
                               ? fmt::format("{} {}: ", surface.profileName(), c.surface.profile)
                               : std::string();
  for (const ProfileStatistics &s : c.surface.statistics)
    text +=
        fmt::format("{}{}: rms height {:.4g} um, rms slope {:.4g}, wavelengths {:.4g} to {:.4g} "
                    "mm, mean {:.4g} mm\n",
                    name, s.step, s.rmsHeight / um, s.rmsSlope, s.shortestWavelength / mm,
                    s.longestWavelength / mm, s.meanWavelength / mm);
  if (!c.surface.statistics.empty())
    text += fmt::format("{}real area {:.1f} %, {} micro-contacts, peak pressure {:.0f} MPa\n", name,
                        100.0 * c.realAreaRatio(), contactIntervals(c.normal, c.boundary).size(),
                        c.normal.peakPressure() * c.hertz.modulus / MPa);
  return text;
}

} // namespace

std::string summaryJson(const CreepSpecification &asked, const std::string &text,
                        const FrictionLaw &law, const CreepCurves &curves,
                        const std::vector<std::string> &files)
{
  Json json = summaryHead(asked.surface, text, law, curves, files);
  const ThermalSpecification &thermal = asked.physics.thermal;
  if (thermal.model != ThermalModel::Off)
    json["hertz"]["peclet_number"] = pecletNumber(curves.contacts.front().hertz.halfWidth,
                                                  asked.speed.front(), thermal.material);
  for (const Curve &curve : curvesOf(asked, curves))
    json["curves"].push_back(curveJson(asked.surface, curve));
  if (curves.hasBand && asked.spread.method == UncertaintyMethod::Sampled)
    json["uncertainty"] = {{"samples", asked.spread.samples},
                           {"seed", asked.spread.seed},
                           {"redrawn_share", curves.redrawn}};
  json["not_converged"] = failures(curves);
  json["points"] = curves.points.size();
  json["points_resumed"] = curves.resumed;
  json["seconds"] = curves.seconds;
  return jsonText("summary.json", json);
}

std::string summaryJson(const StaticSpecification &asked, const std::string &text,
                        const FrictionLaw &law, const StaticCases &cases,
                        const std::vector<std::string> &files)
{
  Json json = summaryHead(asked.surface, text, law, cases, files);
  for (const StaticPoint &p : cases.points) {
    Json force = {{asked.surface.profileName(), p.profile}};
    for (const auto &one : columnsOf(staticColumns(), &Column<StaticPoint>::still))
      force[keyWithUnit(one.column)] = jsonValue<Json>(one, p);
    json["forces"].push_back(force);
  }
  json["points"] = cases.points.size();
  json["seconds"] = cases.seconds;
  return jsonText("summary.json", json);
}

std::string shortReport(const CreepSpecification &asked, const CreepCurves &curves)
{
  std::string text = nominalContact(curves.contacts.front());
  const ContactSetup *last = nullptr;
  for (const Curve &curve : curvesOf(asked, curves)) {
    if (curve.contact != last)
      text += profileReport(asked.surface, *curve.contact);
    last = curve.contact;
    const Json j = curveJson(asked.surface, curve);
    text += fmt::format("{:g} m/s: T/N at most {:.4f} (creep {:.4g}), {:.4f} at creep {:g}\n",
                        curve.points.front()->speed, j["peak_traction_ratio"].get<double>(),
                        j["creep_at_peak"].get<double>(), curve.points.back()->tractionRatio,
                        curve.points.back()->creep);
  }
  std::vector<QuotedPoint> quoted;
  for (const CurvePoint &point : curves.points)
    if (point.converged())
      quoted.push_back({point.speed, point.creep, point.tractionRatio, point.band});
  return text + quotation(quoted);
}

std::string shortReport(const StaticSpecification &asked, const StaticCases &cases)
{
  std::string text = nominalContact(cases.contacts.front());
  std::size_t k = 0;
  for (const ContactSetup &contact : cases.contacts) {
    text += profileReport(asked.surface, contact);
    for (std::size_t force = 0; force < asked.forceRatio.size(); ++force, ++k)
      text +=
          fmt::format("T/(mu N) = {:g}: T/N {:.4f}, {:.4g} mm stick\n", cases.points[k].forceRatio,
                      cases.points[k].tractionRatio, cases.points[k].stickLength / mm);
  }
  return text;
}

std::string detailedReport(const SurfaceSpecification &surface,
                           const std::vector<ContactSetup> &contacts)
{
  std::string text;
  for (const ContactSetup &c : contacts)
    text += fmt::format("{} {}: normal contact: {} iterations, {} active sets, residual {:.1e}, "
                        "{:.3f} s; plastic depth {:.3g} um\n",
                        surface.profileName(), c.surface.profile, c.normal.iterations,
                        c.normal.activeSets, c.normal.residual, c.normal.seconds,
                        c.normal.plasticDepth.maxCoeff() * c.cellSize / um);
  return text;
}

} // namespace wheelrail
