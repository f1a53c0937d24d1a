# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_fit's page against its options and its table of runs."""

import re

from wr_fit_run import TOOLS, read_runs, wr_fit


def test_options_are_documented():
    """Every option is in the documentation, and every documented one exists."""
    coded = re.findall(r"^  ((?:--?[\w-]+,)*--[\w-]+)", wr_fit("--help").stdout, re.MULTILINE)
    page = (TOOLS.parent / "doc" / "wr_fit.md").read_text()
    syntax = page.split("## Examples")[0]
    assert {o for c in coded for o in c.split(",")} == set(re.findall(r"`(--?[\w-]+)`", syntax))
    for name in ("eq2", "eq4", "velocity", "constant"):
        assert f"`{name}`" in syntax and name in wr_fit("--help").stdout


def test_runs_are_read_by_numpy_with_the_line_of_the_page(log, tmp_path, monkeypatch):
    page = (TOOLS.parent / "doc/wr_fit.md").read_text(encoding="utf-8")
    line = re.search(r"^p = (numpy.*)$", page, re.MULTILINE)[1]
    wr_fit(log, "--runs", tmp_path / "runs.csv")
    monkeypatch.chdir(tmp_path)
    import numpy

    runs = eval(line, {"numpy": numpy})
    row = read_runs(tmp_path / "runs.csv")[0]
    assert set(row) - {"file"} == set(runs.dtype.names) - {"file_"}
    for name in ("mu", "poissons_ratio", "breaking_strain", "distance", "gap"):
        assert float(runs[name]) == float(row[name])
    assert (row["poissons_ratio"], row["breaking_strain"], row["distance"]) == (
        "0.3",
        "0.04",
        "100",
    )


def test_the_older_name_of_the_option_writes_the_same_table(log, tmp_path):
    for option, table in (("--runs", "new.csv"), ("--points", "old.csv")):
        assert wr_fit(log, option, tmp_path / table).returncode == 0
    assert (tmp_path / "new.csv").read_bytes() == (tmp_path / "old.csv").read_bytes()


def test_the_page_names_the_columns_of_runs_csv(log, tmp_path):
    page = (TOOLS.parent / "doc/wr_fit.md").read_text(encoding="utf-8")
    start = page.index("`runs.csv`: one comment line")
    text = page[start : page.index("In Python", start)]
    names = [name for code in re.findall(r"`([\w,]+)`", text) for name in code.split(",")]
    wr_fit(log, "--runs", tmp_path / "runs.csv")
    assert list(read_runs(tmp_path / "runs.csv")[0]) == names
