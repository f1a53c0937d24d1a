# SPDX-License-Identifier: GPL-2.0-or-later
"""What the drills share: where the programs are, samples, runs, verdicts, the report at the end."""

import argparse
import collections
import functools
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tools"
# drills are scripts, so that pytest's pythonpath (pyproject.toml) does not reach them
sys.path += [str(TOOLS), str(ROOT / "unittest" / "tools")]
from single_rank import alone  # noqa: E402

HANG = 120.0 * float(os.environ.get("MCAWR_TIME_FACTOR", "1"))  # seconds for one run
CODES = range(7)  # exit codes of our programs
ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMP_NUM_THREADS="1",
    PYTHONDONTWRITEBYTECODE="1",
    MPLBACKEND="agg",
)
SANITIZER = re.compile(r"(ERROR: \w+Sanitizer.*|runtime error: .*)")

CASE = """contact: {load_per_length: 4000 N/mm, radius: 0.5 m, youngs_modulus: 210 GPa,
          poissons_ratio: 0.3}
friction: {law: bucher2006, local: false}
thermal: {model: averaged}
creep: [0.001, 0.003, 0.01, 0.03]
speed: [5 m/s, 10 m/s, 20 m/s, 40 m/s]
cells: 64
"""
PATCH = """contact: {load: 100 kN, radii: {wheel_rolling: 0.5 m, rail_profile: 0.3 m},
          youngs_modulus: 210 GPa, poissons_ratio: 0.3}
friction: {law: constant, mu: 0.3}
thermal: off
creep: [0.001, 0.01]
speed: 20 m/s
cells: [16, 16]
"""
# two small blocks, the upper one driven; rows of the log every 20 steps
SLIDING = """units nano
dimension 2
boundary p s p
atom_style sphere
timestep 5e-5
neighbor 0.4 bin
lattice hex 2.5
region box block 0 25 -0.25 19.7 -0.5 0.5 units box
create_box 2 box
region lower block INF INF INF 9 INF INF units box
region upper block INF INF 9 INF INF INF units box
create_atoms 1 region lower
create_atoms 2 region upper
region bottom block INF INF INF 3 INF INF units box
region top block INF INF 16 INF INF INF units box
group bottom region bottom
group top region top
group lower type 1
group upper type 2
pair_style mca
pair_coeff * * steel.mca strength 92
mca_links create lower lower
mca_links create upper upper
velocity upper set 5 0 0 units box
fix integrate all nve/mca
fix hold bottom freeze
"""
DRIVE = "fix drive top mca/drive velocity 5 pressure 15 file {log} every 20\n"


class Done:
    """How a run ended: exit code (negative: a signal; None: it hung), its output, its errors."""

    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    @property
    def line(self):
        """LAMMPS's line of error, or the last line of what it said."""
        errors = re.findall(r"(?m)^ERROR.*$", self.out)
        lines = errors or (self.err.strip() or self.out.strip()).splitlines()
        return lines[-1] if lines else ""


def run(command, folder, *, patience=None, **more):
    """Runs a command in a folder and waits for its end; more: as for subprocess.Popen."""
    more.setdefault("stdout", subprocess.PIPE)
    more.setdefault("stderr", subprocess.PIPE)
    more.setdefault("stdin", subprocess.DEVNULL)
    more.setdefault("env", ENVIRONMENT)
    with subprocess.Popen(
        list(map(str, command)), cwd=folder, start_new_session=True, **more
    ) as process:
        try:
            out, err = process.communicate(timeout=patience or HANG)
            code = process.returncode
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, err = process.communicate()
            code = None
    return Done(code, *((text or b"").decode("utf-8", "replace") for text in (out, err)))


def problem(done):
    """What no program of ours may do, whatever it was given; empty if it did nothing of that."""
    said = done.out + done.err
    if done.code is None:
        return "hangs"
    found = SANITIZER.search(said)
    if found:
        return found.group(1)
    if done.code < 0 or done.code > 128:
        return f"killed by {signal.Signals(-done.code if done.code < 0 else done.code - 128).name}"
    for words in ("Traceback (most recent call last)", "internal error", "terminate called"):
        if words in said:
            return f"{words}: {done.line}"
    if done.code not in CODES:
        return f"exit code {done.code}"
    if done.code != 0 and not done.err.strip() and "ERROR" not in done.out:
        return f"exit code {done.code} without a word"
    if any(ord(c) < 32 and c not in "\n\t\r" for c in done.err):
        return "control characters in its message"
    return ""


def _part(text):
    """(2, 8) of "2/8"."""
    found = re.fullmatch(r"([1-9]\d{0,5})/([1-9]\d{0,5})", text)
    if not found or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"'{text}' is not allowed, must be K/N with 1 <= K <= N")
    return int(found[1]), int(found[2])


class Drill:
    """A drill: its options, its programs, what it counted and what it found."""

    def __init__(self, text, count, meaning, parts=False):
        """count: default of --count, and what it means; parts: with --all and --part."""
        parser = argparse.ArgumentParser(
            description=text, formatter_class=argparse.RawDescriptionHelpFormatter
        )
        parser.add_argument(
            "--build", default=os.environ.get("MCAWR_BUILD", ROOT / "build"), metavar="DIR",
            type=lambda path: pathlib.Path(path).resolve(), help="build folder [build/]",
        )  # fmt: skip
        parser.add_argument(
            "--count", type=int, default=count, metavar="N", help=f"{meaning} [{count}]"
        )
        parser.add_argument("--seed", type=int, default=1, metavar="S", help="random numbers [1]")
        parser.add_argument("--only", default="", metavar="WORD", help="kinds whose name has it")
        if parts:
            parser.add_argument("--all", action="store_true", help="all cases, whatever --count")
            parser.add_argument(
                "--part", type=_part, default=(1, 1), metavar="K/N",
                help="every N-th case, from the K-th on [1/1]",
            )  # fmt: skip
        self.given = parser.parse_args()
        self.bin = self.given.build / "bin"
        ENVIRONMENT["MCAWR_BUILD"] = str(self.given.build)
        self.tally = collections.defaultdict(collections.Counter)
        self.found = collections.defaultdict(list)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="drill-"))
        ENVIRONMENT.update(alone(self.folder))  # no drill has two runs of lmp at once
        self.random = random.Random(self.given.seed)

    def program(self, name):
        """Path of a program of the build folder, or of a script of tools."""
        inside = self.bin / name
        path = inside if inside.exists() else TOOLS / name
        if not path.exists():
            sys.exit(f"{path}: no such program; build it first (--build DIR)")
        return path

    def lmp(self, script, **variables):
        """The command that runs an input script."""
        words = [word for name, value in variables.items() for word in ("-var", name, value)]
        return [self.program("lmp"), "-in", script, "-log", "none", *words]

    def wanted(self, kind):
        """Whether --only asks for this kind."""
        return self.given.only in kind

    def sample(self, total):
        """Which of so many cases are run: all, or --count of them at random."""
        if total <= self.given.count:
            return range(total)
        return sorted(self.random.sample(range(total), self.given.count))

    def cases(self, kind, cases):
        """Those of the cases that are run: all or --count of them at random, of these a part."""
        number, parts = self.given.part
        chosen = range(len(cases)) if self.given.all else self.sample(len(cases))
        chosen = list(chosen)[number - 1 :: parts]
        print(f"{kind}: {len(chosen)} of {len(cases)} cases", flush=True)
        return (cases[k] for k in chosen)

    def new_folder(self, name):
        """An empty folder."""
        return pathlib.Path(tempfile.mkdtemp(prefix=name + "-", dir=self.folder))

    def count(self, kind, outcome):
        """One more of this outcome."""
        self.tally[kind][outcome] += 1

    def fault(self, kind, what, command=()):
        """Something was found."""
        self.tally[kind]["faults"] += 1
        self.found[kind].append(f"{what}\n      {' '.join(map(str, command))}" if command else what)

    def end(self):
        """Prints what was counted and ends the script: 1 if anything was found."""
        for kind, outcomes in self.tally.items():
            outcomes.setdefault("faults", 0)
            total = sum(outcomes.values())
            print(f"{kind}: {total}, " + ", ".join(f"{n} {what}" for what, n in outcomes.items()))
        for kind, faults in self.found.items():
            for fault in faults[:20]:
                print(f"  {kind}: {fault!r}" if "\n" not in fault else f"  {kind}: {fault}")
            if len(faults) > 20:
                print(f"  {kind}: and {len(faults) - 20} more")
        if not self.tally:
            sys.exit("nothing was run")
        if self.found:
            sys.exit(1)
        import shutil

        shutil.rmtree(self.folder, ignore_errors=True)


def falsified(bytes_, generator):
    """(bytes with one bit flipped or their end cut off, what was done)."""
    at = generator.randrange(len(bytes_))
    if generator.random() < 0.2:
        return bytes_[:at], f"cut at byte {at} of {len(bytes_)}"
    bit = generator.randrange(8)
    changed = bytearray(bytes_)
    changed[at] ^= 1 << bit
    return bytes(changed), f"bit {bit} of byte {at} of {len(bytes_)} flipped"


@functools.cache
def inputs():
    """{name: text} of good inputs of the scripts, from their tests."""
    from test_files import INPUTS

    return INPUTS


def writers():
    """{script: words before the name of the output} of the scripts that write a file."""
    from test_files import WRITERS

    return WRITERS
