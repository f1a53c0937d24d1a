# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep --fit-measured: laws fitted to a measured traction curve, apart from a prediction."""

import json
import signal

import pytest
from line_runs import interrupted
from patch_runs import CASE, numbers, run, table

CURVE = "# speed: km/h\n# creep: %\ncreep,speed,traction_ratio\n" + "".join(
    f"{creep},36,{ratio}\n"
    for creep, ratio in [
        (0.02, 0.020),
        (0.05, 0.049),
        (0.1, 0.090),
        (0.2, 0.150),
        (0.5, 0.230),
        (1, 0.262),
        (3, 0.268),
        (10, 0.235),
        (20, 0.200),
    ]
)


@pytest.fixture
def files(tmp_path):
    (tmp_path / "case.yaml").write_text(CASE, encoding="utf-8")
    (tmp_path / "curve.csv").write_text(CURVE, encoding="utf-8")
    return tmp_path


def test_fit(files):
    out = files / "out"
    done = run(
        files / "case.yaml", out, "cells=16", options=("--fit-measured", files / "curve.csv")
    )
    assert "predicted within" in done.stdout and "layer" in done.stdout
    fit = json.loads((out / "measured_fit.json").read_text(encoding="utf-8"))
    rows = table(out / "measured_fit.csv")
    measured = numbers(rows, "measured")
    assert len(measured) == 9
    for name in ("polach", "layer"):
        assert fit[name]["rms_traction_ratio"] < 0.5 * fit["predicted"]["rms_traction_ratio"]
        assert abs(numbers(rows, name) - measured).max() < 0.05
        assert fit[name]["mu0"]["low"] < fit[name]["mu0"]["value"] < fit[name]["mu0"]["high"]
    assert 0 < fit["layer"]["share_of_initial_slope"] < 1
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    assert {"measured_fit.csv", "measured_fit.json"} <= set(summary["files"])
    assert (files / "curve.csv").read_text(encoding="utf-8") == CURVE


def test_an_interrupted_fit_keeps_the_points(files):
    """The points of the case are in the journal when the fit begins."""
    words = (
        files / "case.yaml",
        "--set",
        "cells=[256, 256]",
        "--fit-measured",
        files / "curve.csv",
    )
    interrupted(signal.SIGTERM, files / "out", *words)


def test_too_few_values_are_named_with_their_file(files):
    for count in (1, 3):
        (files / "curve.csv").write_text("".join(CURVE.splitlines(True)[: 3 + count]))
        curve = ("--fit-measured", files / "curve.csv")
        done = run(files / "case.yaml", files / "out", code=3, options=curve)
        expected = f"curve.csv: {count} of the at least 4 values that --fit-measured needs"
        assert expected in done.stderr, done.stderr


def test_per_cent_without_its_unit_is_doubted(files):
    """A creep of 10 is one of 1000 %, also where no law is found for it."""
    text = CURVE.replace("# creep: %\n", "").replace("20,36,0.2\n", "")
    (files / "curve.csv").write_text(text, encoding="utf-8")
    curve = ("--fit-measured", files / "curve.csv")
    done = run(files / "case.yaml", files, "cells=16", code=4, options=curve)
    assert "curve.csv: creep: 10 (1000 %); above 1 the bodies slide faster" in done.stderr


def test_of_one_speed_as_plot_creep_reads_it(files):
    """Creep in per cent by its name, and the speed of the case; two speeds are refused."""
    lines = [line.split(",") for line in CURVE.splitlines()[3:6]]
    plain = files / "plain.csv"
    plain.write_text(
        "creep_percent,traction_ratio\n" + "".join(f"{c},{ratio}\n" for c, _, ratio in lines),
        encoding="utf-8",
    )
    fit = ("--fit-measured", plain)
    done = run(files / "case.yaml", files / "out", "cells=16", code=3, options=fit)
    assert "3 of the at least 4 values" in done.stderr  # read, but too few for a fit
    done = run(files / "case.yaml", files / "out", "speed=[10 m/s, 20 m/s]", code=3, options=fit)
    assert "the column 'speed' is needed" in done.stderr


def test_faults(files):
    bad = files / "bad.csv"
    bad.write_text(CURVE.replace("0.235", "zero"), encoding="utf-8")
    done = run(files / "case.yaml", files / "out", code=3, options=("--fit-measured", bad))
    assert "bad.csv" in done.stderr and "traction_ratio" in done.stderr
    curve = files / "curve.csv"
    done = run(
        *(files / "case.yaml", files / "out", "mode=static", "static.force_ratio=0.5"),
        code=2,
        options=("--fit-measured", curve),
    )
    assert "--fit-measured" in done.stderr


def test_unlike_bodies_have_a_fit_that_leaves_their_coupling_out(files):
    """Whatever the law of the case, whose own curve is predicted with the coupling."""
    case = files / "case.yaml"
    words = "youngs_modulus: [210 GPa, 70 GPa]"
    case.write_text(CASE.replace("youngs_modulus: 209.92 GPa", words), encoding="utf-8")
    out = files / "out"
    box = ("cells=24", "contact.domain=3")
    done = run(case, out, *box, options=("--fit-measured", files / "curve.csv"))
    assert "leaves out that the bodies are unlike" in done.stderr
    fit = json.loads((out / "measured_fit.json").read_text(encoding="utf-8"))
    assert fit["layer"]["left_out"] == "the coupling of unlike bodies"
    like = files / "like"
    alike = (*box, "contact.youngs_modulus=105 GPa")  # the same G and nu of both together
    run(case, like, *alike, options=("--fit-measured", files / "curve.csv"))
    other = json.loads((like / "measured_fit.json").read_text(encoding="utf-8"))
    assert "left_out" not in other["layer"]
    for name in ("mu0", "compliance"):
        assert fit["layer"][name]["value"] == pytest.approx(other["layer"][name]["value"], rel=1e-6)
    assert fit["predicted"]["rms_traction_ratio"] != other["predicted"]["rms_traction_ratio"]
