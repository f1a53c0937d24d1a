# SPDX-License-Identifier: GPL-2.0-or-later
"""What moves, adds, rescales or leaves out automata beside the laws: right, or refused by name."""

import pytest

from lmp_run import fails, lmp

HEAD = """
units nano
dimension 2
boundary s s p
atom_style sphere
timestep 2e-5
neighbor 0.4 bin
lattice hex 2.5
region box block -40 40 -40 40 -0.5 0.5 units box
create_box 1 box
region blk block -20 20 -20 20 INF INF units box
create_atoms 1 region blk
"""
LAWS = """
pair_style mca plasticity none fracture none viscosity none link none
pair_coeff * * steel.mca
"""
LINKED = LAWS + "mca_links create all all\n"
MOVED = "fix integrate all nve/mca\n"
SHEAR = "displace_atoms all ramp x 0 0.04 y -20 20 units box\n"

# ---- between links and the first run


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize(
    "command",
    [
        SHEAR,
        "displace_atoms all rotate 0 0 0 0 0 1 0.5\n",
        "change_box all triclinic\nchange_box all xy delta 0.08 remap units box\n",
        "change_box all x scale 1.001 remap units box\n",
        "set group all y 0.0\n",
        "fix bend all deform 1 x erate 1e-3 remap v\n" + SHEAR,
    ],
)
def test_links_that_are_turned_before_their_first_run(tmp_path, command, ranks):
    if "set group" in command:
        command = "variable y atom y+1e-4*x\nset group all y v_y\n"
    boundary = HEAD.replace("s s p", "p p p") if "change_box" in command else HEAD
    if "deform" in command:
        boundary = HEAD.replace("s s p", "p s p")
    fails(boundary + LINKED + command + MOVED + "run 0\n", tmp_path, "were turned by", ranks=ranks)


@pytest.mark.parametrize("ranks", [1, 2])
def test_links_that_are_turned_after_they_were_read(tmp_path, ranks):
    lmp(HEAD + LINKED + MOVED + "run 0\nmca_links write x.links\nwrite_data x.data\n", tmp_path)
    sample = HEAD.split("lattice")[0] + "read_data x.data\n" + LAWS + "mca_links read x.links\n"
    lmp(sample + MOVED + "run 0\n", tmp_path, ranks=ranks)
    fails(sample + SHEAR + MOVED + "run 0\n", tmp_path, "were turned by", ranks=ranks)


@pytest.mark.parametrize(
    "command",
    ["displace_atoms all move 1.3 0.7 0 units box\n", "change_box all x delta -5 5 units box\n"],
)
def test_what_turns_no_link_does_no_harm(tmp_path, command):
    lmp(HEAD + LINKED + command + MOVED + "run 20\n", tmp_path)


def test_links_made_of_a_sheared_sample_are_free_of_shear(tmp_path):
    """Moved before links are made, or made anew, it is another sample."""
    again = "mca_links delete all all\n" + SHEAR + "mca_links create all all\n"
    lmp(HEAD + LINKED + again + MOVED + "run 0\n", tmp_path)


# ---- in a run


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("start", [0, 150])
def test_a_fix_that_sets_places_without_velocities(tmp_path, start, ranks):
    move = (
        f"variable dx atom 1e-3*y*(step-{start})*(step>{start})*dt\nvariable none equal 0\n"
        "fix m all move variable v_dx NULL NULL NULL NULL NULL\nrun 300\n"
    )
    parts = ["not moved by their velocities", "fix move variable"]
    fails(HEAD + LINKED + move, tmp_path, *parts, ranks=ranks)


def test_automata_with_a_velocity_that_nothing_moves(tmp_path):
    part = (
        "region left block INF 0 INF INF INF INF\ngroup left region left\nvelocity all set 1 0 0\n"
    )
    script = HEAD + LINKED + part + "velocity left set 2 0 0\nfix 1 left nve/mca\nrun 10\n"
    fails(script, tmp_path, "not moved by their velocities", "not in the group of fix nve/mca")


@pytest.mark.parametrize(
    "fix",
    [
        "nve/mca",
        "move linear 1 2 0",
        "move wiggle 1 0.5 0 0.05 units box",
        "move rotate 0 0 0 0 0 1 0.5",
        "rigid single",
    ],
)
def test_fixes_that_move_by_velocities(tmp_path, fix):
    """A boundary that a fix moves, linked to the rest."""
    part = "region left block INF 0 INF INF INF INF\ngroup left region left\n"
    part += "group rest subtract all left\nvelocity rest set 1 0 0\n"
    part += "fix rest rest nve/mca\n"
    laws = LINKED.replace("fracture none", "fracture none cutoff 4")
    lmp(HEAD + laws + part + f"fix m left {fix}\nrun 300\n", tmp_path)
