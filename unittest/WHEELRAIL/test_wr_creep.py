# SPDX-License-Identifier: GPL-2.0-or-later
"""The command line of wr_creep: results, bad input, exit codes, interruption."""

import json
import math
import os
import re
import signal
import subprocess

import pytest
from line_runs import BIN, CASE, ROUGH, SOURCE, TABLE2, interrupted, law_file, table, wr_creep


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def test_carter_curve_and_files(case, tmp_path):
    done = wr_creep(case, "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    exact = [0.041062583, 0.096992529, 0.175105295, 0.234338297, 0.274691536, 0.296165011, 0.3]
    rows = table(tmp_path / "out/creep.csv")
    assert list(rows[0])[:3] == ["speed", "creep", "traction_ratio"]
    for row, value in zip(rows, exact, strict=True):
        heat = float(row["traction"]) * float(row["creep"])
        assert float(row["t_gamma"]) == pytest.approx(heat)
        # no more than mu p0
        assert 0 < float(row["peak_traction"]) < 0.3 * 542.1
        assert float(row["traction_ratio"]) == pytest.approx(value, abs=2e-4)
        assert float(row["traction"]) == pytest.approx(4000 * float(row["traction_ratio"]))
    contact = table(tmp_path / "out/contact.csv")
    assert len(contact) == 1000
    assert list(contact[0])[:6] == ["x", "pressure", "traction", "mu", "slip", "state"]
    assert max(float(row["pressure"]) for row in contact) == pytest.approx(542.0558, rel=3e-6)
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["hertz"]["half_width_mm"] == pytest.approx(4.697817, abs=1e-6)
    assert summary["contacts"][0]["real_area_ratio"] == pytest.approx(1.0, abs=1e-5)
    curve = json.loads((tmp_path / "out/creep.json").read_text())["curves"][0]
    for name in (
        "creep",
        "traction_ratio",
        "traction",
        "mu_mean",
        "temperature_rise",
        "stick_fraction",
    ):
        assert curve[name] == pytest.approx([float(row[name]) for row in rows], rel=1e-5)
    assert sorted(os.listdir(tmp_path / "out")) == [
        "contact.csv",
        "creep.csv",
        "creep.json",
        "summary.json",
    ]


def test_example_runs_and_is_table2(tmp_path):
    done = wr_creep(TABLE2, "-o", tmp_path, "-q")
    assert (done.returncode, done.stdout) == (0, "") and done.stderr.count("\n") == 1, done.stderr
    assert "bucher2006 is used outside of what it was fitted on" in done.stderr
    rows = [row for row in table(tmp_path / "creep.csv") if float(row["creep"]) == 0.1]
    assert [float(row["traction_ratio"]) for row in rows] == pytest.approx(
        [0.32092491, 0.31783216, 0.31419372], abs=1e-7
    )


def test_every_step_of_the_profile_is_said(case, tmp_path):
    done = wr_creep(case, "-o", tmp_path, "--set", ROUGH)
    assert "generated: rms height" in done.stdout and "active sets" not in done.stdout
    done = wr_creep(case, "-o", tmp_path, "-v", "--set", ROUGH)
    assert "generated: rms height" in done.stdout
    assert re.search(r"\d+ iterations, \d+ active sets, residual", done.stdout)
    steps = json.loads((tmp_path / "summary.json").read_text())["contacts"][0]["roughness"]
    assert steps[0]["rms_slope"] == pytest.approx(0.02, rel=0.05)


def test_measured_profiles(case, tmp_path):
    for name in ("rail", "wheel"):
        lines = ["# height: um", "# position: mm"]
        lines += [f"{0.01 * i:.3f}, {((i * 7919) % 13) * 0.1:.2f}" for i in range(2500)]
        (tmp_path / f"{name}.csv").write_text("\n".join(lines), encoding="utf-8")
    done = wr_creep(
        case,
        "-o",
        tmp_path / "out",
        "--set",
        "roughness={rail: rail.csv, wheel: wheel.csv, cutoff: 0.1 mm}",
    )
    assert done.returncode == 0, done.stderr
    for step in (
        "rail: as read",
        "rail: detrended",
        "wheel: filtered",
        "wheel: resampled",
        "sum of both",
    ):
        assert step in done.stdout
    one = [row["traction"] for row in table(tmp_path / "out/creep.csv")]
    done = wr_creep(
        case,
        "-o",
        tmp_path / "two",
        "--set",
        "roughness={rail: [wheel.csv, rail.csv], wheel: [rail.csv, wheel.csv], cutoff: 0.1 mm}",
    )
    assert done.returncode == 0 and "profile 2: wheel: filtered" in done.stdout
    two = table(tmp_path / "two/creep.csv")
    assert [row["profile"] for row in two] == ["1"] * 7 + ["2"] * 7
    assert [row["traction"] for row in two[7:]] == one
    done = wr_creep(case, "-o", tmp_path / "bad", "--set", "roughness={rail: missing.csv}")
    assert done.returncode == 3 and "missing.csv" in done.stderr


def test_law_file_with_covariance_gives_a_band(case, tmp_path):
    covariance = [[1e-4 if i == j == 0 else 0.0 for j in range(5)] for i in range(5)]
    (tmp_path / "law.json").write_text(json.dumps(law_file(covariance)), encoding="utf-8")
    case.write_text(CASE.replace("law: constant, mu: 0.3", "law: law.json"), encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "out", "--set", "creep=[0.01, 0.05]")
    assert done.returncode == 0, done.stderr
    for row in table(tmp_path / "out/creep_band.csv"):
        assert float(row["standard_error"]) == pytest.approx(0.01, rel=1e-3)
        assert float(row["low"]) < float(row["traction_ratio"]) < float(row["high"])
    assert json.loads((tmp_path / "out/creep.json").read_text())["curves"][0][
        "standard_error"
    ] == pytest.approx([0.01, 0.01], rel=1e-3)


def test_static_case(case, tmp_path):
    """Cattaneo, Mindlin: T/N = 0.3 x ratio, stick zone a sqrt(1 - ratio) in the middle."""
    done = wr_creep(
        case,
        "-o",
        tmp_path / "out",
        "--set",
        "mode=static",
        "--set",
        "static.force_ratio=[0.19, 0.64]",
    )
    assert done.returncode == 0, done.stderr
    for row, ratio in zip(table(tmp_path / "out/static.csv"), (0.19, 0.64), strict=True):
        assert float(row["traction_ratio"]) == pytest.approx(0.3 * ratio)
        assert float(row["stick_length"]) == pytest.approx(
            2 * 4.697817 * (1 - ratio) ** 0.5, rel=1e-4
        )
        assert float(row["stick_centre"]) == pytest.approx(0, abs=1e-6)
    assert sorted(os.listdir(tmp_path / "out")) == ["contact.csv", "static.csv", "summary.json"]
    states = [row["state"] for row in table(tmp_path / "out/contact.csv")]
    assert states == states[::-1] and states.count("stick") == pytest.approx(500 * 0.6, abs=2)
    assert len(json.loads((tmp_path / "out/summary.json").read_text())["forces"]) == 2


def test_periodic_case_is_westergaard(tmp_path):
    flat = SOURCE / "examples/wheelrail/periodic.yaml"
    wave = "roughness={hurst: 0.8, rms_height: 10 um, wavelength_min: 10 mm, wavelength_max: 10 mm}"
    done = wr_creep(flat, "-o", tmp_path, "--set", wave, "--set", "cells=256")
    assert done.returncode == 0, done.stderr
    modulus, amplitude = 210e9 / (2 * (1 - 0.09)), 10e-6 * 2**0.5
    share = 2e6 / 0.01 / (math.pi * modulus * amplitude / 0.01)
    exact = 20 / math.pi * math.asin(share**0.5)
    assert float(table(tmp_path / "static.csv")[0]["stick_length"]) == pytest.approx(
        exact, abs=0.01
    )
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary["periodic"]["mean_pressure_MPa"] == pytest.approx(200)
    assert summary["contacts"][0]["peak_pressure_MPa"] == pytest.approx(
        400 / share**0.5, rel=1e-3
    )
    done = wr_creep(flat, "-o", tmp_path / "bad", "--set", "mode=frozen")
    assert done.returncode == 3 and "contact.period" in done.stderr


def test_sampled_band(case, tmp_path):
    covariance = [[1e-4 if i == j == 0 else 0.0 for j in range(5)] for i in range(5)]
    (tmp_path / "law.json").write_text(json.dumps(law_file(covariance)), encoding="utf-8")
    case.write_text(CASE.replace("law: constant, mu: 0.3", "law: law.json"), encoding="utf-8")
    sampled = [
        "--set",
        "creep=[0.01, 0.05]",
        "--set",
        "uncertainty={method: sampled, samples: 400}",
    ]
    for threads in ("1", "3"):
        done = wr_creep(case, "-o", tmp_path / threads, "--threads", threads, *sampled)
        assert done.returncode == 0, done.stderr
    assert (tmp_path / "1/creep_band.csv").read_text() == (
        tmp_path / "3/creep_band.csv"
    ).read_text()
    for row in table(tmp_path / "1/creep_band.csv"):
        assert float(row["standard_error"]) == pytest.approx(0.01, rel=0.12)
        assert float(row["high"]) - float(row["low"]) == pytest.approx(4 * 0.01, rel=0.15)
    assert json.loads((tmp_path / "1/summary.json").read_text())["uncertainty"]["samples"] == 400


def test_print_config_is_a_case_file(case, tmp_path):
    first = wr_creep(case, "--print-config", "--set", "cells=512")
    assert first.returncode == 0 and "cells: 512" in first.stdout
    (tmp_path / "again.yaml").write_text(first.stdout, encoding="utf-8")
    assert wr_creep(tmp_path / "again.yaml", "--print-config").stdout == first.stdout


BAD_FILES = {
    "empty": ("", "is empty"),
    "blank": ("# nothing here\n", "not a case file"),
    "truncated": (CASE[:120], ""),
    "cut in a line": (CASE[: CASE.index("creep")], "creep"),
    "no number": (CASE.replace("4000 N/mm", "much"), "'much' is not a number"),
    "nan": (CASE.replace("0.5 m", "nan m"), "contact.radius: 'nan m' is not finite"),
    "inf": (CASE.replace("210 GPa", "inf GPa"), "not finite"),
    "negative": (CASE.replace("4000 N/mm", "-4000 N/mm"), "allowed range"),
    "unknown": (CASE.replace("cells", "cels"), "nearest known one is 'cells'"),
    "unit": (CASE.replace("20 m/s", "20 MPa"), "another dimension than m/s"),
    "no unit": (CASE.replace("0.5 m", "0.5"), "no unit"),
    "binary": ("\0\1\2", ""),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_bad_case_files(name, case, tmp_path):
    text, expected = BAD_FILES[name]
    case.write_text(text, encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "out")
    assert done.returncode == 3
    assert len(done.stderr.strip().splitlines()) == 1
    assert "case.yaml" in done.stderr and expected in done.stderr, done.stderr
    assert not (tmp_path / "out").exists()


def test_bad_law_and_missing_files(case, tmp_path):
    (tmp_path / "law.json").write_text('{"format": "mca-fric', encoding="utf-8")
    for arguments in (
        ["missing.yaml"],
        [tmp_path],
        [case, "--set", f"friction.law={tmp_path}/law.json"],
        [case, "--set", "friction.law=none.json"],
    ):
        if len(arguments) > 1:
            case.write_text(CASE.replace(", mu: 0.3", ""), encoding="utf-8")
        done = wr_creep(*arguments, "-o", tmp_path / "out")
        assert done.returncode == 3, done.stderr
        assert len(done.stderr.strip().splitlines()) == 1


def test_usage_errors(case):
    for arguments, part in (
        (["--sett", "cells=3"], "--set"),
        (["--set", "cells"], "KEYWORD=VALUE"),
        (["--set", "contact.radus=1 m"], "contact.radius"),
        (["--threads", "0"], "threads"),
        (["other.yaml"], "one case file"),
    ):
        done = wr_creep(case, *arguments)
        assert done.returncode == 2, arguments
        assert part in done.stderr
        assert len(done.stderr.strip().splitlines()) == 1
    assert wr_creep().returncode == 2


def test_unwritable_output(case, tmp_path):
    (tmp_path / "file").write_text("x", encoding="utf-8")
    for folder in (tmp_path / "file", tmp_path / "file/below", "/proc/wr_creep"):
        done = wr_creep(case, "-o", folder)
        assert done.returncode == 5, done.stderr
        assert len(done.stderr.strip().splitlines()) == 1
    assert (tmp_path / "file").read_text() == "x"


def test_results_do_not_overwrite_inputs(case, tmp_path):
    """A measured profile, or a law, may lie where the results go and have the name of one."""
    lines = ["# height: um", "# position: mm"] + [f"{0.01 * i:.3f}, {i % 2}" for i in range(2500)]
    profile = tmp_path / "contact.csv"
    profile.write_text("\n".join(lines), encoding="utf-8")
    law = tmp_path / "summary.json"
    law.write_text(json.dumps(law_file(None)), encoding="utf-8")
    for file, change in (
        (profile, "roughness={rail: contact.csv}"),
        (law, "friction={law: summary.json, mu: null}"),
    ):
        content = file.read_bytes()
        if file == law:
            case.write_text(
                CASE.replace("{law: constant, mu: 0.3}", "{law: summary.json}"), encoding="utf-8"
            )
        done = wr_creep(case, "-o", tmp_path, *(["--set", change] if file == profile else []))
        assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
        assert f"{file.name} is an input, it would be overwritten" in done.stderr
        assert file.read_bytes() == content and not (tmp_path / "creep.csv").exists()


def test_lost_report_is_an_error(case):
    with open("/dev/full", "w", encoding="utf-8") as full:
        done = subprocess.run(
            [BIN, case, "--print-config"], stdout=full, stderr=subprocess.PIPE, text=True
        )
    assert (
        done.returncode == 5
        and done.stderr == "wr_creep: standard output: cannot write: No space left on device\n"
    )


def test_not_converged(case, tmp_path):
    done = wr_creep(
        case,
        "-o",
        tmp_path / "out",
        "--set",
        "friction={law: bucher2006}",
        "--set",
        "thermal={conductivity: 0.01 W/(m K)}",
        "--set",
        "creep=0.9",
    )
    assert done.returncode == 4, done.stderr
    assert not (tmp_path / "out/creep.csv").exists()


def test_points_that_do_not_converge_leave_the_others(case, tmp_path):
    """The hottest creeps leave no strength: they are named, the others are those of a run alone."""
    sets = ["--set", "friction={law: law.json}", "--set", "thermal={conductivity: 0.01 W/(m K)}"]
    law = law_file(None) | {"kappa2_range": [0, 1e9]}
    (tmp_path / "law.json").write_text(json.dumps(law), encoding="utf-8")
    for mode, creeps in (("frozen", "[0.9, 1e-6, 0.5, 2e-6]"), ("moving", "[0.9, 1e-6, 2e-6]")):
        out = tmp_path / mode
        more = ["--set", f"mode={mode}", "--set", "cells=256", "--set", "moving.passes=2"]
        more = more if mode == "moving" else more[:4]
        done = wr_creep(case, "-o", out, "-q", *sets, *more, "--set", f"creep={creeps}")
        assert done.returncode == 4, done.stderr
        bad = creeps.count("0.")
        lines = done.stderr.splitlines()
        assert "point 1 (speed 20 m/s, creep 0.9): " in lines[0], lines
        assert f"{bad} of {bad + 2} operating points did not converge" in lines[-1], lines
        rows = table(out / "creep.csv")
        assert [float(row["creep"]) for row in rows] == [1e-6, 2e-6]
        summary = json.loads((out / "summary.json").read_text())
        assert len(summary["not_converged"]) == bad and summary["points"] == bad + 2
        assert not (out / "wr_creep.journal").exists()
        alone = tmp_path / f"{mode}-alone"
        done = wr_creep(case, "-o", alone, "-q", *sets, *more, "--set", "creep=[1e-6, 2e-6]")
        assert done.returncode == 0, done.stderr
        if mode == "moving":
            assert table(alone / "creep.csv") == rows
        for row, other in zip(rows, table(alone / "creep.csv"), strict=True):
            assert float(row["traction_ratio"]) == pytest.approx(
                float(other["traction_ratio"]), rel=1e-6
            )
    # the last point failed: its fields are not there, and no others stand for them
    more = ["--set", "creep=[1e-6, 0.9]"]
    wr_creep(case, "-o", tmp_path / "last", "-q", *sets, *more)
    text = (tmp_path / "last/contact.csv").read_text()
    assert "creep 0.9, which did not converge" in text
    assert table(tmp_path / "last/contact.csv") == []


@pytest.mark.parametrize("mode", ["frozen", pytest.param("moving", marks=pytest.mark.long)])
def test_braking_is_driving_turned_around(mode, case, tmp_path):
    """Negative creeps, and those in per cent, on a rough line with heat and a band."""
    (tmp_path / "law.json").write_text(
        json.dumps(law_file([[1e-4 * (i == j) for j in range(5)] for i in range(5)])),
        encoding="utf-8",
    )
    sets = ["--set", ROUGH, "--set", "friction={law: law.json, local: true}"]
    sets += ["--set", "thermal={model: local}", "--set", "fields=[1, 2]"]
    sets += ["--set", f"mode={mode}", "--set", "cells=512"]
    sets += ["--set", "roughness.wavelength_min=0.4 mm"]
    for sign, creeps in (("+", "[0.1 %, 3 %]"), ("-", "[-0.1 %, -3 %]")):
        done = wr_creep(case, "-o", tmp_path / sign, "-q", *sets, "--set", f"creep={creeps}")
        assert done.returncode == 0, done.stderr
    turned = ("creep", "traction_ratio", "traction")
    for there, back in zip(
        table(tmp_path / "+/creep.csv"), table(tmp_path / "-/creep.csv"), strict=True
    ):
        for name, value in there.items():
            factor = -1 if name in turned else 1
            assert float(back[name]) == factor * float(value), name
    for there, back in zip(
        table(tmp_path / "+/creep_band.csv"), table(tmp_path / "-/creep_band.csv"), strict=True
    ):
        assert float(back["low"]) == -float(there["high"]) < -float(there["low"])
        assert back["standard_error"] == there["standard_error"]
    for number in (1, 2):
        name = f"contact_{number:04d}.csv"
        rows = zip(table(tmp_path / "+" / name), table(tmp_path / "-" / name), strict=True)
        for there, back in rows:
            assert float(back["traction"]) == -float(there["traction"])
            assert (back["pressure"], back["state"]) == (there["pressure"], there["state"])
    curve = json.loads((tmp_path / "-/summary.json").read_text())["curves"][0]
    assert curve["peak_traction_ratio"] < -0.1 and curve["last_over_peak"] > 0


def test_contacts_of_chosen_points(case, tmp_path):
    wr_creep(case, "-o", tmp_path / "last", "-q")
    done = wr_creep(case, "-o", tmp_path / "some", "-q", "--set", "fields=[2, 7]")
    assert done.returncode == 0, done.stderr
    names = sorted(p.name for p in (tmp_path / "some").glob("contact*"))
    assert names == ["contact_0002.csv", "contact_0007.csv"]
    last = (tmp_path / "last/contact.csv").read_text()
    assert (tmp_path / "some/contact_0007.csv").read_text() == last
    second = (tmp_path / "some/contact_0002.csv").read_text()
    assert "\n# speed 20 m/s, creep 0.0005;" in second and second != last
    wr_creep(case, "-o", tmp_path / "none", "-q", "--set", "fields=none")
    assert not list((tmp_path / "none").glob("contact*"))
    wr_creep(case, "-o", tmp_path / "all", "-q", "--set", "fields=all")
    assert len(list((tmp_path / "all").glob("contact_*.csv"))) == 7
    done = wr_creep(case, "-o", tmp_path / "x", "--set", "fields=8")
    assert (
        done.returncode == 3
        and "fields: '8' is above the number of operating points, 7" in done.stderr
    )
    done = wr_creep(case, "-o", tmp_path / "x", "--set", "fields=first")
    assert done.returncode == 3 and "'first' is not allowed" in done.stderr
    still = ["--set", "mode=static", "--set", "static.force_ratio=[0.1, 0.5]"]
    wr_creep(case, "-o", tmp_path / "still", "-q", *still, "--set", "fields=1")
    assert "T/(mu N) = 0.1;" in (tmp_path / "still/contact_0001.csv").read_text()


def test_load_on_a_width(case, tmp_path):
    """4000 N/mm are 80 kN on 20 mm; without a width a load means a point contact."""
    wr_creep(case, "-o", tmp_path / "line", "-q")
    text = CASE.replace("load_per_length: 4000 N/mm", "load: 80 kN, width: 20 mm")
    case.write_text(text, encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "width", "-q")
    assert done.returncode == 0, done.stderr
    assert table(tmp_path / "line/creep.csv") == table(tmp_path / "width/creep.csv")
    for change, part in (
        ("contact.load_per_length=4 N/mm", "contact.load_per_length: does not go with contact.wid"),
        ("contact.load=[1 kN, 2 kN]", "contact.load: one value is expected"),
        ("contact.semi_axes=[5 mm, 5 mm]", "does not go with a line contact (contact.width)"),
    ):
        done = wr_creep(case, "-o", tmp_path / "x", "--set", change)
        assert done.returncode == 3 and part in done.stderr, done.stderr
        assert done.stderr.count("\n") == 1
    case.write_text(text.replace("load: 80 kN, ", ""), encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "x")
    assert done.returncode == 3 and "contact.width: needs contact.load" in done.stderr
    case.write_text(text.replace(", width: 20 mm", ""), encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "x")
    assert done.returncode == 3
    assert "contact.radius: does not go with contact.load: a point contact" in done.stderr
    assert "contact.width" in done.stderr


def test_friction_from_a_table_and_of_polachs_form(case, tmp_path):
    """In full sliding T/N is mu: of the sliding speed, and of the load's mean pressure."""
    head = "# pressure: MPa\n# speed: m/s\npressure,speed,mu\n"
    flat = "0,0,0.4\n0,4,0.2\n600,0,0.4\n600,4,0.2\n"
    (tmp_path / "mu.csv").write_text(head + flat, encoding="utf-8")
    sliding = ["--set", "creep=[5 %, 15 %]", "--set", "friction={law: mu.csv}"]
    done = wr_creep(case, "-o", tmp_path / "a", "-q", *sliding)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    ratios = [float(row["traction_ratio"]) for row in table(tmp_path / "a/creep.csv")]
    assert ratios == pytest.approx([0.4 - 0.05 * 1, 0.4 - 0.05 * 3], abs=1e-4)
    summary = json.loads((tmp_path / "a/summary.json").read_text())
    assert summary["law"]["format"] == "table" and summary["warnings"] == []
    assert summary["law_use"]["sliding_speed_m_s"] == [1, 3]
    # mu = 0.5 - p/3000 MPa; mean of p under the load of Hertz: 8 p0/(3 pi)
    (tmp_path / "mu.csv").write_text(head + "0,1,0.5\n600,1,0.3\n", encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "b", "-q", *sliding)
    assert done.returncode == 0 and done.stderr.count("\n") == 1
    assert "sliding speed in m/s 1 to 3 (1)" in done.stderr
    ratios = [float(row["traction_ratio"]) for row in table(tmp_path / "b/creep.csv")]
    assert ratios[0] == pytest.approx(0.5 - 8 * 542.06 / (3 * math.pi) / 3000, abs=2e-4)
    assert json.loads((tmp_path / "b/summary.json").read_text())["warnings"][0] in done.stderr
    done = wr_creep(
        case, "-o", tmp_path / "c", "-q", "--set", "creep=[5 %, 15 %]",
        "--set", "friction={law: polach, mu0: 0.4, A: 0.5, B: 0.8 s/m}",
    )  # fmt: skip
    assert done.returncode == 0 and done.stderr == "", done.stderr
    ratios = [float(row["traction_ratio"]) for row in table(tmp_path / "c/creep.csv")]
    assert ratios == pytest.approx(
        [0.4 * (0.5 * math.exp(-0.8 * v) + 0.5) for v in (1, 3)], abs=1e-4
    )
    for change, part in (
        ("friction={law: polach, mu0: 0.4}", "friction.A: is missing"),
        ("friction={law: mu.csv, mu: 0.3}", "friction.mu: goes with 'law: constant' only"),
        ("friction={law: constant, mu: 0.3, B: 1 s/m}", "friction.B: goes with 'law: polach' only"),
        ("friction={law: none.csv}", "none.csv"),
    ):
        done = wr_creep(case, "-o", tmp_path / "x", "--set", change)
        assert done.returncode == 3 and part in done.stderr, done.stderr
    still = ["--set", "mode=static", "--set", "static.force_ratio=0.5"]
    done = wr_creep(case, "-o", tmp_path / "x", "--set", "friction={law: mu.csv}", *still)
    assert done.returncode == 3 and "one friction coefficient for the whole contact" in done.stderr
    done = wr_creep(
        SOURCE / "examples/wheelrail/table2.yaml", "-o", tmp_path / "d", "-q",
        "--set", f"friction.law={SOURCE / 'examples/wheelrail/friction.csv'}",
    )  # fmt: skip
    assert done.returncode == 0 and done.stderr == "", done.stderr


def test_use_outside_of_the_fit_is_said(case, tmp_path):
    law = law_file(None) | {"kappa3_range": [2239, 2239], "kappa2_range": [10, 300]}
    (tmp_path / "law.json").write_text(json.dumps(law), encoding="utf-8")
    sets = ["--set", "friction={law: law.json}", "--set", "creep=[0.01]"]
    done = wr_creep(case, "-o", tmp_path / "a", "-q", *sets)
    assert done.returncode == 0 and done.stderr.count("\n") == 1
    kappas = "E/sigma_0 206 (2239)", "kappa2 43.7 to 616.5 (10 to 300)"
    for part in ("law.json is used outside", *kappas):
        assert part in done.stderr, done.stderr
    summary = json.loads((tmp_path / "a/summary.json").read_text())
    assert summary["law_use"]["kappa3"] == pytest.approx([206, 206])
    assert summary["law"]["kappa3_range"] == [2239, 2239]
    assert f"wr_creep: warning: {summary['warnings'][0]}\n" == done.stderr
    # a strength that fits the law, pressures of the contact: inside
    more = ["--set", "friction.strength=92 MPa", "--set", "friction.local=true"]
    more += ["--set", "contact.load_per_length=10 N/mm"]
    done = wr_creep(case, "-o", tmp_path / "b", "-q", *sets, *more)
    assert done.returncode == 0 and "kappa2" in done.stderr
    assert "E/sigma_0" not in done.stderr, done.stderr
    bare = {name: law[name] for name in ("format", "mu0", "mu1", "mu2", "b", "c")}
    (tmp_path / "law.json").write_text(json.dumps(bare), encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "c", "-q", *sets)
    assert (done.returncode, done.stderr) == (0, "")


def test_interrupted_run_goes_on(case, tmp_path):
    many = [case, "--set", ROUGH, "--set", "cells=2048", "--threads", "1"]
    many += ["--set", "creep={from: 1e-4, to: 0.1, n: 4000}"]
    message = interrupted(signal.SIGINT, tmp_path / "out", *many)
    assert "run the same command again to continue" in message
    done = wr_creep(*many, "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["points"] == 4000 and summary["points_resumed"] > 0
    assert not (tmp_path / "out/wr_creep.journal").exists()


def test_friction_settles_where_the_pressure_jumps(tmp_path):
    """Rough, with hardness and local temperature: at one of these creeps a cell opens and closes in
    turn, so that temperature and pressure have no common solution to the last digit."""
    sets = [
        "friction={law: bucher2006, local: true}",
        "speed=10 m/s",
        "contact.hardness_limit=true",
    ]
    sets += ["thermal={model: local, conductivity: 50 W/(m K), density: 7800 kg/m3, "]
    sets[-1] += "specific_heat: 450 J/(kg K)}"
    sets += ["roughness={hurst: 0.8, rms_slope: 0.02, wavelength_min: 0.1 mm, "]
    sets[-1] += "wavelength_max: 10 mm, seed: 1}"
    sets += ["creep={from: 0.12, to: 0.2, n: 41, spacing: linear}"]
    words = [word for change in sets for word in ("--set", change)]
    done = wr_creep(TABLE2, "-o", tmp_path, "-q", *words)
    assert done.returncode == 0, done.stderr
    ratio = [float(row["traction_ratio"]) for row in table(tmp_path / "creep.csv")]
    assert len(ratio) == 41
    falls = [a - b for a, b in zip(ratio, ratio[1:])]
    assert all(0 < fall < 0.001 for fall in falls)
