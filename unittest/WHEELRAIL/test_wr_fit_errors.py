# SPDX-License-Identifier: GPL-2.0-or-later
"""What wr_fit's standard errors are worth, by runs that were made twice: the shipped archives.

A difference of two means in units of their errors has a root mean square of 1, and 5 % lie beyond
1.96, if the errors are right."""

import csv
import itertools
import math
import os
import subprocess
from pathlib import Path

import pytest

from mcawr import archive
from mcawr.friction_log import CHECK, Text

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ["WHEELRAIL_BIN"]) / "wr_fit"
LOGS = ROOT / "examples" / "campaign" / "logs"
# plans of preset d whose runs slide 250 nm after the first 250 nm; averages from there
SEEDS = ("temperature", "velocity", "pressure", "similar", "ductility")
PARTS = (*SEEDS, "paper36", "convergence")


def rows_of(tmp_path, *words):
    """Rows of runs.csv."""
    table = tmp_path / "runs.csv"
    done = subprocess.run(
        [BIN, *words, "--runs", table, "-q", "--kappa2-min", "0"],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode in (0, 4), done.stderr  # 4: no law, which does not matter here
    lines = table.read_text(encoding="utf-8").splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def difference(a, b, error):
    """How far two runs are apart, in units of their errors."""
    return (float(a["mu"]) - float(b["mu"])) / math.hypot(float(a[error]), float(b[error]))


def rms(values):
    return math.sqrt(math.fsum(x * x for x in values) / len(values))


def beyond(values):
    return sum(abs(x) > 1.96 for x in values) / len(values)


def test_seeds_differ_by_their_errors(tmp_path):
    differences, own = [], []
    for plan in SEEDS:
        rows = rows_of(tmp_path, LOGS / f"{plan}.tar.xz", "--start-distance", "250")
        runs = {}
        for row in rows:
            runs.setdefault(row["file"].rsplit("-seed", 1)[0], []).append(row)
        for seeds in runs.values():
            for a, b in itertools.combinations(seeds, 2):
                differences.append(difference(a, b, "mu_se"))
                own.append(difference(a, b, "mu_se_own"))
    assert len(differences) > 35
    # the root mean square of 36 normal numbers scatters by 12 %, the 5 % beyond by 4
    assert rms(differences) == pytest.approx(1, abs=0.15)
    assert beyond(differences) < 0.1
    assert rms(own) > 1.15  # what a run knows of itself is not all


@pytest.mark.parametrize(("parts", "beyond_errors"), [(2, 1.4), (4, 1.15)])
def test_parts_of_a_run_differ_by_their_own_errors(tmp_path, parts, beyond_errors):
    """Neighbouring halves and quarters of what is averaged: the slow times within a run are in its
    error, however short it is; but for states that outlive a part, which doc/wr_fit.md tells."""
    cut = tmp_path / "cut"
    cut.mkdir()
    for plan in PARTS:
        path = LOGS / f"{plan}.tar.xz"
        for name, content in archive.unpack(str(path), path.read_bytes()).items():
            if not name.endswith(".friction"):
                continue
            text = Text.of(content.decode())
            assert text.names[-1] == CHECK
            rows = [row.rsplit(" ", 1)[0] for row in text.rows]
            later = [row for row in rows if float(row.split()[2]) > 250]
            size = len(later) // parts
            for k in range(parts if size >= 40 else 0):
                lines = [*text.head, " ".join(text.names[:-1]), *later[k * size : (k + 1) * size]]
                part = cut / f"{plan}-{name.removesuffix('.friction')}-part{k}.friction"
                part.write_text("\n".join(lines) + "\n", encoding="utf-8")
    rows = {row["file"]: row for row in rows_of(tmp_path, cut, "--start", "0")}
    pairs = [
        (row, rows[name.replace(f"-part{k}.", f"-part{k + 1}.")])
        for name, row in rows.items()
        for k in range(0, parts, 2)
        if f"-part{k}." in name
    ]
    differences = [difference(a, b, "mu_se_own") for a, b in pairs]
    assert len(differences) > 110
    assert 0.85 < rms(differences) < beyond_errors
    assert beyond(differences) < 0.15
