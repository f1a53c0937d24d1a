# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a point contact, mode moving: what is averaged, and surfaces on their way."""

import math

import numpy
import pytest
from patch_runs import CASE, creep_rows, gsf_map, numbers, run, table, wr_creep

# 64 cells on 4 semi-axes: a pass of 2a is 32 steps; rough enough to see, in the box on all passes
ROUGH = "{hurst: 0.8, rms_slope: 0.002, wavelength_min: 2.6 mm, wavelength_max: 10 mm}"
CELLS = ("cells=64", "contact.domain=4", f"roughness={ROUGH}", "mode=moving")
STEPS = 32


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


@pytest.mark.parametrize("start,discarded", [("steady", 2), ("rest", 4)])
def test_means_are_over_the_passes_that_are_kept(start, discarded, case, tmp_path):
    (row,) = creep_rows(case, tmp_path / "out", *CELLS, f"moving.start={start}")
    series = table(tmp_path / "out/series.csv")
    assert len(series) == 12 * STEPS == int(row["iterations"])
    for column, error in (("force_x", "force_x_se"), ("moment_z", "moment_z_se")):
        means = numbers(series, column).reshape(12, STEPS).mean(axis=1)[discarded:]
        assert float(row[column]) == pytest.approx(means.mean(), rel=1e-8)
        expected = means.std(ddof=1) / math.sqrt(len(means))
        assert float(row[error]) == pytest.approx(expected, rel=2e-3)
        assert expected > 0
    config = wr_creep(case, "--print-config", "--set", "mode=moving").stdout
    assert "passes: 12" in config


def test_few_passes_keep_half_of_them(case, tmp_path):
    (row,) = creep_rows(
        case, tmp_path / "out", *CELLS, "moving={passes: 4, start: rest}", "creep=5e-3"
    )
    series = table(tmp_path / "out/series.csv")
    kept = numbers(series[2 * STEPS :], "force_x")
    assert float(row["force_x"]) == pytest.approx(kept.mean(), rel=1e-8)


def test_spin_turns_rough_surfaces(case, tmp_path):
    """Full sliding by spin alone: the moment is that of friction about the middle, whatever the
    surfaces; they turn without harm, and a smooth contact does not see it."""
    spin = ("creep=0", "spin=0.05 1/mm", "moving.passes=3")
    (rough,) = creep_rows(case, tmp_path / "rough", *CELLS, *spin)
    (smooth,) = creep_rows(case, tmp_path / "smooth", *CELLS, *spin, "roughness=none")
    (frozen,) = creep_rows(
        case, tmp_path / "frozen", *CELLS[:2], "creep=0", "spin=0.05 1/mm", "roughness=none"
    )
    assert float(smooth["moment_z"]) == pytest.approx(float(frozen["moment_z"]), rel=2e-3)
    assert float(rough["moment_z"]) == pytest.approx(float(smooth["moment_z"]), rel=0.1)
    assert float(rough["real_area"]) < float(smooth["real_area"])


def test_no_error_without_two_passes(case, tmp_path):
    """Where one pass is kept there is nothing to scatter: no column, rather than a 0."""
    sequence = "sequence={time: [0 s, 1 ms], load: [10 kN, 11 kN]}"
    for number, change in enumerate(("moving.passes=2", sequence)):
        (row,) = creep_rows(case, tmp_path / str(number), "mode=moving", change)
        assert "products" in row and not [name for name in row if name.endswith("_se")]
    (row,) = creep_rows(case, tmp_path / "three", "mode=moving", "moving.passes=3")
    assert {"force_x_se", "force_y_se", "moment_z_se"} <= set(row)


def test_measured_maps_travel(case, tmp_path):
    """Surfaces that move at their own speeds: between the cells, and with spin."""
    for name, seed in (("rail", 1), ("wheel", 2)):
        gsf_map(tmp_path / f"{name}.gsf", seed, nx=300)
    changes = (
        "roughness={rail: rail.gsf, wheel: wheel.gsf, cutoff: 2.5 mm}",
        "mode=moving",
        "moving.passes=6",
        "contact.domain=2.6",
    )
    for drive in (("creep=1e-3",), ("creep=0", "lateral=1e-3"), ("creep=1e-3", "spin=1e-3 1/mm")):
        (row,) = creep_rows(case, tmp_path / "out", *changes, *drive)
        assert numpy.hypot(float(row["force_x"]), float(row["force_y"])) > 1000
        assert float(row["force_x_se"]) + float(row["force_y_se"]) > 0
    done = run(case, tmp_path / "short", *changes, "moving.passes=40", code=3)
    assert "the measured map ends" in done.stderr
