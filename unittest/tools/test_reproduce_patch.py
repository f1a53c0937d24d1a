# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/reproduce, rolling point contact: runs that go on, tables whose answers are known, and
the page beside the shipped tables."""

import json
import os
import re
from pathlib import Path

import pytest

from mcawr.errors import Failure
from reproduce_parts import patch_runs as runs
from script_calls import Caller

ROOT = Path(__file__).resolve().parents[2]

BUILD = (
    Path(os.environ["MCAWR_TEST_LMP"]).parents[1]
    if "MCAWR_TEST_LMP" in os.environ
    else ROOT / "build"
)
built = pytest.mark.skipif(
    not (BUILD / "bin" / "wr_creep").exists(), reason="wr_creep is not built"
)
STORED = ("fig14-3d", "fig15-3d", "polach-3d", "grid-3d")
MU, FROZEN, MOVING = 0.4, 0.5, 0.9  # what the tables of these tests follow


@pytest.fixture
def call(monkeypatch, capfd):
    monkeypatch.setenv("MCAWR_BUILD", str(BUILD))
    return Caller(monkeypatch, capfd)


# runs ---------------------------------------------------------------------------------------------
def small(name="one", *changes):
    words = ("thermal=off", "cells=[24, 24]", "creep=[1e-3]", "sensitivities=true")
    return runs.Run(name, {"mode": "smooth", "seed": 0}, (*words, "fields=none", *changes))


@built
def test_runs_go_on(tmp_path, monkeypatch):
    """What is done is not made again, unless the case is another one; results are the program's."""
    monkeypatch.setenv("MCAWR_BUILD", str(BUILD))
    said = []
    both = [small(), small("two", "creep=[1e-3, 2e-3]")]
    runs.compute(both[:1], tmp_path, 1, said.append)
    runs.compute(both, tmp_path, 2, said.append)
    assert [line.split(":")[0] for line in said] == ["1 of 1", "1 of 1"]
    runs.compute([small("one", "creep=[2e-3]")], tmp_path, 1, said.append)
    assert len(said) == 3
    with pytest.raises(Failure, match="curvatures"):  # a case that wr_creep refuses
        runs.compute([small("bad", "contact.curvatures=[1, 1]")], tmp_path, 1, said.append)
    text, fits = runs.table([both[1]], tmp_path)
    assert fits is None
    rows = [line for line in text.splitlines() if not line.startswith("#")]
    assert rows[0].startswith("mode,seed,speed,creep,traction_ratio") and len(rows) == 3
    creep = (tmp_path / "two" / "creep.csv").read_text().splitlines()[-1].split(",")
    assert float(rows[-1].split(",")[4]) == pytest.approx(float(creep[2]), rel=1e-5)


@built
def test_no_solution_is_a_result(tmp_path, monkeypatch):
    """A strength that the temperature uses up (exit code 4) is not tried again."""
    monkeypatch.setenv("MCAWR_BUILD", str(BUILD))
    hot = (
        "creep=[0.1]",
        "speed=40 m/s",
        "thermal.model=local",
        "friction.strength_temperature=9 K",
    )
    run = runs.Run("hot", {"mode": "smooth", "seed": 0}, ("cells=[24, 24]", *hot))
    said = []
    runs.compute([run], tmp_path, 1, said.append)
    assert len(said) == 1 and "leaves no strength" in said[0]
    runs.compute([run], tmp_path, 1, said.append)
    assert len(said) == 1
    text, _ = runs.table([run], tmp_path)
    (tmp_path / "t.csv").write_text(text)
    row = runs.read("t", str(tmp_path))[0]
    assert row["creep"] == 0.1 and row["speed"] == 40 and "traction_ratio" not in row


# tables -------------------------------------------------------------------------------------------
def force(creep, factor=1.0):
    return MU * factor * creep / (factor * creep + 1e-3)


def rows_of(plan, value):
    """Rows of a plan's runs; value(labels, creep) -> traction_ratio, c11."""
    rows = []
    for run in runs.PLANS[plan]():
        given = dict(change.split("=", 1) for change in run.changes)
        for creep in map(float, given["creep"].strip("[]").split(",")):
            ratio, c11 = value(run.labels, creep)
            factor = 0.4 if run.labels["mode"] != "smooth" else 1.0
            point = {"speed": given["speed"].split()[0], "creep": creep, "traction_ratio": ratio}
            point |= {"temperature_max": 1000 * creep, "peak_pressure": 900 / factor}
            point |= {"real_area": 170 * factor, "c11": c11, "c22": 0.8 * c11}
            rows.append(run.labels | point)
    return rows


def known(labels, creep):
    """Slopes of half and nine tenths of the smooth one, with a spread of 1 % over the seeds."""
    factor = {"smooth": 1.0, "frozen": FROZEN, "moving": MOVING}[labels["mode"]]
    spread = 1 + 0.01 * (-1) ** labels["seed"] if labels["seed"] else 1.0
    return force(creep, factor) * spread, 4.0 * factor * spread


def write_tables(folder, value=known, plans=tuple(runs.PLANS)):
    folder.mkdir(exist_ok=True)
    for plan in plans:
        (folder / f"{plan}.csv").write_text(runs.as_csv(rows_of(plan, value)))
    fits = []
    for run in runs.low():
        if run.polach:
            kA = {"smooth": 0.9, "frozen": 0.4, "moving": 0.8}[run.labels["mode"]]
            fit = {"mu0": MU, "A": 1, "B": 0, "kA": kA, "kS": kA / 2, "rms": 0.001}
            fits.append(run.labels | fit | {"kA_se": 0.01, "kS_se": 0.02})
    (folder / "patch-low-polach.csv").write_text(runs.as_csv(fits))


def line(text, begin):
    found = [row for row in text.splitlines() if row.strip().startswith(begin)]
    assert len(found) == 1, text
    return [float(word) for word in re.findall(r"[-+]?\d+\.?\d*", found[0].strip()[len(begin) :])]


def test_figures_tell_what_the_tables_hold(call, tmp_path):
    write_tables(tmp_path / "tables")
    words = ("--logs", tmp_path / "tables", "-o", tmp_path)
    code, text, err = call("reproduce", *STORED, *words)
    assert code == 0, err
    for name in STORED:
        assert (tmp_path / f"{name}.png").read_bytes()[:4] == b"\x89PNG"
        assert (tmp_path / f"{name}.txt").read_text().strip() in text
    smooth, frozen, _, ratio, error, moving, _, over, _ = line(text, "creep 0.1 % ")
    assert smooth == pytest.approx(force(1e-3), abs=1e-4)
    assert frozen == pytest.approx(force(1e-3, FROZEN), abs=1e-4)
    assert ratio == pytest.approx(force(1e-3, FROZEN) / force(1e-3), abs=2e-3)
    assert error == pytest.approx(0.01 * ratio / 3, rel=0.3)  # of ten seeds that differ by +-1 %
    assert moving == pytest.approx(force(1e-3, MOVING), abs=1e-4)
    assert over == pytest.approx(moving / smooth, abs=2e-3)
    slope = line(text, "waves from 2 mm")
    assert slope[0] == pytest.approx(runs.standard_slope(2), abs=1e-4)
    assert slope[2] == 40 and slope[4] == pytest.approx(FROZEN, abs=2e-3)
    assert line(text, "largest T/N, smooth:")[-1] == 100
    assert line(text, "frozen, local, 40 m/s")[-1] == 50  # 1000 K x the largest creep there
    assert line(text, "frozen ")[:2] == [10, 0.4]
    assert line(text, "Polach 2005, dry") == [1.0, 0.4, 0.7, 0.4]
    assert line(text, "24 cells a wave")[0] == pytest.approx(FROZEN * 0.99, abs=1e-4)


def test_a_maximum_is_seen(call, tmp_path):
    """T/N that falls by a tenth from 1 to 10 % creep."""

    def falling(labels, creep):
        ratio, c11 = known(labels, creep)
        return (0.9 * known(labels, 0.01)[0] if creep == 0.1 else ratio), c11

    write_tables(tmp_path / "tables", falling)
    code, text, err = call("reproduce", "fig14-3d", "--logs", tmp_path / "tables", "-o", tmp_path)
    assert code == 0, err
    assert line(text, "largest T/N, moving:")[1] == 1
    assert line(text, "largest T/N, moving:")[-1] == pytest.approx(90, abs=0.1)


def test_points_without_a_solution_are_counted(call, tmp_path):
    """Moving roughness at 3 % with local temperature: two of ten seeds end."""

    def some(labels, creep):
        ends = labels["mode"] == "moving" and labels["heat"] == "local" and labels["seed"] > 8
        return ("", 4.0) if ends else known(labels, creep)

    write_tables(tmp_path / "tables", some)
    code, text, err = call("reproduce", "fig15-3d", "--logs", tmp_path / "tables", "-o", tmp_path)
    assert code == 0, err
    assert line(text, "local, creep 3 %")[:2] == [8, 10]


def test_missing_tables_are_one_clear_line(call, tmp_path):
    for name in STORED:
        err = call.refused(3, "reproduce", name, "--logs", tmp_path, "-o", tmp_path / "out")
        assert "patch-" in err and "--run" in err
    write_tables(tmp_path, plans=("patch-low",))
    table = tmp_path / "patch-low.csv"
    table.write_text(
        "".join(row for row in table.read_text().splitlines(True) if not row.startswith("moving"))
    )
    (tmp_path / "patch-slope.csv").write_text(runs.as_csv(rows_of("patch-slope", known)))
    err = call.refused(3, "reproduce", "fig14-3d", "--logs", tmp_path, "-o", tmp_path / "out")
    assert "moving" in err
    table.write_text(table.read_text() + "frozen,1\n")
    err = call.refused(3, "reproduce", "polach-3d", "--logs", tmp_path, "-o", tmp_path / "out")
    assert "not a table of reproduce" in err


@pytest.mark.parametrize("name", STORED)
def test_page_tells_what_the_shipped_tables_tell(call, tmp_path, name):
    code, text, err = call("reproduce", name, "-o", tmp_path)
    assert code == 0, err
    page = (ROOT / "doc" / "rough_patch.md").read_text(encoding="utf-8")
    assert text.strip() in page, f"doc/rough_patch.md does not hold this:\n{text}"
    assert f"pictures/{name}.png" in page


@built
@pytest.mark.long
def test_pictures_of_runs(call, tmp_path, monkeypatch):
    """The figures that call wr_creep, on a coarse grid."""
    monkeypatch.setattr(runs, "cells_of", lambda cell: [54, 72])
    names = ("fields-3d", "fig13-3d", "curves-3d", "start-3d")
    code, _, err = call("reproduce", *names, "-o", tmp_path)
    assert code == 0, err
    for name in names:
        assert (tmp_path / f"{name}.png").read_bytes()[:4] == b"\x89PNG"


def test_shipped_tables_are_of_the_plans():
    """Every run of the plans is in the shipped tables, and nothing else."""
    for plan in runs.PLANS:
        shipped = {
            (r["mode"], r["heat"], r["wave"], r["cells"], r["seed"], r["speed"], r["creep"])
            for r in runs.read(plan, runs.SHIPPED)
        }
        planned = set()
        for run in runs.PLANS[plan]():
            given = dict(change.split("=", 1) for change in run.changes)
            for creep in given["creep"].strip("[]").split(","):
                label = [run.labels[k] for k in ("mode", "heat", "wave", "cells", "seed")]
                planned.add((*label, float(given["speed"].split()[0]), float(creep)))
        assert shipped == planned
        assert json.dumps(sorted(shipped))  # numbers, no nan
