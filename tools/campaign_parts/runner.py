# SPDX-License-Identifier: GPL-2.0-or-later
"""Running the runs of a campaign: start, watch, go on after a kill, report."""

import ctypes
import datetime
import math
import os
import re
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from typing import NoReturn, TextIO

from mcawr import errors, programs
from mcawr.files import write

from . import folder as folders
from .quantities import Run

POLL = 0.25  # s between looks at the running processes
REPORT = 60.0  # s between progress lines when the output is no terminal
WORTH = 600.0  # s that a run has left where it is worth to go on from its checkpoint on more ranks
LEAST = 500  # automata of a rank: 1600 on two take 0.65 of the time (doc/performance.md)
MPI_VARIABLES = ("OMPI_", "PMIX_", "PMI_", "PRTE_", "ORTE_", "MPI_LOCALRANKID", "SLURM_")
ALLOWED = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM")
RANKS = (
    ("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
    ("PMI_RANK", "PMI_SIZE"),
    ("SLURM_PROCID", "SLURM_STEP_NUM_TASKS"),
)  # a batch script has a SLURM_PROCID and SLURM_NTASKS too


def place() -> tuple[int, int]:
    """(rank, size) if an MPI launcher or srun started this program several times, else (0, 1)."""
    for names in RANKS:
        words = [os.environ.get(name, "") for name in names]
        if all(word.isdecimal() for word in words):
            return int(words[0]), int(words[1])
    return 0, 1


def lmp_program() -> str:
    """lmp with the plugin: $MCAWR_LMP, else build/bin/lmp or that of the installed tree."""
    return os.environ.get("MCAWR_LMP") or programs.program("lmp")


def command(
    run: Run, launcher: Iterable[str] = (), go_on_from: str | None = None, attempt: int = 1
) -> list[str]:
    """The exact command of a run, to be run in its folder."""
    words = [
        *launcher,
        lmp_program(),
        "-in",
        run.input,
        "-log",
        f"log.{attempt}.lammps",
        "-screen",
        "none",
    ]
    for name, value in run.variables().items():
        words += ["-var", name, value]
    words += ["-var", "name", "run", "-var", "log", folders.PART, "-var", "pictures", "run.*.dump"]
    if go_on_from:
        words += ["-var", "continue", "1", "-var", "restart", go_on_from]
    return words


def _environment(nested: bool) -> dict[str, str]:
    """Environment of lmp: as root too; inside mpirun, lmp must not take part in the outer job."""
    env = {
        name: value
        for name, value in os.environ.items()
        if not nested or not name.startswith(MPI_VARIABLES)
    }
    for name in ALLOWED:
        env[name] = "1"
    env.setdefault("OMPI_MCA_rmaps_base_oversubscribe", "1")
    env.setdefault("OMPI_MCA_hwloc_base_binding_policy", "none")
    return env


def _die_with_parent() -> None:
    """In the child: SIGTERM when the campaign dies, so that a kill of it leaves no lmp behind."""
    pr_set_pdeathsig = 1
    ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGTERM)


# what ends a run from outside; any other signal is a fault of the run
OUTSIDE = {signal.SIGHUP, signal.SIGINT, signal.SIGKILL, signal.SIGTERM, signal.SIGXCPU}
FULL = ("No space left on device", "Disk quota exceeded", "File too large")


def is_full(path: str, why: object = "") -> bool:
    """Whether a failure is that of a full disk."""
    if any(text in str(why) for text in FULL):
        return True
    try:
        disk = os.statvfs(path)
    except OSError:  # the folder is gone
        return False
    return disk.f_bavail * disk.f_frsize < 65536


def _killed_by(code: int) -> signal.Signals | None:
    """The signal behind an exit code of lmp or of what started it; None if there is none."""
    number = -code if code < 0 else code - 128
    return signal.Signals(number) if number in set(signal.Signals) else None


def _now() -> str:
    return datetime.datetime.now().astimezone().isoformat(timespec="seconds")


def _leftovers(path: str) -> list[int]:
    """Processes of an earlier call that still work in a run's folder: mpirun takes a while to end
    its ranks, and does not keep the lock open as lmp does."""
    found = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        try:
            with open(f"/proc/{entry}/cmdline", "rb") as file:
                ours = folders.PART.encode() in file.read()
            if ours and os.readlink(f"/proc/{entry}/cwd") == os.path.realpath(path):
                found.append(int(entry))
        except OSError:
            continue
    return found


def end_leftovers(path: str, patience: float = 10.0) -> None:
    """Ends them, so that no two lmp write the same files. Only called with the run's lock held."""
    began = time.monotonic()
    while left := _leftovers(path):
        number = signal.SIGTERM if time.monotonic() - began < patience else signal.SIGKILL
        for process in left:
            try:
                os.kill(process, number)
            except ProcessLookupError:
                pass
        time.sleep(0.2)


def mpirun(ranks: int) -> list[str]:
    """What starts lmp on so many ranks."""
    return ["mpirun", "-np", str(ranks)] if ranks > 1 else []


class Attempt:
    """One lmp working on one run; the run's lock is held by us and by lmp."""

    def __init__(
        self,
        folder: folders.RunFolder,
        lock: TextIO,
        launcher: Iterable[str],
        nested: bool,
        ranks: int = 1,
    ) -> None:
        self.folder, self.lock, self.ranks = folder, lock, ranks
        end_leftovers(folder.path)
        self.began = time.monotonic()
        record = folder.record()
        number = len(record.get("attempts", [])) + 1
        path = folder.file
        if folder.has(folders.LOG):  # finished, and made longer since
            os.replace(path(folders.LOG), path(folders.PART))
        checkpoint = folder.checkpoint() if folder.has(folders.PART) else None
        self.anew = folder.why_damaged() if checkpoint else None
        if self.anew:
            checkpoint = None
        if folder.has("failed.txt"):
            os.remove(path("failed.txt"))
        words = command(folder.run, launcher, checkpoint, number)
        record.update(
            parameters=folder.run.values,
            kappa1=folder.run.kappa1,
            kappa2=folder.run.kappa2,
            inputs=folders.inputs_of(folder.run),
        )
        record.pop("results", None)
        record.setdefault("attempts", []).append(
            {
                "begin": _now(),
                "host": os.uname().nodename,
                "from": checkpoint or "start",
                "command": shlex.join(words),
            }
        )
        folder.write_record(record)
        self.time_at_start = folder.time() if checkpoint else 0.0
        with open(path(f"output.{number}.txt"), "wb") as output:
            self.process = subprocess.Popen(
                words,
                cwd=folder.path,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                env=_environment(nested),
                pass_fds=[lock.fileno()],
                preexec_fn=_die_with_parent,
            )
        self.number, self.stopped = number, False
        self.widens = False  # it is ended to go on on more ranks

    def stop(self) -> None:
        """Ends lmp, if it has not ended yet."""
        if self.process.poll() is None:
            self.stopped = True
            self.process.terminate()

    def work(self) -> float:
        """Automaton-steps done in this attempt."""
        values = self.folder.run.values
        share = (self.folder.time() - self.time_at_start) / values["ns"]
        return max(0.0, share) * self.folder.run.work

    def left(self) -> float:
        """Seconds that are left at the speed so far; 0 before the first row of the log."""
        run, done = self.folder.run, self.work()
        share = 1 - self.folder.time() / run.values["ns"]
        return share * run.work / done * (time.monotonic() - self.began) if done > 0 else 0.0

    def outcome(self) -> tuple[str, str | None]:
        """('finished', 'failed', 'interrupted' or 'full': the disk is, why)."""
        code = self.process.returncode
        if self.stopped:
            return "interrupted", "ended with the campaign"
        if killer := _killed_by(code):
            if killer in OUTSIDE:
                return "interrupted", f"killed by {killer.name}"
            why: str | None = self.error() or f"ended by {killer.name}"
        elif code:
            why = self.error() or f"exit code {code}"
        else:
            cut = self.folder.why_not_finished()
            why = cut and f"ended without an error, but {cut}"
        if not why:
            return "finished", None
        return ("full" if is_full(self.folder.path, why) else "failed"), why

    def end(self) -> tuple[str, str | None]:
        """outcome(), once lmp has ended, with all that it means for the folder; a folder that it
        cannot be written into is a fault of this run alone."""
        folder, path = self.folder, self.folder.file
        seconds = time.monotonic() - self.began
        try:
            record = folder.record()
            if not record:
                raise folders.FolderError(f"{path('run.json')}: is gone")
            outcome, why = self.outcome()
            record["attempts"][-1].update(
                end=_now(),
                seconds=round(seconds, 1),
                core_seconds=round(seconds * (self.ranks_in_log() or self.ranks), 1),
                outcome=why or outcome,
            )
            if outcome == "finished":
                record["results"] = folder.checksums()
            if outcome == "failed":
                write(path("failed.txt"), f"{why}\n")
            folder.write_record(record)
            if outcome == "finished":
                os.replace(path(folders.PART), path(folders.LOG))
                for name in folders.CHECKPOINTS[:2]:
                    if folder.has(name):
                        os.remove(path(name))
        except (OSError, errors.Failure) as error:
            outcome = "full" if is_full(folder.path, error) else "failed"
            why = str(error)
        finally:
            self.lock.close()
        return outcome, why

    def ranks_in_log(self) -> int | None:
        """On how many ranks lmp ran, by its own words, whatever started it; None if it was ended
        before them."""
        try:
            with open(
                self.folder.file(f"log.{self.number}.lammps"), encoding="utf-8", errors="replace"
            ) as file:
                found = re.search(r"(\d+) by (\d+) by (\d+) MPI processor grid", file.read())
        except OSError:
            return None
        return math.prod(map(int, found.groups())) if found else None

    def error(self) -> str | None:
        """The line that says why lmp gave up; the last one that it wrote where none is an error."""
        written: list[str] = []
        for name in (f"log.{self.number}.lammps", f"output.{self.number}.txt"):
            try:
                with open(self.folder.file(name), encoding="utf-8", errors="replace") as file:
                    written = [line.strip() for line in file if line.strip()]
            except OSError:
                continue
            if lines := [line for line in written if "ERROR" in line or "rror:" in line]:
                return lines[-1]
        return written[-1] if written else None


def hours(seconds: float) -> str:
    """Seconds as h:mm:ss."""
    seconds = int(seconds)
    return f"{seconds // 3600}:{seconds // 60 % 60:02d}:{seconds % 60:02d}"


class Campaign:
    """Works through the runs of a plan in one folder.

    jobs: runs at a time. shared: that many cores instead, one for each run; where fewer runs than
    cores are left, they share these as ranks.
    """

    def __init__(
        self,
        top: str,
        runs: Sequence[Run],
        jobs: int = 1,
        launcher: Iterable[str] = (),
        retry: bool = False,
        say: Callable[[str], object] = print,
        in_order: bool = False,
        ranks: int = 1,
        shared: bool = False,
    ) -> None:
        self.top = top
        self.folders = [folders.RunFolder(top, run) for run in runs]
        self.in_order = in_order
        self.jobs, self.launcher, self.retry, self.say = jobs, list(launcher), retry, say
        self.ranks, self.shared = ranks, shared
        self.tried: set[str] = set()
        self.rank, self.size = place()
        self.active: list[Attempt] = []
        self.done_work = 0.0
        self.began = time.monotonic()
        self.last_report = self.began
        self.stop = False
        self.full: str | None = None  # why the disk is

    def prepare(self) -> None:
        """Checks before anything runs."""
        program = lmp_program()
        if not (os.path.isfile(program) and os.access(program, os.X_OK)):
            raise folders.FolderError(
                f"{program}: lmp is not there or cannot be run: build it (tools/setup.sh) "
                "or set MCAWR_LMP",
                5,
            )
        for folder in self.folders:
            folder.check_same()

    def run(self) -> dict[str, int]:
        """Runs everything; the number of runs in each state at the end."""
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self._interrupt)
        try:
            self._work_through()
        except (OSError, errors.Failure) as error:  # end lmp and its records in order
            self._interrupt()
            self.say = lambda text: None
            self._finish_early()
            if is_full(self.top, error):
                self._say_full(error)
            raise
        self._finish_early()
        if self.full:
            self._say_full(self.full)
        return self._states()

    def _work_through(self) -> None:
        # mostly the longest first, so that the end is not one long run alone
        waiting = sorted(self.folders, key=lambda f: 0 if self.in_order else -f.run.work)
        while True:
            self._collect()
            if self.stop:
                break
            waiting = [f for f in waiting if not self._is_over(f)]
            fresh = [f for f in waiting if f.run.name not in self.tried]
            for number, folder in enumerate(fresh):
                if self._idle() < 1:
                    break
                self._start(folder, self._ranks_of(folder, len(fresh) - number))
            if not self.active and all(f.run.name in self.tried for f in waiting):
                break
            if self.shared and not fresh:
                self._widen()
            self._report()
            time.sleep(POLL)

    def wait_for_others(self) -> dict[str, int]:
        """Rank 0 of several waits for the runs of the others, so that its last lines are the
        last."""
        while not self.stop and any(f.is_locked() for f in self.folders):
            self._report()
            time.sleep(1.0)
        return self._states()

    def _is_over(self, folder: folders.RunFolder) -> bool:
        if folder.run.name in self.tried:
            return False
        return folder.is_finished() or (folder.failure() is not None and not self.retry)

    def _idle(self) -> int:
        """How many more runs may begin, or of shared cores how many are free."""
        return self.jobs - sum(a.ranks if self.shared else 1 for a in self.active)

    def _ranks_of(self, folder: folders.RunFolder, waiting: int) -> int:
        """Ranks of a run that begins while so many wait, itself among them."""
        if not self.shared:
            return self.ranks
        return max(1, min(self._idle() // waiting, folder.run.automata // LEAST))

    def _widen(self) -> None:
        """Where idle cores could double the ranks of a run that has long to go, the longest one is
        ended, to go on from its newest checkpoint on more of them."""
        if any(a.widens for a in self.active):
            return
        for attempt in sorted(self.active, key=lambda a: -a.left()):
            most = min(attempt.ranks + self._idle(), attempt.folder.run.automata // LEAST)
            if most >= 2 * attempt.ranks and attempt.left() > WORTH and attempt.folder.checkpoint():
                attempt.widens = True
                attempt.stop()
                return

    def _start(self, folder: folders.RunFolder, ranks: int) -> None:
        lock = folder.lock()
        if lock is None:
            if self.size == 1:
                self.say(f"{folder.run.name}: is being worked on by another call; left to it")
            self.tried.add(folder.run.name)
            return
        self.tried.add(folder.run.name)
        if folder.is_finished():  # by another worker, since we looked
            lock.close()
            return
        launcher = self.launcher or mpirun(ranks)
        nested = self.size > 1 and not launcher
        attempt = Attempt(folder, lock, launcher, nested, ranks)
        self.active.append(attempt)
        if attempt.anew:
            self.say(f"{folder.run.name}: begins anew, its log is damaged: {attempt.anew}")
        if attempt.time_at_start:
            self.say(
                f"{folder.run.name}: goes on from {attempt.time_at_start:.4g} ns"
                + (f" on {ranks} ranks" if ranks > 1 else "")
            )

    def _collect(self) -> None:
        for attempt in list(self.active):
            if attempt.process.poll() is None:
                continue
            self.active.remove(attempt)
            self.done_work += attempt.work()
            name, seconds = attempt.folder.run.name, time.monotonic() - attempt.began
            outcome, why = attempt.end()
            if outcome == "finished":
                mu, room = attempt.folder.mean("mu"), attempt.folder.mean("room")
                cost = attempt.folder.core_seconds()
                self.say(
                    f"{name}: finished in {hours(seconds)}, {cost:.0f} core-seconds in all"
                    + (f", mu of its second half {mu:.3f}" if mu is not None else "")
                    + (f", room {room:.3f}" if room else "")
                )
                if doubt := attempt.folder.doubt():
                    self.say(f"{name}: warning: {doubt}")
            elif outcome == "full":
                self._interrupt()
                self.full = self.full or why
            elif attempt.widens and attempt.stopped:
                self.tried.discard(name)
            elif not self.stop:
                self.say(f"{name}: {outcome}: {why}")

    def _states(self) -> dict[str, int]:
        states = [f.state() for f in self.folders]
        return {
            state: states.count(state)
            for state in ("finished", "running", "failed", "interrupted", "waiting")
        }

    def _interrupt(self, *_: object) -> None:
        self.stop = True

    def _say_full(self, why: object) -> NoReturn:
        errors.fail(
            errors.Exit.IO,
            f"{self.top}: the disk is full ({why}): make room and run the same command again",
        )

    def _finish_early(self) -> None:
        for attempt in self.active:
            attempt.stop()
        ended = [attempt.folder for attempt in self.active]
        for attempt in list(self.active):
            attempt.process.wait()
        self._collect()
        for _ in range(20):  # a daemon of MPI that lmp left may hold the lock for a while
            if not any(folder.is_locked() for folder in ended):
                break
            time.sleep(0.1)

    def progress(self) -> str:
        """One line: how far, how fast, how long it will still take."""
        total = sum(f.run.work for f in self.folders)
        reached = sum(f.run.work * min(1.0, f.time() / f.run.values["ns"]) for f in self.folders)
        states = self._states()
        elapsed = time.monotonic() - self.began
        mine = self.done_work + sum(a.work() for a in self.active)
        rate = mine * self.size / elapsed if elapsed > 0 else 0.0
        left = f"about {hours((total - reached) / rate)} left, " if rate > 0 and elapsed > 5 else ""
        failed = f", {states['failed']} failed" if states["failed"] else ""
        return (
            f"{100 * reached / total:5.1f} %, {states['finished']} of {len(self.folders)} "
            f"runs{failed}, "
            f"{left}{rate / 1e6:.1f} M automaton-steps/s"
        )

    def _report(self) -> None:
        now = time.monotonic()
        terminal = sys.stdout.isatty()
        if self.rank != 0 or now - self.last_report < (2.0 if terminal else REPORT):
            return
        self.last_report = now
        errors.say(("\r\033[K" if terminal else "") + self.progress(), end="" if terminal else "\n")
