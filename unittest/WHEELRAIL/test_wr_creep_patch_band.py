# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a point contact: what the covariance of the friction law leaves open."""

import json

import numpy
import pytest
from patch_runs import CASE, creep_rows, numbers, run, table

LAW = {
    "format": "mca-friction-law 1",
    "mu0": 0.15,
    "mu1": 0.0442,
    "mu2": 0.3243,
    "b": 0.195,
    "c": 0.00212,
    "n": 34,
    "rms_relative": 0.09,
    "kappa1_range": [0, 5],
    "kappa2_range": [2, 1500],
    "source": "test",
}
FILE = CASE.replace("law: constant, mu: 0.3", "law: law.json, velocity_term: false")


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(FILE, encoding="utf-8")
    covariance = [[1e-4 if i == j == 0 else 0.0 for j in range(5)] for i in range(5)]
    text = json.dumps({**LAW, "covariance": covariance})
    (tmp_path / "law.json").write_text(text, encoding="utf-8")
    return path


def test_full_sliding_has_the_error_of_mu(case, tmp_path):
    """mu0 alone is uncertain, by 0.01: so are T/N, and the forces times the load."""
    run(case, tmp_path / "out", "creep=0.3", "lateral=0.4")
    (row,) = table(tmp_path / "out/creep_band.csv")
    (point,) = table(tmp_path / "out/creep.csv")
    assert float(row["standard_error"]) == pytest.approx(0.01, rel=1e-3)
    assert float(row["force_x_standard_error"]) == pytest.approx(0.6 * 0.01 * 1e4, rel=1e-2)
    assert float(row["force_y_standard_error"]) == pytest.approx(0.8 * 0.01 * 1e4, rel=1e-2)
    for name in ("force_x", "force_y", "moment_z", "traction_ratio"):
        assert row[name] == point[name]
    low, high = float(row["force_x_low"]), float(row["force_x_high"])
    assert high - low == pytest.approx(
        2 * 1.959964 * float(row["force_x_standard_error"]), rel=1e-4
    )


def test_derivatives_are_those_of_neighbouring_laws(case, tmp_path):
    """Linear: dF/dmu0 from two other laws, run by themselves, in partial slip and with heat."""
    changes = ("creep=[5e-4, 2e-3]", "spin=2e-4 1/mm", "thermal={model: local}")
    run(case, tmp_path / "out", *changes)
    band = table(tmp_path / "out/creep_band.csv")
    forces = []
    for mu0 in (0.145, 0.155):
        text = json.dumps({**LAW, "mu0": mu0})
        (tmp_path / "law.json").write_text(text, encoding="utf-8")
        forces.append(creep_rows(case, tmp_path / f"{mu0}", *changes))
    assert not (tmp_path / "0.145/creep_band.csv").exists()  # no covariance, no band
    for name in ("force_x", "force_y", "moment_z"):
        error = abs(numbers(forces[1], name) - numbers(forces[0], name))  # of one standard error
        assert numbers(band, f"{name}_standard_error") == pytest.approx(error, rel=0.03, abs=0.05)


def test_results_do_not_see_the_covariance(case, tmp_path):
    run(case, tmp_path / "with", "creep=[5e-4, 2e-3]", "thermal={model: averaged}")
    (tmp_path / "law.json").write_text(json.dumps(LAW), encoding="utf-8")
    run(case, tmp_path / "without", "creep=[5e-4, 2e-3]", "thermal={model: averaged}")
    for name in ("with", "without"):
        assert (tmp_path / name / "creep.csv").exists()
    assert (tmp_path / "with/creep.csv").read_bytes() == (
        tmp_path / "without/creep.csv"
    ).read_bytes()


def test_sampled(case, tmp_path):
    changes = ("uncertainty={method: sampled, samples: 100, seed: 3}", "creep=[1e-3, 0.3]")
    for threads in ("1", "2"):
        run(case, tmp_path / threads, *changes, options=("--threads", threads))
    first = (tmp_path / "1/creep_band.csv").read_text()
    assert first == (tmp_path / "2/creep_band.csv").read_text()
    rows = table(tmp_path / "1/creep_band.csv")
    # the standard deviation of 100 draws is known to 7 %
    assert float(rows[1]["standard_error"]) == pytest.approx(0.01, rel=0.25)
    for row in rows:
        assert float(row["force_x_low"]) < float(row["force_x"]) < float(row["force_x_high"])
    summary = json.loads((tmp_path / "1/summary.json").read_text())
    assert summary["uncertainty"] == {"samples": 100, "seed": 3, "redrawn_share": 0.0}


def test_forces_that_are_given_have_a_creepage_with_a_band(case, tmp_path):
    case.write_text(
        FILE.replace("creep: [1e-3]", "force: {longitudinal: -2 kN}\nlateral: 2e-4"),
        encoding="utf-8",
    )
    run(case, tmp_path / "out")
    (row,) = table(tmp_path / "out/creep_band.csv")
    assert float(row["found_creep"]) == float(row["creep"]) > 0
    assert 0 < float(row["found_creep_standard_error"]) < float(row["creep"])
    assert float(row["force_y_standard_error"]) > 0


def test_moving(case, tmp_path):
    """A smooth contact: the band of the steady state; and where there is none."""
    run(case, tmp_path / "frozen")
    run(case, tmp_path / "moving", "mode=moving", "moving.passes=2")
    frozen, moving = (table(tmp_path / m / "creep_band.csv")[0] for m in ("frozen", "moving"))
    assert float(moving["standard_error"]) == pytest.approx(
        float(frozen["standard_error"]), rel=0.01
    )
    assert numpy.sign(float(moving["force_x"])) == -1
    static = ("mode=static", "static.force_ratio=0.5")
    run(case, tmp_path / "static", *static)
    assert not (tmp_path / "static/creep_band.csv").exists()
    done = run(case, tmp_path / "bad", *static, "uncertainty.method=sampled", code=3)
    assert "uncertainty.method: does not go with mode static" in done.stderr


def test_a_line_to_quote(case, tmp_path):
    """T/N at the creep nearest 10 %: mean of two surfaces, the law's interval, what they span."""
    rough = "roughness={hurst: 0.8, rms_slope: 0.01, wavelength_min: 2.6 mm, "
    rough += "wavelength_max: 10 mm, "
    done = run(case, tmp_path / "out", rough + "seed: [1, 2]}", "creep=[0.01, 0.09, 0.3]")
    points = [r for r in table(tmp_path / "out/creep.csv") if float(r["creep"]) == 0.09]
    bands = [r for r in table(tmp_path / "out/creep_band.csv") if float(r["creep"]) == 0.09]
    ratios = [float(point["traction_ratio"]) for point in points]
    low, high = (numpy.mean([float(band[end]) for band in bands]) for end in ("low", "high"))
    speed = float(points[0]["speed"])
    assert (
        f"T/N at 9 % creep, {speed:g} m/s: {numpy.mean(ratios):.3f}, 95 % of law {low:.3f}.."
        f"{high:.3f}, of roughness {min(ratios):.3f}..{max(ratios):.3f} (2 surfaces)\n"
    ) in done.stdout
    done = run(case, tmp_path / "far", "creep=[0.01, 0.3]")
    assert "T/N at" in done.stdout and "% creep" not in done.stdout
