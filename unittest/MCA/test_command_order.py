# SPDX-License-Identifier: GPL-2.0-or-later
"""Commands in any order that LAMMPS allows: fixes before the pair style, timestep and output
between runs, computes after what reads them, restart files of a sample that has not run yet."""

import re

import numpy as np
import pytest

from lmp_run import fails, lmp

RANKS = [1, pytest.param(2, marks=pytest.mark.long)]
BLOCKS = """
units nano
dimension 2
boundary p s p
atom_style sphere
timestep 4e-5
neighbor 0.4 bin
lattice hex 2.5
region box block 0 30 -0.25 28.4 -0.5 0.5 units box
create_box 2 box
region lower mca/rough below 14.07 3.25 5 1 units box
region upper mca/rough above 14.07 3.25 5 1 units box
create_atoms 1 region lower
create_atoms 2 region upper
region bottom block INF INF INF 5 INF INF units box
region top block INF INF 23 INF INF INF units box
group bottom region bottom
group top region top
group lower type 1
group upper type 2
"""
LAWS = """
pair_style mca
pair_coeff * * steel.mca strength 92
mca_links create lower lower
mca_links create upper upper
velocity upper set 5 0 0 units box
"""
FIXES = """
fix integrate all nve/mca
fix hold bottom freeze
"""
SAMPLE = BLOCKS + LAWS + FIXES
DRIVE = "fix drive top mca/drive velocity 5 pressure 15\n"
SHOWN = """
thermo_style custom step f_drive[1] f_drive[2] f_drive[4] f_drive[5]
thermo_modify format float %.15g
thermo 100
"""


def values(text, name):
    """What the input script printed as `name ...`, as numbers."""
    line = re.findall(rf"^{name} (.*)$", text, re.MULTILINE)[-1]
    return [float(word) for word in line.split()]


@pytest.mark.parametrize("ranks", RANKS)
def test_fixes_before_the_pair_style(tmp_path, ranks):
    """To the last bit those of the usual order."""
    usual = lmp(SAMPLE + DRIVE + SHOWN + "run 300\n", tmp_path, ranks=ranks).thermo[0]
    early = BLOCKS + FIXES + LAWS + DRIVE + SHOWN + "run 300\n"
    other = lmp(early, tmp_path, ranks=ranks).thermo[0]
    assert all(np.array_equal(usual[name], other[name]) for name in usual)


def test_restart_of_fixes_before_the_pair_style(tmp_path):
    """Per-atom states find their fixes, whose numbers have changed."""
    first = BLOCKS + FIXES + LAWS + DRIVE + SHOWN
    whole = lmp(first + "run 200\nrun 200\n", tmp_path).thermo[1]
    lmp(first + "run 200\nwrite_restart r.restart\n", tmp_path)
    again = "read_restart r.restart\nneighbor 0.4 bin\n" + FIXES + DRIVE + SHOWN + "run 200\n"
    continued = lmp(again, tmp_path).thermo[0]
    assert all(np.array_equal(whole[name], continued[name]) for name in whole)


@pytest.mark.parametrize(
    "between",
    [
        "unfix integrate\nfix integrate all nve/mca\ntimestep 2e-5\n",
        "pair_style mca preset a\ntimestep 3e-5\npair_coeff * * steel.mca strength 92\n",
        "pair_style none\ntimestep 3e-5\n"
        "pair_style mca preset a\npair_coeff * * steel.mca strength 92\n",
    ],
)
def test_timestep_between_runs(tmp_path, between):
    assert len(lmp(SAMPLE + "run 0\n" + between + "run 10\n", tmp_path).thermo) == 2


def test_a_timestep_that_is_too_long_is_still_refused(tmp_path):
    again = "pair_style mca\ntimestep 4e-4\npair_coeff * * steel.mca\n"
    fails(SAMPLE + "run 0\n" + again + "run 1\n", tmp_path, "longer than the critical one")


def test_values_of_a_drive_that_has_not_run(tmp_path):
    shown = 'print "values $(f_drive[5]) $(f_drive[7]) $(f_drive[8])"\n'
    assert values(lmp(SAMPLE + DRIVE + shown, tmp_path).out, "values") == [0, 0, 0]
    again = "pair_style mca\n" + shown
    assert values(lmp(SAMPLE + DRIVE + "run 0\n" + again, tmp_path).out, "values") == [0, 0, 0]


COMPUTES = """
compute c all mca/atom links mean
compute l all mca/link/local id1 id2 sigma
compute f all mca/fragment/atom
"""
OUTPUTS = pytest.mark.parametrize(
    "output",
    [
        "write_dump all custom x.dump id c_c[*]",
        "write_dump all custom x.dump id c_f",
        "write_dump all local x.dump index c_l[*]",
    ],
)


def test_height_of_a_layer_that_lost_automata(tmp_path):
    shown = 'print "height $(f_drive[5]:%.12g)"\n'
    gone = "region upmost block INF 10 25 INF INF INF units box\ndelete_atoms region upmost\n"
    script = SAMPLE + DRIVE + "run 200\n" + gone + shown
    found = re.findall("^height (.*)$", lmp(script + "run 0\n" + shown, tmp_path).out, re.M)
    assert float(found[0]) == pytest.approx(float(found[1]), rel=1e-9)


@OUTPUTS
def test_output_after_automata_changed_ranks(tmp_path, output):
    moved = FIXES.replace("fix hold bottom freeze\n", "")
    sample = "processors 2 1 1" + BLOCKS + LAWS + moved + COMPUTES
    flown = (
        "velocity all set 150 0 0 units box\nneighbor 1.2 bin\n"
        "neigh_modify check no every 10000 delay 10000\nrun 300\n"
    )
    gone = sample + flown + output + "\nwrite_data x.data\n"
    fails(gone + output + "\n", tmp_path, "write_data", "give run 0 before output", ranks=2)
    lmp(gone + "run 0\n" + output + "\n", tmp_path, ranks=2)


@OUTPUTS
def test_output_after_automata_were_deleted(tmp_path, output):
    gone = SAMPLE + COMPUTES + "run 10\ngroup some id 1:40\ndelete_atoms group some\n"
    fails(gone + output + "\n", tmp_path, "give run 0 before output")
    lmp(gone + "run 0\n" + output + "\n", tmp_path)


def test_links_command_leaves_the_present_values(tmp_path):
    """And a run without set-up goes on as if it had not been given."""
    computes = "compute l all mca/link/local id1 id2 sigma strain\n"
    shown = "write_dump all local {}.dump index c_l[*] modify format float %.12g\n"
    first = SAMPLE + computes + DRIVE + SHOWN + "run 200\n"
    plain = lmp(first + shown.format("a") + "run 200 pre no\n", tmp_path).thermo[1]
    with_links = first + "mca_links write x.links\n" + shown.format("b") + "run 200 pre no\n"
    other = lmp(with_links, tmp_path).thermo[1]
    rows = [
        np.array(sorted(map(tuple, np.loadtxt(tmp_path / f"{name}.dump", skiprows=9)[:, 1:])))
        for name in "ab"
    ]
    assert np.allclose(*rows, rtol=1e-9, atol=1e-9)
    assert all(np.allclose(plain[name], other[name], rtol=1e-9, atol=0) for name in plain)


@pytest.mark.parametrize("ranks", RANKS)
@pytest.mark.parametrize(
    "command", ["mca_links create all all reach 0.1", "write_restart r", "write_data d"]
)
def test_a_new_order_of_automata_is_set_up(tmp_path, command, ranks):
    """LAMMPS lets them migrate outside a run, of which 'pre no' tells nothing."""
    shown = SHOWN.replace("f_drive[5]", "f_drive[5] pe c_en")
    first = SAMPLE + "compute en all mca/energy\n" + DRIVE + shown + "run 500\n" + command + "\n"
    usual = lmp(first + "run 200\n", tmp_path, ranks=ranks).thermo[1]
    other = lmp(first + "run 200 pre no\n", tmp_path, ranks=ranks).thermo[1]
    assert all(np.array_equal(usual[name], other[name]) for name in usual)
    assert np.abs(other["c_en"]).max() < 1e-3
    parts = lmp(first + f'run 200 pre no every 100 "{command}"\n', tmp_path, ranks=ranks).thermo
    assert all(np.isclose(usual[name][-1], parts[2][name][-1], rtol=1e-6) for name in usual)


@pytest.mark.parametrize("pre", ["yes", "no"])
def test_a_run_within_a_run_is_refused(tmp_path, pre):
    """LAMMPS calls no set-up of fixes behind it."""
    nested = f'run 200 pre {pre} every 50 "run 0"\n'
    fails(SAMPLE + DRIVE + nested, tmp_path, "run every", "step 50")


MIGRATING = (
    BLOCKS
    + LAWS
    + """
variable w atom 100+0.1*y
velocity all set v_w 0 0 units box
fix integrate all nve/mca
neigh_modify every 1 delay 0 check yes
thermo_style custom step pe ke
thermo_modify format float %.12g
"""
)


@pytest.mark.parametrize("ranks", [1, 2])
def test_new_ids_before_pre_no_are_told(tmp_path, ranks):
    """LAMMPS does not set up behind reset_atoms."""
    run = "run 75\nreset_atoms id sort yes\nrun 75 pre no\n"
    fails(MIGRATING + run, tmp_path, "leave out 'pre no'", "order or IDs", ranks=ranks)


def test_automata_that_migrate_before_pre_no_are_told(tmp_path):
    """A part of run every does not set up behind write_data."""
    wide = MIGRATING.replace("block 0 30", "block 0 60")
    run = 'run 600 pre no every 75 "write_data d nofix"\n'
    fails(wide + run, tmp_path, "leave out 'pre no'", "write_data", ranks=4)


@pytest.mark.parametrize("ranks", RANKS)
def test_restart_files_between_parts_of_a_run(tmp_path, ranks):
    """They are of the present state, and the run goes on as without them."""
    usual, written = (
        lmp(MIGRATING + f'run 300 every 75 "{command}"\n', tmp_path, ranks=ranks).thermo[-1]
        for command in ("print a", "write_restart r.restart")
    )
    for name in usual:
        assert written[name][-1] == pytest.approx(usual[name][-1], rel=1e-6), name


def test_a_restart_file_behind_a_new_velocity_in_a_run(tmp_path):
    """The viscous forces are those of the new one, as between runs."""
    first = SAMPLE + "compute most all reduce max fx fy\n"
    first += "thermo_style custom step c_most[*]\nthermo_modify format float %.15g\n"
    kick = "velocity upper set 10 -40 0 units box"
    usual = lmp(first + f"run 100\n{kick}\nwrite_restart r\nrun 100\n", tmp_path).thermo[1]
    parts = f"""run 200 every 100 "if '$(step)==100' then '{kick}' 'write_restart r'"\n"""
    other = lmp(first + parts, tmp_path).thermo[1]
    assert all(other[name][0] == pytest.approx(usual[name][0], rel=1e-9) for name in usual)


def test_a_layer_that_loses_automata_in_a_run(tmp_path):
    """Its mass is that of now, as after a set-up."""
    first = BLOCKS + LAWS + FIXES + DRIVE + SHOWN
    first += "region high block INF INF 26 INF INF INF units box\n"
    first += "fix lost all evaporate 20 1 high 4711\n"
    tables = [
        lmp(first + run, tmp_path).thermo[-1]
        for run in ("run 200\n", 'run 200 every 20 "print a"\n')
    ]
    for name in tables[0]:
        assert tables[0][name][-1] == pytest.approx(tables[1][name][-1], rel=1e-3), name


def test_a_fix_that_sets_forces_of_the_layer_is_told_of(tmp_path):
    script = SAMPLE + "fix more top setforce 0 NULL NULL\n" + DRIVE + "run 10\n"
    assert lmp(script, tmp_path).out.count("fix more setforce sets forces of") == 1
    script = SAMPLE + "fix more bottom setforce 0 0 0\n" + DRIVE + "run 10\n"
    assert "sets forces of" not in lmp(script, tmp_path).out


def test_an_account_that_ends_is_no_fall(tmp_path):
    first = SAMPLE + "compute en all mca/energy\nfix drive top mca/drive velocity 25 pressure 15 "
    script = first + "file x.friction every 50\nrun 400\nuncompute en\nrun 100\n"
    assert "dissipates fell by" not in lmp(script, tmp_path).out


def test_another_thickness_is_no_change_of_sizes(tmp_path):
    lmp(SAMPLE + "run 10\nwrite_restart r.restart\n", tmp_path)
    again = "read_restart r.restart\nneighbor 0.4 bin\npair_style mca thickness 2\n"
    assert "become those of their material" not in lmp(again + FIXES + "run 10\n", tmp_path).out


@pytest.mark.parametrize("every", [1, 50])
def test_a_variable_of_a_drive_sees_its_computes_in_each_step(tmp_path, every):
    """Whatever the interval of thermo output, and though the compute is of the pair style."""
    drive = """
compute k upper ke
compute e all pe
variable p equal 15+1e-3*c_k+0*c_e
fix drive top mca/drive velocity 5 pressure v_p
"""
    shown = SHOWN.replace("thermo 100", f"thermo {every}")
    table = lmp(SAMPLE + drive + shown + "run 100\n", tmp_path).thermo[0]
    usual = lmp(SAMPLE + drive + SHOWN + "run 100\n", tmp_path).thermo[0]
    assert all(table[name][-1] == usual[name][-1] for name in usual)


def test_restart_file_before_the_first_run(tmp_path):
    """Height, account and log are those of the run that was not interrupted."""
    account = "compute en all mca/energy\n"
    shown = SHOWN.replace("f_drive[5]", "f_drive[5] c_en[8] c_en")
    first = SAMPLE + account + DRIVE + shown
    whole = lmp(first + "run 200\n", tmp_path).thermo[0]
    lmp(first + "write_restart r.restart\n", tmp_path)
    again = "read_restart r.restart\nneighbor 0.4 bin\n" + FIXES + account + DRIVE + shown
    continued = lmp(again + "run 200\n", tmp_path).thermo[0]
    assert all(np.array_equal(whole[name], continued[name]) for name in whole)


def test_account_after_what_reads_it(tmp_path):
    """Its books of a step are made before any fix reads them, also those defined earlier."""
    late = """
variable e equal c_en
variable d equal c_en[3]
fix p all print 50 "${e} ${d}" file seen.txt screen no title ""
compute en all mca/energy
"""
    columns = "thermo_style custom step c_en c_en[3]\nthermo_modify format float %.15g\nthermo 50\n"
    table = lmp(SAMPLE + DRIVE + late + columns + "run 200\n", tmp_path).thermo[0]
    seen = np.loadtxt(tmp_path / "seen.txt")
    assert seen[1:, 1] == pytest.approx(table["c_en[3]"][1:], rel=1e-5)
    assert np.abs(seen[:, 0]).max() < 1e-4 * np.abs(table["c_en[3]"][-1])


def test_area_of_a_box_that_grows(tmp_path):
    """The stress is the force over the area of now: a further set-up finds it, too."""
    grows = "fix grow all deform 1 x vel 15 remap v\n"
    run, again = lmp(SAMPLE + grows + DRIVE + SHOWN + "run 500\nrun 0\n", tmp_path).thermo
    for name in ("f_drive[1]", "f_drive[2]"):
        assert run[name][-1] == pytest.approx(again[name][0], rel=2e-3)  # 2.5 % longer


def test_interfaces_in_a_restart_file_of_a_hybrid_style(tmp_path):
    laws = LAWS.replace("pair_style mca", "pair_style hybrid/overlay mca zero 4").replace(
        "* * steel.mca", "* * mca steel.mca"
    )
    zero = "pair_coeff * * zero\n"
    laws = laws.replace("mca_links create lower", zero + "mca_links create lower", 1)
    own = laws.replace(zero, zero + "pair_coeff 1 2 mca interface friction 0.7\n", 1)
    first = BLOCKS + own + FIXES + DRIVE + SHOWN
    whole = lmp(first + "run 200\nrun 200\n", tmp_path).thermo[1]
    lmp(first + "run 200\nwrite_restart r.restart\n", tmp_path)
    materials = "pair_coeff * * mca steel.mca strength 92\n" + zero
    again = "read_restart r.restart\nneighbor 0.4 bin\n" + materials + FIXES + DRIVE + SHOWN
    continued = lmp(again + "run 200\n", tmp_path).thermo[0]
    assert all(np.array_equal(whole[name], continued[name]) for name in whole)


def test_rough_line_stays_where_it_was_made(tmp_path):
    """Though the lower face of a shrink-wrapped box moves."""
    box = """
units nano
dimension 2
boundary s s p
atom_style sphere
lattice hex 2.5
region box block -5 35 -0.25 28.4 -0.5 0.5 units box
create_box 1 box
region line mca/rough below 14.07 3.25 5 1 units box
region cut block 0 30 INF INF INF INF units box
region part intersect 2 line cut
create_atoms 1 region part
variable n equal count(all)
variable inside equal count(all,line)
timestep 4e-5
neighbor 0.4 bin
pair_style mca
pair_coeff * * steel.mca
fix integrate all nve/mca
run 0
print "inside ${n} ${inside}"
"""
    n, inside = values(lmp(box, tmp_path).out, "inside")
    assert n == inside > 50


def test_account_of_a_sample_at_rest_says_nothing(tmp_path):
    rest = SAMPLE.replace("velocity upper set 5 0 0 units box", "velocity all set 0 0 0")
    done = lmp(
        rest + "compute en all mca/energy\nthermo_style custom step c_en\nrun 200\n", tmp_path
    )
    assert "WARNING: Compute mca/energy" not in done.out
