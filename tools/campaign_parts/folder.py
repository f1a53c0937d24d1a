# SPDX-License-Identifier: GPL-2.0-or-later
"""A campaign's folder: one folder a run, and what can be told from it at any moment.

NAME/run.friction.part  the log while the run is going on
NAME/run.friction       the log of a finished run: its appearance is what makes a run finished
NAME/run.{a,b}.restart  checkpoints, written by turns; run.restart: the end of a finished run
NAME/run.json           parameters, checksums of the input script, of the potential files that it
                        names and of what a finished run left, every attempt with its exact command
NAME/failed.txt         why the run failed; run with --retry tries again
NAME/lock               locked (flock) by the process that works on the run and by lmp itself
"""

import fcntl
import filecmp
import hashlib
import itertools
import json
import math
import os
import re
import time
from collections.abc import Iterable
from typing import Any, TextIO

from mcawr import friction_log, layer_health
from mcawr.errors import BadInput, Exit, Failure
from mcawr.files import read_bytes, read_text, write
from mcawr.numbers import decimal

from . import size
from .plan import ROOT
from .quantities import Run

LOG = "run.friction"
PART = LOG + ".part"
CHECKPOINTS = ("run.a.restart", "run.b.restart", "run.restart")
RESULTS = (LOG, "run.profile", "run.restart")  # what a finished run leaves
# values of a run that may change as it goes on; files of materials, whose quantities count
UNBOUND = ("ns", "checkpoint", "picture", "profile", "material", "upper_material")
AGAIN = "move the run's folder away to make the run again"
RESTART_END = b"LammpS RestartT\0"  # what LAMMPS writes last
SEAL = b"mca-restart 3:\n\0"  # of pair_style mca; its checksum follows, written after all else
UNSEALED = bytes(8)


class FolderError(Failure):
    """One clear line, and the exit code that it means."""

    def __init__(self, text: str, code: int = Exit.BAD_INPUT) -> None:
        super().__init__(code, text)


def keep_plan(path: str, top: str) -> None:
    """Puts the plan beside the runs that are made from it, under the first free name: a plan that
    stands there already, an earlier one or the user's own, is never overwritten."""
    end = os.path.splitext(path)[1]
    for number in itertools.count(1):
        copy = os.path.join(top, f"plan.{number}{end}" if number > 1 else "plan" + end)
        if not os.path.exists(copy):
            return write(copy, read_bytes(path))
        if filecmp.cmp(path, copy, shallow=False):
            return None


def named_otherwise(top: str, runs: list[Run]) -> list[tuple[str, str]]:
    """[(folder, name)] of runs that have begun in another folder than that of their name: one of
    the same parameters, but for those that may change, that is no run of the plan."""

    def key(values: dict[str, Any]) -> str:
        kept = {name: value for name, value in values.items() if name not in UNBOUND}
        return json.dumps(kept, sort_keys=True)

    names = {run.name for run in runs}
    missing = {
        key(run.values): run.name
        for run in runs
        if not os.path.exists(os.path.join(top, run.name, "run.json"))
    }
    found = []
    for name in sorted(os.listdir(top)) if missing and os.path.isdir(top) else []:
        path = os.path.join(top, name, "run.json")
        if name in names or not os.path.isfile(path):
            continue
        try:
            had = key(json.loads(read_text(path))["parameters"])
        except (BadInput, ValueError, LookupError, TypeError, AttributeError):
            continue
        if had in missing:
            found.append((name, missing[had]))
    return found


def checksum(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def inputs_of(run: Run) -> dict[str, str]:
    """{name: checksum} of a run's input script and of the potential files that it names, as far as
    they are found where LAMMPS looks for them."""
    script = read_bytes(run.input)
    found = {run.values["input"]: checksum(script)}
    folders = os.environ.get("LAMMPS_POTENTIALS", "").split(os.pathsep)
    for name in sorted(set(re.findall(r"\S+\.mca\b", script.decode("utf-8", "replace")))):
        for folder in filter(None, [*folders, os.path.join(ROOT, "potentials")]):
            if os.path.isfile(os.path.join(folder, name)):
                found[name] = checksum(read_bytes(os.path.join(folder, name)))
                break
    return found


def _checksum_of(record: dict[str, Any]) -> str:
    return checksum(json.dumps(record, sort_keys=True).encode())


def _check_head(run: Run, head: dict[str, Any]) -> None:
    """The head of a log is that of this run; its material is the weaker one. Raises BadInput."""
    wanted = (
        ("loading", "pressure", "p"),
        ("loading", "velocity", "v"),
        ("material", "strength", "strength"),
        ("material", "youngs_modulus", "E"),
        ("material", "density", "rho"),
    )
    for section, key, name in wanted:
        try:
            given = float(head[section][key])
        except (LookupError, TypeError, ValueError):
            raise BadInput(f"{PART}: its head has no {section}: {key}") from None
        if not math.isclose(given, run.weaker[name], rel_tol=1e-4):
            raise BadInput(
                f"{PART}: its head says {key} {given:g}, the plan {name} {run.weaker[name]:g}"
            )


class RunFolder:
    """What there is of one run."""

    def __init__(self, top: str, run: Run) -> None:
        self.run = run
        self.path = os.path.join(top, run.name)

    def file(self, name: str) -> str:
        return os.path.join(self.path, name)

    def has(self, name: str) -> bool:
        return os.path.exists(self.file(name))

    def text(self, name: str) -> str | None:
        """What stands in a file; None without the file. Raises BadInput."""
        return read_text(self.file(name)) if self.has(name) else None

    def record(self) -> dict[str, Any]:
        """run.json; empty before the first attempt. Raises FolderError if it is not as it was
        written."""
        text = self.text("run.json")
        if text is None:
            return {}
        try:
            record = json.loads(text)
            if record.pop("checksum") == _checksum_of(record):
                return record
        except (ValueError, RecursionError, LookupError, TypeError, AttributeError):
            pass
        raise FolderError(
            f"{self.file('run.json')}: is damaged, or was edited (its checksum does not fit): "
            f"{AGAIN}"
        )

    def write_record(self, record: dict[str, Any]) -> None:
        record = {**record, "checksum": _checksum_of(record)}
        write(self.file("run.json"), json.dumps(record, indent=1) + "\n")

    def core_seconds(self) -> float:
        """What the run has cost so far: of each attempt that has ended, its time on all its
        ranks."""
        return sum(a.get("core_seconds", 0.0) for a in self.record().get("attempts", []))

    def check_same(self) -> None:
        """The folder belongs to this run: same parameters (it may have become longer), input
        script and potential files; what a finished run left is as it left it."""
        record, log = self.record(), self.log()
        if not record:
            if log:
                raise FolderError(f"{self.file('run.json')}: is missing beside {log}: {AGAIN}")
            return
        begun, elsewhere = f"{self.path}: was begun with", "give the run another name or folder"
        for name, value in self.run.values.items():
            old = record["parameters"].get(name)
            if name in UNBOUND or old == value:
                continue
            raise FolderError(f"{begun} {name} = {old}, the plan says {value}: {elsewhere}")
        now = inputs_of(self.run)
        for name in {**record["inputs"], **now}:
            if record["inputs"].get(name) != now.get(name):
                raise FolderError(f"{begun} another {name}, its content has changed: {elsewhere}")
        results = record.get("results", {LOG: None}) if log == LOG else {}
        for name, known in results.items():
            if not self.has(name) or checksum(read_bytes(self.file(name))) != known:
                raise FolderError(
                    f"{self.file(name)}: is damaged, or was changed since the run finished (the "
                    f"checksum in run.json does not fit): {AGAIN}"
                )
        planned = self.run.values["ns"]
        reached = record["parameters"]["ns"] if self.has(LOG) else self.time()
        if reached > planned * (1 + 1e-9):
            raise FolderError(
                f"{self.path}: was run for {reached:g} ns, the plan says {planned:g}: "
                "a run can be made longer, not shorter"
            )

    def is_finished(self) -> bool:
        return (
            self.has(LOG)
            and self.record().get("parameters", {}).get("ns", 0) >= self.run.values["ns"]
        )

    def failure(self) -> str | None:
        """Why the run failed; None if it did not."""
        text = self.text("failed.txt")
        return None if text is None else text.strip()

    def lock(self) -> TextIO | None:
        """The open lock file, locked; None if another process (or an lmp it left) works on the
        run."""
        os.makedirs(self.path, exist_ok=True)
        file = open(self.file("lock"), "a", encoding="utf-8")
        for _ in range(10):  # is_locked of another process may hold it for a moment
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return file
            except BlockingIOError:
                time.sleep(0.02)
        file.close()
        return None

    def is_locked(self) -> bool:
        if not self.has("lock"):
            return False
        with open(
            self.file("lock"), encoding="utf-8"
        ) as file:  # for reading: the folder may be read-only
            try:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
                return False
            except BlockingIOError:
                return True

    def checksums(self) -> dict[str, str]:
        """{name: checksum} of what a finished run leaves, its log under its last name."""
        return {
            name: checksum(read_bytes(self.file(now)))
            for name in RESULTS
            if self.has(now := PART if name == LOG else name)
        }

    def is_whole(self, name: str) -> bool:
        """Whether a restart file was written to its end, and has its checksum."""
        try:
            with open(self.file(name), "rb") as file:
                content = file.read()
        except OSError:
            return False
        return content.endswith(RESTART_END) and SEAL + UNSEALED not in content

    def checkpoint(self) -> str | None:
        """The newest restart file that was written to its end; None if there is none."""
        found = [
            (os.stat(self.file(name)).st_mtime_ns, name)
            for name in CHECKPOINTS
            if self.is_whole(name)
        ]
        return max(found)[1] if found else None

    def log(self) -> str | None:
        """Name of the log there is, finished or not; None if there is none."""
        return next((name for name in (PART, LOG) if self.has(name)), None)

    def time(self) -> float:
        """ns that the log reaches."""
        log = self.log()
        rows = friction_log.last_rows(self.file(log), 1) if log else []
        try:
            return friction_log.number_in(rows[-1], "time") if rows else 0.0
        except (ValueError, IndexError):
            return 0.0

    def why_damaged(self) -> str | None:
        """Why the run cannot go on from the log that it wrote so far; None if it can."""
        try:
            _check_head(self.run, friction_log.read(self.file(PART)).head)
        except BadInput as error:
            return str(error)
        return None

    def why_not_finished(self) -> str | None:
        """Why a run whose lmp ended without an error is none that a law may rest on; None if it
        is one."""
        values, path = self.run.values, self.file(PART)
        try:
            log = friction_log.read(path)
            _check_head(self.run, log.head)
        except BadInput as error:
            return str(error)
        time, end = log.columns["time"], self.record()["parameters"]["ns"]
        row = max(values["row"], self.run.dt)
        if not time or time[-1] < end - 1.5 * row:
            return f"the log ends at {time[-1] if time else 0:g} of {end:g} ns"
        if time[0] > 1.5 * row:
            return f"the log begins at {time[0]:g} ns: rows are missing"
        if not log.columns["links"][-1] > 0:
            return "no link is left"
        half = slice(len(time) // 2, None)
        mu, normal = (
            math.fsum(column) / len(column)
            for column in (log.columns[name][half] for name in ("mu", "normal_stress"))
        )
        if mu <= 0:
            return f"mu of its second half is {mu:.4g}, not above 0: nothing rubs on anything"
        if abs(normal - values["p"]) > self.run.slack(end):
            return (
                f"the mean normal stress of its second half is {normal:.4g} MPa under a pressure "
                f"of {values['p']:g} MPa: the blocks do not carry it"
            )
        if self.has("run.restart") and not self.is_whole("run.restart"):
            return "run.restart is incomplete"
        return None

    def state(self) -> str:
        """finished, running, failed, interrupted or waiting."""
        if self.is_finished():
            return "finished"
        if self.is_locked():
            return "running"
        if self.failure() is not None:
            return "failed"
        return "interrupted" if self.log() else "waiting"

    def column(self, name: str) -> list[float]:
        """A column of the log so far; empty without one."""
        log = self.log()
        text = friction_log.Text.of((self.text(log) if log else None) or "")
        if name not in text.names:
            return []
        place, values = text.names.index(name), []
        for number, line in text.numbered_rows():
            try:
                values.append(decimal(line.split()[place]))
            except IndexError:  # cut
                continue
            except ValueError as error:
                raise FolderError(f"{self.file(str(log))}:{number}: {name}: {error}") from None
        return values

    def mean(self, name: str) -> float | None:
        """Mean of a column over the second half of the log so far; None without one. wr_fit does
        it better."""
        values = self.column(name)
        half = values[len(values) // 2 :]
        return sum(half) / len(half) if half else None

    def doubt(self) -> str | None:
        """What is wrong with the layer of the log so far; None if nothing is, or nothing known."""
        values = self.run.values
        room, lost = self.mean("room"), self.column("lost")
        least = min(
            layer_health.least_room(block["p"], block["E"], block["nu"])
            for block in size.blocks(values)
        )
        found = []
        if room and room < least:
            found.append(
                f"automata have {room:.3f} of the solid's room, at least {least:.3f} is expected: "
                "they sank into each other"
            )
        if lost and lost[-1] > 0:
            found.append(f"{lost[-1]:g} automata left through the held or the driven rows")
        way, broken = values["v"] * values["row"], self.column("broken")  # m/s ns = nm
        smooth = layer_health.smooth_share(broken[len(broken) // 2 :], way, values["d"])
        if smooth > layer_health.SMOOTH:
            found.append(f"worn smooth for {100 * smooth:.0f} % of the second half: too narrow")
        columns = {name: self.column(name) for name in layer_health.NEEDED}
        if layer_health.fall(columns, self.area()) > layer_health.FALL:
            found.append("what flow, breaking or contacts dissipate fell: energy from nothing")
        return "; ".join(found) or None

    def area(self) -> float:
        """Area of the driven layer, nm2; 0 before the log has a head."""
        try:
            geometry = friction_log.head_of(self.file(self.log() or LOG))["geometry"]
            return float(geometry["width"]) * float(geometry["thickness"])
        except (BadInput, Failure, LookupError, TypeError, ValueError):
            return 0.0


def rate_in(top: str, runs: Iterable[Run]) -> float | None:
    """Automaton-steps a second and core of those of the runs that are finished in a folder; None
    without one."""
    work = cost = 0.0
    for run in runs:
        folder = RunFolder(top, run)
        record = folder.record()
        attempts = record.get("attempts", [])
        if folder.is_finished() and all("core_seconds" in attempt for attempt in attempts):
            # as it was run: the plan may have changed
            work += Run(run.name, {**run.values, **record["parameters"]}, run.input).work
            cost += folder.core_seconds()
    return work / cost if cost else None
