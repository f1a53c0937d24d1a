# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts of tools/campaign: plan (what to run), folder (what there is of it), runner (running
it)."""
