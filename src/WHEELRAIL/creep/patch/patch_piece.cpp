// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_piece.h"

#include "base/errors.h"
#include "creep/patch/static_patch.h"

#include <fmt/format.h>
#include <utility>

namespace wheelrail {
namespace {

/// What the bands are of: forces and moment, or the creepage where a force is given.
struct Quantities {
  std::vector<double> tractionRatio, x, y, momentZ;

  void add(const PatchPoint &point, const PatchDrive &drive)
  {
    tractionRatio.push_back(point.tractionRatio());
    x.push_back(drive.forceX ? point.creepage.xi : point.forceX);
    y.push_back(drive.forceY ? point.creepage.eta : point.forceY);
    momentZ.push_back(point.momentZ);
  }
  PatchBands bands(const LawSpread &spread) const
  {
    return {spread.band(tractionRatio), spread.band(x), spread.band(y), spread.band(momentZ)};
  }
};

/// The points of a piece one by one.
class PieceSolver {
 public:
  PieceSolver(const PatchSpecification &asked, const LawSpread &spread, const PatchContact &contact,
              const std::function<bool()> &goOn)
      : asked_(asked), spread_(spread), contact_(contact), goOn_(goOn)
  {
  }

  /// \param keeps write the point's fields to `result`
  /// \return whether the point was solved: not, when interrupted
  bool solve(const PatchTask &task, int number, bool keeps, PatchPieceResult &result)
  {
    switch (asked_.mode) {
    case PatchMode::Static:
      return still(task, number, keeps, result);
    case PatchMode::Moving:
      return moving(task, number, keeps, result);
    default:
      return frozen(task, number, keeps, result);
    }
  }

  /// After a point that failed: the next one begins cold.
  void startAnew()
  {
    frozen_.reset();
    others_.reset();
  }

 private:
  bool still(const PatchTask &task, int number, bool keeps, PatchPieceResult &result)
  {
    const std::optional<StaticPatch> solved = solveStaticPatch(
        asked_.physics, *spread_.laws().front(), contact_, task, asked_.sequence.load, goOn_);
    if (!solved)
      return false;
    result.points.push_back(solved->point);
    if (keeps)
      result.fields[number] = solved->fields;
    return true;
  }

  bool moving(const PatchTask &task, int number, bool keeps, PatchPieceResult &result)
  {
    std::optional<PatchPoint> own;
    std::vector<PatchStep> series;
    PatchFields fields;
    Quantities quantities;
    for (const LawPointer &law : spread_.laws()) {
      MovingPatch rolling(asked_.physics, asked_.moving, asked_.sequence, *law, contact_,
                          asked_.contact.spinPoint);
      const std::optional<PatchPoint> point = rolling.solve(task.speed, task.drive, goOn_);
      if (!point)
        return false;
      quantities.add(*point, task.drive);
      if (own)
        continue;
      own = point; // laws() begins with the law itself
      series = rolling.series();
      fields = rolling.fields();
    }
    own->bands = quantities.bands(spread_);
    result.points.push_back(*own);
    result.series[number] = std::move(series);
    if (keeps)
      result.fields[number] = std::move(fields);
    return true;
  }

  bool frozen(const PatchTask &task, int number, bool keeps, PatchPieceResult &result)
  {
    const auto warm = [&](std::optional<FrozenPatch> &patch, const LawPointer &law) {
      if (!patch)
        patch.emplace(asked_.physics, contact_, asked_.contact.spinPoint);
      return patch->solve(*law, task.speed, task.drive);
    };
    Quantities quantities;
    PatchPoint own = warm(frozen_, spread_.laws().front());
    quantities.add(own, task.drive);
    for (std::size_t k = 1; k < spread_.laws().size(); ++k) {
      if (!goOn_())
        return false;
      quantities.add(warm(others_, spread_.laws()[k]), task.drive);
    }
    own.bands = quantities.bands(spread_);
    result.points.push_back(own);
    if (keeps)
      result.fields[number] = frozen_->fields();
    return true;
  }

  const PatchSpecification &asked_;
  const LawSpread &spread_;
  const PatchContact &contact_;
  const std::function<bool()> &goOn_;
  std::optional<FrozenPatch> frozen_, others_; ///< with the law itself, and with those near it
};

/// What a point that does not converge leaves: what was asked for, and why it is not there.
PatchPoint failedPoint(const PatchContact &contact, const PatchTask &task, const Error &error)
{
  PatchPoint point;
  point.surface = contact.surface.number;
  point.load = contact.load;
  point.speed = task.speed;
  point.creepage = task.drive.creepage;
  point.failure = error.what();
  return point;
}

/// Which keywords asked for a force that friction cannot carry.
Error impossibleForce(const PatchDrive &drive, const ForceTooLarge &error)
{
  const char *keyword = drive.forceX && drive.forceY ? "force.longitudinal, force.lateral"
                        : drive.forceX               ? "force.longitudinal"
                                                     : "force.lateral";
  constexpr double kN = 1e3;
  return {ExitCode::BadInput,
          fmt::format("{}: {:.5g} kN cannot be carried: friction allows less than {:.5g} kN",
                      keyword, error.force / kN, error.capacity / kN)};
}

} // namespace

PatchPieceResult solvePatchPiece(const PatchSpecification &asked, const LawSpread &spread,
                                 const PatchContact &contact, const std::vector<PatchTask> &tasks,
                                 const PatchPiece &piece, const std::function<bool()> &goOn)
{
  PatchPieceResult result;
  PieceSolver solver(asked, spread, contact, goOn);
  for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
    const int number = static_cast<int>(k) + 1;
    const bool keeps = asked.fields.holds(number, static_cast<int>(tasks.size()));
    try {
      if (!goOn() || !solver.solve(tasks[k], number, keeps, result))
        return {};
    } catch (const ForceTooLarge &error) {
      if (tasks.size() == 1) // nothing else was asked for
        throw impossibleForce(tasks[k].drive, error);
      result.points.push_back(
          failedPoint(contact, tasks[k], impossibleForce(tasks[k].drive, error)));
      solver.startAnew();
    } catch (const Error &error) {
      if (error.code() != ExitCode::NotConverged)
        throw;
      result.points.push_back(failedPoint(contact, tasks[k], error));
      solver.startAnew();
    }
  }
  return result;
}

} // namespace wheelrail
