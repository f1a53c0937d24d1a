# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables from elsewhere, read as wr_creep reads them: doc/wr_creep_files.md, Text files."""

import csv
import re
from collections.abc import Callable
from typing import TypeVar

from .files import read_text
from .tables import Row, checked, rows_of

T = TypeVar("T")

WITH_COMMA = re.compile(r"[-+]?[0-9]+,[0-9]+([eE][-+]?[0-9]+)?")
WITH_POINT = re.compile(r"[-+]?([0-9]+\.[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
PERCENT = re.compile(r"[_ ]*(percent|%)_*$")
HINT = " (a decimal comma is read where semicolons or tabs stand between the numbers)"


class Units:
    """Of the lines "# NAME: UNIT"."""

    def __init__(self, text: str) -> None:
        self.given: list[tuple[int, str, str]] = []  # line, name, unit
        lines = [line.strip() for line in text.split("\n")]
        data = [k for k, line in enumerate(lines, 1) if line and not line.startswith("#")]
        self.first = data[1] if len(data) > 1 else len(lines) + 1  # line of numbers
        for number, line in enumerate(lines, 1):
            name, colon, unit = line[1:].partition(":")
            if line.startswith("#") and colon:
                self.given.append((number, name.strip(), unit.strip()))

    def of(self, name: str) -> str:
        """The unit of a column, or "". Raises ValueError."""
        found = [(number, unit) for number, known, unit in self.given if known == name]
        if len(found) > 1 or (found and found[0][0] > self.first):
            raise ValueError(f"line {found[-1][0]}: {name}: is given once, before the numbers")
        return found[0][1] if found else ""

    def ratio(self, name: str) -> float:
        """The factor of a column that is a ratio: 1, or 0.01 where its unit is %, or its name ends
        in that or in percent. Raises ValueError."""
        short = PERCENT.sub("", name)
        if short != name:
            if self.of(short) or self.of(name):
                raise ValueError(f"{name}: its unit is given once, in a line of # or in the name")
            return 0.01
        unit = self.of(name) or "1"
        if unit not in ("1", "%"):
            raise ValueError(f"{name}: '{unit}'; 1 and % are allowed")
        return 0.01 if unit == "%" else 1.0


def split_by(head: str) -> tuple[str, Callable[[str], list[str]]]:
    """The separator that the first row decides, and what splits a line by it."""
    mark = next((mark for mark in ";\t," if mark in head), "")
    if not mark:
        return mark, str.split
    return mark, lambda line: [cell.strip() for cell in next(csv.reader([line], delimiter=mark))]


def with_points(rows: list[Row]) -> None:
    """Decimal commas become points. Raises ValueError where the file has both."""
    points = commas = ""
    for row in rows:
        for name, cell in row.items():
            if WITH_COMMA.fullmatch(cell):
                commas = commas or f"line {row.line}: {name}: '{cell}' has a decimal comma"
                row[name] = cell.replace(",", ".")
            elif WITH_POINT.fullmatch(cell):
                points = points or f"line {row.line}: {name}: '{cell}' has a decimal point"
    if points and commas:
        raise ValueError(f"{commas}; {points}")


def read(path: str, what: str, convert: Callable[[list[Row], Units], T]) -> T:
    """convert() of all rows of a table and its units. Raises BadInput: 'PATH: not WHAT: why'."""

    def load() -> T:
        text = read_text(path)
        lines = (line for line in text.split("\n") if line.strip() and not line.startswith("#"))
        mark, cells_of = split_by(next(lines, ""))
        rows = rows_of(text, cells_of, HINT if mark == "," else "")
        if mark and mark != ",":
            with_points(rows)
        return convert(rows, Units(text))

    return checked(path, what, load)
