// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_LAW_CHECKSUM_H
#define WHEELRAIL_LAW_LAW_CHECKSUM_H

#include <string>

/// The key "checksum" of a law file: CRC-32 of all its bytes but those of the line that holds the
/// key. It finds digits that were damaged; whoever changes a law by intent takes the line away.
namespace wheelrail {

/// The text of a law file, or of a report without a law, with the line of its checksum.
/// \param text JSON with an indent of two blanks and the key "format", without a checksum
std::string withChecksum(const std::string &text);

/// Whether the line of the checksum is there, as `withChecksum` wrote it, and fits.
bool fitsChecksum(const std::string &text);

} // namespace wheelrail
#endif
