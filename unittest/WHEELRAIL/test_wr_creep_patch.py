# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a point contact: results, files, random cases."""

import json
import os
import random

import numpy
import pytest
from patch_runs import (
    CASE,
    ROUGH,
    SOURCE,
    STEEL,
    creep_rows,
    gsf_map,
    numbers,
    run,
    table,
    wr_creep,
)

# 24 random cases take some seconds; 200 were run in development
LONG = pytest.mark.long
RANDOM_CASES = int(os.environ.get("WHEELRAIL_RANDOM_CASES", "24"))


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


@pytest.mark.parametrize("mode", ["frozen", "moving"])
def test_points_that_do_not_converge_leave_the_others(mode, case, tmp_path):
    """The hottest creep leaves no strength: it is named, the others are those of a run alone."""
    law = {"format": "mca-friction-law 1", "mu0": 0.15, "mu1": 0.0, "mu2": 0.3, "b": 0, "c": 0.002}
    (tmp_path / "law.json").write_text(json.dumps(law), encoding="utf-8")
    changes = ["friction={law: law.json}", "thermal={conductivity: 0.01 W/(m K)}", f"mode={mode}"]
    changes += ["cells=16", "fields=all"] + ["moving.passes=2"] * (mode == "moving")
    out = tmp_path / "out"
    done = run(case, out, *changes, "creep=[1e-6, 0.9, 2e-6]", code=4, options=["-q"])
    lines = done.stderr.splitlines()
    assert "point 2 (load 10000 N, creep 0.9, " in lines[0] and "no strength" in lines[0], lines
    assert (
        "1 of 3 operating points did not converge and is left out; the others are written"
        in lines[-1]
    )
    rows = table(out / "creep.csv")
    assert [float(row["creep"]) for row in rows] == [1e-6, 2e-6]
    summary = json.loads((out / "summary.json").read_text())
    assert len(summary["not_converged"]) == 1 and summary["points"] == 3
    assert sorted(p.name for p in out.glob("*.vti")) == ["fields_0001.vti", "fields_0003.vti"]
    alone = creep_rows(case, tmp_path / "alone", *changes, "creep=[2e-6]")
    assert float(alone[0]["force_x"]) == pytest.approx(float(rows[1]["force_x"]), rel=1e-5)
    done = run(case, tmp_path / "none", *changes, "creep=[0.9]", code=4, options=["-q"])
    assert "no strength" in done.stderr and not (tmp_path / "none/creep.csv").exists()


def test_law_used_outside_of_its_fit_and_friction_of_a_table(case, tmp_path):
    done = run(case, tmp_path / "a", "friction={law: bucher2006}", options=["-q"])
    assert "bucher2006 is used outside of what it was fitted on" in done.stderr
    summary = json.loads((tmp_path / "a/summary.json").read_text())
    assert summary["warnings"][0] in done.stderr
    assert summary["law_use"]["kappa3"] == pytest.approx([206, 206])
    table_text = "# pressure: MPa\n# speed: m/s\npressure,speed,mu\n1,0,0.4\n1,4,0.2\n"
    (tmp_path / "mu.csv").write_text(table_text, encoding="utf-8")
    rows = creep_rows(case, tmp_path / "b", "friction={law: mu.csv}", "creep=15 %")
    assert float(rows[0]["traction_ratio"]) == pytest.approx(0.25, rel=1e-3)  # 3 m/s
    polach = "friction={law: polach, mu0: 0.4, A: 0.5, B: 0.8 s/m}"
    rows = creep_rows(case, tmp_path / "c", polach, "creep=-15 %")
    mu = 0.4 * (0.5 * numpy.exp(-0.8 * 3) + 0.5)
    assert float(rows[0]["force_x"]) == pytest.approx(10000 * mu, rel=1e-3)


# Printed results of CONTACT (Vollebregt; eve70a/CONTACT, d431cdb), an independent program
# for the same equations on the same grids; half a unit of the last digit and a tenth.


def test_creep_curve_of_a_wheel_against_contact(tmp_path):
    path = tmp_path / "wheel.yaml"
    path.write_text(
        f"contact: {{load: 106700 N, semi_axes: [6.30352 mm, 12.60756 mm], {STEEL}}}\n"
        "friction: {law: constant, mu: 0.33}\nthermal: off\nspeed: 1 m/s\ncells: [48, 44]\n"
        "creep: [0.04 %, 0.12 %, 0.2 %, 2.8e-3]\n",
        encoding="utf-8",
    )
    rows = creep_rows(path, tmp_path / "out")
    assert -numbers(rows, "force_x") / (0.33 * 106700) == pytest.approx(
        [0.2588, 0.6482, 0.8816, 0.9832], abs=5.5e-5
    )
    assert [round(1384 * share) for share in numbers(rows, "stick_fraction")] == [
        1182,
        782,
        422,
        132,
    ]
    assert numbers(rows, "peak_pressure") == pytest.approx(641.05, rel=0.01)
    assert numbers(rows, "approach") == pytest.approx(7.6516e-2, rel=2e-3)
    contact = json.loads((tmp_path / "out/summary.json").read_text())["contacts"][0]
    assert contact["contact_cells"] == 1384
    assert contact["hertz_pressure_MPa"] == pytest.approx(641.05, abs=0.01)
    # Kalker's own table: C11 = 3.70 (nu 0.25: 3.40) at a/b = 0.5; the cells leave a few per cent
    assert contact["kalker"]["c11"] == pytest.approx(3.75, rel=0.05)


def test_lateral_creep_and_spin_against_contact(tmp_path):
    path = tmp_path / "spin.yaml"
    path.write_text(
        f"contact: {{load: 82 kN, semi_axes: [8 mm, 4 mm], "
        f"{STEEL}, spin_point: 0.16666666666666667}}\n"
        "friction: {law: constant, mu: 0.3}\nthermal: off\nspeed: 30 m/s\ncells: [44, 44]\n"
        "creep: 0\nlateral: -0.0625 %\nspin: 6.25e-4 1/mm\n",
        encoding="utf-8",
    )
    (row,) = creep_rows(path, tmp_path / "out")
    assert float(row["force_y"]) / (0.3 * 82000) == pytest.approx(-0.6074, abs=5.5e-5)
    assert float(row["moment_z"]) == pytest.approx(-4.821e4, abs=5.5)
    assert float(row["peak_pressure"]) == pytest.approx(1223, abs=0.55)
    assert float(row["stick_fraction"]) == pytest.approx(356 / 1276, abs=1e-6)
    assert float(row["power"]) == pytest.approx(540.4, abs=0.055)
    assert 0.8 < float(row["power_closure"]) < 1.0  # of first order in the cells


def test_cattaneo_shift_against_contact(tmp_path):
    """One shift from rest under a force; curvatures, and loads in N, lengths in mm, G = 200 MPa."""
    path = tmp_path / "cattaneo.yaml"
    path.write_text(
        "contact: {load: 9.1954 N, curvatures: [0.01 1/mm, 0.01 1/mm], youngs_modulus: 568 MPa,\n"
        "          poissons_ratio: 0.42, domain: 2.53333333333333}\nmode: static\n"
        "static: {force_ratio: 0.875}\nfriction: {law: constant, mu: 0.4}\ncells: 19\n",
        encoding="utf-8",
    )
    run(path, tmp_path / "out")
    (row,) = table(tmp_path / "out/static.csv")
    assert float(row["force_x"]) == pytest.approx(-0.875 * 0.4 * 9.1954, rel=1e-6)
    # the cells are CONTACT's but for a difference of 1e-5 in the box
    assert float(row["shift_x"]) == pytest.approx(8.155e-3, abs=2e-6)
    assert float(row["approach"]) == pytest.approx(1.998e-2, abs=1e-5)
    assert float(row["stick_fraction"]) == pytest.approx(45 / 177, abs=1e-6)


def test_forces_find_the_creepages(case, tmp_path):
    """The creepages that belong to forces give these forces again."""
    (row,) = creep_rows(case, tmp_path / "given", "lateral=-0.04 %", "spin=1e-4 1/mm")
    text = CASE.replace(
        "creep: [1e-3]",
        f"force: {{longitudinal: {row['force_x']} N, lateral: {row['force_y']} N}}\n"
        "spin: 1e-4 1/mm",
    )
    case.write_text(text, encoding="utf-8")
    (found,) = creep_rows(case, tmp_path / "found")
    assert float(found["creep"]) == pytest.approx(1e-3, rel=1e-4)
    assert float(found["lateral"]) == pytest.approx(-4e-4, rel=1e-4)
    case.write_text(
        text.replace("force: {longitudinal: -", "force: {longitudinal: -9"), encoding="utf-8"
    )
    run(case, tmp_path / "more", code=3)


@pytest.mark.parametrize(
    "law", ["{law: constant, mu: 0.3}", "{law: polach, mu0: 0.3, A: 0.5, B: 1 s/m}"]
)
def test_no_force_no_creep(law, case, tmp_path):
    """Whatever the point before."""
    text = case.read_text(encoding="utf-8").replace("creep: [1e-3]\n", "")
    case.write_text(text, encoding="utf-8")
    for axis, creep, rest in (("longitudinal", "creep", ()), ("lateral", "lateral", ("creep=0",))):
        changes = (f"friction={law}", f"force.{axis}=[-500 N, 0 N, 500 N]", *rest)
        rows = creep_rows(case, tmp_path / axis, *changes)
        found = numbers(rows, creep)
        assert found[0] == pytest.approx(-found[2], rel=1e-4) and found[0] > 1e-4
        assert found[1] == 0
    both = ("force.longitudinal=[500 N, 0 N]", "force.lateral=[500 N, 0 N]")
    rows = creep_rows(case, tmp_path / "both", f"friction={law}", *both)
    (free,) = (row for row in rows if float(row["traction"]) == 0)
    assert float(free["creep"]) == float(free["lateral"]) == 0


def test_signs_and_per_cent(case, tmp_path):
    rows = creep_rows(case, tmp_path / "out", "creep=[-0.1 %, 0, 0.1 %]")
    force = numbers(rows, "force_x")
    assert force[0] == pytest.approx(-force[2], rel=1e-6) and force[2] < 0 and force[1] == 0
    assert numbers(rows, "traction_ratio") == pytest.approx(abs(force) / 1e4, rel=1e-6)
    rows = creep_rows(case, tmp_path / "series", "creep={from: -1e-4, to: -1e-2, n: 3}")
    assert numbers(rows, "creep") == pytest.approx([-1e-4, -1e-3, -1e-2])
    assert (
        len(
            creep_rows(
                case,
                tmp_path / "grid",
                "creep=[0, 1e-3]",
                "lateral={from: -1e-3, to: 1e-3, n: 3}",
                "spin=[0 1/m, 0.1 1/m]",
                "speed=[10 m/s, 20 m/s]",
            )
        )
        == 24
    )


def test_several_loads(case, tmp_path):
    radii = CASE.replace(
        "load: 10 kN, semi_axes: [3 mm, 4 mm]",
        "load: [10 kN, 80 kN], radii: {wheel_rolling: 0.5 m, rail_profile: 0.3 m}",
    )
    case.write_text(radii, encoding="utf-8")
    run(case, tmp_path / "out")
    contacts = json.loads((tmp_path / "out/summary.json").read_text())["contacts"]
    assert contacts[1]["a_mm"] == pytest.approx(
        2 * contacts[0]["a_mm"]
    )  # Hertz: third root of the load
    assert contacts[1]["hertz_pressure_MPa"] == pytest.approx(2 * contacts[0]["hertz_pressure_MPa"])


def test_frozen_and_moving_agree_where_they_must(case, tmp_path):
    """Smooth contact: whatever travels, it is the steady state; rough and fully sliding: mu N."""
    (frozen,) = creep_rows(case, tmp_path / "frozen")
    (moving,) = creep_rows(case, tmp_path / "moving", "mode=moving")
    assert float(moving["force_x"]) == pytest.approx(float(frozen["force_x"]), rel=1e-4)
    (rest,) = creep_rows(
        case, tmp_path / "rest", "mode=moving", "moving.start=rest", "moving.passes=8"
    )
    assert float(rest["force_x"]) == pytest.approx(float(frozen["force_x"]), rel=3e-3)
    (sliding,) = creep_rows(
        case,
        tmp_path / "rough",
        "mode=moving",
        "roughness=" + ROUGH.replace("0.01", "0.002"),
        "creep=0.3",
    )
    assert float(sliding["force_x"]) == pytest.approx(-0.3 * 1e4, rel=1e-4)
    assert float(sliding["force_x_se"]) < 1.0


@LONG
def test_roughness_costs_stiffness_when_frozen_and_little_when_moving(case, tmp_path):
    """The finding of the two-dimensional model, in three dimensions: small creep, rough surface."""
    changes = [
        "creep=1e-5",
        "friction.mu=1",
        "cells=96",
        "contact.domain=3",
        "contact.semi_axes=[6 mm, 6 mm]",
        "contact.load=45 kN",
        "roughness={hurst: 0.8, rms_slope: 0.01, wavelength_min: 1.5 mm, wavelength_max: 6 mm}",
    ]
    (smooth,) = creep_rows(case, tmp_path / "smooth", *[c for c in changes if "roughness" not in c])
    (frozen,) = creep_rows(case, tmp_path / "frozen", *changes)
    (moving,) = creep_rows(case, tmp_path / "moving", *changes, "mode=moving", "moving.passes=6")
    assert float(frozen["real_area"]) < float(smooth["real_area"])
    loss = [float(row["force_x"]) / float(smooth["force_x"]) for row in (frozen, moving)]
    assert loss[0] < 0.9 and loss[0] < loss[1] < 1.05
    assert 0 < float(moving["force_x_se"]) < 0.1 * abs(float(moving["force_x"]))
    series = table(tmp_path / "moving/series.csv")
    kept = series[len(series) // 3 :]  # two of the six passes are left out
    assert numbers(kept, "force_x").mean() == pytest.approx(float(moving["force_x"]))


def test_sequence(case, tmp_path):
    text = CASE.replace(
        "creep: [1e-3]",
        "mode: moving\nmoving: {start: rest}\nsequence: {time: [0 s, 1 ms, 2 ms],\n"
        "  load: [10 kN, 10 kN, 14 kN], creep: [0, 0.2 %, 0.2 %]}",
    ).replace("load: 10 kN,", "load: 10 kN, domain: 2.8,", 1)
    case.write_text(text, encoding="utf-8")
    run(case, tmp_path / "out")
    series = table(tmp_path / "out/series.csv")
    seconds, load, creep = (numbers(series, name) for name in ("time", "load", "creep"))
    assert seconds[-1] == pytest.approx(2e-3, rel=0.01)
    assert creep == pytest.approx(
        numpy.interp(seconds, [0, 1e-3, 2e-3], [0, 2e-3, 2e-3]), abs=1e-12
    )
    assert load == pytest.approx(numpy.interp(seconds, [0, 1e-3, 2e-3], [1e4, 1e4, 1.4e4]))
    assert numbers(series, "peak_pressure")[-1] > 1.05 * numbers(series, "peak_pressure")[0]
    assert numbers(series, "force_x")[-1] == pytest.approx(-0.3 * load[-1], rel=0.1)


def test_full_sliding_with_a_local_law(case, tmp_path):
    """Eq. 5 with the Hertzian pressure of each cell has an exact mean: mu0 + mu2 J3."""
    law = "friction={law: bucher2006, local: true, velocity_term: false, strength: 1000 MPa}"
    load = 2 / 3 * numpy.pi * 3 * 4 * 500.0  # N of p0 = 500 MPa
    (row,) = creep_rows(
        case, tmp_path / "out", law, f"contact.load={load} N", "creep=0.3", "cells=128"
    )
    assert float(row["mu_mean"]) == pytest.approx(0.42904433, abs=2e-4)
    assert float(row["traction_ratio"]) == pytest.approx(float(row["mu_mean"]), rel=1e-4)


def test_temperature_of_an_ellipse(case, tmp_path):
    """Full sliding with mu: Eq. 11 row by row, by the formula and by the flash temperatures."""
    mean = {}
    for model in ("averaged", "averaged_power", "local"):
        (row,) = creep_rows(
            case, tmp_path / model, "creep=0.2", "cells=160", f"thermal={{model: {model}}}"
        )
        mean[model] = float(row["temperature_rise"])
    assert mean["averaged_power"] == pytest.approx(mean["averaged"], rel=1e-3)
    assert mean["local"] == pytest.approx(mean["averaged"], rel=0.01)
    p0 = 1.5 * 1e4 / (numpy.pi * 3e-3 * 4e-3)
    row = (
        8
        * 2**0.5
        / (15 * numpy.pi**0.5)
        * 0.3
        * p0
        * 0.2
        * 20
        * (3e-3 / (50 * 7800 * 450 * 20)) ** 0.5
    )
    eta = numpy.linspace(-1, 1, 200001)
    share = numpy.trapz((1 - eta**2) ** 1.25, eta) / (numpy.pi / 2)
    assert mean["averaged"] == pytest.approx(share * row, rel=1e-6)


def test_hardness_limits_the_pressure(case, tmp_path):
    (row,) = creep_rows(
        case, tmp_path / "out", "contact.hardness_limit=true", "friction.strength=100 MPa"
    )
    assert float(row["peak_pressure"]) == pytest.approx(300)
    assert float(row["real_area"]) > numpy.pi * 12
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["contacts"][0]["plastic_depth_um"] > 0
    run(case, tmp_path / "none", "contact.hardness_limit=true", "friction.strength=1 MPa", code=3)


def test_unlike_bodies_that_do_not_couple(case, tmp_path):
    """Incompressible bodies of any stiffness: half-spaces of the mean compliance."""
    both = CASE.replace(
        "youngs_modulus: 209.92 GPa, poissons_ratio: 0.28",
        "youngs_modulus: 3 GPa, poissons_ratio: 0.5",
    )
    case.write_text(both, encoding="utf-8")
    (one,) = creep_rows(case, tmp_path / "one")
    case.write_text(both.replace("3 GPa", "[2 GPa, 6 GPa]"), encoding="utf-8")
    (two,) = creep_rows(case, tmp_path / "two")
    assert float(two["force_x"]) == pytest.approx(float(one["force_x"]), rel=1e-6)


def test_unlike_bodies(case, tmp_path):
    """A soft wheel on steel: traction without creep, another pressure; all three modes agree."""
    soft = ("contact.youngs_modulus=[20 GPa, 209.92 GPa]", "contact.poissons_ratio=[0.2, 0.28]")
    rows = creep_rows(case, tmp_path / "free", *soft, "creep=[0, 1e-3]")
    assert float(rows[0]["power"]) > 0  # the surfaces stretch against each other
    assert 0 < float(rows[0]["stick_fraction"]) < 1
    moving = ("mode=moving", "moving.passes=2")
    (rolled,) = creep_rows(case, tmp_path / "moving", *soft, *moving)
    assert float(rolled["force_x"]) == pytest.approx(float(rows[1]["force_x"]), rel=1e-3)
    assert float(rolled["approach"]) == pytest.approx(float(rows[1]["approach"]), rel=1e-3)


def test_sequence_of_loads_at_rest(case, tmp_path):
    """Mindlin and Deresiewicz: a force that grows with the load in constant ratio makes no slip."""
    loads = ", ".join(f"{load / 1000:.6g} kN" for load in numpy.linspace(500, 10000, 20))
    instants = ", ".join(f"{k} s" for k in range(20))
    still = "mode=static"
    stages = (f"sequence.time=[{instants}]", f"sequence.load=[{loads}]")
    # of the ring of cells that a stage adds, half a ring slips at once: it does not with more of
    # them
    stick = {}
    for name, changes in {"at once": (), "stages": stages}.items():
        run(case, tmp_path / name, still, "static.force_ratio=0.5", *changes)
        (row,) = table(tmp_path / name / "static.csv")
        assert float(row["force_x"]) == pytest.approx(-1500, rel=1e-5)
        stick[name] = float(row["stick_fraction"])
    assert stick["at once"] == pytest.approx(0.5 ** (2 / 3), abs=0.05)
    assert stick["stages"] > 0.9
    run(case, tmp_path / "bad", still, "static.shift=[1 um, 0 um]", *stages, code=3)


def test_measured_maps(case, tmp_path):
    gsf_map(tmp_path / "rail.gsf", 1)
    gsf_map(tmp_path / "wheel.gsf", 2, holes=True)
    maps = "roughness={rail: rail.gsf, wheel: wheel.gsf, cutoff: 2.5 mm, unmeasured: fill}"
    done = run(case, tmp_path / "out", maps, "contact.domain=2.6")
    assert "6 of 7680 points had no height" in done.stderr
    for step in ("rail: as read", "wheel: on the cells"):
        assert step in done.stdout
    (rough,) = table(tmp_path / "out/creep.csv")
    (smooth,) = creep_rows(case, tmp_path / "smooth", "contact.domain=2.6")
    assert float(rough["real_area"]) != float(smooth["real_area"])
    done = run(case, tmp_path / "refused", maps.replace("fill", "refuse"), code=3)
    assert "wheel.gsf" in done.stderr and done.stderr.count("\n") == 1
    done = run(case, tmp_path / "short", maps, "mode=moving", "moving.passes=40", code=3)
    assert "the measured map ends" in done.stderr
    done = run(case, tmp_path / "small", maps, "contact.domain=8", code=3)
    assert "gsf" in done.stderr


def test_fields_and_polach(case, tmp_path):
    run(
        case,
        tmp_path / "out",
        "fields=[1, 4]",
        "creep={from: 1e-4, to: 1e-1, n: 8}",
        "thermal={model: local}",
        options=("--polach", tmp_path / "polach.json"),
    )
    files = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert (
        "fields_0001.vti" in files
        and "fields_0004_pressure.gsf" in files
        and "fields_0002.vti" not in files
    )
    raw = (tmp_path / "out/fields_0004_pressure.gsf").read_bytes()
    data = numpy.frombuffer(raw[-32 * 32 * 4 :], "<f4").reshape(32, 32)
    row = table(tmp_path / "out/creep.csv")[3]
    assert data.max() == pytest.approx(1e6 * float(row["peak_pressure"]), rel=1e-6)
    law = json.loads((tmp_path / "polach.json").read_text())
    assert "kA" in json.dumps(law) and len(table(tmp_path / "polach.csv")) == 8
    done = wr_creep(SOURCE / "examples/wheelrail/table2.yaml", "--polach", tmp_path / "line.json")
    assert done.returncode == 2 and "--polach" in done.stderr
    done = wr_creep(case, "-o", tmp_path / "o", "--polach", tmp_path / "o/summary.json")
    assert done.returncode == 2 and done.stderr.count("\n") == 1


def test_same_digits_for_any_number_of_threads(case, tmp_path):
    changes = [
        f"roughness={ROUGH[:-1]}, seed: [1, 2]}}",
        "contact.domain=3",
        "creep={from: 1e-4, to: 1e-2, n: 10}",
        "speed=[10 m/s, 30 m/s]",
        "thermal={model: local}",
        "friction={law: bucher2006, local: true}",
    ]
    case.write_text(CASE.replace("law: constant, mu: 0.3", "law: bucher2006"), encoding="utf-8")
    for threads in ("1", "3"):
        run(case, tmp_path / threads, *changes, options=("--threads", threads))
    assert (tmp_path / "1/creep.csv").read_bytes() == (tmp_path / "3/creep.csv").read_bytes()
    assert len(table(tmp_path / "1/creep.csv")) == 40


def random_case(seed):
    """Loads, shapes, materials, creepages, laws, heat and limits over all of their ranges."""
    draw = random.Random(seed)

    def between(low, high):
        return low * (high / low) ** draw.random()

    creep, pressure = between(1e-5, 0.2), between(0.2, 1.5)  # p0 in GPa
    a = between(1, 10)
    b = a * between(0.5, 2)
    n, mode = draw.randint(32, 48), draw.choice(["frozen", "frozen", "moving"])
    rough = draw.random() < 0.75
    domain = 3.6 if rough else 2.2
    text = (
        f"contact: {{load: {2 / 3 * 3.14159 * a * b * pressure * 1e3:.5g} N, "
        f"semi_axes: [{a:.4g} mm, {b:.4g} mm], "
        f"youngs_modulus: 210 GPa, poissons_ratio: {draw.choice([0, 0.3, 0.5])}, domain: {domain}, "
        f"hardness_limit: {draw.choice(['true', 'false'])}}}\n"
        f"cells: [{n}, {draw.randint(n, 48)}]\n"
        f"creep: [{draw.choice([-1, 0, 1]) * creep:.4g}, {creep:.4g}]\n"
        f"lateral: {draw.uniform(-1, 1) * creep:.4g}\n"
        f"spin: {draw.choice([0, 1, 1, 10]) * draw.uniform(-1, 1) * creep / a:.4g} 1/mm\n"
        f"speed: {between(1, 60):.4g} m/s\nfields: none\nsensitivities: false\nmode: {mode}\n"
    )
    if mode == "moving":
        text += f"moving: {{passes: 2, start: {draw.choice(['steady', 'rest'])}}}\n"
    if rough:
        shortest = 8 * domain * max(a, b) / n  # against the slope at the edge of the smooth contact
        text += (
            f"roughness: {{hurst: {draw.uniform(0.3, 1):.3g}, "
            f"rms_slope: {0.02 * pressure * between(0.02, 0.5):.3g}, "
            f"wavelength_min: {shortest:.4g} mm, "
            f"wavelength_max: {4 * shortest:.4g} mm, seed: {seed}}}\n"
        )
    if draw.random() < 0.4:
        text += f"friction: {{law: constant, mu: {between(0.05, 1):.3g}}}\n"
    else:
        text += f"friction: {{law: bucher2006, local: {draw.choice(['true', 'false'])}}}\n"
    text += draw.choice(
        [
            "thermal: off\n",
            "thermal: {model: averaged}\n",
            "thermal: {model: averaged_power}\n",
            "thermal: {model: local}\n",
        ]
    )
    return text


@pytest.mark.parametrize("cases", [8, pytest.param(RANDOM_CASES, marks=LONG)])
def test_random_cases_converge_or_say_why(tmp_path, cases):
    """Rough, spin, high creep, limits, frozen and moving: an answer or one clear line, for each of
    the two points of a case or for the whole of it, never half a file."""
    answers, refusals = 0, []
    for seed in range(1, cases + 1):
        path, out = tmp_path / f"{seed}.yaml", tmp_path / f"out{seed}"
        path.write_text(random_case(seed), encoding="utf-8")
        done = wr_creep(path, "-o", out, "-q", timeout=120)
        assert done.returncode in (0, 3, 4), (seed, done.stderr)
        lines = [line for line in done.stderr.splitlines() if "warning" not in line]
        missing = [line for line in lines if line.startswith("wr_creep: point ")]
        if done.returncode == 0 or len(missing) == 1:
            rows = table(out / "creep.csv")
            assert len(rows) == 2 - len(missing) and len(lines) == 2 * len(missing), done.stderr
            for row in rows:
                assert all(numpy.isfinite(float(value)) for value in row.values()), seed
                assert float(row["traction_ratio"]) <= float(row["mu_mean"]) * (1 + 1e-5), seed
        else:
            assert len(lines) == 1, done.stderr
            assert not (out / "creep.csv").exists()
        if done.returncode == 0:
            answers += 1
        else:
            refusals.append((seed, lines[0]))
    print(*refusals, sep="\n")
    assert answers >= 0.85 * cases, refusals


@pytest.mark.parametrize("name", ["patch", "patch_rough"])
def test_examples_run(name, tmp_path):
    done = wr_creep(
        SOURCE / f"examples/wheelrail/{name}.yaml",
        "-o",
        tmp_path,
        "-q",
        "--set",
        "cells=48",
        "--set",
        "creep=[0.1 %, 1 %]",
        "--set",
        "roughness=none",
    )
    assert done.returncode == 0, done.stderr
