# SPDX-License-Identifier: GPL-2.0-or-later
"""shellcheck over the shell scripts."""

import argparse
import subprocess

from mcawr.errors import Exit, fail

from .sources import ROOT, Files, shown


def check(files: Files, _options: argparse.Namespace) -> list[str]:
    """Findings of shellcheck, which follows what a script sources."""
    if not files["shell"]:
        return []
    command = ["shellcheck", "--format=gcc", "--external-sources", *map(shown, files["shell"])]
    try:
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        fail(Exit.INTERNAL, "shellcheck is missing (Debian: apt-get install shellcheck)")
    if done.returncode not in (0, 1):
        fail(Exit.INTERNAL, f"shellcheck failed: {done.stderr.strip()}")
    return done.stdout.splitlines()
