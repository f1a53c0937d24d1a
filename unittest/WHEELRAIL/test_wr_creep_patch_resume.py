# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a contact in a point: runs that are killed go on, fields included."""

import json
import signal
import subprocess
import time

import pytest
from patch_runs import BIN, CASE, wr_creep


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def test_interrupted_runs_go_on(case, tmp_path):
    for mode in ("frozen", "moving"):
        many = [
            case,
            "-o",
            tmp_path / mode,
            "--threads",
            "1",
            "--set",
            f"mode={mode}",
            "--set",
            "points=40",
            "--set",
            "moving.passes=4",
            "--set",
            f"creep={{from: 1e-4, to: 1e-2, n: {1500 if mode == 'frozen' else 30}}}",
        ]
        running = subprocess.Popen([BIN, *map(str, many)], stderr=subprocess.PIPE, text=True)
        journal = tmp_path / mode / "wr_creep.journal"
        for _ in range(600):  # killed for good once something is in the journal
            if journal.exists() or running.poll() is not None:
                break
            time.sleep(0.05)
        running.send_signal(signal.SIGKILL)
        running.communicate()
        assert not (tmp_path / mode / "creep.csv").exists()
        assert journal.exists()
        done = wr_creep(*many)
        assert done.returncode == 0, done.stderr
        summary = json.loads((tmp_path / mode / "summary.json").read_text())
        assert summary["points_resumed"] > 0 and not journal.exists()
        whole = wr_creep(*many[:1], "-o", tmp_path / (mode + "2"), *many[3:])
        assert whole.returncode == 0
        for name in ("creep.csv", "series.csv") if mode == "moving" else ("creep.csv",):
            assert (tmp_path / mode / name).read_bytes() == (
                tmp_path / (mode + "2") / name
            ).read_bytes()


def killed(command, journal):
    """Starts a run and kills it once something is in its journal."""
    with subprocess.Popen([BIN, *map(str, command)], stderr=subprocess.DEVNULL) as running:
        for _ in range(600):
            if journal.exists() or running.poll() is not None:
                break
            time.sleep(0.05)
        running.send_signal(signal.SIGKILL)


def test_fields_of_finished_points_are_kept(case, tmp_path):
    out, journal = tmp_path / "out", tmp_path / "out/wr_creep.journal"
    chosen = list(range(1, 17))
    changes = ("points=40", f"fields={chosen}", "creep={from: 1e-4, to: 1e-2, n: 1500}")
    command = [case, "-o", out, "--threads", 1, "-q"]
    command += [word for change in changes for word in ("--set", change)]
    killed(command, journal)
    kept = sorted(out.glob("wr_creep.journal.*"))
    assert journal.exists() and len(kept) == len(chosen) and not (out / "creep.csv").exists()
    kept[0].write_bytes(kept[0].read_bytes()[:-1] + b"\x55")  # a damaged one
    done = wr_creep(*command)
    assert done.returncode == 0 and "computed again" in done.stderr, done.stderr
    resumed = json.loads((out / "summary.json").read_text())["points_resumed"]
    assert 8 <= resumed < 1500  # the damaged point's piece of eight is computed again
    assert not list(out.glob("wr_creep.journal*"))
    whole = tmp_path / "whole"
    assert wr_creep(case, "-o", whole, *command[3:]).returncode == 0
    names = {path.name for path in whole.iterdir()}
    assert names == {path.name for path in out.iterdir()} and len(names) == 2 + 10 * len(chosen)
    for name in names - {"summary.json"}:
        assert (out / name).read_bytes() == (whole / name).read_bytes(), name
