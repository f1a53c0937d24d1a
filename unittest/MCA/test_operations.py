# SPDX-License-Identifier: GPL-2.0-or-later
"""Every command and fix of LAMMPS that moves, adds, removes or rescales automata, by name: it is
right, by the account of the energy, or it is refused or warned of in one line."""

import os
import re
import subprocess

import numpy as np
import pytest


from lmp_run import lmp

# a block of two materials, linked, that shears and turns a little; room around it
SAMPLE = """
units nano
dimension 2
boundary {boundary}
atom_style sphere 1
atom_modify map array
timestep 2e-5
neighbor 0.4 bin
lattice hex 2.5
region box block -40 40 -40 40 -0.5 0.5 units box
create_box 2 box
region blk block -15 15 -15 15 INF INF units box
create_atoms 1 region blk
region left block INF 0 INF INF INF INF units box
set region left type 2
group left region left
group right subtract all left
region top block INF INF 10 INF INF INF units box
group top region top
group rest subtract all top
pair_style mca
pair_coeff * * steel.mca strength 920
pair_coeff 2 2 steel.mca strength 500 youngs_modulus 150000
mca_links create all all
variable vx atom 2+0.05*y
variable vy atom 1-0.02*x
velocity all set v_vx v_vy 0
compute en all mca/energy
compute totals all pair mca
thermo_style custom step atoms c_en[*] c_en c_totals[1] pe ke
thermo_modify format float %20.15g
thermo 20
write_dump all custom early.dump id type x y z vx vy vz
"""
MOVES = "fix i all nve/mca\n"
LINE = r"(?:ERROR|WARNING)[^\n]*"


def run(folder, commands, boundary="f f p", **more):
    return lmp(SAMPLE.format(boundary=boundary) + commands, folder, check=False, **more)


def lines(result):
    return re.findall(LINE, result.out + result.err)


def closes(table, bar=1e-5):
    """The account: its error against what the sample has and got."""
    size = table["c_en[1]"].max() + sum(abs(table[f"c_en[{k}]"][-1]) for k in (6, 7, 8))
    assert np.isfinite(table["c_en"]).all()
    assert np.abs(table["c_en"]).max() < bar * size, (np.abs(table["c_en"]).max(), size)


# ---- commands, after links were made and before the first run, and between two runs

# name: (command, outcome). "same": the sample goes on as without it; "changes": the account has
# what it put in or took out, and closes; else part of the line that refuses it
COMMANDS = {
    "displace_atoms": [
        ("displace_atoms all move 1.3 0.7 0 units box", "same"),
        ("displace_atoms all ramp x 0 0.04 y -15 15 units box", "were turned by"),
        ("displace_atoms all rotate 0 0 0 0 0 1 0.5", "were turned by"),
        ("displace_atoms all random 0.01 0.01 0 4711 units box", "were turned by"),
        ("displace_atoms top move 0 9 0 units box", "stretched beyond the cutoff"),
        ("displace_atoms top move 0 -9 0 units box", "stretched beyond the cutoff"),
    ],
    "change_box": [
        ("change_box all x delta -5 5", "same"),
        ("change_box all boundary f p p", "same"),
        ("change_box all x scale 1.001 remap units box", "were turned by"),
        ("change_box all triclinic xy delta 0.5 remap units box", "were turned by"),
    ],
    "create_atoms": [
        ("create_atoms 1 single 30 30 0 units box", "same"),
        ("create_atoms 1 single 0.3 0.2 0 units box", "overlap"),
    ],
    "delete_atoms": [
        ("delete_atoms group top", "changes"),
        ("delete_atoms random fraction 0.1 yes all NULL 4711", "changes"),
        ("delete_atoms overlap 0.5 all all", "same"),
    ],
    "set": [
        ("set group all diameter 3", "same"),
        ("set group all density 0.001", "same"),
        ("set group all mass 7", "same"),
        ("set group all type 1", "changes"),
        ("set group all omega 0 0 3", "changes"),
        ("set group all image 1 NULL NULL", "same"),
        ("variable y atom y+1e-3*x\nset group all y v_y", "were turned by"),
    ],
    "velocity": [
        ("velocity all set 3 1 0 sum yes", "changes"),
        ("velocity all create 1 4711 loop geom", "changes"),
        ("velocity all ramp vx 0 3 y -15 15 units box", "changes"),
        ("velocity all zero linear", "changes"),
        ("velocity all zero angular", "changes"),
    ],
    "read_dump": [("read_dump early.dump 0 x y vx vy box no", "turned")],
    "replicate": [("replicate 2 1 1", "replicate")],
    "reset_atoms": [("reset_atoms id", "same")],
    "balance": [("balance 1.0 shift xy 10 1.05", "same")],
    "read_data": [("read_data more.data add append", "same")],
    "minimize": [("minimize 0 0 10 10", "minimize")],
    "rerun": [("rerun early.dump dump x y vx vy", "rerun")],
    "reset_timestep": [("reset_timestep 0", "same")],
    "timestep": [("timestep 1e-5", "changes"), ("timestep 1e-2", "longer than the critical one")],
    "pair_coeff": [
        ("pair_coeff * * steel.mca strength 920 youngs_modulus 100000", "changes"),
        ("pair_coeff * * steel.mca density 0.004", "changes"),
    ],
    "pair_modify": [("pair_modify shift no", "same")],
    "neigh_modify": [("neigh_modify exclude group top top", "neigh_modify exclude")],
    "mca_links": [("mca_links delete top rest", "changes")],
    "unfix": [("unfix i", "not moved by their velocities")],
}
# those that touch neither places nor sizes nor the list of automata, or need what is not there
HARMLESS = """
angle_write create_bonds create_box delete_bonds box kim_init kim_interactions kim_param
kim_property kim_query reset_ids reset_atom_ids reset_mol_ids message server dihedral_write info
plugin read_restart run write_coeff write_data write_dump write_restart temper temper/npt neb tad
prd dynamical_matrix third_order fitpod geturl group2ndx ndx2group hyper
""".split()
CASES = [
    pytest.param(command, outcome, id=command.replace("\n", ";"))
    for cases in COMMANDS.values()
    for command, outcome in cases
]
MORE = "more.data\n\n1 atoms\n2 atom types\n-40 40 xlo xhi\n-40 40 ylo yhi\n-0.5 0.5 zlo zhi\n"
MORE += "\nAtoms # sphere\n\n1 1 2.5 0.0078 30 30 0\n"


@pytest.mark.parametrize("when", ["first", "between"])
@pytest.mark.parametrize("command, outcome", CASES)
def test_commands(tmp_path, command, outcome, when):
    (tmp_path / "more.data").write_text(MORE, encoding="utf-8")
    begin = MOVES + ("run 0 post no\n" if when == "first" else "run 200\n")
    periodic = command.startswith(("change_box", "set group all image"))
    boundary = "p p p" if periodic and "delta -5" not in command else "f f p"
    result = run(tmp_path, begin + command + "\nrun 200\n", boundary)
    if outcome not in ("same", "changes"):
        assert result.rc != 0 and any(outcome in line for line in lines(result)), lines(result)
        return
    assert result.rc == 0, lines(result)
    before, after = result.thermo[0], result.thermo[-1]
    closes(after)
    energy = [t["c_en[1]"] + t["c_en[2]"] for t in (before, after)]
    put_in = after["c_en[8]"][0] - before["c_en[8]"][-1]
    assert put_in == pytest.approx(energy[1][0] - energy[0][-1], abs=1e-9 * energy[0][0])
    if outcome == "same":
        assert abs(put_in) < 1e-9 * energy[0][0]
        assert after["c_totals[1]"][0] == before["c_totals[1]"][-1]


# ---- fixes in a run

# right: the account closes; sets: velocities, of which the account knows nothing, LAMMPS does; a
# part of a line: refused, or warned of
FIXES = {
    "addforce": ("all addforce 20 -10 0", "right"),
    "addtorque": ("all addtorque 0 0 500", "right"),
    "add/heat": ("", "needs temperature"),
    "adapt": ("all adapt 1 atom diameter v_grows", "Diameter, mass or type of automaton"),
    "aveforce": ("top aveforce 0 30 NULL", "right"),
    "deform": ("all deform 1 x erate 0.05 remap v", "right"),
    "deposit": ("all deposit 3 1 40 4711 region far vy -5 -5 units box", "right"),
    "drag": ("all drag 0 30 NULL 50 2", "right"),
    "enforce2d": ("all enforce2d", "right"),
    "evaporate": ("all evaporate 40 1 top 4711", "right"),
    "freeze": ("top freeze", "right"),
    "gravity": ("all gravity 500 vector 0 -1 0", "right"),
    "heat": ("all heat 1 5", "sets"),
    "indent": ("all indent 2000 sphere 0 22 0 8 units box", "right"),
    "langevin": ("all langevin 3 3 0.1 4711", "right"),
    "lineforce": ("top lineforce 0 1 0", "right"),
    "momentum": ("all momentum 1 linear 1 1 0", "sets"),
    "move": ("top move linear 1 -1 0", "right"),
    "nph/sphere": ("all nph/sphere iso 0 0 1", "it moves automata without their velocities"),
    "npt/sphere": ("all npt/sphere temp 1 1 1 iso 0 0 1", "it moves automata without"),
    "nve/limit": ("all nve/limit 0.1", "moves"),
    "nve/sphere": ("all nve/sphere disc", "moves"),
    "nve": ("all nve", "moves"),
    "nvt/sphere": ("all nvt/sphere temp 1 1 1 disc", "moves"),
    "oneway": ("all oneway 10 far x", "sets"),
    "planeforce": ("top planeforce 0 1 0", "right"),
    "pour": ("all pour 3 1 4711 region rain diam one 2.5", "right"),
    "press/berendsen": ("all press/berendsen iso 0 0 1", "it moves automata without"),
    "recenter": ("all recenter INIT INIT NULL", "right"),
    "rigid": ("top rigid single", "right"),
    "rigid/small": ("top rigid/small molecule", "molecule"),
    "setforce": ("top setforce 0 NULL 0", "right"),
    "spring": ("all spring tether 500 0 0 NULL 1", "right"),
    "spring/self": ("all spring/self 50", "right"),
    "temp/berendsen": ("all temp/berendsen 1 1 0.1", "sets"),
    "temp/csvr": ("all temp/csvr 1 1 0.1 4711", "sets"),
    "temp/rescale": ("all temp/rescale 1 1 1 0 1", "sets"),
    "viscous": ("all viscous 20", "right"),
    "wall/harmonic": ("all wall/harmonic ylo -16 500 1 3 units box", "right"),
    "wall/lj93": ("all wall/lj93 ylo -18 1 2 5 units box", "right"),
    "wall/reflect": ("all wall/reflect ylo -15.2 units box", "sets"),
    "wall/region": ("all wall/region cell harmonic 500 1 3", "right"),
}
GROUPS = {"gravity": "", "pour": "fix g all gravity 500 vector 0 -1 0\n"}
FIX_HEAD = """
region far block -5 5 25 30 -0.1 0.1 units box
region rain block -10 10 25 35 -0.1 0.1 units box
region cell block -17 30 -17 30 INF INF units box
variable grows equal 2.5*(1+1e-5*step)
"""


@pytest.mark.parametrize(
    "style", [style for style, (command, _) in FIXES.items() if command], ids=lambda s: s
)
def test_fixes(tmp_path, style):
    command, outcome = FIXES[style]
    led = {"move", "rigid"}
    integrator = "fix i rest nve/mca\n" if style in led else MOVES
    if outcome == "moves" and style not in led:
        integrator = ""
    commands = FIX_HEAD + integrator + GROUPS.get(style, "") + f"fix tried {command}\nrun 300\n"
    boundary = (
        "p p p" if style in ("deform", "nph/sphere", "npt/sphere", "press/berendsen") else "f f p"
    )
    result = run(tmp_path, commands, boundary)
    told = lines(result)
    if outcome in ("right", "sets"):
        assert result.rc == 0, told
        table = result.thermo[-1]
        assert np.isfinite(table["pe"] if "pe" in table else table["PotEng"]).all()
        if outcome == "right":
            closes(table, 1e-4)
        assert not any("not fix nve/mca" in line for line in told)
    else:
        assert any(outcome in line for line in told), told


# what measures, controls or stores; needs charges, bonds, molecules, grids or another atom style;
# is an old name that LAMMPS refuses
OTHER_FIXES = """accelerate/cos ave/atom ave/chunk ave/correlate ave/correlate/long ave/grid
ave/histo ave/histo/weight ave/time balance box/relax cmap controller damping/cundall
deform/pressure ave/spatial ave/spatial/sphere lb/pc lb/rigid/pc/sphere reax/c/bonds reax/c/species
dt/reset efield efield/tip4p ehex electron/stopping electron/stopping/fit external ffl
filter/corotate flow/gauss gld gle halt heat/flow imd ipi momentum/chunk nonaffine/displacement nph
npt npt/cauchy numdiff numdiff/virial nve/bpm/sphere nve/noforce nvk nvt nvt/sllod pafi pair
press/langevin print property/atom rattle restrain rhok rigid/nph rigid/nph/small rigid/npt
rigid/npt/small rigid/nve rigid/nve/small rigid/nvt rigid/nvt/small shake smd spring/chunk spring/rg
store/force store/state temp/csld thermal/conductivity ti/spring tmd ttm ttm/grid ttm/mod vector
viscosity viscous/sphere wall/ees wall/flow wall/gran wall/gran/region wall/lj1043 wall/lj126
wall/morse wall/reflect/stochastic wall/region/ees wall/table""".split()


@pytest.mark.parametrize(
    "kind, known",
    [("Fix styles", [*FIXES, *OTHER_FIXES]), ("Command styles", [*COMMANDS, *HARMLESS])],
)
def test_every_style_of_this_lammps_is_known(kind, known):
    """A style that is new has to be looked at."""
    page = subprocess.run(
        [os.environ["MCA_LMP_BARE"], "-h"], capture_output=True, text=True, check=True
    ).stdout
    if "4 Feb 2025" not in page:
        pytest.skip("another release has other styles")
    section = re.search(rf"^\* {kind}:?\n\n(.*?)(?=^\* |\Z)", page, re.MULTILINE | re.DOTALL)[1]
    assert sorted(set(section.split()) - set(known)) == []
