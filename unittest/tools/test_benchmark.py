# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/benchmark.py with a stand-in for lmp, whose speed is a number in the environment."""

import json
import re
from pathlib import Path

import pytest

LMP = """#!/bin/sh
# LAMMPS's words for a run, twice as fast for lj, SPEED times for the plugin
case "$*" in
*in.lj*) rate=2 ;;
*in.mca*) rate=${SPEED:-1} ;;
*) rate=1 ;;
esac
case "$*" in
*"warm begin"* | *warmup*) : >"$(echo "$*" | sed 's/.*-var sample \\([^ ]*\\).*/\\1/').links" ;;
esac
seconds=$(echo "$rate" | awk '{printf "%.6f", 1 / $1}')
printf 'Loop time of %s on 1 procs for 1000 steps with 1600 atoms\\n100.0%% CPU use\\n' \\
  "$seconds" >log.bench
"""
WORDS = ["--short", "--rounds", "1", "-o", "out.json"]


@pytest.fixture
def bench(call, tmp_path, monkeypatch):
    """bench(speed, words): exit code, output, errors; a build of the stand-in in this folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "lmp").write_text(LMP)
    (tmp_path / "bin" / "lmp").chmod(0o755)

    def run(speed, *words):
        monkeypatch.setenv("SPEED", str(speed))
        return call("benchmark.py", "--build", ".", *WORDS, *words)

    return run


def ratios(path):
    table = json.loads(path.read_text())["ratios"]
    return {(r["row"], r["ratio"]): r["median"] for r in table}


def test_ratios(bench, tmp_path):
    """Each row over what it is taken over, from the times that LAMMPS says."""
    code, out, err = bench(3)
    assert code == 0, err
    found = ratios(tmp_path / "out.json")
    assert found == pytest.approx(
        {
            ("default laws", "mca / gran/hooke/history"): 3,
            ("default laws", "mca / lj/cut"): 1.5,
            ("rail steel, 1000 MPa", "row / default laws"): 1,
            ("rail steel, 1073 K", "row / default laws"): 1,
            ("strength 552 MPa", "row / default laws"): 1,
            ("drucker-prager", "row / default laws"): 1,
            ("account", "row / default laws"): 1,
            ("space", "mca / gran/hooke/history"): 3,
        },
        rel=1e-5,
    )
    assert "mca / lj/cut" in out


@pytest.mark.parametrize("speed, fallen", [(2.6, 0), (2.5, 3)])
def test_compare(bench, tmp_path, speed, fallen):
    """2.5 is 17 % less than 3, 2.6 is 13 %; ratios of the plugin to itself stay."""
    assert bench(3)[0] == 0
    (tmp_path / "out.json").rename(tmp_path / "release.json")
    code, out, err = bench(speed, "--compare", "release.json")
    said = [line for line in err.splitlines() if "before" in line]
    assert code == (1 if fallen else 0) and len(said) == fallen, err
    assert "8 ratios compared, 0 of the file not measured" in out
    if fallen:
        assert "mca / lj/cut, 1600 automata, 1 ranks: 1.500 before, 1.250 now (-17 %)" in said[1]


def test_compare_with_less(bench, tmp_path):
    """What is not measured is counted."""
    assert bench(3)[0] == 0
    (tmp_path / "out.json").rename(tmp_path / "release.json")
    code, out, _ = bench(3, "--compare", "release.json", "--laws", "account")
    assert code == 0 and "3 ratios compared, 5 of the file not measured" in out


def test_compare_with_the_release(bench):
    """Every ratio of a short run stands in the shipped file."""
    release = Path(__file__).resolve().parents[2] / "tools" / "benchmark" / "release.json"
    _, out, _ = bench(3, "--compare", release)
    assert re.search(r"^8 ratios compared, \d+ of the file not measured", out, re.MULTILINE), out


def test_against(bench, tmp_path):
    assert bench(3, "--against", ".", "--laws", "account")[0] == 0
    found = ratios(tmp_path / "out.json")
    assert found["account", "this build / other build"] == pytest.approx(1)


@pytest.mark.parametrize(
    "content, word",
    [
        ("", "release.json"),
        ('{"format": "mca-benchmark 1"}', "must be 'mca-benchmark 2'"),
        ('{"format": "mca-benchmark 2", "ratios": []}', "ratios are needed"),
    ],
)
def test_bad_file_to_compare_with(bench, tmp_path, content, word):
    """Before anything runs."""
    (tmp_path / "release.json").write_text(content)
    code, _, err = bench(3, "--compare", "release.json")
    assert code == 3 and err.count("\n") == 1 and word in err


def test_failed_run(bench, tmp_path):
    (tmp_path / "bin" / "lmp").write_text("#!/bin/sh\necho ERROR: no luck\nexit 1\n")
    code, _, err = bench(3)
    assert code == 1 and "no luck" in err and not (tmp_path / "out.json").exists()
