# SPDX-License-Identifier: GPL-2.0-or-later
"""Messages of commits: a subject of at most 72 columns, an empty line, a body that says why."""

import argparse
import subprocess
from collections.abc import Iterator

from mcawr.errors import Exit, fail

from .sources import ROOT, Files

WIDTH = 72  # of a subject, so that `git log --oneline` fits a terminal
UPSTREAM = ("origin/main", "main")  # what a branch is compared with, the first that there is


def _git(*words: str) -> subprocess.CompletedProcess[str]:
    try:
        done = subprocess.run(
            ["git", "-C", ROOT, *words], capture_output=True, text=True, check=False
        )
    except FileNotFoundError:
        fail(Exit.INTERNAL, "git is missing (Debian: apt-get install git)")
    return done


def _base(given: str | None) -> str:
    """The commit after which messages are read."""
    for name in (given,) if given else UPSTREAM:
        done = _git("rev-parse", "--verify", "--quiet", f"{name}^{{commit}}")
        if done.returncode == 0:
            return done.stdout.strip()
    if given:
        fail(Exit.USAGE, f"--base '{given}': no such commit")
    return fail(
        Exit.USAGE,
        f"commits: neither {' nor '.join(UPSTREAM)} is here to compare with: give --base COMMIT",
    )


def check(_files: Files, options: argparse.Namespace) -> list[str]:
    """Faults in the messages of the commits that are on this branch and not in its base."""
    done = _git("log", "--no-merges", "--format=%h%x00%B%x01", f"{_base(options.base)}..HEAD")
    if done.returncode != 0:
        fail(Exit.IO, f"git log failed: {done.stderr.strip()}")
    found = []
    for entry in done.stdout.split("\x01"):
        number, _, message = entry.strip().partition("\0")
        if number:
            found += [f"commit {number}: {fault}" for fault in faults(message)]
    return found


def faults(message: str) -> Iterator[str]:
    """What is wrong with a message."""
    subject, *rest = message.strip().split("\n")
    if len(subject) > WIDTH:
        yield f"subject: {len(subject)} columns, at most {WIDTH} are allowed: '{subject}'"
    if rest and rest[0]:
        yield f"the line after the subject must be empty: '{subject}'"
    if not any(rest):
        yield f"body: there is none; it says why: '{subject}'"
