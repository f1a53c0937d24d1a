// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/temperature_factor.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace wheelrail {
namespace {

class HeatedLaw : public FrictionLaw {
 public:
  HeatedLaw(LawPointer cold, const TemperatureFactor &factor)
      : cold_(std::move(cold)), factor_(factor)
  {
  }

  Eigen::VectorXd mu(const FrictionState &state) const override
  {
    Eigen::VectorXd mu = cold_->mu(state);
    for (Eigen::Index i = 0; i < mu.size(); ++i)
      mu[i] *= factor_.at(state.temperature[i]);
    return mu;
  }
  bool dependsOnTemperature() const override { return true; }
  bool growsWithTemperature() const override { return factor_.hot > 1.0; }
  nlohmann::ordered_json json() const override
  {
    nlohmann::ordered_json json = cold_->json();
    json["temperature_factor"] = {
        {"hot", factor_.hot}, {"start_K", factor_.start}, {"end_K", factor_.end}};
    return json;
  }
  LawPointer changed(const Eigen::VectorXd &change) const override
  {
    return heatedLaw(cold_->changed(change), factor_);
  }
  LawDraws draws() const override
  {
    return [cold = cold_->draws(), factor = factor_](const Eigen::VectorXd &normal) {
      return heatedLaw(cold(normal), factor);
    };
  }

  bool dependsOnSpeed() const override { return cold_->dependsOnSpeed(); }
  bool dependsOnStrength() const override { return cold_->dependsOnStrength(); }
  const Strength *strength() const override { return cold_->strength(); }
  std::vector<LawInput> inputs() const override { return cold_->inputs(); }
  LawUse use(const FrictionState &state) const override { return cold_->use(state); }
  std::string warning(const LawUse &use) const override { return cold_->warning(use); }
  std::string note() const override { return cold_->note(); }
  Eigen::VectorXd standardErrors() const override { return cold_->standardErrors(); }
  double variance(const Eigen::VectorXd &derivative) const override
  {
    return cold_->variance(derivative);
  }
  bool isDefined() const override { return cold_->isDefined(); }
  bool isSound() const override { return cold_->isSound(); }
  const char *soundness() const override { return cold_->soundness(); }

 private:
  LawPointer cold_;
  TemperatureFactor factor_;
};

} // namespace

double TemperatureFactor::at(double rise) const
{
  return 1.0 + (hot - 1.0) * std::clamp((rise - start) / (end - start), 0.0, 1.0);
}

LawPointer heatedLaw(LawPointer cold, const TemperatureFactor &factor)
{
  return std::make_shared<HeatedLaw>(std::move(cold), factor);
}

} // namespace wheelrail
