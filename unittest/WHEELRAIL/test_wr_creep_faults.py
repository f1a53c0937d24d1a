# SPDX-License-Identifier: GPL-2.0-or-later
"""What happens around wr_creep: full disks, damaged journals, files that change, closed streams,
text that a terminal would obey, numbers beyond any contact."""

import json
import os
import pathlib
import random
import re
import resource
import subprocess

import pytest

BIN = pathlib.Path(os.environ["WHEELRAIL_BIN"]) / "wr_creep"
SOURCE = pathlib.Path(os.environ["PROJECT_SOURCE"])

LINE = """\
contact: {load_per_length: 4000 N/mm, radius: 0.5 m, youngs_modulus: 210 GPa, poissons_ratio: 0.3}
friction: {law: constant, mu: 0.3}
thermal: off
speed: 20 m/s
creep: {from: 1e-4, to: 1e-2, n: 40}
cells: 1000
"""
POINT = """\
contact: {load: 80 kN, curvatures: [1 1/m, 1.5 1/m], youngs_modulus: 210 GPa, poissons_ratio: 0.3}
friction: {law: constant, mu: 0.3}
thermal: off
speed: 20 m/s
creep: {from: 1e-4, to: 1e-2, n: 20}
cells: 32
"""
LONG = pytest.mark.long
FULL = "No space left on device|File too large"


def wr_creep(*arguments, **options):
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    return subprocess.run([BIN, *map(str, arguments)], text=True, timeout=120, **options)


def one_line(done, code, *parts):
    """The failed call said one clear line that holds the parts, below its progress and notes."""
    beside = re.compile(r": \d+ of \d+ |^\w+: note: ")
    lines = [line for line in done.stderr.splitlines() if not beside.search(line)]
    assert done.returncode == code, done.stderr
    assert len(lines) == 1, done.stderr
    for part in parts:
        assert part in lines[0], lines[0]


def small_files(size):
    """For preexec_fn: files of at most so many bytes, as on a disk that fills up."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def contents(folder):
    """The bytes of all results by name, without what tells of time."""
    found = {p.name: p.read_bytes() for p in folder.iterdir()}
    return {
        name: re.sub(rb'"(seconds|points_resumed)": [^,\n]*', b"", data)
        for name, data in found.items()
    }


@pytest.fixture(params=["line", "point"])
def case(request, tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(LINE if request.param == "line" else POINT, encoding="utf-8")
    return path


@pytest.fixture
def line(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(LINE, encoding="utf-8")
    return path


def interrupted_by_a_full_disk(case, out, *more):
    """The sweep ends, its results do not fit: the journal stays alone."""
    done = wr_creep(case, "-o", out, "-q", *more, preexec_fn=small_files(20000))
    one_line(
        done, 5, "; no result is written; the operating points in", "wr_creep.journal are kept"
    )
    assert re.search(FULL, done.stderr)
    assert {p.name.rstrip(".0123456789") for p in out.iterdir()} == {"wr_creep.journal"}
    return out / "wr_creep.journal"


def test_results_that_do_not_fit_leave_the_journal(case, tmp_path):
    out = tmp_path / "out"
    interrupted_by_a_full_disk(case, out)
    done = wr_creep(case, "-o", out)
    assert done.returncode == 0 and "from a run that ended early" in done.stdout, done.stderr
    assert json.loads((out / "summary.json").read_text())["points_resumed"] >= 8
    assert not (out / "wr_creep.journal").exists()
    whole = tmp_path / "whole"
    assert wr_creep(case, "-o", whole, "-q").returncode == 0
    assert contents(out) == contents(whole)


def test_old_results_stay_when_new_ones_do_not_fit(case, tmp_path):
    out = tmp_path / "out"
    assert wr_creep(case, "-o", out, "-q").returncode == 0
    before = contents(out)
    changed = ("--set", "friction.mu=0.25")
    for limit in (0, 100, 5000, 20000):
        done = wr_creep(case, "-o", out, "-q", *changed, preexec_fn=small_files(limit))
        assert done.returncode == 5 and re.search(FULL, done.stderr), (limit, done.stderr)
        (out / "wr_creep.journal").unlink(missing_ok=True)
        assert contents(out) == before, limit


def test_results_are_together_with_polachs_law(tmp_path):
    """Its files are part of them; a fit that fails leaves the curves."""
    case = tmp_path / "case.yaml"
    case.write_text(POINT, encoding="utf-8")
    out = tmp_path / "out"
    (tmp_path / "full.json").symlink_to("/dev/full")
    done = wr_creep(case, "-o", out, "-q", "--polach", tmp_path / "full.json")
    one_line(done, 5, "full.json: cannot write", "no result is written")
    assert {p.name.rstrip(".0123456789") for p in out.iterdir()} == {"wr_creep.journal"}
    assert not (tmp_path / "full.csv").exists()
    few = ("--set", "creep=[1e-3]")
    done = wr_creep(case, "-o", out, "-q", *few, "--polach", tmp_path / "law.json")
    assert done.returncode == 4 and "Polach's law" in done.stderr
    assert (out / "creep.csv").exists() and not (tmp_path / "law.json").exists()


@pytest.mark.parametrize("flips", [4, pytest.param(25, marks=LONG)])
def test_damaged_journals_are_never_believed(case, tmp_path, flips):
    """A flipped bit is found, said, and its points are computed again."""
    out = tmp_path / "out"
    journal = interrupted_by_a_full_disk(case, out)
    good = journal.read_bytes()
    assert wr_creep(case, "-o", out, "-q").returncode == 0
    right = contents(out)
    generator = random.Random(24)
    for _ in range(flips):
        bad = bytearray(good)
        bad[generator.randrange(len(good))] ^= 1 << generator.randrange(8)
        journal.write_bytes(bad)
        done = wr_creep(case, "-o", out, "-q")
        one_line(done, 0, "wr_creep: warning: ", "wr_creep.journal: ")
        assert contents(out) == right
    for text in (b"", b"{}", b"\n", good[: len(good) // 2], b"\0" * 100, b"[" * 100000, good * 2):
        journal.write_bytes(text)
        done = wr_creep(case, "-o", out, "-q")
        one_line(done, 0, "wr_creep: warning: ")
        assert contents(out) == right and not journal.exists(), text[:20]


def profile(path, factor=1.0):
    lines = ["# height: um", "# position: mm"]
    lines += [f"{0.01 * i:.3f}, {factor * ((i * 7919) % 13) * 0.1:.4f}" for i in range(2500)]
    path.write_text("\n".join(lines), encoding="utf-8")


def law(path, mu0):
    content = {"format": "mca-friction-law 1", "mu0": mu0, "mu1": 0.0442, "mu2": 0.3243}
    content.update(b=0.195, c=0.00212, covariance=None, n=34, rms_relative=0.09, source="test")
    path.write_text(json.dumps({**content, "kappa1_range": [0, 5], "kappa2_range": [2, 1500]}))


@pytest.mark.parametrize(
    "name, write, change", [("rail.csv", profile, 1.5), ("law.json", law, 0.2)]
)
def test_a_journal_knows_the_content_of_the_files(name, write, change, line, tmp_path):
    write(tmp_path / name, 0.15)
    if name == "rail.csv":
        setting = ("--set", "roughness={rail: rail.csv, cutoff: 0.1 mm}")
    else:
        setting = ()
        line.write_text(LINE.replace("constant, mu: 0.3", "law.json"), encoding="utf-8")
    out = tmp_path / "out"
    interrupted_by_a_full_disk(line, out, *setting)
    write(tmp_path / name, change)
    done = wr_creep(line, "-o", out, "-q", *setting)
    one_line(done, 0, "is of another case, or of files that have changed since")
    fresh = tmp_path / "fresh"
    assert wr_creep(line, "-o", fresh, "-q", *setting).returncode == 0
    assert contents(out) == contents(fresh)


def test_a_journal_of_another_case_is_said(line, tmp_path):
    out = tmp_path / "out"
    journal = interrupted_by_a_full_disk(line, out)
    kept = journal.read_bytes()
    done = wr_creep(line, "-o", out, "-q", "--set", "creep=[1e-3]")  # one piece: none of its own
    one_line(done, 0, "is of another case")
    assert journal.read_bytes() == kept
    still = ("--set", "mode=static", "--set", "static.force_ratio=0.5")
    assert wr_creep(line, "-o", out, "-q", *still).returncode == 0
    assert journal.read_bytes() == kept


@pytest.mark.parametrize("changes", [(), ("--set", "creep=many"), ("--help",), ("--nonsense",)])
def test_streams_that_cannot_be_written(changes, line, tmp_path):
    """stderr is passed over, a lost report is an error; nothing is printed into a result."""
    out = tmp_path / "out"
    right = wr_creep(line, "-o", out, *changes).returncode
    assert right in (0, 2)
    for name in ("stderr", "stdout"):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = wr_creep(line, "-o", out, *changes, **{name: full})
        assert done.returncode == (5 if name == "stdout" and right == 0 else right)
    command = [str(BIN), str(line), "-o", str(out), *changes]
    for closed in ("2>&-", "1>&-", "0<&-", "1>&- 2>&-", "0<&- 1>&- 2>&-"):
        (out / "creep.csv").unlink(missing_ok=True)
        script = f'"$@" {closed}'
        done = subprocess.run(
            ["/bin/sh", "-c", script, "sh", *command], capture_output=True, text=True, timeout=60
        )
        assert done.returncode == (5 if "1>&-" in closed and right == 0 else right), closed
        if not changes:
            assert (out / "creep.csv").read_text().startswith("# program: wr_creep")
            for file in out.iterdir():
                assert b"wr_creep: " not in file.read_bytes(), file


def test_a_reader_that_goes_away_ends_nothing(line, tmp_path):
    done = subprocess.run(
        ["/bin/bash", "-c", '"$@" 2>&1 | true; exit ${PIPESTATUS[0]}', "sh", str(BIN), str(line)]
        + ["-o", str(tmp_path / "out")],
        timeout=60,
    )
    assert done.returncode in (0, 5)  # 5: the reader of the report was gone by then
    assert (tmp_path / "out/creep.csv").exists()


def test_whole_numbers_and_names_of_options(line, tmp_path):
    for given in ("0x10", "010", "1e2", "+2", "2.0", " 2", "4294967297", "18446744073709551617"):
        one_line(wr_creep(line, "--threads", given), 2, "--threads", "whole number from 1 to 1024")
    one_line(wr_creep(line, "-o", ""), 2, "--output", "must be a name")
    one_line(wr_creep(line, "--polach", ""), 2, "--polach", "must be a name")


def test_what_files_say_is_shown_not_obeyed(line, tmp_path):
    """Case, --set, law, profile and their names with escape sequences and ends of lines."""
    evil = "\x1b]0;title\x07\x1b[31m\nwr_creep: all is well\u009b2J"
    (tmp_path / evil.replace("/", "")).write_text("", encoding="utf-8")
    law(tmp_path / "law.json", 0.15)
    text = (tmp_path / "law.json").read_text()
    (tmp_path / "law.json").write_text(text.replace('"b"', json.dumps(evil)), encoding="utf-8")
    (tmp_path / "rail.csv").write_text("# height: um\n# spacing: 5 um\n\x1b[31m\n")
    line.write_text(LINE + json.dumps(evil) + ": 1\n", encoding="utf-8")
    calls = [[line], [tmp_path / evil], [tmp_path / (evil + "none")], ["--" + evil]]
    line2 = tmp_path / "line.yaml"
    line2.write_text(LINE.replace("{law: constant, mu: 0.3}", "{law: law.json}"), encoding="utf-8")
    calls += [[line2], [line2, "--set", f"creep={evil}"], [line2, "--set", f"{evil}=1"]]
    calls += [[line2, "-o", tmp_path / evil / "below"], [line2, "--threads", evil]]
    good = tmp_path / "good.yaml"
    good.write_text(LINE, encoding="utf-8")
    calls += [[good, "--set", "roughness={rail: rail.csv}"]]
    for call in calls:
        done = wr_creep("-o", tmp_path / "out", *call) if "-o" not in call else wr_creep(*call)
        assert done.returncode in (2, 3, 5), call
        assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", done.stderr), done.stderr
        assert len(done.stderr.splitlines()) == 1, done.stderr


def test_names_are_shown_in_the_report(line, tmp_path):
    out = tmp_path / "a\x1b[31m\nb"
    done = wr_creep(line, "-o", out)
    assert done.returncode == 0 and (out / "creep.csv").exists()
    assert "\x1b" not in done.stdout + done.stderr


def test_deeply_nested_files_are_refused(line, tmp_path):
    for text in ("[" * 100000, "{a: " * 100000, "- " * 100000, "a: &a [*a]\n"):
        (tmp_path / "deep.yaml").write_text(text)
        done = wr_creep(tmp_path / "deep.yaml", "-o", tmp_path / "out")
        one_line(done, 3, "deep.yaml")
    (tmp_path / "law.json").write_text('{"mu0": ' + "[" * 200000)
    line.write_text(LINE.replace("constant, mu: 0.3", "law.json"), encoding="utf-8")
    one_line(wr_creep(line, "-o", tmp_path / "out"), 3, "law.json", "nested deeper than")


def test_a_contact_narrower_than_a_cell_is_refused(line, tmp_path):
    sets = ("--set", "contact.domain=100", "--set", "cells=32")
    one_line(
        wr_creep(line, "-o", tmp_path / "out", *sets), 3, "cells: 32 on a contact.domain of 100"
    )
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("cases", [12, pytest.param(40, marks=LONG)])
def test_random_numbers_give_results_or_a_reason(tmp_path, cases):
    """Any numbers that the ranges allow: no nan, no crash, no trace."""
    keywords = {}
    for name, low, high in re.findall(
        r"^  ([a-z][a-zA-Z0-9_.]*) +\[([^,\s]+), ([^\]]+)\]", wr_creep("--help").stdout, re.M
    ):
        keywords[name] = (float(low), float(high))
    units = {"contact.load_per_length": "N/m", "contact.load": "N", "contact.radius": "m"}
    units |= {"contact.curvatures": "1/m", "contact.youngs_modulus": "Pa", "speed": "m/s"}
    units |= {"friction.strength": "Pa", "friction.modulus": "Pa", "friction.density": "kg/m3"}
    units |= {"friction.strength_temperature": "K", "thermal.conductivity": "W/(m K)"}
    units |= {"thermal.density": "kg/m3", "thermal.specific_heat": "J/(kg K)", "spin": "1/m"}
    generator = random.Random(7)

    def value(name):
        low, high = keywords[name]
        number = high * (max(low, 1e-12) / high) ** generator.random()
        return f"{number:.3g} {units.get(name, '')}".strip()

    law_keys = ["friction.strength", "friction.strength_temperature", "friction.modulus"]
    law_keys += ["friction.density", "thermal.conductivity", "thermal.density"]
    law_keys += ["thermal.specific_heat", "creep", "speed", "contact.youngs_modulus"]
    line_keys = ["contact.load_per_length", "contact.radius", *law_keys]
    point_keys = ["contact.load", "spin", "lateral", *law_keys]
    codes = []
    for number in range(cases):
        point = number % 2 == 1
        keys = point_keys if point else line_keys
        groups = [f"{key}={value(key)}" for key in keys]
        if point:
            first = value("contact.curvatures")
            groups += [f"contact.curvatures=[{first}, {first}]", "cells=16", "sensitivities=false"]
        else:
            groups += ["cells=64"]
        groups += ["contact.poissons_ratio=0.3", f"friction.local={number % 3 == 0}".lower()]
        groups += [f"thermal.model={('averaged', 'local', 'averaged_power')[number % 3]}"]
        (tmp_path / "case.yaml").write_text("mode: frozen\n")
        out = tmp_path / f"out{number}"
        done = wr_creep(
            tmp_path / "case.yaml", "-o", out, *[x for g in groups for x in ("--set", g)]
        )
        codes.append(done.returncode)
        assert done.returncode in (0, 3, 4), (groups, done.stderr)
        assert not re.search(r"(?<![a-z])-?(nan|inf)(?![a-z])", done.stdout + done.stderr), groups
        if done.returncode == 0:
            for name in ("creep.csv", "summary.json"):
                text = (out / name).read_text().replace('"covariance": null', "")
                assert not re.search(r"(?<![a-z])(-?nan|-?inf|null)(?![a-z])", text), groups
        elif out.exists():  # one point each
            assert [p.name for p in out.iterdir() if p.name != "wr_creep.journal"] == []
    assert codes.count(0) >= cases // 8, codes


def test_a_failing_sweep_keeps_what_it_has(line, tmp_path):
    """Points that do not converge: the others are written; so are they when the disk was full."""
    out = tmp_path / "out"
    sets = ("--set", "friction={law: bucher2006}", "--set", "thermal={conductivity: 0.01 W/(m K)}")
    sets += ("--set", f"creep={[0.9] + [1e-6 * k for k in range(1, 20)]}")
    done = wr_creep(line, "-o", out, *sets)
    assert (
        done.returncode == 4 and "1 of 20 operating points did not converge" in done.stderr
    ), done.stderr
    names = ["contact.csv", "creep.csv", "creep.json", "summary.json"]
    assert sorted(p.name for p in out.iterdir()) == names
    full = tmp_path / "full"
    done = wr_creep(line, "-o", full, *sets, preexec_fn=small_files(30000))
    assert done.returncode == 5, done.stderr
    assert [p.name for p in full.iterdir()] == ["wr_creep.journal"]
    done = wr_creep(line, "-o", full, *sets)
    assert done.returncode == 4 and "from a run that ended early" in done.stdout
    assert contents(full) == contents(out)
