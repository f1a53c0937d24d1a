#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A table of creep forces for a multibody code whose interpolation error is known: over several
geometries, with values that are placed where the forces are curved.

    creep_table.py case.yaml -o forces.csv
    creep_table.py case.yaml -o forces.csv --tolerance 0.005
    creep_table.py case.yaml -o forces.csv --over contact.radii.rail_profile="80 mm, 300 mm"

The case begins with its own values of load, speed, spin, lateral and longitudinal creep. wr_creep
computes the forces in the middle of each interval too; where linear interpolation misses them by
more than --tolerance of the load, the middle becomes a value of the table, until none does or
--most operating points are reached. What is left stands in the table's head, axis by axis. Each
--over is one more axis, in front: a keyword of the case with a list of values of one unit.
Exit codes: 0 ok, 2 usage, 5 the table cannot be written, others as wr_creep.
"""

import argparse
import itertools
import os
import re
import subprocess
import tempfile
from typing import Any

from mcawr import numbers, programs, tables
from mcawr.command_line import Parser, file_name, number_in, whole_in
from mcawr.errors import BadInput, fail, fail_as, Exit, run_script, say
from mcawr.files import check_apart, write

# axis of wr_creep --table: keyword and unit with which it is set
AXES = {
    "load": ("contact.load", "N"),
    "speed": ("speed", "m/s"),
    "spin": ("spin", "1/mm"),
    "lateral": ("lateral", ""),
    "creep": ("creep", ""),
}
FORCES = ("force_x", "force_y")

Values = dict[str, list[float]]
Cells = dict[tuple[float, ...], list[str]]  # by the five coordinates: the cells after them


class Geometry:
    """One choice of the lists of --over."""

    def __init__(self, choice: tuple[str, ...], keywords: list[str]) -> None:
        self.changes = [f"{keyword}={text}" for keyword, text in zip(keywords, choice)]
        self.numbers = [text.split()[0] for text in choice]


def split_over(text: str) -> tuple[str, list[str]]:
    """KEYWORD=LIST as keyword and values. Raises argparse.ArgumentTypeError."""
    keyword, sign, values = text.partition("=")
    words = [value.split() for value in values.strip(" []").split(",")]
    try:
        found = [numbers.decimal(word[0]) for word in words]
    except (ValueError, IndexError):
        found = []
    units = {" ".join(word[1:]) for word in words}
    if not keyword or not sign or not found or len(units) != 1 or found != sorted(set(found)):
        raise argparse.ArgumentTypeError(
            f"'{text}': KEYWORD=NUMBER UNIT, NUMBER UNIT, ... is needed, increasing, of one unit"
        )
    return keyword, [" ".join(word) for word in words]


def keyword_list(axis: str, values: list[float]) -> str:
    keyword, unit = AXES[axis]
    return f"{keyword}=[" + ", ".join(f"{value:.12g} {unit}".strip() for value in values) + "]"


class Runs:
    """Runs of wr_creep for a geometry."""

    def __init__(self, given: argparse.Namespace, folder: str) -> None:
        self.given, self.folder, self.done = given, folder, 0
        self.head: list[str] = []

    def cells(self, geometry: Geometry, values: Values) -> Cells:
        """The table over these values; of the case where there are none. Ends the script where
        wr_creep fails but for operating points that did not converge."""
        path = os.path.join(self.folder, "table.csv")
        command = [self.given.wr_creep, self.given.case, "-q", "-o", self.folder, "--table", path]
        changes = [*self.given.set, *geometry.changes, "fields=none", "sensitivities=false"]
        changes += [keyword_list(axis, list_) for axis, list_ in values.items()]
        for change in changes:
            command += ["--set", change]
        if os.path.exists(path):
            os.remove(path)
        done = subprocess.run(command, text=True, capture_output=True, check=False)
        if done.returncode not in (0, 4) or not os.path.exists(path):
            fail_as("wr_creep", done)
        self.done += 1
        with open(path, encoding="utf-8") as file:
            self.head = [line.rstrip("\n") for line in file if line.startswith("#")]

        def convert(rows: list[tables.Row]) -> Cells:
            found = {}
            for row in rows:
                key = tuple(row.number(axis) for axis in AXES)
                found[key] = [text for name, text in row.items() if name not in AXES]
            return found

        return tables.read(path, "a table of wr_creep", convert)


def axes_of(cells: Cells) -> Values:
    return {axis: sorted({key[k] for key in cells}) for k, axis in enumerate(AXES)}


def middles(values: list[float]) -> list[float]:
    return [0.5 * (a + b) for a, b in zip(values, values[1:])]


def errors_along(runs: Runs, geometries: list[Geometry], values: Values, axis: str) -> list[float]:
    """Largest error of linear interpolation in the middle of each interval of an axis, as a share
    of the load; over all other values and all geometries."""
    place = list(AXES).index(axis)
    between = middles(values[axis])
    worst = [0.0] * len(between)
    for geometry in geometries:
        cells = runs.cells(geometry, {**values, axis: sorted(values[axis] + between)})
        sorted_values = axes_of(cells)[axis]  # as they came back, every second one a middle
        for key, texts in cells.items():
            at = sorted_values.index(key[place])
            if at % 2 == 0:
                continue
            ends = [
                cells[key[:place] + (sorted_values[at + step],) + key[place + 1 :]]
                for step in (-1, 1)
            ]
            if "" in (texts[0], ends[0][0], ends[1][0]):
                continue  # did not converge
            load = key[0]
            for k in range(len(FORCES)):
                low, high = float(ends[0][k]), float(ends[1][k])
                miss = abs(float(texts[k]) - 0.5 * (low + high)) / load
                worst[at // 2] = max(worst[at // 2], miss)
    return worst


def place_values(
    runs: Runs, geometries: list[Geometry], values: Values, given: argparse.Namespace
) -> tuple[Values, dict[str, float], dict[str, float]]:
    """Values with a small enough error; the errors at the start and at the end, by axis."""
    first: dict[str, float] = {}
    while True:
        found = {
            axis: errors_along(runs, geometries, values, axis)
            for axis, list_ in values.items()
            if len(list_) > 1
        }
        last = {axis: max(errors) for axis, errors in found.items()}
        first = first or last
        worst = max(last.values(), default=0.0)
        if worst <= given.tolerance:
            return values, first, last
        more = {}
        for axis, list_ in values.items():
            added = [
                middle
                for middle, error in zip(middles(list_), found.get(axis, []))
                if error > max(given.tolerance, 0.3 * worst)
            ]
            more[axis] = sorted(list_ + added)
        size = len(geometries)
        for list_ in more.values():
            size *= len(list_)
        if size > given.most:
            say(
                f"{size} operating points would be more than --most {given.most}: an error of "
                f"{worst:.2g} of the load is left"
            )
            return values, first, last
        values = more


def shown(errors: dict[str, float]) -> str:
    return ", ".join(f"{axis} {error:.2g}" for axis, error in errors.items()) or "one value each"


def read_arguments() -> argparse.Namespace:
    parser = Parser(__doc__)
    parser.add_argument("case", metavar="CASE.yaml", type=file_name)
    parser.add_argument("-o", "--output", required=True, metavar="FILE", type=file_name)
    parser.add_argument(
        "--over", action="append", default=[], metavar="KEYWORD=LIST", type=split_over
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEYWORD=VALUE", help="as of wr_creep"
    )
    parser.add_argument("--tolerance", type=number_in(1e-6, 1.0), default=0.01, metavar="SHARE")
    parser.add_argument("--most", type=whole_in(1, 10**7), default=20000, metavar="N")
    parser.add_argument("--wr-creep", default=programs.program("wr_creep"), type=file_name)
    return parser.parse_args()


def with_lists(line: str, over: list[tuple[str, list[str]]]) -> str:
    """A line of the head of one geometry with the values of all."""
    for keyword, list_ in over:
        group, _, name = keyword.partition(".")
        if line.startswith(f"# {group}: "):
            line = re.sub(
                rf"(?<= ){re.escape(name)}: (\[[^]]*\]|[^,]*)",
                f"{name}: [{', '.join(list_)}]",
                line,
            )
    return line


def table_text(runs: Runs, geometries: list[Geometry], values: Values, note: str) -> str:
    keywords = [keyword for keyword, _ in runs.given.over]
    names = [keyword.rpartition(".")[2] for keyword in keywords]
    rows = []
    for geometry in geometries:
        for key, texts in runs.cells(geometry, values).items():
            cells = geometry.numbers + [f"{value:.10g}" for value in key] + texts
            rows.append(",".join(cells))
    grid = [f"{len(list_)} {name}" for (_, list_), name in zip(runs.given.over, names)]
    grid += [f"{len(list_)} {axis}" for axis, list_ in values.items()]
    head = [with_lists(line, runs.given.over) for line in runs.head]
    head = [line for line in head if not line.startswith("# grid:")]
    for (keyword, list_), name in zip(runs.given.over, names):
        unit = " ".join(list_[0].split()[1:]) or "1"
        head.append(f"# {name}: {keyword}, {unit}")
    head.append(f"# grid: {' x '.join(grid)}; creep varies fastest")
    head.append(f"# interpolation, linear: {note}")
    columns = [*names, *AXES, *FORCES, "moment_z", "converged"]
    return "\n".join([*head, ",".join(columns), *rows]) + "\n"


def main() -> None:
    given = read_arguments()
    keywords = [keyword for keyword, _ in given.over]
    if len(set(keywords)) < len(keywords):
        fail(Exit.USAGE, "--over: a keyword stands twice")
    check_apart([given.case], [given.output])
    if not os.path.exists(given.case):
        raise BadInput(f"{given.case}: no such file")
    choices = itertools.product(*(list_ for _, list_ in given.over))
    geometries = [Geometry(choice, keywords) for choice in choices]
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(given, folder)
        values = axes_of(runs.cells(geometries[0], {}))
        values, first, last = place_values(runs, geometries, values, given)
        note = (
            f"error in the middle of intervals, share of the load: {shown(last)} "
            f"(as given: {shown(first)})"
        )
        write(given.output, table_text(runs, geometries, values, note))
    size: Any = len(geometries)
    for list_ in values.values():
        size *= len(list_)
    say(f"{size} operating points written to {given.output}; {note}")


if __name__ == "__main__":
    run_script(main)
