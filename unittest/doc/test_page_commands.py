# SPDX-License-Identifier: GPL-2.0-or-later
"""The worked examples of every page: each command of a program or a script of ours that needs
minutes at most is run as it stands, in order, in a copy of the checkout, and ends with 0. Point
contacts have a quarter of their cells there.

What a user brings along (logs, a campaign, a law, a measured curve) lies there: synthetic logs of
Eq. 2."""

import itertools
import os
import re
import shutil
import subprocess
import tarfile
from pathlib import Path

import friction_logs
import pytest

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("MCAWR_LMP", str(ROOT / "build" / "bin" / "lmp"))).parent

PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    *sorted((ROOT / "doc").glob("*.md")),
    *sorted((ROOT / "examples").glob("**/README.md")),
]
# run here
PROGRAMS = {"wr_fit", "wr_creep"}
SCRIPTS = {
    "campaign_to_creep.sh",
    "contact_inp.py",
    "plot_creep.py",
    "plot_fit.py",
    "plot_friction.py",
    "plot_patch.py",
    "plot_series.py",
}
# not run here, and why
ELSEWHERE = {
    "lmp": "minutes; doc_test_examples runs them shorter",
    "plot_fragment.py": "needs a run's dump; tools_test_plot_fragment",
    "plot_layer.py": "needs a run's profile; tools_test_plot_layer",
    "dump_to_vtk.py": "needs a run's dump; tools_test_dump_to_vtk",
    "plot_mechanics.py": "an hour",
    "campaign": "hours; tools_test_campaign with a stand-in for lmp",
    "reproduce": "minutes to days; tools_test_reproduce",
    "creep_table.py": "minutes; test_creep_table",
    "plot_shakedown.py": "needs stresses; tools_test_plot_shakedown",
    "benchmark.py": "minutes on a quiet machine",
    "wr_patch_benchmark": "minutes on a quiet machine",
    "setup.sh": "builds; CI",
    "quickstart.sh": "builds and runs; tools_test_scripts",
    "check.sh": "runs the tests",
    "newcomer.sh": "a bare Debian",
    "build_docs.sh": "site_test_site",
    "gate": "CI",
}


def commands_of(page):
    """[command] of the page's blocks outside of Syntax; continued lines are one."""
    text = page.read_text(encoding="utf-8")
    text = re.sub(r"^## Syntax\n.*?(?=^## )", "", text, flags=re.MULTILINE | re.DOTALL)
    blocks = re.findall(r"^```(?:sh|text)\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    lines = "\n".join(blocks).replace("\\\n", " ").split("\n")
    return [line for line in lines if program_of(line)]


def program_of(line):
    """Name of the program or script of ours that a line begins with; empty: another line."""
    words = re.sub(r"^(?:mpirun -np \d+|nohup|[A-Z_]+=\S+) ", "", line.strip()).split()
    found = re.fullmatch(r"(?:~|[.\w-]*/)*(?:bin/|tools/)?([\w.]+)", words[0]) if words else None
    name = found[1] if found else ""
    known = {*PROGRAMS, *SCRIPTS, *ELSEWHERE}
    placed = bool(found) and bool(re.search(r"(?:^|/)(?:tools|build/bin)/", words[0]))
    return name if placed or (name in known - {"campaign", "gate"} and len(words) > 1) else ""


def is_run_here(command):
    return program_of(command) in PROGRAMS | SCRIPTS


def half(cells):
    """The line of a case's cells with half of them along each axis."""
    return f"cells: [{int(cells[1]) // 2}, {int(cells[2]) // 2}]"


def checkout(folder):
    """What a user has: the checkout, and beside it what pages call campaign, logs, run.friction,
    law.json."""
    for name in ("doc", "tools", "potentials"):
        (folder / name).symlink_to(ROOT / name)
    shutil.copytree(ROOT / "examples", folder / "examples")
    for case in (folder / "examples").glob("**/*.yaml"):
        text = case.read_text("utf-8")
        coarse = re.sub(r"(?m)^cells: \[(\d+), (\d+)\]", half, text)
        case.write_text(coarse, "utf-8")
    (folder / "build").mkdir()
    (folder / "build" / "bin").symlink_to(BIN)
    return folder


def bring_along(folder):
    campaign = friction_logs.campaign(folder / "campaign", velocities=(1, 2.5, 5, 10), ns=260)
    with tarfile.open(folder / "plan.tar.xz", "w:xz", preset=0) as archive:
        for log in campaign.glob("*/run.friction"):
            archive.add(log, f"{log.parent.name}.friction")
    for name in ("paper36", "smoke"):
        if not (folder / name).exists():
            (folder / name).symlink_to(folder / "campaign")
    with tarfile.open(ROOT / "examples/campaign/logs/own-material.tar.xz") as archive:
        archive.extractall(folder / "aluminium")
    for name in ("run", "friction"):
        (folder / f"{name}.friction").write_text(friction_logs.friction_log(ns=150), "utf-8")
    for v, p in itertools.product((2, 5, 10), (15, 20, 26)):
        log = friction_logs.friction_log(p=p, v=v, ns=150, seed=v * p)
        (folder / f"v{v}-p{p}.friction").write_text(log, "utf-8")
    rows = (f"{0.1 * k:.1f},{0.4 + 0.01 * (k * k % 7)}" for k in range(300))
    (folder / "tribometer.csv").write_text("\n".join(("time,mu", *rows)), "utf-8")
    curve = (f"{creep},36,{0.3 * creep / (0.3 + creep)}" for creep in (0.1, 0.2, 0.5, 1, 2, 5, 10))
    units = ("# creep: %", "# speed: km/h", "creep,speed,traction_ratio")
    (folder / "measured.csv").write_text("\n".join((*units, *curve)), "utf-8")
    call(folder, f"{BIN}/wr_fit campaign -o law.json")


def call(folder, command):
    """What it shows."""
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=folder,
        env={**os.environ, "PATH": f"{BIN}:{os.environ['PATH']}"},
        timeout=600,
        text=True,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, f"{command}\n{done.stdout[-1500:]}{done.stderr[-1500:]}"
    return done.stdout


def pages_that_run():
    pages = [page for page in PAGES if any(map(is_run_here, commands_of(page)))]
    assert len(pages) > 8
    return pages


@pytest.mark.parametrize("page", pages_that_run(), ids=lambda page: str(page.relative_to(ROOT)))
def test_worked_examples_run(page, tmp_path):
    top = checkout(tmp_path)
    text = page.read_text(encoding="utf-8")
    own = page.parent.name != "logs" and "From the top folder of the checkout" not in text
    inside = page.is_relative_to(ROOT / "examples") and own
    start = top / page.parent.relative_to(ROOT) if inside else top
    bring_along(start)
    for command in filter(is_run_here, commands_of(page)):
        call(start, command)


def test_worked_examples_of_wr_fits_help_run(tmp_path):
    """wr_creep's: wheelrail_test_wr_creep_examples."""
    bring_along(checkout(tmp_path))
    shutil.copy(ROOT / "examples/campaign/logs/paper36.tar.xz", tmp_path)
    shown = call(tmp_path, "wr_fit --help")
    commands = re.findall(r"^  (wr_fit .*)$", shown.split("Examples:")[1], re.MULTILINE)
    assert len(commands) == 6
    for command in commands:
        call(tmp_path, command)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_command_is_known(page):
    """A command on a page is run here, or it is said why not."""
    unknown = [
        command
        for command in commands_of(page)
        if program_of(command) not in {*PROGRAMS, *SCRIPTS, *ELSEWHERE}
    ]
    assert not unknown


def test_commands_are_found():
    commands = commands_of(ROOT / "doc" / "wr_fit.md")
    assert sum(command.startswith("wr_fit ") for command in commands) == 8
    assert program_of("mpirun -np 2 build/bin/lmp -in in.x") == "lmp"
    assert program_of("../../tools/plot_layer.py x") == "plot_layer.py"
    assert not program_of("campaign: 3") and not program_of("gate | holds")
