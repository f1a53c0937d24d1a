# SPDX-License-Identifier: GPL-2.0-or-later
"""Measured series of time and friction coefficient, wr_fit FILE.csv."""

import json
import random

import pytest

from wr_fit_run import one_line, wr_fit


def series(rows=1200, mean=0.43, noise=0.02, seed=1, start=0.3):
    """(time, mu) of a tribometer that runs in over 20 s, with noise that remembers."""
    rng, now, found = random.Random(seed), 0.0, []
    for k in range(rows):
        now = 0.8 * now + rng.gauss(0, noise * 0.6)
        t = 0.1 * (k + 1)
        found.append((t, mean + now - (start if t < 20 else 0) * (1 - t / 20)))
    return found


def test_mean_and_error(tmp_path):
    """95 % of the intervals hold the mean; the grinding-in is left out."""
    hits = 0
    for seed in range(40):
        table = tmp_path / "t.csv"
        table.write_text(
            "# of a tribometer\ntime,force,mu\n"
            + "".join(f"{t:.1f},{1000 * mu:.4g},{mu:.6f}\n" for t, mu in series(seed=seed))
        )
        result = wr_fit(table, "-o", tmp_path / "fit.json")
        assert result.returncode == 0, result.stderr
        report = json.loads((tmp_path / "fit.json").read_text())
        assert report["format"] == "mca-measured-friction 1"
        (one,) = report["series"]
        assert 8 < one["start"] < 62 and one["rows"] == 1200 - round(10 * one["start"]) + 1
        assert 0.2 < one["correlation_time"] < 3 and 0.0005 < one["mu_se"] < 0.01
        hits += abs(one["mu"] - 0.43) < 1.96 * one["mu_se"]
    assert 34 <= hits
    assert f"mu {one['mu']:.4g} +- " in result.stdout and "t.csv" in result.stdout


@pytest.mark.parametrize("separator, decimal", [(";", ","), ("\t", ","), (",", "."), (" ", ".")])
def test_as_spreadsheets_write_them(tmp_path, separator, decimal):
    rows = [f"{t:.1f}{separator}{mu:.6f}".replace(".", decimal) for t, mu in series()]
    (tmp_path / "one.CSV").write_bytes(b"\xef\xbb\xbf" + "\r\n".join(rows).encode() + b"\r\n")
    (tmp_path / "two.csv").write_text("".join(f"{t:.1f},{mu:.6f}\n" for t, mu in series()))
    one, two = (
        wr_fit(tmp_path / name, "--start", 30).stdout.split(": ", 1)[1]
        for name in ("one.CSV", "two.csv")
    )
    assert one == two and "901 rows from time 30 on" in one


@pytest.mark.parametrize(
    "text, parts",
    [
        ("time,mu,mu\n1,2,3\n", [":1:", "column 'mu' is there twice"]),
        ("time,mi\n1,2\n", [":1:", "column 'mu' is missing", "'mi'"]),
        ("1,0.4\n2,0.4\n", ["2 rows", "at least 7"]),
        ("time;mu\n1;0,4\n2;0,1e309\n", [":3: mu: '0,1e309' is not", "within +-1e+12"]),
        ("time,mu\n1,0.4\n2,x\n", [":3:", "mu", "'x'"]),
        ("time,mu\n1,0.4\n2,0.4\n4,0.4\n", [":4:", "4 follows 2", "evenly"]),
        ("time,mu\n1,0.4\n2,0.4,7\n", [":3:", "3 columns, 2 are expected"]),
    ],
)
def test_what_is_refused(tmp_path, text, parts):
    (tmp_path / "t.csv").write_text(text)
    one_line(wr_fit(tmp_path / "t.csv"), 3, "t.csv", *parts)


def test_what_does_not_go_together(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text("".join(f"{t:.1f},{mu:.6f}\n" for t, mu in series()))
    for option in ("--runs", "--plot"):
        one_line(wr_fit(table, option, tmp_path / "x.png"), 2, option, "friction logs")
    for words in (
        ("--start-distance", 250), ("--grinding-in", 50), ("--points", tmp_path / "x.csv"),
        ("--material", tmp_path / "x.mca"), ("--model", "eq4"), ("--solid-only",),
        ("--level", 0.9), ("--kappa3", 300), ("--kappa2-min", 5), ("--include-drifting",),
    ):  # fmt: skip
        said = "--runs" if words[0] == "--points" else words[0]
        one_line(wr_fit(table, *words), 2, f"{said}: goes with friction logs")
    one_line(wr_fit(table, tmp_path / "a.friction"), 2, "two calls")
    one_line(wr_fit(table, "--start", 500), 3, "leaves 0 rows", "the last is at 120")


@pytest.mark.parametrize("rows", [4, 6, 7])
def test_a_short_series_has_an_error_or_is_refused(tmp_path, rows):
    table, report = tmp_path / "t.csv", tmp_path / "fit.json"
    table.write_text("".join(f"{t:.1f},{mu:.6f}\n" for t, mu in series(rows=rows)))
    done = wr_fit(table, "-o", report)
    if rows < 7:
        one_line(done, 3, f"t.csv: {rows} rows of time and mu, at least 7 are needed")
        assert not report.exists()
    else:
        one_line(done, 0)
        (one,) = json.loads(report.read_text())["series"]
        assert one["rows"] == 4 and one["mu_se"] > 0 and "inf" not in done.stdout


def test_a_series_that_is_named_twice_counts_once(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text("".join(f"{t:.1f},{mu:.6f}\n" for t, mu in series()))
    (tmp_path / "link.csv").symlink_to("t.csv")
    done = wr_fit(table, tmp_path / ".." / tmp_path.name / "t.csv", tmp_path / "link.csv")
    assert done.returncode == 0 and done.stdout.count("\n") == 1
