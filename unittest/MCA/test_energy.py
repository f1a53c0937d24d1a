# SPDX-License-Identifier: GPL-2.0-or-later
"""compute mca/energy: the account closes, on any number of ranks, and goes on after a restart."""

import re

import numpy as np
import pytest

from lmp_run import STEEL, fails, lmp

LONG = pytest.mark.long
NAMES = {
    "c_energy[1]": "kinetic",
    "c_energy[2]": "elastic",
    "c_energy[3]": "plastic",
    "c_energy[4]": "fracture",
    "c_energy[5]": "viscous",
    "c_energy[6]": "work",
}


def account(result, run=0):
    table = result.thermo[run]
    named = {name: table[column] for column, name in NAMES.items()}
    named["dissipated"] = named["plastic"] + named["fracture"] + named["viscous"]
    named["error"] = table["c_energy"]
    named["step"] = table["Step"]
    named["drive"] = table.get("f_drive")
    named["touching"] = table.get("c_energy[9]")
    named["flow of contacts"] = table.get("c_energy[11]")
    named["slip"] = table.get("c_energy[12]")
    return named


@pytest.fixture(scope="module")
def sliding(tmp_path_factory):
    return account(lmp("in.energy_sliding", tmp_path_factory.mktemp("sliding"), laws="preset b"))


def test_sliding_account_closes(sliding):
    for name in ("plastic", "fracture", "viscous", "work"):
        assert sliding[name][-1] > 0, name
    # each channel is more than a hundred times the bar, so that none could be missing
    assert (
        min(sliding[n][-1] for n in ("plastic", "fracture", "viscous"))
        > 1e-3 * sliding["dissipated"][-1]
    )
    assert np.abs(sliding["error"][1:] / sliding["dissipated"][1:]).max() < 1e-6


def test_error_is_the_sum(sliding):
    total = sliding["kinetic"] + sliding["elastic"] + sliding["dissipated"] - sliding["work"]
    total += sliding["touching"]
    assert sliding["error"] == pytest.approx(total - total[0], abs=1e-9 * sliding["work"][-1])


@pytest.mark.parametrize(
    "laws",
    [
        "preset a",
        "preset b plasticity isochoric flow contacts",
        "preset b viscosity none",
        "preset b viscosity both",
        pytest.param("preset b flow contacts", marks=LONG),
        pytest.param("preset b steps plain", marks=LONG),
        pytest.param("preset b plasticity isochoric flow contacts steps plain", marks=LONG),
        pytest.param("preset b viscosity both steps plain", marks=LONG),
    ],
)
def test_other_laws_close_too(laws, tmp_path):
    dt = 1.25e-5 if "both" in laws else 5e-5
    a = account(lmp("in.energy_sliding", tmp_path, laws=laws, steps=1000, dt=dt))
    assert a["dissipated"][-1] > 0
    assert np.abs(a["error"][1:] / a["dissipated"][1:]).max() < 1e-6
    assert (a["viscous"][-1] == pytest.approx(0, abs=1e-3 * a["dissipated"][-1])) == (
        "viscosity none" in laws
    )
    parts = (
        ("flow of contacts", "plastic", "flow contacts"),
        ("slip", "viscous", "viscosity both"),
    )
    for part, whole, words in parts:
        if words in laws:
            assert 1e-3 * a[whole][-1] < a[part][-1] < 0.999 * a[whole][-1]
        else:
            assert not a[part].any()


@pytest.mark.parametrize("laws", ["", pytest.param("viscosity both", marks=LONG)])
def test_flow_dissipates(laws, tmp_path):
    """What flows about the mean of what flows makes no energy, contacts that are pressed beside
    links and welds too: in no 50 steps."""
    a = account(
        lmp(
            "in.energy_sliding",
            tmp_path,
            laws=f"preset b plasticity isochoric flow contacts {laws}",
            steps=4000,
            dt=4e-5,
        )
    )
    assert a["plastic"][-1] > 0.3 * a["dissipated"][-1]
    assert np.diff(a["plastic"]).min() > -1e-3 * a["plastic"][-1]


@pytest.mark.parametrize("newton", ["on", pytest.param("off", marks=LONG)])
def test_ranks_share_the_account(sliding, newton, tmp_path):
    a = account(lmp("in.energy_sliding", tmp_path, ranks=2, laws="preset b", newton=newton))
    for name in NAMES.values():
        assert a[name][4] == pytest.approx(sliding[name][4], rel=1e-8), name
    assert np.abs(a["error"][1:] / a["dissipated"][1:]).max() < 1e-6


def test_pair_pressed_together(tmp_path):
    # a link that flows until both automata nearly coincide: its shear gets as stiff as 1/r^2, and
    # steps would be unstable below r = sqrt(2/3) c_s dt = 0.052 d
    script = """units nano
dimension 2
atom_style sphere
atom_modify map array
boundary f f p
timestep 5e-5
region box block -10 12.5 -10 10 -0.5 0.5 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 2.5 0 0 units box
pair_style mca plasticity radial
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
group first id 1
group second id 2
velocity second set 0 0.2 0 units box
fix integrate all nve/mca
variable r equal sqrt((x[1]-x[2])^2+(y[1]-y[2])^2)
variable px equal 320*(x[2]-x[1])/v_r
variable py equal 320*(y[2]-y[1])/v_r
variable qx equal -v_px
variable qy equal -v_py
fix press_first first addforce v_px v_py 0
fix press_second second addforce v_qx v_qy 0
fix drag all viscous 36
compute energy all mca/energy
compute totals all pair mca
thermo 200
thermo_style custom step c_energy c_energy[1] c_energy[2] c_energy[3] c_energy[4] &
  c_energy[5] c_energy[6] v_r c_totals[3]
thermo_modify format float %20.15g
run 30000
"""
    result = lmp(script, tmp_path)
    a, table = account(result), result.thermo[0]
    assert np.abs(a["error"]).max() < 1e-9 * a["dissipated"][-1]
    assert a["fracture"][-1] > 0 and table["c_totals[3]"][-1] == 1
    assert table["v_r"][table["c_totals[3]"] == 0].min() > 0.1 * 2.5
    assert table["v_r"].min() > 0.09 * 2.5  # an elastic contact from then on


def test_breaking_takes_nothing_back(tmp_path):
    """A notched plate pulled apart, every step of it: what links pay as they break is theirs."""
    script = """units nano
dimension 2
boundary s s p
atom_style sphere
timestep 5e-5
lattice hex 2.5
region box block 0 $(16*2.5) 0 $(14*2.5*sqrt(3)/2) -0.5 0.5 units box
create_box 1 box
create_atoms 1 box
region notch block INF $(5*2.5) $(6.6*2.5*sqrt(3)/2) $(7.4*2.5*sqrt(3)/2) INF INF units box
delete_atoms region notch
region ends block INF INF $(0.5*2.5) $(12.5*2.5*sqrt(3)/2) INF INF units box side out
group ends region ends
pair_style mca
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
velocity all ramp vy -5 5 y 0 $(13*2.5*sqrt(3)/2) units box
fix integrate all nve/mca
fix hold ends setforce 0 0 0
compute energy all mca/energy
compute totals all pair mca
thermo 1
thermo_style custom step c_energy[1] c_energy[2] c_energy[3] c_energy[4] c_energy[5] c_energy[6] &
  c_energy c_totals[3]
thermo_modify format float %20.15g
run 4000
"""
    result = lmp(script, tmp_path)
    a, broken = account(result), result.thermo[0]["c_totals[3]"]
    steps = np.diff(a["fracture"])
    print("paid", a["fracture"][-1], "by", broken[-1], "links, taken back", steps[steps < 0].sum())
    assert broken[-1] > 30
    assert -steps[steps < 0].sum() < 1e-3 * a["fracture"][-1]
    assert np.abs(a["error"]).max() < 1e-6 * a["dissipated"][-1]


@pytest.mark.parametrize("dimension", [2, 3])
def test_elastic_energy_stays(tmp_path, dimension):
    a = account(lmp("in.energy_elastic", tmp_path, dimension=dimension))
    assert np.ptp(a["elastic"]) > 0.1 * a["kinetic"][0]
    assert a["dissipated"] == pytest.approx(0, abs=1e-9 * a["kinetic"][0])
    assert np.abs(a["error"]).max() < 1e-9 * a["kinetic"][0]


def test_two_runs_and_restart_go_on(sliding, tmp_path):
    first = "run 1000\nwrite_restart half.restart"
    b = lmp(
        "in.energy_sliding",
        tmp_path,
        laws="preset b",
        steps=3000,
        extra="",
        begin=_file(tmp_path, first),
    )
    whole = account(b, run=1)
    assert whole["step"][-1] == 4000
    for name in NAMES.values():
        assert whole[name][-1] == pytest.approx(sliding[name][-1], rel=1e-6), name
    script = """read_restart half.restart
fix integrate all nve/mca
fix hold bottom freeze
fix drive top mca/drive velocity 5 pressure 15
compute energy all mca/energy
thermo_style custom step c_energy c_energy[1] c_energy[2] c_energy[3] c_energy[4] &
  c_energy[5] c_energy[6]
thermo_modify format float %20.15g
run 750
"""
    go_on = account(lmp(script, tmp_path))
    reference = whole["step"].tolist().index(1750)
    for name in NAMES.values():
        assert go_on[name][-1] == pytest.approx(whole[name][reference], rel=1e-9), name
    assert abs(go_on["error"][-1]) < 1e-6 * go_on["dissipated"][-1]


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
def test_first_script_of_the_readme(ranks, tmp_path):
    """Periodic, with ghosts of the own rank. The sanitizers see a read past an array here."""
    readme = (STEEL.parents[1] / "README.md").read_text(encoding="utf-8")
    script = re.search(r"^```lammps\n(.*?)^```", readme, re.MULTILINE | re.DOTALL)[1]
    columns = "c_energy " + " ".join(f"c_energy[{k}]" for k in range(1, 7))
    begin, run = script.rsplit("run ", 1)
    a = account(
        lmp(
            begin
            + "compute energy all mca/energy\nthermo_modify norm no\n"
            + f"thermo_style custom step {columns}\nthermo 100\nrun {run}",
            tmp_path,
            ranks=ranks,
        )
    )
    assert a["step"][-1] == 2500 and a["dissipated"][-1] > 0 and a["work"][-1] > 0
    assert np.abs(a["error"][1:]).max() < 1e-6 * a["work"][-1]


def _file(folder, text):
    path = folder / "begin.txt"
    path.write_text(text + "\n")
    return path


@pytest.mark.parametrize(
    "line, words",
    [
        ("compute e all mca/energy now", ("takes no arguments", "now")),
        ("group g id 1\ncompute e g mca/energy", ("group g", "allowed: all")),
        ("compute e all mca/energy\ncompute f all mca/energy", ("Only one compute mca/energy",)),
    ],
)
def test_bad_input(line, words, tmp_path):
    script = (
        "units nano\ndimension 2\natom_style sphere\nregion b block 0 9 0 9 -0.5 0.5\n"
        "create_box 1 b\npair_style mca\npair_coeff * * steel.mca\n" + line + "\n"
    )
    fails(script, tmp_path, *words)
