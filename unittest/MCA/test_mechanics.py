# SPDX-License-Identifier: GPL-2.0-or-later
"""Mechanics against exact answers: the short versions of the experiments that
doc/howto_mechanics.md shows. Bars as measured and as the issue's limits; see mechanics.py for what
is done."""

import numpy as np
import pytest

import mechanics as m
from lmp_run import dump, largest_difference, lmp

LONG = pytest.mark.long

# ---- elasticity


@pytest.mark.parametrize("plane", ["strain", "stress"])
def test_bar_with_free_sides(tmp_path, plane):
    """Interior: E and Poisson's ratio. The outermost row carries 5/6 of its share before the rows
    below give way, so a bar of n rows is as stiff as n - 1/3 rows of the solid. Outermost rows of a
    stiffer material correct that."""
    stiffer = 1 / m.surface_row(plane)[2]
    assert m.bar(tmp_path / "skin", 10, plane, stiffer)["bar"] == pytest.approx(1, abs=2e-4)
    r = m.bar(tmp_path, 10, plane)
    assert r["interior"] == pytest.approx(1, abs=1e-4)
    assert r["poisson"] == pytest.approx(1, abs=1e-4)
    assert np.abs(r["syy"][4:6]).max() < 1e-6
    ideal, excess, _ = m.surface_row(plane)
    assert r["sxx"][0] == pytest.approx(ideal, abs=0.02) and r["sxx"][-1] == pytest.approx(
        r["sxx"][0]
    )
    assert r["mean"][0] / r["mean"][5] == pytest.approx(excess, abs=0.02)
    # error of E over the nominal height, and over the height between the outermost rows' 5/6
    assert r["bar"] - 1 == pytest.approx(-0.032, abs=0.003)
    assert r["bar"] * 10 / (10 - 1 / 3) == pytest.approx(1, abs=0.004)


@pytest.mark.parametrize(
    "xx,yy,xy",
    [(0.3, -0.7, 0.4), *(pytest.param(*e, marks=LONG) for e in ((1, 0, 0), (1, 1, 0), (0, 0, 1)))],
)
def test_plane_stress_is_hookes(tmp_path, xx, yy, xy):
    """Confined tension, equal tension, shear: the stress of the solid in plane stress, nothing
    across the plane, the same for all automata."""
    strain = 1e-7
    lmp(
        "in.homogeneous",
        tmp_path,
        exx=xx * strain,
        eyy=yy * strain,
        exy=xy * strain,
        plane="stress",
        flow="none",
    )
    frame = dump(tmp_path / "state.dump")[-1][1]
    c = m.E / (1 - m.NU**2)
    expected = (
        np.array(
            [
                c * (xx + m.NU * yy),
                c * (yy + m.NU * xx),
                2 * m.G * xy,
                0,
                c * (1 + m.NU) * (xx + yy) / 3,
            ]
        )
        * strain
    )
    for k in range(5):
        assert np.abs(frame[f"c_state[{k + 1}]"] - expected[k]).max() < 1e-6 * m.K * strain


@pytest.mark.parametrize("mode", ["l", pytest.param("s", marks=LONG)])
def test_dispersion_is_that_of_the_lattice(tmp_path, mode):
    """16 automata a wave: the speed of the discrete lattice, 1 % below that of the solid; the step
    and the interpolated zero crossings cost 3e-4."""
    measured, continuum = m.wave_speed(tmp_path, mode, columns=16)
    assert measured == pytest.approx(m.lattice_speed(mode, 16), rel=5e-4)
    assert measured < continuum


def test_wave_speed_of_a_free_bar(tmp_path):
    measured, expected = m.wave_speed(tmp_path, "bar", columns=256, rows=20, free=True)
    assert measured == pytest.approx(expected, rel=0.01)
    # what is left is the stiffness of 20 - 0.303 rows over the mass of 20
    assert measured == pytest.approx(expected * np.sqrt(1 - 0.303 / 20), rel=0.003)


def test_hertz(tmp_path):
    r = m.hertz(tmp_path, 4)
    assert r["half_width"] == pytest.approx(r["hertz"], abs=0.25 * m.D)
    assert r["p0"] == pytest.approx(r["hertz_p0"], rel=0.02)


# ---- rigid motion, symmetries


@pytest.mark.parametrize("block, degrees", [(False, 90), (True, 217)])
def test_rigid_rotation_keeps_the_stress(tmp_path, block, degrees):
    assert m.turned(tmp_path, block, degrees, degrees) < 1e-8


def sheared_blocks(folder, mirror=1, shift=0.0, order=1, ratio=1):
    """Two linked blocks of unlike materials that collide askew; forces and stresses by place."""
    atoms = [
        (x * m.D + (y % 2) * m.D / 2, y * m.ROW + (6.0 if y > 4 else 5.7) - 5.7, 1 + (y > 4))
        for y in range(10)
        for x in range(9)
    ][::order]
    lines = "".join(
        f"create_atoms {t} single {mirror * (x - 11) + shift!r} {y!r} 0 units box\n"
        for x, y, t in atoms
    )
    lmp(
        m.HEAD.format(dt=2e-5)
        + f"""boundary s s p
region box block {shift - 30} {shift + 30} -5 40 -0.5 0.5 units box
create_box 2 box
{lines}pair_style mca
pair_coeff 1 1 steel.mca
pair_coeff 2 2 steel.mca youngs_modulus {m.E * ratio} strength 150
neighbor 0.4 bin
group low type 1
group high type 2
mca_links create low low
mca_links create high high
velocity low set {mirror * 20} 0 0 units box
velocity high set {-mirror * 20} -60 0 units box
fix integrate all nve/mca
compute state all mca/atom sxx syy sxy mean plastic links
run 400
variable px atom {mirror}*(x-{shift!r})
variable pf atom {mirror}*fx
compute torque all property/atom tqz
variable pt atom {mirror}*c_torque
variable pxy atom {mirror}*c_state[3]
dump final all custom 1 final.dump id v_px y v_pf fy v_pt c_state[1] c_state[2] v_pxy &
  c_state[4] c_state[5] c_state[6]
dump_modify final sort id format float %.17g
run 0
""",
        folder,
    )
    frame = dump(folder / "final.dump")[-1][1]
    return {name: values[::order] for name, values in frame.items()}


def test_mirror_translation_and_order_of_atoms(tmp_path):
    """One collision mirrored, shifted by 512 nm, with IDs (hence i and j of all pairs)
    reversed: equal to round-off, grown by 400 steps of contacts that form and break."""
    start = sheared_blocks(tmp_path / "0")
    assert start["c_state[5]"].max() > 1e-4 and start["v_pf"].max() > 50
    for name, other in {
        "mirror": {"mirror": -1},
        "shift": {"shift": 512.0},
        "order": {"order": -1},
    }.items():
        same = sheared_blocks(tmp_path / name, **other)
        assert (same["c_state[6]"] == start["c_state[6]"]).all(), name
        bar = 1e-7 if name == "shift" else 1e-9  # 512 nm cost three digits of the strains
        for columns in (
            ["v_px", "y"],
            ["v_pf", "fy"],
            ["v_pt"],
            ["c_state[1]", "c_state[2]", "v_pxy", "c_state[4]"],
        ):
            scale = max(np.abs(start[c]).max() for c in columns)
            assert largest_difference(same, start, columns, scale) < bar, (name, columns)


def test_unlike_materials_stay_bounded(tmp_path):
    """A free block of two elastic materials, G ratio 10, for 1e5 steps: its energy neither grows
    nor fades."""
    t = lmp(
        m.HEAD.format(dt=2e-5)
        + f"""boundary s s p
lattice hex {m.D}
region box block 0 13 0 10 -0.5 0.5 units box
create_box 2 box
create_atoms 1 box
region hard block 6 INF 4 INF INF INF units box
set region hard type 2
pair_style mca {m.ELASTIC}
pair_coeff 1 1 steel.mca
pair_coeff 2 2 steel.mca youngs_modulus {10 * m.E}
neighbor 0.4 bin
mca_links create all all
velocity all set 0 0 0
variable v atom 5*sin(x)*cos(y)
velocity all set v_v v_v NULL
fix integrate all nve/mca
compute spin all erotate/sphere
# of discs, m d^2/8, not of balls
variable total equal pe+ke+0.5/0.4*c_spin
thermo 100
thermo_style custom step pe ke v_total
thermo_modify format float %.15g
run 100000
""",
        tmp_path,
    ).thermo[-1]
    total = t["v_total"]
    assert t["PotEng"].max() > 0.1 * total[0]
    assert np.ptp(total) < 0.02 * total[0]
    assert abs(total[-100:].mean() - total[:100].mean()) < 1e-4 * total[0]


# ---- plasticity, fracture


@pytest.mark.parametrize(
    "kind, law",
    [
        ("tension", "isochoric flow contacts"),
        pytest.param("shear", "isochoric flow contacts", marks=LONG),
        pytest.param("tension", "radial", marks=LONG),
        pytest.param("shear", "radial", marks=LONG),
    ],
)
def test_diagram_runs_through_fig5(tmp_path, kind, law):
    """Strains a tenth of Fig. 5's, where the contacts' strain is linear: the three points, the
    stresses of a material point, the plastic work of the curve."""
    r = m.diagram(
        tmp_path, kind, f"plasticity {law} fracture none", scale=0.1, steps=2000, every=10
    )
    strain, stress = m.measured_diagram(r)
    first = int(np.argmax(r["kappa"] > 0))
    assert strain[first - 1] == pytest.approx(stress[first - 1] / m.E, rel=1e-3)
    # flow begins between the rows where the stress reaches the elastic limit
    assert stress[first - 1] < m.Y1 < 2 * stress[first - 1] - stress[first - 2]
    curve = m.MaterialPoint(scale=0.1).yield_stress(r["kappa"][first + 1 :])
    assert np.abs(stress[first + 1 :] - curve).max() < 2e-3 * m.STRENGTH
    for point, value in ((0.0015, m.Y2), (0.004, m.STRENGTH)):
        assert np.interp(point, strain, stress) == pytest.approx(value, rel=0.01)
    reference = m.point_along(r, "isochoric" in law, 0.1)
    # the material point feels what contacts lengthen as they rotate; isochoric takes most of it off
    near = 0.05 if "isochoric" in law else 0.01
    for k, name in enumerate(["sxx", "syy", "szz", "sxy"]):
        assert np.abs(r[name] - reference[:, k]).max() < near * m.STRENGTH, name
    assert r["kappa"][-1] == pytest.approx(reference[-1, 4], rel=0.005)
    # plastic work: the integral of the curve
    cell, kappa = np.sqrt(3) / 2 * m.D**2, np.linspace(0, r["kappa"][-1], 20001)
    curve = m.MaterialPoint(scale=0.1).yield_stress(kappa)
    work = cell * (0.5 * (curve[1:] + curve[:-1]) * np.diff(kappa)).sum()
    assert r["work"][-1] == pytest.approx(work, rel=1e-6)
    assert r["total_work"][-1] == pytest.approx(r["sum_work"][-1], rel=1e-12)


@pytest.mark.parametrize("kind", ["tension", pytest.param("shear", marks=LONG)])
def test_unloads_along_e_and_hardens_isotropically(tmp_path, kind):
    """Slope of unloading; yielding the other way begins at the stress where unloading began."""
    r = m.diagram(
        tmp_path,
        kind,
        "plasticity isochoric flow contacts fracture none",
        scale=0.1,
        reverse=True,
        steps=2000,
    )
    x, stress = (r["shear"], r["sxy"]) if kind == "shear" else (r["exx"], r["sxx"])
    turn = int(np.argmax(x))
    down = slice(turn + 3, turn + 30)
    slope = np.polyfit(x[down], stress[down], 1)[0]
    assert slope == pytest.approx(m.G if kind == "shear" else m.UNIAXIAL["strain"][0], rel=0.01)
    again = (
        np.flatnonzero(np.diff(r["kappa"][turn + 2 :]) > 1e-12)[0] + turn + 3
    )  # the first row of flow
    assert r["equivalent"][again] == pytest.approx(r["equivalent"][turn], rel=0.01)
    assert stress[again] < 0 and stress[turn] > 0


@pytest.mark.parametrize("kind", ["shear", pytest.param("tension", marks=LONG)])
def test_breaks_at_the_breaking_strain(tmp_path, kind):
    """The first links break in the step in which the stretch, or the shear angle, of the most
    strained ones reaches the criterion."""
    r = m.diagram(tmp_path, kind, "", scale=0.1, steps=2000)
    first = min(e[0] for e in r["events"])
    at = {name: np.interp(first, r["step"], r[name]) for name in ("exx", "eyy", "shear")}
    angles = np.radians([0, 60, 120])
    x, y = np.cos(angles), np.sin(angles)
    rx, ry = (1 + at["exx"]) * x + at["shear"] * y, (1 + at["eyy"]) * y
    distance = np.hypot(rx, ry)
    turn = np.arcsin((x * ry - y * rx) / distance)
    intensity = np.sqrt(
        np.maximum(np.log(distance), 0) ** 2 + 4 / 3 * (turn - turn.mean()) ** 2
    ).max()
    assert intensity == pytest.approx(0.004, rel=2e-3)
    assert all(e[3:] == (1, -1) for e in r["events"] if e[0] == first)
    assert r["broken"][-1] > 0 and r["links"][-1] + r["broken"][-1] == r["links"][0]


# ---- criteria

SPEED = 50.0  # nm/ns, 2e-4 of d in a step of 1e-5 ns
SLOW = 1.0
# linked, first distance over d, velocity of the second one along and across the axis in each phase
CASES = [
    (True, 1, [(SPEED, 0)] * 4),
    (True, 1, [(0, SPEED)] * 4),
    (True, 1, [(SPEED, -SPEED)] * 4),
    (True, 1, [(SLOW, 0)] * 4),
    (True, 1, [(0, SLOW)] * 4),
    (True, 1, [(SLOW, -SLOW)] * 4),
    (True, 1, [(-SLOW, 0)] * 4),
    (True, 1, [(-SLOW, SLOW)] * 4),
    (False, 1.001, [(-5, 0), (5, 0), (5, 0), (-8, 0)]),  # welds, heals, is torn
    (False, 1.0, [(-1.5, 0), (0, 0), (3, 0), (-3, 0)]),  # welds, breaks in tension, welds again
    (
        False,
        1.0,
        [(-1.5, 0), (0, 5), (5, 0), (-9, 0)],
    ),  # shears off under pressure, is worn, welds again
    (False, 1.0, [(-1.5, 0), (0, 5), (-5, 0), (5, 0)]),  # worn, then pressed on to healing
    (False, 1.0, [(-5, 0), (9, 0), (5, 0), (0, 0)]),  # heals, and is pulled to 0.7 %
]
PHASES = [100, 150, 200, 150]


# periodic and brittle, pressed along y alone; prints the stress over the strength of its first
# break
PRESSED = """
units nano
dimension 2
boundary p p p
atom_style sphere
timestep 5e-5
lattice hex 2.5
region box block 0 8 0 6 -0.2 0.2
create_box 1 box
create_atoms 1 box
pair_style mca plane {plane} plasticity none fracture {criterion} compressive_strength {ratio} &
  viscosity none link none weld none heal none
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
variable widening equal {widening}
variable vx atom v_widening*0.01*{sign}*(x-xlo)
variable vy atom -0.01*{sign}*(y-ylo)
velocity all set v_vx v_vy 0
fix d all deform 1 x erate $(v_widening*0.01*{sign}) y erate $(-0.01*{sign}) remap v
fix i all nve/mca
compute pr all pair mca
compute st all mca/atom sxx syy
compute m all reduce ave c_st[*]
variable s equal c_m[2]/92
variable side equal c_m[1]/92
variable br equal c_pr[3]
thermo_style custom step v_s v_side c_pr[3]
thermo 10
fix h all halt 5 v_br > 0 error continue
run {steps}
"""


def strength_of(folder, criterion, ratio, plane="strain", sign=1, steps=14000):
    """In compression, or with sign -1 in tension; None where nothing breaks."""
    widening = "0.3/0.7" if plane == "strain" else "0.3"
    script = PRESSED.format(
        criterion=criterion, ratio=ratio, plane=plane, sign=sign, steps=steps, widening=widening
    )
    result = lmp(script, folder)
    table = result.thermo[0]
    print(criterion, ratio, plane, sign, table["v_s"][-1], table["v_side"][-1])
    return result, abs(table["v_s"][-1]) if "Fix halt condition" in result.out else None


@pytest.mark.parametrize("plane", ["strain", "stress"])
@pytest.mark.parametrize("ratio", [3, pytest.param(10, marks=LONG)])
def test_mohr_coulomb_has_both_strengths_in_both_planes(tmp_path, plane, ratio):
    criterion = "mohr-coulomb"
    pressed = strength_of(tmp_path / "c", criterion, ratio, plane)[1]
    pulled = strength_of(tmp_path / "t", criterion, ratio, plane, sign=-1)[1]
    assert pressed == pytest.approx(ratio, rel=0.02)
    assert pulled == pytest.approx(1, rel=0.03)


def test_drucker_prager_in_plane_strain(tmp_path):
    """The figures of the page, and the warning where there is no strength."""
    criterion = "drucker-prager"
    # where the cone is nearly missed, the stress along x that finite strains leave counts much
    for ratio, plane, expected, bar in (
        (3, "stress", 3, 0.03),
        (2, "strain", 2.93, 0.03),
        (3, "strain", 6.28, 0.06),
    ):
        found = strength_of(tmp_path / f"{ratio}{plane}", criterion, ratio, plane)[1]
        assert found == pytest.approx(expected, rel=bar)
    for ratio, told in ((5, False), (6, True)):
        out = strength_of(tmp_path / str(ratio), criterion, ratio, steps=10)[0].out
        assert ("no strength in compression in plane strain, only below 5.323" in out) == told
    assert strength_of(tmp_path / "none", criterion, 6)[1] is None


def criteria(**more):
    return lambda linked: m.PairModel(linked, **more)


@pytest.mark.parametrize(
    "laws, model",
    [
        ("", criteria()),
        ("preset a", criteria(preset="a")),
        ("healed_strain 0.003", criteria(healed=0.003)),
        ("fracture stress", criteria(fracture="stress")),
        ("fracture equivalent", criteria(fracture="equivalent")),
        (
            "fracture drucker-prager compressive_strength 3",
            criteria(fracture="drucker-prager", ratio=3.0),
        ),
        (
            "fracture mohr-coulomb compressive_strength 3",
            criteria(fracture="mohr-coulomb", ratio=3.0),
        ),
        ("fracture none", criteria(fracture="none")),
    ],
    ids=lambda v: v if isinstance(v, str) else "",
)
def test_each_criterion_acts_in_its_step(tmp_path, laws, model):
    """Single pairs that are pulled, sheared and pressed: the steps in which they weld, heal, break,
    are worn and weld again, against the table of links."""
    found, expected = m.pair_events(tmp_path, CASES, laws, PHASES, model)
    assert found == expected
    kinds = {e[2:] for e in found}
    assert {(0, 1)} <= kinds if laws == "preset a" else {(0, 2), (2, -1)} <= kinds
    # an elastic pair at the hardness would break at once by its equivalent stress
    heals = laws not in ("preset a", "fracture equivalent")
    healed = 3 if "healed" in laws else 1
    assert ((2, healed) in kinds) == heals and (2, 4 - healed) not in kinds
    assert ((3, -1) in kinds) == (healed == 3)
    if laws != "fracture none":
        assert (1, -1) in kinds


def test_linking_by_plastic_work(tmp_path):
    """A contact of an automaton that flows: it links in the first step in which the mean plastic
    work of both automata since they touch reaches the given part of the work up to the strength."""
    lmp(
        m.HEAD.format(dt=1e-5)
        + f"""boundary f f p
region box block -10 20 -20 20 -0.5 0.5 units box
create_box 1 box
create_atoms 1 single 0 0 0 units box
create_atoms 1 single {m.D} 0 0 units box
create_atoms 1 single {2 * m.D - 1e-4} 0 0 units box
pair_style mca viscosity none fracture none link none link_work 0.05
pair_coeff * * steel.mca
neighbor 0.4 bin
group pulled id 1
group pair id 1 2
mca_links create pair pair
velocity pulled set -0.5 10 0 units box
fix integrate all nve/mca
fix hold all freeze
compute work all mca/atom plastic_work
fix events all mca/events 1001 step id1 id2 before after
dump work all custom 1 work.dump id c_work
dump_modify work format float %.17g sort id
dump events all local 1001 events.dump index f_events[*]
run 1001
""",
        tmp_path,
    )
    work = np.array([f["c_work"][1:].mean() for _, f in dump(tmp_path / "work.dump")])
    cell = np.sqrt(3) / 2 * m.D**2
    k2, k3 = 0.015 - m.Y2 / m.E, 0.04 - m.STRENGTH / m.E
    enough = 0.05 * cell * ((m.Y1 + m.Y2) / 2 * k2 + (m.Y2 + m.STRENGTH) / 2 * (k3 - k2))
    frame = dump(tmp_path / "events.dump")[-1][1]
    events = [
        tuple(int(frame[f"f_events[{k}]"][e]) for k in range(1, 6))
        for e in range(len(frame["index"]))
    ]
    # the work of a step is in the state of the next one
    first = int(np.argmax(work >= enough)) - 1
    assert 0 < first < 1000
    assert events == [(first, 2, 3, 0, 2)] or events == [(first, 3, 2, 0, 2)]


LAWS = (
    "plasticity isochoric flow contacts fracture drucker-prager compressive_strength 2 "
    "link_work 0.002 heal none"
)
OUTPUT = """neighbor 0.4 bin
neigh_modify every 1 delay 0 check yes
fix integrate all nve/mca
compute state all mca/atom broken formed plastic_work sxx szz energy
compute total all pair mca
compute sums all reduce sum c_state[1] c_state[2] c_state[3]
fix events all mca/events {steps} step id1 id2 before after
dump events all local {steps} events.dump index f_events[*]
thermo {steps}
thermo_style custom step c_total[*] c_sums[*]
thermo_modify format float %.15g
run {steps}
dump state all custom 1 state.dump id x y vx vy c_state[*]
dump_modify state format float %.17g sort id
run 0
write_restart end.restart
"""


def collide(folder, ranks, parts):
    """Two blocks that collide under laws that are off by default, in as many runs as `parts` has
    numbers of steps, each of which reads the restart file of the one before."""
    for k, steps in enumerate(parts):
        start = (
            f"""atom_style sphere
units nano
dimension 2
boundary s s p
timestep 5e-5
read_data {folder.parent}/blocks.data
pair_style mca cutoff 3.6 {LAWS}
pair_coeff * * steel.mca
neighbor 0.4 bin
group low type 1
group high type 2
mca_links create low low
mca_links create high high
velocity high set 60 -150 0 units box
"""
            if k == 0
            else f"read_restart {folder}/{k - 1}/end.restart\n"
        )
        result = lmp(start + OUTPUT.format(steps=steps), folder / str(k), ranks=ranks)
    events = {
        tuple(int(f[f"f_events[{c}]"][m]) for c in range(1, 6))
        for k in range(len(parts))
        for _, f in dump(folder / str(k) / "events.dump")
        for m in range(len(f["index"]))
    }
    events = {(step, min(i, j), max(i, j), before, after) for step, i, j, before, after in events}
    return dump(folder / str(len(parts) - 1) / "state.dump")[-1][1], events, result.thermo[-1]


def test_changes_and_states_of_automata(tmp_path):
    """Broken and formed links of the automata are those of the events, their sums those of compute
    pair; three ranks and two halves with a restart in between give the same as one run."""
    lmp(
        m.HEAD.format(dt=5e-5)
        + f"""boundary s s p
lattice hex {m.D}
region box block -40 80 -6 60 -0.5 0.5 units box
create_box 2 box
region low block 0 40 0 12 -0.5 0.5 units box
region high block 0 40 14 26 -0.5 0.5 units box
create_atoms 1 region low
create_atoms 2 region high
set group all density 1
write_data blocks.data
""",
        tmp_path,
    )
    state, events, thermo = collide(tmp_path / "whole", 1, [600])
    counts = np.zeros((2, len(state["id"])))
    for _, i, j, before, after in events:
        for a in (i, j):
            counts[0][a - 1] += before > 0 >= after
            counts[1][a - 1] += after > 0 >= before
    assert counts[0].sum() > 20 and counts[1].sum() > 4
    t = {k: v[-1] for k, v in thermo.items()}
    for end, others, last in ((state, events, thermo), collide(tmp_path / "halves", 3, [300, 300])):
        assert others == events
        assert (end["c_state[1]"] == counts[0]).all() and (end["c_state[2]"] == counts[1]).all()
        for total, total_too in (("c_total[6]", "c_sums[3]"),):
            assert last[total][-1] == pytest.approx(last[total_too][-1], rel=1e-12)
            assert last[total][-1] == pytest.approx(t[total], rel=1e-10) and t[total] > 0
    first = dump(tmp_path / "whole" / "0" / "state.dump")[-1][1]
    for columns in (
        ["x", "y"],
        ["vx", "vy"],
        ["c_state[3]"],
        ["c_state[4]", "c_state[5]"],
        ["c_state[6]"],
    ):
        scale = max(np.abs(first[c]).max() for c in columns)
        assert largest_difference(end, first, columns, scale) < 1e-9, columns
