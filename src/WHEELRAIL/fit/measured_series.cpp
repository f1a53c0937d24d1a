// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/measured_series.h"

#include "base/errors.h"
#include "base/file_ending.h"
#include "base/number_rows.h"
#include "base/statistics.h"
#include "base/text_lines.h"
#include "shared/friction_log_format.h"
#include "shared/printable.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace wheelrail {

namespace {

constexpr std::size_t leastAveraged = 4;                 // of seriesMean
constexpr std::size_t leastRows = 2 * leastAveraged - 1; // the later half has as many

/// Where both columns stand, and how many there are.
struct Columns {
  std::size_t time = 0, mu = 1, all = 2;
};

bool isNames(const std::vector<std::string_view> &cells)
{
  return std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return !cell.empty() && (std::isalpha(static_cast<unsigned char>(cell.front())) != 0);
  });
}

Columns columnsOf(const std::string &path, int line, const std::vector<std::string_view> &cells)
{
  const std::vector<std::string> names(cells.begin(), cells.end());
  const auto placeOf = [&](const std::string &name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (std::count(found, names.end(), name) > 1)
      throw badInput(path, line, "", fmt::format("column '{}' is there twice", name));
    if (found != names.end())
      return static_cast<std::size_t>(found - names.begin());
    throw badInput(path, line, "",
                   fmt::format("column '{}' is missing; the columns are '{}'", name,
                               mcawr::printable(fmt::format("{}", fmt::join(names, "', '")))));
  };
  return {placeOf("time"), placeOf("mu"), names.size()};
}

void addRow(MeasuredSeries &series, int line, double time, double mu)
{
  if (!series.time.empty()) {
    const double step = time - series.time.back();
    const double first = series.time.size() > 1 ? series.time[1] - series.time[0] : step;
    if (!(step > 0.0) || std::abs(step - first) > spacingTolerance * first)
      throw badInput(series.file, line, "time",
                     fmt::format("{:.6g} follows {:.6g}: times must rise evenly, here by {:.6g}",
                                 time, series.time.back(), first));
  }
  series.time.push_back(time);
  series.mu.push_back(mu);
}

} // namespace

bool isMeasuredSeries(const std::string &path)
{
  return fileEnding(path) == ".csv";
}

MeasuredSeries readMeasuredSeries(const std::string &path)
{
  const std::string text = readTextFile(path);
  MeasuredSeries series;
  series.file = path;
  NumberRows rows(path);
  std::optional<Columns> columns;
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    const std::string_view row = trimmedView(line);
    if (row.empty() || row.front() == '#')
      continue;
    const auto cells = rows.cells(lines.number(), row);
    if (!columns) {
      const bool named = isNames(cells);
      columns = named ? columnsOf(path, lines.number(), cells) : Columns{};
      if (named)
        continue;
    }
    if (cells.size() != columns->all)
      throw badInput(path, lines.number(), "",
                     fmt::format("{} columns, {} are expected{}", cells.size(), columns->all,
                                 rows.decimalHint()));
    const auto at = [&](const char *name, std::string_view cell) {
      const double x = rows.number(lines.number(), name, cell);
      if (std::abs(x) > mcawr::friction_log::largest)
        throw badInput(path, lines.number(), name,
                       fmt::format("'{}' is not allowed, must be within +-{:g}", cell,
                                   mcawr::friction_log::largest));
      return x;
    };
    addRow(series, lines.number(), at("time", cells[columns->time]), at("mu", cells[columns->mu]));
  }
  if (series.mu.size() < leastRows)
    throw badInput(
        path, 0, "",
        fmt::format("{} rows of time and mu, at least {} are needed", series.mu.size(), leastRows));
  return series;
}

MeasuredMean meanOf(const MeasuredSeries &series, std::optional<double> start)
{
  MeasuredMean found;
  found.file = series.file;
  const std::size_t n = series.mu.size();
  std::size_t begin = 0;
  if (start) {
    begin = std::lower_bound(series.time.begin(), series.time.end(), *start) - series.time.begin();
    if (begin + leastAveraged > n)
      throw badInput(
          series.file, 0, "",
          fmt::format("--start {:g} leaves {} rows, at least {} are needed, the last is at "
                      "{:g}",
                      *start, n - begin, leastAveraged, series.time.back()));
    found.mean = seriesMean(series.mu, begin, n);
  } else {
    const StationaryPart part = stationaryPart(series.mu);
    begin = part.start;
    found.mean = part.mean;
    found.note = part.found ? "" : "no stationary part: " + part.reason;
  }
  found.standardError = widenedError(found.mean);
  found.start = series.time[begin];
  const double interval = (series.time.back() - series.time.front()) / static_cast<double>(n - 1);
  found.correlationTime = found.mean.correlationTime * interval;
  return found;
}

std::string textReport(const std::vector<MeasuredMean> &means)
{
  std::string text;
  for (const MeasuredMean &m : means)
    text += fmt::format("{}: mu {:.4g} +- {:.2g} (95 %, standard error {:.2g}), {} rows from time "
                        "{:.6g} on, worth {:.1f} independent ones{}\n",
                        mcawr::printable(m.file), m.mean.mean, normal95 * m.standardError,
                        m.standardError, m.mean.n, m.start, m.mean.effectiveN,
                        m.note.empty() ? "" : "; " + m.note);
  return text;
}

nlohmann::ordered_json jsonReport(const std::vector<MeasuredMean> &means)
{
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const MeasuredMean &m : means) {
    nlohmann::ordered_json one = {{"file", m.file},
                                  {"mu", m.mean.mean},
                                  {"mu_se", m.standardError},
                                  {"n_eff", m.mean.effectiveN},
                                  {"correlation_time", m.correlationTime},
                                  {"start", m.start},
                                  {"rows", m.mean.n},
                                  {"stationary", m.note.empty()}};
    if (!m.note.empty())
      one["note"] = m.note;
    all.push_back(one);
  }
  return {{"format", "mca-measured-friction 1"}, {"series", all}};
}

} // namespace wheelrail
