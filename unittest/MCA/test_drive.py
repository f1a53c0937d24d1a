# SPDX-License-Identifier: GPL-2.0-or-later
"""fix mca/drive: prescribed speed, rigid layer, constant normal pressure, and its log."""

import os
import pathlib
import re

import numpy as np
import pytest
import yaml

from lmp_run import dump, friction_log, lmp

V, P = 8.0, 40.0


@pytest.fixture(scope="module", params=[1, 3])
def driven(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(f"driven{request.param}")
    result = lmp("in.driven", folder, ranks=request.param, v=V, p=P)
    return result, dump(folder / "layer.dump"), friction_log(folder / "driven.friction")


def test_speed_is_exact_and_the_layer_rigid(driven):
    frames = driven[1]
    first = frames[0][1]
    for step, f in frames[1:]:
        assert (f["vx"] == V).all()
        assert (f["omegaz"] == 0).all() and (f["c_state"] == 0).all()
        assert np.ptp(f["vy"]) == 0
        shift = f["yu"] - first["yu"]
        assert np.ptp(shift) < 1e-12
        assert np.abs(f["xu"] - first["xu"] - V * step * 5e-5).max() < 1e-10


def test_mean_normal_stress_is_the_pressure(driven):
    log = driven[2][1]
    half = len(log["step"]) // 2
    assert log["normal_stress"][half:].mean() == pytest.approx(P, rel=0.02)


def test_log_describes_itself(driven):
    head = yaml.safe_load(driven[2][0])
    assert head["format"] == "mca-friction 1"
    assert head["loading"] == {"pressure": P, "velocity": V}
    assert head["material"]["youngs_modulus"] == 206000
    assert head["material"]["density"] == pytest.approx(7800)
    assert head["material"]["elastic_limit"] == pytest.approx(0.554 * 92)
    assert head["material"]["viscosity"] == pytest.approx(0.41)
    assert head["geometry"]["width"] == 50 and head["geometry"]["packing"] == "hex"
    assert head["geometry"]["automata"] == 280 and head["geometry"]["diameter"] == 2.5
    assert head["run"] == {"timestep": 5e-5, "every": 50, "seed": 11}
    assert head["laws"]["preset"] == "d" and head["units"]["stress"] == "MPa"
    assert head["program"]["lammps"] == 20250204 or head["program"]["lammps"] > 20250204


def test_log_columns(driven):
    result, _, (_, log) = driven
    assert list(log) == [
        "step",
        "time",
        "displacement",
        "shear_stress",
        "normal_stress",
        "mu",
        "links",
        "broken",
        "formed",
        "gap",
        "room",
        "lost",
        "flow_energy",
        "breaking_energy",
        "contact_energy",
        "check",
    ]
    assert (log["step"] == np.arange(50, 4001, 50)).all()
    assert np.allclose(log["time"], log["step"] * 5e-5, rtol=1e-9)
    assert np.allclose(log["displacement"], V * log["time"], rtol=1e-9)
    assert np.allclose(log["mu"], log["shear_stress"] / P, rtol=1e-7, atol=1e-12)
    # links change by what broke and formed; an event counts in the step that decides it and acts
    # from the next one, so those of a row's own step come into the links of the next row
    events = np.cumsum(log["formed"] - log["broken"])
    offset = log["links"] - events
    assert (offset == np.median(offset)).mean() > 0.8
    # the rows are means over their steps: the running mean of thermo over the same steps
    t = result.thermo[0]
    assert np.allclose(t["f_row[1]"][1:], log["shear_stress"], rtol=1e-6, atol=1e-9)
    assert np.allclose(t["f_row[2]"][1:], log["normal_stress"], rtol=1e-6, atol=1e-9)


def test_scalar_and_vector_of_thermo(driven):
    result, frames, (_, log) = driven
    t = result.thermo[0]
    assert np.allclose(t["f_drive"], t["f_drive[1]"] / P, rtol=1e-12)
    assert (t["f_drive"] == t["f_drive[3]"]).all()
    assert np.allclose(t["f_drive[4]"], V * t["Step"] * 5e-5, rtol=1e-10)
    assert np.allclose(t["f_drive[5]"][1:], log["gap"], rtol=1e-6, atol=1e-9)
    gap = [f["yu"].mean() - frames[0][1]["yu"].mean() for _, f in frames]
    assert np.allclose(t["f_drive[5]"], gap, atol=1e-10)
    # work: shear stress x area x path, per thickness 1 and width 50
    work = np.concatenate([[0], np.cumsum(log["shear_stress"]) * 50 * V * 50 * 5e-5])
    assert np.allclose(t["f_drive[6]"], work, rtol=1e-6, atol=1e-6 * np.abs(work).max())


def test_momentum_balance_of_the_layer(driven):
    """Mass x acceleration of the layer = normal stress - pressure."""
    log, frames = driven[2][1], driven[1]
    steps = [s for s, _ in frames]
    speed = np.array([f["vy"][0] for _, f in frames])
    mass_per_area = 20 * 0.0078 * np.sqrt(0.75) * 2.5**2 / 50
    impulse = np.cumsum((log["normal_stress"] - P) * 50 * 5e-5)
    moved = mass_per_area * (speed[1:] - speed[0])
    assert len(steps) == len(log["step"]) + 1
    # the sums are over steps, Verlet's momentum over half steps at both ends
    assert np.abs(moved - impulse).max() < 0.02 * np.abs(impulse).max() + 2 * 5e-5 * 300


def test_variable_velocity_and_pressure(tmp_path):
    lmp("in.driven", tmp_path, v="v_ramp", p="v_load")
    frames = dump(tmp_path / "layer.dump")
    for step, f in frames[1:]:
        # the speed of a step is that of its post-force
        assert np.allclose(f["vx"], 2 + 10 * step * 5e-5, rtol=1e-12)
    log = friction_log(tmp_path / "driven.friction")[1]
    way = [f["xu"][0] - frames[0][1]["xu"][0] for _, f in frames[1:]]
    assert log["displacement"] == pytest.approx(way, rel=1e-11)
    assert way[-1] == pytest.approx(2 * 0.2 + 5 * 0.2**2, rel=1e-3)


def test_log_of_a_second_run_goes_on(tmp_path):
    lmp("in.driven", tmp_path, v=V, p=P, extra="run 1000")
    log = friction_log(tmp_path / "driven.friction")[1]
    assert (np.diff(log["step"]) == 50).all() and log["step"][-1] == 5000


def test_no_half_written_files(driven):
    folder = driven[0].folder
    assert not [f for f in os.listdir(folder) if f.endswith(".tmp")]


def test_automata_that_leave_through_the_layer_are_told_of(tmp_path):
    """One of the layer gives its place, a little below the others, to a loose one that is thrown
    upwards."""
    more = (
        "variable top equal bound(top,ymax)\nvariable x equal xcm(one,x)\n"
        "region one block 20 22.4 10 INF INF INF units box\ngroup one region one\n"
        "group one intersect one top\n"
        "variable x1 equal $x\nvariable y1 equal ${top}-0.05\n"
        "delete_atoms group one\ncreate_atoms 1 single ${x1} ${y1} 0 units box\n"
        "group loose subtract all low high\nvelocity loose set 8 50 0\nrun 500"
    )
    result = lmp("in.driven", tmp_path, v=V, p=P, extra=more)
    assert "1 automata left the fragment through the driven layer" in result.out
    assert result.out.count("left the fragment") == 1


def test_automata_that_leave_through_the_held_rows_are_told_of(tmp_path):
    """A held one gives its place to a loose one that is thrown downwards."""
    more = (
        "region one block 20 22.4 INF 1 INF INF units box\ngroup one region one\n"
        "variable x1 equal xcm(one,x)\nvariable x2 equal ${x1}\n"
        "delete_atoms group one\ncreate_atoms 1 single ${x2} 0.05 0 units box\n"
        "group loose subtract all low high\nvelocity loose set 0 -50 0\nrun 500"
    )
    result = lmp("in.driven", tmp_path, v=V, p=P, extra=more)
    assert "1 automata left the fragment through the held layer: hold more rows" in result.out
    assert result.out.count("left the fragment") == 1
    lost = friction_log(tmp_path / "driven.friction")[1]["lost"]
    assert (lost[:80] == 0).all() and lost[-1] == 1


def test_room_is_the_area_between_the_rows_over_that_of_the_cells(driven):
    """Twelve free rows, and half of one on either side; the upper block begins 0.13 of the
    lattice's period of two rows higher. Nothing is lost, so that it goes with the gap."""
    result, frames, (_, log) = driven
    row = np.sqrt(0.75) * 2.5
    assert (log["lost"] == 0).all()
    assert np.allclose(log["room"], 1 + (log["gap"] + 0.13 * 2 * row) / (13 * row), rtol=1e-7)
    assert np.allclose(result.thermo[0]["f_drive[7]"][1:], log["room"], rtol=1e-7)
    assert (result.thermo[0]["f_drive[8]"] == 0).all()
    assert (log["flow_energy"] == 0).all()


def test_room_where_forces_out_of_the_plane_are_set(tmp_path):
    """A frequent idiom of two dimensions, which holds nothing."""
    flat = "fix flat all setforce NULL NULL 0\nrun 100\n"
    result = lmp("in.driven", tmp_path, v=V, p=P, extra=flat)
    room = friction_log(tmp_path / "driven.friction")[1]["room"]
    assert (np.abs(room - 1) < 0.1).all()
    assert "sets forces of" not in result.out


EXAMPLE = str(pathlib.Path(os.environ["PROJECT_SOURCE"]) / "examples/friction/in.friction")


def example(folder, **variables):
    shown = lmp(pathlib.Path(EXAMPLE).read_text(encoding="utf-8"), folder, frames=0, **variables)
    return shown.out, friction_log(folder / "friction.friction")[1]


def test_a_layer_that_sinks_is_told_of_once(tmp_path):
    """Flow that does not keep its volume, at a Poisson's ratio where it shows at once."""
    out, log = example(tmp_path, ns=0.3, nu=0.4, laws="c")
    assert out.count("automata of the layer have 0.9") == 1 and "is no solid any more" in out
    assert log["room"][-1] < 0.95 and "fell by" not in out


def test_a_term_of_the_account_that_falls_is_told_of_once(tmp_path):
    out, log = example(tmp_path, ns=0.1, nu=0.4, laws="c", account=1)
    assert out.count("what plastic flow dissipates fell by") == 1
    assert log["flow_energy"][-1] < -1000 and log["breaking_energy"][-1] > 0


def test_a_solid_is_not_warned_of(tmp_path):
    out, log = example(tmp_path, ns=0.1, nu=0.4, laws="d", account=1)
    assert "fell by" not in out and "the solid" not in out
    assert (np.diff(log["flow_energy"]) > 0).all() and (log["contact_energy"] > 0).all()
    assert np.abs(log["room"] - 1).max() < 0.01


def smooth(log, diameter=2.5):
    """Share of the way in phases of a diameter at least, in which no link broke."""
    steps = np.diff(log["displacement"], prepend=0)
    whole = np.flatnonzero(np.concatenate([[1], log["broken"], [1]]))
    phases = [steps[a : b - 1].sum() for a, b in zip(whole, whole[1:])]
    return sum(p for p in phases if p >= diameter) / steps.sum()


def test_a_narrow_sample_is_told_of(tmp_path):
    """Few junctions at the start and a layer that slid smooth at the end, each told once: two flat
    blocks of a strong steel under a light load, which shear off a row of links in the beginning."""
    small = {"ns": 1, "v": 50, "every": 125, "columns": 8, "laws": "d"}
    out, log = example(tmp_path / "flat", p=0.5, strength=552, amplitude=0, **small)
    assert out.count("0.013 junctions carry pressure 0.5 at once, fewer than 10") == 1
    (share,) = re.findall(r"no link broke in (\d+) % of the 50 that the layer slid", out)
    assert 80 < 100 * smooth(log) < 100 and int(share) == round(100 * smooth(log))
    out, log = example(tmp_path / "rough", p=80, **small)
    assert log["broken"].sum() > 100
    assert "junctions" not in out and "no link broke" not in out
    out, _ = example(tmp_path / "free", p=0.5, strength=552, **{**small, "laws": "d link none"})
    assert "junctions" not in out and "no link broke" not in out


def test_a_narrow_sample_in_space_is_told_of(tmp_path):
    """p A/(d^2 sigma_link): 16 places of 0.098 of the area that is linked, and 20 times as many."""
    script = pathlib.Path(EXAMPLE.replace("friction/in.", "space/in.")).read_text(encoding="utf-8")
    small = {"p": 5, "ns": 0.001, "frames": 0, "columns": 8, "rows": 16}
    out = lmp(script, tmp_path / "few", depth=4, **small).out
    assert out.count("1.6 junctions carry pressure 5 at once, fewer than 10") == 1
    assert "junctions" not in lmp(script, tmp_path / "many", depth=80, **small).out


BRONZE = """# UNITS: nano
youngs_modulus 110000
poissons_ratio 0.34
density 0.0088
strength 350
elastic_limit 0.43
yield_strength 0.80
yield_strain 0.02
breaking_strain 0.20
viscosity 410
diameter 2.5
"""


def test_the_log_names_interfaces_of_its_types(rough_data, tmp_path):
    own = "pair_coeff 2 1 interface friction 0.3 link 2"
    lmp("in.sliding", tmp_path, data=rough_data, steps=500, extra=own)
    head = yaml.safe_load(friction_log(tmp_path / "sliding.friction")[0])
    assert head["interface"] == {"types": "1 2", "friction": 0.3, "link": 2}
    assert "interface_2" not in head


@pytest.mark.parametrize(
    "lower, upper, driven",
    [
        ("bronze.mca", "bronze.mca", None),
        ("bronze.mca", "steel.mca", 92),
        ("steel.mca", "bronze.mca", 350),
    ],
)
def test_example_takes_material_files_of_ones_own(tmp_path, lower, upper, driven):
    """The head has both, the weaker first, whichever is on top."""
    (tmp_path / "bronze.mca").write_text(BRONZE, encoding="utf-8")
    example(tmp_path, ns=0.05, material=lower, upper_material=upper)
    head = yaml.safe_load(friction_log(tmp_path / "friction.friction")[0])
    if driven is None:
        assert head["material"]["strength"] == 350 and "other_material" not in head
        assert head["material"]["youngs_modulus"] == 110000 and "layer" not in head["material"]
        return
    assert [head[name]["strength"] for name in ("material", "other_material")] == [92, 350]
    layers = {
        head[name]["strength"]: head[name]["layer"] for name in ("material", "other_material")
    }
    assert layers.pop(driven) == "driven" and list(layers.values()) == ["other"]
