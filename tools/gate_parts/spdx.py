# SPDX-License-Identifier: GPL-2.0-or-later
"""Every source file begins with its SPDX line, after #! where there is one."""

import argparse

from mcawr.files import write

from .sources import Files, shown

LINE = "SPDX-License-Identifier: GPL-2.0-or-later"
COMMENT = {"c++": "//"}  # all others: #


def check(files: Files, options: argparse.Namespace) -> list[str]:
    """Files without their line; with options.fix it is added."""
    findings = []
    for language, paths in files.items():
        line = f"{COMMENT.get(language, '#')} {LINE}\n"
        for path in paths:
            text = path.read_text(encoding="utf-8")
            lines = text.splitlines(keepends=True)
            place = 1 if lines and lines[0].startswith("#!") else 0
            if lines[place : place + 1] == [line]:
                continue
            if options.fix:
                write(path, "".join([*lines[:place], line, *lines[place:]]))
            else:
                findings.append(f"{shown(path)}:{place + 1}:1: spdx: must be '{line.rstrip()}'")
    return findings
