# SPDX-License-Identifier: GPL-2.0-or-later
"""Mechanical experiments in lmp whose outcome is known exactly, and what is expected of them.

test_mechanics.py runs them short; tools/plot_mechanics.py runs them long and draws the figures of
doc/howto_mechanics.md. Units nano: nm, ns, MPa. Steel of potentials/steel.mca, sigma_0 = 92 MPa.
"""

import numpy as np

from lmp_run import dump, lmp

E, NU, RHO, D = 206000.0, 0.3, 0.0078, 2.5
G, K = E / 2 / (1 + NU), E / 3 / (1 - 2 * NU)
LAME, WEIGHT = K - 2 * G / 3, 1 - 2 * G / (3 * K)
STRENGTH, Y1, Y2, BREAKING = 92.0, 0.554 * 92, 0.870 * 92, 0.04
ROW = D * np.sqrt(3) / 2
# modulus and Poisson's ratio of uniaxial tension in the plane
UNIAXIAL = {"strain": (E / (1 - NU**2), NU / (1 - NU)), "stress": (E, NU)}
ELASTIC = "plasticity none fracture none viscosity none link none heal none"

HEAD = """units nano
dimension 2
atom_style sphere
timestep {dt}
"""


# ---- elasticity


def bar(folder, rows, plane="strain", skin=1.0):
    """A sheet with free sides, stretched: stress and E of each row over the solid's, Poisson's
    ratio of the middle over the solid's. `skin` times stiffer are the outermost rows."""
    modulus, ratio = UNIAXIAL[plane]
    strain = 1e-6
    lmp(
        "in.bar",
        folder,
        rows=rows,
        plane=plane,
        exx=strain,
        eyy=-ratio * strain,
        c2=modulus / RHO,
        skin=skin,
    )
    frame = dump(folder / "state.dump")[-1][1]
    row = np.rint(frame["y"] / ROW).astype(int)

    def by_row(values):
        return np.array([values[row == k].mean() for k in range(rows)])

    sxx, syy, szz, mean = (by_row(frame[f"c_state[{k}]"]) / strain / modulus for k in (1, 2, 3, 4))
    height = np.arange(rows) * ROW
    middle = slice(rows // 2 - 2, rows // 2 + 2)
    contraction = -np.polyfit(height[middle], (by_row(frame["y"]) - height)[middle] / strain, 1)[0]
    return {
        "sxx": sxx,
        "syy": syy,
        "szz": szz,
        "mean": mean,
        "bar": sxx.mean(),
        "interior": sxx[middle].mean(),
        "poisson": contraction / ratio,
    }


def surface_row(plane):
    """A free close-packed row at the strain of the interior: 4 of 6 contacts. Over the values of
    the interior: sum of its sxx, its mean stress, its elastic energy."""
    ratio = UNIAXIAL[plane][1]
    weight = NU / (1 - 2 * NU) if plane == "strain" else NU / (1 - NU)  # lambda / 2G
    # sums over the contacts of e and of e^2 + gamma^2, over 3
    four, six = (2.5 - 1.5 * ratio) / 3, 1 - ratio
    energy = ((2.5 + 1.5 * ratio**2) / 3 + weight * four**2) / (
        1 + ratio**2 + weight * six**2
    )
    return 5 / 6, four / six, energy


def lattice(packing):
    """Places in one period of a packing in space with d = 1, and the edges of the period."""
    edges = {"fcc": [np.sqrt(2)] * 3, "hcp": [1, np.sqrt(3), np.sqrt(8 / 3)], "sc": [1, 1, 1]}[
        packing
    ]
    basis = {
        "fcc": [(0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)],
        "sc": [(0, 0, 0)],
        "hcp": [(0, 0, 0), (0.5, 0.5, 0), (0.5, 5 / 6, 0.5), (0, 1 / 3, 0.5)],
    }[packing]
    return np.array(basis) * edges, np.array(edges)


def surface_energies(packing, cells=4):
    """{number of contacts: elastic energy over that of the interior} of the automata of a bar along
    x, free in y and z, at the uniaxial strain of its interior."""
    basis, edges = lattice(packing)
    grid = np.array([(i, j, k) for i in (-1, 0, 1) for j in range(cells) for k in range(cells)])
    places = (grid[:, None, :] * edges + basis).reshape(-1, 3)
    strain, weight = np.array([1, -NU, -NU]), 1 / 2 if packing == "sc" else 1 / 4
    found = {}
    for place in places[np.repeat(grid[:, 0] == 0, len(basis))]:
        n = places - place
        n = n[np.abs((n**2).sum(axis=1) - 1) < 0.1]
        e, moved = (
            (n * n * strain).sum(axis=1),
            ((n * strain) ** 2).sum(axis=1),
        )  # moved: e^2 + gamma^2
        energy = (weight * moved.sum() + NU / (1 - 2 * NU) * (weight * e.sum()) ** 2) / (1 + NU)
        assert abs(found.setdefault(len(n), energy) - energy) < 1e-12
    return found


def stiffer_surface(packing):
    """Commands for in.space_bar: automata of the surface are stiffer by the inverse of that."""
    inner = 6 if packing == "sc" else 12
    text = "compute contacts all mca/atom links\nrun 0\n"
    for k, (contacts, energy) in enumerate(sorted(surface_energies(packing).items())):
        if contacts != inner:
            text += (
                f"variable at{contacts} atom c_contacts=={contacts}\n"
                f"group at{contacts} variable at{contacts}\n"
                f"set group at{contacts} type {k + 2}\n"
                f"pair_coeff {k + 2} {k + 2} steel.mca youngs_modulus {E / energy!r}\n"
            )
    return text


def lattice_speed(mode, wavelength):
    """Phase speed of a plane wave along a close-packed row of the infinite lattice, from its
    dynamical matrix (longitudinal, or transverse with the rotation)."""
    q = 2 * np.pi / wavelength  # over d
    angles = np.radians(np.arange(0, 360, 60))
    energy, sums = np.zeros((3, 3), complex), np.zeros(3, complex)
    for nx, ny in zip(np.cos(angles), np.sin(angles)):
        phase = np.exp(1j * q * nx)
        normal = np.array([nx * (phase - 1), ny * (phase - 1), 0])
        shear = np.array([-ny * (phase - 1), nx * (phase - 1), -0.5 * (1 + phase)])
        energy += G / 3 * (np.outer(normal.conj(), normal) + np.outer(shear.conj(), shear))
        sums += normal
    energy += LAME / 2 / 9 * np.outer(sums.conj(), sums)
    mass = np.array([1, 1, 1 / 8]) * RHO * D**2  # over the cell's volume, displacements over d
    values, vectors = np.linalg.eigh(2 * energy / np.sqrt(np.outer(mass, mass)))
    longitudinal = np.argmax(np.abs(vectors[0]))
    pick = (
        longitudinal
        if mode == "l"
        else min(set(range(3)) - {longitudinal}, key=lambda k: values[k])
    )
    return np.sqrt(values[pick]) / (q / D)


def wave_speed(folder, mode, columns=64, rows=4, free=False):
    """Phase speed of a standing wave whose length is `columns` automata."""
    length = columns * D
    c = np.sqrt({"l": LAME + 2 * G, "s": G, "bar": UNIAXIAL["strain"][0]}[mode] / RHO)
    t = lmp(
        "in.wave",
        folder,
        mode="s" if mode == "s" else "l",
        columns=columns,
        rows=rows,
        free="s" if free else "p",
        dt=2e-4 if free else 5e-5,
        time=2.2 * length / c,
    ).thermo[-1]
    amplitude, time = t["v_amplitude"], t["Time"]
    down = [k for k in range(len(time) - 1) if amplitude[k] > 0 >= amplitude[k + 1]]
    at = [
        time[k] + (time[k + 1] - time[k]) * amplitude[k] / (amplitude[k] - amplitude[k + 1])
        for k in down
    ]
    return length / np.diff(at).mean(), c


# ---- rigid motion


def turned(folder, block, degrees, steps):
    """Largest change of any stress of a sheared sample, over the largest stress, while it is turned
    rigidly; all automata move on straight chords, as they do in every step."""
    angle = np.radians(degrees) / steps
    atoms = (
        "region body block -14 14 -12 12 -0.5 0.5 units box\ncreate_atoms 1 region body"
        if block
        else f"create_atoms 1 single 0 0 0 units box\ncreate_atoms 1 single {D} 0 0 units box"
    )
    lmp(
        HEAD.format(dt=1e-4)
        + f"""boundary f f p
lattice hex {D}
region box block -60 60 -60 60 -0.5 0.5 units box
create_box 1 box
{atoms}
pair_style mca {ELASTIC}
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
fix integrate all nve/mca
fix hold all freeze
# strain and shear in one step
variable sx atom (1e-3*x+2e-3*y)/dt
variable sy atom -0.5e-3*y/dt+1e-3*x/dt
velocity all set v_sx v_sy NULL
compute state all mca/atom sxx syy sxy mean
compute link all mca/link/local id1 id2 sigma tau
run 1
dump state all custom {steps} state.dump id c_state[*]
dump_modify state format float %.17g sort id
dump link all local {steps} link.dump index c_link[*]
dump_modify link format float %.17g
reset_timestep 0
# chords of a rotation about the origin
variable cx atom ((cos({angle!r})-1)*x-sin({angle!r})*y)/dt
variable cy atom (sin({angle!r})*x+(cos({angle!r})-1)*y)/dt
variable turn atom {angle!r}/dt
velocity all set v_cx v_cy NULL
set group all omega 0 0 v_turn
run {steps} every 1 "velocity all set v_cx v_cy NULL" "set group all omega 0 0 v_turn"
""",
        folder,
    )
    frames, links = dump(folder / "state.dump"), dump(folder / "link.dump")
    xx, yy, xy, mean = (frames[0][1][f"c_state[{k}]"] for k in range(1, 5))
    a = np.radians(degrees)
    c, s = np.cos(a), np.sin(a)
    expected = (
        c * c * xx + s * s * yy - 2 * c * s * xy,
        s * s * xx + c * c * yy + 2 * c * s * xy,
        c * s * (xx - yy) + (c * c - s * s) * xy,
        mean,
    )
    size = max(np.abs(v).max() for v in (xx, yy, xy))
    worst = max(np.abs(frames[-1][1][f"c_state[{k + 1}]"] - expected[k]).max() for k in range(4))

    def key(f):
        return {
            (int(min(i, j)), int(max(i, j))): (p, q)
            for i, j, p, q in zip(*(f[1][f"c_link[{k}]"] for k in range(1, 5)))
        }

    before, after = key(links[0]), key(links[-1])
    assert before.keys() == after.keys() and len(before) > 0
    worst = max([worst] + [abs(after[k][m] - before[k][m]) for k in before for m in (0, 1)])
    assert max(abs(v[1]) for v in before.values()) > 0.1 * size  # it is sheared
    return worst / size


# ---- stress-strain diagrams of a homogeneous block


def lattice_strain(exx, eyy, shear):
    """xx, yy, xy of the strain that the contacts of a homogeneously deformed lattice feel: e of
    each, and the rotation of its axis beside the mean one. Differs from the deformation by
    squares."""
    angles = np.radians(np.arange(0, 360, 60))
    x, y = np.cos(angles), np.sin(angles)
    rx, ry = (1 + exx) * x + shear * y, (1 + eyy) * y
    r = np.hypot(rx, ry)
    nx, ny, e = rx / r, ry / r, r - 1
    gamma = np.arcsin((x * ry - y * rx) / r) - mean_turn(exx, eyy, shear)
    return (
        np.array(
            [
                (e * nx * nx - gamma * nx * ny).sum(),
                (e * ny * ny + gamma * nx * ny).sum(),
                (e * nx * ny + gamma * (nx * nx - ny * ny) / 2).sum(),
            ]
        )
        / 3
    )


def mean_turn(exx, eyy, shear):
    """Mean rotation of the axes of all contacts: that of automata without a torque."""
    angles = np.radians(np.arange(0, 360, 60))
    x, y = np.cos(angles), np.sin(angles)
    rx, ry = (1 + exx) * x + shear * y, (1 + eyy) * y
    return np.arctan2(x * ry - y * rx, x * rx + y * ry).mean()


class MaterialPoint:
    """Plane strain along a strain path, small implicit steps: J2 flow with isotropic hardening in
    the plane alone, which keeps the area, or what plasticity radial does instead. The curve's
    strains are those of the steel times `scale`."""

    def __init__(self, preserving=True, scale=1.0):
        self.preserving, self.scale, self.kappa = preserving, scale, 0.0
        self.flow, self.stress = np.zeros(4), np.zeros(4)  # xx, yy, zz, xy

    def yield_stress(self, kappa):
        return np.interp(
            kappa,
            [0, 0.015 * self.scale - Y2 / E, BREAKING * self.scale - STRENGTH / E],
            [Y1, Y2, STRENGTH],
        )

    def strain(self, xx, yy, xy):
        e = np.array([xx, yy, 0, xy]) - self.flow
        mean = K * e[:3].sum()
        s = 2 * G * (e - np.array([1, 1, 1, 0]) * e[:3].sum() / 3)
        if self.preserving:
            mean, s = (
                mean + (s[0] + s[1]) / 2,
                np.array([s[0] - s[1], s[1] - s[0], 0, 2 * s[3]]) / 2,
            )
        q = np.sqrt(1.5 * (s[:3] @ s[:3] + 2 * s[3] ** 2))
        lower, upper = 0.0, q / (3 * G) if q > self.yield_stress(self.kappa) else 0.0
        while upper - lower > 1e-13:
            d = (lower + upper) / 2
            lower, upper = (
                (d, upper) if q - 3 * G * d > self.yield_stress(self.kappa + d) else (lower, d)
            )
        flow = 1.5 * upper * s / q if q > 0 else 0 * s
        flow[2] = 0.0
        self.flow = self.flow + flow
        self.kappa += upper
        self.stress = s * (1 - 3 * G * upper / q if q > 0 else 1) + mean * np.array([1, 1, 1, 0])
        if self.preserving:
            self.stress[2] = (K - 2 * G / 3) * (xx + yy)  # nothing flows across the plane
        return self.stress


def tension_path(stretches, preserving=True, scale=1.0):
    """exx, eyy of tension along x in plane strain with a free side: syy = 0 of a material point
    that feels the strain of the lattice."""
    point, path, eyy, last = MaterialPoint(preserving, scale), [], 0.0, 0.0
    for exx in stretches:

        def syy(side, exx=exx):
            trial = MaterialPoint(preserving, scale)
            trial.kappa, trial.flow = point.kappa, point.flow
            return trial.strain(*lattice_strain(exx, side, 0))[1]

        # secant: syy rises with eyy
        a, b = eyy, eyy - 0.5 * (exx - last)
        fa, fb = syy(a), syy(b)
        while abs(fb) > 1e-6 * Y1 and fa != fb:
            a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
            fb = syy(b)
        eyy, last = b, exx
        point.strain(*lattice_strain(exx, eyy, 0))
        path.append((exx, eyy))
    return path


def strained(folder, segments, laws="", every=20, file="steel.mca"):
    """A block whose automata are moved homogeneously: segments of (exx, eyy, angle of shear, steps)
    of final strains from the first state. Returns columns of the strains and of what its middle
    feels: stresses after the return, mean stress, plastic strain, plastic work; and the events."""
    columns, rows = 24, 26
    text = (
        HEAD.format(dt=5e-5)
        + f"""boundary f f p
lattice hex {D}
region box block -6 {columns * D + 10} -6 {rows * ROW + 6} -0.5 0.5 units box
create_box 1 box
region body block -0.1 {columns * D - 0.6} -0.1 {rows * ROW - 0.1} -0.5 0.5 units box
create_atoms 1 region body
pair_style mca viscosity none {laws}
pair_coeff * * {file}
neighbor 0.4 bin
neigh_modify every 1 delay 0 check yes
mca_links create all all
fix integrate all nve/mca
fix hold all freeze
region middle block {(columns / 2 - 2) * D} {(columns / 2 + 2) * D} &
  {(rows / 2 - 2) * ROW} {(rows / 2 + 2) * ROW} -0.5 0.5 units box
group middle region middle
compute state all mca/atom sxx syy szz sxy mean intensity plastic plastic_work
compute mean middle reduce ave c_state[*]
compute works all reduce sum c_state[8]
compute totals all pair mca
fix events all mca/events {every} step id1 id2 before after
dump events all local {every} events.dump index f_events[*]
thermo {every}
thermo_style custom step c_mean[*] c_totals[*] c_works
thermo_modify format float %.17g
"""
    )
    last, strains = np.zeros(3), []
    for exx, eyy, shear, steps in segments:
        now = np.array([exx, eyy, shear])
        rate, turn = (
            (now - last) / (steps * 5e-5),
            (mean_turn(*now) - mean_turn(*last)) / (steps * 5e-5),
        )
        text += f"""variable fy atom y/{1 + last[1]!r}
variable fx atom (x-{last[2]!r}*v_fy)/{1 + last[0]!r}
variable vx atom {rate[0]!r}*v_fx+{rate[2]!r}*v_fy
variable vy atom {rate[1]!r}*v_fy
variable turn atom {turn!r}
velocity all set v_vx v_vy NULL
set group all omega 0 0 v_turn
run {steps}
"""
        strains.append(last + np.outer(np.arange(0, steps + 1, every) / steps, now - last))
        last = now
    result = lmp(text, folder)
    joined = {
        name: np.concatenate(
            [t[name] if k == 0 else t[name][1:] for k, t in enumerate(result.thermo)]
        )
        for name in result.thermo[0]
    }
    strains = np.concatenate([t if k == 0 else t[1:] for k, t in enumerate(strains)])
    out = dict(zip(("exx", "eyy", "shear"), strains.T))
    out.update(
        step=joined["Step"],
        mean=joined["c_mean[5]"],
        kappa=joined["c_mean[7]"],
        work=joined["c_mean[8]"],
        links=joined["c_totals[1]"],
        broken=joined["c_totals[3]"],
        total_work=joined["c_totals[6]"],
        sum_work=joined["c_works"],
    )
    # the compute gives the stresses before the return, which takes 3G dkappa off the intensity
    flow = np.concatenate([[0], np.diff(out["kappa"]) / np.maximum(np.diff(out["step"]), 1)])
    factor = 1 - 3 * G * flow / np.maximum(joined["c_mean[6]"], 1e-300)
    for k, name in enumerate(("sxx", "syy", "szz", "sxy"), 1):
        mean = 0 if name == "sxy" else out["mean"]
        out[name] = mean + factor * (joined[f"c_mean[{k}]"] - mean)
    out["equivalent"] = factor * joined["c_mean[6]"]
    out["events"] = [
        tuple(int(f[f"f_events[{k}]"][m]) for k in range(1, 6))
        for _, f in dump(folder / "events.dump")
        for m in range(len(f["index"]))
    ]
    return out


def point_along(r, preserving=True, scale=1.0, between=5):
    """Stresses xx, yy, zz, xy and kappa of a material point along the strains of a run."""
    point, out, last = MaterialPoint(preserving, scale), [], np.zeros(3)
    for now in np.array([r["exx"], r["eyy"], r["shear"]]).T:
        for t in np.linspace(0, 1, between + 1)[1:]:
            point.strain(*lattice_strain(*(last + t * (now - last))))
        last = now
        out.append([*point.stress, point.kappa])
    return np.array(out)


def measured_diagram(r):
    """Equivalent strain and stress of a run, from its strains and stresses alone: the integral of
    the equivalent plastic strain rate, with the plastic strain left when Hooke's law is taken off,
    and sigma_eq/E as in a tension test."""
    strain = np.array([lattice_strain(*v) for v in zip(r["exx"], r["eyy"], r["shear"])])
    mean = (r["sxx"] + r["syy"] + r["szz"]) / 3

    def elastic(s):
        return (s - mean) / (2 * G) + mean / (3 * K)

    flow = np.array(
        [
            strain[:, 0] - elastic(r["sxx"]),
            strain[:, 1] - elastic(r["syy"]),
            -elastic(r["szz"]),
            strain[:, 2] - r["sxy"] / (2 * G),
        ]
    )
    d = np.diff(flow, axis=1)
    rate = np.sqrt(2 / 3 * (d[0] ** 2 + d[1] ** 2 + d[2] ** 2 + 2 * d[3] ** 2))
    return np.concatenate([[0], rate.cumsum()]) + r["equivalent"] / E, r["equivalent"]


def diagram(folder, kind, laws, scale=1.0, reverse=False, steps=4000, every=5):
    """The block's diagram up to the breaking strain, in tension with a free side or in shear; with
    `reverse` it is unloaded and loaded the other way from 0.6 times that on. The beginning, where
    it is elastic, is done in a tenth of the steps."""
    file = f"steel.mca yield_strain {0.015 * scale!r} breaking_strain {BREAKING * scale!r}"
    factor = np.sqrt(3) if kind == "shear" else 1
    early, end = 2 * Y1 / E, 1.02 * BREAKING * scale
    strains = [*np.linspace(0, early, 11)[1:], *np.linspace(early, end, 91)[1:]]
    if reverse:
        strains = [e for e in strains if e < 0.6 * end]
        strains += list(
            np.linspace(strains[-1], strains[-1] - (1e-3 if scale < 1 else 2e-3), 21)[1:]
        )
    strains = [factor * e for e in strains]
    if kind == "shear":
        path = [(0.0, 0.0, e, steps // 100) for e in strains]
    else:
        path = [(*p, 0.0, steps // 100) for p in tension_path(strains, "isochoric" in laws, scale)]
    return strained(folder, path, laws, every, file)


# ---- Hertz


def hertz(folder, size, depth=10, radius=2000):
    """A rigid cylinder pressed into a block so that the half-width of the contact is about `size`
    automata; the block is 2 `depth` half-widths wide, `depth` deep, rests on a rigid floor, and the
    radius is `radius` * size/10. Returns the pressures of the surface's automata, load per
    thickness, half-width (twice the root mean square of x under these pressures, as of an ellipse),
    largest pressure (of a straight line through p^2 against x^2), and Hertz's values for that
    load."""
    a = size * D
    rounded = radius * a / 10
    columns, rows = 2 * depth * size, round(depth * a / ROW)
    stiffness = 6e10 / size**2  # the surface gives way to it by 2 % of the approach
    result = lmp(
        "in.hertz",
        folder,
        columns=columns,
        rows=rows,
        radius=rounded,
        approach=a * a / rounded,
        stiffness=stiffness,
        dt=1e-4 if size < 8 else 1.5e-4,
    )
    t = result.thermo[-1]
    top = dump(folder / "top.dump")[-1][1]
    inside = rounded - np.hypot(top["x"] - columns * D / 2, top["y"] - t["v_centre"][-1])
    pressure = np.where(inside > 0, stiffness * inside**2, 0.0) / D
    x = top["x"] - columns * D / 2
    touching = pressure > 0
    p0squared = np.polyfit(x[touching] ** 2, pressure[touching] ** 2, 1)[1]
    load = pressure.sum() * D
    modulus = E / (1 - NU**2)
    return {
        "x": x,
        "pressure": pressure,
        "load": load,
        "half_width": 2 * np.sqrt((pressure * x * x).sum() / pressure.sum()),
        "p0": np.sqrt(p0squared),
        "hertz": np.sqrt(4 * load * rounded / (np.pi * modulus)),
        "hertz_p0": np.sqrt(load * modulus / (np.pi * rounded)),
    }


# ---- two automata that meet and part


class PairModel:
    """Kind of one pair, by the table of links in doc/laws.md; elastic, both automata without other
    contacts. Presets a and b, and the criteria of local stress."""

    def __init__(self, linked, preset="b", fracture="strain", ratio=1.0, healed=np.inf):
        self.kind, self.preset, self.fracture, self.ratio = int(linked), preset, fracture, ratio
        self.healed = healed  # strain at which what has healed breaks
        self.gamma = 0.0

    def _coulomb(self, sigma, tau, s):
        """a sigma_1 - sigma_3 of the local tensor."""
        tensor = np.diag(s)
        tensor[0, 1] = tensor[1, 0] = tau
        low, _, high = np.linalg.eigvalsh(tensor)
        return self.ratio * high - low

    def step(self, r, turn):
        """Distance and further rotation of the axis; returns the next kind."""
        e = r / D - 1
        self.gamma = self.gamma + turn if self.kind > 0 else 0.0
        touches = self.kind > 0 or e < -1e-9
        mean = K * e / 3 if touches else 0.0
        sigma, tau = (2 * G * e + WEIGHT * mean if touches else 0.0), 2 * G * self.gamma
        intensity = np.sqrt(max(sigma, 0) ** 2 + 3 * tau**2)
        # averaged: sigma/3 along the axis, nothing along the face
        s = np.array([sigma, 0, 3 * mean - sigma / 3])
        m = s.mean()
        equivalent = np.sqrt(1.5 * ((s - m) @ (s - m)) + 3 * tau**2)
        a = self.ratio
        breaks = {
            "strain": max(e, 0) ** 2 + 4 / 3 * self.gamma**2 >= BREAKING**2,
            "stress": intensity >= STRENGTH,
            "equivalent": equivalent >= STRENGTH,
            "mohr-coulomb": self._coulomb(sigma, tau, s) >= a * STRENGTH,
            "drucker-prager": (a + 1) / 2 * equivalent + 1.5 * (a - 1) * m >= a * STRENGTH,
            "none": False,
        }[self.fracture]
        strained = np.sqrt(max(e, 0) ** 2 + 4 / 3 * self.gamma**2) >= self.healed
        heals = -sigma >= 3 * Y2 and not breaks and not strained
        whole = 1 if self.healed == np.inf else 3
        if self.kind in (1, 3):
            after = -1 if breaks or (self.kind == 3 and strained) else self.kind
        elif self.kind == 2:
            after = -1 if intensity >= STRENGTH else whole if heals else 2
        elif self.preset == "a":
            after = (
                self.kind
                if self.kind < 0 and -sigma >= 2.35 * STRENGTH
                else int(-sigma >= 2.35 * STRENGTH)
            )
        elif self.kind == -1:
            after = whole if heals else -1 if -sigma >= Y1 else 0
        else:
            after = 2 if -sigma >= Y1 else 0
        before, self.kind = self.kind, after
        return before, after


def pair_events(folder, cases, laws, phases_steps, model):
    """Pairs of automata that move as prescribed. A case is (linked, first distance over d, [(speed
    of the second along the axis, across it) of each phase]). Returns the events of lmp and of the
    model: sets of (case, step, before, after)."""
    dt = 1e-5
    text = (
        HEAD.format(dt=dt)
        + f"""boundary s s p
region box block -10 30 -10 {20 * len(cases)} -0.5 0.5 units box
create_box 1 box
pair_style mca cutoff 3.5 preset b viscosity none plasticity none {laws}
pair_coeff * * steel.mca
neighbor 0.4 bin
neigh_modify every 1 delay 0 check yes
"""
    )
    for k, (linked, first, _) in enumerate(cases):
        text += f"create_atoms 1 single 0 {20 * k} 0 units box\n"
        text += f"create_atoms 1 single {first * D!r} {20 * k} 0 units box\n"
        if linked:
            text += f"group linked id {2 * k + 1} {2 * k + 2}\n"
    text += "".join(f"group second id {2 * k + 2}\n" for k in range(len(cases)))
    if any(c[0] for c in cases):
        text += "mca_links create linked linked\n"
    total = sum(phases_steps)
    text += f"""fix integrate all nve/mca
fix hold all freeze
fix events all mca/events {total + 1} step id1 id2 before after
dump events all local {total + 1} events.dump index f_events[*]
"""
    for phase, steps in enumerate(phases_steps):
        for k, (_, _, phases) in enumerate(cases):
            vx, vy = phases[phase]
            text += (
                f"group one id {2 * k + 2}\nvelocity one set {vx!r} {vy!r} 0 units box\n"
                "group one delete\n"
            )
        text += f"run {steps}\n"
    text += "run 1\n"
    lmp(text, folder)
    frame = dump(folder / "events.dump")[-1][1]
    found = {
        ((int(min(i, j)) - 1) // 2, int(step), int(b), int(a))
        for step, i, j, b, a in zip(*(frame[f"f_events[{k}]"] for k in range(1, 6)))
    }
    expected = set()
    for k, (linked, first, phases) in enumerate(cases):
        pair, step, x, y = model(linked), 0, first * D, 0.0
        pair.step(x, 0.0)
        for (vx, vy), steps in zip(phases, phases_steps):
            for _ in range(steps):
                angle = np.arctan2(y, x)
                x, y, step = x + vx * dt, y + vy * dt, step + 1
                before, after = pair.step(np.hypot(x, y), np.arctan2(y, x) - angle)
                if before != after and (before > 0 or after > 0):
                    expected.add((k, step, before, after))
    return found, expected
