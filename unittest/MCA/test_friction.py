# SPDX-License-Identifier: GPL-2.0-or-later
"""Coulomb friction of unlinked contacts, pair_style mca friction: two automata against the spring
that sticks and slides, step by step; a block on a row of automata; the account, ranks, restarts."""

import numpy as np
import pytest

from lmp_run import dump, fails, largest_difference, lmp
from mechanics import D, E, ELASTIC, G, STRENGTH

MU = 0.3
LAWS = f"elasticity pairwise {ELASTIC} weld none"

PAIR = """units nano
dimension {dimension}
boundary f f {z}
atom_style sphere
timestep 1e-4
region box block -10 10 -10 10 {low} {high} units box
create_box 2 box
create_atoms 1 single 0 0 0 units box
create_atoms 2 single 0 {y} 0 units box
pair_style mca {style}
pair_coeff * * steel.mca
{own}
neighbor 0.4 bin
group upper type 2
dump state all custom 1 state.dump id x y z fx fy fz tqx tqy tqz
dump_modify state sort id format float %.17g
thermo 1
compute virial all pressure NULL virial
thermo_style custom step pe c_virial[4]
thermo_modify format float %.17g
{runs}
"""
DIMENSIONS = {
    2: dict(dimension=2, z="p", low=-0.5, high=0.5),
    3: dict(dimension=3, z="f", low=-10, high=10),
}


def led(*ways):
    """Runs of 100 steps in which the upper automaton is led at these velocities."""
    return "\n".join(
        f"fix lead upper move linear {x} {y} {z}\nrun 100\nunfix lead" for x, y, z in ways
    )


def pair(folder, dimension, runs, style=f"{LAWS} friction {MU}", own="", y=0.999 * D):
    script = PAIR.format(y=y, style=style, own=own, runs=runs, **DIMENSIONS[dimension])
    result = lmp(script, folder)
    frames = dict(dump(folder / "state.dump"))
    get = [np.array([[frames[s][c] for c in "xyz"] for s in sorted(frames)])]
    for names in (("fx", "fy", "fz"), ("tqx", "tqy", "tqz")):
        get.append(np.array([[frames[s][c] for c in names] for s in sorted(frames)]))
    thermo = {
        k: np.concatenate([t[k][bool(n) :] for n, t in enumerate(result.thermo)])
        for k in ("PotEng", "c_virial[4]")
    }
    return *(a.transpose(0, 2, 1) for a in get), thermo


def spring(places, links=np.inf):
    """Normal and tangential stress of the contact at each place, by Cundall and Strack; `links` is
    the pressure that makes a link, whose shear goes on without sliding."""
    shear, before, linked = np.zeros(3), None, False
    rows = []
    for way in places[:, 1] - places[:, 0]:
        r = np.linalg.norm(way)
        n, eps = way / r, r / D - 1
        if before is not None:
            turn = np.cross(before, n)
            sine = np.linalg.norm(turn)
            if sine > 0:
                angle, axis = np.arcsin(sine), turn / sine
                shear = (
                    shear * np.cos(angle)
                    + np.cross(axis, shear) * sine
                    + axis * (axis @ shear) * (1 - np.cos(angle))
                    + angle * np.cross(axis, n)
                )
        before = n
        normal, trial = 2 * G * eps, shear
        limit = MU * max(-normal, 0) * (1 + eps)
        size = 2 * G * np.linalg.norm(shear)
        slides = not linked and size > limit
        if slides:
            shear = shear * limit / size
        linked = linked or -normal >= links
        rows.append((n, eps, normal, 2 * G * shear, trial, slides))
    return rows


WAYS = [(0.3, 0, 0), (-0.6, 0, 0), (0.3, -0.2, 0), (0, 1, 0), (0, -1, 0), (0.3, 0, 0)]


@pytest.mark.parametrize("dimension", [2, 3])
def test_a_contact_sticks_and_slides(tmp_path, dimension):
    """There and back, pressed more and let go: force, torque and energy in every step."""
    ways = WAYS if dimension == 2 else [(x, y, 0.4 * k) for k, (x, y, _) in enumerate(WAYS)]
    x, f, torque, thermo = pair(tmp_path, dimension, led(*ways))
    area = D * 1 / np.sqrt(3) if dimension == 2 else None
    slid = stuck = 0
    rows = spring(x)
    for k, (n, eps, normal, tau, trial, slides) in enumerate(rows):
        if normal > -1e-6 * G:
            assert np.abs(f[k]).max() == 0
            continue
        if area is None:  # that of the packing
            area = -(f[k, 0] @ n) / -normal
        force = area * (normal * n + tau / (1 + eps))
        scale = area * abs(normal)
        assert f[k, 0] == pytest.approx(force, abs=1e-8 * scale)
        assert f[k, 1] == pytest.approx(-force, abs=1e-8 * scale)
        for i in (0, 1):
            assert torque[k, i] == pytest.approx(
                0.5 * area * D * np.cross(n, tau), abs=1e-8 * scale * D
            )
        if slides:  # Coulomb's law
            share = np.linalg.norm(np.cross(f[k, 0], n)) / -(f[k, 0] @ n)
            assert abs(share) == pytest.approx(MU, rel=1e-12)
        energy = 0.5 * area * D * 2 * G * (eps**2 + trial @ trial)
        assert thermo["PotEng"][k] == pytest.approx(energy, rel=1e-8)
        slid, stuck = slid + slides, stuck + (not slides)
    assert slid > 50 and stuck > 30
    volume = 20 * 20 * (1 if dimension == 2 else 20)
    way = x[:, 1] - x[:, 0]
    assert thermo["c_virial[4]"] * volume == pytest.approx(
        way[:, 0] * f[:, 1, 1], abs=1e-9 * np.abs(f).max()
    )


def test_a_link_takes_the_spring_over(tmp_path):
    """Pressed until it links while it rubs: the tangential force does not jump."""
    style = f"{LAWS} friction {MU}".replace("link none", "link elastic_limit")
    x, f, _, _ = pair(tmp_path, 2, led((1, 0, 0), (0.05, -0.05, 0), (1, 0, 0)), style, y=0.9998 * D)
    rows = spring(x, 0.554 * STRENGTH)
    area = D / np.sqrt(3)
    last = 0
    for k, (n, eps, normal, tau, _, slides) in enumerate(rows):
        force = area * (normal * n + tau / (1 + eps))
        assert f[k, 0] == pytest.approx(force, abs=1e-8 * area * abs(normal))
        last = k if slides else last
    assert 50 < last < 250 and abs(rows[-1][3][0]) > 2 * MU * abs(rows[-1][2])


def test_an_interface_has_its_own(tmp_path):
    """A pair of an interface has the bits of the style's; 0 is none."""
    runs = led((1, 0, 0), (-3, 0, 0))
    _, f, _, _ = pair(tmp_path / "style", 2, runs)
    _, own, _, _ = pair(
        tmp_path / "own", 2, runs, LAWS, own=f"pair_coeff 1 2 interface friction {MU}"
    )
    assert (own == f).all()
    _, none, _, _ = pair(
        tmp_path / "none", 2, runs, f"{LAWS} friction 1", own="pair_coeff 1 2 interface friction 0"
    )
    _, plain, _, _ = pair(tmp_path / "plain", 2, runs, LAWS)
    assert (none == plain).all() and not (plain == f).all()


BLOCK = """units nano
dimension 2
boundary p s p
atom_style sphere
timestep 8e-5
lattice hex {d}
region box block 0 $(8*{d}) 0 $(4*{d}*sqrt(3)/2) -0.5 0.5 units box
create_box 2 box
create_atoms 1 box
region block block INF INF $(0.5*{d}) INF INF INF units box
group block region block
set group block type 2
pair_style mca {laws} friction {mu}
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create block block
fix integrate block nve/mca
fix damp block viscous 40
fix press block addforce 0 -200 0
compute slid block com
thermo_style custom step c_slid[1]
run 3000
variable begin equal $(c_slid[1])
fix pull block addforce $(200*{ratio}) 0 0
run 30000
variable end equal $(c_slid[1])
print "way $(v_end-v_begin)"
"""


@pytest.mark.parametrize("mu", [0, 0.3])
def test_a_block_on_a_row_of_automata(tmp_path, mu):
    """It lies in the hollows, under 30 degrees. Pulled, it climbs the flanks before it where the
    pull over the load exceeds tan(30 degrees + the angle of friction), and not below."""
    limit = np.tan(np.pi / 6 + np.arctan(mu))
    ways = []
    for ratio in (0.96 * limit, 1.04 * limit):
        script = BLOCK.format(
            d=D,
            mu=mu,
            ratio=ratio,
            laws=f"{ELASTIC} weld none".replace("viscosity none", "viscosity normal"),
        )
        result = lmp(script, tmp_path / f"{ratio:.3f}")
        line = [s for s in result.out.splitlines() if s.startswith("way ")][-1]
        ways.append(float(line.split()[1]))
    assert abs(ways[0]) < 0.1 * D and ways[1] > D


LONG = pytest.mark.long
RUB = [
    "",
    *(
        pytest.param(laws, marks=LONG)
        for laws in (
            "preset b link none weld none heal none",
            "preset b",
            "steps plain viscosity none",
        )
    ),
]


@pytest.mark.parametrize("laws", RUB)
def test_the_account_knows_friction(tmp_path, laws):
    """It closes, and what friction takes never comes back."""
    dt = 5e-5 if "preset b" in laws else 1.25e-5
    begin = tmp_path / "begin"
    begin.write_text(
        "thermo 10\nthermo_style custom step c_energy c_energy[*]\n"
        "thermo_modify format float %20.15g\n"
    )
    result = lmp(
        "in.energy_sliding", tmp_path, laws=f"{laws} friction 0.4", steps=2000, dt=dt, begin=begin
    )
    t = result.thermo[0]
    friction = t["c_energy[10]"]
    lost = t["c_energy[3]"] + t["c_energy[4]"] + t["c_energy[5]"] + friction
    assert friction[-1] > 2e-3 * lost[-1]
    assert np.diff(friction).min() >= 0
    assert np.abs(t["c_energy"][25:] / lost[25:]).max() < 1e-6
    total = t["c_energy[1]"] + t["c_energy[2]"] + lost + t["c_energy[9]"]
    total -= t["c_energy[6]"] + t["c_energy[7]"] + t["c_energy[8]"]
    assert t["c_energy"] == pytest.approx(total - total[0], abs=1e-9 * lost[-1])
    assert "WARNING: Compute mca/energy" not in result.out


def test_refused(tmp_path, fragments):
    for word in ("-0.1", "nan", "x"):
        fails(
            "in.fragments",
            tmp_path,
            "keyword friction",
            f"value {word}",
            ">= 0",
            data=fragments,
            style=f"mca friction {word}",
        )
    fails(
        "in.fragments",
        tmp_path,
        "interface friction is '-1'",
        ">= 0",
        data=fragments,
        extra="pair_coeff 1 2 interface friction -1",
    )


def test_no_friction_changes_no_bit(tmp_path, fragments):
    frames = []
    for k, style in enumerate(("mca", "mca friction 0", "mca friction 0.4")):
        lmp(
            "in.fragments",
            tmp_path / str(k),
            data=fragments,
            style=style,
            fall=50,
            steps=400,
            every=400,
        )
        frames.append(dump(tmp_path / str(k) / "state.dump")[-1][1])
    assert all((frames[1][name] == frames[0][name]).all() for name in frames[0])
    assert largest_difference(frames[2], frames[0], ["vx"]) > 1e-3


@pytest.mark.parametrize("ranks", [2, pytest.param(3, marks=LONG)])
def test_ranks(tmp_path, fragments, ranks):
    frames = []
    for k, n in enumerate((1, ranks)):
        folder = tmp_path / str(k)
        common = dict(data=fragments, style="mca friction 0.4", steps=400, every=400)
        lmp("in.fragments", folder, ranks=n, **common)
        frames.append(dump(folder / "state.dump")[-1][1])
    # the scales of test_parallel.py
    assert largest_difference(frames[1], frames[0], ["vx", "vy"], 5140) < 1e-12
    assert largest_difference(frames[1], frames[0], ["fx", "fy", "tqz"], E * D) < 1e-12
