# SPDX-License-Identifier: GPL-2.0-or-later
"""Elastic constants, waves and conservation against closed forms; per-automaton and per-link output
against numbers that follow from a uniform strain."""

import numpy as np
import pytest

from lmp_run import dump, lmp, periodic_block

E, NU, RHO, D, H = 206000.0, 0.3, 0.0078, 2.5, 1.7
LAMBDA, G = E * NU / (1 + NU) / (1 - 2 * NU), E / 2 / (1 + NU)
K = E / 3 / (1 - 2 * NU)
STRAIN = 1e-7


def hooke(xx, yy, xy):
    """Plane strain: xx, yy, xy, zz and mean stress."""
    s = [LAMBDA * (xx + yy) + 2 * G * xx, LAMBDA * (xx + yy) + 2 * G * yy, 2 * G * xy]
    zz = NU * (s[0] + s[1])
    return np.array(s + [zz, (s[0] + s[1] + zz) / 3])


MIXED = (0.3, -0.7, 0.4)
STRAINS = [(1, 0, 0), (0, 1, 0), (1, 1, 0), (1, -1, 0), (0, 0, 1), MIXED]


@pytest.mark.parametrize(
    "ranks,xx,yy,xy",
    [
        *((1, *strain) for strain in STRAINS),
        (2, *MIXED),
        *(pytest.param(2, *strain, marks=pytest.mark.long) for strain in STRAINS[:-1]),
    ],
)
def test_periodic_block_is_hookes(tmp_path, xx, yy, xy, ranks):
    result = lmp(
        "in.homogeneous", tmp_path, ranks=ranks, exx=xx * STRAIN, eyy=yy * STRAIN, exy=xy * STRAIN
    )
    frame = dump(tmp_path / "state.dump")[-1][1]
    expected, size = hooke(xx * STRAIN, yy * STRAIN, xy * STRAIN), K * STRAIN
    names = [f"c_state[{k}]" for k in range(1, 6)]
    for name, value in zip(names, expected):
        assert np.abs(frame[name] - value).max() < 1e-6 * size, name
    # every automaton the same, also at the periodic faces
    for name in names:
        assert np.ptp(frame[name]) < 1e-6 * size, name
    # the virial of LAMMPS gives the same stress (thickness of the box is 1, of the discs H)
    last = {k: v[-1] for k, v in result.thermo[-1].items()}
    virial = [-last[f"c_virial[{k}]"] / H for k in (1, 2, 4)]
    assert np.allclose(virial, expected[:3], rtol=0, atol=2e-6 * size)
    density = 0.5 * (expected[0] * xx + expected[1] * yy + 2 * expected[2] * xy) * STRAIN
    assert last["PotEng"] == pytest.approx(density * last["Volume"] * H, rel=1e-5)


@pytest.mark.parametrize("thickness", [1.0, 2.5])
def test_thickness_is_in_the_pressures_of_lammps_only(tmp_path, thickness):
    more = (
        "pair_style mca plasticity none fracture none thickness {}\n"
        "pair_coeff * * steel.mca diameter 2.501\nneighbor 0.4 bin\nmca_links create all all\n"
        "variable vx atom 0.2*sin(2*PI*(x-xlo)/lx)\n"
        "velocity all set v_vx 0 0\nfix integrate all nve/mca\n"
        "compute state all mca/atom sxx\ncompute sum all reduce ave c_state\n"
        "compute virial all pressure NULL virial\n"
        "compute each all stress/atom NULL virial\ncompute all_of all reduce sum c_each[1]\n"
        "thermo_style custom step c_sum c_virial[1] c_all_of vol\n"
        "thermo_modify format float %.15g\nrun 200\n"
    )
    script = periodic_block()
    table = lmp(script + more.format(thickness), tmp_path).thermo[0]
    stress = table["c_sum"][-1]
    assert stress < -10
    assert -table["c_virial[1]"][-1] == pytest.approx(thickness * stress, rel=1e-3)
    assert table["c_all_of"][-1] / table["Volume"][-1] == pytest.approx(
        thickness * stress, rel=1e-3
    )


def test_moduli_of_a_periodic_block(tmp_path):
    """E/(1 - nu^2), nu/(1 - nu) and G from three measured stress states."""

    def stress(**strain):
        folder = tmp_path / "_".join(strain)
        lmp("in.homogeneous", folder, **{k: v * STRAIN for k, v in strain.items()})
        frame = dump(folder / "state.dump")[-1][1]
        return np.array([frame[f"c_state[{k}]"].mean() / STRAIN for k in (1, 2, 3)])

    x, y, shear = stress(exx=1), stress(eyy=1), stress(exy=0.5)
    stiffness = np.array([x[:2], y[:2]]).T
    compliance = np.linalg.inv(stiffness)
    assert 1 / compliance[0, 0] == pytest.approx(E / (1 - NU**2), rel=1e-6)
    assert -compliance[1, 0] / compliance[0, 0] == pytest.approx(NU / (1 - NU), rel=1e-6)
    assert shear[2] == pytest.approx(G, rel=1e-6)


def test_pairwise_law_has_youngs_modulus_but_no_poissons_ratio(tmp_path):
    lmp("in.homogeneous", tmp_path, exx=STRAIN, laws="elasticity pairwise".split()[1])
    frame = dump(tmp_path / "state.dump")[-1][1]
    assert frame["c_state[1]"].mean() / STRAIN == pytest.approx(2 * G, rel=1e-6)
    assert np.abs(frame["c_state[2]"]).max() < 1e-6 * G * STRAIN


def test_output_of_links_under_uniform_strain(tmp_path):
    lmp("in.homogeneous", tmp_path, exx=STRAIN, eyy=-0.5 * STRAIN, exy=0.2 * STRAIN)
    frame = dump(tmp_path / "state.dump")[-1][1]
    assert (frame["c_state[8]"] == 6).all() and (frame["c_state[9]"] == 0).all()
    assert (frame["c_state[7]"] == 0).all()
    xx, yy, xy, zz, mean = hooke(STRAIN, -0.5 * STRAIN, 0.2 * STRAIN)
    mises = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * xy**2)
    assert np.abs(frame["c_state[6]"] - mises).max() < 1e-6 * mises
    links = dump(tmp_path / "links.dump")[-1][1]
    atoms = len(frame["id"])
    assert len(links["c_link[1]"]) == 3 * atoms
    pairs = {tuple(sorted(p)) for p in zip(links["c_link[1]"], links["c_link[2]"])}
    assert len(pairs) == 3 * atoms  # each link once
    strains = {}
    for angle in np.radians([0, 60, 120]):
        n, t = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        eps = STRAIN * np.array([[1, 0.2], [0.2, -0.5]])
        strains[angle] = (n @ eps @ n, t @ eps @ n)
    for k in range(3 * atoms):
        e, gamma = links["c_link[4]"][k], links["c_link[6]"][k]
        assert any(
            abs(e - a) < 2e-6 * STRAIN and abs(gamma - b) < 2e-6 * STRAIN
            for a, b in strains.values()
        )
        sigma = 2 * G * e + (1 - 2 * G / 3 / K) * mean
        assert links["c_link[8]"][k] == pytest.approx(sigma, abs=1e-6 * K * STRAIN)
        assert links["c_link[9]"][k] == pytest.approx(2 * G * gamma, abs=1e-6 * K * STRAIN)
    assert (links["c_link[3]"] == 1).all() and (links["c_link[5]"] == 0).all()


@pytest.mark.parametrize("ranks", [1, 3])
def test_free_block_conserves(tmp_path, ranks):
    """Linear momentum to 1e-13, angular momentum to 1e-11, energy to the order of the step."""
    result = lmp("in.free_block", tmp_path, ranks=ranks)
    t = result.thermo[-1]
    speed = np.hypot(t["v_px"][0], t["v_py"][0])
    assert np.abs(t["v_px"] - t["v_px"][0]).max() < 1e-13 * speed
    assert np.abs(t["v_py"] - t["v_py"][0]).max() < 1e-13 * speed
    spin = t["v_spin"]
    assert np.abs(spin - spin[0]).max() < 1e-11 * np.abs(spin[0])
    total = t["PotEng"] + t["KinEng"] + t["v_turning"]
    assert t["PotEng"].max() > 0.05 * total[0]
    assert np.ptp(total) < 1e-3 * total[0]
    assert abs(total[-20:].mean() - total[:20].mean()) < 1e-5 * total[0]


def test_energy_error_is_of_second_order(tmp_path):
    spread = []
    for k, dt in enumerate((8e-5, 4e-5)):
        t = lmp("in.free_block", tmp_path / str(k), dt=dt, steps=round(0.08 / dt)).thermo[-1]
        total = t["PotEng"] + t["KinEng"] + t["v_turning"]
        spread.append(np.ptp(total))
    assert 3.0 < spread[0] / spread[1] < 5.0


@pytest.mark.parametrize("mode", ["l", "s"])
def test_wave_speed_of_a_long_bar(tmp_path, mode):
    """Standing wave of 64 automata in a periodic sheet: c_l = sqrt((K+4G/3)/rho), c_s =
    sqrt(G/rho)."""
    c = np.sqrt((LAMBDA + 2 * G if mode == "l" else G) / RHO)
    length = 64 * D
    period = length / c
    t = lmp("in.wave", tmp_path, mode=mode, time=2.2 * period).thermo[-1]
    amplitude, time = t["v_amplitude"], t["Step"] * 5e-5
    # from downward to downward zero crossing
    down = [k for k in range(len(time) - 1) if amplitude[k] > 0 >= amplitude[k + 1]]
    at = [
        time[k] + (time[k + 1] - time[k]) * amplitude[k] / (amplitude[k] - amplitude[k + 1])
        for k in down
    ]
    measured = length / np.diff(at).mean()
    assert measured == pytest.approx(c, rel=0.01)
