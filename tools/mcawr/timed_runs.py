# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of lmp that share a machine by turns, and the times that LAMMPS says they took."""

import dataclasses
import os
import re
import signal
import subprocess
from pathlib import Path
from typing import Any

from .errors import Exit, fail

TURN = 0.2  # s


def counted(pattern: str, text: str) -> float | None:
    """Increase of a counter over the last run; None if LAMMPS did not count."""
    counts = [int(n) for n in re.findall(pattern, text)]
    return counts[-1] - counts[-2] if len(counts) > 1 else None


def parse_log(text: str) -> dict[str, Any]:
    """What LAMMPS says after its last run: loop time in s, CPU use and breakdown in %, counts; rate
    in million automaton-steps a second of a rank's processor time. Raises ValueError."""
    last = text[text.rindex("Loop time of") :]
    loop = re.match(r"Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms", last)
    cpu = re.search(r"([\d.]+)% CPU use", last)
    if not (loop and cpu):
        raise ValueError("the times of a run are missing")
    # the timed run goes on from the warm-up ("run N pre no"), and so do its counters
    builds = counted(r"Neighbor list builds = (\d+)", text)
    dangerous = counted(r"Dangerous builds = (\d+)", text)
    neighbours = re.search(r"Ave neighs/atom = (\S+)", last)
    memory = re.search(r"Per MPI rank memory allocation \(min/avg/max\) = \S+ \| (\S+)", text)
    breakdown = re.findall(
        r"^(Pair|Bond|Neigh|Comm|Output|Modify|Other)\s*\|.*\|\s*([\d.]+)\s*$", last, re.MULTILINE
    )
    seconds, ranks, steps, automata = float(loop[1]), int(loop[2]), int(loop[3]), int(loop[4])
    cpu_use = float(cpu[1])
    return {
        "automata": automata,
        "ranks": ranks,
        "steps": steps,
        "loop_seconds": seconds,
        "cpu_use_percent": cpu_use,
        "rate": automata * steps / seconds / 1e4 / cpu_use if cpu_use > 0 else None,
        "neighbour_list_builds": builds,
        "dangerous_builds": dangerous,
        "neighbours_per_automaton": float(neighbours[1]) if neighbours else None,
        "memory_megabytes_per_rank": float(memory[1]) if memory else None,
        "breakdown_percent": {name: float(share) for name, share in breakdown},
    }


@dataclasses.dataclass
class Run:
    """A started lmp, or several under one mpirun."""

    title: str
    process: subprocess.Popen
    output: Any  # file
    logs: list[Path]

    def signal(self, number: int) -> None:
        """Sent to mpirun and to what it started."""
        pid = self.process.pid
        children = Path(f"/proc/{pid}/task/{pid}/children")
        for one in [pid, *map(int, children.read_text().split() if children.exists() else [])]:
            try:
                os.kill(one, number)
            except ProcessLookupError:
                pass  # has just ended

    def ends(self, seconds: float) -> bool:
        """Within some seconds."""
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return False
        return True

    def result(self, needed: str = "Loop time of") -> list[str]:
        """The log of each lmp, once the run has ended. Raises Failure if one failed, or its log
        lacks what is needed."""
        self.process.wait()
        with self.output:
            self.output.seek(0)
            said = self.output.read()
        texts = [log.read_text() if log.exists() else "" for log in self.logs]
        for text in texts:
            if self.process.returncode != 0 or needed not in text:
                errors = [line for line in (text + said).splitlines() if "ERROR" in line]
                fail(
                    Exit.INTERNAL,
                    f"{self.title}: lmp failed with exit code {self.process.returncode}: "
                    f"{errors[0] if errors else said.strip()[:2000]}",
                )
        return texts


def start(
    title: str,
    lmp: str,
    script: Path,
    variables: dict[str, Any],
    place: Path,
    ranks: int = 1,
    partitions: int = 0,
) -> Run:
    """One run of a script, or as many copies at once as there are partitions of one rank, in a
    folder, which is made."""
    command = [lmp, "-in", str(script), "-log", "log.bench", "-screen", "none"]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    place.mkdir(exist_ok=True)
    for log in place.glob("log.*"):
        log.unlink()
    logs = [place / "log.bench"]
    if partitions:
        command += ["-partition", f"{partitions}x1", "-plog", "log.bench", "-pscreen", "none"]
        logs = [place / f"log.bench.{k}" for k in range(partitions)]
    if ranks > 1 or partitions:
        command = ["mpirun", "-np", str(partitions or ranks)] + command
    output = open(place / "output", "w+", encoding="utf-8")
    process = subprocess.Popen(
        command, cwd=place, env=mpi_environment(), stdout=output, stderr=subprocess.STDOUT
    )
    return Run(title, process, output, logs)


def take_turns(runs: list[Run]) -> None:
    """Lets runs go on by turns until all have ended."""
    going = list(runs)
    try:
        for run in going:
            run.signal(signal.SIGSTOP)
        while going:
            for run in list(going):
                run.signal(signal.SIGCONT)
                if run.ends(TURN):
                    going.remove(run)
                else:
                    run.signal(signal.SIGSTOP)
    finally:
        for run in going:
            run.signal(signal.SIGKILL)


def run_all(runs: list[Run]) -> list[dict[str, Any]]:
    """Runs that share the machine: a parsed log of each lmp."""
    return [parse_log(text) for run in runs for text in run.result()]


def throughput(runs: list[dict[str, Any]]) -> float:
    """Automaton-steps that runs which share the machine do in a second."""
    return sum(r["automata"] * r["steps"] for r in runs) / max(r["loop_seconds"] for r in runs)


def mpi_environment() -> dict[str, str]:
    """Also as root, more ranks than cores; the system decides which core runs a rank."""
    return {
        **os.environ,
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
        "OMPI_MCA_hwloc_base_binding_policy": "none",
    }
