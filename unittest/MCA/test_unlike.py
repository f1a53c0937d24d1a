# SPDX-License-Identifier: GPL-2.0-or-later
"""Unlike materials that meet: the critical step, and the energy account as its witness."""

import os

import numpy as np
import pytest

from lmp_run import fails, lmp

IMPACT = """
units nano
dimension 2
boundary p s p
atom_style sphere
timestep {dt}
lattice hex 2.5
region box block 0 40 -0.1 95 -0.5 0.5 units box
create_box 2 box
region a block INF INF INF 43 INF INF units box
region b block INF INF 43.1 INF INF INF units box
create_atoms 1 region a
create_atoms 2 region b
group a type 1
group b type 2
pair_style {style} plasticity none fracture none link none weld none heal none
{coeff}
neighbor 0.4 bin
mca_links create a a
mca_links create b b
velocity b set 0 -0.2 0 units box
fix i all nve/mca
compute en all mca/energy
thermo_style custom step c_en[*] c_en
thermo 100
run {steps}
"""
LIGHT = "youngs_modulus 30000 poissons_ratio 0.2 density 0.0024 viscosity 100"


def impact(dt, second, steps=400, hybrid=False):
    style = "hybrid/overlay zero 3 mca" if hybrid else "mca"
    mca = "mca " if hybrid else ""
    coeff = f"pair_coeff * * {mca}steel.mca\npair_coeff 2 2 {mca}steel.mca {second}\n"
    coeff += "pair_coeff * * zero\n" if hybrid else ""
    return IMPACT.format(dt=dt, style=style, coeff=coeff, steps=steps)


@pytest.mark.parametrize("hybrid", [False, True])
@pytest.mark.parametrize(
    "second", [LIGHT, "density 0.002 viscosity 0", "diameter 2.4 density 0.0027 viscosity 50"]
)
def test_the_pair_that_meets_has_the_say(tmp_path, second, hybrid):
    script = impact(5e-5, second, hybrid=hybrid)
    fails(script, tmp_path, "Timestep 5e-05 is longer", "where types 1 and 2 meet")


@pytest.mark.parametrize("second", [LIGHT, "density 0.002 viscosity 0"])
def test_energy_does_not_grow_below_the_limit(tmp_path, second):
    """At 99 % of the step that the refusal names."""
    line = fails(impact(5e-5, second), tmp_path / "refused", "critical one").error_lines[0]
    limit = float(line.split("critical one, ")[1].split()[0])
    table = lmp(impact(0.99 * limit, second), tmp_path).thermo[0]
    total = table["c_en[1]"] + table["c_en[2]"]
    assert (total <= total[0] * (1 + 1e-4)).all()
    assert (table["c_en[5]"] >= -1e-9 * total[0]).all()
    assert table["c_en[5]"][-1] > 0
    assert abs(table["c_en"][-1]) < 1e-3 * total[0]


# ---- a drill: random pairs of materials and steps; MCA_UNLIKE_COUNT makes it long

COUNT = int(os.environ.get("MCA_UNLIKE_COUNT", "6"))


def drawn(seed):
    """Words of a second material, the laws, whether both are linked, the part of the limit."""
    rng = np.random.default_rng(seed)
    words = {
        "youngs_modulus": 206000 * 10 ** rng.uniform(-1.5, 0.7),
        "poissons_ratio": rng.uniform(0.0, 0.45),
        "density": 0.0078 * 10 ** rng.uniform(-0.7, 0.7),
        "viscosity": rng.choice([0.0, 410 * 10 ** rng.uniform(-1.5, 0.5)]),
        "strength": 92 * 10 ** rng.uniform(-0.3, 1.3),
    }
    # the curve of steel yields at a strain of 0.015, which has to be beyond the elastic one
    words["strength"] = min(words["strength"], 0.01 * words["youngs_modulus"])
    laws = rng.choice(
        [
            "plasticity none fracture none link none weld none heal none",
            "plasticity none",
            "",
            "viscosity normal",
        ]
    )
    second = " ".join(f"{k} {v:.6g}" for k, v in words.items())
    return second, str(laws), bool(rng.random() < 0.5), rng.uniform(0.5, 0.99)


@pytest.mark.parametrize("seed", range(COUNT))
def test_random_pairs_make_no_energy(tmp_path, seed):
    """Above the limit that is named a step is refused; below it no energy comes from nothing."""
    second, laws, linked, part = drawn(seed)
    script = impact(1e-3, second, steps=0)
    script = script.replace("plasticity none fracture none link none weld none heal none", laws)
    script = script.replace("0 95 -0.5", "0 60 -0.5").replace(
        "velocity b set 0 -0.2", "velocity b set 0.5 -2"
    )
    if linked:
        script = script.replace("mca_links create b b", "mca_links create all all reach 1.05")
    line = fails(script, tmp_path / "refused", "critical one").error_lines[0]
    limit = float(line.split("critical one, ")[1].split()[0])
    fails(script.replace("timestep 0.001", f"timestep {1.01 * limit}"), tmp_path, "critical one")
    script = script.replace("timestep 0.001", f"timestep {part * limit}")
    result = lmp(script.replace("run 0", "run 1500"), tmp_path)
    table = result.thermo[0]
    total = table["c_en[1]"] + table["c_en[2]"]
    print(
        seed,
        second,
        laws,
        linked,
        f"{part:.2f}",
        total[-1] / total[0],
        table["c_en"][-1] / total[0],
    )
    assert (total <= total[0] * (1 + 2e-3)).all()
    assert np.abs(table["c_en"]).max() < 1e-3 * total[0]
    for k in (3, 4, 5):
        assert (np.diff(table[f"c_en[{k}]"]) >= -1e-3 * total[0]).all(), k
    assert "Compute mca/energy" not in result.out
