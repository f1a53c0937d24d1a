# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_creep.py: a picture from creep.csv, or one clear line and no file."""

import subprocess
from pathlib import Path

import pytest

PLOT = Path(__file__).resolve().parents[2] / "tools" / "plot_creep.py"
HEAD = (
    "# units\nspeed,creep,traction_ratio,traction,mu_mean,temperature_rise,iterations,"
    "stick_fraction\n"
)
GOOD = (
    HEAD + "10,1e-4,0.02,80,0.33,0.1,3,0.97\n10,1e-3,0.2,800,0.33,2,3,0.6\n"
    "20,1e-3,0.2,800,0.33,3,3,0.6\n"
)


def plot(tmp_path, content):
    table, picture = tmp_path / "creep.csv", tmp_path / "a.png"
    if content is not None:
        table.write_text(content)
    done = subprocess.run(
        [PLOT, table, "-o", picture], text=True, capture_output=True, timeout=60, check=False
    )
    return done, picture


def test_picture(tmp_path):
    done, picture = plot(tmp_path, GOOD)
    assert done.returncode == 0, done.stderr
    assert picture.read_bytes()[:4] == b"\x89PNG"


@pytest.mark.parametrize(
    "content",
    [None, "", HEAD, "a,b\n1,2\n", HEAD + "10,1e-4,x,80,0.33,0.1,3,1\n", GOOD + "10,1e-4,0.0"],
    ids=["missing", "empty", "no rows", "other columns", "not a number", "cut"],
)
def test_bad_table(tmp_path, content):
    done, picture = plot(tmp_path, content)
    assert done.returncode == 3
    assert done.stderr.count("\n") == 1 and "creep.csv" in done.stderr
    assert not picture.exists()
