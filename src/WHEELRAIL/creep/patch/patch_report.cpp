// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_report.h"

#include "base/result_text.h"
#include "base/si.h"
#include "creep/sweep/quotation.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

using Json = nlohmann::ordered_json;

constexpr double perMm = 1e3;

bool severalSurfaces(const PatchSpecification &asked)
{
  return asked.roughness.surfaces() > 1;
}

const char *modeName(PatchMode mode)
{
  return mode == PatchMode::Frozen ? "frozen" : mode == PatchMode::Moving ? "moving" : "static";
}

using PatchColumns = FileColumns<PatchPoint>;

/// The columns of a file, and that of the surfaces when there are several.
PatchColumns withSurface(PatchColumns columns, const PatchSpecification &asked)
{
  if (severalSurfaces(asked))
    columns.push_back(
        {{asked.roughness.surfaceName(), "1", 1.0, "", kept<&PatchPoint::surface>}, wholeDigits});
  return columns;
}

void append(PatchColumns &columns, const PatchColumns &others)
{
  columns.insert(columns.end(), others.begin(), others.end());
}

/// A column of the table under another name. \param digits of the file
FileColumn<PatchPoint> named(const std::string &name, const std::string &inTable, int digits)
{
  const auto &table = patchColumns();
  Column<PatchPoint> column = *std::find_if(table.begin(), table.end(),
                                            [&](const auto &one) { return one.name == inTable; });
  column.name = name;
  return {column, digits};
}

/// A quantity with its standard error and 95 % interval, the band's in the quantity's unit.
/// \param name in the file
/// \param inTable in the table of columns
/// \param band likewise
PatchColumns withBand(const std::string &name, const std::string &inTable, const std::string &band)
{
  PatchColumns columns = {
      named(name, inTable, 10), named(name + "_standard_error", band + "_standard_error", 6),
      named(name + "_low", band + "_low", 10), named(name + "_high", band + "_high", 10)};
  for (FileColumn<PatchPoint> &one : columns) {
    one.column.unit = columns.front().column.unit;
    one.column.scale = columns.front().column.scale;
  }
  return columns;
}

Json statisticsJson(const HeightMapStatistics &s)
{
  return {{"step", s.step},
          {"unmeasured", s.unmeasured},
          {"rms_height_um", s.rmsHeight / um},
          {"rms_slope_x", s.rmsSlopeX},
          {"rms_slope_y", s.rmsSlopeY},
          {"shortest_wavelength_mm", s.shortestWavelength / mm}};
}

Json contactJson(const PatchSpecification &asked, const PatchContact &c,
                 const PatchContactSummary &summary)
{
  const NormalContactResult &normal = c.normal;
  Json json = {{asked.roughness.surfaceName(), c.surface.number},
               {"load_N", c.load},
               {"a_mm", c.hertz.a / mm},
               {"b_mm", c.hertz.b / mm},
               {"hertz_pressure_MPa", c.hertz.hertzPressure / MPa},
               {"hertz_approach_mm", c.hertz.approach / mm},
               {"cell_size_mm", {c.grid.dx / mm, c.grid.dy / mm}},
               {"contact_cells", normal.contactCells()},
               {"approach_mm", normal.approach / mm},
               {"peak_pressure_MPa", normal.peakPressure() / MPa},
               {"real_area_mm2", c.realArea(normal.pressure) / mm2},
               {"real_area_ratio", c.realArea(normal.pressure) / c.nominalArea()},
               {"plastic_depth_um", normal.plasticDepth.maxCoeff() / um},
               {"iterations", normal.iterations},
               {"active_sets", normal.activeSets},
               {"residual", normal.residual},
               {"seconds", normal.seconds}};
  Json steps = Json::array();
  for (const HeightMapStatistics &s : c.surface.statistics)
    steps.push_back(statisticsJson(s));
  json["roughness"] = steps;
  if (summary.kalker) {
    const KalkerCoefficients &k = *summary.kalker;
    const CreepSensitivity &s = *summary.sensitivity;
    json["kalker"] = {{"c11", k.c11}, {"c22", k.c22}, {"c23", k.c23}, {"c33", k.c33}};
    json["sensitivity"] = {{"force_x_creep_N", -s.xx},
                           {"force_y_lateral_N", -s.yy},
                           {"force_y_spin_N_mm", -s.yz / mm},
                           {"moment_z_lateral_N_mm", -s.zy / newtonMm},
                           {"moment_z_spin_N_mm2", -s.zz / newtonMm / mm}};
  }
  return json;
}

} // namespace

bool isOfMoving(const Column<PatchPoint> &column, const PatchSpecification &asked)
{
  if (asked.mode != PatchMode::Moving || column.moving.digits == 0)
    return false;
  const bool isError = column.name.find("_se") != std::string::npos;
  const bool scatters =
      !asked.sequence.any() && asked.moving.passes - asked.moving.discardedPasses() > 1;
  return !isError || scatters;
}

std::string patchCsv(const PatchSpecification &asked, const PatchCurves &curves)
{
  using C = Column<PatchPoint>;
  const bool still = asked.mode == PatchMode::Static;
  PatchColumns columns = columnsOf(patchColumns(), still ? &C::still : &C::creep);
  for (const FileColumn<PatchPoint> &one : columnsOf(patchColumns(), &C::moving))
    if (isOfMoving(one.column, asked))
      columns.push_back(one);
  if (asked.physics.wear.kind != WearLaw::Kind::None)
    append(columns, columnsOf(patchColumns(), &C::wear));
  return csvOf(withSurface(columns, asked), curves.points);
}

std::string patchBandCsv(const PatchSpecification &asked, const PatchCurves &curves)
{
  const bool givesX = !asked.forceX.empty(), givesY = !asked.forceY.empty();
  PatchColumns columns = columnsOf(patchColumns(), &Column<PatchPoint>::band);
  append(columns,
         givesX ? withBand("found_creep", "creep", "x") : withBand("force_x", "force_x", "x"));
  append(columns,
         givesY ? withBand("found_lateral", "lateral", "y") : withBand("force_y", "force_y", "y"));
  append(columns, withBand("moment_z", "moment_z", "moment_z"));
  return csvOf(withSurface(columns, asked), curves.points);
}

std::string patchSeriesCsv(const PatchSpecification &asked, const PatchCurves &curves)
{
  using C = Column<PatchStep>;
  const bool still = asked.mode == PatchMode::Static;
  const auto columns = columnsOf(seriesColumns(), still ? &C::stages : &C::series);
  std::string text =
      fmt::format("# point: operating point, as the case asks for them, from 1 on; {}\npoint,{}",
                  unitsOf(columns), headOf(columns));
  for (const auto &[number, steps] : curves.series)
    for (const PatchStep &s : steps)
      text += fmt::format("{},{}", number, rowOf(columns, s));
  return text;
}

std::string patchSummary(const PatchSpecification &asked, const std::string &text,
                         const FrictionLaw &law, const PatchCurves &curves,
                         const std::vector<std::string> &files)
{
  const PatchContact &first = curves.contacts.front();
  Json json = {{"format", "wr_creep-summary 1"}, {"version", WHEELRAIL_VERSION}};
  json["case"] = text;
  json["law"] = law.json();
  if (!curves.use.ranges.empty())
    json["law_use"] = toJson(law, curves.use);
  json["contact"] = "patch";
  json["mode"] = modeName(asked.mode);
  json["shear_modulus_GPa"] = first.pair.G / GPa;
  json["poissons_ratio"] = first.pair.nu;
  json["coupling"] = first.pair.K;
  json["curvatures_per_mm"] = {first.hertz.curvatures.A / perMm, first.hertz.curvatures.B / perMm};
  json["cells"] = {first.grid.nx, first.grid.ny};
  const ThermalSpecification &thermal = asked.physics.thermal;
  if (thermal.model != ThermalModel::Off)
    json["peclet_number"] = pecletNumber(first.hertz.a, asked.speed.front(), thermal.material);
  for (std::size_t k = 0; k < curves.contacts.size(); ++k)
    json["contacts"].push_back(contactJson(asked, curves.contacts[k], curves.summaries[k]));
  if (curves.hasBand && asked.spread.method == UncertaintyMethod::Sampled)
    json["uncertainty"] = {{"samples", asked.spread.samples},
                           {"seed", asked.spread.seed},
                           {"redrawn_share", curves.redrawn}};
  json["warnings"] = curves.warnings;
  json["files"] = files;
  json["fields"] = Json::array();
  for (const auto &[number, fields] : curves.fields) {
    const FieldPlace place = fieldPlace(number, static_cast<int>(curves.points.size()));
    json["fields"].push_back({{"point", place.point}, {"files", fieldStem(place)}});
    if (place.instant > 0)
      json["fields"].back()["time_s"] = asked.sequence.fields[place.instant - 1];
  }
  json["not_converged"] = failures(curves);
  json["points"] = curves.points.size();
  json["points_resumed"] = curves.resumed;
  json["seconds"] = curves.seconds;
  return jsonText("summary.json", json);
}

std::string patchShortReport(const PatchSpecification &asked, const PatchCurves &curves)
{
  std::string text;
  for (const PatchContact &c : curves.contacts) {
    const std::string name =
        severalSurfaces(asked)
            ? fmt::format("{} {}: ", asked.roughness.surfaceName(), c.surface.number)
            : std::string();
    text +=
        fmt::format("{}load {:.4g} kN: Hertz: semi-axes {:.4g} x {:.4g} mm, pressure {:.4g} "
                    "MPa; {} x {} cells of {:.4g} x {:.4g} um\n",
                    name, c.load / 1e3, c.hertz.a / mm, c.hertz.b / mm, c.hertz.hertzPressure / MPa,
                    c.grid.nx, c.grid.ny, c.grid.dx / um, c.grid.dy / um);
    for (const HeightMapStatistics &s : c.surface.statistics)
      text += fmt::format("{}{}: rms height {:.4g} um, rms slope {:.4g} along x, {:.4g} along y\n",
                          name, s.step, s.rmsHeight / um, s.rmsSlopeX, s.rmsSlopeY);
    text += fmt::format("{}real area {:.1f} % of the ellipse, peak pressure {:.0f} MPa\n", name,
                        100.0 * c.realArea(c.normal.pressure) / c.nominalArea(),
                        c.normal.peakPressure() / MPa);
  }
  std::vector<PatchPoint> points;
  std::copy_if(curves.points.begin(), curves.points.end(), std::back_inserter(points),
               [](const PatchPoint &point) { return point.converged(); });
  if (points.empty()) // of sequences that ended early there are steps
    return text;
  const PatchPoint &last = points.back();
  const auto largest =
      std::max_element(points.begin(), points.end(), [](const PatchPoint &a, const PatchPoint &b) {
        return a.tractionRatio() < b.tractionRatio();
      });
  text += fmt::format("T/N at most {:.4f}; last point: Fx {:.5g} N, Fy {:.5g} N, Mz {:.5g} N mm, "
                      "{:.0f} % of the contact sticks\n",
                      largest->tractionRatio(), last.forceX, last.forceY, last.momentZ / newtonMm,
                      100.0 * last.stickFraction);
  const bool differByCreep = asked.contact.load.size() == 1 && asked.lateral.size() <= 1 &&
                             asked.spin.size() <= 1 && asked.forceX.empty() &&
                             asked.forceY.empty() && !asked.sequence.any();
  if (asked.mode != PatchMode::Static && differByCreep) {
    std::vector<QuotedPoint> quoted;
    for (const PatchPoint &point : points)
      quoted.push_back(
          {point.speed, point.creepage.xi, point.tractionRatio(), point.bands.tractionRatio});
    text += quotation(quoted);
  }
  return text;
}

std::string patchDetailedReport(const PatchCurves &curves)
{
  std::string text;
  for (const PatchContact &c : curves.contacts)
    text += fmt::format("normal contact: {} iterations, {} active sets, residual {:.1e}, {:.3f} s; "
                        "plastic depth {:.3g} um\n",
                        c.normal.iterations, c.normal.activeSets, c.normal.residual,
                        c.normal.seconds, c.normal.plasticDepth.maxCoeff() / um);
  int products = 0;
  for (const PatchPoint &p : curves.points)
    products += p.products;
  return text + fmt::format("tangential contact: {} products with the influence of the tractions\n",
                            products);
}

std::vector<std::string> failures(const PatchCurves &curves)
{
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < curves.points.size(); ++k)
    if (const PatchPoint &p = curves.points[k]; !p.converged()) {
      const std::string rolls =
          p.speed > 0.0
              ? fmt::format(", creep {:g}, lateral {:g}, spin {:g} 1/mm, {:g} m/s", p.creepage.xi,
                            p.creepage.eta, p.creepage.phi / perMm, p.speed)
              : "";
      lines.push_back(fmt::format("point {} (load {:g} N{}): {}", k + 1, p.load, rolls, p.failure));
    }
  return lines;
}

std::string fieldStem(const FieldPlace &place)
{
  return fmt::format("fields_{:04d}", place.point) +
         (place.instant > 0 ? fmt::format("_{:04d}", place.instant) : "");
}

std::vector<std::string> fieldFileNames(const FieldPlace &place)
{
  std::vector<std::string> files = {fieldStem(place) + ".vti"};
  for (const std::string &name : gsfNames())
    files.push_back(fmt::format("{}_{}.gsf", fieldStem(place), name));
  return files;
}

std::vector<std::string> fieldFileNames(const PatchSpecification &asked)
{
  const int total = static_cast<int>(patchTasks(asked).size());
  const int instants = static_cast<int>(asked.sequence.fields.size());
  std::vector<std::string> files;
  for (int point = 1; point <= total; ++point)
    if (asked.fields.holds(point, total))
      for (int instant = 0; instant <= instants; ++instant)
        for (const std::string &name : fieldFileNames({point, instant}))
          files.push_back(name);
  return files;
}

namespace {

/// What the fields are of, in words.
std::string fieldTitle(const PatchSpecification &asked, const PatchCurves &curves,
                       const FieldPlace &place)
{
  const PatchPoint &point = curves.points[place.point - 1];
  const PatchValues *values = &point;
  std::string when = fmt::format("point {}", place.point);
  double speed = point.speed;
  if (place.instant > 0) {
    const std::vector<PatchStep> &steps = curves.series.at(place.point);
    const PatchStep &step = steps.at(stepAt(steps, asked.sequence.fields[place.instant - 1]));
    values = &step;
    speed = step.speed;
    when += fmt::format(" at {:g} s", step.time);
  }
  const Creepage &c = values->creepage;
  if (asked.mode == PatchMode::Static)
    return fmt::format("{}: load {:g} N, shift {:g} mm, lateral {:g} mm, twist {:g}", when,
                       values->load, c.xi / mm, c.eta / mm, c.phi);
  return fmt::format("{}: load {:g} N, creep {:g}, lateral {:g}, spin {:g} 1/mm, {:g} m/s", when,
                     values->load, c.xi, c.eta, c.phi / perMm, speed);
}

} // namespace

void addFields(ResultFiles &files, const PatchSpecification &asked, const PatchCurves &curves)
{
  const std::vector<PatchTask> tasks = patchTasks(asked);
  for (const auto &[number, si] : curves.fields) {
    const FieldPlace place = fieldPlace(number, static_cast<int>(tasks.size()));
    PatchGrid grid = curves.contacts[tasks[place.point - 1].contact].grid;
    for (double *length : {&grid.dx, &grid.dy, &grid.left, &grid.bottom})
      *length /= mm;
    PatchFields fields = si;
    fields.gap /= mm;
    fields.pressure /= MPa;
    fields.traction.x /= MPa;
    fields.traction.y /= MPa;
    fields.slipIsShift = asked.mode == PatchMode::Static;
    if (fields.slipIsShift) {
      fields.slip.x /= mm;
      fields.slip.y /= mm;
    }
    addFieldFiles(files.files(), files.pathOf(fieldStem(place)), grid, fields, files.head(),
                  fieldTitle(asked, curves, place));
  }
}

std::vector<PolachPoint> polachPoints(const PatchCurves &curves)
{
  std::vector<PolachPoint> points;
  for (const PatchPoint &p : curves.points)
    if (p.converged())
      points.push_back({{p.creepage.xi, p.creepage.eta, p.creepage.phi / perMm, p.speed, p.load},
                        p.forceX,
                        p.forceY});
  return points;
}

PolachContact polachContact(const PatchCurves &curves)
{
  const PatchContact &first = curves.contacts.front();
  return {first.pair.G / MPa, first.hertz.a / mm, first.hertz.b / mm, first.load,
          ellipseKalkerCoefficients(first.hertz.a / first.hertz.b, first.pair.nu)};
}

} // namespace wheelrail
