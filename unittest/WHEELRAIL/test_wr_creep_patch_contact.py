# SPDX-License-Identifier: GPL-2.0-or-later
"""What CONTACT's own cases need of wr_creep: box, cells, approach, twist, steps, mu across y, heat
of unlike bodies, a gap at the cells' centres."""

import math

import numpy
import pytest
from patch_runs import CASE, ROUGH, creep_rows, numbers, run, table

from mcawr import fields

LOAD, MU, A, B = 10e3, 0.3, 3.0, 4.0  # N, mm: of CASE
SLIDING = "creep=[0.1]"
CELL = "contact.cell=[0.25 mm, 0.25 mm]"


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def row_of(case, out, *changes):
    """The only operating point, as numbers."""
    (row,) = creep_rows(case, out, *changes)
    return {name: float(value) for name, value in row.items()}


def ball(case, curvatures):
    text = case.read_text(encoding="utf-8")
    case.write_text(
        text.replace("semi_axes: [3 mm, 4 mm]", f"curvatures: {curvatures}"), encoding="utf-8"
    )


def static_row(case, out, *changes):
    text = case.read_text(encoding="utf-8")
    rolls = ("creep", "speed", "sensitivities")
    text = "".join(line for line in text.splitlines(True) if not line.startswith(rolls))
    still = case.with_name("static.yaml")
    still.write_text(text + "mode: static\n", encoding="utf-8")
    run(still, out, *changes)
    (row,) = table(out / "static.csv")
    return {name: float(value) for name, value in row.items()}


@pytest.mark.parametrize(
    "change", ["contact.box=[6.6 mm, 8.8 mm]", "contact.cell=[0.20625 mm, 0.275 mm]"]
)
def test_box_and_cell_say_what_the_domain_says(case, tmp_path, change):
    by_domain = row_of(case, tmp_path / "domain", "contact.domain=2.2")
    assert row_of(case, tmp_path / "size", change) == pytest.approx(by_domain, rel=1e-9, abs=1e-6)


def test_box_is_as_long_and_as_wide_as_it_says(case, tmp_path):
    done = row_of(case, tmp_path / "out", "contact.box=[6.4 mm, 9.6 mm]", "cells=[64, 48]")
    cells = done["real_area"] / (0.1 * 0.2)
    assert cells == pytest.approx(round(cells), abs=1e-6)
    assert done["real_area"] == pytest.approx(math.pi * A * B, rel=0.02)


def test_centre_moves_the_box_and_not_the_contact(case, tmp_path):
    """By whole cells, so that the contact has the same cells; the moment is about the origin."""
    box = "contact.cell=[0.25 mm, 0.25 mm]"
    changes = (box, "cells=[40, 40]", "lateral=1e-3", "spin=1e-4 1/mm")
    middle = row_of(case, tmp_path / "middle", *changes)
    moved = row_of(case, tmp_path / "moved", *changes, "contact.centre=[0.5 mm, -0.25 mm]")
    for name in ("force_x", "force_y", "moment_z", "peak_pressure", "approach", "stick_fraction"):
        assert moved[name] == pytest.approx(middle[name], rel=1e-5), name
    refused = run(case, tmp_path / "far", *changes, "contact.centre=[3 mm, 0 mm]", code=3)
    assert "border of the box" in refused.stderr


def test_approach_gives_the_load_that_makes_it(case, tmp_path):
    ball(case, "[1 1/m, 0.7 1/m]")
    text = case.read_text(encoding="utf-8")
    case.write_text(text.replace("cells: [32", "cells: [36"), encoding="utf-8")
    under_load = row_of(case, tmp_path / "load", CELL)
    approach = under_load["approach"]
    text = case.read_text(encoding="utf-8")
    case.write_text(text.replace("load: 10 kN", f"approach: {approach} mm"), encoding="utf-8")
    found = row_of(case, tmp_path / "approach", CELL)
    assert found["load"] == pytest.approx(LOAD, rel=1e-8)
    for name in ("force_x", "peak_pressure", "real_area", "approach"):
        assert found[name] == pytest.approx(under_load[name], rel=1e-5), name
    still = static_row(case, tmp_path / "static", "static.force_ratio=0.5", CELL)
    assert still["load"] == pytest.approx(LOAD, rel=1e-8)
    assert still["traction_ratio"] == pytest.approx(0.5 * MU, rel=1e-5)


def test_several_approaches_are_one_curve_each(case, tmp_path):
    """Hertz: the load goes with the approach to the power 3/2."""
    text = case.read_text(encoding="utf-8")
    text = text.replace("load: 10 kN, semi_axes: [3 mm, 4 mm]",
                        "approach: [10 um, 40 um], curvatures: [1 1/m, 1 1/m]")  # fmt: skip
    case.write_text(text, encoding="utf-8")
    loads = numbers(creep_rows(case, tmp_path / "out"), "load")
    assert loads[1] / loads[0] == pytest.approx(8.0, rel=1e-6)


def test_mu_changes_across_the_contact(case, tmp_path):
    """In full sliding a part that is odd in y makes no force, and the moment mu N b^2/(5 c) of
    Hertz's pressure under a factor 1 + y/c."""
    even = row_of(case, tmp_path / "even", SLIDING, "friction.mu=0.6")
    twice = ("friction.across_y=[-1 mm, 1 mm]", "friction.across_factor=[2, 2]")
    assert row_of(case, tmp_path / "twice", SLIDING, *twice) == pytest.approx(even, rel=1e-9)
    odd = ("friction.across_y=[-8 mm, 8 mm]", "friction.across_factor=[0.5, 1.5]", "cells=[96, 96]")
    slides = row_of(case, tmp_path / "odd", SLIDING, *odd)
    assert slides["force_x"] == pytest.approx(-MU * LOAD, rel=1e-5)
    assert slides["moment_z"] == pytest.approx(MU * LOAD * B**2 / (5 * 16), rel=1e-3)
    still = static_row(case, tmp_path / "static", "static.shift=[1 mm, 0 mm]", *odd)
    assert still["moment_z"] == pytest.approx(slides["moment_z"], rel=1e-3)
    beyond = ("friction.across_y=[-1 nm, 1 nm]", "friction.across_factor=[0.5, 1.5]")
    step = row_of(case, tmp_path / "beyond", SLIDING, *beyond)
    assert step["force_x"] == pytest.approx(
        -MU * LOAD, rel=1e-5
    )  # 0.5 on one half, 1.5 on the other


@pytest.mark.parametrize("mode", ["frozen", "moving"])
@pytest.mark.parametrize("model", ["averaged", "averaged_power", "local"])
def test_bulk_temperature_is_added(case, tmp_path, model, mode):
    changes = [f"thermal={{model: {model}}}", "creep=[0.01]", f"mode={mode}"]
    if mode == "moving":
        changes.append("moving.passes=2")
    cold = row_of(case, tmp_path / "cold", *changes)
    warm = row_of(case, tmp_path / "warm", *changes, "thermal.bulk=[40 K, 20 K]")
    assert cold["temperature_rise"] > 1.0
    for name in ("temperature_rise", "temperature_max"):
        assert warm[name] == pytest.approx(cold[name] + 30.0, rel=1e-6), name
    assert warm["force_x"] == cold["force_x"]


@pytest.mark.parametrize("model", ["averaged", "averaged_power", "local"])
def test_heat_goes_into_both_bodies_by_their_effusivity(case, tmp_path, model):
    """Four times the conductivity is twice the effusivity: a rise of 2/(1 + 2) of that of equal
    bodies, and a bulk temperature of (T_wheel + 2 T_rail)/3."""
    equal = row_of(case, tmp_path / "equal", f"thermal={{model: {model}}}")
    of_each = f"thermal={{model: {model}, conductivity: [50 W/(m K), 200 W/(m K)]}}"
    unlike = row_of(case, tmp_path / "unlike", of_each)
    assert unlike["temperature_rise"] == pytest.approx(equal["temperature_rise"] * 2 / 3, rel=1e-6)
    warm = row_of(case, tmp_path / "warm", of_each, "thermal.bulk=[0 K, 60 K]")
    assert warm["temperature_rise"] == pytest.approx(unlike["temperature_rise"] + 40, rel=1e-6)


def test_friction_feels_the_bulk_temperature(case, tmp_path):
    """Eq. 10: at half of the temperature without strength, half the strength is left."""
    text = case.read_text(encoding="utf-8").replace("law: constant, mu: 0.3", "strength: 500 MPa")
    case.write_text(text, encoding="utf-8")
    soft = row_of(case, tmp_path / "soft", SLIDING)
    text = text.replace("500 MPa", "1000 MPa").replace("thermal: off", "thermal: {bulk: 625 K}")
    case.write_text(text, encoding="utf-8")
    slow = ("speed=1 mm/s",)  # the rise by friction is then nothing
    warm = row_of(case, tmp_path / "warm", SLIDING, *slow)
    case.write_text(text.replace("{bulk: 625 K}", "off").replace("1000", "500"), encoding="utf-8")
    soft = row_of(case, tmp_path / "soft", SLIDING, *slow)
    assert warm["mu_mean"] == pytest.approx(soft["mu_mean"], rel=1e-3)


def paraboloid(path, nx, ny, size, A=0.5e-3, B=0.25e-3):
    """Heights -A x^2 - B y^2 (1/mm, mm) at the middles of cells as text, rows upwards."""
    x = (numpy.arange(nx) - 0.5 * (nx - 1)) * size
    y = (numpy.arange(ny) - 0.5 * (ny - 1)) * size
    rows = [";".join(f"{-A * s * s - B * t * t:.15g}" for s in x) for t in y]
    head = ["# height: mm", f"# spacing: {size} mm", "# rows: upwards"]
    path.write_text("\n".join(head + rows) + "\n", encoding="utf-8")


BALL = ("contact.cell=[0.2 mm, 0.2 mm]", "cells=[40, 36]")
CELLS = "roughness={{rail: {}, sampling: {}, detrend: none}}"


@pytest.mark.parametrize("more", [0, 2, 10])
def test_points_that_are_the_cells_centres(case, tmp_path, more):
    """A gap that is given at the centres is the gap of the same smooth bodies, to rounding; means
    over the cells are A (dx^2 + dy^2)/12 and the like nearer, and rounder where points bend."""
    ball(case, "[1.5 1/m, 1.25 1/m]")
    smooth = row_of(case, tmp_path / "smooth", *BALL)
    ball_of_points = tmp_path / "ball.txt"
    paraboloid(ball_of_points, 40 + more, 36 + more, 0.2)
    text = case.read_text(encoding="utf-8").replace("[1.5 1/m, 1.25 1/m]", "[1 1/m, 1 1/m]")
    case.write_text(text, encoding="utf-8")
    exact = row_of(case, tmp_path / "cells", *BALL, CELLS.format(ball_of_points, "cells"))
    for name in ("approach", "peak_pressure", "real_area", "force_x"):
        assert exact[name] == pytest.approx(smooth[name], rel=1e-6), name
    if more:  # means need points all over the cells
        means = row_of(case, tmp_path / "mean", *BALL, CELLS.format(ball_of_points, "mean"))
        assert abs(means["approach"] / smooth["approach"] - 1) > 1e-4


@pytest.mark.parametrize(
    "nx, ny, size, said",
    [
        (40, 36, 0.21, "points 0.21 x 0.21 mm apart are no centres of cells of 0.2 x 0.2 mm"),
        (39, 36, 0.2, "39 x 36 points; as many as the box has cells, 40 x 36, or an even number"),
        (38, 36, 0.2, "38 x 36 points"),
        (40, 37, 0.2, "40 x 37 points"),
    ],
)
def test_points_that_are_no_centres_are_refused(case, tmp_path, nx, ny, size, said):
    ball(case, "[1 1/m, 1 1/m]")
    paraboloid(tmp_path / "ball.txt", nx, ny, size)
    changes = (*BALL, CELLS.format(tmp_path / "ball.txt", "cells"))
    error = run(case, tmp_path / "out", *changes, code=3).stderr
    assert "roughness.sampling: " in error and said in error, error


def test_points_at_centres_travel(case, tmp_path):
    """Grooves along x that travel are grooves that stand."""
    ball(case, "[1 1/m, 1 1/m]")
    y = numpy.arange(36) * 0.2
    rows = [";".join(["%.12g" % (3e-4 * math.cos(2 * math.pi * t / 1.2))] * 900) for t in y]
    head = "# height: mm\n# spacing: 0.2 mm\n# rows: upwards\n"
    (tmp_path / "grooves.txt").write_text(head + "\n".join(rows) + "\n", encoding="utf-8")
    changes = (*BALL, CELLS.format(tmp_path / "grooves.txt", "cells"))
    stands = row_of(case, tmp_path / "stands", *changes)
    goes = row_of(case, tmp_path / "goes", *changes, "mode=moving", "moving.passes=4")
    assert goes["peak_pressure"] == pytest.approx(stands["peak_pressure"], rel=1e-5)
    assert goes["force_x"] == pytest.approx(stands["force_x"], rel=1e-3)


@pytest.mark.parametrize("unit", ["mm", "1 mm", "1000 um"])
def test_height_unit_is_a_unit_or_a_number_with_one(case, tmp_path, unit):
    draw = numpy.random.default_rng(1)
    numpy.save(tmp_path / "map.npy", draw.normal(size=(80, 80)) * 1e-4)
    measured = f"{{rail: {tmp_path / 'map.npy'}, spacing: 0.2 mm, height_unit: {unit}}}"
    done = row_of(case, tmp_path / "out", f"roughness={measured}")
    numpy.save(tmp_path / "map.npy", numpy.load(tmp_path / "map.npy") * 1e-3)
    in_metres = row_of(
        case, tmp_path / "m", f"roughness={measured.replace(f'unit: {unit}', 'unit: m')}"
    )
    assert done == pytest.approx(in_metres, rel=1e-9)


def test_twist_of_a_bonded_circle(case, tmp_path):
    """Reissner and Sagoci: a rigid disc that is turned by an angle on a half-space needs 16/3 G a^3
    times it; both bodies turn by half of it. Friction that nothing overcomes leaves out the edge
    only, where the pressure ends."""
    text = case.read_text(encoding="utf-8").replace("[3 mm, 4 mm]", "[4 mm, 4 mm]")
    case.write_text(text.replace("mu: 0.3", "mu: 10"), encoding="utf-8")
    changes = ("static.shift=[0 mm, 0 mm]", "cells=[96, 96]")
    twist = 1e-6
    row = static_row(case, tmp_path / "out", *changes, f"static.twist={twist}")
    area = row["real_area"] / (math.pi * 16)  # of whole cells
    bonded = -8 / 3 * 82e3 * 4**3 * twist * area**1.5  # N mm
    assert row["moment_z"] == pytest.approx(bonded, rel=0.01)
    assert row["twist"] == pytest.approx(twist)
    assert abs(row["force_x"]) < 1e-6 * abs(bonded)
    both = static_row(case, tmp_path / "both", "static.shift=[1e-6 mm, 0 mm]", "static.twist=1e-6")
    alone = static_row(case, tmp_path / "alone", "static.shift=[1e-6 mm, 0 mm]")
    assert both["force_x"] == pytest.approx(alone["force_x"], rel=1e-3)


def test_full_twist_slides_everywhere(case, tmp_path):
    """mu N times the mean distance from the centre, 3 pi a/16 of a sphere's pressure."""
    text = case.read_text(encoding="utf-8").replace("[3 mm, 4 mm]", "[4 mm, 4 mm]")
    case.write_text(text, encoding="utf-8")
    row = static_row(case, tmp_path / "out", "static.shift=[0 mm, 0 mm]", "static.twist=-0.5")
    assert row["moment_z"] == pytest.approx(MU * LOAD * 3 * math.pi / 16 * 4, rel=5e-3)


def test_steps_of_several_cells(case, tmp_path):
    """They come to the same steady rolling, and the balance of energy closes."""
    box = ("cells=[64, 32]", "contact.domain=2.8")
    steady = row_of(case, tmp_path / "steady", *box)
    changes = (*box, "mode=moving", "moving.start=rest", "moving.passes=4")
    steps = []
    for step in (1, 2, 4):
        out = tmp_path / str(step)
        row = row_of(case, out, *changes, f"moving.step={step}")
        series = table(out / "series.csv")
        steps.append(len(series))
        assert float(series[-1]["distance"]) == pytest.approx(4 * 2 * A, rel=0.05)
        assert float(series[-1]["force_x"]) == pytest.approx(steady["force_x"], rel=0.01 * step)
        slides = row_of(case, out, *changes, f"moving.step={step}", SLIDING)
        assert slides["force_x"] == pytest.approx(-MU * LOAD, rel=1e-5)
        assert slides["power"] == pytest.approx(MU * LOAD * 0.1 * 20, rel=1e-2)
        assert slides["power_closure"] == pytest.approx(1, abs=1e-2)  # to O(h)
        assert row["power_closure"] == pytest.approx(1, abs=0.05 * step)
    assert steps == [4 * 46, 4 * 23, 4 * 12]  # cells of 8.4/64 mm on a pass of 6 mm


@pytest.mark.parametrize("keyword", ["creep=[1e-13]", "lateral=1e-19", "spin=-1e-14 1/m"])
def test_rounding_of_a_creepage_is_nothing(case, tmp_path, keyword):
    name = keyword.split("=", maxsplit=1)[0]
    row = row_of(case, tmp_path / "out", "creep=[1e-3]", "lateral=1e-3", keyword)
    assert row[name] == 0.0


def test_a_force_that_friction_carries_at_a_larger_speed(tmp_path):
    """mu rises from 0.2 at rest to 0.4 at 2 m/s: a force between has the creepage that carries it,
    from cold, warm, with another force; above what any speed carries it is refused."""
    (tmp_path / "rise.csv").write_text(
        "# pressure: MPa\n# speed: m/s\npressure,speed,mu\n"
        "100,0,0.2\n100,2,0.4\n900,0,0.2\n900,2,0.4\n",
        encoding="utf-8",
    )
    case = tmp_path / "case.yaml"
    case.write_text(CASE.replace("creep: [1e-3]\n", ""), encoding="utf-8")
    rises = f"friction={{law: {tmp_path}/rise.csv}}"
    forces = "force.longitudinal=[-2.9 kN, 2.5 kN, -1 kN, -3.9 kN, 4.1 kN]"
    done = run(case, tmp_path / "list", rises, forces, code=4)
    rows = table(tmp_path / "list/creep.csv")
    assert numbers(rows, "force_x") == pytest.approx([-2.9e3, 2.5e3, -1e3, -3.9e3], rel=1e-5)
    assert float(rows[0]["creep"]) == pytest.approx(0.045, rel=1e-3)
    assert "4.1 kN cannot be carried: friction allows less than 4 kN" in done.stderr
    (given,) = creep_rows(case, tmp_path / "given", rises, f"creep={rows[0]['creep']}")
    assert float(given["force_x"]) == pytest.approx(-2.9e3, rel=1e-5)
    both = ("force.longitudinal=-2.5 kN", "force.lateral=1 kN")
    (row,) = creep_rows(case, tmp_path / "both", rises, *both)
    assert [float(row[name]) for name in ("force_x", "force_y")] == pytest.approx([-2500, 1000])


def test_a_layer_that_yields_heats_by_what_it_carries(tmp_path):
    """Where all slides the averaged models agree."""
    case = tmp_path / "case.yaml"
    case.write_text(CASE.replace("[1e-3]", "[5e-2]"), encoding="utf-8")
    layer = "layer={thickness: 1 um, shear_modulus: 1 GPa, yield_stress: 30 MPa}"
    for mode in ("mode=frozen", "mode=moving"):
        rises = [
            float(row["temperature_rise"])
            for model in ("averaged", "averaged_power")
            for row in creep_rows(
                case, tmp_path / model, layer, f"thermal={{model: {model}}}", mode, "cells=24"
            )
        ]
        assert rises[0] == pytest.approx(rises[1], rel=0.01)


def test_wear_depth_of_travelling_surfaces_is_the_largest_mean(tmp_path):
    """Of the second of two passes, from the fields of each of its steps: the row across the track
    whose mean is largest, which is less than the mean of what is largest in each."""
    case = tmp_path / "case.yaml"
    case.write_text(CASE.replace("creep: [1e-3]\n", ""), encoding="utf-8")
    rough = (f"roughness={ROUGH[:-1]}, boxes: 4}}", "contact.domain=5", "cells=40", "mode=moving")
    wear = ("wear={law: archard, coefficient: 1e-4, hardness: 3 GPa}",)
    twice = ("moving.passes=2", "creep=2e-2")
    (row,) = creep_rows(case, tmp_path / "out", *rough, *wear, *twice)
    ends = numbers(table(tmp_path / "out/series.csv"), "time")
    instants = ", ".join(f"{end:.9g} s" for end in ends[len(ends) // 2 :])
    lists = f"time: [0 s, {ends[-1]:.9g} s], creep: [2e-2, 2e-2], fields: [{instants}]"
    run(case, tmp_path / "fields", *rough, f"sequence={{{lists}}}", "fields=last")
    worn = []
    for path in sorted((tmp_path / "fields").glob("fields_0001_*.vti")):
        kept = fields.read_vti(path)
        slip = numpy.hypot(kept.arrays["slip"][..., 0], kept.arrays["slip"][..., 1])
        worn.append((1e-4 / 3e3 * kept.arrays["pressure"] * slip).sum(axis=1) * kept.dx * 1e6)
    worn = numpy.array(worn)
    assert len(worn) == len(ends) // 2
    depth = float(row["wear_depth"])
    assert depth == pytest.approx(worn.mean(axis=0).max(), rel=1e-3)
    assert depth < 0.995 * worn.max(axis=1).mean()
