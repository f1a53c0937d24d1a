# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_layer.py: the measures of known profiles, and one clear line for others."""

import csv
import subprocess
from pathlib import Path

import pytest

import forked_scripts

PLOT = Path(__file__).resolve().parents[2] / "tools" / "plot_layer.py"
HEAD = """# Chunk-averaged data
# Timestep Number-of-chunks Total-count
# Chunk Coord1 Ncount vx c_state[1] v_upper v_away2
"""


def frame(step, low, high):
    """Ten rows of height 1: still below `low`, at 5 above `high`, linear between; half linked
    there."""
    rows = []
    for k in range(10):
        share = min(max((k - low) / (high - low), 0), 1)
        inside = low < k < high
        rows.append(
            f"  {k + 1} {k} 4 {5 * share} {3 if inside else 6} {share} {2 if inside else 0}"
        )
    return f"{step} 10 40\n" + "\n".join(rows) + "\n"


def plot(tmp_path, content, *options):
    (tmp_path / "a.profile").write_text(content)
    return forked_scripts.run([PLOT, tmp_path / "a.profile", *options], tmp_path)


def test_measures_of_a_known_layer(tmp_path):
    # the second frame is from a continued run, the third is being written
    content = HEAD + frame(1000, 3, 6) + HEAD + frame(2000, 2, 7) + frame(3000, 2, 7)[:60]
    done = plot(tmp_path, content, "-o", tmp_path / "a.png", "--csv", tmp_path / "a.csv")
    assert done.returncode == 0, done.stderr
    with open(tmp_path / "a.csv", encoding="utf-8") as file:
        rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
    assert [row["step"] for row in rows] == [1000, 2000]
    for row, (low, high) in zip(rows, ((3, 6), (2, 7))):
        assert row["depth"] == pytest.approx(0.8 * (high - low))
        assert row["mixed"] == pytest.approx(0.8 * (high - low))
        assert row["centre"] == pytest.approx(4.5)
        assert row["automata"] == 4
        assert row["linked"] == pytest.approx(0.5) and row["displacement2"] == pytest.approx(2)
    assert (tmp_path / "a.png").read_bytes()[:4] == b"\x89PNG"


def test_automata_that_left_the_fragment_do_not_count(tmp_path):
    away = "  11 10 0 0 0 0 0\n  12 99 1 11 0 1 500\n"
    low = "  0 -1 1 -2 0 0 9\n"
    content = HEAD + "1000 13 42\n" + low + "".join(frame(1000, 3, 6).splitlines(True)[1:]) + away
    done = plot(tmp_path, content)
    assert done.returncode == 0, done.stderr
    assert float(done.stdout.splitlines()[1].split()[2]) == pytest.approx(0.8 * 3)


def test_reader_that_has_enough(tmp_path):
    (tmp_path / "a.profile").write_text(HEAD + frame(1000, 3, 6) + frame(2000, 2, 7))
    script = f"set -o pipefail; {PLOT} {tmp_path / 'a.profile'} | true"
    done = subprocess.run(
        ["bash", "-c", script], text=True, capture_output=True, timeout=60, check=False
    )
    assert done.returncode == 5
    assert done.stderr == "plot_layer.py: standard output: cannot be written: Broken pipe\n"


@pytest.mark.parametrize(
    "content, word",
    [
        ("", "no frame"),
        ("nonsense\n", ":1:"),
        (HEAD.replace("vx", "vz") + frame(1, 3, 6), "columns"),
        (HEAD + frame(1, 3, 6).replace("0.0", "zero"), ":8: 'zero' is not a finite"),
    ],
)
def test_bad_profile(tmp_path, content, word):
    done = plot(tmp_path, content, "-o", tmp_path / "a.png")
    assert done.returncode == 3
    assert done.stderr.count("\n") == 1 and word in done.stderr
    assert not (tmp_path / "a.png").exists()
