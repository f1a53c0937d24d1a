# SPDX-License-Identifier: GPL-2.0-or-later
"""compute mca/energy where something beside the laws acts: fixes in any order, a box that moves,
automata that come and go, commands between runs. What is no error is a term of its own."""

import re

import numpy as np
import pytest

from lmp_run import INPUTS, fails, lmp

LONG = pytest.mark.long
TERMS = ["kinetic", "elastic", "plastic", "fracture", "viscous", "work", "box", "changed"]

BLOCK = """
units nano
dimension 2
boundary {boundary}
atom_style sphere
timestep 4e-5
lattice hex 2.5
region box {box} units box
create_box 2 box
create_atoms 1 box
pair_style mca {laws}
pair_coeff * * steel.mca strength 552
neighbor 0.4 bin
mca_links create all all
"""
OUTPUT = """
thermo_style custom step c_en[*] c_en
thermo_modify norm no format float %20.15g
thermo 50
"""
ACCOUNT = "compute en all mca/energy\n"
STANDING = BLOCK.format(
    boundary="p s p", box="block 0 50 -0.02 $(10*2.5*sqrt(3)/2) -0.5 0.5", laws=""
)
FIXES = """fix i all nve/mca
fix g all gravity 100 vector 0 -1 0
region bot block INF INF INF 3 INF INF units box
group bot region bot
fix h bot freeze
"""


def last(result, run=-1):
    table = result.thermo[run]
    row = {name: table[f"c_en[{k}]"][-1] for k, name in enumerate(TERMS, 1)}
    return dict(row, error=table["c_en"][-1])


def worst(result, run=-1):
    return np.abs(result.thermo[run]["c_en"]).max()


@pytest.fixture(scope="module")
def standing(tmp_path_factory):
    folder = tmp_path_factory.mktemp("standing")
    return last(lmp(STANDING + FIXES + ACCOUNT + OUTPUT + "run 1000\n", folder))


@pytest.mark.parametrize("before", ["", "run 10\ngroup one id 3\ndelete_atoms group one\n"])
def test_read_before_a_set_up_has_seen_the_sample(tmp_path, before):
    script = STANDING + FIXES + ACCOUNT + before + "mca_links create all all\n"
    fails(script + 'print "$(c_en[1])"\n', tmp_path, "mca/energy", "give run 0 before output")
    lmp(script + 'run 0\nprint "$(c_en[1])"\n', tmp_path)


@pytest.mark.parametrize("runs", [1, pytest.param(20, marks=LONG)])
@pytest.mark.parametrize("order", ["before", "between", "behind"])
def test_no_order_of_commands_matters(standing, tmp_path, order, runs):
    fixes = FIXES.split("fix g")
    commands = {
        "before": ACCOUNT + FIXES,
        "between": fixes[0] + ACCOUNT + "fix g" + fixes[1],
        "behind": FIXES + ACCOUNT,
    }[order]
    part = f"run {1000 // runs} pre yes post no\n"
    a = last(lmp(STANDING + commands + OUTPUT + part * runs, tmp_path))
    for name in TERMS:
        assert a[name] == pytest.approx(standing[name], rel=1e-9, abs=1e-9 * a["work"]), name
    assert abs(a["error"]) < 1e-9 * a["work"]


def test_a_driven_layer_defined_behind_it(tmp_path):
    """Its set-up gives the layer a velocity: that is where the account begins."""
    drive = (
        "fix i all nve/mca\nregion top block INF INF 18 INF INF INF units box\n"
        "group top region top\nregion bot block INF INF INF 3 INF INF units box\n"
        "group bot region bot\nfix h bot freeze\nvelocity top set 0 0.3 0 units box\n"
        "velocity top ramp vy 0 1 x 0 50 units box\n"
    )
    fix = "fix drive top mca/drive velocity 5 pressure 15\n"
    both = [
        last(lmp(STANDING + drive + commands + OUTPUT + "run 200\n", tmp_path / str(k)))
        for k, commands in enumerate((ACCOUNT + fix, fix + ACCOUNT))
    ]
    for name in TERMS:
        assert both[0][name] == pytest.approx(both[1][name], rel=1e-9, abs=1e-9), name
    assert both[0]["error"] == pytest.approx(both[1]["error"], abs=1e-9 * both[0]["kinetic"])


SHAPES = {
    "stretched": ("block 0 50 0 $(12*2.5*sqrt(3)/2) -0.5 0.5", "x erate 0.2", "0.2*x", "0"),
    "sheared": ("prism 0 50 0 $(12*2.5*sqrt(3)/2) -0.5 0.5 0 0 0", "xy erate 0.2", "0.2*y", "0"),
}


@pytest.mark.parametrize(
    "shape, laws, ranks",
    [
        ("sheared", "elastic", 1),
        ("stretched", "all", 2),
        pytest.param("stretched", "elastic", 1, marks=LONG),
        pytest.param("stretched", "elastic", 2, marks=LONG),
        pytest.param("stretched", "all", 1, marks=LONG),
        pytest.param("sheared", "elastic", 2, marks=LONG),
        pytest.param("sheared", "all", 1, marks=LONG),
        pytest.param("sheared", "all", 2, marks=LONG),
    ],
)
def test_work_of_the_box(tmp_path, shape, ranks, laws):
    """fix deform with remap v is work, and no error, also where automata pass a face."""
    box, deform, vx, vy = SHAPES[shape]
    words = "plasticity none fracture none link none weld none heal none" if laws != "all" else ""
    script = BLOCK.format(boundary="p p p", box=box, laws=words) + (
        f"variable vx atom {vx}+40\nvariable vy atom {vy}+10\nvelocity all set v_vx v_vy 0\n"
        f"fix d all deform 1 {deform} remap v\nfix i all nve/mca\n"
        "neigh_modify every 1 delay 0 check yes\n"
    )
    result = lmp(script + ACCOUNT + OUTPUT + "run 1000\n", tmp_path, ranks=ranks)
    a = last(result)
    print(shape, laws, a, worst(result))
    assert a["box"] > 100.0
    assert worst(result) < 2e-5 * a["box"]
    assert a["work"] == 0 and a["changed"] == 0


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
@pytest.mark.parametrize(
    "command",
    [
        "velocity all set 3 1 0 sum yes units box\n",
        "region part block 10 20 12 INF INF INF units box\ndelete_atoms region part\n",
        "create_atoms 2 single 25 40 0 units box\n",
        "pair_coeff * * steel.mca strength 552 youngs_modulus 100000\n",
        "pair_coeff * * steel.mca strength 552 density 4\n",
        "mca_links delete all all\n",
        "timestep 2e-5\n",
        "unfix g\n",
    ],
)
def test_what_is_changed_between_runs(tmp_path, command, ranks):
    script = STANDING.replace("p s p", "p f p").replace("sqrt(3)/2) -0.5", "sqrt(3)/2+30) -0.5")
    region = "region solid block INF INF INF 22 INF INF units box\ncreate_atoms 1 region solid"
    script = script.replace("create_atoms 1 box", region)
    result = lmp(
        script + ACCOUNT + FIXES + OUTPUT + "run 1000\n" + command + "run 1000\n",
        tmp_path,
        ranks=ranks,
    )
    before, begin, after = (
        last(result, 0),
        {n: result.thermo[1][f"c_en[{k}]"][0] for k, n in enumerate(TERMS, 1)},
        last(result, 1),
    )
    held = [a["kinetic"] + a["elastic"] for a in (before, begin)]
    assert begin["changed"] == pytest.approx(held[1] - held[0], rel=1e-9, abs=1e-12)
    assert begin["changed"] != 0
    assert after["changed"] == begin["changed"]
    size = after["work"] + abs(after["changed"]) + after["kinetic"]
    assert worst(result, 0) < 1e-8 * size and worst(result, 1) < 1e-6 * size


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
@pytest.mark.parametrize(
    "fix",
    [
        "fix rain all deposit 4 2 40 4711 region rain vy -40 -40 units box",
        "fix gone all evaporate 60 2 rest 4711",
    ],
)
def test_automata_that_come_and_go_in_a_run(tmp_path, fix, ranks):
    script = STANDING.replace("p s p", "p f p").replace("sqrt(3)/2) -0.5", "sqrt(3)/2+30) -0.5")
    script = script.replace(
        "create_atoms 1 box",
        "region solid block INF INF INF 22 INF INF units box\ncreate_atoms 1 region solid",
    )
    more = (
        "region rain block 5 45 30 45 -0.1 0.1 units box\nregion rest block INF INF 10 INF INF INF "
        f"units box\n{fix}\n"
    )
    order = (FIXES + ACCOUNT + more, FIXES + more + ACCOUNT)
    both = [
        lmp(script + commands + OUTPUT + "run 600\n", tmp_path / str(k), ranks=ranks)
        for k, commands in enumerate(order)
    ]
    for result in both:
        a = last(result)
        assert abs(a["changed"]) > 1e-3
        assert worst(result) < 1e-6 * (abs(a["changed"]) + a["work"])
    for name in TERMS:
        assert last(both[0])[name] == pytest.approx(last(both[1])[name], rel=1e-6, abs=1e-9), name


def test_a_restart_file_keeps_all_terms(tmp_path):
    """After changes between runs, and itself no change."""
    first = lmp(
        STANDING + ACCOUNT + FIXES + OUTPUT + "run 200\nvelocity all set 3 1 0 sum yes units box\n"
        "run 200\nwrite_restart x.restart\nrun 200\n",
        tmp_path,
    )
    commands = "read_restart x.restart\n" + "".join(
        line + "\n" for line in FIXES.splitlines() if not line.startswith(("region", "group"))
    )
    second = lmp(commands + ACCOUNT + OUTPUT + "run 200\n", tmp_path)
    for name, value in last(first).items():
        assert last(second)[name] == pytest.approx(value, rel=1e-12, abs=1e-10), name
    assert last(first)["changed"] > 1


@pytest.mark.parametrize(
    "lead",
    [
        "fix m top move linear 2 -1 0",
        "fix m top move wiggle 0.1 0.02 0 0.04 units box",
        "fix m top move rotate 25 10 0 0 0 1 20 units box",
        "velocity top set 0 0 0",
    ],
)
def test_work_of_what_leads_automata(tmp_path, lead):
    script = STANDING.replace("p s p", "s s p").replace("block 0 50", "block -1 51") + (
        "region top block INF INF 18 INF INF INF units box\ngroup top region top\n"
        "group rest subtract all top\nfix i rest nve/mca\nvelocity rest set 0 4 0 units box\n"
    )
    a = lmp(
        script.replace("neighbor", "comm_modify cutoff 8\nneighbor")
        + ACCOUNT
        + lead
        + OUTPUT
        + "run 600\n",
        tmp_path,
    )
    print(lead, last(a))
    assert abs(last(a)["work"]) > 1 or lead.startswith("velocity")
    # wiggle gives the velocity of the end of a step, by which shear grows in the whole of it
    bar = 3e-4 if "wiggle" in lead else 3e-6
    assert worst(a) < bar * (last(a)["kinetic"] + abs(last(a)["work"]))


WARNING = r"WARNING: Compute mca/energy: in step (\d+) (.*), above 0.001 of the energy"


@pytest.mark.parametrize("ranks", [2, pytest.param(1, marks=LONG)])
def test_a_large_error_is_told_once(tmp_path, ranks):
    """A fix that sets velocities: its work is not known."""
    result = lmp(
        STANDING + ACCOUNT + FIXES + OUTPUT + "fix m all momentum 1 linear 1 1 0\n"
        "run 1000\nrun 200\n",
        tmp_path,
        ranks=ranks,
    )
    told = re.findall(WARNING, result.out)
    assert len(told) == 1, result.out[-3000:]
    step, words = told[0]
    number = float(re.fullmatch(r"the error is (\S+)", words)[1])
    # the fix acts behind it in the same step
    assert number == pytest.approx(result.thermo[0]["c_en"][int(step) // 50], rel=0.01)


def test_energy_that_comes_back_is_told_once(tmp_path):
    """plasticity radial far above the strength, in a material that hardly changes its volume: flow
    makes energy."""
    script = (INPUTS / "in.energy_sliding").read_text(encoding="utf-8")
    changes = {
        "pressure 15": "pressure 2300",
        "steel.mca": "steel.mca strength 900 poissons_ratio 0.4",
    }
    for old, new in changes.items():
        assert old in script
        script = script.replace(old, new)
    result = lmp(script, tmp_path, laws="preset c viscosity normal heal none", steps=6000, dt=3e-5)
    told = re.findall(WARNING, result.out)
    plastic = result.thermo[0]["c_energy[3]"]
    assert np.maximum.accumulate(plastic)[-1] > plastic[-1]
    assert len(told) == 1 and "plastic flow has given back" in told[0][1], told


@pytest.mark.parametrize("laws", ["preset d", pytest.param("preset b", marks=LONG)])
def test_friction_gives_no_warning(tmp_path, laws):
    result = lmp("in.energy_sliding", tmp_path, laws=laws, steps=2000, dt=2e-5)
    assert "Compute mca/energy" not in result.out
