# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases of CONTACT (github.com/eve70a/CONTACT, 2025) from its input files on: the numbers and the
counts of cells that its reference outputs print, none off in a printed digit unless it says why."""

import math
import subprocess

import numpy
import pytest

from patch_runs import SOURCE, table, wr_creep

STEEL = "0.28 0.28 82000. 82000."
SOFT = "0.28 0.28 1. 1."
BALL = "1 1\n 0.0056566 0. 0.0056566 0. 0. 0."


def block(
    control, drive, friction, material, grid, *, physics="022020", flow="0001341", rolling=""
):
    """One case as an input has it: our own lines with CONTACT's numbers."""
    lines = [
        " 3  MODULE",
        f" {control}  P-B-T-N-F-S",
        f" {physics}  L-D-C-M-Z-E",
        f" {flow}  H-G-I-A-O-W-R",
    ]
    solver = flow.rjust(7, "0")[1]
    if solver != "1":
        lines.append(" 200 100 30 1 1e-6   MAXGS, MAXIN, MAXNR, MAXOUT, EPS")
    if solver in "2345":
        lines.append(" 1.0 0.05 1 2.0 -1.0  settings of that solver")
    lines += [drive, friction, rolling, material, grid]
    return "\n".join(line for line in lines if line) + "\n"


def converted(tmp_path, *cases, code=0):
    (tmp_path / "a.inp").write_text(
        "% ours\n\n" + "".join(cases) + " 0  MODULE\n", encoding="utf-8"
    )
    done = subprocess.run(
        ["/usr/bin/python3", SOURCE / "tools/contact_inp.py", tmp_path / "a.inp", "-o", tmp_path],
        capture_output=True,
        text=True,
    )
    assert done.returncode == code, done.stderr
    return done


def solved(tmp_path, number=1, name="creep", options=()):
    """Rows of a table, as numbers."""
    case, out = tmp_path / f"case_{number:03d}.yaml", tmp_path / f"out{number}"
    done = wr_creep(case, "-o", out, "-q", *options)
    assert done.returncode == 0, done.stderr
    rows = table(out / f"{name}.csv")
    return [{k: float(v) for k, v in row.items()} for row in rows]


def printed(value, digits=4):
    """A number as CONTACT prints it, within a tenth of the last digit's half for its rounding."""
    unit = 10.0 ** (math.floor(math.log10(abs(value))) - digits + 1)
    return pytest.approx(value, abs=0.55 * unit)


def cells(row, area):
    """(in contact, sticking)"""
    count = row["real_area"] / area
    return round(count), round(count * row["stick_fraction"])


def test_cattaneo(tmp_path):
    plastic = "0.42 0.42 200. 200."
    hertz = block("200100", "9.1954 0 0 0", "0.4 0.4", plastic, "-3\n 19 19 1. 1. 1.26667")
    shift = block(
        "201120",
        "9.1954 -0.875 0 0  FN, FX",
        "0.4 0.4",
        plastic,
        "1\n 19 19 -1.26667 -1.26667 .13333 .13333\n 1 1\n 0.01 0. 0.01 0. 0. 0.",
    )
    converted(tmp_path, hertz, shift)
    (row,) = solved(tmp_path, 1, "static")
    assert row["peak_pressure"] == printed(4.393) and row["approach"] == pytest.approx(
        1.998e-2, rel=1e-3
    )
    (row,) = solved(tmp_path, 2, "static")
    assert row["approach"] == printed(1.998e-2) and row["peak_pressure"] == printed(4.393)
    assert row["shift_x"] == printed(8.155e-3)
    assert row["force_x"] == pytest.approx(-0.875 * 0.4 * 9.1954, rel=1e-6)
    assert cells(row, 0.13333**2) == (177, 45)


def test_shipped_example_is_cattaneos(tmp_path):
    example = (SOURCE / "examples/wheelrail/shift.inp").read_text(encoding="utf-8")
    converted(tmp_path, example[: example.index(" 0  MODULE")])
    (row,) = solved(tmp_path, 1, "static")
    assert row["shift_x"] == printed(8.155e-3) and cells(row, 0.13333**2) == (177, 45)


def test_testbank_1_approach(tmp_path):
    converted(
        tmp_path,
        block(
            "201000",
            ".01131 .00304 .0 .0  PEN",
            ".3 .3",
            STEEL,
            f"1\n 17 17 -1.13333 -1.13333 .13333 .13333\n {BALL}",
            flow="000341",
        ),
    )
    (row,) = solved(tmp_path, 1, "static")
    assert row["load"] == printed(1720.0) and row["force_x"] == printed(-451.5)
    assert row["peak_pressure"] == printed(821.0)
    assert cells(row, 0.13333**2) == (177, 45)


def test_testbank_7_steady(tmp_path):
    converted(
        tmp_path,
        block(
            "203100",
            "0.4705 -0.00304 0 0",
            "0.4013 0.4013",
            SOFT,
            "1\n 41 41\n -4.1 -4.1\n 0.2 0.2  dx, dy\n 1 1\n .002963 0. .002963\n 0 0 0",
            rolling="0. 0.2 1000.",
        ),
    )
    (row,) = solved(tmp_path)
    assert row["force_x"] / (0.4013 * 0.4705) == printed(0.6466)
    assert cells(row, 0.04) == (973, 555)


def test_testbank_8_friction_of_each_row(tmp_path):
    friction = "\n".join(
        f" {0.2 + 0.01 * k:.3f} {0.2 + 0.01 * k:.3f}  FSTAT, FKIN" for k in range(41)
    )
    grid = "1\n 51 41 -4.1 -4.1 0.2 0.2\n 1 1\n .002963 0. .002963 0. 0. 0.\n" + friction
    converted(
        tmp_path,
        block(
            "203100",
            "0.4705 -0.00304 0 0",
            "",
            SOFT,
            grid,
            physics="2022020",
            rolling="0. 0.2 1000.",
        ),
    )
    (row,) = solved(tmp_path)
    assert row["force_x"] == printed(0.1206) and row["force_x"] / 0.4705 == printed(0.2563)
    assert row["force_y"] == printed(3.864e-4) and row["moment_z"] == printed(-1.946e-2)
    assert row["approach"] == printed(7.258e-2) and row["peak_pressure"] == printed(1.834e-2)
    assert row["power"] * 1e3 == printed(3.359e-4 * 1e3)  # N mm/s as N m/s
    assert cells(row, 0.04) == (973, 534)


def test_testbank_9_unlike_bodies_with_spin(tmp_path):
    converted(
        tmp_path,
        block(
            "203110",
            "2.468 -0.4718 0. 0.1000E-03  FN, FX",
            "0.6 0.6",
            "0.1 0.28 1. 0.8100E+05",
            "1\n 25 25 -13.75 -13.75 1.1 1.1\n 1 1\n 0.3332E-03 0 0.3332E-03 0 0 0",
            rolling="0. 1.1 1000.",
        ),
    )
    (row,) = solved(tmp_path)
    assert row["creep"] == printed(2.827e-4)
    assert row["force_x"] == printed(-0.6986) and row["force_y"] == printed(-0.2610)
    assert row["moment_z"] == printed(-1.470) and row["approach"] == printed(7.607e-2)
    assert row["peak_pressure"] == printed(1.199e-2)
    assert cells(row, 1.21) == (292, 140)


def test_testbank_10_and_11(tmp_path):
    """Corners in place of sizes; then the approach is given beside a force, and the shift goes on.
    From rest a force ratio pushes the wheel to -x; one to +x is turned by half a turn."""
    grid = f"2\n 17 17 -1.13333 -1.13333 1.13333 1.13333\n {BALL}"
    under_load = block("201120", "1722. -.875 0 0  FN, FX", ".3 .3", STEEL, grid)
    goes_on = block("001020", "0.01131 -.875 0 0  PEN, FX", ".3 .3", STEEL, grid)
    converted(tmp_path, under_load, goes_on)
    before, row = solved(tmp_path, 1, "series")
    area = (2.26666 / 17) ** 2
    assert before["shift_x"] == printed(3.042e-3) and before["force_x"] == printed(-452.0)
    assert before["approach"] == printed(1.132e-2) and before["peak_pressure"] == printed(821.4)
    assert cells(before, area) == (177, 45)
    assert row["load"] == printed(1720.0) and row["force_x"] == printed(-451.4)
    assert row["peak_pressure"] == printed(821.0) and row["approach"] == 0.01131
    assert row["shift_x"] - before["shift_x"] == pytest.approx(-2.826e-6, rel=0.02)
    assert cells(row, area) == (177, 45)
    converted(tmp_path, goes_on.replace("001020", "201020"))
    (row,) = solved(tmp_path, 1, "static")
    assert row["load"] == printed(1720.0) and row["force_x"] == printed(-451.4)
    assert cells(row, area) == (177, 45)
    text = (tmp_path / "case_001.yaml").read_text(encoding="utf-8")
    converted(tmp_path, goes_on.replace("001020", "201020").replace("-.875", ".875"))
    turned = (tmp_path / "case_001.yaml").read_text(encoding="utf-8")
    assert "half a turn" in turned and "half a turn" not in text


def test_stages_that_are_refused(tmp_path):
    grid = f"2\n 17 17 -1.13333 -1.13333 1.13333 1.13333\n {BALL}"
    first = block("201120", "1722. -.875 0 0", ".3 .3", STEEL, grid)
    for drive, said in (
        ("1722. -.5 0 0", "under one force along x"),
        ("1722. -.875 .1 0", "under one force along x"),
    ):
        later = block("001120", drive, ".3 .3", STEEL, grid)
        assert said in converted(tmp_path, first, later, code=3).stderr


# creep x 1e3 after so many steps
ROLLED = {1: 1.824, 2: 1.882, 5: 2.140, 10: 2.676, 14: 3.403, 24: 3.062, 33: 3.111, 56: 3.101}


@pytest.mark.long
def test_catt_to_cart(tmp_path):
    """A shift, and 56 steps of rolling that go on from it under the same force."""
    grid = "1\n 34 33 -4.125 -4.125 0.25 0.25\n 1 1\n .002963 0. .002963 0. 0. 0."
    shift = block("201120", "0.4705 -0.657 0 0", "0.4013 0.4013", SOFT, grid)
    step = block(
        "002120", "0.4705 -0.657 0 0", "0.4013 0.4013", SOFT, grid, rolling="0. 0.25 1000."
    )
    converted(tmp_path, shift, *[step] * 56)
    rows = solved(tmp_path, 1, "series")
    assert len(rows) == 56
    for number, creep in ROLLED.items():
        assert 1e3 * rows[number - 1]["creep"] == printed(creep), number
    assert cells(rows[-1], 0.0625) == (621, 346)


@pytest.mark.parametrize("turned", [False, True])
def test_steps_that_differ(tmp_path, turned):
    """Each has a load and a force of its own, and so has the shift; to -x they are turned."""
    grid = "1\n 36 33 -4.5 -4.125 0.25 0.25\n 1 1\n .002963 0. .002963 0. 0. 0."
    rolling = ("180d" if turned else "0.") + " 0.25 1000."
    drives = [(0.4705, -0.3), (0.47, -0.6), (0.45, -0.2), (0.40, 0.1)]
    shift, *steps = [
        block(control, f"{load} {force} 0 0", "0.4 0.4", SOFT, grid, rolling=way)
        for (load, force), control, way in zip(
            drives, ["201120"] + ["002120"] * 3, [""] + [rolling] * 3
        )
    ]
    converted(tmp_path, shift, *steps)
    rows = solved(tmp_path, 1, "series")
    assert len(rows) == 3
    sign = -1 if turned else 1
    for row, (load, force) in zip(rows, drives[1:]):
        assert row["load"] == pytest.approx(load, rel=1e-6)
        assert row["force_x"] == pytest.approx(sign * force * 0.4 * load, abs=1e-5 * 0.4 * load)


def test_fastsim_1_and_what_is_refused(tmp_path):
    grid = "-3\n 44 44 8. 4. 1.1  MX,MY,AA,BB,SCALE"
    drive, rolling = "82000. 0. -0.000625 0.000625", "0. 0.4 30000."
    exact = block("203100", drive, "0.3 0.3", STEEL, grid, rolling=rolling)
    simple = block(
        "233100", drive, "", f"{STEEL}\n 1. 1. 1.", grid, physics="122320", rolling=rolling
    )
    said = converted(tmp_path, exact, simple, code=3).stderr
    assert "a.inp:15: B = 3: bounds other than mu p are not in wr_creep (case 2)" in said
    (row,) = solved(tmp_path)
    assert row["force_y"] / (0.3 * 82000) == printed(-0.6074) and row["moment_z"] == printed(
        -4.821e4
    )
    assert row["peak_pressure"] == printed(1223.0) and row["power"] == printed(540.4)
    assert cells(row, 0.4 * 0.2) == (1276, 356)


def test_tractcurv(tmp_path):
    """The ratio of axes in place of a curvature; from the second case on only the creep is said.
    The 31st has a falling friction with a memory and a layer."""
    grid = "-2\n 48 44 0.0008 0.5 1.1  MX,MY,A1,AOB,SCALE"
    rolling = "0. 0.5 10000."
    first = block("203100", "106700. 0.0004 0 0", "0.33 0.33", STEEL, grid, rolling=rolling)
    more = [
        block("203100", f"106700. {creep} 0 0", "", "", "", physics="100000", flow="0100341")
        for creep in (0.0012, 0.002, 0.0028)
    ]
    layer = block(
        "203100",
        "106700. 0.002 0 0",
        "0.14 0.19 1250. 0. 0.\n 0.003 1.",
        f"{STEEL}\n 8200. 1.25 0. 0.",
        grid,
        physics="422420",
        flow="0100341",
        rolling=rolling,
    )
    converted(tmp_path, first, *more, layer)
    references = ((0.2588, 1182), (0.6482, 782), (0.8816, 422), (0.9832, 132))
    for number, (force, stick) in enumerate(references, 1):
        (row,) = solved(tmp_path, number)
        assert -row["force_x"] / (0.33 * 106700) == printed(force)
        assert round(1384 * row["stick_fraction"]) == stick
    (row,) = solved(tmp_path, 5)
    assert row["force_x"] == printed(-12310.0) and round(1384 * row["stick_fraction"]) == 1250


ERTZ = "1\n 216 45 -7.9 -11.25 0.2 0.5\n 1 1\n 0.001015 0. 0.0004215 0. 0. 0."
WARM = "{} 450. 50e-3 7.85e-6  BKTEMP, HEATCP, LAMBDA, DENS"


@pytest.mark.long
def test_ertz(tmp_path):
    """It rolls to -x. 166.8 and 241.8 K are printed for the temperature: see wr_creep's page. What
    the warm wheel adds is 75.0 K of its 150; without sliding there is nothing else."""

    def heated(drive, temperature, **how):
        bodies = f"{WARM.format(0.0)}\n{WARM.format(temperature)}"
        return block(
            "203100",
            drive,
            how.get("friction", ""),
            f"{how.get('material', '')}\n{bodies}".strip(),
            how.get("grid", ""),
            physics=how.get("physics", "100000"),
            flow=how.get("flow", "3102241"),
            rolling=how.get("rolling", ""),
        )

    cases = [
        heated(
            "100000. -0.03333 0 0",
            0.0,
            friction="0.3 0.3",
            material=STEEL,
            grid=ERTZ,
            physics="022020",
            flow="3002241",
            rolling="180.d 0.2 30000.",
        ),
        heated("100000. 0 0 0", 150.0),
        heated("100000. -0.03333 0 0", 150.0),
        block(
            "203100", "100000. -0.002 0.001 0.0002", "", "", "", physics="100000", flow="1102241"
        ),
    ]
    converted(tmp_path, *cases)
    hot, warm, both, partial = (solved(tmp_path, number)[0] for number in (1, 2, 3, 4))
    assert -hot["force_x"] == printed(3.0e4) and hot["power"] == printed(2.994e4)
    assert hot["approach"] == printed(8.190e-2) and hot["peak_pressure"] == printed(770.6)
    assert hot["temperature_max"] == pytest.approx(152.34, abs=0.1)
    assert warm["temperature_max"] == pytest.approx(75.0, abs=1e-9) and abs(warm["force_x"]) < 1e-6
    assert both["temperature_max"] - hot["temperature_max"] == pytest.approx(
        241.8 - 166.8, abs=1e-6
    )
    # turned: longitudinal and lateral forces have the other sign
    assert -partial["force_x"] / 3e4 == printed(0.7274) and -partial["force_y"] / 3e4 == printed(
        -0.1492
    )
    assert partial["moment_z"] == printed(-4.626e4) and partial["power"] == printed(1672.0)
    assert cells(partial, 0.1) == (1969, 770)


def test_carter2d(tmp_path):
    """A row of cells is a line contact; edges inside their cells are nearer to the exact 0.64 than
    CONTACT's 0.648."""
    converted(
        tmp_path,
        block(
            "203100",
            "35780. -0.00024 0 0",
            "0.3 0.3",
            STEEL,
            "3\n 55 1 -1.05 0. 0.04 200.\n 1 1\n 0.001 0. 0. 0. 0. 0.",
            rolling="0. 0.0401 30000.",
        ),
    )
    (row,) = solved(tmp_path)
    assert abs(row["traction_ratio"]) / 0.3 == pytest.approx(0.6402, abs=6e-5)


def test_bentall(tmp_path):
    """Rollers of aluminium and steel: the creep under a force, the traction at that creep; full
    sliding and partial slip. Edges inside their cells: without slip the creep is nearer to the
    exact 3.673e-4 than CONTACT's 3.591e-4."""
    grid = "1\n 216 1 -0.108 -500. 0.001 1000.\n 1 1\n 0.020 0. 0. 0. 0. 0."
    first = block("203100", "16201.9 0.00052 0 0", "1e-4 1e-4", "0.31 0.28 23000. 82000.", grid,
                  rolling="180.0d 0.001 1000.")  # fmt: skip
    after = [
        block("203110", f"16201.9 {force} 0 0", f"{mu} {mu}", "", "", physics="000000")
        for force, mu in ((0.0, 1e-4), (0.0, 10.0), (0.0, 0.05), (0.75, 0.05), (-0.75, 0.05))
    ]
    converted(tmp_path, first, *after)
    rows = [solved(tmp_path, number)[0] for number in range(1, 7)]
    assert rows[0]["creep"] == -0.00052
    # turned by half a turn; the force on the rail is that on CONTACT's body 1
    for row, creep in zip(rows[1:], (5.260e-4, None, 4.294e-4, 2.108e-4, 5.392e-4)):
        if creep:
            assert -row["creep"] == pytest.approx(creep, abs=1e-7)
    assert -rows[2]["creep"] == pytest.approx(3.673e-4, rel=2.5e-3)
    assert rows[4]["traction"] == pytest.approx(0.6076, abs=5e-5)
    assert rows[5]["traction"] == pytest.approx(-0.6076, abs=5e-5)
    sticking = [row["stick_fraction"] for row in rows[3:]]
    assert sticking == pytest.approx([125 / 200, 36 / 200, 106 / 201], abs=1.01 / 200)


@pytest.mark.long
def test_spence35(tmp_path):
    """A sphere that is pressed on in 35 stages; points below the surface are passed over. CONTACT's
    box lies 1e-4 mm off centre."""
    grid = "1\n 45 45 -4.4999 -4.4999 0.2 0.2\n 1 1\n 0.004116 0. 0.004116 0. 0. 0."
    points = " 1 0  MATFIL, OUTPUT\n 2  ISUBS\n 1 1 45\n 23 1 23\n 1 1e-6 1e-6\n 0  ISUBS\n"
    stages = [
        block("201103", "0.000011 0 0 0", "0.2986 0.2986", "0. 0. 0.5 100000.", grid) + points
    ]
    stages += [
        block("001101", f"{(k / 45) ** 3:.6f} 0 0 0", "", "", "", physics="100000", flow="0011111")
        for k in range(2, 36)
    ]
    converted(tmp_path, *[stage.replace("3  MODULE", "3  module") for stage in stages])
    rows = solved(tmp_path, 1, "series")
    assert len(rows) == 35 and rows[-1]["load"] == pytest.approx(0.470508)
    assert cells(rows[-1], 0.04) == (921, 225)
    for first, later in zip(rows, rows[1:]):
        assert later["real_area"] > first["real_area"]


def test_gap_across_and_twist(tmp_path):
    """The shift of tang_problm: an arc along x and a table across y, twisted, beside the gap as
    curvatures; and the gap of each cell."""
    heads = "1\n 31 33 -1.55 -1.65 0.1 0.1\n"
    across = " ".join(f"{0.002 * (0.1 * k - 2.0) ** 2:.9f}" for k in range(41))
    drive = ".00404 0.0005 -0.0010 0.0008  PEN, CKSI, CETA, CPHI"
    both = [
        block("201000", drive, ".3 .3", STEEL, heads + gap, flow="000241")
        for gap in (
            " 1 1\n .002 0. .002 0. 0. 0.",
            f" 2 1\n 41 0. 250. -2. 0.1  NN, XM, RM, Y1, DY1\n{across}",
            " 9 1\n"
            + "\n".join(
                f"{0.002 * ((0.1 * i - 1.5)**2 + (0.1 * j - 1.6)**2):.9f}"
                for j in range(33)
                for i in range(31)
            ),
        )
    ]
    converted(tmp_path, *both)
    curved, *tables = (solved(tmp_path, number, "static")[0] for number in (1, 2, 3))
    assert curved["twist"] == pytest.approx(8e-4)
    for row in tables:
        for name in ("load", "force_x", "force_y", "moment_z", "peak_pressure", "stick_fraction"):
            assert row[name] == pytest.approx(curved[name], rel=1e-5), name


def field(path):
    """The values of a .gsf file."""
    head = path.read_bytes()
    nx, ny = (int(head.split(name + b" = ")[1].split(b"\n")[0]) for name in (b"XRes", b"YRes"))
    return numpy.frombuffer(head[-4 * nx * ny :], dtype="<f4")


HEAT = " 0. 450. 50e-3 7.85e-6\n 0. 450. 50e-3 7.85e-6\n"


def test_friction_that_changes_with_the_temperature(tmp_path):
    """m3_tempdep 1, 2: a wheel that slides at 1 m/s. CONTACT prints .8660 mu N and 137.5 K, with a
    cell's own heat twice (test_ertz): without it the wheel is less hot and rubs more."""
    wheel = "1\n 80 45 -7.9 -11.25 0.2 0.5\n 1 1\n 0.001015 0 0.0004215 0 0 0"
    slides = "100000. -0.03333 0. 0."
    hot = {"physics": "622020", "flow": "3001341", "rolling": "180.d 0.2 30000."}
    plain = {**hot, "physics": "022020"}
    converted(
        tmp_path,
        block("203100", slides, ".3 .3", STEEL + "\n" + HEAT, wheel, **plain),
        block("203100", slides, ".3 0. -.18 400.\n 0. 1.", STEEL + "\n" + HEAT, wheel, **hot),
    )
    (cold,), (warm,) = (solved(tmp_path, number) for number in (1, 2))
    assert cold["traction_ratio"] == pytest.approx(0.3, rel=1e-4)
    share, rise = warm["traction_ratio"] / 0.3, warm["temperature_max"]
    assert 0.8660 < share < 1.0 and rise < 137.5
    mu, heated = (
        field(tmp_path / f"out2/fields_0001_{name}.gsf") for name in ("mu", "temperature")
    )
    touches = mu > 0.0
    assert mu[touches] == pytest.approx(0.3 - 0.18 / 400.0 * heated[touches], rel=1e-5)


def test_line_with_an_arc_and_a_memory(tmp_path):
    """veldep_fric: its gap is an arc along x and a table across y. Without a memory it is refused,
    as what goes on from steady rolling."""
    arc = "3\n 92 1 -4.6 0. 0.1 200.\n 2 1\n 2 0. 460. -10. 20.\n 0. 0."
    curved = "3\n 92 1 -4.6 0. 0.1 200.\n 1 1\n 1.0869565217391304e-3 0 0 0 0 0"
    drive, law = "622216. -0.0009999 0. 0.", ".18 .12 100. 0. 0.\n {} 1."
    falls = {"physics": "422020", "rolling": "0. 0.1 45000."}
    goes_on = block("002100", drive, "", "", "", physics="100000")
    done = converted(
        tmp_path,
        block("203100", drive, law.format("0.003"), STEEL, arc, **falls),
        block("203100", drive, law.format("0.003"), STEEL, curved, **falls),
        goes_on,
        block("203100", drive, law.format("0."), STEEL, arc, **falls),
        code=3,
    )
    assert "P = 0: going on from steady rolling, T = 3, is not converted (case 3)" in done.stderr
    assert "MEMDST = 0: without a memory friction that falls has several" in done.stderr
    (of_arc,), (of_curve,) = (solved(tmp_path, number) for number in (1, 2))
    for name in ("traction_ratio", "stick_fraction"):
        assert of_arc[name] == pytest.approx(of_curve[name], rel=1e-6)


def test_steady_rolling_has_no_history(tmp_path):
    """P = 0 of a steady case says nothing: each is a case of its own."""
    grid = "-3\n 9 9 1. 1. 1.2"
    rolls = {"rolling": "0. .2 30000."}
    converted(
        tmp_path,
        block("203100", "9.1 1e-3 0 0", ".3 .3", STEEL, grid, **rolls),
        block("003100", "9.1 2e-3 0 0", "", "", "", physics="100000"),
    )
    creeps = [solved(tmp_path, number)[0]["creep"] for number in (1, 2)]
    assert creeps == [1e-3, 2e-3]


def test_settings_of_other_solvers_are_passed_over(tmp_path):
    """ConvexGS (testbank 6), SteadyGS, veldep_fric's, GDsteady (tang_problm)."""
    converted(
        tmp_path,
        *[
            block("200100", "9.1 0 0 0", ".3 .3", STEEL, "-3\n 9 9 1. 1. 1.2", flow=flow)
            for flow in ("0000241", "0200241", "0300241", "0400241", "0500241")
        ],
    )
    plain, *others = (
        (tmp_path / f"case_{k:03d}.yaml").read_text(encoding="utf-8").splitlines()[1:]
        for k in range(1, 6)
    )
    assert others == [plain] * 4


def test_cases_of_an_earlier_call_go(tmp_path):
    """Also where they are refused now; a case file of one's own stays."""
    good = block("200100", "9 0 0 0", ".3 .3", STEEL, "-3\n 9 9 1. 1. 1.2")
    converted(tmp_path, good, good)
    (tmp_path / "case_mine.yaml").write_text("# mine\n")
    assert (tmp_path / "case_002.yaml").exists()
    text, _ = BAD["direction"]
    converted(tmp_path, good, text, code=3)
    assert sorted(path.name for path in tmp_path.glob("*.yaml")) == [
        "case_001.yaml",
        "case_mine.yaml",
    ]


BAD = {
    "module": (" 1 MODULE\n", "a.inp:3: MODULE 1: module 3 is read"),
    "control": (" 3 MODULE\n 2x3\n", "a.inp:4: CPBTNFS: '2x3' is not a control word"),
    "end": (" 3 MODULE\n 203100\n", "ends where"),
    "number": (
        block("200100", "9.1 zero 0 0", ".3 .3", STEEL, "-3\n 9 9 1. 1. 1.2"),
        "a.inp:8: 'zero' is not a number (FN, CKSI, CETA, CPHI)",
    ),
    "grid": (block("200100", "9 0 0 0", ".3 .3", STEEL, "7\n 9 9"), "IPOTCN = 7: "),
    "gap": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "1\n 9 9 -1 -1 .2 .2\n 3 1"),
        "IBASE = 3: 1, 2 and 9 are read",
    ),
    "cells": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "-3\n 9.5 9 1. 1. 1.2"),
        "a.inp:11: MX, MY: 9.5 is not allowed, must be a whole number from 1 to 16384",
    ),
    "no cells": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "2\n 9 9 1. 1. 0. 2.\n" + BALL),
        "a.inp:11: IPOTCN = 2: cells have no size",
    ),
    "table": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "1\n 9 9 -1 -1 .2 .2\n 2 1\n 1 0 9 -1 .1 7"),
        "a.inp:13: NN: 1 is not allowed",
    ),
    "arc": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "1\n 9 9 -1 -1 .2 .2\n 2 1\n 2 0 0 -1 .1 7 8"),
        "a.inp:13: IBASE = 2: RM is not 0, DY1 above 0",
    ),
    "kinetic": (
        block("200100", "9 0 0 0", ".3 .2", STEEL, "-3\n 9 9 1. 1. 1.2"),
        "FKIN is not FSTAT",
    ),
    "direction": (
        block("203100", "9 1e-3 0 0", ".3 .3", STEEL, "-3\n 9 9 1. 1. 1.2", rolling="90d .2 1."),
        "CHI = 90 degrees: 0 and 180 are converted",
    ),
    "no grid": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "", physics="002000"),
        "grid of a former case that is not there",
    ),
    "viscous": (block("200100", "9 0 0 0", "", "", "", physics="022120"), "a.inp:5: M = 1: only"),
    "lateral force on a line": (
        block(
            "203120",
            "16201.9 0. 0. 0",
            "0.3 0.3",
            STEEL,
            "1\n 216 1 -0.108 -500. 0.001 1000.\n 1 1\n 0.02 0 0 0 0 0",
            rolling="180.0d 0.001 1000.",
        ),
        "a line contact rolls steadily under a load, without a lateral force",
    ),
    "few cells": (  # plastic_3bl, testbank 3
        block("200100", "9 0 0 0", ".3 .3", STEEL, "-3\n 1 1 .5 .5 1."),
        "a.inp:3: MX, MY = 1, 1: at least 8 cells along a side",
    ),
    "small box": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "-3\n 9 9 .5 .5 1."),
        "a.inp:3: SCALE = 1: at least 1.05",
    ),
    "saddle": (
        block("200100", "9 0 0 0", ".3 .3", STEEL, "-1\n 9 9 .5 -.5 1.2"),
        "a.inp:3: a gap that closes to the sides, B1 or B3",
    ),
    "points on a line": (
        block(
            "203100",
            "9 1e-3 0 0",
            ".3 .3",
            STEEL,
            "1\n 9 1 -1 -.5 .2 1.\n 9 1\n" + " 0." * 9,
            rolling="0. .2 1.",
        ),
        "a.inp:3: a gap of points, or a hollow one, on a line is not converted",
    ),
    "no heat": (
        block(
            "203100",
            "9 0 0 0",
            ".3 0 -.1 400\n 0 1",
            STEEL,
            "-3\n 9 9 1. 1. 1.2",
            physics="622020",
            rolling="0. .2 1.",
        ),
        "a.inp:3: L = 6 needs the heat of this case",
    ),
    "after refused": (
        block("203200", "9 0 0 0", "", "", "")
        + block("001100", "9 0 0 0", ".3 .3", STEEL, "-3\n 9 9 1. 1. 1.2"),
        "P = 0: it goes on from a case that is refused (case 2)",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_what_cannot_be_done_is_refused_by_line(tmp_path, name):
    text, said = BAD[name]
    error = converted(tmp_path, text, code=3).stderr
    assert said in error and "Traceback" not in error, error
