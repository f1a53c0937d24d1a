# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_series.py: one point for the runs of a condition, its table, its picture."""

import csv
import json
import math
import pathlib

import pytest
from mcawr import files
from script_calls import load, with_checksum
from test_files import POINT


def point(mu, p=15.0, v=5.0, strength=92.0, se=0.003, **more):
    values = {"mu": mu, "mu_se": se, "pressure": p, "velocity": v, "strength": strength}
    return {**POINT, **values, "kappa3": 206000.0 / strength, **more}


@pytest.fixture
def series(call, tmp_path, monkeypatch):
    """series(points, *words): (exit code, rows of the table, what was complained of)."""
    monkeypatch.chdir(tmp_path)

    def run(points, *words):
        (tmp_path / "a.png").unlink(missing_ok=True)
        (tmp_path / "fit.json").write_text(with_checksum({"report": {"points": points}}))
        code, _, err = call("plot_series.py", "fit.json", *words, "-o", "a.png", "--csv", "a.csv")
        if code:
            assert err.count("\n") == 1 and not (tmp_path / "a.png").exists()
            return code, None, err
        assert (tmp_path / "a.png").read_bytes()[:4] == b"\x89PNG"
        lines = [row for row in (tmp_path / "a.csv").read_text().splitlines() if row[0] != "#"]
        return code, list(csv.DictReader(lines)), err

    return run


def test_seeds_are_one_point(series):
    points = [point(0.40), point(0.44), point(0.5, v=10.0), point(0.6, v=2.0, se=None)]
    code, rows, _ = series(points, "--against", "velocity")
    assert code == 0 and [row["velocity"] for row in rows] == ["5", "10"]
    first, second = rows
    assert first["runs"] == "2" and float(first["mu"]) == pytest.approx(0.42)
    assert float(first["own_error"]) == pytest.approx(0.003 / math.sqrt(2), rel=1e-4)
    assert float(first["scatter"]) == pytest.approx(0.02, rel=1e-4)  # 0.0283 over sqrt(2)
    assert first["mu_se"] == first["scatter"]  # the larger one
    assert second["runs"] == "1" and second["scatter"] == "" and second["mu_se"] == "0.003"
    assert float(second["youngs_modulus"]) == pytest.approx(206)


def test_runs_that_differ_in_more_than_their_seed_are_no_point(series, tmp_path, call):
    """Two conditions of wr_fit (another size, another step) at one pressure, speed and material."""
    points = [point(0.40, file="a"), point(0.44, file="b"), point(0.5, v=10.0, file="c")]
    for runs, code in (([[0, 1], [2]], 0), ([[0], [1], [2]], 3)):
        conditions = [{"runs": members} for members in runs]
        report = {"report": {"points": points, "conditions": conditions}}
        (tmp_path / "own.json").write_text(with_checksum(report))
        words = ("own.json", "--against", "velocity", "-o", "own.png")
        if code:
            assert "differ in more than the seed" in call.refused(code, "plot_series.py", *words)
        else:
            assert call("plot_series.py", *words)[0] == 0


def test_bars_are_students_t_of_the_seeds():
    """Bars of two seeds of one condition reach 12.7 standard errors where the report says so."""
    module = load("plot_series.py")
    for more, t95 in (({"t95": 12.706}, 12.706), ({}, 1.96)):
        points = [point(0.40, **more), point(0.44, **more)]
        (axes,) = module.figure_of(points, "pressure", False).axes
        low, high = axes.containers[0].lines[2][0].get_segments()[0][:, 1]
        assert high - low == pytest.approx(2 * t95 * 0.02)


def test_bars_of_plot_fit_are_too():
    condition = {"kappa1": 1.0, "kappa2": 9.0, "kappa3": 400.0, "mu": 0.4, "mu_se": 0.02}
    for more, t95 in (({"t95": 12.706}, 12.706), ({}, 1.96)):
        report = {"points": [point(0.4)], "conditions": [{**condition, **more, "runs": [0]}]}
        (drawn,) = load("plot_fit.py").points_of({"report": report})
        assert drawn["t95"] == t95 and drawn["mu_se"] == 0.02


@pytest.mark.parametrize("third", ["kappa3", "ductility"])
def test_plot_fit_brings_runs_to_the_number_of_the_law(third):
    condition = {"kappa1": 1.0, "kappa2": 9.0, "kappa3": 400.0, "mu": 0.4, "mu_se": 0.02}
    condition |= {third: 400.0, "runs": [0]}
    fit = {third: 100.0, "parameters": {"n": {"value": 0.5}}}
    report = {"points": [point(0.4)], "conditions": [condition], "fit": fit}
    law = {"mu0": 0.4, "mu1": 0, "mu2": 0, "b": 0, "c": 0}
    _, _, (drawn,), _ = load("plot_fit.py").contents({**law, "report": report})
    assert drawn["mu"] == pytest.approx(0.2) and drawn["mu_se"] == pytest.approx(0.01)


@pytest.mark.parametrize(
    "law",
    [
        {"mu0": 0.4, "mu1": 0, "mu2": 0, "b": 0, "c": 0, "covariance": [[0.0] * 10] * 10},
        {"table_temperature": [293], "table_pressure": [[1]], "table_mu": [[0.4]]},
    ],
)
def test_plot_fit_refuses_a_law_of_one_material(call, tmp_path, law):
    condition = {"kappa1": 1.0, "kappa2": 9.0, "kappa3": 400.0, "mu": 0.4, "mu_se": 0.02}
    report = {"points": [point(0.4)], "conditions": [{**condition, "runs": [0]}]}
    path, picture = tmp_path / "law.json", tmp_path / "a.png"
    path.write_text(with_checksum({"format": "mca-friction-law 2", **law, "report": report}))
    code, _, err = call("plot_fit.py", str(path), "-o", str(picture))
    assert code == 3 and err.count("\n") == 1 and not picture.exists()
    assert "law.json: is a law of one material" in err


def test_other_quantities_are_lines(series):
    points = [point(0.4 + 0.01 * p, p=p, strength=s) for p in (1.0, 5.0) for s in (92.0, 200.0)]
    for words in (["--against", "pressure"], ["--against", "pressure", "--mu"]):
        code, rows, _ = series(points, *words)
        assert code == 0 and len(rows) == 4
    module = load("plot_series.py")
    lines = module.lines_of(points, "pressure")
    assert len(lines) == 2 and [len(line) for line in lines.values()] == [2, 2]
    assert [module.name_of(line, lines) for line in lines] == [
        "$\\sigma_0$ = 92 MPa",
        "$\\sigma_0$ = 200 MPa",
    ]
    code, _, err = series([point(0.4, p=p) for p in range(1, 12)], "--against", "velocity")
    assert code == 3 and "11 lines against velocity" in err


def test_no_point_with_an_error(series):
    code, _, err = series([point(0.4, se=None)], "--against", "velocity")
    assert code == 3 and "no point with a standard error" in err


def test_peaks_do_not_flatten_the_rest():
    """The static peak is several times mu: it stands on an axis of its own."""
    module = load("plot_series.py")
    points = [point(0.36 + 0.015 * v, v=v, mu_peak=2.0, mu_grinding_in=0.45) for v in (1.0, 10.0)]
    figure = module.figure_of(points, "velocity", False)
    top, axes = figure.axes
    low, high = axes.get_ylim()
    assert 0.3 < low < 0.375 and 0.5 < high < 0.6
    assert top.get_ylim()[1] > 2.0
    (bars,) = (c for c in axes.containers)
    (stems,) = bars[2]
    heights = [part[1][1] - part[0][1] for part in stems.get_segments()]
    assert heights == pytest.approx([2 * 1.96 * 0.003] * 2)


def test_temperature_is_that_of_run_json(series, tmp_path):
    """Moduli and strengths that go with it make no line of their own."""
    points = []
    for name, kelvin, strength, mu in (("a", 293, 900, 0.5), ("b", 873, 338, 0.36)):
        (tmp_path / name).mkdir()
        record = {"parameters": {"temperature": kelvin}, "attempts": [], "checksum": ""}
        (tmp_path / name / "run.json").write_text(json.dumps(record))
        log = tmp_path / name / "run.friction"
        points.append(point(mu, strength=float(strength), file=str(log)))
    code, rows, _ = series(points, "--against", "temperature")
    assert code == 0 and {row["temperature"] for row in rows} == {"293", "873"}
    module = load("plot_series.py")
    (line,) = module.lines_of(module.with_temperatures(points[::-1]), "temperature").values()
    assert [x for x, _ in line] == [293, 873]
    (tmp_path / "b" / "run.json").unlink()
    code, _, err = series(points, "--against", "temperature")
    assert code == 3 and "b/run.friction: no temperature" in err


def test_temperature_of_a_shipped_log_is_that_of_its_plan():
    logs = pathlib.Path(__file__).resolve().parents[2] / "examples/campaign/logs"
    archive = logs / "temperature.tar.xz"
    names = sorted(files._members(str(archive)))
    found = {
        load("plot_series.py").with_temperatures([{"file": f"{archive}/{name}"}])[0]["temperature"]
        for name in names
        if name.endswith(".friction")
    }
    assert found == {293, 473, 673, 773, 873}
