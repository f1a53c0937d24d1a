# SPDX-License-Identifier: GPL-2.0-or-later
"""The friction log (doc/friction_log.md): its schema for Python, and its readers.

Lines that begin with # are YAML; then come a line of column names and the rows. Times are in ns,
stresses in MPa, lengths in nm, whatever the units of the run.
"""

import dataclasses
import itertools
import os
import typing
import zlib
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from .errors import BadInput
from .files import open_now, read_text
from .numbers import decimal, whole

FORMAT = "mca-friction 1"


class Column(typing.NamedTuple):
    """A column, as `columns` of src/shared/friction_log_format.h has it."""

    name: str
    unit: str  # "": a pure number
    over: str  # the interval of a row: its End, the Mean over it, or the Sum


TABLE = (
    Column("step", "", "End"),
    Column("time", "ns", "End"),
    Column("displacement", "nm", "End"),
    Column("shear_stress", "MPa", "Mean"),
    Column("normal_stress", "MPa", "Mean"),
    Column("mu", "", "Mean"),
    Column("links", "", "End"),
    Column("broken", "", "Sum"),
    Column("formed", "", "Sum"),
    Column("gap", "nm", "End"),
    Column("room", "", "End"),
    Column("lost", "", "End"),
    Column("flow_energy", "MPa nm3", "End"),
    Column("breaking_energy", "MPa nm3", "End"),
    Column("contact_energy", "MPa nm3", "End"),
)
NEEDED = TABLE[: 1 + [column.name for column in TABLE].index("gap")]  # the others may be missing
COLUMNS = tuple(column.name for column in TABLE)
MEANS = tuple(column.name for column in TABLE if column.over == "Mean")
SUMS = tuple(column.name for column in TABLE if column.over == "Sum")
CHECK = "check"  # column behind them: CRC-32 of all bytes before the number; may be missing
LARGEST = 1e12  # of any number; the reader for C++ has the same
SPACING = 0.02  # tolerance of the time between rows, which is printed rounded
CAMPAIGN = "# campaign: "  # line of the head with JSON: command, rows_averaged; of packed logs


def is_row(line: str) -> bool:
    """Whether the line holds numbers: neither the head nor the names."""
    return line[:1].isdigit()


def number_in(words: Sequence[str], name: str) -> float:
    """A column of a row that is split into words. Raises IndexError, ValueError."""
    return decimal(words[COLUMNS.index(name)])


@dataclasses.dataclass
class Text:
    """A log's lines, unread: those of the head, the names of the columns, those of the rows."""

    head: list
    names: list
    rows: list

    @classmethod
    def of(cls, text: str) -> "Text":
        """Whatever follows the last end of line was cut and is left out."""
        lines = text.split("\n")[:-1]
        head = list(itertools.takewhile(lambda line: line.startswith("#"), lines))
        return cls(
            head, lines[len(head)].split() if len(lines) > len(head) else [], lines[len(head) + 1 :]
        )

    def numbered_rows(self) -> Iterator[tuple[int, str]]:
        """(number in the file, from 1; line) of each row."""
        return enumerate(self.rows, len(self.head) + 2)


class Checks:
    """The numbers of the column check, row by row."""

    def __init__(self, lines: Iterable[str]) -> None:
        """lines: of the head, and the names of the columns."""
        self._sum = 0
        for line in lines:
            self._add(f"{line}\n")

    def _add(self, text: str) -> None:
        self._sum = zlib.crc32(text.encode(), self._sum)

    def of(self, row: str) -> str:
        """The next row, without its number, with it."""
        self._add(f"{row} ")
        line = f"{row} {self._sum}"
        self._add(f"{self._sum}\n")
        return line

    def fits(self, line: str) -> bool:
        """Whether the next row is as it was written."""
        return self.of(line.rpartition(" ")[0]) == line


@dataclasses.dataclass
class FrictionLog:
    """What a log says: its head as YAML gives it, and {name: values} of its columns."""

    head: dict
    columns: dict


def _head(path: str, lines: Iterable[str]) -> dict[str, Any]:
    """The head as YAML gives it. Raises BadInput."""
    import yaml

    text = "\n".join(line.rstrip("\n")[1:].removeprefix(" ") for line in lines)
    try:
        # no head; what is nested deeply the fast loader would follow until the stack ends
        if sum(text.count(mark) for mark in "[{:-?") > 1000:
            raise ValueError
        head = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
        if head["format"] != FORMAT:
            raise BadInput(f"{path}: format '{head['format']}', must be '{FORMAT}'")
    except (yaml.YAMLError, KeyError, TypeError, ValueError, RecursionError):
        raise BadInput(
            f"{path}: not a friction log: its head or its column names are incomplete"
        ) from None
    return head


def head_of(path: str) -> dict[str, Any]:
    """What the head of a log says of its run, without the rows. Raises BadInput."""
    return _head(path, Text.of(read_text(path)).head)


def read(path: str, names: Sequence[str] | None = None) -> FrictionLog:
    """A log with these columns, or with all that it has of TABLE; a last row that was cut is left
    out. Raises BadInput, with the line: also where rows are missing."""
    text = Text.of(read_text(path))
    head = _head(path, text.head)
    if names is None:
        least = [column.name for column in NEEDED]
        names = [*least, *(name for name in COLUMNS if name in text.names and name not in least)]
    needed = dict.fromkeys(("step", "time", *names))
    for name in needed:
        if text.names.count(name) != 1:
            raise BadInput(f"{path}:{len(text.head) + 1}: not a friction log: no column '{name}'")
    places = {name: text.names.index(name) for name in needed}
    columns: dict[str, list[Any]] = {name: [] for name in needed}
    checks = Checks([*text.head, " ".join(text.names)]) if text.names[-1] == CHECK else None
    for number, line in text.numbered_rows():
        words = line.split()
        if len(words) != len(text.names):
            raise BadInput(f"{path}:{number}: {len(words)} columns, {len(text.names)} are expected")
        if checks and not checks.fits(line):
            raise BadInput(
                f"{path}:{number}: {CHECK}: '{words[-1]}' does not fit: the head, or a row up to "
                f"here, was changed since it was written (without the column '{CHECK}' it is read "
                "all the same)"
            )
        for name, place in places.items():
            columns[name].append(_value(f"{path}:{number}: {name}", words[place], name == "step"))
        _check_spacing(f"{path}:{number}", columns["step"], columns["time"])
    return FrictionLog(head, {name: columns[name] for name in names})


def _value(where: str, word: str, is_whole: bool) -> float:
    try:
        value = whole(word) if is_whole else decimal(word)
    except ValueError as error:
        raise BadInput(f"{where}: {error}") from None
    if abs(value) > LARGEST:
        raise BadInput(f"{where}: '{word}' is not within +-{LARGEST:g}")
    return value


def _check_spacing(where: str, steps: Sequence[float], times: Sequence[float]) -> None:
    """The last row follows the one before as the second follows the first."""
    if len(steps) < 2:
        return
    step, time = steps[-1] - steps[-2], times[-1] - times[-2]
    if step <= 0 or time <= 0:
        raise BadInput(f"{where}: step {steps[-1]} follows {steps[-2]}: must increase")
    every, interval = steps[1] - steps[0], times[1] - times[0]
    if step != every or abs(time - interval) > SPACING * interval:
        raise BadInput(
            f"{where}: {step} steps and {time:.4g} ns after the row before, {every} and "
            f"{interval:.4g} ns at the start of the log: rows are missing, or too many"
        )


def last_rows(path: str, count: int) -> list[list[str]]:
    """The last whole rows of a log that may be growing, as lists of words (fewer if there are
    fewer, none if it cannot be read)."""
    try:
        with open(path, "rb", opener=open_now) as file:
            file.seek(0, os.SEEK_END)
            file.seek(max(0, file.tell() - 4096))
            lines = file.read().decode("utf-8", "replace").split("\n")[:-1]
    except OSError:
        return []
    return [line.split() for line in lines if is_row(line)][-count:]
