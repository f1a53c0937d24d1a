# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/campaign: plans with a material of their own, of two blocks and at temperatures."""

import re

import pytest

from campaign_calls import HEAD, ROOT, campaign, one_line
from campaign_parts import plan as plans, size

ALUMINIUM = (ROOT / "examples" / "campaign" / "aluminium.mca").read_text()
SI = """# UNITS: si
youngs_modulus 70e9
poissons_ratio 0.33
density 2700
strength 300e6
elastic_limit 0.7
yield_strength 0.9
yield_strain 0.02
breaking_strain 0.1
viscosity 0.41
diameter 2.5e-9
"""


def test_own_material(tmp_path):
    """From a file in any of its units; defaults, file and run each go before the one before."""
    runs = plans.read(plans.find("own-material")).runs
    known = {"E": 70000, "nu": 0.33, "rho": 2700, "strength": 300, "elastic_limit": 0.7}
    known |= {"yield_strength": 0.9, "yield_strain": 0.02, "breaking_strain": 0.1, "eta": 0.41}
    for run in runs:
        assert {name: run.values[name] for name in known} == known and run.values["d"] == 2.5
    (tmp_path / "si.mca").write_text(SI)
    path = tmp_path / "plan.yaml"
    path.write_text(
        HEAD + "defaults: {material: si.mca, nu: 0.2}\n"
        "runs: [{strength: [200, 300]}, {material: [steel.mca, si.mca], v: 7}, {E: 60000}]\n"
    )
    found = {run.name: run.values for run in plans.read(str(path)).runs}
    assert list(found)[:4] == ["strength200", "strength300", "steel", "si"]
    assert found["strength300"] == {**found["strength300"], **known, "nu": 0.2}
    assert found["strength200"]["strength"] == 200 and found["strength200"]["rho"] == 2700
    assert found["steel"]["E"] == 206000 and found["steel"]["nu"] == 0.3
    variables = plans.read(str(path)).runs[0].variables()
    assert variables["rho"] == "0.0027" and variables["eta"] == "410" and variables["d"] == "2.5"
    assert variables["breaking_strain"] == "0.1"


def test_upper_material(tmp_path):
    """All its quantities but the diameter are the upper block's; kappas are of the weaker one, the
    step is that of the worst contact that both could have."""
    (tmp_path / "si.mca").write_text(SI)
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{strength: [92, 400], upper_material: si.mca}, {v: 7}]\n")
    weak, strong, plain = plans.read(str(path)).runs
    upper = weak.variables()["upper_values"].split()
    words = dict(zip(upper[::2], map(float, upper[1::2])))
    assert words["youngs_modulus"] == 70000 and words["density"] == 0.0027
    assert words["viscosity"] == 410 and words["strength"] == 300 and "diameter" not in words
    assert weak.values["E"] == 206000 and weak.kappa2 == pytest.approx(15 * 206000 / 92**2)
    assert strong.kappa2 == pytest.approx(15 * 70000 / 300**2)
    assert strong.kappa1 == pytest.approx(2700 * 70e9 * 25 / 300e6**2)
    # viscous: density of the one, viscosity of both
    assert weak.dt < plain.dt and weak.dt == pytest.approx(plain.dt * 2700 / 7800, rel=0.1)
    assert "upper_values" not in plain.variables() and plain.values["upper"] is None


def test_size_follows_the_weaker_block(tmp_path):
    """Junctions form at the weaker strength and elastic limit, whichever block has it."""
    for name, strength, limit in (("weak", 60, 0.3), ("strong", 600, 0.7)):
        text = re.sub(r"(?m)^(strength) .*$", rf"\1 {strength}", ALUMINIUM)
        text = re.sub(r"(?m)^(elastic_limit) .*$", rf"\1 {limit}", text)
        (tmp_path / f"{name}.mca").write_text(text)
    path = tmp_path / "plan.yaml"
    pairs = ["material: weak.mca, upper_material: strong.mca"]
    pairs.append("material: strong.mca, upper_material: weak.mca")
    runs = "".join(
        f"  - {{{pair}, laws: {laws}}}\n" for laws in ("d", "d link 2") for pair in pairs
    )
    path.write_text(HEAD + "defaults: {p: 8}\nruns:\n" + runs)
    found = plans.read(str(path)).runs
    assert [run.values["columns"] for run in found] == [80, 80, 160, 160]
    pressures = [size.link_pressure(run.values) for run in found]
    assert pressures == pytest.approx([18, 18, 120, 120])


@pytest.mark.parametrize(
    "text, run, part",
    [
        (SI, "upper_material: none.mca", "material: no file none.mca"),
        (SI, "upper_material: own.mca, temperature: 300", "has none, the plan says 300"),
        (SI.replace("youngs_modulus 70e9", "youngs_modulus 1e6"), "upper_material: own.mca", "< E"),
    ],
)
def test_bad_upper_material(text, run, part, tmp_path):
    (tmp_path / "own.mca").write_text(text)
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{" + run + "}]\n")
    one_line(campaign("list", path), 3, part)


def test_an_input_script_without_the_upper_block(tmp_path):
    """LAMMPS takes a variable that a script does not read without a word; the plan does not."""
    (tmp_path / "in.own").write_text("variable p index 1\n")
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "input: in.own\nruns: [{upper_material: steel.mca}]\n")
    one_line(
        campaign("list", path), 3, "upper_material: the input script", "no variable upper_values"
    )


SOFTENING = SI.replace("strength 300e6", "strength 300e6 200e6 100e6").replace(
    "youngs_modulus", "temperature 300 600 900\nyoungs_modulus"
)


def test_material_at_temperatures(tmp_path):
    """Linear between those of the file; a run's temperature goes before what the defaults state."""
    (tmp_path / "soft.mca").write_text(SOFTENING)
    path = tmp_path / "plan.yaml"
    path.write_text(
        HEAD + "defaults: {material: soft.mca, temperature: 600, nu: 0.2}\n"
        "runs: [{v: 7}, {temperature: [300, 450, 900]}, {temperature: 900, strength: 50}]\n"
    )
    runs = plans.read(str(path)).runs
    strengths = [(run.values["temperature"], run.values["strength"]) for run in runs]
    assert strengths == [(600, 200), (300, 300), (450, 250), (900, 100), (900, 50)]
    assert [run.values["nu"] for run in runs] == [0.2, 0.33, 0.33, 0.33, 0.33]
    assert runs[2].name == "temperature450" and runs[2].values["rho"] == 2700
    assert runs[2].variables()["strength"] == "250" and "temperature" not in runs[2].variables()


@pytest.mark.parametrize(
    "text, run, part",
    [
        (SOFTENING, "v: 7", "temperature is missing, allowed for soft.mca: 300 to 900"),
        (
            SOFTENING,
            "temperature: 299",
            "temperature: '299' is not allowed, allowed for soft.mca: 300 to 900",
        ),
        (SI, "temperature: 300", "temperature: soft.mca has none, the plan says 300"),
        (
            SOFTENING.replace(" 600", ""),
            "temperature: 300",
            "strength has 3 values, allowed: 1 or 2",
        ),
        (SOFTENING.replace("600", "300"), "temperature: 300", "temperature 300 stands after 300"),
        (SOFTENING.replace("600 900", ""), "temperature: 300", ":2: temperature has one value"),
        (
            SOFTENING,
            "temperature: cold",
            "temperature: 'cold' is not allowed, must be a number > 0",
        ),
    ],
)
def test_bad_temperatures(text, run, part, tmp_path):
    (tmp_path / "soft.mca").write_text(text)
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "defaults: {material: soft.mca}\nruns: [{" + run + "}]\n")
    one_line(campaign("list", path), 3, part)


def test_rail_steel_is_the_same_for_plan_and_plugin():
    """potentials/rail_steel.mca at its temperatures: the factors of EN 1993-1-2."""
    found = [
        plans.material.read(str(ROOT / "potentials/rail_steel.mca"), t) for t in (293, 773, 1073)
    ]
    assert found[0]["strength"] == 900 and found[0]["E"] == 206000
    assert found[1]["E"] == pytest.approx(0.6 * 206000)
    assert found[1]["strength"] * found[1]["yield_strength"] == pytest.approx(0.78 * 720)
    assert found[1]["strength"] * found[1]["elastic_limit"] == pytest.approx(0.36 * 720, rel=1e-4)
    assert found[2]["E"] == pytest.approx(0.09 * 206000)
    assert found[2]["strength"] * found[2]["yield_strength"] == pytest.approx(0.11 * 720)
    assert found[2]["strength"] * found[2]["elastic_limit"] == pytest.approx(0.05 * 720, rel=1e-4)


def test_steel_is_the_default(tmp_path):
    """What a plan takes without a material is what potentials/steel.mca says."""
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{name: a}, {name: b, material: steel.mca}]\n")
    first, second = plans.read(str(path)).runs
    assert first.values == second.values and first.dt == second.dt == 4e-5


@pytest.mark.parametrize(
    "text, part",
    [
        (None, ":2: material: no file own.mca beside the plan"),
        ("", "own.mca:1: 'UNITS: STYLE'"),
        ("# UNITS: lj\n", "own.mca:1: 'UNITS: STYLE' with nano"),
        ("# UNITS:\n", "own.mca:1:"),
        ("# UNITS: nano\n", "own.mca: youngs_modulus is missing"),
        (ALUMINIUM.replace("density", "densty"), "own.mca:6: unknown keyword 'densty'"),
        (ALUMINIUM.replace("300 ", "nan "), "own.mca:7: strength: 'nan' is not allowed"),
        (ALUMINIUM.replace("300 ", "0x10 "), "own.mca:7: strength: '0x10'"),
        (ALUMINIUM.replace("300 ", "1 500 "), "own.mca:7: strength has 2 values, allowed: one, or"),
        (ALUMINIUM.replace("300 ", "-3 "), "own.mca:7: strength: '-3'"),
        (ALUMINIUM.replace("300 ", "# "), "own.mca:7: strength: ''"),
        (ALUMINIUM.replace("300 ", "3" * 5000 + " "), f"strength: '{'3' * 57}...' is not allowed"),
        (ALUMINIUM.replace("density", "d" * 5000), f"unknown keyword '{'d' * 57}...'"),
        (ALUMINIUM + "density 1\n", "own.mca:14: density appears twice"),
        (ALUMINIUM.replace("0.33", "0.5"), "must be a number in -1 .. 0.5"),
        (ALUMINIUM.replace("0.9 ", "1.1 "), "yield_strength: '1.1' is not allowed, must be <= 1"),
        (ALUMINIUM.replace("0.7 ", "0.95 "), "elastic_limit: '0.95'"),
        (ALUMINIUM.replace("0.02 ", "0.003 "), "yield_strain: '0.003'"),
        (ALUMINIUM.replace("0.1 ", "0.02 "), "breaking_strain: '0.02'"),
        (ALUMINIUM.replace("0.1 ", "0.5 "), "breaking_strain: '0.5'"),
        (ALUMINIUM.replace("70000 ", "10 "), "p: '15.0' is not allowed, must be < E = 10 (MPa)"),
    ],
)
def test_bad_material(tmp_path, text, part):
    if text is not None:
        (tmp_path / "own.mca").write_text(text)
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{material: own.mca}]\n")
    one_line(campaign("run", path, "-o", tmp_path / "out"), 3, part)
    assert not (tmp_path / "out").exists()
