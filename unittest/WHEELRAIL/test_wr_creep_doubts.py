# SPDX-License-Identifier: GPL-2.0-or-later
"""What can be computed with but hardly be meant, impossible forces, and results as a set."""

import json
import os

import pytest
from patch_runs import CASE, SOURCE, gsf_map, run, table

LINE = SOURCE / "examples/wheelrail/table2.yaml"
HEAT = "thermal={model: averaged, conductivity: 50 W/(m K), density: 7800 kg/m^3, "
HEAT += "specific_heat: 450 J/(kg K)}"
CONSTANT = "friction={law: constant, mu: 0.3}"


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def warnings(done):
    return [line for line in done.stderr.splitlines() if "warning: " in line]


def test_plausible_cases_have_no_warning(case, tmp_path):
    assert not warnings(run(case, tmp_path / "a"))
    assert not warnings(run(LINE, tmp_path / "b", "creep=[0.01]", "speed=[20 m/s]", CONSTANT))


@pytest.mark.parametrize(
    "changes,expected",
    [
        (["creep=3"], "creep: 3 (300 %); above 1"),
        (["lateral=-1.5"], "lateral: -1.5 (-150 %); above 1"),
        (["creep=0", "spin=0.5 1/mm"], "spin at the contact's edge: 2 (200 %); above 1"),
        (["speed=[900 m/s]"], "speed: 900 m/s (3240 km/h); no wheel"),
        (["speed=[5 mm/s]", HEAT], "at speed: 0.005 m/s; temperatures are of heat that flows"),
        (["contact.load=11000 kN"], "above youngs_modulus/50 = 4198 MPa"),
        (
            ["contact.load=100 kN", "friction={law: bucher2006, strength: 552 MPa}"],
            "above 3 friction.strength = 1656 MPa",
        ),
        (
            ["friction={law: constant, mu: 0.3, memory_length: 0.1 mm}"],
            "friction.memory_length: 0.1 mm have no effect",
        ),
    ],
)
def test_a_patch_that_cannot_be_meant(changes, expected, case, tmp_path):
    done = run(case, tmp_path / "out", *changes)
    assert any(expected in line for line in warnings(done)), done.stderr
    told = json.loads((tmp_path / "out/summary.json").read_text())["warnings"]
    assert any(expected in line for line in told)


@pytest.mark.parametrize(
    "changes,expected",
    [
        (["creep=[2.0]"], "creep: 2 (200 %); above 1"),
        (["contact.load_per_length=4e8 N/mm"], "contact: it reaches 1486 mm"),
        (["contact.load_per_length=4e6 N/mm"], "peak pressure"),
        (["speed=[720 m/s]"], "speed: 720 m/s (2592 km/h); no wheel"),
        (["speed=[20 mm/s]", HEAT], "the Peclet number is 3.3 at speed: 0.02 m/s; temperatures"),
        (["contact.radius=460 m"], "a rolling radius of 460 m; no wheel"),
        (
            ["friction={law: constant, mu: 0.3, memory_length: 0.1 mm}"],
            "friction.memory_length: 0.1 mm have no effect",
        ),
    ],
)
def test_a_line_that_cannot_be_meant(changes, expected, tmp_path):
    done = run(LINE, tmp_path / "out", "creep=[0.01]", "speed=[20 m/s]", "thermal=off", *changes)
    assert any(expected in line for line in warnings(done)), done.stderr


def test_a_contact_that_outgrows_the_domain_leaves_other_points(tmp_path):
    """Heat softens one point of the sweep so much that it reaches the ends."""
    changes = ("friction={law: bucher2006, local: true}", "contact.hardness_limit=true")
    changes += ("thermal.model=local", "creep=[0.01, 0.5]", "speed=[10 m/s, 80 m/s]")
    done = run(LINE, tmp_path / "out", *changes, code=4)
    assert "creep 0.5 at 80 m/s: contact.domain: the contact reaches the ends" in done.stderr
    rows = table(tmp_path / "out/creep.csv")
    assert {"creep": "0.01", "speed": "10"}.items() <= rows[0].items() and len(rows) >= 2


def test_a_sequence_in_seconds_that_meant_ms(case, tmp_path):
    """Its steps were beyond the whole numbers: one step, and forces of nothing, without a word."""
    sequence = "sequence={time: [0 s, 1e6 s, 2e6 s], load: [10 kN, 11 kN, 10 kN]}"
    done = run(case, tmp_path / "out", "mode=moving", "thermal=off", sequence, code=3)
    assert "sequence.time: '2e+06 s' lets the wheel roll" in done.stderr
    assert "at most 100000 are allowed" in done.stderr


@pytest.mark.parametrize(
    "change, expected",
    [
        ("creep=[0.01]", "short.csv: the profile, 3.99 mm, is shorter than the stretch"),
        ("roughness.cutoff=0.012345678 mm", "short.csv: roughness.cutoff: 0.012346 mm must lie"),
    ],
)
def test_a_short_profile_is_named_with_its_numbers(change, expected, tmp_path):
    rows = "".join(f"{0.01 * k:.2f};{0.1 * (k % 13):.1f}\n" for k in range(400))
    (tmp_path / "short.csv").write_text("# height: um\n# position: mm\n" + rows)
    rough = f"roughness={{rail: {tmp_path / 'short.csv'}}}"
    done = run(LINE, tmp_path / "out", rough, change, code=3)
    assert expected in done.stderr and "000000" not in done.stderr


def test_heights_of_a_wrong_unit_and_fill_values(case, tmp_path):
    gsf_map(tmp_path / "a.gsf", 1)
    good = (tmp_path / "a.gsf").read_bytes()
    (tmp_path / "b.gsf").write_bytes(good.replace(b"ZUnits = m\n", b"ZUnits =Mm\n"))
    rough = "roughness={{rail: {}, detrend: none}}"
    done = run(case, tmp_path / "out", rough.format(tmp_path / "b.gsf"))
    assert any("rms slope" in line for line in warnings(done)), done.stderr
    rows = [["0.1", "0.2", "-0.1", "0.05"] * 8 for _ in range(32)]
    rows[5][4] = rows[5][5] = "-9999"
    text = "# height: um\n# spacing: 0.5 mm\n" + "\n".join(" ".join(row) for row in rows) + "\n"
    (tmp_path / "fill.txt").write_text(text)
    done = run(case, tmp_path / "fill", rough.format(tmp_path / "fill.txt"))
    assert any("2 of the heights are -9999 um" in line for line in warnings(done)), done.stderr


def test_fill_values_of_a_profile(tmp_path):
    """nan, which a map takes, is refused in a profile."""
    rows = [f"{0.01 * k:.2f};{0.1 * (k % 13):.1f}\n" for k in range(4000)]
    rows[20:22] = ["0.20;-9999\n", "0.21;-9999\n"]
    (tmp_path / "fill.csv").write_text("# height: um\n# position: mm\n" + "".join(rows))
    rough = f"roughness={{rail: {tmp_path / 'fill.csv'}, detrend: none}}"
    done = run(LINE, tmp_path / "out", rough, "creep=[0.01]", "speed=[20 m/s]", "thermal=off")
    (line,) = [line for line in warnings(done) if "2 of the heights are -9999 um" in line]
    assert line.endswith("Interpolate or cut the profile where nothing was measured")


def test_a_law_of_a_material_knows_its_temperatures(case, tmp_path):
    """A file without temperature_range holds at the temperatures of its material."""
    law = {"format": "mca-friction-law 2", "mu0": 0.3, "density": 7800, "temperature": [293, 873]}
    law |= {"strength": [900, 400], "youngs_modulus": [206e3, 64e3]}
    (tmp_path / "law.json").write_text(json.dumps(law))
    friction = f"friction={{law: {tmp_path / 'law.json'}, ambient: %s}}"
    assert not warnings(run(case, tmp_path / "in", friction % "400 K"))
    done = run(case, tmp_path / "out", friction % "1000 K")
    assert any("temperature in K 1000 (293 to 873)" in line for line in warnings(done)), done.stderr


def test_transverse_profiles_are_named(case, tmp_path):
    (tmp_path / "a.prw").write_text("1 2\n")
    for which in (case, LINE):
        done = run(which, tmp_path / "out", f"roughness={{wheel: {tmp_path / 'a.prw'}}}", code=3)
        assert done.stderr.splitlines()[-1].count("transverse profile of a wheel") == 1


def test_case_files_of_other_machines(case, tmp_path):
    text = CASE.replace("[3 mm, 4 mm]", "[3000 \u00b5m, 4 mm]")
    variants = {
        "Latin-1": text.encode("latin-1"),
        "CRLF": text.replace("\n", "\r\n").encode(),
        "CR": text.replace("\n", "\r").encode(),
        "UTF-8 with a mark": text.encode("utf-8-sig"),
        "UTF-16": text.encode("utf-16"),
    }
    for name, content in variants.items():
        case.write_bytes(content)
        run(case, tmp_path / name)
    tables = {(tmp_path / name / "creep.csv").read_text() for name in variants}
    assert len(tables) == 1
    case.write_bytes(text.encode("utf-16-le"))
    done = run(case, tmp_path / "no mark", code=3)
    assert "is UTF-16 without a byte order mark; save it as UTF-8" in done.stderr


def test_one_impossible_force_leaves_the_others(case, tmp_path):
    """10 kN at mu = 0.3 carry 3 kN."""
    text = CASE.replace("creep: [1e-3]", "force: {longitudinal: [1 kN, 5 kN, 2 kN]}")
    case.write_text(text, encoding="utf-8")
    done = run(case, tmp_path / "out", code=4)
    first, last = table(tmp_path / "out/creep.csv")
    assert float(first["force_x"]) == pytest.approx(1000.0, rel=1e-5)
    assert float(last["force_x"]) == pytest.approx(2000.0, rel=1e-5)
    assert (
        "force.longitudinal: 5 kN cannot be carried: friction allows less than 3 kN" in done.stderr
    )
    alone = run(case, tmp_path / "one", "force.longitudinal=5 kN", code=3)
    assert "force.longitudinal: 5 kN" in alone.stderr
    both = run(case, tmp_path / "two", "force={longitudinal: 1 kN, lateral: 4 kN}", code=3)
    assert "force.longitudinal, force.lateral: 4.1231 kN" in both.stderr


def test_a_load_above_the_hardness_is_named(tmp_path):
    case = tmp_path / "case.yaml"
    case.write_text(
        "contact: {load_per_length: 40000 N/mm, period: 10 mm, youngs_modulus: 210 GPa, "
        "poissons_ratio: 0.3, hardness_limit: true}\n"
        "roughness: {hurst: 0.8, rms_slope: 0.01, wavelength_min: 0.1 mm, wavelength_max: 5 mm, "
        "seed: 3}\nmode: static\nstatic: {force_ratio: 0}\n"
        "friction: {law: constant, mu: 0.3, strength: 1000 MPa}\n"
    )
    done = run(case, tmp_path / "out", code=3)
    assert "contact.hardness_limit" in done.stderr
    assert "4000 MPa" in done.stderr and "3000 MPa" in done.stderr


def test_results_replace_a_set_by_a_set(case, tmp_path):
    """Nothing of a former run stays beside the files of a new one; what is not ours does."""
    out = tmp_path / "out"
    run(case, out, "fields=all", "creep=[1e-3, 2e-3]")
    (out / "fields_of_mine.gsf").write_text("mine")
    (out / "notes.txt").write_text("mine")
    first = set(os.listdir(out))
    assert {"fields_0001.vti", "fields_0002.vti"} <= first
    named = json.loads((out / "summary.json").read_text())["files"]
    assert set(named) == first - {"fields_of_mine.gsf", "notes.txt"}
    run(case, out, "fields=last", "creep=[1e-3]")
    assert "fields_0002.vti" not in os.listdir(out) and "fields_0001.vti" in os.listdir(out)
    # another contact and another mode
    run(LINE, out, "creep=[0.01]", "speed=[20 m/s]", "thermal=off")
    assert set(os.listdir(out)) == {
        "contact.csv", "creep.csv", "creep.json", "summary.json", "fields_of_mine.gsf", "notes.txt"
    }  # fmt: skip
    # a former result that the run reads stays
    run(case, out, "fields=last")
    gap = "fields_0001_gap.gsf"
    rough = f"roughness={{rail: {out / gap}, detrend: none}}"
    run(case, out, "contact.semi_axes=[1 mm, 1 mm]", "contact.load=1 kN", rough)
    assert gap in os.listdir(out) and "fields_0001.vti" not in os.listdir(out)
