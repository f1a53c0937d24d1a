// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/online/online_contact.h"

#include "base/errors.h"
#include "creep/case/case_reader.h"
#include "creep/case/common_groups.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace wheelrail {
namespace {

/// Forces are off by less than 1e-5 of what friction carries, mostly by 1e-6, where the cells' own
/// error is 1e-3 to 1e-2; a tenth of it takes half as much time again.
TangentialOptions onlineOptions()
{
  TangentialOptions options;
  options.tolerance = 5e-5;
  options.followsSteps = true;
  return options;
}

[[noreturn]] void refuse(const std::string &what, const std::string &needed)
{
  throw Error(ExitCode::BadInput,
              fmt::format("{}: a contact that is asked step by step {}", what, needed));
}

/// The specification with its largest load only: the one whose box is used.
PatchSpecification pointContactOf(const Case &input)
{
  const auto *asked = std::get_if<PatchSpecification>(&input.task);
  if (!asked)
    refuse("contact", "is a point contact (contact.load without contact.width)");
  if (!asked->contact.approach.empty())
    refuse("contact.approach", "needs contact.load in its place");
  if (asked->mode != PatchMode::Frozen)
    refuse("mode", "needs frozen");
  if (!asked->forceX.empty() || !asked->forceY.empty())
    refuse("force", "needs creepages in its place");
  if (asked->roughness.surfaces() > 1)
    refuse("roughness", fmt::format("has one surface; {} are given", asked->roughness.surfaces()));
  PatchSpecification one = *asked;
  one.contact.load = {*std::max_element(one.contact.load.begin(), one.contact.load.end())};
  return one;
}

PatchContact firstContact(const PatchSpecification &asked, const FrictionLaw &law)
{
  return preparePatch(asked.contact, asked.roughness, asked.contact.load.front(), 0,
                      asked.physics.pressureLimit(law, 0.0), 0.0);
}

std::vector<Column<PatchPoint>> columnsOf(const PatchSpecification &asked)
{
  const bool wears = asked.physics.wear.kind != WearLaw::Kind::None;
  std::vector<Column<PatchPoint>> columns;
  for (const Column<PatchPoint> &column : patchColumns())
    if (column.creep.digits > 0 || (wears && column.wear.digits > 0))
      columns.push_back(column);
  return columns;
}

/// \return the value, or 0 where the keyword takes it for 0
double allowed(const char *name, double value)
{
  const Keyword &keyword = *findKeyword(name);
  if (!(value >= keyword.low && value <= keyword.high))
    throw Error(ExitCode::Usage, fmt::format("{}: '{}' is not in the allowed range {}", name, value,
                                             rangeOf(keyword)));
  return std::abs(value) < -keyword.smallest ? 0.0 : value;
}

} // namespace

OnlineContact::OnlineContact(const Case &input)
    : asked_(pointContactOf(input)), columns_(columnsOf(asked_)), law_(asked_.friction.read()),
      contact_(firstContact(asked_, *law_)), space_(contact_.grid, contact_.pair),
      load_(contact_.load),
      speed_(asked_.speed.front()), creepage_{asked_.creep.front(), asked_.lateral.front(),
                                              asked_.spin.front()}
{
}

void OnlineContact::set(const Creepage &creepage, double load, double speed)
{
  const Creepage newCreepage = {allowed("creep", creepage.xi), allowed("lateral", creepage.eta),
                                allowed("spin", creepage.phi)};
  const double newLoad = allowed("contact.load", load), newSpeed = allowed("speed", speed);
  if (newLoad != load_)
    requireCells(newLoad);
  creepage_ = newCreepage;
  load_ = newLoad;
  speed_ = newSpeed;
}

/// Means over the nominal ellipse would say nothing: what a case is refused for, too.
void OnlineContact::requireCells(double load) const
{
  const HertzEllipse hertz = asked_.contact.hertz(load);
  const double across = 2.0 * std::min(hertz.a / contact_.grid.dx, hertz.b / contact_.grid.dy);
  if (across < fewestCellsAcross)
    throw Error(ExitCode::BadInput,
                fmt::format("contact.load: {:g} N: {:.3g} cells for the width of the contact of "
                            "{:.4g} x {:.4g} mm; at least {} are needed",
                            load, across, 2e3 * hertz.a, 2e3 * hertz.b, fewestCellsAcross));
}

/// The normal contact under the load that is set: it starts from the pressure before, which is the
/// answer but for the cells at its edge.
void OnlineContact::press()
{
  NormalContactOptions options;
  options.start = contact_.normal.pressure * (load_ / contact_.load);
  NormalContactResult normal = solveNormalContact(
      space_, contact_.problem(asked_.physics.pressureLimit(*law_, 0.0), load_), options);
  checkInsideBox(contact_.grid, normal.pressure);
  contact_.normal = std::move(normal);
  contact_.load = load_;
  contact_.hertz = asked_.contact.hertz(load_);
  if (patch_)
    patch_->pressAnew();
}

const PatchPoint &OnlineContact::step()
{
  PatchDrive drive;
  drive.creepage = creepage_;
  try {
    if (load_ != contact_.load)
      press();
    if (!patch_)
      patch_.emplace(asked_.physics, contact_, asked_.contact.spinPoint, onlineOptions());
    point_ = patch_->solve(*law_, speed_, drive);
  } catch (...) {
    patch_.reset();
    throw;
  }
  return point_;
}

void OnlineContact::requireStep() const
{
  if (!patch_)
    throw Error(ExitCode::Usage, "there is no result: no step was made, or the last one failed");
}

const PatchPoint &OnlineContact::point() const
{
  requireStep();
  return point_;
}

const PatchFields &OnlineContact::fields() const
{
  requireStep();
  return patch_->fields();
}

} // namespace wheelrail
