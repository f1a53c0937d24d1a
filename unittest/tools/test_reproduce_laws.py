# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/reproduce laws: logs whose mu goes with known powers and factors."""

import math

import pytest
from test_reproduce import line, logs, made, profiles, pytestmark, reproduce  # noqa: F401

ETA = -0.1  # power of the viscosity
FIRST = ("base", "soft", "strong", "dense", "faint")


def test_sets_of_laws_in_the_order_of_the_rule(tmp_path):
    """First those that rub alike at base and soft, by their distance from Eq. 2; then the others;
    then those that are not complete."""
    factors = {"d": 1.0, "d worn never": 0.8, "d weld 1": 0.9, "c": 1.0, "d flow links": 1.0}

    def factor(run):
        soft = run.values["laws"] == "c" and run.name.startswith("soft")
        return factors.get(run.values["laws"], 0.0) * (0.7 if soft else 1)

    folder, runs = logs(tmp_path, "laws", factor, ns=40)
    for run in runs:
        condition, *_ = run.name.split("-")
        left = run.values["laws"] == "d flow links" and condition == "faint"
        if run.values["laws"] not in factors or left or condition not in FIRST:
            (folder / f"{run.name}.friction").unlink()
    text = made(tmp_path, "laws", reproduce(tmp_path, "laws"))
    names = [row.split("  ")[0] for row in text.splitlines()[2:]]
    assert names[:6] == ["d", "d weld", "d never", "c", "d links", "Eq. 2"]
    assert line(text, "d weld  ")[-2] == pytest.approx(10, abs=2)
    assert line(text, "c  ")[-4] == pytest.approx(0.7, abs=0.02)
    assert "24 runs" in text


def changing(run):
    """mu over Eq. 2 of preset d goes with powers of the viscosity and of the roughness, and one
    seed differs."""
    name = run.name.split("-")[0]
    if run.name == "light-seed2":  # of four
        return 1.2
    return 2 ** {"thin": -ETA, "thick": ETA}.get(name, 0.0) * (0.8 if name == "smooth" else 1)


def of_preset_d(tmp_path, plan, ns):
    """The comparison of it alone; the layer's depth goes like the root of the viscosity."""
    folder, runs = logs(tmp_path, plan, changing, ns=ns)
    kept = [run for run in runs if run.values["laws"] == "d"]
    for run in runs:
        if run not in kept:
            (folder / f"{run.name}.friction").unlink()
    rows = {0.205: (3, 6), 0.82: (3, 9)}
    profiles(folder, kept, lambda run, part: rows.get(run.values["eta"], (3, 6)), frames=120)
    return made(tmp_path, plan, reproduce(tmp_path, plan)).split("\n\n")


def test_second_step_tells_the_powers_of_the_viscosity(tmp_path):
    _, _, second = of_preset_d(tmp_path, "laws", ns=150)
    head = second.splitlines()[0].split()
    assert head[-8:] == ["thin", "thick", "n", "of", "eta", "n", "of", "depth"]
    *_, eta, _, depth, _ = line(second, "d  ")
    assert (eta, depth) == pytest.approx((ETA, 0.5), abs=0.015)


@pytest.mark.long
def test_third_step_tells_what_does_not_change(tmp_path):
    _, second, seeds, last = of_preset_d(tmp_path, "laws-long", ns=420)
    apart, times, number = line(seeds, "d: seeds differ by")
    assert apart == pytest.approx(9.5 / math.sqrt(11), abs=0.1) and times > 5 and number == 11
    assert [row.split()[0] for row in last.splitlines()[1:]] == ["d"]
    assert len(line(second, "d  ")) == 2 * 6
    away = [-ETA * math.log(2), ETA * math.log(2), math.log(0.8), 0, 0, 0]
    scatter = 100 * math.sqrt(sum((a - sum(away) / 6) ** 2 for a in away) / 6)
    size, _, eta, _, smooth, _, depth, _, number, rms, _ = line(last, "d  ")
    assert size == pytest.approx(scatter, abs=1) and rms == pytest.approx(8, abs=1.5)
    assert (eta, smooth, depth) == pytest.approx((ETA, 0.8, 0.5), abs=0.015) and number == 1
