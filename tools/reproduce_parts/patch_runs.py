# SPDX-License-Identifier: GPL-2.0-or-later
"""Rolling point contact: the runs of wr_creep behind the figures, and the tables of them."""

import csv
import dataclasses
import io
import json
import math
import os
import subprocess
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from mcawr import tables
from mcawr.errors import Exit, built, fail_as, say
from mcawr.files import make_folder, write_all

from .common import Missing

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
CASE = os.path.join(ROOT, "examples", "wheelrail", "patch.yaml")  # the locomotive wheel
SHIPPED = os.path.join(ROOT, "examples", "wheelrail", "results")
AXES = (6.412142, 8.400566)  # mm, of its ellipse
BOX = 4.2  # semi-axes: rough contacts reach beyond the ellipse
PASSES = 12  # of moving roughness; wr_creep leaves out the first two
SEEDS = tuple(range(1, 11))
CELLS = 8  # on the shortest wave
WAVE, LONGEST, HURST = 3.0, 10.0, 0.8  # mm, mm: shortest and longest wave
# rms slope of the profile along x, as that of the standard surfaces of the line contact; the
# gradient of an isotropic surface is sqrt(2) times as large
SLOPE, SLOPES = 0.02, (0.01, 0.02, 0.04)
STANDARD_WAVE, CUTOFFS = 0.1, (4.0, 3.0, 2.0, 1.0, 0.5)  # mm, of examples/wheelrail/rough.yaml
DENSE = (1e-4, 3e-4, 6e-4, 1e-3, 1.5e-3, 2e-3, 2.5e-3, 3e-3, 4e-3, 5e-3, 7e-3, 0.01, 0.03, 0.1)
FEW = (1e-4, 1e-3, 2.5e-3, 0.01, 0.1)  # what moving roughness is worth
HOT = (2e-3, 5e-3, 0.01, 0.02, 0.03, 0.05, 0.07, 0.1)
SPEEDS = (10, 20, 40)  # m/s
GRIDS = (8, 12, 16, 24, 32)  # cells on the shortest wave; moving roughness: the first two
FRICTION = {  # Eq. 5 without, Eq. 2 with temperature
    "none": ("friction={law: bucher2006, local: true, velocity_term: false}", "thermal=off"),
    "averaged": ("friction={law: bucher2006, local: true}", "thermal.model=averaged"),
    "local": ("friction={law: bucher2006, local: true}", "thermal.model=local"),
}
COLUMNS = (
    "speed", "creep", "traction_ratio", "mu_mean", "temperature_rise", "temperature_max",
    "stick_fraction", "peak_pressure", "real_area", "power_closure", "iterations", "products",
)  # fmt: skip
POLACH = ("mu0", "A", "B", "kA", "kS")


def standard_slope(shortest: float) -> float:
    """rms slope of the profile of the standard surface that is left when its waves end at
    `shortest` (mm): the spectrum of the gradient falls as k^(1 - 2H)."""

    def part(wave: float) -> float:
        return wave ** (2 * HURST - 2) - LONGEST ** (2 * HURST - 2)

    return SLOPE * (part(shortest) / part(STANDARD_WAVE)) ** 0.5


def cells_of(cell: float, axes: Sequence[float] = AXES) -> list[int]:
    """Cells of the box, none longer than `cell` (mm), in even numbers of factors 2, 3 and 5. axes:
    of the ellipse, mm."""

    def is_even_product(n: int) -> bool:
        rest = n
        for p in (2, 3, 5):
            while rest % p == 0:
                rest //= p
        return n % 2 == 0 and rest == 1

    counts = []
    for axis in axes:
        n = int(-(-BOX * axis // cell))
        while not is_even_product(n):
            n += 1
        counts.append(n)
    return counts


@dataclasses.dataclass(frozen=True)
class Run:
    """A call of wr_creep: the name of its folder, what stands beside its points in the table, what
    is changed in the case file, whether Polach's law is fitted to it, and whether its table has the
    limits of T/N by the law's errors."""

    name: str
    labels: dict
    changes: tuple
    polach: bool = False
    case: str = CASE
    band: bool = False


def run(
    mode: str,
    seed: int,
    creep: Sequence[float],
    *,
    heat: str = "none",
    speed: float = 20,
    slope: float = SLOPE,
    wave: float = WAVE,
    cells: int = CELLS,
    polach: bool = False,
) -> Run:
    """The run of one surface, or of a smooth one (mode `smooth`, seed 0) on the same grid.

    slope: of the profile; wave: mm; cells: on the shortest wave; speed: m/s."""
    rough = f"hurst: {HURST}, rms_slope: {slope * 2**0.5:.6g}, wavelength_min: {wave:g} mm"
    rough = f"roughness={{{rough}, wavelength_max: {LONGEST:g} mm, seed: {seed}}}"
    changes = [
        *FRICTION[heat],
        "roughness=none" if mode == "smooth" else rough,
        f"mode={'moving' if mode == 'moving' else 'frozen'}",
        f"contact.domain={BOX:g}",
        f"cells={cells_of(wave / cells)}",
        f"creep=[{', '.join(f'{xi:g}' for xi in creep)}]",
        f"speed={speed:g} m/s",
        f"sensitivities={'false' if mode == 'moving' else 'true'}",
        "fields=none",
    ]
    if mode == "moving":
        changes += [f"moving.passes={PASSES}", "moving.start=steady"]
    labels = {"mode": mode, "heat": heat, "slope": 0 if mode == "smooth" else slope}
    labels |= {"wave": wave, "cells": cells, "seed": seed}
    words = (mode, heat, f"slope{slope:.3g}", f"wave{wave:g}", f"cells{cells}", f"{speed:g}m/s")
    name = "-".join([*words, f"seed{seed}", f"{len(creep)}creeps{creep[0]:g}"]).replace("m/s", "ms")
    return Run(name, labels, tuple(changes), polach)


def low() -> Iterator[Run]:
    """Creep curves without temperature."""
    yield run("smooth", 0, DENSE)
    yield run("smooth", 0, FEW, polach=True)
    for seed in SEEDS:
        yield run("frozen", seed, DENSE)
        yield run("frozen", seed, FEW, polach=True)
        yield run("moving", seed, FEW, polach=True)


def high() -> Iterator[Run]:
    """Creep curves with temperature; moving roughness one creep a run, since some end."""
    for heat in ("averaged", "local"):
        for speed in SPEEDS:
            # the hottest asperities of some seeds have no strength left beyond
            creeps = HOT[:6] if heat == "local" and speed == max(SPEEDS) else HOT
            yield run("smooth", 0, creeps, heat=heat, speed=speed)
            for seed in SEEDS:
                yield run("frozen", seed, creeps, heat=heat, speed=speed)
    for seed in SEEDS:
        for heat, creep in (("averaged", 0.1), ("local", 0.03)):
            yield run("moving", seed, (creep,), heat=heat)


def slope() -> Iterator[Run]:
    """Initial slopes of frozen roughness: three slopes, and the standard surface with its waves
    ended; the grid at one seed."""
    for seed in SEEDS:
        for value in SLOPES:
            yield run("frozen", seed, (1e-3,), slope=value)
        for wave in CUTOFFS:
            yield run("frozen", seed, (1e-3,), slope=standard_slope(wave), wave=wave)
    for cells in GRIDS:
        yield run("smooth", 0, (1e-3,), cells=cells)
        yield run("frozen", 1, (1e-3, 0.01), cells=cells)
    for cells in GRIDS[:2]:
        yield run("moving", 1, (1e-3,), cells=cells)


PLANS = {"patch-low": low, "patch-high": high, "patch-slope": slope}


# runs ---------------------------------------------------------------------------------------------
def words_of(case: str, changes: Iterable[str], *more: str) -> list[str]:
    """A call of wr_creep. Raises Failure where it is not built."""
    words = [built("wr_creep"), case, *more]
    for change in changes:
        words += ["--set", change]
    return words


def call(words: list[str]) -> str:
    """The call to its end. Raises Failure with the program's exit code and line."""
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode:
        fail_as(words[0], done)
    return done.stdout


def record_of(found: Any) -> dict[str, Any]:
    """A JSON file's object. Raises TypeError, ValueError for anything else."""
    return dict(found)


class Folder:
    """The folder of a run."""

    def __init__(self, top: str, a_run: Run) -> None:
        self.run, self.path = a_run, os.path.join(top, a_run.name)

    def file(self, name: str) -> str:
        return os.path.join(self.path, name)

    def why_none(self) -> str | None:
        """The line with which wr_creep found no solution of this very case; None of others."""
        if not os.path.exists(self.file("none.json")):
            return None
        found = tables.read_json(self.file("none.json"), "a run without a solution", record_of)
        return found["why"] if found.get("changes") == list(self.run.changes) else None

    def is_done(self) -> bool:
        """Are the results of this very case there? wr_creep goes on by itself with others."""
        if self.why_none():
            return True
        if not os.path.exists(self.file("creep.csv")):
            return False
        case = call(words_of(self.run.case, self.run.changes, "--print-config"))
        summary = tables.read_json(self.file("summary.json"), "a summary of wr_creep", record_of)
        return summary.get("case", "").strip() == case.strip()

    def start(self) -> subprocess.Popen[str]:
        make_folder(self.path)
        words = ["-o", self.path, "-q", "--threads", "1"]
        words += ["--polach", self.file("polach.json")] if self.run.polach else []
        return subprocess.Popen(
            words_of(self.run.case, self.run.changes, *words),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
        )

    def end(self, process: subprocess.Popen[str]) -> None:
        """Takes what a run that has ended left behind. Raises Failure as wr_creep ended, unless it
        found no solution (exit code 4), which is a result."""
        stderr = process.stderr.read() if process.stderr else ""
        if process.returncode == Exit.NOT_CONVERGED and not os.path.exists(self.file("creep.csv")):
            why = stderr.strip().splitlines()[-1].removeprefix("wr_creep: ")
            record = json.dumps({"why": why, "changes": list(self.run.changes)}, indent=1)
            write_all({self.file("none.json"): record + "\n"})
        elif process.returncode not in (0, Exit.NOT_CONVERGED):
            done = subprocess.CompletedProcess(process.args, process.returncode, "", stderr)
            fail_as("wr_creep", done)


def compute(
    runs: Iterable[Run], top: str, jobs: int, report: Callable[[str], object] = say
) -> None:
    """Makes the runs that are not done in folders below `top`, `jobs` at a time; what was
    interrupted goes on."""
    waiting = [folder for folder in (Folder(top, r) for r in runs) if not folder.is_done()]
    count = len(waiting)
    working: dict[subprocess.Popen[str], Folder] = {}
    try:
        while waiting or working:
            while waiting and len(working) < jobs:
                folder = waiting.pop(0)
                working[folder.start()] = folder
            for process in [p for p in working if p.poll() is not None]:
                folder = working.pop(process)
                folder.end(process)
                left = len(waiting) + len(working)
                report(f"{count - left} of {count}: {folder.run.name} {folder.why_none() or ''}")
            time.sleep(0.02)
    finally:
        for process in working:
            process.terminate()  # wr_creep keeps its journal
        for process in working:
            process.wait()


# tables -------------------------------------------------------------------------------------------
HEAD = (
    "# Rolling of the locomotive wheel (examples/wheelrail/patch.yaml), by tools/reproduce --run\n"
    "# mode: surface; heat: model of the temperature; slope: rms of the profile along x; wave: "
    "shortest, mm; cells: on it; speed: m/s; temperature: K; peak_pressure: MPa; real_area: mm2; "
    "c11, c22: Kalker's, of the surface at the start; a point without traction_ratio has no "
    "solution (the strength ends)\n"
)


def rounded(text: str | float, digits: int = 6) -> str:
    return f"{float(text):.{digits}g}"


def table(runs: Iterable[Run], top: str, head: str = HEAD) -> tuple[str, str | None]:
    """The table of all points, and that of the fits of Polach's law, as CSV."""
    points_, fits, versions = [], [], set()
    for folder in (Folder(top, r) for r in runs):
        if folder.why_none():
            points_.append(folder.run.labels | asked(folder.run))
            continue
        rows = tables.read(folder.file("creep.csv"), "a creep.csv of wr_creep", lambda r: r)
        summary = tables.read_json(folder.file("summary.json"), "a summary of wr_creep", record_of)
        versions.add(summary["version"])
        kalker = summary["contacts"][0].get("kalker", {})
        for row in rows:
            point = folder.run.labels | {name: rounded(row[name]) for name in COLUMNS}
            point |= {name: rounded(kalker[name]) for name in ("c11", "c22") if kalker}
            points_.append(point)
        if folder.run.band:
            band = tables.read(folder.file("creep_band.csv"), "a band of wr_creep", lambda r: r)
            for point, row in zip(points_[-len(rows) :], band):
                point |= {f"law_{end}": rounded(row[end]) for end in ("low", "high")}
        if folder.run.polach and os.path.exists(folder.file("polach.json")):
            fit = tables.read_json(folder.file("polach.json"), "a fit of Polach's law", record_of)
            values = {name: rounded(fit[name], 5) for name in POLACH}
            values |= {f"{name}_se": rounded(fit["standard_error"][name], 3) for name in POLACH}
            values |= {"rms": rounded(fit["rms_force_over_load"], 3)}
            fits.append(folder.run.labels | values)
    made = f"# wr_creep {', '.join(sorted(versions))}\n"
    return as_csv(points_, head + made), as_csv(fits, head + made) if fits else None


def asked(a_run: Run) -> dict[str, str]:
    """Speed and creep of a run of one point, from its changes."""
    given = dict(change.split("=", 1) for change in a_run.changes)
    return {"speed": given["speed"].split()[0], "creep": given["creep"].strip("[]")}


def as_csv(rows: list[dict[str, Any]], head: str = HEAD) -> str:
    """Rows of a table as CSV; head: lines of comment."""
    columns = list(dict.fromkeys(name for row in rows for name in row))
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return head + text.getvalue()


def make(plan: str, top: str, jobs: int) -> None:
    """The runs of a plan in TOP/PLAN, and its tables TOP/PLAN.csv and TOP/PLAN-polach.csv."""
    runs = list(PLANS[plan]())
    compute(runs, os.path.join(top, plan), jobs)
    found, fits = table(runs, os.path.join(top, plan))
    path = os.path.join(top, plan)
    write_all({f"{path}.csv": found} | ({f"{path}-polach.csv": fits} if fits else {}))


def read(name: str, folder: str) -> list[dict[str, Any]]:
    """Rows of a table as dicts, numbers as floats (nan where there is none). Raises BadInput."""
    path = os.path.join(folder, f"{name}.csv")
    if not os.path.exists(path):
        raise Missing(f"{path}: is not there: give another folder by --logs, or make it by --run")

    def numbers(rows: list[tables.Row]) -> list[dict[str, Any]]:
        words = ("mode", "heat", "law")
        return [
            {k: v if k in words else row.number(k) if v else math.nan for k, v in row.items()}
            for row in rows
        ]

    return tables.read(path, "a table of reproduce --run", numbers)


def tables_of(plans: Iterable[str], folder: str) -> dict[str, list[dict[str, Any]]]:
    """{name: rows} of the tables of plans; NAME-polach are fits of Polach's law, where there are
    any. Raises BadInput."""
    found = {plan: read(plan, folder) for plan in plans}
    for plan in plans:
        if os.path.exists(os.path.join(folder, f"{plan}-polach.csv")):
            found[f"{plan}-polach"] = read(f"{plan}-polach", folder)
    return found
