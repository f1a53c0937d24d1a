// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/patch_piece.h"

#include "base/errors.h"
#include "creep/patch/static_patch.h"

#include <fmt/format.h>
#include <tuple>
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
    history_ = {};
    switch (asked_.mode) {
    case PatchMode::Static:
      return still(task, number, keeps, result);
    case PatchMode::Moving:
      return moving(task, number, keeps, result);
    default:
      return frozen(task, number, keeps, result);
    }
  }

  /// Steps of the last point's sequence, also where it failed.
  const PatchHistory &history() const { return history_; }

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
        asked_.physics, *spread_.laws().front(), contact_, task, asked_.sequence, goOn_, history_);
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
    PatchFields fields;
    Quantities quantities;
    for (const LawPointer &law : spread_.laws()) {
      if (own && law == spread_.laws().front()) {
        quantities.add(*own, task.drive);
        continue;
      }
      MovingPatch rolling(asked_.physics, asked_.moving, asked_.sequence, *law, contact_,
                          asked_.contact.spinPoint);
      std::optional<PatchPoint> point;
      try {
        point = rolling.solve(task.speed, task.drive, goOn_);
      } catch (const Error &) {
        if (!own)
          history_ = rolling.history();
        throw;
      }
      if (!point)
        return false;
      quantities.add(*point, task.drive);
      if (own)
        continue;
      own = point; // laws() begins with the law itself
      history_ = rolling.history();
      fields = rolling.fields();
    }
    own->bands = quantities.bands(spread_);
    result.points.push_back(*own);
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
  PatchHistory history_;
};

/// What an operating point that does not converge leaves: what was asked for, and why it is not
/// there.
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
Error impossibleForce(const PatchSpecification &asked, const PatchDrive &drive,
                      const ForceTooLarge &error)
{
  std::string keywords;
  for (const auto &[given, listed, word] :
       {std::tuple{drive.forceX.has_value(), !asked.sequence.forceX.empty(), "longitudinal"},
        {drive.forceY.has_value(), !asked.sequence.forceY.empty(), "lateral"}})
    if (given)
      keywords += fmt::format("{}{}{}", keywords.empty() ? "" : ", ",
                              listed ? "sequence.force_" : "force.", word);
  constexpr double kN = 1e3;
  return {ExitCode::BadInput,
          fmt::format("{}: {:.5g} kN cannot be carried: friction allows less than {:.5g} kN",
                      keywords.empty() ? "static.force_ratio" : keywords, error.force / kN,
                      error.capacity / kN)};
}

/// Where in a sequence a point failed: " (at 0.5 s of the sequence)".
std::string whenOf(const PatchSpecification &asked, const PatchHistory &history)
{
  return asked.sequence.any() ? fmt::format(" (at {:.6g} s of the sequence)", history.now) : "";
}

/// Steps of rolling; stages where they are a sequence; of a point that failed those of a sequence.
void keep(const PatchSpecification &asked, const PatchHistory &history, bool failed, int number,
          PatchPieceResult &result)
{
  if (!history.steps.empty() && (asked.sequence.any() || !failed))
    result.series[number] = history.steps;
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
    } catch (const Error &error) {
      const auto *force = dynamic_cast<const ForceTooLarge *>(&error);
      const Error reason = force ? impossibleForce(asked, tasks[k].drive, *force) : error;
      const Error failure(reason.code(), reason.what() + whenOf(asked, solver.history()));
      // an impossible force is bad input where nothing else was asked for
      const bool isAlone = tasks.size() == 1 && solver.history().steps.empty();
      if (force ? isAlone : error.code() != ExitCode::NotConverged)
        throw Error(failure.code(), failure.what());
      result.points.push_back(failedPoint(contact, tasks[k], failure));
      solver.startAnew();
    }
    keep(asked, solver.history(), !result.points.back().converged(), number, result);
    if (keeps)
      for (const auto &[instant, fields] : solver.history().fields)
        result.fields[fieldNumber({number, instant}, static_cast<int>(tasks.size()))] = fields;
  }
  return result;
}

} // namespace wheelrail
