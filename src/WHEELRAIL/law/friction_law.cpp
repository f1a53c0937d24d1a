// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/friction_law.h"

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace wheelrail {

namespace {

constexpr const char *noCovariance = "a law without a covariance has no parameters to vary";

} // namespace

LawPointer FrictionLaw::changed(const Eigen::VectorXd & /*change*/) const
{
  throw std::logic_error(noCovariance);
}

double FrictionLaw::variance(const Eigen::VectorXd & /*derivative*/) const
{
  throw std::logic_error(noCovariance);
}

LawDraws FrictionLaw::draws() const
{
  throw std::logic_error(noCovariance);
}

nlohmann::ordered_json toJson(const FrictionLaw &law, const LawUse &use)
{
  const std::vector<LawInput> inputs = law.inputs();
  std::map<std::string, Range> byKey;
  for (std::size_t k = 0; k < use.ranges.size(); ++k)
    byKey[inputs[k].key] = use.ranges[k];
  return byKey;
}

} // namespace wheelrail
