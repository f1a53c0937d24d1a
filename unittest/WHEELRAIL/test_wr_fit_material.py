# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_fit --material: logs of one material at several temperatures, whose law is known, and the
contact that uses what is fitted."""

import json
import os
import pathlib
import subprocess

import pytest

import friction_logs
from wr_fit_run import WR_FIT, one_line, wr_fit

LONG = pytest.mark.long
STEEL = pathlib.Path(os.environ["PROJECT_SOURCE"]) / "potentials" / "rail_steel.mca"
# K: sigma_0, E in MPa, as the file says
AT = {293: (900, 206000), 673: (720, 144200), 873: (338.4, 63860)}
RATIOS = (0.03, 0.1, 0.3, 0.7, 1.3, 2.6)
MU0, S, Q = 0.45, 0.5, 4.0
POWER = {0.7: 0.2}  # of the speed, by p/sigma_0; else 0.1


def bounded(ratio):
    return (MU0**-Q + (S / ratio) ** -Q) ** (-1 / Q)


def logs(folder, mu=bounded, at=AT, speeds=(5,), noise=0.02):
    folder.mkdir()
    number = 0
    for kelvin, (strength, E) in at.items():
        for ratio in RATIOS:
            for v in speeds:
                number += 1
                p = ratio * strength
                usual = friction_logs.eq2(*friction_logs.kappas(p, v, strength, E))
                wanted = mu(ratio) * (v / 5) ** POWER.get(ratio, 0.1)
                text = friction_logs.friction_log(
                    p=p, v=v, strength=strength, E=E, seed=number, factor=wanted / usual,
                    ns=20, noise=noise, grinding_in=0,
                )  # fmt: skip
                (folder / f"k{kelvin}-x{ratio}-v{v}.friction").write_text(text)
    return folder


def test_the_form_comes_back_with_its_errors(tmp_path):
    done = wr_fit(
        logs(tmp_path / "logs"),
        "--material",
        STEEL,
        "--model",
        "bounded",
        "-o",
        tmp_path / "l.json",
    )
    assert done.returncode == 0, done.stderr
    law = json.loads((tmp_path / "l.json").read_text())
    assert law["format"] == "mca-friction-law 2" and law["n"] == 18
    errors = {name: law["covariance"][k][k] ** 0.5 for name, k in (("mu0", 0), ("s", 6), ("q", 7))}
    for name, value in (("mu0", MU0), ("s", S), ("q", Q)):
        assert abs(law[name] - value) < 4 * errors[name] < value, name
    assert law["temperature"][0] == 293 and law["strength"][-1] == pytest.approx(79.2)
    assert law["pressure_range"] == pytest.approx([0.03, 2.6])
    assert law["temperature_range"] == pytest.approx([293, 873])
    models = {m["model"]: m.get("delta_aicc") for m in law["report"]["models"]}
    assert models["bounded"] < 5 and models["eq4"] > 10  # the paper's form knows no limit
    assert "Fit of bounded: mu = (B^-q + (s sigma_0/p)^-q)^(-1/q), B = mu0" in done.stdout


def test_the_table_has_the_conditions_and_the_power_of_the_speed(tmp_path):
    done = wr_fit(
        logs(tmp_path / "logs", speeds=(5, 1)), "--material", STEEL, "--model", "table",
        "-o", tmp_path / "l.json",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    law = json.loads((tmp_path / "l.json").read_text())
    assert law["table_temperature"] == pytest.approx(list(AT))
    for ratios, mus, errors in zip(law["table_pressure"], law["table_mu"], law["table_mu_se"]):
        assert ratios == pytest.approx(RATIOS)
        for ratio, mu, error in zip(ratios, mus, errors):
            assert abs(mu - bounded(ratio)) < 4 * error < 0.2 * mu
    assert law["speed_pressure"] == pytest.approx(RATIOS)
    for ratio, power, error in zip(RATIOS, law["speed_exponent"], law["speed_exponent_se"]):
        assert abs(power - POWER.get(ratio, 0.1)) < 4 * error < 0.06
    assert "[0.7] 0." in done.stdout
    assert law["reference_velocity"] == 5 and law["velocity_range"] == [1, 5]


def test_temperatures_that_are_close_are_one_row(tmp_path):
    """673 K and 676 K: the pressures of both rise along one row, which wr_creep reads."""
    folder = logs(tmp_path / "logs")
    for log, ratio, mu in (("a", 0.2, 0.44), ("b", 1.0, 0.41)):
        share = (676 - 673) / (773 - 673)
        strength, E = 720 + share * (561.6 - 720), 144200 + share * (123600 - 144200)
        usual = friction_logs.eq2(*friction_logs.kappas(ratio * strength, 5, strength, E))
        text = friction_logs.friction_log(
            p=ratio * strength, strength=strength, E=E, seed=50, factor=mu / usual, grinding_in=0
        )
        (folder / f"{log}.friction").write_text(text)
    done = wr_fit(folder, "--material", STEEL, "--model", "table", "-o", tmp_path / "l.json")
    assert done.returncode == 0, done.stderr
    law = json.loads((tmp_path / "l.json").read_text())
    assert law["table_temperature"] == pytest.approx(list(AT))
    assert law["table_pressure"][1] == pytest.approx(sorted((*RATIOS, 0.2, 1.0)), rel=1e-3)


def test_a_table_holds_no_run_that_does_not_slide(tmp_path):
    folder = logs(tmp_path / "logs")
    still = friction_logs.friction_log(p=90, v=0, strength=900, seed=50, grinding_in=0)
    (folder / "still.friction").write_text(still)
    done = wr_fit(folder, "--material", STEEL, "--model", "table")
    one_line(done, 4, "still.friction: does not slide, 0 m/s")


def test_a_contact_takes_it(tmp_path):
    """Smooth and cold: mu of the mean pressure's cells; the keywords of other laws are refused."""
    wr_fit(
        logs(tmp_path / "logs"), "--material", STEEL, "--model", "table", "-o", tmp_path / "l.json"
    )
    case = tmp_path / "case.yaml"
    case.write_text(
        "contact: {load_per_length: 4000 N/mm, radius: 0.5 m, youngs_modulus: 210 GPa,\n"
        "  poissons_ratio: 0.3}\n"
        "roughness: none\nfriction: {law: l.json}\nthermal: {model: local}\n"
        "creep: [0.01, 0.1]\nspeed: 20 m/s\ncells: 256\n"
    )

    def wr_creep(*more):
        words = [WR_FIT.with_name("wr_creep"), case, "-o", tmp_path / "out", *more]
        return subprocess.run(words, capture_output=True, text=True, timeout=60, check=False)

    done = wr_creep()
    assert done.returncode == 0, done.stderr
    assert "sliding speed in m/s 0.2 to 2 (5)" in done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["law_use"]["pressure_over_strength"][1] < 1
    text = (tmp_path / "out" / "creep_band.csv").read_text()
    rows = [line for line in text.splitlines() if line[:1].isdigit()]
    low, high = (float(x) for x in rows[0].split(",")[-2:])
    assert low < float(rows[0].split(",")[2]) < high
    one_line(wr_creep("--set", "friction.strength=800 MPa"), 3, "friction.strength", "its material")
    warm = wr_creep("--set", "friction.ambient=900 K")
    assert "temperature in K" in warm.stderr


@pytest.mark.parametrize(
    "at, more, code, parts",
    [
        (AT, ["--model", "bounded"], 2, ["--model bounded", "needs --material"]),
        (AT, ["--model", "table"], 2, ["--model table"]),
        (AT, ["--material", STEEL, "--model", "table", "--level", 0.9], 2, ["--level", "table"]),
        (
            AT,
            ["--material", STEEL, "--model", "bounded", "--kappa3", 300],
            2,
            ["--kappa3: goes with velocity_kappa3, eq2_kappa3, bounded_kappa3, not with bounded"],
        ),
        (
            AT,
            ["--material", STEEL, "--model", "eq2_ductility"],
            2,
            ["--model eq2_ductility: does not go with --material", "eq2_kappa3"],
        ),
        (AT, ["--model", "eq2_kappa3", "--ductility", 90], 2, ["--ductility: goes with eq2_d"]),
        (AT, ["--material", "none.mca"], 3, ["none.mca"]),
        ({0: (92, 206000)}, ["--material", STEEL], 3, ["strength 92", "at no temperature"]),
    ],
)
def test_what_is_refused(tmp_path, at, more, code, parts):
    lines = wr_fit(logs(tmp_path / "logs", at=at), *more).stderr.splitlines()
    result = wr_fit(tmp_path / "logs", *more)
    assert result.returncode == code
    assert all(part in lines[-1] for part in parts)


def test_solid_only_leaves_out_what_sank(tmp_path):
    """A run below 1 - p/K - 0.03 counts with the others, or not."""
    folder = logs(tmp_path / "logs")
    sunk = sorted(folder.iterdir())[0]
    head, rows = sunk.read_text().split("\nstep", 1)
    rows = ("step" + rows).splitlines()
    names = f"{rows[0]} room lost flow_energy breaking_energy contact_energy"
    body = [f"{row} 0.9 0 0 0 0" for row in rows[1:]]
    sunk.write_text("\n".join([head, names, *body]) + "\n")
    counts = []
    for more in ([], ["--solid-only"]):
        done = wr_fit(folder, "--material", STEEL, "--model", "bounded", "-o", tmp_path / "l.json",
                      *more)  # fmt: skip
        counts.append(json.loads((tmp_path / "l.json").read_text())["n"])
    assert counts == [18, 17] and "[left out: no solid: room 0.900 < 0.9" in done.stdout


@LONG
def test_the_chain_takes_it(tmp_path):
    """tools/campaign_to_creep.sh: law of the material, band, picture, the paper's law beside it."""
    script = STEEL.parents[1] / "tools" / "campaign_to_creep.sh"
    case = STEEL.parents[1] / "examples" / "wheelrail" / "rough.yaml"
    done = subprocess.run(
        [script, logs(tmp_path / "logs"), "-o", tmp_path / "out", "--material", STEEL,
         "--model", "bounded", "--case", case, "--", "--set", "creep=[0.01, 0.1]",
         "--set", "speed=10 m/s", "--set", "cells=512", "--set", "uncertainty.samples=20",
         "--set", "roughness.wavelength_min=0.4 mm"],
        capture_output=True, text=True, timeout=100, check=False,
        env={**os.environ, "MCAWR_BUILD": str(WR_FIT.parents[1])},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    out = tmp_path / "out"
    assert f"pictures: {out}/creep.png" in done.stdout and not (out / "fit.png").exists()
    assert json.loads((out / "law.json").read_text())["format"] == "mca-friction-law 2"
    assert (out / "creep_band.csv").exists() and (out / "paper" / "creep.csv").exists()


CASES = STEEL.parents[1] / "examples" / "wheelrail"
ROUGH = "roughness={hurst: 0.8, rms_slope: 0.028, wavelength_min: 3 mm, wavelength_max: 10 mm}"
GRID = ["contact.domain=4.2", "cells=[72, 144]", "sensitivities=false", "fields=none"]


@pytest.mark.parametrize(
    "case, changes",
    [
        ("rough.yaml", ["creep=[0.01, 0.1, 0.2]", "speed=10 m/s"]),
        ("eurosprinter.yaml", ["creep=[0.025, 0.107, 0.195]", *GRID]),
        pytest.param("rough.yaml", ["creep=[0.05]", "speed=10 m/s", "mode=moving", "cells=512",
                                    "moving.passes=2", "roughness.wavelength_min=0.4 mm"],
                     marks=LONG),
        pytest.param("eurosprinter.yaml", ["creep=[0.025, 0.107, 0.195]", ROUGH, *GRID],
                     marks=LONG),
    ],
)  # fmt: skip
def test_heat_and_friction_settle_where_mu_falls_steeply(tmp_path, case, changes):
    """A bend that is as good as sharp (q = 50) and a strength that is lost by nine tenths on 1073
    K; T/N falls with creep where cells get hot, and never passes mu0."""
    material = {
        "temperature": [293, 573, 673, 773, 873, 973, 1073],
        "strength": [900, 900, 720, 561.6, 338.4, 165.6, 79.2],
        "youngs_modulus": [206000, 164800, 144200, 123600, 63860, 26780, 18540],
    }
    law = {"format": "mca-friction-law 2", "mu0": 0.45, "s": 0.5, "q": 50, "density": 7800}
    (tmp_path / "law.json").write_text(json.dumps(law | material))
    words = [WR_FIT.with_name("wr_creep"), CASES / case, "-o", tmp_path / "out"]
    for change in [f"friction={{law: {tmp_path / 'law.json'}}}", *changes]:
        words += ["--set", change]
    done = subprocess.run(words, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == 0, done.stderr
    lines = (tmp_path / "out" / "creep.csv").read_text().splitlines()
    at = next(line for line in lines if line.startswith("speed")).split(",").index("traction_ratio")
    ratios = [float(line.split(",")[at]) for line in lines if line[:1].isdigit()]
    assert 0 < ratios[-1] < ratios[0] + (len(ratios) == 1) and max(ratios) <= 0.45
