# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases of CONTACT that go on from each other, gaps of points, and cases that are refused while the
others of their file are converted."""

import pytest

from patch_runs import wr_creep
from test_contact_inp import HEAT, SOFT, STEEL, block, converted, solved

GRID = "1\n 34 33 -4.125 -4.125 0.25 0.25\n 1 1\n .002963 0. .002963 0. 0. 0."
ROLLS = "0. 0.25 30000."
FALLS = {"friction": "0.2 0.2 100. 0. 1.\n 0.02 0.", "physics": "422020"}
ROWS = {"friction": "", "physics": "2022020", "grid": GRID + "\n 0.3 0.3" * 33}
HOT = {
    "friction": ".3 0. -.18 400.\n 0. 1.",
    "physics": "622020",
    "material": f"{SOFT}\n{HEAT}",
    "flow": "3001341",
}


def rolls(control, drive="0.4705 0.003 0. 0.", **how):
    how = {"friction": "0.4013 0.4013", "material": SOFT, "grid": GRID, "rolling": ROLLS} | how
    parts = [how.pop(name) for name in ("friction", "material", "grid")]
    return block(control, drive, *parts, **how)


def points(height, cells=24, size=0.5):
    """A grid around 0 and the gap of each of its cells."""
    corner = -0.5 * cells * size
    middles = [corner + (k + 0.5) * size for k in range(cells)]
    values = "\n".join(" ".join(f"{height(x, y):.12g}" for x in middles) for y in middles)
    return f"1\n {cells} {cells} {corner} {corner} {size} {size}\n 9 1\n{values}"


@pytest.mark.parametrize("law", [FALLS, ROWS, HOT], ids=["falling", "rows", "hot"])
def test_forces_of_steps_need_one_coefficient(tmp_path, law):
    done = converted(tmp_path, rolls("202110", "0.4705 -0.5 0. 0.", **law), code=3)
    assert "a.inp:3: F = 1: forces need one coefficient of friction (case 1)" in done.stderr
    assert not (tmp_path / "case_001.yaml").exists()


@pytest.mark.parametrize(
    "what, other",
    [
        ("friction", {"friction": "0.1 0.1"}),
        ("friction", FALLS),
        ("friction", ROWS),
        ("friction", HOT),
        ("material", {"material": "0.28 0.28 1. 2."}),
        ("material", {"material": f"{SOFT}\n 1. 1. 0. 0.", "physics": "022420"}),
        ("heat", {"material": f"{SOFT}\n{HEAT}", "flow": "3001341"}),
        ("grid", {"grid": GRID.replace("34 33", "36 33")}),
        ("gap", {"grid": GRID.replace(".002963 0. .002963", ".003 0. .003")}),
    ],
)
def test_steps_that_go_on_differ_in_their_drive_only(tmp_path, what, other):
    """The first steps are converted; what differs is told with the line of its case."""
    first, later = rolls("202100"), rolls("002100", "0.47 0.002 0. 0.", **other)
    done = converted(tmp_path, first, rolls("002100", "0.47 0.002 0. 0."), later, code=3)
    line = 3 + first.count("\n") * 2
    said = f"a.inp:{line}: P = 0: the {what} differs from that of the case it goes on from (case 3)"
    assert said in done.stderr, done.stderr
    text = (tmp_path / "case_001.yaml").read_text(encoding="utf-8")
    assert "cases 1 to 2" in text and "mu: 0.4013" in text


@pytest.mark.parametrize(
    "what, friction, material",
    [
        ("friction", "0.05 0.05", "0.42 0.3 200. 400."),
        ("material", "0.4 0.4", "0.42 0.3 300. 400."),
    ],
)
def test_stages_that_go_on_differ_in_their_load_only(tmp_path, what, friction, material):
    first = block("201100", "9.2 0 0 0", "0.4 0.4", "0.42 0.3 200. 400.", GRID)
    later = block("001100", "12. 0 0 0", friction, material, GRID)
    done = converted(tmp_path, first, later, code=3)
    assert (
        f"P = 0: the {what} differs from that of the case it goes on from (case 2)" in done.stderr
    )


def test_a_shift_between_steps_is_refused(tmp_path):
    under_force = {"drive": "0.4705 -0.5 0. 0."}
    shift = rolls("001110", **under_force, rolling="")
    step = rolls("002110", **under_force)
    said = converted(tmp_path, shift.replace("001110", "201110"), shift, step, code=3).stderr
    assert "T = 1: a shift after others, before steps of rolling" in said
    said = converted(tmp_path, step.replace("002110", "202110"), shift, code=3).stderr
    assert "T = 2: a shift after steps of rolling is not converted" in said


def test_steps_of_rolling_that_wr_creep_refuses(tmp_path):
    """Under an approach, and of a gap that would travel with the rail."""
    done = converted(tmp_path, rolls("202000", "0.011 0.003 0. 0."), code=3)
    assert "T = 2, N = 0: steps under an approach are not in wr_creep" in done.stderr
    gap = points(lambda x, y: 0.002963 * (x * x + y * y))
    done = converted(tmp_path, rolls("202100", grid=gap, rolling="0. 0.5 30000."), code=3)
    assert "T = 2: a gap of points would travel in steps of rolling" in done.stderr


def test_a_gap_of_points_is_turned_with_the_case(tmp_path):
    """The same contact, rolling to -x and turned by hand."""

    def gap(x, y):
        return 0.002963 * (x * x + y * y) + 1e-4 * (0.5 * x**3 + y**3)

    converted(
        tmp_path,
        rolls("203100", "0.4705 0.003 0.001 0.0002", grid=points(gap), rolling="180d 0.5 30000."),
        rolls(
            "203100",
            "0.4705 -0.003 -0.001 0.0002",
            grid=points(lambda x, y: gap(-x, -y)),
            rolling="0d 0.5 30000.",
        ),
    )
    (turned,), (by_hand,) = (solved(tmp_path, number) for number in (1, 2))
    assert abs(turned["moment_z"]) > 0.05
    for name in ("force_x", "force_y", "moment_z", "traction_ratio", "stick_fraction"):
        assert turned[name] == pytest.approx(by_hand[name], rel=1e-6), name


@pytest.mark.parametrize("control", ["203100", "203000"], ids=["load", "approach"])
def test_the_nominal_ellipse_of_a_gap_of_points_is_that_of_its_contact(tmp_path, control):
    """So that means over it are those of the contact, and no radius is doubted: as with curvatures,
    but for what 0.4 mm wide cells tell of 12 and 18 mm."""
    drive = {"203100": "100000. -0.01 0. 0.", "203000": "0.08 -0.01 0. 0."}[control]
    curved = "1\n 40 40 -12. -12. 0.6 0.6\n 1 1\n 0.001 0. 0.0005 0. 0. 0."
    cases = [
        rolls(
            control,
            drive,
            material=f"{STEEL}\n{HEAT}",
            flow="3001341",
            grid=grid,
            rolling="0. 0.6 20000.",
        )
        for grid in (curved, points(lambda x, y: 0.001 * x * x + 0.0005 * y * y, 40, 0.6))
    ]
    converted(tmp_path, *cases)
    (exact,), (fitted,) = (solved(tmp_path, number) for number in (1, 2))
    assert fitted["force_x"] == pytest.approx(exact["force_x"], rel=1e-6)
    assert fitted["temperature_rise"] == pytest.approx(exact["temperature_rise"], rel=0.05)
    done = wr_creep(tmp_path / "case_002.yaml", "-o", tmp_path / "again", "-q")
    assert "rolling radius" not in done.stderr


@pytest.mark.parametrize("load", ["0.01", "0.3"])
@pytest.mark.parametrize(
    "height",
    [
        lambda x, y: 0.1 * abs(x) + 0.1 * abs(y),
        lambda x, y: 0.02 * ((abs(x) - 3.0) ** 2 + y * y),
        lambda x, y: 0.02 * ((x - 4.0) ** 2 + (y + 4.0) ** 2),
        lambda x, y: 0.02 * ((x - 4.0) ** 2 + 0.2 * y * y),
        lambda x, y: 2e-4 * ((x - 0.2) ** 4 + y**4),
    ],
    ids=["pyramid", "two", "in a corner", "at a side", "flat in the middle"],
)
def test_gaps_of_any_form_have_a_nominal_ellipse(tmp_path, height, load):
    """In which some of the contact lies, and no fewer cells than wr_creep needs."""
    how = {"flow": "3001341", "rolling": "0. 0.5 30000.", "grid": points(height)}
    converted(tmp_path, rolls("203100", f"{load} -0.1 0. 0.", material=f"{SOFT}\n{HEAT}", **how))
    (row,) = solved(tmp_path)
    assert 0.0 < row["temperature_rise"] < row["temperature_max"]


GOOD = rolls("203100")
OTHERS = {
    "planform": (rolls("203100", grid=GRID.replace(" 1 1\n", " 1 2\n")), "IPLAN = 2: 1 is read"),
    "other terms": (
        rolls("203100", grid=GRID.replace(".002963 0.", ".002963 .001")),
        "IBASE = 1: a gap B1 x2 + B3 y2 is read, without more",
    ),
    "other gap": (rolls("203100", grid=GRID.replace(" 1 1\n", " 3 1\n")), "IBASE = 3: 1, 2 and 9"),
    "other grid": (rolls("203100", grid="7\n 9 9"), "IPOTCN = 7: "),
    "arc": (
        rolls("203100", grid="1\n 9 9 -1 -1 .2 .2\n 2 1\n 2 0 0 -1 .1\n 7 8"),
        "IBASE = 2: RM is not 0",
    ),
    "kinetic friction of a row": (
        rolls("203100", friction="", physics="2022020", grid=GRID + "\n 0.3 0.2" * 33),
        "FKIN is not FSTAT: one coefficient",
    ),
}


@pytest.mark.parametrize("name", OTHERS)
def test_one_case_is_refused_and_the_others_are_written(tmp_path, name):
    case, said = OTHERS[name]
    error = converted(tmp_path, GOOD, case, GOOD, code=3).stderr
    assert said in error and "(case 2)" in error, error
    names = sorted(path.name for path in tmp_path.glob("*.yaml"))
    assert names == ["case_001.yaml", "case_003.yaml"]


def test_what_a_case_keeps_and_no_former_one_has(tmp_path):
    """Rows and a gap of points without a grid in mm, and a new grid without a gap."""
    no_grid = rolls("203100", friction="", physics="2000000", grid="", material="", rolling="")
    hertz = rolls("203100", grid="-3\n 9 9 3. 3. 1.2")
    gap = rolls("203100", friction="", physics="100020", material="", rolling="",
                grid=" 9 1\n" + " 0." * 81)  # fmt: skip
    no_gap = rolls("203100", physics="022000", grid=GRID.split(" 1 1\n")[0].rstrip())
    error = converted(tmp_path, no_grid, hertz, gap, no_gap, code=3).stderr
    for said in (
        "V = 2: the grid of a former case that is not there (case 1)",
        "IBASE = 9: a gap needs a grid of IPOTCN 1 to 4 (case 3)",
        "gap of a former case on this grid that is not there (case 4)",
    ):
        assert said in error, error
    assert [path.name for path in tmp_path.glob("*.yaml")] == ["case_002.yaml"]
