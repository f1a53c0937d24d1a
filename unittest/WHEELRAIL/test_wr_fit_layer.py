# SPDX-License-Identifier: GPL-2.0-or-later
"""What wr_fit says of the run behind a number: whether its layer is a solid, how far it slid, when
it was worn smooth, of which materials it is."""

import csv
import json
import math

import pytest

import friction_logs
from campaign_parts.pack import packed
from wr_fit_run import one_line, warnings_of, wr_fit


def with_state(text, room=1.02, lost=0, flow=lambda k: 100.0 * k):
    """A log with the columns that newer ones have: the work of the drive in 400 rows is that of
    friction_log(), 2.5e5 MPa nm3."""
    head, rows = text[: text.index("\nstep")], text[text.index("\nstep") + 1 :].splitlines()
    names = f"{rows[0]} room lost flow_energy breaking_energy contact_energy"
    lines = [f"{row} {room} {lost} {flow(k)} {k} {2 * k}" for k, row in enumerate(rows[1:], 1)]
    return "\n".join([head, names, *lines]) + "\n"


@pytest.mark.parametrize(
    "more, warned",
    [
        ({}, None),
        ({"room": 0.98}, None),
        ({"room": 0.969}, "(0.969 of the solid's area, at least 0.970 is expected): automata sank"),
        ({"lost": 3}, "(3): automata left through the held or the driven rows"),
        ({"flow": lambda k: 100.0 * k - 2 * (k > 50)}, None),
        ({"flow": lambda k: 100.0 * k - 3000 * (k > 50)}, "of the work done): what flow, breaking"),
    ],
)
def test_a_layer_that_is_no_solid_is_warned_of(tmp_path, more, warned):
    log = tmp_path / "run.friction"
    log.write_text(with_state(friction_logs.friction_log(ns=60, grinding_in=0), **more))
    result = wr_fit(log, "--start-distance", 250, "-o", tmp_path / "fit.json")
    assert result.returncode == 0
    report = json.loads((tmp_path / "fit.json").read_text())["report"]
    if warned is None:
        assert result.stderr == "" and report["warnings"] == []
    else:
        assert report["warnings"] == warnings_of(result) and warned in result.stderr
        assert len(report["warnings"]) == 1
    run = report["points"][0]
    assert run["room"] == pytest.approx(more.get("room", 1.02))
    assert run["lost"] == more.get("lost", 0) and run["distance"] == pytest.approx(300)
    assert run["least_room"] == pytest.approx(0.97 - 15 * 1.2 / 206000)


def test_room_of_a_packed_log_follows_from_its_gap_and_command(tmp_path):
    """32 rows, 3 held and 3 driven: 27 distances of rows between the innermost."""
    text = friction_logs.friction_log(ns=60).replace(" -0.013\n", " -6.5\n")
    (tmp_path / "old.friction").write_text(text)
    (tmp_path / "packed.friction").write_text(
        packed(text, 4, "lmp -in in.friction -var rows 32 -var held 3 -var columns 40")
    )
    assert wr_fit(tmp_path, "-o", tmp_path / "fit.json").returncode == 0
    old, new = json.loads((tmp_path / "fit.json").read_text())["report"]["points"]
    assert old["room"] is None and new["gap"] == pytest.approx(-6.5)
    height = 27 * math.sqrt(0.75) * 2.5
    assert new["room"] == pytest.approx(1 - 6.5 / height, rel=1e-9)


@pytest.mark.parametrize(
    "ns, options, warned",
    [
        (8, (), "(40 nm): slid less than 250 nm in all"),
        (60, (), "less than 250 nm of sliding on"),
        (60, ("--start-distance", 100), "(from 100 nm on): are averaged from less than 250 nm"),
        (60, ("--start-distance", 250), None),
    ],
)
def test_short_sliding_is_warned_of(tmp_path, ns, options, warned):
    """By the distance v t, not by the time."""
    log = tmp_path / "run.friction"
    log.write_text(friction_logs.friction_log(ns=ns, grinding_in=0, grinding_time=1))
    warnings = warnings_of(wr_fit(log, *options))
    assert len(warnings) == (warned is not None), warnings
    assert warned is None or warned in warnings[0]


@pytest.mark.parametrize(
    "drift, noise, warned",
    [(0.012, 0, True), (-0.003, 0.01, True), (0.006, 0, False), (0, 1, False)],
)
def test_mu_that_drifts_is_warned_of(tmp_path, drift, noise, warned):
    """From 50 to 60 ns: 0.012 per ns are 11 % of the mean there, -0.003 12 %."""
    log = tmp_path / "run.friction"
    text = friction_logs.friction_log(v=5, ns=60, grinding_in=0, drift=drift, noise=noise)
    log.write_text(text)
    result = wr_fit(log, "--start-distance", 250, "-o", tmp_path / "fit.json")
    run = json.loads((tmp_path / "fit.json").read_text())["report"]["points"][0]
    told = f"(by {100 * run['drift']:+.0f} %): mu drifts over the part that is averaged"
    assert (told in result.stderr) == warned == ("drifts" in result.stderr), result.stderr
    if not noise:
        assert run["drift"] == pytest.approx(10 * drift / run["mu"], rel=1e-5)


def test_time_without_a_broken_link_is_worn_smooth(tmp_path):
    """Phases count in which the layer slides by an automaton: 2.5 nm, ten rows."""
    lines = friction_logs.friction_log(ns=60, grinding_in=0).splitlines(keepends=True)
    begin = [line[:1].isdigit() for line in lines].index(True)
    for k, line in enumerate(lines[begin:]):
        if k >= 1100 or 1030 <= k < 1036:  # of 1200: the last 100, and six rows before
            lines[begin + k] = line.replace(" 3456 2 1 ", " 3456 0 1 ")
    log = tmp_path / "run.friction"
    log.write_text("".join(lines))
    result = wr_fit(log, "--start-distance", 250, "-o", tmp_path / "fit.json")
    run = json.loads((tmp_path / "fit.json").read_text())["report"]["points"][0]
    assert run["smooth"] == pytest.approx(100 / 200)
    assert "(worn smooth for 50 % of the time): slide without a link broken" in result.stderr


@pytest.mark.parametrize(
    "p, strength, laws, packing, junctions",
    [
        (15, 92, "link: elastic_limit", "hex", 15 * 40 / 50.968),
        (12.7, 92, "link: elastic_limit", "hex", 12.7 * 40 / 50.968),  # 9.97
        (12.8, 92, "link: elastic_limit", "hex", 12.8 * 40 / 50.968),  # 10.05
        (12.8, 92, "link: 2.35", "hex", 12.8 * 40 / (2.35 * 92)),
        (0.5, 92, "link: elastic_limit", "fcc", 0.5 * 40 * 20 / 50.968),
        (0.5, 92, "link: none", "hex", None),
        (0.5, 92, "weld: none", "hex", None),
    ],
)
def test_a_fragment_that_is_too_narrow_is_warned_of(
    tmp_path, p, strength, laws, packing, junctions
):
    """By p W/(d sigma_link), in space p A/(d^2 sigma_link), of a log that says what links."""
    text = friction_logs.friction_log(p=p, strength=strength, ns=60, grinding_in=0)
    text = text.replace("packing: hex", f"packing: {packing}").replace("preset: B", laws)
    if packing == "fcc":
        text = text.replace("thickness: 1,", "thickness: 50,")
    log = tmp_path / "run.friction"
    log.write_text(text)
    result = wr_fit(log, "--start-distance", 250, "-o", tmp_path / "fit.json")
    report = json.loads((tmp_path / "fit.json").read_text())["report"]
    found = report["points"][0]["junctions"]
    assert found == (junctions if junctions is None else pytest.approx(junctions))
    narrow = junctions is not None and junctions < 10
    told = f"({junctions or 0:.2g} junctions at once): mu scatters with less than 10"
    assert (told in result.stderr) == narrow and len(report["warnings"]) == narrow


def test_interfaces_make_a_condition(tmp_path):
    """Runs that differ in what two types have of their own are no replicas; the temperature of a
    packed log is a column."""
    for name, friction in (("a", "0.3"), ("b", "0.4"), ("c", "0.4")):
        text = friction_logs.friction_log(ns=60, seed=ord(name), grinding_in=0)
        line = "# interface: {types: 1 2, friction: " + friction + "}\n"
        text = text.replace("# loading", line + "# loading")
        if name == "c":
            text = packed(text, 4, "lmp", 873.5)
        (tmp_path / f"{name}.friction").write_text(text)
    table, report = tmp_path / "runs.csv", tmp_path / "fit.json"
    result = wr_fit(tmp_path, "--start-distance", 100, "-o", report, "--runs", table)
    conditions = json.loads(report.read_text())["report"]["conditions"]
    assert sorted(len(c["runs"]) for c in conditions) == [1, 2]
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if line[0] != "#"))
    assert [row["temperature"] for row in rows] == ["nan", "nan", "873.5"]
    assert result.returncode == 0


def test_two_materials_are_named(tmp_path):
    """Kappas are those of the weaker; runs that differ in the other one are no replicas."""
    other = (
        "# other_material: {youngs_modulus: 110000, poissons_ratio: 0.34, density: 8800, "
        "strength: STRENGTH, viscosity: 0.41, layer: other}\n"
    )
    for name, strength in (("a", "350"), ("b", "400")):
        text = friction_logs.friction_log(ns=60, seed=ord(name), grinding_in=0)
        (tmp_path / f"{name}.friction").write_text(
            text.replace("# loading", other.replace("STRENGTH", strength) + "# loading")
        )
    result = wr_fit(tmp_path, "--start-distance", 250, "-o", tmp_path / "fit.json")
    report = json.loads((tmp_path / "fit.json").read_text())["report"]
    assert "a.friction (sigma_0 92 and 350 MPa): of several materials" in report["warnings"][0]
    assert "2 of 2 runs" in result.stderr and "kappas are those of the weakest" in result.stderr
    assert len(report["conditions"]) == 2
    kappa1, kappa2 = friction_logs.kappas(15, 5, 92)
    assert report["points"][0]["kappa1"] == pytest.approx(kappa1)
    assert report["points"][0]["strengths"] == [92, 350]
    (tmp_path / "a.friction").write_text(text.replace("# loading", other + "# loading"))
    one_line(
        wr_fit(tmp_path / "a.friction"), 3, "a.friction:5: other_material: strength: 'STRENGTH' is"
    )
