# SPDX-License-Identifier: GPL-2.0-or-later
"""Interfaces of types, pair_coeff I J interface: a coating detaches at its strength, elsewhere
nothing changes."""

import numpy as np
import pytest

from lmp_run import dump, fails, lmp

LONG = pytest.mark.long
STRENGTH = 30  # of the interface, MPa; steel has 92

COATED = """
units nano
dimension {dimension}
boundary p s p
atom_style sphere
timestep 2e-5
lattice {lattice} {d}
region box block 0 {x} -0.2 {y} {low} {z} units box
create_box 2 box
create_atoms 1 box
region coating block INF INF $({y}/2) INF INF INF units box
set region coating type 2
pair_style mca plasticity none fracture {fracture} viscosity none link none weld none heal none
pair_coeff * * steel.mca
{interface}
neighbor 0.4 bin
mca_links create all all
# a homogeneous strain rate, so that there are no waves
variable pull atom {rate}*(y-{y}/2)
velocity all set 0 v_pull 0
"""
PULL = """
region upper block INF INF {high} INF INF INF units box
region lower block INF INF INF 2.1 INF INF units box
group upper region upper
group lower region lower
fix integrate all nve/mca
fix upper upper setforce NULL 0 NULL
fix lower lower setforce NULL 0 NULL
compute links all mca/link/local id1 id2 sigma tau strain gamma_total
dump links all local 1 links{tag}.dump c_links[*]
dump_modify links format float %.17g
fix events all mca/events 1 step id1 id2 type1 type2 before after
dump events all local 1 events{tag}.dump f_events[*]
"""
PLANE = dict(dimension=2, lattice="hex", d=2.5, x=20, y=26.1, low=-0.5, z=0.5, rate=0.05)
SPACE = dict(
    dimension=3, lattice="fcc", d=2.5 * 2**0.5, x=10.6066, y=24.7, low=0, z=10.6066, rate=0.05
)


def head(sample, fracture="stress", interface=""):
    return COATED.format(fracture=fracture, interface=interface, **sample)


def pulling(sample, tag=""):
    return PULL.format(high=sample["y"] - 2.3, tag=tag)


def broken(path):
    """{(step, lower ID, higher ID, types)} of links that broke."""
    found = set()
    for _, f in dump(path):
        columns = [f[f"f_events[{k}]"].astype(int) for k in range(1, 8)]
        for step, i, j, a, b, before, after in zip(*columns):
            assert before > 0 >= after
            found.add((step, *sorted((i, j)), *sorted((a, b))))
    return found


def strength_of(fracture, frame):
    """The number that the criterion compares, of each link."""
    columns = [frame[f"c_links[{k}]"] for k in range(1, 7)]
    i, j, sigma, tau, eps, shear = columns
    if fracture == "stress":
        size = np.sqrt(np.maximum(sigma, 0) ** 2 + 3 * tau**2)
    else:
        size = np.sqrt(np.maximum(eps, 0) ** 2 + 4 / 3 * shear**2)
    return {tuple(sorted((int(a), int(b)))): s for a, b, s in zip(i, j, size)}


STRESS = ("stress", f"strength {STRENGTH}", STRENGTH)
STRAIN = ("strain", "breaking_strain 1.5e-4", 1.5e-4)


@pytest.mark.parametrize(
    "sample, fracture, words, limit",
    [
        pytest.param(PLANE, *STRESS, id="plane-stress"),
        pytest.param(SPACE, *STRAIN, id="space-strain"),
        pytest.param(PLANE, *STRAIN, id="plane-strain", marks=LONG),
        pytest.param(SPACE, *STRESS, id="space-stress", marks=LONG),
    ],
)
def test_a_coating_detaches_at_its_interface(tmp_path, sample, fracture, words, limit):
    """In the first step whose links of both types reach the interface's limit, and nowhere else,
    though the others are pulled as much; without an interface nothing breaks."""
    steps = 250
    script = head(sample, fracture, f"pair_coeff 1 2 interface {words}") + pulling(sample)
    lmp(script + f"run {steps}\n", tmp_path / "own")
    events = broken(tmp_path / "own" / "events.dump")
    first = min(step for step, *_ in events)
    assert {(a, b) for *_, a, b in events} == {(1, 2)} and first > 50
    frames = dict(dump(tmp_path / "own" / "links.dump"))
    before, now = (strength_of(fracture, frames[step]) for step in (first - 1, first))
    for step, i, j, *_ in events:
        if step == first:
            assert before[i, j] < limit <= now[i, j] < 1.05 * limit
    elsewhere = [s for pair, s in now.items() if not {pair} & {(i, j) for _, i, j, *_ in events}]
    assert max(elsewhere) > limit
    lmp(head(sample, fracture) + pulling(sample) + f"run {steps}\n", tmp_path / "none")
    assert not broken(tmp_path / "none" / "events.dump")


@pytest.mark.parametrize("ranks", [3, pytest.param(1, marks=LONG)])
def test_ranks_and_restart(tmp_path, ranks):
    """On three ranks, and in a run that goes on from a restart file without its pair_coeff."""
    own = f"pair_coeff 2 1 interface strength {STRENGTH}"
    run = head(PLANE, "stress", own) + pulling(PLANE)
    lmp(run + "run 250\n", tmp_path / "whole")
    expected = broken(tmp_path / "whole" / "events.dump")
    lmp(run + "run 60\nwrite_restart mid.restart\n", tmp_path / "parts", ranks=ranks)
    go_on = "read_restart mid.restart\nneighbor 0.4 bin\n" + pulling(PLANE, ".2")
    lmp(go_on + "run 190\n", tmp_path / "parts", ranks=4 - ranks)
    parts = broken(tmp_path / "parts" / "events.dump")
    assert parts | broken(tmp_path / "parts" / "events.2.dump") == expected and expected


def test_an_interface_alike_changes_no_bit(fragments, tmp_path):
    """The numbers that follow from both materials, given by hand, and one that is taken back."""
    weaker = "strength 92 breaking_strain 0.04 viscosity 410"
    frames = []
    for k, more in enumerate(
        (
            "",
            f"pair_coeff 1 2 interface {weaker}",
            "pair_coeff 1 2 interface viscosity 1\npair_coeff 2 1 interface",
        )
    ):
        lmp(
            "in.fragments",
            tmp_path / str(k),
            data=fragments,
            style="mca preset b",
            fall=50,
            steps=300,
            every=300,
            extra=more,
        )
        frames.append(dump(tmp_path / str(k) / "state.dump")[-1][1])
    for frame in frames[1:]:
        assert all((frame[name] == frames[0][name]).all() for name in frame)


def test_types_of_one_material_link_as_they_like(fragments, tmp_path):
    """With `link none` two fragments that collide stay two, those of one type weld."""
    common = dict(data=fragments, style="mca preset b", fall=50, steps=600, every=600)
    formed = {}
    for name, own in {"none": "pair_coeff 1 2 interface link none", "usual": ""}.items():
        lmp("in.fragments", tmp_path / name, extra=own, **common)
        frame = dump(tmp_path / name / "events.dump")[-1][1]
        columns = [frame[f"f_events[{k}]"].astype(int) for k in range(2, 6)]
        formed[name] = sum(
            after > 0 >= before and min(i, j) <= 80 < max(i, j)
            for i, j, before, after in zip(*columns)
        )
    assert formed["none"] == 0 < formed["usual"]


@pytest.mark.parametrize(
    "words, parts",
    [
        ("1 2 interface strength -1", ["strength is '-1'", "> 0"]),
        ("1 2 interface strenght 1", ["strenght", "strength"]),
        ("1 2 interface strength 30", ["breaking_strain, give it, too"]),
        ("1 3 interface viscosity 1", ["J"]),
        ("1 2 steel.mca", ["a material belongs to a type", "interface"]),
        ("1 2 interface viscosity 1e5", ["Timestep", "types 1 and 2 meet"]),
    ],
)
def test_what_is_refused(fragments, tmp_path, words, parts):
    fails("in.fragments", tmp_path, *parts, data=fragments, extra=f"pair_coeff {words}")
