# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction that falls with slip and temperature, and a layer: against CONTACT and by hand."""

import line_runs
import pytest
from patch_runs import CASE, creep_rows, numbers, run, wr_creep

# Second series of CONTACT's example tractcurv: Eurosprinter, friction law 4 with a memory, layer
# M = 4 that stays elastic. Creep, force in N (four digits are printed), cells that stick.
TRACTCURV = [
    (0.00001, 65.81, 1382),
    (0.001, 6425, 1342),
    (0.002, 12310, 1250),
    (0.010, 32110, 374),
    (0.011, 32570, 312),
    (0.075, 28360, 0),
    (0.100, 26620, 0),
    (0.125, 25100, 0),
]


def test_layer_and_local_slip_agree_with_contact(tmp_path):
    """Every count; forces to the digits printed, 6e-4 where CONTACT stops its own iteration."""
    case = tmp_path / "tractcurv.yaml"
    case.write_text(
        "contact: {load: 106.7 kN, curvatures: [0.8 1/m, 0.28142 1/m], domain: 2.2,"
        " youngs_modulus: 209.92 GPa, poissons_ratio: 0.28}\n"
        "layer: {thickness: 1.25 mm, shear_modulus: 8200 MPa}\n"
        "friction: {law: polach, mu0: 0.33, A: 0.424242424242, B: 0.554517744448 s/m,"
        " memory_length: 0.003 mm}\n"
        f"thermal: off\nspeed: 10 m/s\ncells: [48, 44]\nsensitivities: false\nfields: none\n"
        f"creep: {[creep for creep, _, _ in TRACTCURV]}\n",
        encoding="utf-8",
    )
    rows = creep_rows(case, tmp_path / "out")
    for (creep, force, stick), row in zip(TRACTCURV, rows, strict=True):
        assert float(row["creep"]) == creep
        assert round(float(row["stick_fraction"]) * 1384) == stick, creep
        assert -float(row["force_x"]) == pytest.approx(force, rel=6e-4 if not stick else 2e-4)


@pytest.fixture(name="case")
def sliding_case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(
        CASE.replace("thermal: off", "thermal: {model: averaged}").replace("1e-3", "0.05"),
        encoding="utf-8",
    )
    return path


def test_hot_friction_is_the_fixed_point_by_hand(case, tmp_path):
    """All slides, and the mean rise is c mu: mu = mu0 (1 + (f - 1)(c mu - s)/(e - s))."""
    (cold,) = creep_rows(case, tmp_path / "cold")
    c = float(cold["temperature_rise"]) / 0.3
    start, end, factor = 0.2 * 0.3 * c, 1.5 * 0.3 * c, 0.4
    (hot,) = creep_rows(
        case,
        tmp_path / "hot",
        f"friction.hot_factor={factor}",
        f"friction.hot_start={start} K",
        f"friction.hot_end={end} K",
    )
    slope = 0.3 * (factor - 1) / (end - start)
    mu = (0.3 - slope * start) / (1 - slope * c)
    assert float(hot["mu_mean"]) == pytest.approx(mu, rel=3e-6)
    assert float(hot["temperature_rise"]) == pytest.approx(c * mu, rel=3e-6)
    assert numbers([hot], "traction_ratio")[0] == pytest.approx(mu, rel=3e-6)


@pytest.mark.parametrize(
    "base, creep, cells", [(CASE, 0.06, 32), (line_runs.CASE, 0.03, 256)], ids=["point", "line"]
)
def test_where_friction_grows_each_point_heats_up_from_cold(base, creep, cells, tmp_path):
    """At the creep the contact may be cold, or as hot as that of creep 1 leaves it."""
    case = tmp_path / "case.yaml"
    case.write_text(base.replace("thermal: off", "thermal: {model: averaged}"), encoding="utf-8")
    changes = (
        "friction={law: constant, mu: 0.1, hot_factor: 10, hot_start: 20 K, hot_end: 100 K}",
        f"cells={cells}",
    )
    (alone,) = creep_rows(case, tmp_path / "alone", *changes, f"creep={creep}")
    hot, last = creep_rows(case, tmp_path / "both", *changes, f"creep=[1, {creep}]")
    assert float(alone["traction_ratio"]) == pytest.approx(0.1, rel=1e-4)
    assert float(hot["traction_ratio"]) == pytest.approx(1, rel=1e-4)
    assert float(last["traction_ratio"]) == pytest.approx(0.1, rel=1e-4)


def test_a_factor_of_one_changes_nothing(case, tmp_path):
    assert creep_rows(case, tmp_path / "a") == creep_rows(
        case, tmp_path / "b", "friction.hot_factor=1", "friction.hot_end=200 K"
    )


@pytest.mark.parametrize(
    "changes, message",
    [
        (
            ["friction.hot_factor=0.9", "friction.hot_start=600 K"],
            "hot_end: 600 K, allowed: above friction.hot_start",
        ),
        (["thermal=off", "friction.hot_factor=0.5"], "does not go with thermal: off"),
    ],
)
def test_factors_that_cannot_be(case, tmp_path, changes, message):
    text = case.read_text(encoding="utf-8")
    if changes[0] == "thermal=off":
        case.write_text(text.replace("thermal: {model: averaged}", "thermal: off"))
        changes = changes[1:]
    done = run(case, tmp_path / "out", *changes, code=3)
    assert message in done.stderr and done.stderr.count("\n") == 1


def test_help_names_the_factor():
    assert "friction.hot_factor" in wr_creep("--help").stdout
