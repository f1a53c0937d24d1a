# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of wr_fit and of the scripts that read what it writes."""

import csv
import os
import subprocess

import friction_logs
import pytest
from wr_fit_run import PNG, TOOLS, one_line, wr_fit


def test_pictures(runs, log, tmp_path):
    assert wr_fit(runs, "-q", "--plot", tmp_path / "fit.png").returncode == 0
    assert (tmp_path / "fit.png").read_bytes().startswith(PNG)
    assert wr_fit(log, "-q", "--runs", tmp_path / "p.csv").returncode == 0
    made = subprocess.run(
        [TOOLS / "plot_friction.py", log, "-o", tmp_path / "mu.png", "--runs", tmp_path / "p.csv"],
        capture_output=True,
        text=True,
    )
    assert made.returncode == 0, made.stderr
    assert (tmp_path / "mu.png").read_bytes().startswith(PNG)


@pytest.mark.long
def test_picture_of_one_log(log, tmp_path):
    """Also where no folder for temporary files is there."""
    assert wr_fit(log, "-q", "--plot", tmp_path / "one.png").returncode == 0
    assert (tmp_path / "one.png").read_bytes().startswith(PNG)
    (tmp_path / "one.png").unlink()
    assert (
        wr_fit(
            log, "-q", "--plot", tmp_path / "one.png", env={**os.environ, "TMPDIR": "/missing"}
        ).returncode
        == 0
    )
    assert (tmp_path / "one.png").read_bytes().startswith(PNG)


@pytest.mark.parametrize(
    "against",
    [
        "pressure",
        *(pytest.param(x, marks=pytest.mark.long) for x in ("velocity", "viscosity", "strength")),
    ],
)
def test_figures_4_and_6(tmp_path, against):
    runs = friction_logs.campaign(
        tmp_path / "c", velocities=(2.5, 5), strengths_and_pressures=[(92, 5), (92, 15)]
    )
    wr_fit(runs, "-q", "-o", tmp_path / "fit.json")
    made = subprocess.run(
        [TOOLS / "plot_series.py", tmp_path / "fit.json", "--against", against]
        + ["-o", tmp_path / "x.png"],
        capture_output=True,
        text=True,
    )
    assert made.returncode == 0, made.stderr
    assert (tmp_path / "x.png").read_bytes().startswith(PNG)
    (tmp_path / "fit.json").write_text("{}")
    one_line(
        subprocess.run(
            [TOOLS / "plot_series.py", tmp_path / "fit.json", "--against", "velocity"],
            capture_output=True,
            text=True,
            cwd=tmp_path,
        ),
        3,
        "not wr_fit's JSON",
    )


def test_a_series_counts_what_wr_fit_counts(tmp_path):
    """A copy is no other seed, a run that sank is none with --solid-only; a light load, which only
    the law leaves out, is drawn."""
    heavy = [friction_logs.friction_log(seed=seed) for seed in (1, 2, 3)]
    head, rows = heavy[2].split("\nstep", 1)
    names, *rows = ("step" + rows).splitlines()
    names += " room lost flow_energy breaking_energy contact_energy"
    sunk = "\n".join([head, names, *(f"{row} 0.9 0 0 0 0" for row in rows)]) + "\n"
    light = friction_logs.friction_log(p=0.05)
    for k, text in enumerate((heavy[0], heavy[0], heavy[1], sunk, light)):
        (tmp_path / f"{k}.friction").write_text(text)
    wr_fit(tmp_path, "-q", "--solid-only", "-o", tmp_path / "fit.json")
    made = subprocess.run(
        [TOOLS / "plot_series.py", "fit.json", "--against", "pressure", "--csv", "a.csv"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert made.returncode == 0, made.stderr
    lines = (tmp_path / "a.csv").read_text().splitlines()[1:]
    found = {row["pressure"]: row["runs"] for row in csv.DictReader(lines)}
    assert found == {"0.05": "1", "15": "2"}


def test_missing_matplotlib_does_not_spoil_the_fit(log, tmp_path):
    (tmp_path / "matplotlib.py").write_text("raise ImportError('none here')\n")
    result = wr_fit(
        log,
        "-o",
        tmp_path / "fit.json",
        "--plot",
        tmp_path / "fit.png",
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert result.returncode == 5
    assert "matplotlib is missing" in result.stderr and "fit.png was not made" in result.stderr
    assert (tmp_path / "fit.json").exists() and not (tmp_path / "fit.png").exists()
    other = subprocess.run(
        [TOOLS / "plot_friction.py", log, "-o", tmp_path / "mu.png"],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    one_line(other, 1, "matplotlib is missing")


def test_plot_friction_refuses_bad_logs(log, tmp_path):
    good = log.read_text()
    for content, part in [
        ("", "not a friction log"),
        (good.replace(" 3456 2 1 -0.013\n", "\n", 1), ":10: "),
        (good.replace(" 15.0 ", " 15.0 nan ", 1), ":10: "),
        (good.replace("mca-friction 1", "mca-friction 2"), "'mca-friction 2'"),
    ]:
        log.write_text(content)
        made = subprocess.run(
            [TOOLS / "plot_friction.py", log, "-o", tmp_path / "mu.png"],
            capture_output=True,
            text=True,
        )
        one_line(made, 3, part)
        assert not (tmp_path / "mu.png").exists()
