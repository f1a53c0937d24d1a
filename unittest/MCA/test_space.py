# SPDX-License-Identifier: GPL-2.0-or-later
"""Three dimensions: elastic constants of the packings, a bar with free sides, conservation, ranks,
restart, and what is refused."""

import math

import numpy as np
import pytest

import mechanics as m
from lmp_run import dump, fails, friction_log, largest_difference, lmp

E, NU, D = 206000.0, 0.3, 2.5
LAMBDA, G, K = E * NU / (1 + NU) / (1 - 2 * NU), E / 2 / (1 + NU), E / 3 / (1 - 2 * NU)
STRAIN = 1e-7
LONG = pytest.mark.long
AXES = ("xx", "yy", "zz", "xy", "xz", "yz")
STRESS = [f"c_state[{k}]" for k in range(1, 7)]


def tensor(xx=0, yy=0, zz=0, xy=0, xz=0, yz=0):
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def hooke(eps):
    return LAMBDA * np.trace(eps) * np.eye(3) + 2 * G * eps


CELLS = {"fcc": dict(nx=4, ny=3, nz=3), "hcp": dict(nx=5, ny=3, nz=3), "sc": dict(nx=5, ny=4, nz=4)}


def strained(folder, packing, ranks=1, **strain):
    result = lmp(
        "in.space_homogeneous",
        folder,
        ranks=ranks,
        packing=packing,
        **CELLS[packing],
        **{f"e{k}": v * STRAIN for k, v in strain.items()},
    )
    frame = dump(folder / "state.dump")[-1][1]
    return result, frame, np.array([frame[name] for name in STRESS])


STRAINS = [
    dict(xx=0.3, yy=-0.7, zz=0.2, xy=0.4, xz=-0.1, yz=0.6),
    dict(xx=1, yy=1, zz=1),
    dict(yy=1),
    dict(xy=1),
    dict(xz=1),
    dict(yz=1),
]


@pytest.mark.parametrize(
    "packing, strain",
    [
        pytest.param(p, s, id=f"{p}-{'_'.join(s)}", marks=[LONG] if k else [])
        for p in CELLS
        for k, s in enumerate(STRAINS)
    ],
)
def test_periodic_block_is_hookes(tmp_path, packing, strain):
    """Hydrostatic, confined tension, shears, and all at once: every automaton the same, 1e-6."""
    result, frame, stress = strained(tmp_path, packing, ranks=2 if len(strain) > 3 else 1, **strain)
    expected = hooke(tensor(**strain) * STRAIN)
    size = np.abs(expected).max()
    for k, name in enumerate(AXES):
        i, j = "xyz".index(name[0]), "xyz".index(name[1])
        assert np.abs(stress[k] - expected[i, j]).max() < 1e-6 * size, name
    assert np.abs(frame["c_state[7]"] - np.trace(expected) / 3).max() < 1e-6 * size
    assert (frame["c_state[10]"] == (6 if packing == "sc" else 12)).all()
    last = {k: v[-1] for k, v in result.thermo[-1].items()}
    virial = -np.array([last[f"c_virial[{k}]"] for k in range(1, 7)])
    assert (
        np.abs(
            virial - [expected[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        ).max()
        < 2e-6 * size
    )
    energy = 0.5 * np.sum(expected * tensor(**strain)) * STRAIN * last["Volume"]
    assert last["PotEng"] == pytest.approx(energy, rel=1e-5)


@pytest.mark.parametrize("packing", ["fcc", *(pytest.param(p, marks=LONG) for p in ("hcp", "sc"))])
def test_constants_of_the_packings(tmp_path, packing):
    """E, nu, K and G of the measured stiffness."""
    columns = []
    for name in AXES:
        _, _, stress = strained(tmp_path / name, packing, **{name: 1 if name in AXES[:3] else 0.5})
        columns.append(stress.mean(axis=1) / STRAIN)
    compliance = np.linalg.inv(np.array(columns).T)
    found = {
        "E": 1 / np.diag(compliance)[:3],
        "G": 1 / np.diag(compliance)[3:],
        "nu": -compliance[1:3, 0] / compliance[0, 0],
        "K": 1 / compliance[:3, :3].sum(),
    }
    print(packing, {k: np.round(v, 8).tolist() for k, v in found.items()})
    for name, value in {"E": E, "G": G, "nu": NU, "K": K}.items():
        assert found[name] == pytest.approx(value, rel=1e-5), name


def bar(folder, packing="fcc", cells=5, **variables):
    """Stress, strain across and modulus of the middle and of the whole of a bar, and its sides over
    d."""
    strain, edges = 1e-5, m.lattice(packing)[1]
    result = lmp(
        "in.space_bar",
        folder,
        strain=strain,
        packing=packing,
        cells=cells,
        long=2 if packing == "fcc" else 3,
        **variables,
    )
    frame = dump(folder / "state.dump")[-1][1]
    sides = cells * edges[1:]
    middle = np.ones(len(frame["y"]), bool)
    for axis, side in zip("yz", sides):
        middle &= abs(frame[axis] - (frame[axis].min() + frame[axis].max()) / 2) < 0.1 * side * D
    stress = {name: frame[c][middle].mean() for name, c in zip(AXES, STRESS)}
    inner = frame["y"][middle]
    grown = np.ptp(inner) * (math.sqrt(2) / D)
    across = grown / np.rint(grown) - 1 if packing == "fcc" else math.nan
    last = {k: v[-1] for k, v in result.thermo[-1].items()}
    force = (
        -last["c_virial[1]"]
        * last["Volume"]
        / ((2 if packing == "fcc" else 3) * edges[0] * D * (1 + strain))
    )
    return stress, across / strain, force / np.prod(sides * D) / strain, sides, strain


@pytest.mark.parametrize(
    "packing, missing",
    [
        ("fcc", 0.1025),
        pytest.param("sc", -0.0201, marks=LONG),
        pytest.param("hcp", 0.0702, marks=LONG),
    ],
)
def test_stiffer_surface_corrects_the_bar(tmp_path, packing, missing):
    """What the automata of the free sides lack, and a bar whose automata there make up for it: E
    over the nominal section of 10 x 10 layers, whose error has to be below 1 %."""
    cells = 10 if packing == "sc" else 5
    plain = bar(tmp_path / "plain", packing, cells)[2] / E
    (tmp_path / "skin.txt").write_text(m.stiffer_surface(packing))
    corrected = bar(tmp_path / "stiffer", packing, cells, skin=tmp_path / "skin.txt")[2] / E
    print(packing, "E of the bar", plain, "with a stiffer surface", corrected)
    assert 1 - plain == pytest.approx(missing, abs=0.005)
    assert corrected == pytest.approx(1, abs=0.003)


@pytest.mark.parametrize("cells", [5, pytest.param(10, marks=LONG)])
def test_bar_with_free_sides(tmp_path, cells):
    """E and nu of the interior within 0.1 %, from its stress and strain tensors; the stress across
    the middle of the bar dies away with its thickness."""
    stress, across, whole, _, strain = bar(tmp_path, cells=cells)
    shear = (stress["xx"] - stress["yy"]) / (2 * strain * (1 - across))
    bulk = (stress["xx"] + stress["yy"] + stress["zz"]) / (3 * strain * (1 + 2 * across))
    modulus, ratio = (
        9 * bulk * shear / (3 * bulk + shear),
        (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear),
    )
    print(
        2 * cells,
        "layers: E",
        modulus,
        "nu",
        ratio,
        "apparent",
        stress["xx"] / strain,
        -across,
        "across",
        stress["yy"] / stress["xx"],
        "whole bar",
        whole / E,
    )
    assert modulus == pytest.approx(E, rel=1e-3)
    assert ratio == pytest.approx(NU, rel=1e-3)
    assert abs(stress["yy"]) < 0.008 / cells * stress["xx"]


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
def test_free_block_conserves(tmp_path, ranks):
    """Linear momentum to 1e-13, angular momentum to 1e-11 over 1e4 steps."""
    t = lmp("in.space_free", tmp_path, ranks=ranks).thermo[-1]
    p = np.array([t[f"c_sums[{k}]"] for k in (1, 2, 3)])
    spin = np.array([t[f"c_sums[{k}]"] for k in (4, 5, 6)])
    print(
        "p",
        np.abs(p.T - p[:, 0]).max() / np.linalg.norm(p[:, 0]),
        "L",
        np.abs(spin.T - spin[:, 0]).max() / np.linalg.norm(spin[:, 0]),
    )
    assert np.abs(p.T - p[:, 0]).max() < 1e-13 * np.linalg.norm(p[:, 0])
    assert np.abs(spin.T - spin[:, 0]).max() < 1e-11 * np.linalg.norm(spin[:, 0])
    total = t["PotEng"] + t["KinEng"] + t["c_sums[7]"]
    assert t["PotEng"].max() > 0.05 * total[0]
    assert np.ptp(total) < 2e-3 * total[0]
    assert abs(total[-20:].mean() - total[:20].mean()) < 1e-4 * total[0]


# ---- sliding blocks: ranks and restart

VECTORS = {
    "r": (["x", "y", "z"], None),
    "v": (["vx", "vy", "vz"], 5140),
    "w": (["omegax", "omegay", "omegaz"], 5140 / D),
    "f": (["fx", "fy", "fz"], E * D**2),
    "t": (["tqx", "tqy", "tqz"], E * D**3),
    "s": (STRESS, E),
    "k": (["c_state[7]"], 1.0),
}


def two_blocks(path, lift):
    """Data file of two fcc blocks, the upper one beside the lower one's lattice, and lifted. Each
    automaton is a little off its place, so that no pair comes back to the lattice's distance to the
    last bit: rounding would decide whether it touches."""
    a, atoms, n = D * math.sqrt(2), [], (4, 6, 3)
    for i in range(2 * n[0]):
        for j in range(2 * n[1]):
            for k in range(2 * n[2]):
                if (i + j + k) % 2:
                    continue
                upper = j >= n[1]
                x, y, z = (
                    0.5 * a * c + 1e-6 * math.sin(37.0 * len(atoms) + c)
                    for c in (i + 0.23 * upper, j + lift * upper, k + 0.11 * upper)
                )
                atoms.append(f"{len(atoms) + 1} {1 + upper} {D} 1 {x!r} {y!r} {z!r}")
    path.write_text(
        f"two blocks\n\n{len(atoms)} atoms\n2 atom types\n0 {n[0] * a!r} xlo xhi\n"
        f"-1 {n[1] * a + 1!r} ylo yhi\n0 {n[2] * a!r} zlo zhi\n\nAtoms # sphere\n\n"
        + "\n".join(atoms)
        + "\n"
    )
    return path


@pytest.fixture(scope="module")
def blocks(tmp_path_factory):
    """Far too near to each other, so that much happens within a few steps."""
    return two_blocks(tmp_path_factory.mktemp("blocks") / "space.data", 0.013)


def slide(folder, data, **more):
    lmp("in.space_sliding", folder, data=data, **more)
    return dump(folder / "final.dump")[-1][1], friction_log(folder / "sliding.friction")[1]


@pytest.fixture(scope="module")
def serial(blocks, tmp_path_factory):
    return slide(tmp_path_factory.mktemp("serial"), blocks)


def compare(frame, other, tolerance):
    for columns, scale in VECTORS.values():
        assert largest_difference(frame, other, columns, scale) < tolerance, columns
    for name in ("type", "c_state[8]", "c_state[9]"):
        assert (frame[name] == other[name]).all(), name


@pytest.mark.parametrize(
    "ranks,newton,extra",
    [
        (2, "on", ""),
        (4, "off", ""),
        pytest.param(3, "on", "", marks=LONG),
        pytest.param(4, "on", "", marks=LONG),
        pytest.param(1, "off", "", marks=LONG),
        pytest.param(2, "off", "", marks=LONG),
        (3, "on", "comm_style tiled\nfix balance all balance 100 1.0 rcb"),
    ],
)
def test_same_on_all_ranks(serial, blocks, tmp_path, ranks, newton, extra):
    frame, log = slide(tmp_path, blocks, ranks=ranks, newton=newton, extra=extra)
    assert serial[1]["broken"].sum() > 10 and serial[1]["formed"].sum() > 10
    for name in ("links", "broken", "formed"):
        assert (log[name] == serial[1][name]).all(), name
    compare(frame, serial[0], 1e-12)


def test_the_log_names_its_packing(blocks, tmp_path):
    lmp("in.space_sliding", tmp_path, data=blocks)
    assert "packing: fcc, " in friction_log(tmp_path / "sliding.friction")[0]


def test_plain_steps(serial, blocks, tmp_path):
    one, _ = slide(tmp_path / "one", blocks, scheme="plain viscosity normal", extra=ACCOUNT)
    two, _ = slide(tmp_path / "two", blocks, scheme="plain viscosity normal", ranks=2)
    compare(two, one, 1e-12)
    assert largest_difference(one, serial[0], ["c_state[7]"], 1.0) > 1e-6


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
def test_continues_from_a_restart_file(serial, blocks, tmp_path, ranks):
    whole, _ = slide(tmp_path / "whole", blocks, ranks=ranks, extra="restart 350 mid.*.restart")
    compare(whole, serial[0], 1e-12)
    lmp(
        "in.space_continue",
        tmp_path / "rest",
        ranks=ranks,
        steps=250,
        restart=tmp_path / "whole" / "mid.350.restart",
    )
    compare(dump(tmp_path / "rest" / "final.dump")[-1][1], whole, 1e-12)


ACCOUNT = """compute energy all mca/energy
thermo 50
thermo_style custom step c_energy[*] c_energy
thermo_modify format float %20.15g
"""


@pytest.mark.parametrize(
    "ranks,newton",
    [(1, "on"), pytest.param(2, "on", marks=LONG), pytest.param(2, "off", marks=LONG)],
)
def test_account_of_the_energy(serial, blocks, tmp_path, ranks, newton):
    """It closes while links flow, break and weld; what it misses comes from the violent first
    steps, and falls with the step. The run itself is the same."""
    result = lmp(
        "in.space_sliding", tmp_path, data=blocks, ranks=ranks, newton=newton, extra=ACCOUNT
    )
    compare(dump(tmp_path / "final.dump")[-1][1], serial[0], 1e-12)
    t = result.thermo[0]
    plastic, fracture, viscous, work = (t[f"c_energy[{k}]"] for k in (3, 4, 5, 6))
    lost = plastic + fracture + viscous
    print(
        "shares",
        plastic[-1] / lost[-1],
        fracture[-1] / lost[-1],
        viscous[-1] / lost[-1],
        "error",
        np.abs(t["c_energy"][1:] / lost[1:]).max(),
    )
    assert min(plastic[-1], fracture[-1], viscous[-1]) > 1e-3 * lost[-1]
    assert np.abs(t["c_energy"][1:] / lost[1:]).max() < 1e-4
    held = t["c_energy[1]"] + t["c_energy[2]"] + t["c_energy[9]"]
    assert t["c_energy"] == pytest.approx(held + lost - work - held[0], abs=1e-9 * held[0])


def test_flow_dissipates(tmp_path):
    """Blocks that meet: links flow beside contacts that press, and make no energy of it."""
    data = two_blocks(tmp_path / "blocks.data", 0.4)
    t = lmp("in.space_sliding", tmp_path, data=data, steps=1200, extra=ACCOUNT).thermo[0]
    kinetic, _, plastic, fracture, viscous, _ = (t[f"c_energy[{k}]"] for k in range(1, 7))
    assert plastic[-1] > 0.5 * kinetic.max() and fracture[-1] > 0
    assert np.diff(plastic).min() > -0.01 * plastic[-1]
    assert kinetic[-1] < 0.2 * kinetic.max()
    assert np.abs(t["c_energy"][1:]).max() < 1e-4 * (plastic + fracture + viscous)[-1]


SLIP = "flow contacts viscosity both weld elastic_limit"  # preset c
FURTHER = ["plasticity isochoric flow contacts", "link 2 friction 0.4"]
FURTHER_LONG = [
    SLIP,
    "fracture drucker-prager compressive_strength 3 link_work 0.01",
    "worn never",
    "viscosity both",
    "flow contacts",
    "link none link_work 0.001",
    "fracture equivalent",
]


@pytest.mark.parametrize(
    "laws", [*FURTHER, *(pytest.param(laws, marks=LONG) for laws in FURTHER_LONG)]
)
def test_further_laws(blocks, tmp_path, laws):
    """The account closes, two ranks do the same as one, and so does a run from a restart file."""
    scheme = "corrected " + laws
    step = "timestep 1.25e-5\n" if "both" in laws else ""
    # its shorter steps give round-off more of the violent beginning
    steps, tolerance = (1000, 1e-11) if "both" in laws else (600, 1e-12)
    more = dict(scheme=scheme, steps=steps)
    result = lmp("in.space_sliding", tmp_path / "one", data=blocks, extra=step + ACCOUNT, **more)
    one = dump(tmp_path / "one" / "final.dump")[-1][1]
    t = result.thermo[0]
    friction = t["c_energy[10]"]
    lost = sum(t[f"c_energy[{k}]"] for k in (3, 4, 5)) + friction
    assert np.abs(t["c_energy"][1:] / lost[1:]).max() < 1e-4
    assert np.diff(friction).min() >= 0 and (friction[-1] > 0) == ("friction" in laws)
    log = friction_log(tmp_path / "one" / "sliding.friction")[1]
    assert log["broken"].sum() > 10 and log["formed"].sum() > 10
    extra = f"{step}restart {steps - 250} mid.*.restart"
    two, _ = slide(tmp_path / "two", blocks, ranks=2, extra=extra, **more)
    compare(two, one, tolerance)
    lmp(
        "in.space_continue",
        tmp_path / "rest",
        steps=250,
        restart=tmp_path / "two" / f"mid.{steps - 250}.restart",
    )
    compare(dump(tmp_path / "rest" / "final.dump")[-1][1], two, tolerance)


# ---- refused

SCRIPT = """units nano
dimension {dimension}
boundary p p p
atom_style sphere
lattice {lattice} 2.5
region box block 0 6 0 6 {z}
create_box 1 box
create_atoms 1 box
pair_style mca {keywords}
pair_coeff * * steel.mca
neighbor 0.4 bin
timestep 4e-5
{more}
run 0
"""


@pytest.mark.parametrize(
    "dimension,keywords,more,parts",
    [
        (3, "packing hex", "", ("packing", "hex", "fcc, hcp, sc")),
        (2, "packing fcc", "", ("packing", "fcc", "hex")),
        (3, "packing bcc", "", ("packing", "bcc", "hex, fcc, hcp, sc")),
        (3, "packing sc thickness 2", "", ("thickness", "dimension 2")),
        (
            3,
            "packing sc",
            "compute t all mca/atom theta\ncompute s all reduce sum c_t\n"
            "thermo_style custom step c_s",
            ("theta", "dimension 2"),
        ),
    ],
)
def test_refused(tmp_path, dimension, keywords, more, parts):
    plane = dimension == 2
    fails(
        SCRIPT.format(
            dimension=dimension,
            keywords=keywords,
            more=more,
            lattice="hex" if plane else "sc",
            z="-0.1 0.1" if plane else "0 6",
        ),
        tmp_path,
        *parts,
    )
