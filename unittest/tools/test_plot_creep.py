# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_creep.py: a picture from creep.csv, or one clear line and no file."""

import subprocess
from pathlib import Path

import pytest

import forked_scripts
from matplotlib import collections
from script_calls import load

PLOT = Path(__file__).resolve().parents[2] / "tools" / "plot_creep.py"
HEAD = (
    "# units\nspeed,creep,traction_ratio,traction,mu_mean,temperature_rise,iterations,"
    "stick_fraction\n"
)
GOOD = (
    HEAD + "10,1e-4,0.02,80,0.33,0.1,3,0.97\n10,1e-3,0.2,800,0.33,2,3,0.6\n"
    "20,1e-3,0.2,800,0.33,3,3,0.6\n"
)


def plot(tmp_path, content):
    table, picture = tmp_path / "creep.csv", tmp_path / "a.png"
    if content is not None:
        table.write_text(content)
    return forked_scripts.run([PLOT, table, "-o", picture], tmp_path), picture


def test_picture(tmp_path):
    done, picture = plot(tmp_path, GOOD)
    assert done.returncode == 0, done.stderr
    assert picture.read_bytes()[:4] == b"\x89PNG"


@pytest.mark.parametrize(
    "content",
    [None, "", HEAD, "a,b\n1,2\n", HEAD + "10,1e-4,x,80,0.33,0.1,3,1\n", GOOD + "10,1e-4,0.0"],
    ids=["missing", "empty", "no rows", "other columns", "not a number", "cut"],
)
def test_bad_table(tmp_path, content):
    done, picture = plot(tmp_path, content)
    assert done.returncode == 3
    assert done.stderr.count("\n") == 1 and "creep.csv" in done.stderr
    assert not picture.exists()


def test_bands_of_several_curves_can_be_told_apart(tmp_path):
    """By bars, none of which stands where one of another band does."""
    from matplotlib import pyplot

    module = load("plot_creep.py")
    creep = [1e-4 * 1.1**k for k in range(60)]
    band = {"creep": creep, "low": [0.1] * 60, "high": [0.2] * 60}
    figure, axes = pyplot.subplots()
    for number in range(3):
        module.draw_band(axes, band, f"C{number}", number, 3)
    bars = [
        {segment[0][0] for segment in lines.get_segments()}
        for lines in axes.collections
        if isinstance(lines, collections.LineCollection)
    ]
    assert [len(places) for places in bars] == [10, 10, 10]
    assert not bars[0] & bars[1] and not bars[1] & bars[2] and not bars[0] & bars[2]
    pyplot.close(figure)


def test_a_band_of_other_results_is_not_drawn(call, tmp_path):
    """What an earlier run left beside a new curve is no band of it."""
    band = "# units\nspeed,creep,low,high\n{}\n"
    rows = "10,1e-4,{0},0.03\n10,1e-3,{0},0.3\n20,1e-3,{0},0.3"
    (tmp_path / "creep.csv").write_text(GOOD)
    words = (tmp_path / "creep.csv", "-o", tmp_path / "a.png")
    (tmp_path / "creep_band.csv").write_text(band.format(rows.format("0.01")))
    assert call("plot_creep.py", *words)[::2] == (0, "")
    with_band = (tmp_path / "a.png").read_bytes()
    for other in (rows.format("0.021"), rows.format("0.01").replace("20,1e-3", "20,2e-3")):
        (tmp_path / "creep_band.csv").write_text(band.format(other))
        code, _, err = call("plot_creep.py", *words)
        assert code == 0 and "not drawn" in err and err.count("\n") == 1
        assert (tmp_path / "a.png").read_bytes() != with_band


@pytest.mark.parametrize(
    "column, values, called",
    [
        ("profile", "12", ["speed 20 m/s, profile 1", "speed 20 m/s, profile 2"]),
        ("surface", "12", ["speed 20 m/s, surface 1", "speed 20 m/s, surface 2"]),
        ("load", ["5e4", "1e5"], ["speed 20 m/s, load 50000 N", "speed 20 m/s, load 100000 N"]),
        ("lateral", ["0", "0.01"], ["speed 20 m/s, lateral 0", "speed 20 m/s, lateral 0.01"]),
        ("spin", ["0", "0.1"], ["speed 20 m/s, spin 0 /mm", "speed 20 m/s, spin 0.1 /mm"]),
        ("load", ["5e4", "5e4"], None),
    ],
)
def test_a_curve_for_each_contact(tmp_path, column, values, called):
    """And a band for each; of one colour are only those whose seeds differ."""
    creeps, table, band = [0.001, 0.003, 0.01], tmp_path / "creep.csv", tmp_path / "creep_band.csv"
    numbers = [(value, creep) for value in values for creep in (creeps if called else creeps[:2])]
    rows = [f"20,{creep},{0.2 + 10 * creep},{value}\n" for value, creep in numbers]
    table.write_text(f"speed,creep,traction_ratio,{column}\n" + "".join(rows))
    limits = [f"20,{creep},0,1,{value}\n" for value, creep in numbers]
    band.write_text(f"speed,creep,low,high,{column}\n" + "".join(limits))
    drawn = load("plot_creep.py").curves_of(str(table), "", "-")
    if called is None:
        assert len(drawn) == 1
        return
    assert [style["label"] for _, _, style in drawn] == called
    assert len({style["color"] for _, _, style in drawn}) == 2
    for values, limits, _ in drawn:
        assert values["creep"] == limits["creep"] == creeps


def test_creepages_that_were_found_tell_no_curves_apart(tmp_path):
    """Under a lateral force lateral is another in each row."""
    table = tmp_path / "creep.csv"
    rows = "20,0.001,0.1,0.002\n20,0.002,0.2,0.005\n20,0.003,0.3,0.009\n"
    table.write_text("speed,creep,traction_ratio,lateral\n" + rows)
    ((values, _, style),) = load("plot_creep.py").curves_of(str(table), "own", "-")
    assert values["creep"] == [0.001, 0.002, 0.003] and style["label"] == "own, speed 20 m/s"


def test_negative_creep(call, tmp_path):
    """On a linear axis: a logarithmic one would hide it."""
    (tmp_path / "creep.csv").write_text(GOOD + "20,-1e-3,-0.2,800,0.33,3,3,0.6\n")
    code, _, err = call("plot_creep.py", tmp_path / "creep.csv", "-o", tmp_path / "a.png")
    assert code == 0 and err == ""
    call.refused(2, "plot_creep.py", tmp_path / "creep.csv", "--label", "a", "--label", "b")


def test_no_creep_but_0(call, tmp_path):
    (tmp_path / "creep.csv").write_text("speed,creep,traction_ratio\n10,0,0.1\n")
    code, _, err = call("plot_creep.py", tmp_path / "creep.csv", "-o", tmp_path / "a.png")
    assert code == 0 and err == ""


def test_control_characters_in_labels_are_shown_not_drawn(call, tmp_path):
    """matplotlib would warn of each on two lines."""
    (tmp_path / "creep.csv").write_text(GOOD)
    words = ("--label", "\x1b[31mred", "-o", tmp_path / "a.png")
    assert call("plot_creep.py", tmp_path / "creep.csv", *words)[::2] == (0, "")


MEASURED = "# source\ncreep_percent,traction_ratio\n0.5,0.25\n10,0.2\n"


@pytest.mark.parametrize(
    "text, columns, creeps",
    [
        (MEASURED, None, [0.005, 0.1]),
        (MEASURED.replace("creep_percent", "creep"), None, [0.5, 10]),
        ("T/N,slip %\n0.25,0.5\n0.2,10\n", ("slip %", "T/N"), [0.005, 0.1]),
        ("# creep: %\ncreep,traction_ratio\n0.5,0.25\n10,0.2\n", None, [0.005, 0.1]),
        ("# creep: 1\ncreep,traction_ratio\n0.5,0.25\n10,0.2\n", None, [0.5, 10]),
        ("# creep: %\ncreep; traction_ratio\n0,5;0,25\n10; 0,2\n", None, [0.005, 0.1]),
        ("# slip: %\nT\tslip\n0,25\t0,5\n0,2\t10\n", ("slip", "T"), [0.005, 0.1]),
        ("creep traction_ratio\n0.5   0.25\n10 0.2\n", None, [0.5, 10]),
    ],
)
def test_measured_points(tmp_path, text, columns, creeps):
    """From columns with the usual names, or others; per cent is understood."""
    (tmp_path / "m.csv").write_text(text)
    module = load("plot_creep.py")
    creep, ratio = module.measured(str(tmp_path / "m.csv"), columns)
    assert creep == pytest.approx(creeps) and ratio == [0.25, 0.2]


@pytest.mark.parametrize(
    "text, more, code, part",
    [
        (MEASURED, [], 0, ""),
        (
            MEASURED,
            ["--columns", "slip,T"],
            3,
            "m.csv: not a table of measured creep and T/N: 'slip'",
        ),
        (MEASURED, ["--columns", "slip"], 2, "two names of columns, CREEP,RATIO, are needed"),
        ("a\n", [], 3, "no points"),
        (MEASURED + "x,1\n", [], 3, "creep_percent: 'x' is not a decimal number"),
        ("# creep: %\n" + MEASURED, [], 3, "creep_percent: its unit is given once"),
        (MEASURED + "# creep_percent: %\n", [], 3, "line 5: creep_percent: is given once, before"),
        ("# creep: mm\ncreep,traction_ratio\n1,1\n", [], 3, "creep: 'mm'; 1 and % are allowed"),
        ("creep,traction_ratio\n0,5,0,1\n", [], 3, "4 cells, 2 are expected (a decimal comma is"),
        (
            "creep;traction_ratio\n0,5;0.1\n",
            [],
            3,
            "line 2: creep: '0,5' has a decimal comma; line 2: traction_ratio: '0.1' has a decimal",
        ),
    ],
)
def test_measured_points_are_drawn_or_refused(tmp_path, text, more, code, part):
    (tmp_path / "creep.csv").write_text(GOOD)
    (tmp_path / "m.csv").write_text(text)
    done = subprocess.run(
        [PLOT, "creep.csv", "--measured", "m.csv", "-o", "a.png", *more],
        text=True, capture_output=True, timeout=60, check=False, cwd=tmp_path,
    )  # fmt: skip
    assert done.returncode == code, done.stderr
    assert part in done.stderr
    assert (tmp_path / "a.png").exists() == (code == 0)
