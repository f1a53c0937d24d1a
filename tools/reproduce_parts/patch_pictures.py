# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of point contacts whose runs of wr_creep take seconds."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from typing import Any

from mcawr.errors import fail_as
from mcawr.files import write

from . import patch_runs

TOOLS = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))


def computed(
    folder: str, name: str, mode: str, seed: int, creep: Sequence[float], *more: Any, **choice: Any
) -> str:
    """Folder of a run that has been made now."""
    made = os.path.join(folder, name)
    a_run = patch_runs.run(mode, seed, creep, **choice)
    words = patch_runs.words_of(patch_runs.CASE, (*a_run.changes, *more), "-o", made, "-q")
    patch_runs.call(words)
    return made


def plot_patch(*words: str) -> None:
    done = subprocess.run(
        [sys.executable, os.path.join(TOOLS, "plot_patch.py"), *words],
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )
    if done.returncode:
        fail_as("plot_patch.py", done)


def some_fields(folder: str, creep: float, cells: int, *modes: Any) -> list[str]:
    """Files with the fields of these modes (of seed 1) at one creep."""
    files = []
    for mode in modes:
        seed = 0 if mode == "smooth" else 1
        more = ["fields=last", *(["moving.passes=2"] if mode == "moving" else [])]
        made = computed(folder, mode, mode, seed, (creep,), *more, cells=cells)
        files.append(os.path.join(made, "fields_0001.vti"))
    return files


def fields(_: object, picture: str) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        modes = ("smooth", "frozen", "moving")
        files = some_fields(folder, 1e-3, 12, *modes)
        labels = [word for mode in modes for word in ("--label", mode)]
        plot_patch("fields", *files, *labels, "-o", picture)
    return ["creep 0.1 %, seed 1; moving: after 26 mm of rolling"]


def fig13(_: object, picture: str) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        files = some_fields(folder, 2.5e-3, 12, "smooth", "frozen")
        plot_patch("friction", *files, "--label", "smooth", "--label", "frozen", "-o", picture)
    return ["creep 0.25 %, Eq. 5 with the pressure of each cell, seed 1"]


FORCES = {  # creepages of the curves, linear from 0 on
    "creep": [f"creep={{from: 0, to: {1e-2:g}, n: 21, spacing: linear}}"],
    "lateral": ["creep=0", f"lateral={{from: 0, to: {1e-2:g}, n: 21, spacing: linear}}"],
    "spin": ["creep=0", "spin={from: 0 1/mm, to: 2e-3 1/mm, n: 21, spacing: linear}"],
}


def curves(_: object, picture: str) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for mode, seed in (("smooth", 0), ("frozen", 1)):
            text = ""
            for name, changes in FORCES.items():
                made = computed(folder, f"{mode}-{name}", mode, seed, (0,), *changes)
                with open(os.path.join(made, "creep.csv"), encoding="utf-8") as file:
                    lines = [line for line in file if not line.startswith("#")]
                text += "".join(lines if not text else lines[1:])
            files.append(os.path.join(folder, f"{mode}.csv"))
            write(files[-1], text)
        plot_patch("curves", *files, "--label", "smooth", "--label", "frozen", "-o", picture)
    return ["without temperature, Eq. 5 with the pressure of each cell, seed 1"]


def start(_: object, picture: str) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name, mode, seed in (("smooth", "smooth", 0), ("moving", "moving", 1)):
            more = ["mode=moving", "moving.passes=4", "moving.start=rest", "sensitivities=false"]
            made = computed(folder, name, mode, seed, (1e-3,), *more)
            files.append(os.path.join(made, "series.csv"))
        plot_patch("transient", *files, "--label", "smooth", "--label", "moving", "-o", picture)
    return ["creep 0.1 %, pressed together, then rolled; seed 1"]
