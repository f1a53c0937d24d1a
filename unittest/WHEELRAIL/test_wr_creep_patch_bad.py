# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep with a point contact: what is refused, and what is warned of."""

import json
import re

import pytest
from patch_runs import CASE, ROUGH, SOURCE, run, wr_creep


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


MAPS = SOURCE / "unittest/WHEELRAIL/data/maps"
BAD = {
    "load unit": (
        {"10 kN": "10 kN/m"},
        ":1: contact.load: '10 kN/m': 'kN/m' is of another dimension than N",
    ),
    "no shape": ({"semi_axes: [3 mm, 4 mm], ": ""}, "contact.radii: is missing"),
    "two shapes": (
        {"semi_axes": "curvatures: [1 1/m, 1 1/m], semi_axes"},
        "contact.semi_axes: does not go with contact.curvatures",
    ),
    "line key": (
        {"semi_axes": "radius: 0.5 m, semi_axes"},
        "contact.radius: does not go with contact.load",
    ),
    "both loads": (
        {"load:": "load_per_length: 1 N/mm, load:"},
        "contact.load_per_length: does not go with",
    ),
    "three axes": (
        {"[3 mm, 4 mm]": "[3 mm, 4 mm, 5 mm]"},
        "contact.semi_axes: 3 values; [a, b] are expected",
    ),
    "flat": (
        {"semi_axes: [3 mm, 4 mm]": "radii: {wheel_rolling: 0.5 m}"},
        "add up to 0 1/m; above 0 is needed",
    ),
    "hollow": (
        {
            "semi_axes: [3 mm, 4 mm]": "radii: {wheel_rolling: 0.5 m, "
            "wheel_profile: -0.2 m, rail_profile: 0.3 m}"
        },
        "contact.radii",
    ),
    "zero radius": (
        {"semi_axes: [3 mm, 4 mm]": "radii: {wheel_rolling: 0.5 m, rail_profile: 0 m}"},
        "'0' is not allowed",
    ),
    "radius name": (
        {"semi_axes: [3 mm, 4 mm]": "radii: {wheel_roling: 0.5 m}"},
        "'contact.radii.wheel_rolling'",
    ),
    "points": ({"[32, 32]": "[32, 32, 32]"}, ":6: cells: 3 values"),
    "few points": ({"[32, 32]": "[32, 4]"}, "'4' is not in the allowed range [8,"),
    "creep": (
        {"creep: [1e-3]": "creep: 1 mm"},
        "neither a plain number nor one with a per cent sign",
    ),
    "creep range": (
        {"creep: [1e-3]": "creep: 2000 %"},
        "'2000 %' is not in the allowed range [-10, 10]",
    ),
    "spin unit": ({"creep: [1e-3]": "creep: 0\nspin: 0.1"}, "'0.1' has no unit; one like 1/m"),
    "series": (
        {"creep: [1e-3]": "creep: {from: -1e-3, to: 1e-3, n: 3}"},
        "creep.from: must be positive when spacing is log",
    ),
    "creep and force": (
        {"creep: [1e-3]": "creep: 0\nforce: {longitudinal: 1 N}"},
        "creep: does not go with force.longitudinal",
    ),
    "sequence frozen": (
        {"creep: [1e-3]": "creep: 0\nsequence: {time: [0 s, 1 s]}"},
        "mode moving or static is needed",
    ),
    "sequence order": (
        {"creep: [1e-3]": "mode: moving\ncreep: 0\nsequence: {time: [0 s, 2 s, 1 s]}"},
        "sequence.time: at least two instants",
    ),
    "sequence column": (
        {"creep: [1e-3]": "mode: moving\ncreep: 0\nsequence: {time: [0 s, 1 s], load: [1 N]}"},
        "sequence.load: 1 values",
    ),
    "static": ({"creep: [1e-3]": "mode: static"}, "static.force_ratio: is missing"),
    "shift": (
        {"creep: [1e-3]": "mode: static\nstatic: {shift: 1 um}"},
        "static.shift: 1 values; [x, y] are expected",
    ),
    "start": (
        {"creep: [1e-3]": "mode: moving\ncreep: 0\nmoving: {start: shift}"},
        "moving.start: 'shift' needs force",
    ),
    "constant": (
        {"creep: [1e-3]": "mode: moving\ncreep: 0\nmoving: {reference_length: 1}"},
        "moving.reference_length: does not go with",
    ),
    "fields": (
        {"fields: none": "fields: first"},
        "fields: 'first' is not allowed; none, last, all",
    ),
    "fields number": (
        {"fields: none": "fields: [2]"},
        "fields: '2' is above the number of operating points, 1",
    ),
    "two boxes": (
        {"load": "box: [8 mm, 9 mm], domain: 3, load"},
        "contact.domain: does not go with contact.box",
    ),
    "cell and box": (
        {"load": "cell: [1 mm, 1 mm], box: [8 mm, 9 mm], load"},
        "contact.box: does not go with contact.cell: cells and their number decide the box",
    ),
    "one cell": ({"load": "cell: 1 mm, load"}, "contact.cell: 1 values; [x, y] are expected"),
    "small box": ({"load": "box: [5 mm, 9 mm], load"}, "border of the box"),
    "coarse cells": (
        {"load": "cell: [2 mm, 1 mm], load"},
        "contact.cell: 3 cells for the width of the contact of 6 x 8 mm; at least 4 are needed",
    ),
    "centre": ({"load": "centre: 1 mm, load"}, "contact.centre: 1 values; [x, y] are expected"),
    "approach and load": (
        {"load": "approach: 20 um, load"},
        "contact.load: does not go with contact.approach: the load is found",
    ),
    "no approach": (
        {"load: 10 kN": "approach: 0 um"},
        "contact.approach: '0 um' is not in the allowed range [1e-12, 1] m",
    ),
    "approach rolls on": (
        {"load: 10 kN": "approach: 20 um", "creep": "mode: moving\ncreep"},
        "contact.approach: does not go with mode moving: rolling is under a load",
    ),
    "across alone": (
        {"mu: 0.3": "mu: 0.3, across_y: [1 mm]"},
        "friction.across_factor: is missing",
    ),
    "across": (
        {"mu: 0.3": "mu: 0.3, across_y: [1 mm, 2 mm], across_factor: [1]"},
        "friction.across_factor: 1 values; one for each of the 2 places",
    ),
    "across falls": (
        {"mu: 0.3": "mu: 0.3, across_y: [2 mm, 2 mm], across_factor: [1, 2]"},
        "friction.across_y: places that increase are expected",
    ),
    "twist alone": (
        {"creep: [1e-3]": "mode: static\nstatic: {force_ratio: 0.5, twist: 0.1}"},
        "static.twist: needs static.shift; [0 m, 0 m] is allowed",
    ),
    "twist rolls": (
        {"creep: [1e-3]": "creep: 0\nstatic: {twist: 0.1}"},
        "static.twist: does not go with mode frozen",
    ),
    "step": ({"creep": "mode: moving\nmoving: {step: 0}\ncreep"}, "moving.step: '0' is not in"),
    "step and heat": (
        {
            "creep": "mode: moving\nmoving: {step: 2}\ncreep",
            "thermal: off": "thermal: {model: local}",
        },
        "moving.step: does not go with thermal.model local",
    ),
    "step and memory": (
        {
            "creep": "mode: moving\nmoving: {step: 2}\ncreep",
            "mu: 0.3": "mu: 0.3, memory_length: 1 mm",
        },
        "moving.step: does not go with friction.memory_length",
    ),
    "step and edges": (
        {"creep": "mode: moving\nmoving: {step: 2}\ncreep", "load": "edges: inside, load"},
        "moving.step: does not go with contact.edges inside",
    ),
    "bulk of three": (
        {"thermal: off": "thermal: {bulk: [1 K, 2 K, 3 K]}"},
        "thermal.bulk: 3 values; one for both bodies, or [wheel, rail], are expected",
    ),
    "unit alone": (
        {"creep: [1e-3]": "creep: 0\nroughness: {rail: a.npy, height_unit: kg}"},
        "roughness.height_unit: '1 kg': 'kg' is of another dimension than m",
    ),
    "roughness": (
        {
            "creep: [1e-3]": "creep: 0\n"
            "roughness: {hurst: 0.8, rms_slope: 0.1, wavelength_min: 1 mm}"
        },
        "wavelength_max: is missing",
    ),
    "npy scale": (
        {"creep: [1e-3]": f"creep: 0\nroughness: {{rail: {MAPS / 'c64.npy'}}}"},
        "roughness.spacing: is missing",
    ),
    "scale": (
        {"creep: [1e-3]": f"creep: 0\nroughness: {{rail: {MAPS / 'deflated.x3p'}, spacing: 1 um}}"},
        "it is for npy files",
    ),
    "bodies": ({"0.28": "[0.28, 0.3, 0.3]"}, "contact.poissons_ratio: 3 values"),
    "domain": (
        {"load: 10 kN": "load: 10 kN, domain: 1"},
        "contact.domain: '1' is not in the allowed range",
    ),
    "hopeless force": ({"creep: [1e-3]": "force: {longitudinal: 4 kN}"}, "force"),
    "missing map": ({"creep: [1e-3]": "creep: 0\nroughness: {rail: a.gsf}"}, "a.gsf"),
    "fine waves": (
        {
            "creep: [1e-3]": "creep: 0\n"
            "roughness: {hurst: 0.8, rms_slope: 0.01, wavelength_min: 0.5 mm, "
            "wavelength_max: 4 mm}"
        },
        "cells: those",
    ),
    "waves": (
        {
            "creep: [1e-3]": "creep: 0\n"
            "roughness: {hurst: 0.8, rms_slope: 0.01, wavelength_min: 90 mm, "
            "wavelength_max: 99 mm}"
        },
        "roughness: no wave",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_cases(name, case, tmp_path):
    changes, expected = BAD[name]
    text = CASE
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    case.write_text(text, encoding="utf-8")
    done = wr_creep(case, "-o", tmp_path / "out", "-q")
    assert done.returncode == 3, done.stderr
    assert done.stderr.count("\n") == 1 and expected in done.stderr, done.stderr
    assert not (tmp_path / "out/creep.csv").exists()


def test_keywords_of_a_patch_are_refused_on_a_line(tmp_path):
    line = SOURCE / "examples/wheelrail/table2.yaml"
    for change in (
        "lateral=0.1",
        "spin=1 1/m",
        "force.lateral=1 N",
        "contact.semi_axes=[1 mm, 1 mm]",
        "roughness.stretch=2",
        "moving.start=rest",
    ):
        done = wr_creep(line, "-o", tmp_path, "--set", change)
        assert (
            done.returncode in (2, 3) and "does not go with a line contact" in done.stderr
        ), done.stderr
    for change, text in (
        ("creep=-11", "[-10, 10]"),
        ("cells=16", "[32,"),
        ("cells=[64, 64]", "not a list"),
        ("contact.youngs_modulus=[1 GPa, 2 GPa, 3 GPa]", "3 values; one for both bodies"),
    ):
        done = wr_creep(line, "-o", tmp_path, "--set", change)
        assert done.returncode in (2, 3) and text in done.stderr, done.stderr


def test_what_is_refused_or_warned_of(case, tmp_path):
    done = run(
        case,
        tmp_path / "box",
        "contact.hardness_limit=true",
        "friction.strength=75 MPa",
        "contact.domain=2.11",
        code=3,
    )
    assert re.search(
        "contact.domain: the contact reaches the (leading|trailing|lateral) border.*contact.box",
        done.stderr,
    )
    missing = "roughness={rail: none.npy, spacing: 1 mm, height_unit: um}"
    assert "none.npy: no such file" in run(case, tmp_path / "none", missing, code=3).stderr
    done = run(
        case,
        tmp_path / "fine",
        "roughness=" + ROUGH.replace("2.6 mm", "1.5 mm"),
        "contact.domain=3",
    )
    assert "wr_creep: warning: cells: waves of 1.5 mm have" in done.stderr
    assert json.loads((tmp_path / "fine/summary.json").read_text())["warnings"]
    # heat that leaves no strength: the fixed point has no solution there
    hot = CASE.replace("law: constant, mu: 0.3", "law: bucher2006").replace(
        "thermal: off", "thermal: {conductivity: 0.01 W/(m K), model: local}"
    )
    case.write_text(hot, encoding="utf-8")
    done = run(case, tmp_path / "hot", "creep=0.9", code=4, options=["-q"])
    assert done.stderr.count("\n") == 1


def test_print_config_is_a_case_file(case, tmp_path):
    first = wr_creep(
        case,
        "--print-config",
        "--set",
        "contact.radii={wheel_rolling: 0.5 m, rail_profile: 0.3 m}",
        "--set",
        "contact.load=20 kN",
    )
    assert first.returncode == 3  # two shapes
    first = wr_creep(
        case, "--print-config", "--set", "lateral=[0.5 %, -0.5 %]", "--set", f"roughness={ROUGH}"
    )
    assert first.returncode == 0 and "domain: 3.4" in first.stdout, first.stderr
    (tmp_path / "again.yaml").write_text(first.stdout, encoding="utf-8")
    assert wr_creep(tmp_path / "again.yaml", "--print-config").stdout == first.stdout
