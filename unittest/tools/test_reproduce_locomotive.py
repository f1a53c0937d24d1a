# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/reproduce locomotive: curves whose place beside the measured points is known, and the
shipped table."""

import os
import re
from pathlib import Path

import numpy
import pytest

from reproduce_parts import locomotive, locomotive_runs as made, patch_runs
from script_calls import Caller

ROOT = Path(__file__).resolve().parents[2]
BUILD = (
    Path(os.environ["MCAWR_TEST_LMP"]).parents[1]
    if "MCAWR_TEST_LMP" in os.environ
    else ROOT / "build"
)
LAWS = {model: f"{model}.json" for model in made.MODELS}


@pytest.fixture
def call(monkeypatch, capfd):
    monkeypatch.setenv("MCAWR_BUILD", str(BUILD))
    return Caller(monkeypatch, capfd)


def creeps_of(run):
    given = dict(change.split("=", 1) for change in run.changes)
    return [float(word) for word in given["creep"].strip("[]").split(",")]


def write_table(folder, value):
    """A table of the plan; value(labels, creep) -> T/N."""
    rows = []
    for run in made.runs(LAWS):
        for creep in creeps_of(run):
            ratio = value(run.labels, creep)
            row = run.labels | {"speed": 10, "creep": creep, "traction_ratio": ratio}
            limits = {"law_low": 0.9 * ratio, "law_high": 1.1 * ratio} if run.band else {}
            rows.append(row | limits)
    folder.mkdir()
    (folder / "locomotive.csv").write_text(patch_runs.as_csv(rows))


def test_bins_are_those_of_the_points():
    """Means that were taken by hand of examples/wheelrail/eurosprinter.csv."""
    real = locomotive.measured()
    assert len(real.points) == 133
    assert real.creep[3] == pytest.approx(0.0253, abs=5e-5)
    assert list(numpy.round(real.ratio[[0, 3, 6, 8]], 3)) == [0.254, 0.311, 0.250, 0.212]
    assert real.fall(0.107) == pytest.approx(0.80, abs=0.005)
    assert real.fall(0.195) == pytest.approx(0.68, abs=0.005)


def test_a_curve_through_the_bins_meets_the_aims(call, tmp_path):
    """Our law with slope 0.02 has the bins' values at their creeps; all other curves are flat."""
    real = locomotive.measured()

    def through(labels, creep):
        if labels["law"] != locomotive.OURS or labels["slope"] != 0.02:
            return 0.5
        return numpy.interp(numpy.log(creep), numpy.log(real.creep), real.ratio)

    write_table(tmp_path / "tables", through)
    words = ("--logs", tmp_path / "tables", "-o", tmp_path)
    code, text, err = call("reproduce", "locomotive", *words)
    assert code == 0, err
    assert (tmp_path / "locomotive.png").read_bytes()[:4] == b"\x89PNG"
    assert re.search(r"our law +0.02 +0\.00\d +[0-4] +0\.31", text), text
    assert re.search(r"our law +smooth +0\.2\d\d +1\d\d +0\.500", text), text
    assert text.count(": met") == 3 and "rms slope 0.02, frozen; 5 of 5 seeds" in text
    assert "95 % of law 0.450..0.550" in text


def test_a_flat_curve_does_not(call, tmp_path):
    write_table(tmp_path / "tables", lambda labels, creep: 0.4)
    words = ("--logs", tmp_path / "tables", "-o", tmp_path)
    code, text, err = call("reproduce", "locomotive", *words)
    assert code == 0, err
    assert text.count("not met") == 3
    assert "T/N over its peak at 10.7 % within 0.10 of 0.80: not met, 1.00" in text


def test_a_missing_run_is_one_clear_line(call, tmp_path):
    write_table(tmp_path / "tables", lambda labels, creep: 0.4)
    table = tmp_path / "tables" / "locomotive.csv"
    kept = [row for row in table.read_text().splitlines(True) if ",moving," not in row]
    table.write_text("".join(kept))
    words = ("--logs", tmp_path / "tables", "-o", tmp_path / "out")
    assert "moving" in call.refused(3, "reproduce", "locomotive", *words)


def test_page_tells_what_the_shipped_table_tells(call, tmp_path):
    code, text, err = call("reproduce", "locomotive", "-o", tmp_path)
    assert code == 0, err
    page = (ROOT / "doc" / "listings.md").read_text(encoding="utf-8")
    assert text.strip() in page, f"doc/listings.md does not hold this:\n{text}"
    assert "pictures/locomotive.png" in (ROOT / "doc" / "how_close.md").read_text(encoding="utf-8")


def test_shipped_table_is_of_the_plan():
    shipped = {
        (r["law"], r["mode"], r["slope"], r["seed"], r["creep"])
        for r in patch_runs.read("locomotive", patch_runs.SHIPPED)
    }
    planned = {
        (*(run.labels[k] for k in ("law", "mode", "slope", "seed")), creep)
        for run in made.runs(LAWS)
        for creep in creeps_of(run)
    }
    assert shipped == planned


@pytest.mark.skipif(not (BUILD / "bin" / "wr_fit").exists(), reason="wr_fit is not built")
def test_shipped_table_has_the_law_of_the_shipped_logs(tmp_path, monkeypatch):
    monkeypatch.setenv("MCAWR_BUILD", str(BUILD))
    _, law = made.fit(made.MODELS[0], made.LOGS, str(tmp_path))
    head = (Path(patch_runs.SHIPPED) / "locomotive.csv").read_text(encoding="utf-8")
    assert f"# law {made.MODELS[0]}: {made.told(law)}\n" in head


@pytest.mark.long
@pytest.mark.skipif(not (BUILD / "bin" / "wr_creep").exists(), reason="wr_creep is not built")
def test_fig15_is_that_of_the_page(call, tmp_path):
    code, text, err = call("reproduce", "fig15", "-o", tmp_path)
    assert code == 0, err
    page = (ROOT / "doc" / "listings.md").read_text(encoding="utf-8")
    assert text.strip() in page, f"doc/listings.md does not hold this:\n{text}"
