// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/checksum.h"

#include <boost/crc.hpp>
#include <fmt/format.h>

namespace wheelrail {

std::string checksum(std::string_view bytes)
{
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return fmt::format("{:08x}", sum.checksum());
}

} // namespace wheelrail
