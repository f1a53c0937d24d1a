// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_journal.h"

#include "creep/sweep/point_journal.h"

#include <cstring>

namespace wheelrail {
namespace {

/// All fields of a point in a fixed order but for its states; each has one value a cell.
template<class Fields, class Visit>
void eachField(Fields &f, const Visit &visit)
{
  for (auto *field : {&f.gap, &f.pressure, &f.traction.x, &f.traction.y, &f.slip.x, &f.slip.y,
                      &f.mu, &f.temperature})
    visit(*field);
}

constexpr std::size_t fieldsOfPoint = 8;

} // namespace

nlohmann::json patchPointsJson(const std::vector<PatchPoint> &points)
{
  return pointsJson(patchColumns(), points);
}

std::vector<PatchPoint> patchPointsFrom(const nlohmann::json &rows)
{
  return pointsFromJson(patchColumns(), rows);
}

nlohmann::json patchSeriesJson(const std::map<int, std::vector<PatchStep>> &series)
{
  nlohmann::json all = nlohmann::json::object();
  for (const auto &[number, steps] : series)
    all[std::to_string(number)] = journalRows(seriesColumns(), steps);
  return all;
}

std::map<int, std::vector<PatchStep>> patchSeriesFrom(const nlohmann::json &series)
{
  std::map<int, std::vector<PatchStep>> all;
  for (const auto &[number, rows] : series.items())
    all[std::stoi(number)] = pointsFrom(seriesColumns(), rows);
  return all;
}

std::string patchFieldsBytes(const PatchFields &fields)
{
  std::string bytes;
  for (PatchState state : fields.state)
    bytes.push_back(static_cast<char>(state));
  eachField(fields, [&](const Eigen::VectorXd &field) {
    const std::size_t begin = bytes.size(), size = sizeof(double) * field.size();
    bytes.resize(begin + size);
    std::memcpy(&bytes[begin], field.data(), size);
  });
  return bytes;
}

std::optional<PatchFields> patchFieldsFrom(const std::string &bytes, int cells)
{
  const auto count = static_cast<std::size_t>(cells);
  if (bytes.size() != count * (1 + fieldsOfPoint * sizeof(double)))
    return std::nullopt;
  PatchFields fields;
  for (std::size_t k = 0; k < count; ++k)
    fields.state.push_back(static_cast<PatchState>(bytes[k]));
  std::size_t begin = count;
  eachField(fields, [&](Eigen::VectorXd &field) {
    field.resize(cells);
    std::memcpy(field.data(), &bytes[begin], count * sizeof(double));
    begin += count * sizeof(double);
  });
  return fields;
}

} // namespace wheelrail
