// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_CHECKSUM_H
#define WHEELRAIL_BASE_CHECKSUM_H

#include <string>
#include <string_view>

namespace wheelrail {

/// CRC-32 of some bytes (ISO 3309, that of zip and PNG) as eight hexadecimal digits: finds every
/// flip of one bit and every burst of up to 32 bits, and any other damage but one in 2^32.
std::string checksum(std::string_view bytes);

} // namespace wheelrail
#endif
