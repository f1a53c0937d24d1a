// SPDX-License-Identifier: GPL-2.0-or-later
/// \file table.h
/// friction.law FILE.csv: a table mu(p, v), measured or computed elsewhere, read by
/// law/friction_table.h.
#ifndef WHEELRAIL_LAW_FORMS_TABLE_H
#define WHEELRAIL_LAW_FORMS_TABLE_H

#include "base/file_ending.h"
#include "law/friction_table.h"
#include "law/law_choice.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace wheelrail {

class TableLaw : public FrictionLaw {
 public:
  static constexpr const char *word = ".csv";
  static constexpr const char *named = "a table (.csv)";

  static std::vector<LawKeyword> keywords() { return {}; }
  static bool isNamedBy(const LawName &name) { return fileEnding(name.word) == word; }
  static LawChoice choose(const LawValues &values)
  {
    const std::string path = values.name.path;
    LawChoice choice;
    choice.read = [path] { return std::make_shared<TableLaw>(path, readFrictionTable(path)); };
    choice.files = {path};
    choice.cellwise = CellwiseMu{"friction.law", "no table"};
    return choice;
  }

  /// \param path where it was read from, for messages
  TableLaw(std::string path, FrictionTable table) : path_(std::move(path)), table_(std::move(table))
  {
  }

  /// With the pressure of each cell and the sliding speed of the contact.
  Eigen::VectorXd mu(const FrictionState &state) const override
  {
    Eigen::VectorXd mu(state.pressure.size());
    for (Eigen::Index i = 0; i < mu.size(); ++i)
      mu[i] = table_(state.pressure[i], std::abs(state.slidingSpeed));
    return mu;
  }
  bool dependsOnSpeed() const override { return true; }
  bool dependsOnTemperature() const override { return false; }

  std::vector<LawInput> inputs() const override
  {
    return {{"pressure_MPa", "pressure in MPa", pressures()},
            {"sliding_speed_m_s", "sliding speed in m/s", speeds()}};
  }
  LawUse use(const FrictionState &state) const override
  {
    std::vector<double> load;
    for (const double pressure : state.pressure)
      if (pressure > 0.0)
        load.push_back(pressure);
    if (load.empty())
      return {};
    const Range pressure = loadedRange(load, load);
    const double speed = std::abs(state.slidingSpeed);
    return {{{pressure[0] / MPa, pressure[1] / MPa}, {speed, speed}}};
  }
  std::string warning(const LawUse &use) const override
  {
    constexpr double rounding = 1e-9;
    const std::string outside = outsideOf(inputs(), use, rounding);
    if (outside.empty())
      return "";
    return fmt::format("friction.law {}: the contact needs more than the table has (in brackets): "
                       "{}; beyond it the values of its border are taken",
                       path_, outside);
  }
  nlohmann::ordered_json json() const override
  {
    return {{"format", "table"},
            {"source", path_},
            {"pressure_MPa", pressures()},
            {"speed_m_s", speeds()},
            {"mu", {table_.mu.minCoeff(), table_.mu.maxCoeff()}}};
  }

 private:
  static constexpr double MPa = 1e6;

  Range pressures() const { return {table_.pressure.front() / MPa, table_.pressure.back() / MPa}; }
  Range speeds() const { return {table_.speed.front(), table_.speed.back()}; }

  std::string path_;
  FrictionTable table_;
};

} // namespace wheelrail
#endif
