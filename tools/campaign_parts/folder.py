# SPDX-License-Identifier: GPL-2.0-or-later
"""A campaign's folder: one folder a run, and what can be told from it at any moment.

NAME/run.friction.part  the log while the run is going on
NAME/run.friction       the log of a finished run: its appearance is what makes a run finished
NAME/run.{a,b}.restart  checkpoints, written by turns; run.restart: the end of a finished run
NAME/run.json           parameters, input script, and every attempt with its exact command
NAME/failed.txt         why the run failed; run with --retry tries again
NAME/lock               locked (flock) by the process that works on the run and by lmp itself
"""

import fcntl
import filecmp
import itertools
import json
import os
import time

from mcawr import friction_log
from mcawr.errors import Exit, Failure
from mcawr.files import write

LOG = "run.friction"
PART = LOG + ".part"
CHECKPOINTS = ("run.a.restart", "run.b.restart", "run.restart")
RESTART_END = b"LammpS RestartT\0"  # what LAMMPS writes last


class FolderError(Failure):
    """One clear line, and the exit code that it means."""

    def __init__(self, text, code=Exit.BAD_INPUT):
        super().__init__(code, text)


def keep_plan(path, top):
    """Puts the plan beside the runs that are made from it, under the first free name: a plan that
    stands there already, an earlier one or the user's own, is never overwritten."""
    end = os.path.splitext(path)[1]
    for number in itertools.count(1):
        copy = os.path.join(top, f"plan.{number}{end}" if number > 1 else "plan" + end)
        if not os.path.exists(copy):
            with open(path, encoding="utf-8", newline="") as file:
                return write(copy, file.read())
        if filecmp.cmp(path, copy, shallow=False):
            return None


class RunFolder:
    """What there is of one run."""

    def __init__(self, top, run):
        self.run = run
        self.path = os.path.join(top, run.name)

    def file(self, name):
        return os.path.join(self.path, name)

    def text(self, name):
        """What stands in a file; None without the file."""
        try:
            with open(self.file(name), encoding="utf-8") as file:
                return file.read()
        except (FileNotFoundError, NotADirectoryError):
            return None
        except (OSError, UnicodeDecodeError) as error:
            raise FolderError(
                f"{self.file(name)}: cannot be read: {getattr(error, 'strerror', None) or error}"
            ) from None

    def record(self):
        """run.json; empty before the first attempt."""
        text = self.text("run.json")
        if text is None:
            return {}
        try:
            record = json.loads(text)
            begun = isinstance(record["parameters"]["ns"], (int, float)) and record["attempts"]
            if begun and all(isinstance(attempt["command"], str) for attempt in record["attempts"]):
                return record
        except (ValueError, RecursionError, LookupError, TypeError):
            pass
        raise FolderError(
            f"{self.file('run.json')}: is damaged (no parameters with ns, or no attempts with "
            "their commands): "
            "move the run's folder away to make the run again"
        )

    def write_record(self, record):
        write(self.file("run.json"), json.dumps(record, indent=1) + "\n")

    def check_same(self):
        """The folder belongs to this run: same parameters, where the record has them; the duration
        may have changed."""
        old = self.record().get("parameters", {})
        for name, value in self.run.values.items():
            if (
                name in ("ns", "checkpoint", "picture", "profile")
                or name not in old
                or old[name] == value
            ):
                continue
            raise FolderError(
                f"{self.path}: was begun with {name} = {old[name]}, the plan says {value}: give "
                "the run "
                "another name or use another folder"
            )

    def check_not_shorter(self):
        """The run may be made longer than it is."""
        old, now = self.record().get("parameters", self.run.values)["ns"], self.run.values["ns"]
        if old > now and os.path.exists(self.file(LOG)):
            raise FolderError(
                f"{self.path}: was run for {old:g} ns, the plan says {now:g}: "
                "a run can be made longer, not shorter"
            )

    def is_finished(self):
        return (
            os.path.exists(self.file(LOG))
            and self.record().get("parameters", {}).get("ns", 0) >= self.run.values["ns"]
        )

    def failure(self):
        """Why the run failed; None if it did not."""
        text = self.text("failed.txt")
        return None if text is None else text.strip()

    def lock(self):
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

    def is_locked(self):
        if not os.path.exists(self.file("lock")):
            return False
        with open(
            self.file("lock"), encoding="utf-8"
        ) as file:  # for reading: the folder may be read-only
            try:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
                return False
            except BlockingIOError:
                return True

    def checkpoint(self):
        """The newest restart file that was written to its end; None if there is none."""
        found = []
        for name in CHECKPOINTS:
            try:
                with open(self.file(name), "rb") as file:
                    file.seek(-len(RESTART_END), os.SEEK_END)
                    if file.read() == RESTART_END:
                        found.append((os.fstat(file.fileno()).st_mtime_ns, name))
            except OSError:
                continue
        return max(found)[1] if found else None

    def log(self):
        """Name of the log there is, finished or not; None if there is none."""
        return next((name for name in (PART, LOG) if os.path.exists(self.file(name))), None)

    def time(self):
        """ns that the log reaches."""
        log = self.log()
        rows = friction_log.last_rows(self.file(log), 1) if log else []
        try:
            return friction_log.number_in(rows[-1], "time") if rows else 0.0
        except (ValueError, IndexError):
            return 0.0

    def why_not_whole(self):
        """Why the log is not that of a whole run, as it was last begun; None if it is."""
        reached, end = self.time(), self.record()["parameters"]["ns"]
        if reached > 0 and reached >= end - 1.5 * max(self.run.values["row"], self.run.dt):
            return None
        return f"the log ends at {reached:g} of {end:g} ns"

    def state(self):
        """finished, running, failed, interrupted or waiting."""
        if self.is_finished():
            return "finished"
        if self.is_locked():
            return "running"
        if self.failure() is not None:
            return "failed"
        return "interrupted" if self.log() else "waiting"

    def mean_mu(self):
        """Mean mu of the second half of the log so far; None without one. wr_fit does it better."""
        log = self.log()
        values = []
        text = self.text(log) if log else None
        for number, line in enumerate((text or "").split("\n")[:-1], 1):
            if not friction_log.is_row(line):
                continue
            try:
                values.append(friction_log.number_in(line.split(), "mu"))
            except IndexError:  # cut
                continue
            except ValueError as error:
                raise FolderError(f"{self.file(log)}:{number}: mu: {error}") from None
        half = values[len(values) // 2 :]
        return sum(half) / len(half) if half else None
