# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs wr_fit for its tests."""

import os
import pathlib
import subprocess

WR_FIT = pathlib.Path(os.environ["WHEELRAIL_BIN"]) / "wr_fit"


def wr_fit(*arguments, program=WR_FIT, **more):
    return subprocess.run(
        [program, *map(str, arguments)], capture_output=True, text=True, timeout=60, **more
    )


def one_line(result, code, *parts):
    """The failed call printed one clear line on stderr that holds the parts."""
    assert result.returncode == code, result.stderr
    assert result.stderr.count("\n") == 1
    for part in parts:
        assert part in result.stderr
    return result
