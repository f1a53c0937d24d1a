#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Speed of the plugin beside LAMMPS's own styles, on the same lattice and in the same run."""

import argparse
import dataclasses
import datetime
import json
import os
import platform
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from mcawr.command_line import Parser, file_name, number_in, whole_in
from mcawr.errors import Exit, complain, fail, run_script, say
from mcawr.files import write

ROOT = Path(__file__).resolve().parent.parent
INPUTS = ROOT / "tools" / "benchmark"

# style: input script, steps of the timed run at 1600 automata and 1 rank (about 0.6 s each)
STYLES = {
    "mca": ("in.mca", 3000),
    "gran/hooke/history": ("in.gran", 2000),
    "lj/cut": ("in.lj", 8000),
}
# automata: cells of the hexagonal lattice (2 automata a cell) in x and y
SIZES = {
    1000: (25, 20),
    1600: (40, 20),
    6400: (80, 40),
    40000: (200, 100),
    160000: (400, 200),
    1000000: (1000, 500),
}
WARM_STEPS, WARM_WORK = (
    12000,
    5e8,
)  # of the sliding blocks before their first run: steps, and automaton-steps at most
TURN = 0.2  # s

HELP = """Begins with sliding blocks of each size that have left the shock of their start behind
(12000 steps, for large samples fewer), then runs every style at every size and rank count: once
alone, for LAMMPS's timing breakdown, then ROUNDS times over. The runs of a round take turns of
0.2 s, in which all others are stopped, so that a disturbance of the machine hits all of them alike:
their ratios scatter less than their rates. Prints the medians in million automaton-steps a second
and the ratios mca/other, of ranks and of sizes with their smallest and largest value, and writes
all of it, with the breakdown and neighbour list builds, as JSON.

With --partitions N it also runs N independent copies of the smallest mca case at once, as
LAMMPS partitions of 1 rank, and compares what they do in a second of wall time with what as
many single runs as there are cores do side by side.

The rates are per second of processor time of a rank (LAMMPS's CPU use), which on 1 rank other jobs
hardly disturb; ranks wait for each other at full use of their cores, so more of them need as many
free cores."""
Case = tuple[str, int, int]  # style, automata, ranks
Results = dict[Case, dict[str, Any]]


def counted(pattern: str, text: str) -> float | None:
    """Increase of a counter over the last run; None if LAMMPS did not count."""
    counts = [int(n) for n in re.findall(pattern, text)]
    return counts[-1] - counts[-2] if len(counts) > 1 else None


def parse_log(text: str) -> dict[str, Any]:
    """What LAMMPS says after its last run: loop time in s, CPU use and breakdown in %, counts."""
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


def warm_up(lmp: str, automata: int, folder: Path, scale: float) -> None:
    """Sliding blocks of one size, kept in a restart file: on all cores."""
    nx, ny = SIZES[automata]
    steps = max(100, round(scale * min(WARM_STEPS, WARM_WORK / automata)))
    command = [
        "mpirun",
        "-np",
        str(os.cpu_count()),
        lmp,
        "-in",
        str(INPUTS / "in.mca"),
        "-log",
        "log.bench",
        "-screen",
        "none",
        "-var",
        "nx",
        str(nx),
        "-var",
        "ny",
        str(ny),
        "-var",
        "warmup",
        str(steps),
        "-var",
        "warm",
        "begin",
        "-var",
        "restart",
        warm_file(folder, automata),
    ]
    done = subprocess.run(
        command,
        cwd=folder,
        env=mpi_environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        fail(
            Exit.INTERNAL,
            f"warm-up of {automata} automata: lmp failed with exit code {done.returncode}: "
            f"{done.stdout[-500:]}",
        )


def warm_file(folder: Path, automata: int) -> str:
    return str(folder / f"warm.{automata}.restart")


@dataclasses.dataclass
class Run:
    """A started lmp, or several under one mpirun."""

    title: str
    process: subprocess.Popen
    output: Any  # file
    logs: list

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

    def result(self) -> list[dict[str, Any]]:
        """A parsed log of each lmp, once the run has ended."""
        with self.output:
            self.output.seek(0)
            said = self.output.read()
        texts = [log.read_text() if log.exists() else "" for log in self.logs]
        for text in texts:
            if self.process.returncode != 0 or "Loop time of" not in text:
                errors = [line for line in (text + said).splitlines() if "ERROR" in line]
                fail(
                    Exit.INTERNAL,
                    f"{self.title}: lmp failed with exit code {self.process.returncode}: "
                    f"{errors[0] if errors else said[-500:]}",
                )
        return [parse_log(text) for text in texts]


def start_run(
    lmp: str,
    style: str,
    automata: int,
    ranks: int,
    scale: float,
    folder: Path,
    partitions: int = 0,
    place: str = ".",
) -> Run:
    """One run, or as many copies at once as there are partitions, at `place` in the folder."""
    script, steps = STYLES[style]
    nx, ny = SIZES[automata]
    steps = max(20, round(steps * scale * 1600 / automata * min(ranks, 2) / 20) * 20)
    command = [
        lmp,
        "-in",
        str(INPUTS / script),
        "-log",
        "log.bench",
        "-screen",
        "none",
        "-var",
        "nx",
        str(nx),
        "-var",
        "ny",
        str(ny),
        "-var",
        "steps",
        str(steps),
    ]
    if style == "mca":
        command += ["-var", "warm", "go_on", "-var", "restart", warm_file(folder, automata)]
    work = folder / place
    work.mkdir(exist_ok=True)
    for log in work.glob("log.*"):
        log.unlink()
    logs = [work / "log.bench"]
    if partitions:
        command += ["-partition", f"{partitions}x1", "-plog", "log.bench", "-pscreen", "none"]
        logs = [work / f"log.bench.{k}" for k in range(partitions)]
    if ranks > 1 or partitions:
        command = ["mpirun", "-np", str(partitions or ranks)] + command
    output = open(work / "output", "w+", encoding="utf-8")
    process = subprocess.Popen(
        command, cwd=work, env=mpi_environment(), stdout=output, stderr=subprocess.STDOUT
    )
    return Run(f"{style}, {automata} automata, {ranks} ranks", process, output, logs)


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
    for run in runs:
        run.process.wait()
    return [log for run in runs for log in run.result()]


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


def progress(text: str) -> None:
    """One line on a terminal that overwrites itself, lines elsewhere."""
    if sys.stderr and sys.stderr.isatty():
        print(f"\r\x1b[K{text}", end="", file=sys.stderr, flush=True)
    elif text:
        complain(text)


def spread(values: list[float]) -> dict[str, float]:
    return {"min": min(values), "median": statistics.median(values), "max": max(values)}


def summarise(alone: Any, runs: list[dict[str, Any]]) -> dict[str, Any]:
    """One case: LAMMPS's breakdown and counts of the run alone, rates in million automaton-steps a
    second of all."""
    return {
        "rate": spread([r["rate"] for r in runs]),
        **{
            key: value
            for key, value in alone.items()
            if key not in ("automata", "ranks", "rate", "loop_seconds")
        },
        "runs": [{"rate": r["rate"]} for r in runs],
    }


def ratios(results: Results) -> list[dict[str, Any]]:
    """mca over each other style, ranks over 1 rank, sizes over the smallest; round by round."""
    table = []
    for (style, automata, ranks), case in results.items():
        smallest = min(n for _, n, _ in results)
        others = [
            (f"mca / {other}", (other, automata, ranks))
            for other in STYLES
            if style == "mca" != other
        ]
        if ranks > 1:
            others.append((f"{ranks} ranks / 1 rank, {style}", (style, automata, 1)))
        if automata > smallest:
            others.append((f"{automata} / {smallest} automata, {style}", (style, smallest, ranks)))
        for title, other in others:
            if other in results:
                pairs = zip(case["runs"], results[other]["runs"])
                table.append(
                    {
                        "ratio": title,
                        "automata": automata,
                        "ranks": ranks,
                        **spread([a["rate"] / b["rate"] for a, b in pairs]),
                    }
                )
    return table


def print_tables(results: Results, table: Any) -> None:
    say(
        f"\n{'style':20} {'automata':>8} {'ranks':>5} {'M steps/s':>9} {'min':>6} {'max':>6} "
        f"{'CPU %':>5} {'builds':>11}  breakdown %"
    )
    for (style, automata, ranks), c in results.items():
        shares = " ".join(f"{n} {v:.0f}" for n, v in c["breakdown_percent"].items() if v >= 0.5)
        builds = f"{c['neighbour_list_builds']}/{c['steps']}"
        say(
            f"{style:20} {automata:8} {ranks:5} {c['rate']['median']:9.2f} "
            f"{c['rate']['min']:6.2f} {c['rate']['max']:6.2f} "
            f"{c['cpu_use_percent']:5.0f} {builds:>11}  {shares}"
        )
    say(f"\n{'ratio':34} {'automata':>8} {'ranks':>5} {'median':>7} {'min':>6} {'max':>6}")
    for r in table:
        say(
            f"{r['ratio']:34} {r['automata']:8} {r['ranks']:5} {r['median']:7.2f} "
            f"{r['min']:6.2f} {r['max']:6.2f}"
        )


def processor() -> str:
    for line in open("/proc/cpuinfo", encoding="utf-8"):
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def arguments() -> argparse.Namespace:
    parser = Parser(__doc__ + "\n\n" + HELP)
    parser.add_argument(
        "--build",
        type=file_name,
        default=os.environ.get("MCAWR_BUILD", ROOT / "build"),
        help="build folder with bin/lmp (default: build/ of the checkout)",
    )
    parser.add_argument(
        "--rounds", type=whole_in(1, 1000), default=5, help="runs of each case in turns (default 5)"
    )
    parser.add_argument(
        "--scale",
        type=number_in(1e-3, 1e3),
        default=1,
        help="factor on the number of steps (default 1: about two minutes in all)",
    )
    parser.add_argument("--styles", nargs="+", choices=STYLES, default=list(STYLES))
    parser.add_argument(
        "--sizes", nargs="+", type=whole_in(1, 10**9), choices=SIZES, default=[1600, 40000]
    )
    parser.add_argument("--ranks", nargs="+", type=whole_in(1, 1024), default=[1, 2])
    parser.add_argument(
        "--partitions",
        type=whole_in(0, 1024),
        default=0,
        metavar="N",
        help="also N copies at once as LAMMPS partitions (default 0: none)",
    )
    parser.add_argument(
        "-o",
        "--output",
        type=file_name,
        help="JSON file (default: bench_mca.json in the build folder)",
    )
    args = parser.parse_args()
    args.build = Path(args.build).resolve()
    args.output = os.path.abspath(args.output or args.build / "bench_mca.json")
    lmp = args.build / "bin" / "lmp"
    if not (lmp.is_file() and os.access(lmp, os.X_OK)):
        fail(Exit.IO, f"no lmp in {args.build / 'bin'}: run tools/setup.sh, or give --build DIR")
    if not (os.access(os.path.dirname(args.output), os.W_OK) or os.access(args.output, os.W_OK)):
        fail(Exit.IO, f"cannot write {args.output}")
    return args


def main() -> None:
    args = arguments()
    cases = [
        (style, size, ranks) for size in args.sizes for ranks in args.ranks for style in args.styles
    ]
    alone: dict[Case, dict[str, Any]] = {}
    runs: dict[Case, list[dict[str, Any]]] = {case: [] for case in cases}
    together = []
    lmp = str(args.build / "bin" / "lmp")
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="mcawr-bench-") as folder:
        for size in args.sizes if "mca" in args.styles else []:
            progress(f"sliding of {size} automata, {time.monotonic() - start:.0f} s")
            warm_up(lmp, size, Path(folder), args.scale)

        def begin(k: int) -> Run:
            return start_run(lmp, *cases[k], args.scale, Path(folder), place=f"case{k}")

        for k, (style, size, ranks) in enumerate(cases):
            progress(f"{style}, {size} automata, {ranks} ranks, {time.monotonic() - start:.0f} s")
            alone[cases[k]] = run_all([begin(k)])[0]
        for number in range(args.rounds):
            progress(f"round {number + 1}/{args.rounds}, {time.monotonic() - start:.0f} s")
            turns = [begin(k) for k in range(len(cases))]
            take_turns(turns)
            for case, run in zip(cases, turns):
                runs[case] += run.result()
            if args.partitions:
                size = min(args.sizes)
                copies = run_all(
                    [start_run(lmp, "mca", size, 1, args.scale, Path(folder), args.partitions)]
                )
                singles = run_all(
                    [
                        start_run(lmp, "mca", size, 1, args.scale, Path(folder), place=f"single{k}")
                        for k in range(os.cpu_count() or 1)
                    ]
                )
                together.append(throughput(copies) / throughput(singles))
    progress("")
    results = {case: summarise(alone[case], r) for case, r in runs.items()}
    table = ratios(results)
    if together:
        table.append(
            {
                "ratio": f"{args.partitions} partitions / single runs",
                "automata": min(args.sizes),
                "ranks": args.partitions,
                **spread(together),
            }
        )
    print_tables(results, table)
    busy = [case for case, c in results.items() if c["cpu_use_percent"] < 95]
    if busy:
        say(
            f"\nThe machine was busy with other work: {len(busy)} of {len(results)} cases got "
            "less than 95 % of their cores; figures on more than 1 rank mean little then."
        )
    write(
        args.output,
        json.dumps(
            {
                "format": "mca-benchmark 1",
                "unit": "million automaton-steps per second",
                "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
                "processor": processor(),
                "cores": os.cpu_count(),
                "rounds": args.rounds,
                "seconds": round(time.monotonic() - start, 1),
                "machine_busy": bool(busy),
                "cases": [
                    {"style": s, "automata": n, "ranks": r, **c} for (s, n, r), c in results.items()
                ],
                "ratios": table,
            },
            indent=1,
        )
        + "\n",
    )
    say(f"\nwritten: {args.output}")


if __name__ == "__main__":
    run_script(main)
