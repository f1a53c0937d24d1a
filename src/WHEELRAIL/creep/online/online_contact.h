// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_ONLINE_CONTACT_H
#define WHEELRAIL_CREEP_ONLINE_CONTACT_H

#include "contact/patch/elasticity/patch_half_space.h"
#include "creep/case/case_file.h"
#include "creep/patch/patch_point.h"

#include <optional>
#include <vector>

namespace wheelrail {

/// A point contact that is asked for one operating point after the other: by a multibody code in
/// each of its steps, by Python. It rolls steadily (mode frozen), so that an operating point is a
/// function of what is set, to the tolerance of the solver; the point before is where the search
/// begins, and makes a call fast. SI units. One object per thread.
///
/// The box of cells is that of the case's largest load and stays, as the surfaces in it do. A load
/// that reaches its border is refused (`contact.domain` enlarges it), a small one is on fewer
/// cells, at least 4 across.
class OnlineContact {
 public:
  /// Solves the normal contact. The first speed, creep, lateral and spin of the case are set.
  /// \throws Error (BadInput) for a case that is no point contact in mode frozen with creepages and
  ///         one surface; what reading its files and the normal contact throw
  explicit OnlineContact(const Case &input);
  OnlineContact(const OnlineContact &) = delete;
  OnlineContact &operator=(const OnlineContact &) = delete;

  /// All of them are allowed what their keywords of a case are: `creep`, `lateral` and `spin`, 1/m.
  /// What is closer to 0 than a keyword may be is 0.
  /// \param load N; `contact.load`
  /// \param speed m/s
  /// \throws Error (Usage) for another value, not a number among them, Error (BadInput) for a load
  ///         whose contact is too small for the cells; then nothing is changed
  void set(const Creepage &creepage, double load, double speed);
  void setCreepages(const Creepage &creepage) { set(creepage, load_, speed_); }
  void setLoad(double load) { set(creepage_, load, speed_); }
  void setSpeed(double speed) { set(creepage_, load_, speed); }

  const Creepage &creepage() const { return creepage_; } ///< that is set
  double load() const { return load_; }                  ///< likewise
  double speed() const { return speed_; }                ///< likewise

  /// Solves for what is set.
  /// \throws Error (NotConverged), Error (BadInput) for a contact at the border of the box. The
  ///         next call begins cold, as the first one does
  const PatchPoint &step();

  /// Results of the last step.
  /// \throws Error (Usage) before the first one and after one that failed
  const PatchPoint &point() const;
  const PatchFields &fields() const; ///< likewise
  /// What a point tells: the columns of the case's creep.csv.
  const std::vector<Column<PatchPoint>> &columns() const { return columns_; }
  const PatchContact &contact() const { return contact_; }

 private:
  void requireCells(double load) const;
  void press();
  void requireStep() const;

  PatchSpecification asked_;
  std::vector<Column<PatchPoint>> columns_;
  LawPointer law_;
  PatchContact contact_; ///< under the load of the last step
  PatchHalfSpace space_;
  double load_, speed_;
  Creepage creepage_;
  std::optional<FrozenPatch> patch_; ///< none before the first step and after one that failed
  PatchPoint point_;
};

} // namespace wheelrail
#endif
