// SPDX-License-Identifier: GPL-2.0-or-later
#include "readers.h"

#include "memory_file.h"

#include "base/errors.h"
#include "base/program_files.h"
#include "base/quantity.h"
#include "contact/line/profile.h"
#include "contact/patch/formats/gsf_file.h"
#include "contact/patch/surfaces/height_map_preparation.h"
#include "creep/case/case_file.h"
#include "creep/line/curve_journal.h"
#include "creep/patch/measured_curve.h"
#include "creep/patch/patch_journal.h"
#include "creep/sweep/journal.h"
#include "fit/friction_log.h"
#include "fit/log_archive.h"
#include "fit/measured_series.h"
#include "law/friction_table.h"
#include "law/kappa_law.h"
#include "law/law_checksum.h"
#include "law/material_law.h"
#include "law/softening_material.h"
#include "shared/printable.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace wheelrail;

namespace {

const std::string source = PROJECT_SOURCE;

const std::string &fileWith(const std::string &bytes)
{
  static const MemoryFile file("drill");
  return file.holding(bytes);
}

/// Turns what the reader may throw into Refused.
template<class Read>
std::function<void(const std::string &)> refusing(Read read, bool isCommandLine = false)
{
  return [=](const std::string &bytes) {
    try {
      read(bytes);
    } catch (const Error &error) {
      const bool usual =
          error.code() == ExitCode::BadInput || (isCommandLine && error.code() == ExitCode::Usage);
      require(usual, fmt::format("exit code {}: {}", static_cast<int>(error.code()), error.what()));
      throw Refused(error.what());
    }
  };
}

std::string firstLines(const std::string &text, int count)
{
  std::size_t end = 0;
  while (count-- > 0 && end != std::string::npos)
    end = text.find('\n', end + 1);
  return text.substr(0, end == std::string::npos ? end : end + 1);
}

std::vector<std::string> firstLines(std::vector<std::string> texts, int count)
{
  for (std::string &text : texts)
    text = firstLines(text, count);
  return texts;
}

// ---- what the programs of wheel and rail read

KappaLaw lawWithCovariance()
{
  KappaLaw law = bucher2006();
  law.covariance = 1e-4 * LawCovariance::Identity();
  law.kappa1Range = {0.05, 18.7};
  return law;
}

void readLawFile(const std::string &bytes)
{
  const KappaLaw law = readKappaLaw(fileWith(bytes));
  const std::string text = toJson(law).dump();
  require(toJson(readKappaLaw(fileWith(text))).dump() == text, "another law when read again");
}

/// Falsified as wr_fit wrote it: the same law, or refused; without the line of its checksum noted.
void readSealedLaw(const std::string &bytes)
{
  static const std::string written = toJson(lawWithCovariance()).dump();
  const KappaLaw law = readKappaLaw(fileWith(bytes));
  require(!law.note.empty() || toJson(law).dump() == written, "another law than was written");
}

/// The two kinds that wr_fit writes: a form, a table.
std::vector<std::string> lawsOfAMaterial()
{
  MaterialLaw form;
  form.material.name = "drill";
  form.material.temperature = {293.0, 873.0};
  form.material.strength = {900e6, 300e6};
  form.material.modulus = {206e9, 60e9};
  form.material.density = 7800.0;
  form.parameters.setConstant(0.5);
  form.covariance = MaterialLaw::Covariance(1e-4 * MaterialLaw::Covariance::Identity());
  form.pressureRange = {0.1, 2.0};
  MaterialLaw table = form;
  table.covariance.reset();
  table.parameters.setZero();
  table.table.emplace();
  for (const double kelvin : form.material.temperature)
    table.table->rows.push_back({kelvin, {0.1, 1.0}, {0.4, 0.3}, {0.01, 0.02}});
  table.table->speed = {{0.1, 1.0}, {0.1, 0.05}, {0.01, 0.01}, {1.0, 5.0}, 5.0};
  table.speedRange = {1.0, 5.0};
  return {toJson(form).dump(2) + "\n", toJson(table).dump(2) + "\n"};
}

/// As `readLawFile`.
void readLawOfAMaterial(const std::string &bytes)
{
  const MaterialLaw law = readMaterialLaw(fileWith(bytes));
  const std::string text = toJson(law).dump();
  require(toJson(readMaterialLaw(fileWith(text))).dump() == text, "another law when read again");
}

void readMaterialFile(const std::string &bytes)
{
  const SofteningMaterial material = readPotentialFile(fileWith(bytes));
  for (const double kelvin : material.temperature)
    require(material.strengthAt(kelvin) > 0.0 && material.modulusAt(kelvin) > 0.0 &&
                std::isfinite(material.density),
            "a material without strength");
}

void readTableOfFriction(const std::string &bytes)
{
  const FrictionTable table = readFrictionTable(fileWith(bytes));
  for (const double p : table.pressure)
    for (const double v : table.speed)
      require(table(p, v) > 0.0 && table(p, v) <= 10.0, "a friction coefficient that is none");
}

void readCurveOfTraction(const std::string &bytes)
{
  for (const MeasuredTraction &point : readMeasuredCurve(fileWith(bytes)))
    require(point.creep > 0.0 && point.speed > 0.0 && point.tractionRatio > 0.0 &&
                std::isfinite(point.creep + point.speed + point.tractionRatio),
            "a value of a traction curve that is none");
}

void readSeriesOfFriction(const std::string &bytes)
{
  const MeasuredSeries series = readMeasuredSeries(fileWith(bytes));
  require(series.time.size() == series.mu.size() && series.mu.size() >= 7,
          "columns of unlike length");
  const MeasuredMean found = meanOf(series, {});
  require(std::isfinite(found.mean.mean) && std::isfinite(found.standardError) &&
              found.standardError >= 0.0,
          "a mean that is none");
}

void readCaseFile(const std::string &bytes)
{
  const std::string text = readCase(fileWith(bytes)).text;
  require(readCase(fileWith(text)).text == text, "another case when read again:\n" + text);
}

/// Line and point contacts, as shipped and with every default.
std::vector<std::string> cases()
{
  std::vector<std::string> texts = filesOf("examples/wheelrail", ".yaml");
  for (std::size_t k = 0, shipped = texts.size(); k < shipped; k++)
    texts.push_back(readCase(fileWith(texts[k])).text);
  return texts;
}

void readCaseChange(const std::string &bytes)
{
  static const MemoryFile good("case");
  static const std::string path =
      good.holding(readInputFile(source + "/examples/wheelrail/table2.yaml"));
  const std::string text = readCase(path, {bytes}).text;
  require(readCase(fileWith(text)).text == text, "another case when read again");
}

void readSurfaceProfile(const std::string &bytes)
{
  const Profile profile = readProfile(fileWith(bytes));
  require(profile.spacing > 0.0 && std::isfinite(profile.length()) && profile.height.size() >= 16 &&
              profile.height.allFinite(),
          "a profile with a spacing or heights that are none");
}

void readMap(const std::string &bytes, const HeightMapScale &scale)
{
  const HeightMap map = readHeightMap(fileWith(bytes), scale);
  require(map.nx >= 4 && map.ny >= 4 &&
              map.height.size() == static_cast<Eigen::Index>(map.nx) * map.ny && map.dx > 0.0 &&
              map.dy > 0.0 && std::isfinite(map.dx) && std::isfinite(map.dy),
          "a map without size or spacing");
  for (const double height : map.height)
    require(!std::isinf(height), "a map with an infinite height");
}

void readLog(const std::string &bytes)
{
  const FrictionLog log = readFrictionLog(fileWith(bytes));
  require(log.mu.size() == log.step.size() && log.time.size() == log.step.size(),
          "columns of unlike length");
  for (std::size_t k = 0; k < log.step.size(); k++)
    require(std::isfinite(log.mu[k]) && std::isfinite(log.time[k]) &&
                (k == 0 || log.step[k] > log.step[k - 1]),
            "a row that is none");
  require(std::isfinite(log.kappa1()) && std::isfinite(log.kappa2()) && std::isfinite(log.kappa3()),
          "a kappa that is no number");
}

/// A tar file of two logs: heads of members (names, sizes, checksums) and contents in whole blocks.
std::string tarOfLogs(const std::string &log)
{
  constexpr std::size_t block = 512;
  std::string tar;
  for (const char *name : {"a.friction", "b.friction"}) {
    std::string head(block, '\0');
    const auto set = [&](std::size_t at, const std::string &text) {
      head.replace(at, text.size(), text);
    };
    set(0, name);
    set(100, "0000644");
    set(108, "0000000");
    set(116, "0000000");
    set(124, fmt::format("{:011o}", log.size()));
    set(136, "00000000000");
    set(156, "0");
    set(257, "ustar");
    set(263, "00");
    set(148, std::string(8, ' '));
    unsigned sum = 0;
    for (const char c : head)
      sum += static_cast<unsigned char>(c);
    set(148, fmt::format("{:06o}", sum) + std::string(1, '\0'));
    tar += head + log;
    tar.resize((tar.size() + block - 1) / block * block, '\0');
  }
  return tar + std::string(2 * block, '\0');
}

const std::string shippedArchive = source + "/examples/campaign/logs/temperature.tar.xz";

/// Behind the checksums of xz: the logs that were packed.
void readArchive(const std::string &bytes)
{
  static const auto packed = readLogArchive(shippedArchive);
  require(readLogArchive(fileWith(bytes)) == packed, "other logs than were packed");
}

/// Logs are texts of any kind here: each is a part of the archive.
void readTar(const std::string &bytes)
{
  for (const auto &[name, text] : logsOfTar("drill.tar.xz", bytes)) {
    require(name.find('/') == std::string::npos, "a name with a slash");
    require(text.size() <= bytes.size(), "a log that is larger than the archive");
  }
}

Journal::Pieces piecesOfAJournal()
{
  Journal::Pieces pieces;
  for (std::size_t k = 0; k < 3; k++)
    pieces[k] = {{10.0, 0.001 * static_cast<double>(k + 1), 0.3, 1.2e6, 0.4, 12.5, 33.0, 7, 0.25, 0,
                  0.0, 0.0, 0.0}};
  return pieces;
}

std::string journalBytes(const Journal::Pieces &pieces)
{
  const MemoryFile file("journal");
  Journal journal(file.path, "the case", [](const std::string &) {});
  for (const auto &[number, results] : pieces)
    journal.add(number, results);
  journal.write();
  return readInputFile(file.path);
}

/// Whatever stands there: the pieces that were written, or some of them and a warning.
void readJournalFile(const std::string &bytes)
{
  static const Journal::Pieces written = piecesOfAJournal();
  std::string warning;
  Journal journal(fileWith(bytes), "the case", [&](const std::string &line) { warning = line; });
  const Journal::Pieces found = journal.load();
  for (const auto &[number, results] : found) {
    const auto piece = written.find(number);
    require(piece != written.end() && piece->second == results,
            fmt::format("another piece than was written: {}", number));
  }
  if (!warning.empty())
    throw Refused(warning);
}

/// Points and time series of a piece, as a journal holds them for a point contact.
std::string patchPiece()
{
  PatchPoint point;
  point.surface = 1;
  point.iterations = 12;
  point.load = 1e5;
  point.creepage.xi = 1.0 / 3.0;
  PatchStep step;
  step.distance = 0.25;
  return nlohmann::json{{"points", patchPointsJson({point, point})},
                        {"series", patchSeriesJson({{3, {step, step}}})}}
      .dump();
}

/// As a sweep takes over a piece whose checksum fits: what it throws there is another kind of
/// piece.
void readPatchPoints(const std::string &bytes)
{
  const auto json = nlohmann::json::parse(bytes, nullptr, false);
  try {
    const auto points = patchPointsFrom(json.at("points"));
    const auto series = patchSeriesFrom(json.at("series"));
    require(patchPointsFrom(patchPointsJson(points)).size() == points.size() &&
                patchSeriesFrom(patchSeriesJson(series)).size() == series.size(),
            "other points when read again");
  } catch (const nlohmann::json::exception &error) {
    throw Refused(mcawr::printable(error.what()));
  } catch (const std::logic_error &) {
    throw Refused("a key that is no number");
  }
}

/// Points of a piece of a contact along a line.
std::string curvePiece()
{
  CurvePoint point;
  point.speed = 10.0;
  point.creep = 1.0 / 3.0;
  point.iterations = 7;
  CurvePoint failed;
  failed.failure = "no convergence";
  return curvePointsJson({point, failed}).dump();
}

/// As `readPatchPoints`.
void readCurvePoints(const std::string &bytes)
{
  try {
    const auto points = curvePointsFrom(nlohmann::json::parse(bytes, nullptr, false));
    require(curvePointsFrom(curvePointsJson(points)).size() == points.size(),
            "other points when read again");
  } catch (const nlohmann::json::exception &error) {
    throw Refused(mcawr::printable(error.what()));
  }
}

void readQuantity(const std::string &bytes)
{
  try {
    require(std::isfinite(parseQuantity(bytes, "N/m")), "a quantity that is not finite");
  } catch (const std::invalid_argument &error) {
    throw Refused(mcawr::printable(error.what())); // as every Error makes it
  }
}

} // namespace

std::vector<std::string> filesOf(const std::string &folder, const std::string &ending)
{
  std::vector<std::string> paths, contents;
  for (const auto &entry : std::filesystem::directory_iterator(source + "/" + folder))
    if (entry.path().extension() == ending)
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const std::string &path : paths)
    contents.push_back(readInputFile(path));
  return contents;
}

std::vector<Reader> wheelrailReaders()
{
  const HeightMapScale micrometres{2e-6, 3e-6, 1e-6};
  SimpleField field;
  field.nx = 5;
  field.ny = 4;
  field.width = 10e-6;
  field.height = 12e-6;
  field.xyUnit = field.zUnit = "m";
  field.title = "drill";
  field.value = Eigen::VectorXd::LinSpaced(20, -1e-6, 1e-6);
  field.value[13] = std::numeric_limits<double>::quiet_NaN();
  const std::string sdf =
      "aISO-1.0\r\nManufacID = ISOTC213\r\nCreateDate = 040120220853\r\nModDate = 050320231353\r\n"
      "NumPoints = 5\r\nNumProfiles = 4\r\nXscale = 2.0e-006\r\nYscale = 3.0e-006\r\n"
      "Zscale = 1.0e-006\r\nZresolution = 1.0e-009\r\nCompression = 0\r\nDataType = 7\r\n"
      "CheckType = 0\r\n*\r\n 0.0 1.0 2.0 3.0 4.0\r\n1e1 11 12 13 14\r\n20 21 22 BAD\r\n 24 +30 "
      "31\r\n32 33 34 ; the last ones\r\n*\r\nOperator = nobody\r\n*\r\n";
  const std::string matrix = "# measured on a rail\n# height: um\n# spacing: 2 um, 3 um\n"
                             "# points: 5, 4\n0;1;2;3;4\n10; 11; 12; 13; 14\n20 ;21 ;22 ;nan ;24\n"
                             "30;31;32;33;34\n";
  const std::string european =
      "\xef\xbb\xbf# height: \xb5m\r\n# spacing: 2 mm\r\n# rows: upwards\r\n"
      "0,5\t1\t2\t3\r\n1\t1,5\t2\t3\r\n0\t0\t0\t-1,5\r\n1\t2\t3\t4\r\n";
  const std::string tableText = "# pressure: MPa\n# speed: m/s\npressure,speed,mu\n100,0.1,0.5\n"
                                "100,1,0.4\n900,0.1,0.3\n900,1,0.25\n";
  const std::string curveText = "# speed: km/h\n# creep: %\ncreep;speed;traction_ratio\n"
                                "0,5;36;0,21\n1;36;0,3\n2,5;36;0,28\n";
  std::string seriesText = "# of a tribometer\ntime,force,mu\n", europeanSeries;
  for (int k = 0; k < 40; ++k) {
    seriesText += fmt::format("{},{},0.{}\n", 0.5 * k, 10 + k % 3, 40 + k * k % 7);
    europeanSeries += fmt::format("{},5;0,{}\r\n", k, 40 + k * k % 7);
  }
  std::string points;
  for (int k = 0; k < 20; ++k)
    points += fmt::format("{} {} {}\n", k % 5, k / 5, 0.1 * k);
  const auto map = [](const HeightMapScale &scale) {
    return refusing([=](const std::string &bytes) { readMap(bytes, scale); });
  };
  std::vector<std::string> logs;
  for (const auto &[name, text] :
       readLogArchive(source + "/examples/campaign/logs/pressure.tar.xz"))
    logs.push_back(text);
  logs = firstLines(logs, 30);
  const auto profiles = firstLines(filesOf("examples/wheelrail", ".csv"), 40);
  std::vector<std::string> columns = profiles;
  columns.emplace_back(
      "# height: um\n# spacing: 5 um\n1\n2\n3\n4\n5\n6\n7\n8\n9\n8\n7\n6\n5\n4\n3\n"
      "2\n1\n");
  return {
      {"law",
       {toJson(bucher2006()).dump(2) + "\n", toJson(lawWithCovariance()).dump(2) + "\n"},
       refusing(readLawFile)},
      {"sealed_law",
       {withChecksum(toJson(lawWithCovariance()).dump(2) + "\n")},
       refusing(readSealedLaw)},
      {"material_law", lawsOfAMaterial(), refusing(readLawOfAMaterial)},
      {"material", filesOf("potentials", ".mca"), refusing(readMaterialFile)},
      {"friction_table", {tableText}, refusing(readTableOfFriction)},
      {"traction_curve", {curveText}, refusing(readCurveOfTraction)},
      {"friction_series", {seriesText, europeanSeries}, refusing(readSeriesOfFriction)},
      {"case", cases(), refusing(readCaseFile)},
      {"case_change",
       {"speed=20 m/s", "creep=[0.001, 0.01, 5 %]", "contact.radius=460 mm", "cells=64",
        "roughness={hurst: 0.8, rms_slope: 0.02, wavelength_min: 0.1 mm, wavelength_max: 10 mm, "
        "seed: [1, 2]}",
        "friction={law: constant, mu: 0.3}", "thermal=off"},
       refusing(readCaseChange, true)},
      {"profile", columns, refusing(readSurfaceProfile)},
      {"gsf", {gsfBytes(field)}, map({})},
      {"sdf", {sdf}, map({})},
      {"binary_sdf", filesOf("unittest/WHEELRAIL/data/maps", ".sdf"), map({})},
      {"sur", filesOf("unittest/WHEELRAIL/data/maps", ".sur"), map({})},
      {"x3p", filesOf("unittest/WHEELRAIL/data/maps", ".x3p"), map({})},
      {"points", {"# height: um\n# position: mm\n" + points}, map({})},
      {"matrix", {matrix, european}, map({})},
      {"npy", filesOf("unittest/WHEELRAIL/data/maps", ".npy"), map(micrometres)},
      {"friction_log", logs, refusing(readLog)},
      {"archive", {readInputFile(shippedArchive)}, refusing(readArchive)},
      {"sealed_archive", {tarOfLogs(logs.front())}, refusing(readTar)},
      {"journal", {journalBytes(piecesOfAJournal())}, refusing(readJournalFile)},
      {"curve_points", {curvePiece()}, readCurvePoints},
      {"patch_points", {patchPiece()}, readPatchPoints},
      {"quantity", {"4000 N/mm", "1.5e3 kN/m", "-3 N/m", "7 lbf/inch"}, readQuantity},
  };
}
