// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/checksum.h"

#include "shared/running_checksum.h"

#include <fmt/format.h>

namespace wheelrail {

std::string checksum(std::string_view bytes)
{
  mcawr::RunningChecksum sum;
  sum.add(bytes);
  return fmt::format("{:08x}", sum.value());
}

} // namespace wheelrail
