// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_FIELD_SELECTION_H
#define WHEELRAIL_CREEP_SWEEP_FIELD_SELECTION_H

#include <vector>

namespace wheelrail {

/// Which points of a sweep leave their fields.
struct FieldSelection {
  enum class Kind { None, Last, All, Numbers };
  Kind kind = Kind::Last;
  std::vector<int> numbers; ///< from 1 on, in the order in which the case asks for the points

  /// \param number of the point, from 1 on
  /// \param total number of points in all, which decides Last
  bool holds(int number, int total) const;
};

} // namespace wheelrail
#endif
