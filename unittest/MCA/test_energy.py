# SPDX-License-Identifier: GPL-2.0-or-later
"""compute mca/energy: the account closes, on any number of ranks, and goes on after a restart."""

import numpy as np
import pytest

from lmp_run import fails, lmp

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
    assert sliding["error"] == pytest.approx(total - total[0], abs=1e-9 * sliding["work"][-1])


@pytest.mark.parametrize(
    "laws",
    [
        "preset a",
        "preset b plasticity j2",
        "preset b viscosity none",
        "preset b steps plain",
        "preset b plasticity j2 steps plain",
    ],
)
def test_other_laws_close_too(laws, tmp_path):
    a = account(lmp("in.energy_sliding", tmp_path, laws=laws, steps=1000))
    assert a["dissipated"][-1] > 0
    assert np.abs(a["error"][1:] / a["dissipated"][1:]).max() < 1e-6
    assert (a["viscous"][-1] == pytest.approx(0, abs=1e-3 * a["dissipated"][-1])) == (
        "viscosity none" in laws
    )


@pytest.mark.parametrize("newton", ["on", "off"])
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
pair_style mca
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
