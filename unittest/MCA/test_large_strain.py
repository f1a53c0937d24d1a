# SPDX-License-Identifier: GPL-2.0-or-later
"""Plastic flow without friction against exact answers of plane strain, in lmp: Prandtl's punch,
Hill's ring, a bar that is drawn, and the yield stress in shear of the packing itself.

The material is ideally plastic with links that do not break; k is its yield stress in shear.
"""

import pathlib
import re

import numpy as np
import pytest
from lmp_run import STEEL, dump, lmp

EXAMPLES = pathlib.Path(STEEL).parents[1] / "examples" / "plastic"
E, NU, D = 206000.0, 0.3, 2.5
G, BULK = E / 2 / (1 + NU), E / 3 / (1 - 2 * NU)
LONG = pytest.mark.long
TURNED = pytest.mark.parametrize("turn", [0, 1])  # close-packed rows along x, and upright


def block(folder, **values):
    """Strains, stress by the virial over k, and plastic strain of a periodic perfect block that
    flows."""
    t = lmp("in.plastic_block", folder, **values).thermo[0]
    flows = t["c_plastic"] > 0
    return tuple(t[name][flows][1:] for name in ("v_now", "v_stress", "c_plastic"))


@TURNED
@pytest.mark.parametrize("mode", ["tension", "shear"])
def test_packing_yields_alike_in_all_directions(tmp_path, mode, turn):
    """The error that the packing itself brings to what follows: 1 % at strains of 1.5 %."""
    strain, stress, _ = block(tmp_path, mode=mode, turn=turn, strain=0.015)
    assert strain[0] < 0.004 and strain[-1] == pytest.approx(0.015)
    assert np.abs(stress - 1).max() < 0.01


# ---- Prandtl: a flat rigid punch, p = (2 + pi) k


def punch(folder, width, turn, slow=1):
    out = lmp(str(EXAMPLES / "in.punch"), folder, width=width, turn=turn, slow=slow)
    t = out.thermo[0]
    assert t["c_broken"][-1] == 0
    # little kinetic energy where the limit is reached
    assert (t["KinEng"][10:] / t["PotEng"][10:]).max() < 0.02
    mean = re.search(r"^punch of \d+ automata: p = (\S+) k", out.out, re.MULTILINE)
    return float(mean[1]), t


@pytest.mark.parametrize("turn", [0, pytest.param(1, marks=LONG)])
def test_punch(tmp_path, turn):
    """The free surface begins between two automata, so a punch of n is wider by a share of 1/n:
    what twice the width adds to the load is free of its edges. The packing's k is good to 1 %, the
    pressure is a mean over a quarter of the way, in which it falls by 1 %."""
    exact = 2 + np.pi
    small, _ = punch(tmp_path / "8", 8, turn)
    large, t = punch(tmp_path / "16", 16, turn)
    assert 2 * large - small == pytest.approx(exact, rel=0.02)
    assert exact < large < small
    # the limit is reached: over the last quarter of the way the pressure hardly changes
    assert np.ptp(t["v_p"][-5:]) < 0.02 * exact


@LONG
def test_half_the_speed_changes_nothing(tmp_path):
    fast, slow = (punch(tmp_path / str(s), 8, 0, s)[0] for s in (1, 2))
    assert slow == pytest.approx(fast, rel=0.005)


# ---- Hill: a thick ring whose bore is widened


def hill(a, b, strength):
    """Displacement of the bore over its radius and pressure over k, as the plastic radius grows
    from a to b: small strains, elastic beyond it, ideally plastic within; across the plane it is
    elastic, since it flows in the plane alone."""
    k, area_modulus = strength / np.sqrt(3), 2 * (BULK + G / 3)
    c = np.linspace(a, b, 2000)
    inner = k * (1 - c**2 / b**2)  # pressure on the elastic part
    pressure = inner + 2 * k * np.log(c / a)
    u = k * c**2 / b**2 * (c / area_modulus + b**2 / (2 * G * c))  # Lame, at c
    # r u grows by r times the strain of the area, whose integral is that of d(r^2 sigma_r)
    bore = (c * u + (inner * c**2 - pressure * a**2) / area_modulus) / a
    return bore / a, pressure / k


@LONG
def test_ring(tmp_path):
    out = lmp(str(EXAMPLES / "in.ring"), tmp_path)
    t = out.thermo[0]
    a, b = map(float, re.search(r"^ring of (\S+) and (\S+) nm", out.out, re.MULTILINE).groups())
    way, pressure = t["v_way"], t["v_p"]
    u, p = hill(a, b, 400)
    # elastic-plastic: the plastic radius between 1.3 a and the outer one; a bore of 8 automata is
    # good to half a row of its 16 rows of wall
    rows = (way > np.interp(1.3 * a, np.linspace(a, b, len(u)), u)) & (way < u[-1])
    assert rows.sum() > 4
    assert np.abs(pressure[rows] / np.interp(way[rows], u, p) - 1).max() < 0.03
    # plastic throughout: 2 k ln(b/a) of the present radii, which widening lowers
    full = way > 1.2 * u[-1]
    now = np.log(1 + (b**2 - a**2) / (a * (1 + way)) ** 2)
    assert full.sum() > 5
    assert np.abs(pressure[full] / now[full] - 1).max() < 0.015
    assert t["c_broken"][-1] == 0


# ---- a bar that is drawn


def area(x, y):
    return 0.5 * np.abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def drawn(folder, **values):
    t = lmp("in.neck", folder, **values).thermo[0]
    return t["v_elongation"], t["v_load"], t["c_broken"]


@LONG
def test_bar_keeps_its_area(tmp_path):
    """Inside a bar that hardens, drawn by 20 %: p/K is 0.1 %."""
    broken = drawn(tmp_path, hardening=1.02)[2]
    assert broken[-1] == 0
    start, end = (f[1] for f in dump(tmp_path / "bar.dump"))
    row = np.rint(start["y"] / (D * np.sqrt(3) / 2)).astype(int)
    inside = np.abs(start["x"]) < 30

    def chosen(k):
        found = np.flatnonzero(inside & (row == k))
        return found[np.argsort(start["x"][found])]

    ring = np.concatenate([chosen(3), chosen(row.max() - 3)[::-1]])
    before, after = (area(f["x"][ring], f["y"][ring]) for f in (start, end))
    stretch = np.ptp(end["x"][ring]) / np.ptp(start["x"][ring])
    assert stretch > 1.15
    assert after / before == pytest.approx(1, abs=0.011)


@pytest.mark.parametrize(
    "mode, turn, strain, error",
    [
        ("tension", 0, 0.3, 1e-3),
        ("tension", 1, 0.16, 1e-3),
        ("shear", 0, 0.3, 2e-3),
        ("shear", 1, 0.3, 0.01),
    ],
)
def test_block_yields_at_k_at_large_strains(tmp_path, mode, turn, strain, error):
    """So does the plastic strain grow as the work over the yield stress says, without the elastic
    strain. Beyond 16 % of tension the room of upright rows acts, which reads 1 % too little."""
    now, stress, plastic = block(tmp_path, mode=mode, turn=turn, strain=strain, steps=8000)
    assert np.abs(stress - 1).max() < error
    work = np.log1p(strain) * now / strain * 2 if mode == "tension" else now
    exact = (work - 100 / np.sqrt(3) / G) / np.sqrt(3)
    flown = now > 0.2 * strain
    assert np.abs(plastic[flown] / exact[flown] - 1).max() < 0.01


@LONG
def test_load_of_an_ideally_plastic_bar_falls_with_its_section(tmp_path):
    elongation, load, _ = drawn(tmp_path)
    # the outermost rows yield late: 16 rows bear what 16.3 do
    even = (elongation > 0.015) & (elongation < 0.07)
    assert load[even] * (1 + elongation[even]) == pytest.approx(1, abs=0.025)
    # nothing hardens: a band localizes, and in it links break
    assert np.interp(0.12, elongation, load) < 0.5


@LONG
def test_bar_necks_where_considere_says(tmp_path):
    """True stress 2/sqrt(3) (Y + H kappa), kappa = 2/sqrt(3) ln(1 + elongation): the load is
    largest where its slope is the stress itself, 1.013 at 16 %, and then the bar necks."""
    slope = 1.02  # H/Y
    elongation, load, _ = drawn(tmp_path, hardening=slope, strain=0.3, rows=8, slow=8)
    at = np.exp(1 - np.sqrt(3) / (2 * slope)) - 1
    exact = (1 + slope * 2 / np.sqrt(3) * np.log1p(elongation)) / (1 + elongation)
    even = (elongation > 0.02) & (elongation < at)
    assert np.abs(load[even] / exact[even] - 1).max() < 0.01
    assert load.max() == pytest.approx(exact.max(), rel=0.01)
    assert load[elongation > at + 0.05].max() < 0.1
