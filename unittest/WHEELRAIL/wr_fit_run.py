# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs wr_fit for its tests."""

import csv
import os
import pathlib
import subprocess

TOOLS = pathlib.Path(os.environ["PROJECT_SOURCE"]) / "tools"
PNG = b"\x89PNG\r\n\x1a\n"
WR_FIT = pathlib.Path(os.environ["WHEELRAIL_BIN"]) / "wr_fit"


def wr_fit(*arguments, program=WR_FIT, **more):
    return subprocess.run(
        [program, *map(str, arguments)], capture_output=True, text=True, timeout=60, **more
    )


WARNING = "wr_fit: warning: "


def warnings_of(result):
    """What it warns of on stderr."""
    lines = result.stderr.splitlines()
    return [line.removeprefix(WARNING) for line in lines if line.startswith(WARNING)]


def one_line(result, code, *parts):
    """The failed call printed one clear line on stderr that holds the parts; of a call that ends
    well or with runs that give no law, beside its warnings."""
    assert result.returncode == code, result.stderr
    lines = result.stderr.splitlines()
    if code in (0, 4):
        lines = [line for line in lines if not line.startswith(WARNING)]
    assert len(lines) == (code != 0), result.stderr
    for part in parts:
        assert part in result.stderr
    return result


def read_runs(path):
    """The rows of a table of runs; test_wr_fit_page.py holds its columns against the page."""
    lines = path.read_text().splitlines()
    assert lines[0].startswith("#")
    return list(csv.DictReader(lines[1:]))
