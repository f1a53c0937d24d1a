# SPDX-License-Identifier: GPL-2.0-or-later
"""What moves, adds, rescales or leaves out automata beside the laws: right, or refused by name."""

import re

import pytest

from lmp_run import fails, lmp

RANKS = [1, pytest.param(2, marks=pytest.mark.long)]
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


@pytest.mark.parametrize("ranks", RANKS)
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


@pytest.mark.parametrize("ranks", RANKS)
def test_links_that_are_turned_after_they_were_read(tmp_path, ranks):
    lmp(HEAD + LINKED + MOVED + "run 0\nmca_links write x.links\nwrite_data x.data\n", tmp_path)
    sample = HEAD.split("lattice")[0] + "read_data x.data\n" + LAWS + "mca_links read x.links\n"
    lmp(sample + MOVED + "run 0\n", tmp_path, ranks=ranks)
    fails(sample + SHEAR + MOVED + "run 0\n", tmp_path, "were turned by", ranks=ranks)


def test_links_that_are_read_replace_those_that_are_there(tmp_path):
    """What a file of mca_links write leaves out is none, or zero."""
    some = "region left block INF 0 INF INF INF INF\ngroup left region left\n"
    first = HEAD + LINKED + some + "mca_links delete left left\nmca_links write x.links\n"
    changed = MOVED + "run 50\nmca_links create all all\nmca_links read x.links\n"
    lmp(first + changed + "mca_links write y.links\n", tmp_path)
    texts = [(tmp_path / name).read_text().split("Atoms")[0] for name in ("x.links", "y.links")]
    pairs = [re.findall("^# pair.*|^# automaton.*", text, re.MULTILINE) for text in texts]
    assert pairs[0] and sorted(pairs[0]) == sorted(pairs[1])


def test_a_file_without_links_is_read_as_it_was_written(tmp_path):
    script = HEAD + LAWS + "mca_links write x.links\nmca_links create all all\n"
    assert "Read 0 links" in lmp(script + "mca_links read x.links\n", tmp_path).out


@pytest.mark.parametrize(
    "command",
    ["displace_atoms all move 1.3 0.7 0 units box\n", "change_box all x delta -5 5 units box\n"],
)
def test_what_turns_no_link_does_no_harm(tmp_path, command):
    lmp(HEAD + LINKED + command + MOVED + "run 20\n", tmp_path)


def test_velocities_that_are_set_between_runs_act_as_they_are(tmp_path):
    """Viscous forces of the set-up are those of the same sample in a session of its own."""
    box = HEAD.split("lattice")[0]
    laws = LAWS.replace("viscosity none ", "")
    shown = MOVED + (
        "group one id 1\ncompute force one reduce sum fx\n"
        "compute torques all property/atom tqz\ncompute turn one reduce sum c_torques\n"
        'run 0\nprint "values $(c_force:%.12g) $(c_turn:%.12g)"\n'
    )
    pair = (
        "region box block -10 10 -10 10 -0.5 0.5\ncreate_box 1 box\n"
        "create_atoms 1 single -1.24 0 0\ncreate_atoms 1 single 1.24 0.1 0\n"
    )
    moved = "fix move all nve/mca\nvelocity all ramp vx 50 -50 x -1 1\nrun 3\nunfix move\n"
    set_anew = "velocity all set 2 0 0\nset group all omega 0 0 0.1\n"
    script = box + pair + laws + moved + set_anew + shown + "write_data x.data\nclear\n"
    lines = re.findall(
        r"^values (\S+) (\S+)$",
        lmp(script + box + "read_data x.data\n" + laws + shown, tmp_path).out,
        re.MULTILINE,
    )
    assert len(lines) == 2 and float(lines[0][0]) != 0.0
    assert [float(w) for w in lines[0]] == pytest.approx([float(w) for w in lines[1]], rel=1e-9)


def test_a_box_that_grows_beside_the_sample_does_no_harm(tmp_path):
    grows = "fix grow all deform 1 x erate 0.01 remap none\n"
    lmp(HEAD.replace("s s p", "f s p") + LINKED + grows + MOVED + "run 20\n", tmp_path)


def test_links_made_of_a_sheared_sample_are_free_of_shear(tmp_path):
    """Moved before links are made, or made anew, it is another sample."""
    again = "mca_links delete all all\n" + SHEAR + "mca_links create all all\n"
    lmp(HEAD + LINKED + again + MOVED + "run 0\n", tmp_path)


@pytest.mark.parametrize("first", ["", "run 10\n"])
@pytest.mark.parametrize(
    "command, word",
    [
        ("neigh_modify exclude group left left\n", "exclude"),
        ("neigh_modify exclude type 1 1\n", "exclude"),
        ("neigh_modify include left\n", "include"),
    ],
)
def test_pairs_that_are_left_out_of_the_list(tmp_path, command, word, first):
    part = "region left block INF 0 INF INF INF INF\ngroup left region left\n"
    part += "atom_modify first left\n" if word == "include" else ""
    begin, rest = HEAD.split("create_atoms")
    group = "group left empty\natom_modify first left\n" if word == "include" else ""
    script = begin + group + "create_atoms" + rest + LINKED + part.split("atom_modify")[0]
    parts = ["does not work with neigh_modify " + word, "fix freeze"]
    fails(script + MOVED + first + command + "run 10\n", tmp_path, *parts)


# ---- in a run


@pytest.mark.parametrize("ranks", RANKS)
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


# ---- automata that come in a run, and what changes them

RAIN = """
units nano
dimension 2
boundary p f p
atom_style sphere
timestep 2e-5
neighbor 0.4 bin
lattice hex 2.5
region box block 0 50 -5 60 -0.5 0.5 units box
create_box 2 box
region slab block INF INF 0 10 INF INF units box
create_atoms 1 region slab
pair_style mca
pair_coeff * * steel.mca strength 92
mca_links create all all
region rain block 5 45 40 55 -0.1 0.1 units box
fix integrate all nve/mca
fix g all gravity 1000 vector 0 -1 0
"""
SIZES = """
compute size all property/atom mass diameter
compute least all reduce min c_size[1] c_size[2]
compute most all reduce max c_size[1] c_size[2]
thermo_style custom step atoms c_least[1] c_most[1] c_least[2] c_most[2]
thermo_modify format float %.15g
thermo 50
"""
POUR = (
    "fix g2 all gravity 1000 vector 0 -1 0\nfix rain all pour 3 2 4711 region rain diam one 1.5\n"
)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize(
    "command",
    [
        "fix rain all deposit 3 2 100 4711 region rain near 6 vy 0 0 units box\nrun 400\n",
        POUR.replace("fix g2 all gravity 1000 vector 0 -1 0\n", "") + "run 400\n",
        'run 400 every 100 "create_atoms 2 random 1 $(step+17) rain overlap 6 maxtry 100"\n',
    ],
)
def test_automata_that_come_in_a_run_have_their_size_at_once(tmp_path, command, ranks):
    tables = lmp(RAIN + SIZES + command, tmp_path, ranks=ranks).thermo
    assert tables[-1]["Atoms"][-1] > tables[0]["Atoms"][0]
    for table in tables:
        for least, most in (("c_least[1]", "c_most[1]"), ("c_least[2]", "c_most[2]")):
            assert set(table[least]) == set(table[most]) == {tables[0][least][0]}


@pytest.mark.parametrize("ranks", RANKS)
def test_automata_that_come_in_a_run_may_not_overlap(tmp_path, ranks):
    rain = "region on block 5 45 5 8 -0.1 0.1 units box\n"
    rain += "fix rain all deposit 3 2 20 4711 region on vy 0 0 units box\nrun 200\n"
    fails(RAIN + rain, tmp_path, "overlap: ", ranks=ranks)


@pytest.mark.parametrize("ranks", RANKS)
@pytest.mark.parametrize(
    "command, part",
    [
        ("variable d equal 2.5*(1+1e-6*step)\nfix grow all adapt 1 atom diameter v_d\n", "grow"),
        (
            "variable d equal 1+1e-6*step\nfix grow all adapt 1 atom diameter v_d scale yes\n",
            "fix grow adapt",
        ),
    ],
)
def test_what_changes_diameters_in_a_run(tmp_path, command, part, ranks):
    parts = ["Diameter, mass or type of automaton", part, "before step"]
    script = RAIN.replace("style sphere", "style sphere 1") + command + "run 500\n"
    fails(script, tmp_path, *parts, ranks=ranks)


@pytest.mark.parametrize(
    "command", ["create_atoms 2 random 1 17 rain overlap 6", "delete_atoms region slab"]
)
def test_automata_that_come_and_go_without_a_setup(tmp_path, command):
    script = RAIN + f'run 400 pre no every 100 "{command}"\n'
    fails(script, tmp_path, "added or deleted", "pre no")


def test_types_changed_in_a_run(tmp_path):
    more = "pair_coeff 2 2 steel.mca diameter 2.4\nrun 1\n"
    script = RAIN + more + 'run 300 pre no every 100 "set atom 5 type 2"\n'
    fails(script, tmp_path, "type of automaton 5 was changed within a run")
