# SPDX-License-Identifier: GPL-2.0-or-later
"""The examples against their pages and the plans: one geometry, commands that run where they stand,
every variable set from outside."""

import os
import re
import subprocess
from pathlib import Path

import pytest
import yaml

from campaign_parts import material, plan as plans
from mcawr import dump
from single_rank import alone

ROOT = Path(__file__).resolve().parents[2]
LMP = os.environ.get("MCAWR_LMP", str(ROOT / "build" / "bin" / "lmp"))
FRICTION = ROOT / "examples" / "friction"
SPACE = ROOT / "examples" / "space"


def script_variables(script):
    """Default of each variable that the script's head lets one set; of style index, since LAMMPS
    refuses a command-line value for any other style (equal: computed from these)."""
    head = script.read_text(encoding="utf-8").split("\nunits ")[0]
    found = re.findall(r"^variable +(\w+) +(\w+) +(\S+)", head, re.MULTILINE)
    assert {style for _, style, _ in found} <= {"index", "equal"}
    return {name: default for name, style, default in found if style == "index"}


def run(script, folder, values):
    words = [word for name, value in values.items() for word in ("-var", name, str(value))]
    done = subprocess.run(
        [LMP, "-in", script, *words],
        cwd=folder,
        env=os.environ | alone(folder),
        timeout=120,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    warnings = [  # fragments made small for the test are told to be narrow
        line
        for line in done.stdout.splitlines()
        if "WARNING" in line and "may rub half as much as a wide one" not in line
    ]
    assert done.returncode == 0 and not warnings, done.stdout[-3000:]
    return (folder / "log.lammps").read_text(encoding="utf-8")


def head_of(log):
    lines = log.read_text(encoding="utf-8").splitlines(True)
    return yaml.safe_load("".join(line[2:] for line in lines if line[0] == "#"))


def steps_of(log):
    lines = log.read_text(encoding="utf-8").splitlines()
    return [int(line.split()[0]) for line in lines if line[0].isdigit()]


def test_plans_and_example_have_the_same_defaults():
    """A quantity of the material is the file's in the script, and that file's in a plan."""
    script = script_variables(FRICTION / "in.friction")
    solid = material.read(str(ROOT / "potentials" / script["material"]))
    assert solid == {name: plans.KEYS[name].default for name in solid}
    for name, key in plans.KEYS.items():
        if name in solid and name != "d":
            assert script[key.variable] in ("0", "1", "-1"), name  # as the file says
            continue
        if key.variable and key.default is not None and name != "ns":
            if key.default == "auto":
                continue  # a plan finds it by the load
            word = isinstance(key.default, str)
            default = key.default if word else f"{key.default * key.factor:.12g}"
            assert script[key.variable] == default, name


def test_first_script_is_of_the_same_geometry(tmp_path):
    """The README's: columns, rows, rows held and driven, roughness of the example."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    script = re.search(r"^```lammps\n(.*?)^```", readme, re.MULTILINE | re.DOTALL)[1]
    (tmp_path / "in.first").write_text(script, encoding="utf-8")
    example = script_variables(FRICTION / "in.friction")
    rows, held = int(example["rows"]), int(example["held"])
    columns = int(example["columns"])
    for seed in range(1, 6):  # both blocks take it: neither overlap nor gap
        log = run("in.first", tmp_path, {"seed": seed})
        found = re.findall(r"^(\d+) atoms in group (\w+)$", log, re.MULTILINE)
        count = {name: int(number) for number, name in found}
        assert count["lower"] + count["upper"] == rows * columns
        assert count["bottom"] == count["top"] == held * columns
        lines = re.findall(r"^region +\w+ mca/rough \w+ (\S+) (\S+) \S+ (\d+)", log, re.MULTILINE)
        assert set(lines) == {("14.07", example["amplitude"], str(seed))}


@pytest.mark.parametrize(
    "page", sorted(ROOT.glob("examples/*/README.md")), ids=lambda path: path.parent.name
)
def test_commands_find_their_programs(page):
    """From the folder of the page, unless it says that they are run from the top folder."""
    text = page.read_text(encoding="utf-8")
    start = ROOT if "From the top folder of the checkout" in text else page.parent
    for block in re.findall(r"^```sh\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        for program in re.findall(r"(?<!\S)(\S*(?:build/bin|tools)/\S+)", block):
            target = Path(os.path.normpath(start / program))
            assert target.parent in (ROOT / "build" / "bin", ROOT / "tools")
            assert target.parent.name == "bin" or target.exists()
        for name in re.findall(r"-in (\S+)", block):
            assert (start / name).exists()


def test_every_variable_of_the_friction_example(tmp_path):
    given = {
        "p": 7,
        "v": 3,
        "strength": 120,
        "seed": 5,
        "ns": 0.02,
        "laws": "a weld 0.7",
        "material": "rail_steel.mca",
        "upper_material": "rail_steel.mca",
        "temperature": 300,
        "E": 180000,
        "nu": 0.25,
        "rho": 0.009,
        "eta": 300,
        "elastic_limit": 0.6,
        "yield_strength": 0.9,
        "yield_strain": 0.02,
        "breaking_strain": 0.05,
        "upper_values": "strength 130",
        "columns": 16,
        "rows": 12,
        "held": 2,
        "amplitude": 1.5,
        "d": 3,
        "every": 50,
        "dt": 4e-05,
        "name": "other",
        "log": "mine.friction",
        "pictures": "mine.*.dump",
        "frames": 250,
        "profile": 200,
        "account": 1,
        "checkpoint": 300,
        "continue": 0,
        "restart": "other.restart",
    }
    defaults = script_variables(FRICTION / "in.friction")
    assert given.keys() == defaults.keys()
    assert all(str(given[name]) != defaults[name] for name in given if name != "continue")
    log = run(FRICTION / "in.friction", tmp_path, given)
    assert re.findall(r"^(\d+) atoms in group (?:bottom|top)$", log, re.MULTILINE) == ["32", "32"]
    line = re.findall(r"mca/rough below (\S+) (\S+) (\S+) 5 units box", log)[-1]
    assert list(map(float, line)) == pytest.approx([3 * 3**0.5 / 2 * 11 / 2, 1.5, 6])
    head = head_of(tmp_path / "mine.friction")
    material = head["material"]
    assert (material["youngs_modulus"], material["poissons_ratio"]) == (180000, 0.25)
    assert [material[name] for name in ("density", "strength", "viscosity")] == [9000, 120, 0.3]
    assert (head["other_material"]["layer"], head["other_material"]["strength"]) == ("driven", 130)
    curve = ("elastic_limit", "yield_strength", "yield_strain", "breaking_strain")
    assert [material[name] for name in curve] == pytest.approx([72, 108, 0.02, 0.05])
    assert head["loading"] == {"pressure": 7, "velocity": 3}
    geometry = head["geometry"]
    assert (geometry["width"], geometry["diameter"], geometry["automata"]) == (48, 3, 192)
    assert (head["laws"]["preset"], head["laws"]["weld"]) == ("a", 0.7)
    assert head["run"] == {"timestep": 4e-05, "every": 50, "seed": 5}
    assert steps_of(tmp_path / "mine.friction") == list(range(50, 501, 50))
    assert {path.name for path in tmp_path.iterdir()} == {
        "log.lammps",
        "mine.friction",
        "mine.0.dump",
        "mine.250.dump",
        "mine.500.dump",
        "other.profile",
        "other.a.restart",
        "other.restart",
    }
    profile = (tmp_path / "other.profile").read_text(encoding="utf-8")
    assert re.findall(r"^(\d+) \d+ \d+$", profile, re.MULTILINE) == ["200", "400"]
    run(FRICTION / "in.friction", tmp_path, {**given, "ns": 0.03, "continue": 1})
    assert steps_of(tmp_path / "mine.friction") == list(range(50, 751, 50))


@pytest.mark.parametrize("name", ["notched", "brazilian", "scratch", "grains"])
def test_tables_of_variables_are_those_of_the_script(name):
    folder = ROOT / "examples" / name
    page = (folder / "README.md").read_text(encoding="utf-8")
    table = re.findall(r"^\| `(\w+)` \| `(.*?)` \|", page, re.MULTILINE)
    assert dict(table) == script_variables(folder / f"in.{name}")


def test_notched_plates_have_one_toughness(tmp_path):
    """Two depths of the notch in a smaller plate, and the page's plate, agree."""
    page = (ROOT / "examples/notched/README.md").read_text(encoding="utf-8")
    shown = float(re.search(r"^\| 10 \|.*\| ([\d.]+) \|$", page, re.MULTILINE)[1])
    for notch in (4, 8):
        values = {"notch": notch, "columns": 40, "rows": 60, "rate": 6e-4, "after": 0.04}
        log = run(ROOT / "examples/notched/in.notched", tmp_path, values)
        toughness = float(re.search(r"^notches of .* = (\S+) strength d", log, re.MULTILINE)[1])
        assert toughness == pytest.approx(shown, rel=0.06)
    frames = (tmp_path / "notched.dump").read_text(encoding="utf-8").count("ITEM: TIMESTEP")
    assert frames == 2


@pytest.mark.long
def test_weaker_half_of_the_disc_decides(tmp_path):
    """And the limit is that of stresses of 0.894 and -2.89 by Mohr and Coulomb."""
    split = {}
    for name, value in {"E": 206000, "strength2": 184, "strength": 46}.items():
        values = {"radius": 40, "rate": 5e-3, "after": 0.002, "strength2": 92, name: value}
        log = run(ROOT / "examples/brazilian/in.brazilian", tmp_path, values)
        split[name] = float(re.search(r"^2P/\(pi D h\) = (\S+) MPa", log, re.MULTILINE)[1])
    assert split["E"] == pytest.approx(10 / (10 * 0.894 + 2.89) * 92, rel=0.06)
    assert split["strength2"] == pytest.approx(split["E"], rel=0.02)
    # the waves of the start count twice as much beside half the load
    assert split["strength"] == pytest.approx(split["E"] / 2, rel=0.1)


@pytest.mark.long
def test_scratch(tmp_path):
    values = {"columns": 40, "rows": 12, "depth": 2.5, "length": 5, "radius": 7.5, "laws": "a"}
    log = run(ROOT / "examples/scratch/in.scratch", tmp_path, values)
    hardness = float(re.search(r"^depth 2.5 nm: hardness (\S+) MPa", log, re.MULTILINE)[1])
    mu, lost = re.search(
        r"^scratch over 5 nm: friction (\S+), links lost (\d+)", log, re.MULTILINE
    ).groups()
    assert 0.5 * 92 < hardness < 4 * 92
    assert 0.0 < float(mu) < 3.0 and int(lost) > 0


def test_grains(tmp_path):
    """Whole at first, as many as the variables say; then the counts of the page's sort."""
    values = {"grains": 3, "radius": 7.5, "layers": 2, "distance": 6, "v": 10, "p": 20}
    log = run(ROOT / "examples/grains/in.grains", tmp_path, values)
    first, last, largest = map(
        int,
        re.search(
            r"^fragments: (\d+) at first, (\d+) after 6 nm, the largest of (\d+)", log, re.MULTILINE
        ).groups(),
    )
    broken, formed = map(
        int, re.search(r"^links broken (\d+), formed (\d+)", log, re.MULTILINE).groups()
    )
    assert first == 2 + 2 * 3 and last != first and broken > 0 and formed > 0
    plate = 4 * 3 * 20 / 2.5  # rows of periods
    assert largest > plate


def test_every_variable_of_the_bar(tmp_path):
    """Each changes the box, the strain or the stress; the table of the page is the script's."""
    defaults = script_variables(SPACE / "in.bar")
    page = (SPACE / "README.md").read_text(encoding="utf-8").split("## Friction")[0]
    assert dict(re.findall(r"^\| `(\w+)` \| `(.*?)` \|", page, re.MULTILINE)) == defaults
    shown = {}
    others = {"strength": 184, "cells": 3, "strain": 0.002, "rate": 0.2, "skin": "yes", "d": 3}
    for name, value in {"": "", **others}.items():
        log = run(SPACE / "in.bar", tmp_path, {"strain": 0.0024, **({name: value} if name else {})})
        box = re.search(r"^Created orthogonal box = (.*)$", log, re.MULTILINE)[1]
        strain, stress = re.findall(r"^ +\d+ +(\S+) +(\S+) .*$", log, re.MULTILINE)[-1]
        assert float(strain) == pytest.approx(value if name == "strain" else 0.0024, rel=1e-6)
        shown[name] = (box, strain, stress)
    assert set(shown) == {"", *defaults} and len(set(shown.values())) == len(shown)


def test_friction_in_space(tmp_path):
    """The variables of the friction example and two more; a run that goes on after its restart
    file."""
    defaults, plane = (script_variables(where / "in.friction") for where in (SPACE, FRICTION))
    other = {"columns": "20", "rows": "28", "depth": "8", "skin": "0.03"}
    assert defaults == {**plane, **other}
    values = {"columns": 8, "rows": 14, "depth": 6, "every": 100, "seed": 3, "v": 7, "frames": 0}
    values.update(profile=200, checkpoint=200)
    run(SPACE / "in.friction", tmp_path, {**values, "ns": 0.016})
    log = tmp_path / "friction.friction"
    head = head_of(log)
    assert head["geometry"]["packing"] == "fcc" and head["geometry"]["automata"] == 8 * 14 * 6 / 2
    assert head["loading"]["velocity"] == 7 and head["run"]["seed"] == 3
    run(SPACE / "in.friction", tmp_path, {**values, "ns": 0.032, "continue": 1})
    assert steps_of(log) == list(range(100, 900, 100))
    heads = re.findall(
        r"^(\d+) \d+ [\d.]+$", (tmp_path / "friction.profile").read_text(), re.MULTILINE
    )
    assert list(map(int, heads)) == [200, 400, 600, 800]


def test_page_for_tribologists(tmp_path, monkeypatch):
    """Worn automata and links between the blocks by events are those of the last links."""
    monkeypatch.chdir(tmp_path)
    page = (ROOT / "doc/howto_tribology.md").read_text(encoding="utf-8")
    (script,) = re.findall(r"^```lammps\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    (wear,) = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    places = "dump places all custom 20000 places.dump id type\nrun 20000"
    (tmp_path / "in.wear").write_text(script.replace("run             20000", places))
    run("in.wear", tmp_path, {})
    found = {}
    exec(wear, found)
    kinds = dump.Dump("places.dump").columns(1, ["id", "type"])
    block = dict(zip(kinds["id"], kinds["type"]))
    begin, end = (dump.Dump("links.dump").columns(k, ["id1", "id2"]) for k in (0, 1))
    pairs = list(zip(end["id1"], end["id2"]))
    held = {i for pair in pairs if block[pair[0]] == block[pair[1]] for i in pair}
    assert found["worn"] == len({*begin["id1"], *begin["id2"]} - held)
    assert found["across"] == sum(block[a] != block[b] for a, b in pairs) > 0
    assert 0 < found["contact"] < 2 and found["wear"] >= 0


@pytest.mark.parametrize(
    "call, said",
    [
        ("friction.slide(1, presure=5)", "in.friction has no variable 'presure', it has: p, v, "),
        ("friction.slide(1, upper_material='a.mca')", "no lmp is needed"),
        ("friction.main()", "friction.py: '10 5' is not allowed, must be a time in ns"),
    ],
)
def test_python_example_refuses_what_its_script_does_not_know(tmp_path, call, said):
    (tmp_path / "lammps.py").write_text(
        "LMP_STYLE_GLOBAL = LMP_TYPE_VECTOR = 0\n\n\n"
        "def lammps(cmdargs):\n    raise SystemExit('no lmp is needed')\n"
    )
    done = subprocess.run(
        ["/usr/bin/python3", "-c", f"import friction\n{call}", "10", "5"],
        env={**os.environ, "PYTHONPATH": f"{tmp_path}:{ROOT / 'examples/python'}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == (2 if "main" in call else 1) and said in done.stderr, done.stderr
