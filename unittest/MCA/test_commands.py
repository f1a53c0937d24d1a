# SPDX-License-Identifier: GPL-2.0-or-later
"""LAMMPS's own commands on a linked sample: the physics is right, or one line says why not."""

import numpy as np
import pytest

from lmp_run import dump, fails, lmp, periodic_block

LONG = pytest.mark.long
RANKS = [1, pytest.param(2, marks=LONG)]
ELASTIC = "mca plasticity none fracture none viscosity none link none heal none weld none"
PLASTIC = "c_state[5]"


def run(folder, data, **more):
    more.setdefault("steps", 200)
    more.setdefault("every", 200)
    result = lmp("in.fragments", folder, data=data, **more)
    return result, dump(folder / "state.dump")[-1][1]


@pytest.fixture(scope="module")
def whole(fragments, tmp_path_factory):
    return run(tmp_path_factory.mktemp("whole"), fragments)[1]


def same(a, b, but=()):
    return all((a[name] == b[name]).all() for name in b if name not in but)


def by_place(frame):
    """Automata in the order of rows and columns, whatever their IDs."""
    order = np.lexsort((frame["x"], np.round(frame["y"], 1)))
    return {c: frame[c][order] for c in frame}


def links(frame):
    return int(frame["c_state[6]"].sum()) // 2


# ---- what does no harm: the same bits


@pytest.mark.parametrize(
    "extra",
    [
        "run 100\nrun 100 pre no",
        "run 0",
        "reset_timestep 0",
        "group left id 1:40\nregion low block INF INF INF 10 INF INF units box\ngroup low region "
        "low",
        "displace_atoms all move 0 0 0",
        "atom_modify sort 50 2.0",
        "neigh_modify every 1 delay 0 check no",
        "write_data between.data nofix\nwrite_restart between.restart",
        "set group lower type 1\nset group all image 0 0 0",
    ],
)
def test_harmless(whole, fragments, tmp_path, extra):
    ran = 200 if extra.startswith("run 100") else 0
    _, frame = run(tmp_path, fragments, extra=extra, steps=200 - ran, every=200)
    assert same(frame, whole)


@pytest.mark.parametrize("ranks", [1, 2])
def test_new_ids_keep_the_links(fragments, tmp_path, ranks):
    """IDs given anew between runs: the links follow their automata, by place."""
    frames = []
    for k, extra in enumerate(["run 100", "run 100\nreset_atoms id sort yes\nrun 0"]):
        _, frame = run(tmp_path / str(k), fragments, extra=extra, steps=100, ranks=ranks)
        frames.append(by_place(frame))
    a, b = frames
    assert (a["id"] != b["id"]).sum() > 50
    assert links(a) == links(b) and (a["c_state[6]"] == b["c_state[6]"]).all()
    for name, scale in (("x", 40), ("y", 40), ("vx", 5140), ("c_state[1]", 206000), (PLASTIC, 1)):
        assert np.abs(a[name] - b[name]).max() < 1e-13 * scale, name


# ---- what removes automata


@pytest.fixture(scope="module")
def lower_alone(fragments, tmp_path_factory):
    return delete_upper(tmp_path_factory.mktemp("alone"), fragments, compress="no")


def delete_upper(folder, data, compress, **more):
    extra = f"run 100\ndelete_atoms group upper compress {compress}"
    return by_place(run(folder, data, extra=extra, steps=100, every=100, style=ELASTIC, **more)[1])


@pytest.mark.parametrize(
    "ranks,newton,compress",
    [
        (1, "on", "yes"),
        (2, "off", "yes"),
        pytest.param(2, "on", "yes", marks=LONG),
        pytest.param(2, "on", "no", marks=LONG),
    ],
)
def test_delete_atoms(lower_alone, fragments, tmp_path, ranks, newton, compress):
    """The upper fragment goes with its links and contacts; the lower one keeps its own."""
    frame = delete_upper(tmp_path, fragments, compress, ranks=ranks, newton=newton)
    assert len(frame["id"]) == 80 and links(frame) == 199
    for name, scale in (("x", 40), ("vx", 5140), ("c_state[1]", 206000)):
        assert np.abs(frame[name] - lower_alone[name]).max() < 1e-12 * scale
    assert np.ptp(frame["c_state[1]"]) > 10


@pytest.mark.parametrize("ranks,newton", [(1, "on"), (2, "on"), pytest.param(2, "off", marks=LONG)])
def test_delete_atoms_within_a_fragment(fragments, tmp_path, ranks, newton):
    """One automaton inside is deleted: its six links end, a line says so, and no other ones."""
    result, frame = run(
        tmp_path,
        fragments,
        steps=1,
        newton=newton,
        ranks=ranks,
        every=1,
        extra="run 10\ngroup one id 24\ndelete_atoms group one",
    )
    assert "6 links ended with automata that were deleted" in result.out
    assert len(frame["id"]) == 159
    frames = [f for _, f in dump(tmp_path / "state.dump")]
    assert links(frames[-1]) == links(frames[-2]) - 6
    assert sorted(np.unique(frame["c_state[6]"], return_counts=True)[1])[0] > 0
    damage, left = frame["c_state[9]"], frame["c_state[6]"]
    assert damage[damage > 0] == pytest.approx(1 / (left[damage > 0] + 1)) and sum(damage > 0) == 6


def test_deleted_in_a_run(fragments, tmp_path):
    """fix evaporate takes automata out of the running simulation."""
    _, frame = run(
        tmp_path,
        fragments,
        extra="region all block INF INF INF INF INF INF\nfix gone all evaporate 50 5 all 4711",
        steps=200,
    )
    assert len(frame["id"]) == 140 and np.isfinite(frame["vx"]).all()


# ---- what moves automata between runs


def test_fragments_move_as_a_whole(whole, fragments, tmp_path):
    """A shift of the whole by an exactly representable vector changes no stress, and no link."""
    _, frame = run(
        tmp_path, fragments, extra="displace_atoms all move 16 0 0", style=ELASTIC, fall=0
    )
    _, still = run(tmp_path / "still", fragments, style=ELASTIC, fall=0)
    assert np.abs(frame["x"] - 16 - still["x"]).max() < 1e-12 * 40
    assert np.abs(frame["c_state[1]"] - still["c_state[1]"]).max() < 1e-12 * 206000


def test_box_grows(whole, fragments, tmp_path):
    _, frame = run(
        tmp_path, fragments, extra="change_box all x final -50 90 y final -50 90 boundary f f p"
    )
    assert same(frame, whole)


@pytest.mark.parametrize("ranks", RANKS)
@pytest.mark.parametrize(
    "move",
    [
        "change_box all x scale 1.001 remap",
        "displace_atoms all ramp x 0 0.1 y 0 20 units box",
        "displace_atoms lower rotate 20 10 0 0 0 1 5",
    ],
)
def test_turned_links_are_refused(fragments, tmp_path, move, ranks):
    fails(
        "in.fragments",
        tmp_path,
        "turned",
        "rad between runs",
        "fix deform",
        data=fragments,
        steps=10,
        style=ELASTIC,
        pull=0,
        fall=0,
        ranks=ranks,
        extra="run 10\n" + move,
    )


@pytest.mark.parametrize("ranks", RANKS)
def test_torn_links_are_refused(fragments, tmp_path, ranks):
    fails(
        "in.fragments",
        tmp_path,
        "links of pair_style mca are stretched beyond the cutoff",
        data=fragments,
        steps=10,
        ranks=ranks,
        extra="run 10\ngroup half id 1:40\ndisplace_atoms half move 0 -9 0",
    )


def test_uniform_dilation_is_right(fragments, tmp_path):
    """It turns no link: the mean stress is that of Hooke's law."""
    strain = 1e-5
    grow = f"change_box all x scale {1 + strain} y scale {1 + strain} remap units box"
    _, frame = run(
        tmp_path,
        fragments,
        style=ELASTIC,
        steps=1,
        every=1,
        pull=0,
        fall=0,
        boundary="f f",
        extra="timestep 1e-6\ndelete_atoms group upper\nrun 1\n" + grow,
    )
    # the middle, which the waves from the free sides have not reached
    inside = (np.abs(frame["x"] - 20) < 8) & (np.abs(frame["y"] - 2 * 2.165) < 1)
    plane = 206000 / (1 + 0.3) / (1 - 2 * 0.3) * strain  # 2 (lambda + G) strain
    assert inside.sum() > 5
    for column in ("c_state[1]", "c_state[2]"):
        assert frame[column][inside] == pytest.approx(plane, rel=1e-4)


# ---- what cannot be followed


@pytest.mark.parametrize(
    "extra,parts",
    [
        ("minimize 0 1e-6 10 10", ["minimize", "damped run"]),
        ("run 0\nrerun state.dump dump x y vx vy", ["rerun", "does not hold the state of links"]),
        ("fix box all deform 1 x erate 0.1 remap x", ["fix box deform", "remap v"]),
        ("fix box all deform 1 x erate 0.1 remap none", ["fix box deform", "remap v"]),
        ("fix box all deform 7 x erate 0.1 remap v", ["fix box deform 7", "fix deform 1"]),
        ("fix box lower deform 1 x erate 0.1 remap v", ["deform of group lower", "group all"]),
        ("fix box all press/berendsen x 0 0 1", ["fix box press/berendsen", "remap v"]),
        ("replicate 2 1 1", ["replicate"]),
        ("run_style respa 2 2", ["Pair style mca", "respa"]),
        ("atom_modify first lower\ncomm_modify group lower", ["comm_modify group", "links"]),
        (
            "pair_style hybrid/scaled 0.5 mca\npair_coeff * * mca steel.mca",
            ["pair_style hybrid/scaled", "stress"],
        ),
    ],
)
def test_refused(fragments, tmp_path, extra, parts):
    result = fails(
        "in.fragments",
        tmp_path,
        *(p for p in parts if p != "replicate"),
        data=fragments,
        steps=10,
        boundary="p s",
        extra=extra,
    )
    assert len(result.error_lines) == 1


def test_short_periodic_box_is_refused(fragments, tmp_path):
    script = (
        periodic_block(2)
        + """
pair_style mca
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
"""
    )
    fails(script, tmp_path, "periodic box is 5 long in direction x", "7.8")


# ---- replicate before the links are made


@pytest.mark.parametrize("ranks", [1, 3])
def test_replicated_sample(tmp_path, ranks):
    script = (
        periodic_block()
        + """
replicate 3 2 1
pair_style mca
pair_coeff * * steel.mca
neighbor 0.4 bin
compute links all mca/atom links
compute sum all reduce sum c_links
thermo_style custom step c_sum
fix 1 all nve/mca
run 0
mca_links create all all
run 0
"""
    )
    without, linked = lmp(script, tmp_path, ranks=ranks).thermo
    assert without["c_sum"][-1] == 0  # a sample has no links before mca_links
    assert linked["c_sum"][-1] == 6 * 480


# ---- with other styles


@pytest.mark.parametrize(
    "style,more",
    [
        ("hybrid/overlay mca zero 5.0", "pair_coeff * * zero"),
        ("hybrid/overlay mca lj/cut 3.0", "pair_coeff * * lj/cut 0 2.5"),
    ],
)
@pytest.mark.parametrize("ranks", RANKS)
def test_hybrid_overlay(whole, fragments, tmp_path, style, more, ranks):
    """Together with a style that does nothing."""
    _, frame = run(tmp_path, fragments, style=style, name="mca", more=more, ranks=ranks)
    for name, scale in (("x", 40), ("vx", 5140), ("c_state[1]", 206000), (PLASTIC, 1)):
        assert np.abs(frame[name] - whole[name]).max() < 1e-12 * scale, name
    assert (frame["c_state[6]"] == whole["c_state[6]"]).all()


def test_hybrid_without_all_types_is_refused(fragments, tmp_path):
    fails(
        "in.fragments",
        tmp_path,
        "Pair style mca in hybrid",
        "between all types, not so 1 2",
        data=fragments,
        name="mca",
        style="hybrid mca zero 5.0",
        more="pair_coeff 1 2 zero",
    )


# ---- who follows the forces, which `steps corrected` has to know

FREE = {
    "free": "fix integrate all nve/mca",
    "flat": "fix integrate all nve/mca\nfix flat all setforce NULL NULL 0",
    "along": "fix integrate all nve/mca\nfix hold wall setforce NULL 0 NULL",
}
HELD = {
    "freeze": "fix integrate all nve/mca\nfix hold wall freeze",
    "setforce": "fix integrate all nve/mca\nfix hold wall setforce 0 0 0",
    "move": "fix integrate mover nve/mca\nfix hold wall move linear 0 0 0",
    "nothing": "fix integrate mover nve/mca",
}


@pytest.mark.parametrize("ranks", RANKS)
@pytest.mark.parametrize("held", FREE | HELD)
def test_viscous_contact_decays(tmp_path, held, ranks):
    """v exp(-eta S t/(d m)) against what is held, twice as fast between two that are free."""
    d, eta, rho, dt, steps, v = 2.5, 410, 0.0078, 1.25e-5, 20, -0.1
    t = lmp(
        f"""units nano
dimension 2
boundary f f p
atom_style sphere
timestep {dt}
region box block -10 10 -10 10 -0.5 0.5
create_box 2 box
create_atoms 1 single -1.2 0 0
create_atoms 2 single $(0.99*{d}-1.2) 0 0
group wall type 1
group mover type 2
pair_style mca viscosity normal plasticity none fracture none link none heal none weld none
pair_coeff * * steel.mca youngs_modulus 1e-3 strength 1e-5 viscosity {eta} density {rho}
neighbor 0.4 bin
velocity mover set {v} 0 0
{(FREE | HELD)[held]}
compute vx mover reduce sum vx
compute wall wall reduce sum vx
thermo_style custom step c_vx c_wall
thermo_modify format float %20.15g
thermo {steps}
run {steps}
""",
        tmp_path,
        ranks=ranks,
    ).thermo[0]
    rate = (
        4 / 3 * eta / (rho * d**2) * (1 if held in FREE else 0.5)
    )  # eta S/(d m), S = d h/sqrt(3), m = rho sqrt(3)/2 d^2 h
    assert (t["c_vx"] - t["c_wall"])[-1] == pytest.approx(v * np.exp(-rate * dt * steps), rel=5e-3)
    assert (t["c_wall"][-1] == 0) == (held in HELD)


def test_material_at_a_temperature(tmp_path):
    """Between two temperatures of the file: the quantities given one by one, to the last bit."""
    # rail_steel.mca at 723 K is half of 673 K and half of 773 K
    words = "youngs_modulus 133900 strength 640.8 elastic_limit 0.440769 yield_strength 1 "
    words += "yield_strain 0.02 breaking_strain 0.04"
    strained = "displace_atoms all ramp y 0 0.3 y 0 20 units box\n"
    stress = []
    for case, coeff in enumerate(("rail_steel.mca temperature 723", f"steel.mca {words}")):
        result = lmp(
            periodic_block()
            + f"pair_style mca\npair_coeff * * {coeff}\n{strained}"
            + "mca_links create all all reach 1.05\nfix 1 all nve/mca\n"
            + "thermo_style custom step pyy pxx\nthermo_modify format float %.15g\nrun 20\n",
            tmp_path / str(case),
        )
        stress.append(result.thermo[0])
    assert stress[0]["Pyy"][-1] != 0.0
    for name in ("Pyy", "Pxx"):
        assert stress[0][name] == pytest.approx(stress[1][name], rel=1e-12)
