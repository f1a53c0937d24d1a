// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_sequence.h"

#include "base/si.h"

#include <algorithm>
#include <cmath>

namespace wheelrail {
namespace {

/// Is a step the nearest to an instant, if no earlier one is? The next one ends at `next`.
bool standsFor(double end, double next, double instant)
{
  return end + 0.5 * (next - end) >= instant;
}

double shiftX(const PatchStep &step)
{
  return step.creepage.xi;
}
double shiftY(const PatchStep &step)
{
  return step.creepage.eta;
}
double ratioOf(const PatchStep &step)
{
  return step.tractionRatio();
}

} // namespace

double PatchSequence::lastOf(const std::vector<double> &values) const
{
  return held && values.size() > 1 ? values[values.size() - 2] : values.back();
}

double PatchSequence::at(const std::vector<double> &values, double seconds, double constant) const
{
  if (values.empty())
    return constant;
  constexpr double rounding = 1e-9; // of a time that follows from a distance and speeds
  const double until = held ? seconds * (1.0 - rounding) : seconds;
  const auto after = std::upper_bound(time.begin(), time.end(), until);
  if (after == time.begin())
    return values.front();
  if (after == time.end())
    return lastOf(values);
  const auto k = static_cast<std::size_t>(after - time.begin());
  if (held)
    return values[k - 1];
  const double part = (seconds - time[k - 1]) / (time[k] - time[k - 1]);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

double PatchSequence::distanceAt(double seconds, double constant) const
{
  if (speed.empty())
    return seconds * constant;
  double distance = 0.0;
  for (std::size_t k = 0; k + 1 < time.size() && time[k] < seconds; ++k) {
    const double end = std::min(seconds, time[k + 1]),
                 slope = (speed[k + 1] - speed[k]) / (time[k + 1] - time[k]);
    const double last = held ? speed[k] : speed[k] + slope * (end - time[k]);
    distance += 0.5 * (speed[k] + last) * (end - time[k]);
  }
  return distance + std::max(0.0, seconds - time.back()) * lastOf(speed);
}

// On each stretch the speed is v + a t: a t^2/2 + v t is the distance, in the form that holds for
// v = 0 and for a = 0.
double PatchSequence::timeAt(double distance, double constant) const
{
  if (speed.empty())
    return distance / constant;
  double left = distance;
  for (std::size_t k = 0; k + 1 < time.size(); ++k) {
    const double length = time[k + 1] - time[k];
    const double slope = held ? 0.0 : (speed[k + 1] - speed[k]) / length;
    const double stretch = (speed[k] + 0.5 * slope * length) * length;
    if (left <= stretch) {
      const double square = std::max(0.0, speed[k] * speed[k] + 2.0 * slope * left);
      return time[k] + (left > 0.0 ? 2.0 * left / (speed[k] + std::sqrt(square)) : 0.0);
    }
    left -= stretch;
  }
  return time.back() + (left > 0.0 ? left / lastOf(speed) : 0.0);
}

double PatchStep::tractionRatio() const
{
  return std::hypot(forceX, forceY) / load;
}

const std::vector<Column<PatchStep>> &seriesColumns()
{
  static const std::vector<Column<PatchStep>> table = [] {
    using S = PatchStep;
    std::vector<Column<S>> columns;
    const auto add = [&](Column<S> column, Written series, Written stages) {
      column.still = nowhere; // static.csv has points
      column.series = series;
      column.stages = stages;
      columns.push_back(std::move(column));
    };
    add({"distance", "mm", mm, "rolled at the end of the step", kept<&S::distance>}, following(8),
        nowhere);
    add({"time", "s", 1.0, "at the end of the step; of the stage", kept<&S::time>}, following(8),
        leading(8));
    add({"speed", "m/s", 1.0, "rolling speed of the step", kept<&S::speed>}, following(6), nowhere);
    for (const Column<PatchValues> &value : patchValueColumns()) {
      add(columnOf<S>(value), value.series, value.still);
      if (value.name != "load")
        continue;
      add({"shift_x", "mm", mm, "", derived<S>(shiftX)}, nowhere, leading(10));
      add({"shift_y", "mm", mm, "", derived<S>(shiftY)}, nowhere, leading(10));
      add({"traction_ratio", "1", 1.0, "", derived<S>(ratioOf)}, nowhere, leading(10));
    }
    add({"driving_power", "W", 1.0, "", kept<&S::drivingPower>}, nowhere, nowhere);
    return columns;
  }();
  return table;
}

void PatchHistory::add(const PatchStep &step, double next, const PatchSequence &sequence,
                       const PatchFields &state)
{
  steps.push_back(step);
  while (fields.size() < sequence.fields.size() &&
         standsFor(step.time, next, sequence.fields[fields.size()]))
    fields.emplace(static_cast<int>(fields.size()) + 1, state);
}

void PatchHistory::end(const PatchSequence &sequence, const PatchFields &state)
{
  while (fields.size() < sequence.fields.size())
    fields.emplace(static_cast<int>(fields.size()) + 1, state);
}

std::size_t stepAt(const std::vector<PatchStep> &steps, double seconds)
{
  std::size_t k = 0;
  while (k + 1 < steps.size() && !standsFor(steps[k].time, steps[k + 1].time, seconds))
    ++k;
  return k;
}

} // namespace wheelrail
