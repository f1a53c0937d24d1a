# SPDX-License-Identifier: GPL-2.0-or-later
"""Large samples from small ones: command replicate, then mca_links read with its numbers."""

import numpy as np
import pytest

from lmp_run import dump, fails, lmp

PLANE = """
units nano
dimension 2
boundary p s p
atom_style sphere
timestep 2e-5
neighbor 0.4 bin
lattice hex 2.5
region box block 0 8 0 5.9 -0.2 0.2
create_box 1 box
create_atoms 1 box
"""
SPACE = """
units nano
dimension 3
boundary p p p
atom_style sphere
timestep 2e-5
neighbor 0.4 bin
lattice fcc $(2.5*sqrt(2))
region box block 0 4 0 4 0 3
create_box 1 box
create_atoms 1 box
"""
LAWS = "pair_style mca\npair_coeff * * steel.mca\n"
# waves that shear the links, break some and make automata flow
WAVES = """
variable vx atom 45*sin(2*PI*(x-xlo)/lx)*cos(2*PI*(y-ylo)/ly)
variable vy atom 35*cos(2*PI*(x-xlo)/lx+1)
velocity all set v_vx v_vy 0
"""
RUN = """
fix integrate all nve/mca
compute state all mca/atom links plastic damage energy
compute totals all pair mca
thermo_style custom step pe ke c_totals[*]
thermo_modify norm no format float %.15g
"""
DUMP = """
dump state all custom {every} state.dump id x y z vx vy vz c_state[*]
dump_modify state sort id first yes format float %.17g
"""


def copied(frame, number, shift):
    """Automata of a copy, by the ID of their original."""
    n = len(frame["id"]) // 2
    rows = slice(number * n, (number + 1) * n)
    place = np.stack([frame[c][rows] for c in "xyz"])
    place[shift[0]] -= number * shift[1]
    return place, np.stack([frame[c][rows] for c in frame if c not in ("id", "x", "y", "z")])


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("dimension", [2, 3])
def test_copies_go_on_as_their_original(tmp_path, dimension, ranks):
    sample = PLANE if dimension == 2 else SPACE
    first = lmp(
        sample
        + LAWS
        + "mca_links create all all\n"
        + WAVES
        + RUN
        + "thermo 800\nrun 800\nmca_links write x.links\nwrite_data x.data\n"
        + DUMP.format(every=100)
        + "run 200\n",
        tmp_path,
    )
    read = sample.split("lattice")[0] + "read_data x.data\nreplicate 2 1 1\n" + LAWS
    read = read.replace("x.data", "../x.data")
    copies = lmp(
        read
        + "mca_links read ../x.links replicate 2 1 1\n"
        + RUN
        + DUMP.format(every=100)
        + "run 200\n",
        tmp_path / "copies",
        ranks=ranks,
    )
    one, two = first.thermo[1], copies.thermo[0]
    links, flowed, broken = (one[f"c_totals[{k}]"] for k in (1, 6, 3))
    print(links, broken, flowed)
    assert links[-1] > 100 and broken[-1] > 10 and flowed[-1] > 0
    assert two["c_totals[1]"] == pytest.approx(2 * links)
    for column in ("PotEng", "KinEng"):
        assert two[column] == pytest.approx(2 * one[column], rel=1e-9)
    frames = [dump(f / "state.dump") for f in (tmp_path, tmp_path / "copies")]
    for (_, whole), (_, both) in zip(*frames):
        n, length = len(whole["id"]), whole_length(tmp_path)
        assert len(both["id"]) == 2 * n
        for number in (0, 1):
            place, rest = copied(both, number, (0, length))
            off = place - np.stack([whole[c] for c in "xyz"])
            off[0] -= length * np.round(off[0] / length)
            assert np.abs(off).max() < 1e-8
            expected = np.stack([whole[c] for c in whole if c not in ("id", "x", "y", "z")])
            assert rest == pytest.approx(expected, rel=1e-6, abs=1e-6)


def whole_length(folder):
    for line in (folder / "x.data").read_text(encoding="utf-8").splitlines():
        if line.endswith("xlo xhi"):
            low, high = map(float, line.split()[:2])
            return high - low
    raise ValueError("no box")


@pytest.mark.parametrize(
    "words, parts",
    [
        ("replicate 2 1", ("read file replicate nx ny nz",)),
        ("replicate 2 0 1", ("replicate is '0'", "a whole number from 1 to")),
        ("replicate 1.5 2 1", ("1.5", "whole number")),
        ("replicate 5 1 1", ("are not 5 copies",)),
        ("", ("pairs of x.links are not neighbors here",)),
    ],
)
def test_what_is_no_copy(tmp_path, words, parts):
    lmp(
        PLANE
        + LAWS
        + "mca_links create all all\n"
        + RUN
        + "run 0\nmca_links write x.links\nwrite_data x.data\n",
        tmp_path,
    )
    read = PLANE.split("lattice")[0] + "read_data x.data\nreplicate 2 1 1\n" + LAWS
    fails(read + f"mca_links read x.links {words}\n", tmp_path, *parts)


@pytest.mark.parametrize("weights", ["1 0 0", "1 1 0.5", "0 1 1"])
def test_special_bonds_that_leave_pairs_out(tmp_path, weights):
    first = PLANE + LAWS + "mca_links create all all\n" + RUN + "run 0\nmca_links write x.links\n"
    lmp(first, tmp_path)
    read = PLANE.split("lattice")[0].replace("sphere", "hybrid sphere bond") + (
        f"special_bonds lj {weights}\nread_data x.links\nmass * 1\nbond_style zero\n"
        "bond_coeff * 2.5\n"
    )
    fails(read + LAWS + RUN + "run 0\n", tmp_path, "requires special_bonds lj 1 1 1")


def test_bonds_of_a_file_with_periodic_faces(tmp_path):
    """The page's way leaves LAMMPS nothing to warn of: bonds over a face have no image flags."""
    lmp(
        PLANE + LAWS + "mca_links create all all\n" + RUN + "run 0\nmca_links write x.links\n",
        tmp_path,
    )
    read = (
        PLANE.split("lattice")[0].replace("sphere", "hybrid sphere bond")
        + (
            "special_bonds lj 1 1 1\nread_data x.links\n{}mass * 1\n"
            "bond_style zero\nbond_coeff * 2.5\n"
        )
        + LAWS
        + "{}mca_links read x.links\n"
        + RUN
        + "run 10\n"
    )
    warned = lmp(read.format("", ""), tmp_path)
    assert "Inconsistent image flags" in warned.out
    without = lmp(read.format("", "delete_bonds all multi remove\n"), tmp_path)
    assert "Inconsistent image flags" not in without.out
    assert (without.thermo[0]["c_totals[1]"] == warned.thermo[0]["c_totals[1]"]).all()
    assert without.thermo[0]["c_totals[1]"][0] > 200
    copies = read.replace("mass *", "replicate 2 1 1\nmass *").replace(
        "mca_links read x.links\n", "mca_links read x.links replicate 2 1 1\n"
    )
    doubled = lmp(copies.format("", "delete_bonds all multi remove\n"), tmp_path)
    assert doubled.thermo[0]["c_totals[1]"][0] == 2 * without.thermo[0]["c_totals[1]"][0]
