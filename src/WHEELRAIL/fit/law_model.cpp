// SPDX-License-Identifier: GPL-2.0-or-later
#include "fit/law_model.h"

#include <algorithm>
#include <string>
#include <vector>

namespace wheelrail {

namespace {

/// A model by its name and the parameters that it fits.
struct ModelRow {
  LawModel model;
  const char *name;
  std::vector<LawParameter> parameters;
};

const ModelRow &rowOf(LawModel model)
{
  static const std::vector<ModelRow> rows = {
      {LawModel::Constant, "constant", {Mu0}},
      {LawModel::Velocity, "velocity", {Mu0, Mu1, B}},
      {LawModel::Pressure, "eq4", {Mu0, Mu2, C}},
      {LawModel::VelocityKappa3, "velocity_kappa3", {Mu0, Mu1, B, N}},
      {LawModel::Full, "eq2", {Mu0, Mu1, Mu2, B, C}},
      {LawModel::Kappa3, "eq2_kappa3", {Mu0, Mu1, Mu2, B, C, N}},
      {LawModel::Ductility, "eq2_ductility", {Mu0, Mu1, Mu2, B, C, N}},
      {LawModel::Bounded, "bounded", {Mu0, S, Q}},
      {LawModel::BoundedKappa3, "bounded_kappa3", {Mu0, N, S, Q}},
      {LawModel::BoundedRate, "bounded_rate", {Mu0, S, Q, S1, D}},
      {LawModel::BoundedVelocity, "bounded_velocity", {Mu0, Mu1, B, S, Q}},
      {LawModel::BoundedPressure, "bounded_eq4", {Mu0, Mu2, C, S, Q}},
      {LawModel::BoundedFull, "bounded_eq2", {Mu0, Mu1, Mu2, B, C, S, Q}}};
  return *std::find_if(rows.begin(), rows.end(),
                       [model](const ModelRow &row) { return row.model == model; });
}

} // namespace

const char *nameOf(LawModel model)
{
  return rowOf(model).name;
}

std::array<bool, fitParameters> parametersOf(LawModel model)
{
  std::array<bool, fitParameters> free = {};
  for (const LawParameter parameter : rowOf(model).parameters)
    free[parameter] = true;
  return free;
}

ThirdNumber thirdNumberOf(LawModel model)
{
  if (!parametersOf(model)[N])
    return ThirdNumber::None;
  return model == LawModel::Ductility ? ThirdNumber::Ductility : ThirdNumber::Kappa3;
}

const char *nameOf(ThirdNumber number)
{
  return number == ThirdNumber::Ductility ? "ductility" : "kappa3";
}

double valueOf(ThirdNumber number, const ConditionMean &mean)
{
  if (number == ThirdNumber::None)
    return 1.0;
  return number == ThirdNumber::Ductility ? mean.ductility : mean.kappa3;
}

bool isBounded(LawModel model)
{
  return parametersOf(model)[S];
}

} // namespace wheelrail
