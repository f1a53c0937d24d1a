// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_RUNNING_CHECKSUM_H
#define MCAWR_SHARED_RUNNING_CHECKSUM_H

#include <boost/crc.hpp>
#include <cstdint>
#include <string_view>

namespace mcawr {

/// CRC-32 (ISO 3309, that of zip and PNG) of bytes that come one after the other: finds every flip
/// of one bit and every burst of up to 32 bits, and any other damage but one in 2^32.
class RunningChecksum {
 public:
  void add(std::string_view bytes) { sum_.process_bytes(bytes.data(), bytes.size()); }
  /// Checksum of all that was added so far.
  std::uint32_t value() const { return sum_.checksum(); }

 private:
  boost::crc_32_type sum_;
};

} // namespace mcawr
#endif
