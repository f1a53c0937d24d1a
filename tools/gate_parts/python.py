# SPDX-License-Identifier: GPL-2.0-or-later
"""black, flake8 and mypy of Debian 12, over the Python files."""

import argparse
import os
import re
import subprocess
from collections.abc import Iterator

from mcawr.errors import Exit, fail

from .sources import ROOT, Files, shown

HUNK = re.compile(r"^@@ -(\d+)")


def _run(program: str, *words: object) -> subprocess.CompletedProcess[str]:
    """How a tool ended that says what is wrong by exit code 1."""
    try:
        done = subprocess.run(
            [program, *map(str, words)], cwd=ROOT, capture_output=True, text=True, check=False
        )
    except FileNotFoundError:
        fail(Exit.INTERNAL, f"{program} is missing (Debian: apt-get install {program})")
    if done.returncode not in (0, 1):
        fail(Exit.INTERNAL, f"{program} failed: {(done.stderr or done.stdout).strip()[-500:]}")
    return done


def check_format(files: Files, options: argparse.Namespace) -> list[str]:
    """Places that black would change; with options.fix it does."""
    if not files["python"]:
        return []
    if options.fix:
        _run("black", "-q", *files["python"])
    return list(_changes(_run("black", "-q", "--diff", *map(shown, files["python"])).stdout))


def _changes(diff: str) -> Iterator[str]:
    """A finding for each hunk of a diff: the first line that it changes."""
    path, line = "", None  # the line of the file as it is; None: the hunk's finding is made
    for text in diff.splitlines():
        if text.startswith("--- "):
            path = text[4:].partition("\t")[0]
        elif hunk := HUNK.match(text):
            line = int(hunk[1])
        elif line is not None and text[:1] in ("+", "-"):
            if not text.startswith("+++ "):
                yield f"{path}:{line}:1: format: (tools/gate --fix black)"
                line = None
        elif line is not None:
            line += 1


def check_rules(files: Files, _options: argparse.Namespace) -> list[str]:
    """Findings of flake8."""
    if not files["python"]:
        return []
    done = _run("flake8", *map(shown, files["python"]))
    return done.stdout.splitlines()


def check_types(files: Files, options: argparse.Namespace) -> list[str]:
    """Findings of mypy in tools; those of files that others import are found with them."""
    typed = [path for path in files["python"] if path.is_relative_to(ROOT / "tools")]
    if not typed:
        return []
    cache = options.build / "gates" / "mypy"
    done = _run("mypy", "--cache-dir", os.path.abspath(cache), *map(shown, typed))
    return done.stdout.splitlines()
