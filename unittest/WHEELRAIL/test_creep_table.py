# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/creep_table.py: a table over geometries whose interpolation error is known and placed."""

import os
import re
import subprocess

import numpy
import pytest
from patch_runs import CASE, SOURCE, numbers, run, table

BIN = os.environ["WHEELRAIL_BIN"]
TOOL = os.path.join(SOURCE, "tools/creep_table.py")
COARSE = (
    "--set",
    "cells=16",
    "--set",
    "speed=10 m/s",
    "--set",
    "friction={law: constant, mu: 0.3}",
)


def make(tmp_path, *options):
    (tmp_path / "case.yaml").write_text(CASE, encoding="utf-8")
    command = [TOOL, tmp_path / "case.yaml", "-o", tmp_path / "t.csv", *COARSE, *options]
    command += ["--wr-creep", os.path.join(BIN, "wr_creep")]
    return subprocess.run(command, text=True, capture_output=True, timeout=300, check=False)


def error_in_head(path):
    text = path.read_text(encoding="utf-8")
    return [float(x) for x in re.findall(r"creep ([0-9.e-]+)", text.split("interpolation")[1])[:2]]


def interpolated(rows, creep):
    return numpy.interp(creep, numbers(rows, "creep"), numbers(rows, "force_x"))


def test_values_are_placed_where_the_forces_are_curved(tmp_path):
    done = make(tmp_path, "--set", "creep=[0, 1e-3, 2e-2]", "--tolerance", "0.01")
    assert done.returncode == 0, done.stderr
    rows = table(tmp_path / "t.csv")
    last, first = error_in_head(tmp_path / "t.csv")
    assert last <= 0.01 < first
    # what is said holds between the values, too, not only in the middle of intervals
    creeps = [3.3e-4, 9e-4, 1.7e-3, 3.1e-3, 7e-3, 1.3e-2]
    (tmp_path / "case.yaml").write_text(CASE, encoding="utf-8")
    run(tmp_path / "case.yaml", tmp_path / "out", *COARSE[1::2], f"creep={creeps}")
    exact = numbers(table(tmp_path / "out/creep.csv"), "force_x")
    load = numbers(rows, "load")[0]
    assert abs(interpolated(rows, creeps) - exact).max() / load < 1.5 * last
    # as many values at equal distances miss by more than twice as much
    count = len(rows)
    even = make(
        tmp_path, "--set", f"creep={list(numpy.linspace(0, 2e-2, count))}", "--tolerance", "1"
    )
    assert even.returncode == 0, even.stderr
    assert error_in_head(tmp_path / "t.csv")[0] > 2 * last


def test_geometries_are_axes_of_one_grid(tmp_path):
    done = make(
        tmp_path,
        *("--over", "contact.poissons_ratio=0.25, 0.3", "--set", "creep=[1e-4, 1e-3, 1e-2]"),
        *("--tolerance", "0.5"),
    )
    assert done.returncode == 0, done.stderr
    rows = table(tmp_path / "t.csv")
    assert list(numbers(rows, "poissons_ratio")) == [0.25] * 3 + [0.3] * 3
    text = (tmp_path / "t.csv").read_text(encoding="utf-8")
    assert "poissons_ratio: [0.25, 0.3], hardness_limit" in text  # of all, not of the last one
    assert "# grid: 2 poissons_ratio x 1 load x 1 speed x 1 spin x 1 lateral x 3 creep" in text
    force = numbers(rows, "force_x").reshape(2, 3)
    assert (abs(force[1]) > abs(force[0]))[:1].all()  # C11 grows with Poisson's ratio


@pytest.mark.parametrize(
    "options, code, words",
    [
        (("--over", "contact.poissons_ratio=0.3, 0.2"), 2, "increasing"),
        (("--over", "contact.load=1 kN, 2 N"), 2, "one unit"),
        (("--over", "contact.nonsense=1, 2"), 2, "contact.nonsense"),
        (("--tolerance", "0"), 2, "--tolerance"),
        (("--set", "creep=[x]"), 2, "creep"),
    ],
)
def test_faults_are_one_line(tmp_path, options, code, words):
    done = make(tmp_path, *options)
    assert done.returncode == code, done.stderr
    assert words in done.stderr and done.stderr.count("\n") == 1
    assert not (tmp_path / "t.csv").exists()


def test_a_limit_of_points_is_said(tmp_path):
    done = make(tmp_path, "--set", "creep=[0, 1e-3, 2e-2]", "--tolerance", "1e-4", "--most", "6")
    assert done.returncode == 0, done.stderr
    assert "more than --most 6" in done.stdout
