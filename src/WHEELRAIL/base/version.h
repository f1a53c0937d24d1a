// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_VERSION_H
#define WHEELRAIL_BASE_VERSION_H

namespace wheelrail {

/// Version and commit for `--version` and journals, such as "1.2.3 (v1.2.3-4-gabcdef0)". The commit
/// is that of the build's last configuration, "unknown" when that was outside git. Results carry
/// WHEELRAIL_VERSION alone, so that they do not change with a commit.
extern const char *const versionText;

} // namespace wheelrail
#endif
