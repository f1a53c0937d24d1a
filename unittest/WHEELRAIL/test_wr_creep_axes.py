# SPDX-License-Identifier: GPL-2.0-or-later
"""The page of axes and signs against the program, and the heads of all tables and fields."""

import re

import pytest
from patch_runs import CASE, SOURCE, run, table, wr_creep

PAGE = (SOURCE / "doc/wr_creep_axes.md").read_text(encoding="utf-8")


def rows_of(first):
    """Cells of the table of the page whose head begins so."""
    lines = PAGE[PAGE.index(f"| {first} |") :].split("\n\n")[0].split("\n")[2:]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def page_case(tmp_path):
    path = tmp_path / "page.yaml"
    path.write_text(re.search(r"```yaml\n(.*?)```", PAGE, re.DOTALL)[1], encoding="utf-8")
    return path


def test_numbers_of_the_page(tmp_path):
    case = page_case(tmp_path)
    rows = rows_of("`creep`")
    assert len(rows) == 5
    for creep, lateral, spin, *forces, _ in rows:
        run(case, tmp_path / "out", f"creep={creep}", f"lateral={lateral}", f"spin={spin} 1/mm")
        (found,) = table(tmp_path / "out/creep.csv")
        size = max(abs(float(force)) for force in forces)
        for name, force in zip(("force_x", "force_y", "moment_z"), forces, strict=True):
            assert float(found[name]) == pytest.approx(float(force), rel=6e-6, abs=1e-6 * size)


def test_conventions_of_the_page_follow_from_its_numbers():
    """The second table turns the rows of the first by the rules that stand beside it."""
    driving, spin = (next(r for r in rows_of("`creep`") if r[k] == v) for k, v in
                     ((0, "-0.001"), (2, "0.0005")))  # fmt: skip
    here = [float(text) for text in (driving[0], driving[3], spin[2], spin[4], spin[5])]
    rules = {  # creep, Fx, spin, Fy, Mz
        1: (1, 1, 1, 1, 1),
        2: (1, 1, -1, -1, -1),
        3: (1, -1, 1, -1, -1),
        4: (-1, 1, 1, 1, 1),
    }
    rows = rows_of("what")
    for column, signs in rules.items():
        given = [float(row[column]) for row in rows]
        assert given == [sign * value for sign, value in zip(signs, here, strict=True)]


def test_line_contact_of_the_page(tmp_path):
    changes = ("creep=[0.001, -0.001]", "speed=20 m/s", "cells=1000", "thermal=off")
    sets = [part for change in changes for part in ("--set", change)]
    done = wr_creep(
        SOURCE / "examples/wheelrail/table2.yaml",
        *("-o", tmp_path, *sets, "--set", "friction={law: constant, mu: 0.3}"),
    )
    assert done.returncode == 0, done.stderr
    wanted = dict(re.findall(r"^\| (-?0\.001) \| (-?[0-9.]+) \|$", PAGE, re.MULTILINE))
    assert len(wanted) == 2
    for row in table(tmp_path / "creep.csv"):
        assert float(row["traction_ratio"]) == pytest.approx(float(wanted[row["creep"]]), abs=5e-7)


@pytest.mark.parametrize("mode", ["frozen", "static"])
def test_tables_and_fields_say_what_they_are(mode, tmp_path):
    case = tmp_path / "case.yaml"
    case.write_text(CASE, encoding="utf-8")
    forces = tmp_path / "forces.csv"
    if mode == "frozen":
        layer = "layer={thickness: 20 um, shear_modulus: 1 GPa, yield_stress: 150 MPa}"
        run(
            case, tmp_path, "fields=last", "creep=[-1e-3, 1e-3]", layer, options=("--table", forces)
        )
    else:
        run(case, tmp_path, "fields=last", "mode=static", "static.force_ratio=0.5")
    files = sorted(tmp_path.glob("*.csv")) + sorted(tmp_path.glob("fields*"))
    assert len(files) == (12 if mode == "frozen" else 11)
    for file in files:
        text = file.read_bytes().decode("utf-8", errors="replace")
        for name, words in {
            "program": "wr_creep ",
            "axes": "on the wheel",
            "contact": "semi_axes: [3 mm, 4 mm]",
            "friction": "law: constant, mu: 0.3",
            "layer": "thickness: 20 um, shear_modulus: 1 GPa, yield_stress: 150 MPa",
        }.items():
            if name == "layer" and mode == "static":  # which has none here
                assert f"{name}:" not in text
                continue
            line = re.search(rf"^(?:# |<!-- )?{name}(?: =|:) (.*)$", text, re.MULTILINE)
            assert line and words in line[1], (file, name)


def test_t_gamma_of_unlike_bodies_may_be_negative_wear_not(tmp_path):
    """A soft wheel that is driven less than it rolls freely: its creep works against its force."""
    case = tmp_path / "case.yaml"
    case.write_text(CASE.replace("209.92 GPa", "[70 GPa, 210 GPa]"))
    run(case, tmp_path / "out", "creep=-1e-4", "wear={law: t_gamma}")
    (row,) = table(tmp_path / "out/creep.csv")
    assert float(row["t_gamma"]) < 0.0
    assert float(row["t_gamma"]) == pytest.approx(1e-4 * float(row["force_x"]))
    assert float(row["friction_work"]) > 0.0
    assert float(row["wear_volume"]) > 0.0
