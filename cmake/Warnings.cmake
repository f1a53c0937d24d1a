# SPDX-License-Identifier: GPL-2.0-or-later
# One interface target that every target of ours links privately.
add_library(mcawr_warnings INTERFACE)
target_compile_options(mcawr_warnings INTERFACE -Wall -Wextra -Wshadow)
