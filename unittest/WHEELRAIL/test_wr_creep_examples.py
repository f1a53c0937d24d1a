# SPDX-License-Identifier: GPL-2.0-or-later
"""Documentation, examples and pictures of wr_creep, and the chain from logs of friction to it."""

import json
import os
import re
import subprocess

import pytest

import friction_logs
from line_runs import BIN, CASE, DOC, SOURCE, TABLE2, law_file, table, wr_creep


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.yaml"
    path.write_text(CASE, encoding="utf-8")
    return path


def keywords_of(page):
    return page[page.index("\n## Keywords") : page.index("## Output info")]


def test_documentation_and_program_agree():
    """Every keyword and option is documented, and every documented one exists."""
    text = DOC.read_text(encoding="utf-8")
    help_text = wr_creep("--help").stdout
    section = help_text[
        help_text.index("Keywords of the case file") : help_text.index("Exit codes")
    ]
    keywords = set(re.findall(r"^  ([a-z][a-zA-Z0-9_.]*) ", section, re.M))
    assert len(keywords) > 30
    documented = set(re.findall(r"^\| `([a-z][a-zA-Z0-9_.]*)` ", keywords_of(text), re.M))
    assert documented == keywords
    options = set(re.findall(r"--[a-z][a-z-]+", help_text[: help_text.index("Examples:")]))
    assert set(re.findall(r"^\* `(?:-\w, )?(--[a-z][a-z-]+)", text, re.M)) == options
    for code in range(7):
        assert re.search(rf"^\| {code} \|", text, re.M), code


def test_table_of_keywords_has_the_programs_ranges_and_defaults():
    text, help_text = DOC.read_text(encoding="utf-8"), wr_creep("--help").stdout
    for name, allowed, default in re.findall(
        r"^\| `([a-z][a-zA-Z0-9_.]*)` \| (.*?) \| (.*?) \|", keywords_of(text), re.M
    ):
        line = re.search(rf"^  {re.escape(name)} +(.*)$", help_text, re.M)[1]
        wanted = allowed.replace(" or ", "|") + (f" [{default.strip('`')}]" if default else "")
        assert line == wanted, name


def test_scripts_read_columns_that_exist():
    """Names that the scripts read from the tables of a point contact, against the page, which
    test_result_columns.cpp holds against the program."""
    from reproduce_parts import patch_runs

    page = DOC.read_text(encoding="utf-8")
    output = page[page.index("The tables of a point contact") : page.index("Other files:")]
    columns = set(re.findall(r"^\| `(\w+)` \|", output, re.M))
    assert set(patch_runs.COLUMNS) <= columns
    assert columns > {"stick_fraction", "force_x_se"}


def test_worked_examples_of_the_help_run(tmp_path):
    """Every `wr_creep ...` of --help, on this folder's copies of the files it names."""
    (tmp_path / "table2.yaml").write_text(TABLE2.read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "law.json").write_text(json.dumps(law_file([[0.0] * 5] * 5)), encoding="utf-8")
    text = wr_creep("--help").stdout
    section = text[text.index("Examples:") : text.index("Keywords of the case file")]
    commands = re.findall(r"^  (wr_creep (?:.*\n {11,})*.*)$", section, re.M)
    assert len(commands) == 6
    for command in commands:
        done = subprocess.run(
            command.replace("wr_creep", str(BIN), 1).replace("\n", " "),
            shell=True,
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, command + done.stderr


FEW = ["--set", "creep=[1e-3, 0.1]"]


@pytest.mark.parametrize(
    "name,options",
    [("table2", FEW), ("rough", FEW), ("measured", FEW), ("static", []), ("periodic", [])],
)
def test_examples_run(name, options, tmp_path):
    done = wr_creep(SOURCE / f"examples/wheelrail/{name}.yaml", "-o", tmp_path, "-q", *options)
    assert done.returncode == 0, done.stderr


@pytest.mark.long
def test_moving_example_runs(tmp_path):
    done = wr_creep(
        SOURCE / "examples/wheelrail/moving.yaml",
        "-o",
        tmp_path,
        "--set",
        "cells=512",
        "--set",
        "roughness.wavelength_min=0.4 mm",
        "--set",
        "creep=[2e-4, 1e-2]",
        "--set",
        "moving.passes=2",
    )
    assert done.returncode == 0, done.stderr
    low, high = (float(row["traction_ratio"]) for row in table(tmp_path / "creep.csv"))
    assert low == pytest.approx(0.0411, rel=0.2)  # the smooth contact's; frozen: half of it
    assert high == pytest.approx(0.3)


def test_pictures(case, tmp_path):
    """plot_creep.py and one figure of plot_wheelrail.py, where matplotlib is there."""
    pytest.importorskip("matplotlib")
    wr_creep(case, "-o", tmp_path, "-q")
    plot = [SOURCE / "tools/plot_creep.py", tmp_path / "creep.csv", "-o", tmp_path / "creep.png"]
    assert subprocess.run(plot, check=False).returncode == 0
    assert (tmp_path / "creep.png").stat().st_size > 10000
    (tmp_path / "creep.csv").write_text("speed,creep\n1,x\n", encoding="utf-8")
    assert subprocess.run(plot, check=False, capture_output=True).returncode == 3
    figure = [SOURCE / "tools/plot_wheelrail.py", "fig13", "-o", tmp_path, "--wr-creep", BIN]
    assert subprocess.run(figure, check=False).returncode == 0
    assert (tmp_path / "fig13.png").stat().st_size > 10000
    numbers = json.loads((tmp_path / "fig13.json").read_text())
    rows = table(tmp_path / "fig13.csv")
    assert list(rows[0]) == list(numbers["columns"]) and len(rows) > 1000
    assert [float(row["mu"]) for row in rows] == numbers["columns"]["mu"]
    assert sorted(path.suffix for path in tmp_path.glob("fig13*")) == [".csv", ".json", ".png"]


def test_chain_from_campaign_to_creep(tmp_path):
    """Logs of Eq. 2 with noise -> law -> creep curves whose band holds those of the paper's law."""
    friction_logs.campaign(tmp_path / "campaign")
    done = subprocess.run(
        [
            SOURCE / "tools/campaign_to_creep.sh",
            tmp_path / "campaign",
            "-o",
            tmp_path / "out",
            "--start",
            "12",
            "--",
            "--set",
            "speed=20 m/s",
            "--set",
            "creep=[0.01, 0.1]",
        ],
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, "MCAWR_BUILD": str(BIN.parents[1])},
    )
    assert done.returncode == 0, done.stderr
    points = json.loads((tmp_path / "out/law.json").read_text())["report"]["points"]
    assert points and all(point["t_start"] == 12 for point in points)
    paper = table(tmp_path / "out/paper/creep.csv")
    for row, other in zip(table(tmp_path / "out/creep_band.csv"), paper, strict=True):
        assert 0.0 < float(row["standard_error"]) < 0.05
        assert float(row["low"]) < float(other["traction_ratio"]) < float(row["high"])
    # logs that give no law leave no curve of another one
    before = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"creep.csv", "creep_band.csv", "creep.png", "fit.png", "summary.json"} <= before
    (tmp_path / "out/notes.txt").write_text("mine")
    one = tmp_path / "campaign/run01"
    done = subprocess.run(
        [SOURCE / "tools/campaign_to_creep.sh", one, "-o", tmp_path / "out"],
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, "MCAWR_BUILD": str(BIN.parents[1])},
    )
    assert done.returncode == 4
    left = {path.name for path in (tmp_path / "out").iterdir()}
    assert left == {"law.json", "runs.csv", "notes.txt", "paper"}
    assert not list((tmp_path / "out/paper").iterdir())
    done = subprocess.run(
        [SOURCE / "tools/campaign_to_creep.sh", tmp_path / "none", "-o", tmp_path / "out2"],
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, "MCAWR_BUILD": str(BIN.parents[1])},
    )
    assert done.returncode == 3
    # nor is a file of measured points that is not there found out at the end
    done = subprocess.run(
        [SOURCE / "tools/campaign_to_creep.sh", one, "--measured", tmp_path / "none.csv"],
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 3 and f"--measured {tmp_path}/none.csv: cannot be read" in done.stderr
    assert "1/3" not in done.stdout
