# SPDX-License-Identifier: GPL-2.0-or-later
"""Parts of tools/gate: which files there are, and one module for each gate.

A gate is a function (files, options) -> list of findings, one line each; with options.fix it
mends what it can first.
"""
