# SPDX-License-Identifier: GPL-2.0-or-later
"""The friction log (doc/friction_log.md): its schema for Python, and its readers.

Lines that begin with # are YAML; then come a line of column names and the rows. Times are in ns,
stresses in MPa, lengths in nm, whatever the units of the run.
"""

import dataclasses
import itertools
import math
import os

from .errors import BadInput

FORMAT = "mca-friction 1"
COLUMNS = (
    "step",
    "time",  # ns
    "displacement",  # nm, of the driven layer
    "shear_stress",  # MPa, mean over the row's interval
    "normal_stress",  # MPa, mean over the row's interval
    "mu",  # mean over the row's interval
    "links",  # at its end
    "broken",  # in it
    "formed",  # in it
    "gap",  # nm, at its end
)
MEANS = ("shear_stress", "normal_stress", "mu")  # over the interval of a row
SUMS = ("broken", "formed")  # over the interval of a row; all others are the state at its end
CAMPAIGN = "# campaign: "  # line of the head with JSON: command, rows_averaged; of packed logs


def is_row(line):
    """Whether the line holds numbers: neither the head nor the names."""
    return line[:1].isdigit()


def number_in(words, name):
    """A column of a row that is split into words. Raises IndexError, ValueError."""
    return float(words[COLUMNS.index(name)])


@dataclasses.dataclass
class Text:
    """A log's lines, unread: those of the head, the names of the columns, those of the rows."""

    head: list
    names: list
    rows: list

    @classmethod
    def of(cls, text):
        """Whatever follows the last end of line was cut and is left out."""
        lines = text.split("\n")[:-1]
        head = list(itertools.takewhile(lambda line: line.startswith("#"), lines))
        return cls(
            head, lines[len(head)].split() if len(lines) > len(head) else [], lines[len(head) + 1 :]
        )

    def numbered_rows(self):
        """(number in the file, from 1; line) of each row."""
        return enumerate(self.rows, len(self.head) + 2)


@dataclasses.dataclass
class FrictionLog:
    """What a log says: its head as YAML gives it, and {name: values} of its columns."""

    head: dict
    columns: dict


def _text_of(path):
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput(f"{path}: cannot be read: {error}") from None


def _head(path, lines):
    """The head as YAML gives it. Raises BadInput."""
    import yaml

    try:
        head = yaml.safe_load("\n".join(line.rstrip("\n")[1:].removeprefix(" ") for line in lines))
        if head["format"] != FORMAT:
            raise BadInput(f"{path}: format '{head['format']}', must be '{FORMAT}'")
    except (yaml.YAMLError, KeyError, TypeError, ValueError, RecursionError):
        raise BadInput(
            f"{path}: no friction log: its head or its column names are incomplete"
        ) from None
    return head


def head_of(path):
    """What the head of a log says of its run, without the rows. Raises BadInput."""
    try:
        with open(path, encoding="utf-8") as file:
            return _head(path, itertools.takewhile(lambda line: line.startswith("#"), file))
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput(f"{path}: cannot be read: {error}") from None


def read(path, names=COLUMNS):
    """A log with these columns; a last row that was cut is left out. Raises BadInput."""
    text = Text.of(_text_of(path))
    head = _head(path, text.head)
    if not set(names) <= set(text.names):
        raise BadInput(f"{path}: no friction log: its head or its column names are incomplete")
    places = {name: text.names.index(name) for name in names}
    columns = {name: [] for name in names}
    for number, line in text.numbered_rows():
        words = line.split()
        last = number == len(text.head) + 1 + len(text.rows)
        if last and len(words) < len(text.names):
            break
        if len(words) != len(text.names):
            raise BadInput(f"{path}:{number}: {len(words)} columns, {len(text.names)} are expected")
        try:
            row = {name: float(words[place]) for name, place in places.items()}
        except ValueError:
            raise BadInput(f"{path}:{number}: not a row of numbers") from None
        if not all(map(math.isfinite, row.values())):
            raise BadInput(f"{path}:{number}: not a finite number")
        for name, value in row.items():
            columns[name].append(value)
    return FrictionLog(head, columns)


def last_rows(path, count):
    """The last whole rows of a log that may be growing, as lists of words (fewer if there are
    fewer, none if it cannot be read)."""
    try:
        with open(path, "rb") as file:
            file.seek(0, os.SEEK_END)
            file.seek(max(0, file.tell() - 4096))
            lines = file.read().decode("utf-8", "replace").split("\n")[:-1]
    except OSError:
        return []
    return [line.split() for line in lines if is_row(line)][-count:]
