#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Speed of the plugin beside LAMMPS's own styles, on the same lattice and in the same run."""

import argparse
import dataclasses
import datetime
import json
import os
import platform
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

from mcawr import tables, timed_runs
from mcawr.command_line import Parser, file_name, number_in, whole_in
from mcawr.errors import Exit, complain, fail, run_script, say
from mcawr.files import write

ROOT = Path(__file__).resolve().parent.parent
INPUTS = ROOT / "tools" / "benchmark"
FORMAT = "mca-benchmark 2"
FALLEN = 0.85  # of a ratio over the one before: below, it fell

# style: input script, steps of the timed run at 1600 automata and 1 rank (about 0.6 s each)
STYLES = {
    "mca": ("in.mca", 5000),
    "gran/hooke/history": ("in.gran", 2000),
    "lj/cut": ("in.lj", 8000),
}
WARM_STEPS = 60000  # of sliding blocks; then less than 1 % of the automata flow
# blocks that slide: columns, pairs of rows, variables of in.mca
SAMPLES: dict[str, tuple[int, int, dict[str, Any]]] = {
    "40": (40, 20, {}),
    "56": (56, 20, {}),
    "rail": (40, 20, {"material": "rail_steel.mca", "values": "temperature 293", "p": 1000}),
    # 0.7 of its strength: a third of the pairs are viscous contacts
    "hot": (40, 20, {"material": "rail_steel.mca", "values": "temperature 1073", "p": 55.4}),
    "strong": (40, 20, {"values": "strength 552"}),
}
# automata: sample, copies of it side by side
SIZES = {
    1600: ("40", 1),
    2240: ("56", 1),
    6400: ("40", 4),
    8960: ("56", 4),
    40000: ("40", 25),
    160000: ("40", 100),
    1000000: ("40", 625),
}
DEFAULT = "default laws"
DRUCKER = {"laws": "preset d fracture drucker-prager compressive_strength 3"}
SPACE, SPACE_SIZE = "space", 19652  # automata
SLOWER = {SPACE: 3, "account": 8}  # so many times fewer steps
# what else is measured, at 1600 automata on one rank: sample, more variables of in.mca
LAWS: dict[str, tuple[str, dict[str, Any]]] = {
    "rail steel, 1000 MPa": ("rail", {}),
    "rail steel, 1073 K": ("hot", {}),
    "strength 552 MPa": ("strong", {}),
    "drucker-prager": ("40", DRUCKER),
    "account": ("40", {"account": 1}),
}

HELP = """Makes samples of two blocks that have slid for 60000 steps, where the shock of their start
is over, copies them side by side for larger sizes, and runs the default laws beside the other
styles at every size and rank count; besides at 1600 automata and one rank other materials,
fracture drucker-prager and the account of the energy over the default laws, and a block in space
over gran/hooke/history in space. First once alone, for LAMMPS's timing breakdown, then ROUNDS times
over. The runs of a round take turns of 0.2 s, in which all others are stopped, so that a
disturbance of the machine hits all of them alike: their ratios scatter less than their rates.
Prints the medians in million automaton-steps a second and the ratios with their smallest and
largest value, and writes all of it, with the breakdown and neighbour list builds, as JSON.

The rates are per second of processor time of a rank (LAMMPS's CPU use), which on 1 rank other jobs
hardly disturb; ranks wait for each other at full use of their cores, so more of them need as many
free cores.

--compare FILE holds the ratios beside those of an earlier JSON, such as that of the last release,
tools/benchmark/release.json, and says which fell by more than 15 %; then the exit code is 1.

With --against BUILD each run of the plugin has one of another build beside it.

With --partitions N it also runs N independent copies of the smallest mca case at once, as
LAMMPS partitions of 1 rank, and compares what they do in a second of wall time with what as
many single runs as there are cores do side by side."""


@dataclasses.dataclass(frozen=True)
class Case:
    """What is measured."""

    row: str  # default laws, space or of LAWS
    style: str
    automata: int
    ranks: int = 1
    other: bool = False  # by the other build

    def title(self) -> str:
        return f"{self.row}, {self.style}, {self.automata} automata, {self.ranks} ranks"


Results = dict[Case, dict[str, Any]]


class Bench:
    """Starts the runs of cases, with samples that it makes."""

    def __init__(self, args: argparse.Namespace, folder: Path) -> None:
        self.args, self.folder = args, folder
        self.samples = Path(args.samples or folder)
        self.lmp = str(args.build / "bin" / "lmp")

    def sample_file(self, sample: str) -> str:
        return str(self.samples / f"{sample}.{WARM_STEPS}")

    def warm_up(self, samples: list[str]) -> None:
        """Makes the samples that are missing: on all cores."""
        missing = [s for s in samples if not Path(self.sample_file(s) + ".links").exists()]
        cores = os.cpu_count() or 1
        for first in range(0, len(missing), cores):
            runs = []
            for sample in missing[first : first + cores]:
                nx, ny, variables = SAMPLES[sample]
                begin: dict[str, Any] = {"nx": nx, "ny": ny, "warmup": WARM_STEPS, **variables}
                begin["sample"] = self.sample_file(sample)
                place = self.folder / f"warm.{sample}"
                runs.append(
                    timed_runs.start(
                        f"warm-up of {sample}", self.lmp, INPUTS / "in.mca", begin, place
                    )
                )
            for run in runs:
                run.result()

    def start(self, case: Case, place: str, partitions: int = 0) -> timed_runs.Run:
        lmp = str(self.args.against / "bin" / "lmp") if case.other else self.lmp
        script, at_1600 = STYLES[case.style]
        steps = at_1600 * self.args.scale * 1600 / case.automata * min(case.ranks, 2)
        variables: dict[str, Any] = {}
        steps /= SLOWER.get(case.row, 1)
        if case.row == SPACE:
            script += "3d"
        else:
            sample, copies = SIZES[case.automata] if case.row == DEFAULT else (LAWS[case.row][0], 1)
            nx, ny, of_sample = SAMPLES[sample]
            if case.style == "mca":
                of_row = {} if case.row == DEFAULT else LAWS[case.row][1]
                variables = {"warm": "go_on", "sample": self.sample_file(sample), "copies": copies}
                variables |= {**of_sample, **of_row}
            else:
                variables = {"nx": nx * copies, "ny": ny}
        variables["steps"] = max(20, round(steps / 20) * 20)
        return timed_runs.start(
            case.title(),
            lmp,
            INPUTS / script,
            variables,
            self.folder / place,
            case.ranks,
            partitions,
        )


def cases_of(args: argparse.Namespace) -> list[Case]:
    cases = [
        Case(DEFAULT, style, size, ranks)
        for size in args.sizes
        for ranks in args.ranks
        for style in args.styles
    ]
    if "mca" in args.styles:
        cases += [Case(row, "mca", 1600) for row in args.laws if row != SPACE]
    if SPACE in args.laws:
        cases += [
            Case(SPACE, style, SPACE_SIZE)
            for style in ("mca", "gran/hooke/history")
            if style in args.styles
        ]
    if args.against:
        ours = [case for case in cases if case.style == "mca"]
        cases += [dataclasses.replace(case, other=True) for case in ours]
    return cases


def progress(text: str) -> None:
    """A line that says how far it is."""
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


def denominators(case: Case, smallest: int) -> list[tuple[str, Case]]:
    """What a case is taken over: title, case."""
    if case.other:
        return []
    found = []
    if case.style == "mca":
        found += [
            (f"mca / {style}", dataclasses.replace(case, style=style))
            for style in STYLES
            if style != "mca"
        ]
        found.append(("this build / other build", dataclasses.replace(case, other=True)))
        if case.row in LAWS:
            found.append(("row / default laws", dataclasses.replace(case, row=DEFAULT)))
    if case.row == DEFAULT:
        if case.ranks > 1:
            title = f"{case.ranks} ranks / 1 rank, {case.style}"
            found.append((title, dataclasses.replace(case, ranks=1)))
        if case.automata > smallest:
            title = f"{case.automata} / {smallest} automata, {case.style}"
            found.append((title, dataclasses.replace(case, automata=smallest)))
    return found


def ratios(results: Results) -> list[dict[str, Any]]:
    """Rates over each other, round by round."""
    smallest = min((case.automata for case in results if case.row == DEFAULT), default=0)
    return [
        {
            "row": case.row,
            "ratio": title,
            "automata": case.automata,
            "ranks": case.ranks,
            **spread(
                [a["rate"] / b["rate"] for a, b in zip(measured["runs"], results[other]["runs"])]
            ),
        }
        for case, measured in results.items()
        for title, other in denominators(case, smallest)
        if other in results
    ]


Name = tuple[str, str, int, int]  # of a ratio: row, ratio, automata, ranks


def name_of(ratio: dict[str, Any]) -> Name:
    return (ratio["row"], ratio["ratio"], ratio["automata"], ratio["ranks"])


def read_ratios(path: str) -> dict[Name, float]:
    """Medians of an earlier run."""

    def medians(content: Any) -> dict[Name, float]:
        if content["format"] != FORMAT:
            raise ValueError(f"format '{content['format']}', must be '{FORMAT}'")
        found = {name_of(ratio): tables.number(ratio["median"]) for ratio in content["ratios"]}
        if not found or min(found.values()) <= 0:
            raise ValueError("ratios are needed, which must be > 0")
        return found

    return tables.read_json(path, "a benchmark file", medians)


def compare(before: dict[Name, float], table: list[dict[str, Any]]) -> list[str]:
    """Prints what both have measured. Returns a line for each ratio that fell."""
    both = [r for r in table if name_of(r) in before]
    say(f"\n{'row':22} {'ratio':34} {'automata':>8} {'ranks':>5} {'before':>7} {'now':>7}  change")
    fallen = []
    for r in both:
        was = before[name_of(r)]
        line = f"{r['row']:22} {r['ratio']:34} {r['automata']:8} {r['ranks']:5}"
        change = f"{100 * (r['median'] / was - 1):+.0f} %"
        fell = r["median"] < FALLEN * was
        say(f"{line} {was:7.3f} {r['median']:7.3f}  {change}{'  fell' if fell else ''}")
        if fell:
            name = f"{r['row']}, {r['ratio']}, {r['automata']} automata, {r['ranks']} ranks"
            fallen.append(f"{name}: {was:.3f} before, {r['median']:.3f} now ({change})")
    say(f"{len(both)} ratios compared, {len(before) - len(both)} of the file not measured")
    return fallen


def print_tables(results: Results, table: Any) -> None:
    say(
        f"\n{'row':22} {'style':20} {'automata':>8} {'ranks':>5} {'M steps/s':>9} {'min':>6} "
        f"{'max':>6} {'CPU %':>5} {'builds':>11}  breakdown %"
    )
    for case, c in results.items():
        shares = " ".join(f"{n} {v:.0f}" for n, v in c["breakdown_percent"].items() if v >= 0.5)
        builds = f"{c['neighbour_list_builds']}/{c['steps']}"
        style = f"{case.style}, other build" if case.other else case.style
        say(
            f"{case.row:22} {style:20} {case.automata:8} {case.ranks:5} "
            f"{c['rate']['median']:9.2f} {c['rate']['min']:6.2f} {c['rate']['max']:6.2f} "
            f"{c['cpu_use_percent']:5.0f} {builds:>11}  {shares}"
        )
    say(
        f"\n{'row':22} {'ratio':34} {'automata':>8} {'ranks':>5} "
        f"{'median':>7} {'min':>7} {'max':>7}"
    )
    for r in table:
        say(
            f"{r['row']:22} {r['ratio']:34} {r['automata']:8} {r['ranks']:5} {r['median']:7.3f} "
            f"{r['min']:7.3f} {r['max']:7.3f}"
        )


def processor() -> str:
    for line in open("/proc/cpuinfo", encoding="utf-8"):
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def build_of(folder: str) -> Path:
    build = Path(folder).resolve()
    lmp = build / "bin" / "lmp"
    if not (lmp.is_file() and os.access(lmp, os.X_OK)):
        fail(Exit.IO, f"no lmp in {build / 'bin'}: run tools/setup.sh, or give --build DIR")
    return build


def arguments() -> argparse.Namespace:
    parser = Parser(__doc__ + "\n\n" + HELP)
    parser.add_argument(
        "--build",
        type=file_name,
        default=os.environ.get("MCAWR_BUILD", ROOT / "build"),
        help="build folder with bin/lmp (default: build/ of the checkout)",
    )
    parser.add_argument("--against", type=file_name, help="build folder of another state")
    parser.add_argument(
        "--rounds", type=whole_in(1, 1000), default=5, help="runs of each case in turns (default 5)"
    )
    parser.add_argument(
        "--scale",
        type=number_in(1e-3, 1e3),
        default=1,
        help="factor on the number of steps (default 1: about four minutes in all)",
    )
    parser.add_argument(
        "--short",
        action="store_true",
        help="for a try: three rounds, 1600 automata, one rank, a fifth of the steps; a minute",
    )
    parser.add_argument("--styles", nargs="+", choices=STYLES, default=list(STYLES))
    parser.add_argument(
        "--sizes",
        nargs="*",
        type=whole_in(1, 10**9),
        choices=SIZES,
        default=[1600, 2240, 8960, 40000],
        help="of the default laws (default 1600 2240 8960 40000)",
    )
    parser.add_argument("--ranks", nargs="+", type=whole_in(1, 1024), default=[1, 2])
    parser.add_argument(
        "--laws",
        nargs="*",
        choices=[*LAWS, SPACE],
        default=[*LAWS, SPACE],
        help="other rows (default: all)",
    )
    parser.add_argument(
        "--partitions",
        type=whole_in(0, 1024),
        default=0,
        metavar="N",
        help="also N copies at once as LAMMPS partitions (default 0: none)",
    )
    parser.add_argument(
        "--samples",
        type=file_name,
        help="folder that keeps the samples, for the next call (default: a temporary one)",
    )
    parser.add_argument("--compare", type=file_name, help="JSON of an earlier run")
    parser.add_argument(
        "-o",
        "--output",
        "--json",
        type=file_name,
        help="JSON file (default: bench_mca.json in the build folder)",
    )
    args = parser.parse_args()
    args.build = build_of(args.build)
    args.against = args.against and build_of(args.against)
    if args.short:
        args.rounds, args.sizes, args.ranks, args.scale = 3, [1600], [1], args.scale / 5
    if not cases_of(args):
        parser.error("nothing to run: give --sizes or --laws")
    args.before = read_ratios(args.compare) if args.compare else None
    args.output = os.path.abspath(args.output or args.build / "bench_mca.json")
    if not (os.access(os.path.dirname(args.output), os.W_OK) or os.access(args.output, os.W_OK)):
        fail(Exit.IO, f"cannot write {args.output}")
    if args.samples:
        args.samples = os.path.abspath(args.samples)
        os.makedirs(args.samples, exist_ok=True)
    return args


def measure(args: argparse.Namespace, bench: Bench) -> tuple[Results, list[float]]:
    """All cases, and partitions over single runs."""
    cases, start = cases_of(args), time.monotonic()
    runs: dict[Case, list[dict[str, Any]]] = {case: [] for case in cases}
    together = []
    progress("samples")
    needed = [SIZES[size][0] for size in args.sizes]
    needed += [LAWS[row][0] for row in args.laws if row != SPACE]
    if "mca" in args.styles:
        bench.warm_up(list(dict.fromkeys(needed)))
    alone = {}
    for k, case in enumerate(cases):
        progress(f"{case.title()}, {time.monotonic() - start:.0f} s")
        alone[case] = timed_runs.run_all([bench.start(case, f"case{k}")])[0]
    for number in range(args.rounds):
        progress(f"round {number + 1}/{args.rounds}, {time.monotonic() - start:.0f} s")
        turns = [bench.start(case, f"case{k}") for k, case in enumerate(cases)]
        timed_runs.take_turns(turns)
        for case, run in zip(cases, turns):
            runs[case] += timed_runs.run_all([run])
        if args.partitions:
            case = Case(DEFAULT, "mca", min(args.sizes))
            copies = timed_runs.run_all([bench.start(case, ".", args.partitions)])
            cores = range(os.cpu_count() or 1)
            singles = timed_runs.run_all([bench.start(case, f"single{k}") for k in cores])
            together.append(timed_runs.throughput(copies) / timed_runs.throughput(singles))
    return {case: summarise(alone[case], r) for case, r in runs.items()}, together


def main() -> int:
    args = arguments()
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="mcawr-bench-") as folder:
        results, together = measure(args, Bench(args, Path(folder)))
    table = ratios(results)
    if together:
        table.append(
            {
                "row": DEFAULT,
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
                "format": FORMAT,
                "unit": "million automaton-steps per second",
                "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
                "processor": processor(),
                "cores": os.cpu_count(),
                "rounds": args.rounds,
                "seconds": round(time.monotonic() - start, 1),
                "machine_busy": bool(busy),
                "cases": [{**dataclasses.asdict(case), **c} for case, c in results.items()],
                "ratios": table,
            },
            indent=1,
        )
        + "\n",
    )
    say(f"\nwritten: {args.output}")
    if args.before:
        fallen = compare(args.before, table)
        for line in fallen:
            complain(line)
        return Exit.INTERNAL if fallen else Exit.OK
    return Exit.OK


if __name__ == "__main__":
    run_script(main)
