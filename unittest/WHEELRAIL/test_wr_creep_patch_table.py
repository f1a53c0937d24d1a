# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep --table: forces over a grid of loads, speeds and creepages for a multibody code."""

import json
import re

import numpy
import pytest
from patch_runs import CASE, SOURCE, creep_rows, numbers, run, table, wr_creep

AXES = ("load", "speed", "spin", "lateral", "creep")
GRID = (
    "spin=[-2e-4 1/mm, 0 1/mm, 2e-4 1/mm]",
    "lateral=[-1e-3, 0, 1e-3]",
    "creep=[-2e-3, -1e-3, 0, 1e-3, 2e-3]",
    "speed=[10 m/s, 20 m/s]",
)


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def grid_of(path):
    """{axis: values}, and forces as an array over them: what a reader of the table does."""
    rows = table(path)
    head = next(
        line for line in path.read_text(encoding="utf-8").split("\n") if line.startswith("# grid:")
    )
    sizes = {name: int(size) for size, name in re.findall(r"(\d+) (\w+)", head)}
    assert tuple(sizes) == AXES
    axes = {name: numpy.unique(numbers(rows, name)) for name in AXES}
    shape = tuple(len(values) for values in axes.values())
    assert shape == tuple(sizes.values())
    coordinates = numpy.meshgrid(*axes.values(), indexing="ij")
    for name, values in zip(AXES, coordinates, strict=True):
        assert (numbers(rows, name) == values.ravel()).all(), name
    names = ("force_x", "force_y", "moment_z")
    return axes, {name: numbers(rows, name).reshape(shape) for name in names}


def test_table_is_a_regular_grid(case, tmp_path):
    file = tmp_path / "forces.csv"
    done = run(case, tmp_path / "out", *GRID, options=("--table", file))
    assert "table of 90 operating points" in done.stdout
    _, forces = grid_of(file)
    creep = table(tmp_path / "out/creep.csv")
    for name, values in forces.items():
        assert (values.ravel() == numbers(creep, name)).all()
    # nothing but the signs changes when all creepages do, and when the contact is mirrored in x
    fx, fy, mz = forces["force_x"], forces["force_y"], forces["moment_z"]
    turned = (slice(None), slice(None)) + 3 * (slice(None, None, -1),)
    mirrored = (slice(None), slice(None)) + 2 * (slice(None, None, -1),)
    for values in (fx, fy, mz):
        assert values[turned] == pytest.approx(-values, abs=2e-3 * abs(fx).max())
    assert fx[mirrored] == pytest.approx(fx, abs=2e-3 * abs(fx).max())
    assert fy[mirrored] == pytest.approx(-fy, abs=2e-3 * abs(fx).max())
    assert (numpy.diff(fx, axis=4) < 0).all()  # against the creep
    # between the points
    (middle,) = creep_rows(
        case, tmp_path / "middle", "creep=1.5e-3", "lateral=0.5e-3", "spin=1e-4 1/mm"
    )
    corners = fx[0, 1, 1:, 1:, 3:]
    assert corners.min() < float(middle["force_x"]) < corners.max()


def test_points_that_do_not_converge_are_named(case, tmp_path):
    """Heat that leaves no strength: the other points are results, and the exit code says so."""
    hot = CASE.replace("law: constant, mu: 0.3", "law: bucher2006").replace(
        "thermal: off", "thermal: {conductivity: 0.01 W/(m K), model: local}"
    )
    case.write_text(hot, encoding="utf-8")
    changes = ("creep=[1e-6, 2e-6, 0.9]", "speed=[1 m/s, 20 m/s]")
    file = tmp_path / "forces.csv"
    done = run(case, tmp_path / "out", *changes, code=4, options=("--table", file))
    rows, creep = table(file), table(tmp_path / "out/creep.csv")
    failed = [k for k, row in enumerate(rows) if row["converged"] == "0"]
    assert len(rows) == 6 and 0 < len(failed) < 6 and 5 in failed
    assert f"{len(failed)} of 6 operating points did not converge" in done.stderr
    named = json.loads((tmp_path / "out/summary.json").read_text())["not_converged"]
    assert [int(re.match(r"point (\d+) ", line).group(1)) for line in named] == [
        k + 1 for k in failed
    ]
    assert all(line in done.stderr for line in named)
    assert [row["force_x"] for row in rows if row["converged"] == "1"] == [
        row["force_x"] for row in creep
    ]
    assert {rows[k][name] for k in failed for name in ("force_x", "force_y", "moment_z")} == {""}
    none = ("creep=[0.8, 0.9]", "speed=20 m/s")
    done = run(case, tmp_path / "none", *none, code=4, options=("--table", tmp_path / "none.csv"))
    assert done.stderr.count("wr_creep: ") - done.stderr.count(" points\n") == 1, done.stderr
    assert not (tmp_path / "none/creep.csv").exists() and not (tmp_path / "none.csv").exists()


@pytest.mark.parametrize(
    "changes,expected",
    [
        (("creep=[2e-3, 1e-3]",), "the values of creep must increase"),
        (("speed=[10 m/s, 10 m/s]",), "the values of speed must increase"),
        (("mode=static", "static.force_ratio=0.5"), "that rolls"),
        (("contact.domain=3", "roughness.seed=[1, 2]"), "one surface; 2 are given"),
    ],
)
def test_what_makes_no_table(changes, expected, case, tmp_path):
    if "roughness.seed=[1, 2]" in changes:
        rough = (
            "roughness: {hurst: 0.8, rms_slope: 0.01, wavelength_min: 3 mm, wavelength_max: 9 mm}"
        )
        case.write_text(CASE + rough + "\n", encoding="utf-8")
    done = run(case, tmp_path / "out", *changes, code=2, options=("--table", tmp_path / "t.csv"))
    assert done.stderr.count("\n") == 1 and "--table: " in done.stderr and expected in done.stderr
    assert not (tmp_path / "t.csv").exists() and not (tmp_path / "out").exists()


def test_table_needs_creepages_and_a_point(case, tmp_path):
    case.write_text(CASE.replace("creep: [1e-3]", "force: {longitudinal: -1 kN}"), encoding="utf-8")
    done = run(case, tmp_path / "out", code=2, options=("--table", tmp_path / "t.csv"))
    assert "not with force" in done.stderr
    line = SOURCE / "examples/wheelrail/table2.yaml"
    done = wr_creep(line, "-o", tmp_path, "--table", tmp_path / "t.csv")
    assert done.returncode == 2 and "a point contact" in done.stderr
    done = wr_creep(case, "-o", tmp_path / "o", "--table", tmp_path / "o/creep.csv")
    assert done.returncode == 2 and done.stderr.count("\n") == 1


@pytest.mark.parametrize("layer", [None, "{thickness: 10 um, shear_modulus: 100 MPa}"])
def test_page_reads_a_table(layer, case, tmp_path, monkeypatch):
    """The block of doc/howto_patch.md, whatever the number of lines of #."""
    page = (SOURCE / "doc/howto_patch.md").read_text(encoding="utf-8")
    (code,) = re.findall(r'```python\n(.*?"forces\.csv".*?)```', page, re.DOTALL)
    grid = (
        *("contact.curvatures=[1 1/m, 2 1/m]", "contact.load=[10 kN, 20 kN, 30 kN]"),
        *("cells=[16, 16]", "speed=[10 m/s, 20 m/s]", GRID[0]),
        *("lateral=[0, 1e-3, 2e-3, 3e-3]", "creep=[0, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3]"),
    )
    text = CASE.replace("semi_axes: [3 mm, 4 mm], ", "")
    case.write_text(text + (f"layer: {layer}\n" if layer else ""), encoding="utf-8")
    run(case, tmp_path / "out", *grid, options=("--table", tmp_path / "forces.csv"))
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(compile(code, "doc/howto_patch.md", "exec"), names)  # noqa: S102: that is the test
    _, forces = grid_of(tmp_path / "forces.csv")
    assert (names["force_x"] == forces["force_x"]).all()
    assert names["creep"] == pytest.approx([0, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3])


def test_example_makes_a_table(tmp_path):
    example = SOURCE / "examples/wheelrail/patch_table.yaml"
    few = ("cells=32", "contact.load=[80 kN, 120 kN]", "creep=[0, 0.5 %]", "lateral=[0, 0.5 %]")
    run(example, tmp_path / "out", *few, options=("--table", tmp_path / "forces.csv"))
    axes, forces = grid_of(tmp_path / "forces.csv")
    assert len(axes["load"]) == 2 and (forces["force_x"][..., 1] < 0).all()
