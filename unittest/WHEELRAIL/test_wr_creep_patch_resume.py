# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a point contact: runs that are killed go on, fields included."""

import json
import resource
import signal
import subprocess
import time

import pytest
from patch_runs import BIN, CASE, wr_creep

SECONDS = 6  # a journal is written every two


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def words(case, out, *changes):
    options = [word for change in changes for word in ("--set", change)]
    return [case, "-o", out, "--threads", 1, "-q", *options]


def creep(n):
    return f"creep={{from: 1e-4, to: 1e-2, n: {n}}}"


def processor_time(call):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert call().returncode == 0
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def points_for(case, folder, few, *changes):
    """Points of a curve that takes at least SECONDS on this machine, however loaded it is."""
    each = processor_time(lambda: wr_creep(*words(case, folder / "few", *changes, creep(few))))
    return int(SECONDS / each * few) + 1


def kill(command, journal):
    """Starts a run and kills it once something is in its journal."""
    with subprocess.Popen([BIN, *map(str, command)], stderr=subprocess.DEVNULL) as running:
        while not journal.exists() and running.poll() is None:
            time.sleep(0.02)
        running.send_signal(signal.SIGKILL)
    assert running.returncode == -signal.SIGKILL and journal.exists()


@pytest.mark.parametrize("mode", ["frozen", "moving"])
def test_interrupted_runs_go_on(case, tmp_path, mode):
    out, whole = tmp_path / "out", tmp_path / "whole"
    changes = (f"mode={mode}", "cells=40")
    if mode == "moving":
        changes += ("moving.passes=4",)
    few = 100 if mode == "frozen" else 4
    changes += (creep(points_for(case, tmp_path, few, *changes)),)
    journal = out / "wr_creep.journal"
    kill(words(case, out, *changes), journal)
    assert not (out / "creep.csv").exists()
    done = wr_creep(*words(case, out, *changes))
    assert done.returncode == 0, done.stderr
    summary = json.loads((out / "summary.json").read_text())
    assert summary["points_resumed"] > 0 and not journal.exists()
    assert wr_creep(*words(case, whole, *changes)).returncode == 0
    for name in ("creep.csv", "series.csv") if mode == "moving" else ("creep.csv",):
        assert (out / name).read_bytes() == (whole / name).read_bytes()


def test_fields_of_finished_points_are_kept(case, tmp_path):
    out, whole = tmp_path / "out", tmp_path / "whole"
    chosen = list(range(1, 17))
    n = points_for(case, tmp_path, 100, "cells=40")
    changes = ("cells=40", f"fields={chosen}", creep(n))
    kill(words(case, out, *changes), out / "wr_creep.journal")
    kept = sorted(out.glob("wr_creep.journal.*"))
    assert len(kept) == len(chosen) and not (out / "creep.csv").exists()
    kept[0].write_bytes(kept[0].read_bytes()[:-1] + b"\x55")  # a damaged one
    done = wr_creep(*words(case, out, *changes))
    assert done.returncode == 0 and "computed again" in done.stderr, done.stderr
    resumed = json.loads((out / "summary.json").read_text())["points_resumed"]
    assert 8 <= resumed < n  # the damaged point's piece of eight is computed again
    assert not list(out.glob("wr_creep.journal*"))
    assert wr_creep(*words(case, whole, *changes)).returncode == 0
    names = {path.name for path in whole.iterdir()}
    assert names == {path.name for path in out.iterdir()} and len(names) == 2 + 10 * len(chosen)
    for name in names - {"summary.json"}:
        assert (out / name).read_bytes() == (whole / name).read_bytes(), name
