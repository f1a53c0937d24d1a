// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep/field_selection.h"

#include <algorithm>

namespace wheelrail {

bool FieldSelection::holds(int number, int total) const
{
  switch (kind) {
  case Kind::None:
    return false;
  case Kind::Last:
    return number == total;
  case Kind::All:
    return true;
  default:
    return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
  }
}

} // namespace wheelrail
