# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts of tools/contact_inp.py: inp (reading CONTACT's files), case (what it writes)."""
