# SPDX-License-Identifier: GPL-2.0-or-later
"""What the scripts share: errors, files, and the readers of our formats."""
