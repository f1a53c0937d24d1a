# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables and reports of our programs: CSV with comment lines, JSON."""

import csv
import json
import zlib
from collections.abc import Callable
from typing import Any, NoReturn, TypeVar

from .errors import BadInput, complain
from .files import read_text
from .numbers import decimal, finite

LARGEST = 1e100  # of a number in a table or a report: beyond, its square is none

T = TypeVar("T")


class Row(dict):
    """{column: text} of a line of a CSV file."""

    line = 0

    def number(self, name: str) -> float:
        """A column as a number. Raises ValueError with the line and the column."""
        text = self[name]
        try:
            if abs(value := decimal(text)) <= LARGEST:
                return value
        except ValueError:
            pass
        raise ValueError(
            f"line {self.line}: {name}: '{text[:40]}' is not a decimal number within +-{LARGEST:g}"
        )


def rows(path: str) -> list[Row]:
    """Rows of a CSV file; lines that begin with # are comments.

    Raises BadInput, csv.Error, ValueError.
    """
    return rows_of(read_text(path), lambda line: next(csv.reader([line])))


def rows_of(text: str, cells_of: Callable[[str], list[str]], hint: str = "") -> list[Row]:
    """Rows of a text whose lines cells_of() splits; hint ends the message of a wrong number.

    Raises csv.Error, ValueError.
    """
    found: list[Row] = []
    names = None
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("#") or not line.strip():
            continue
        cells = cells_of(line)
        if names is None:
            names = cells
            if len(set(names)) < len(names):
                raise ValueError(f"line {number}: a column appears twice")
            continue
        if len(cells) != len(names):
            raise ValueError(f"line {number}: {len(cells)} cells, {len(names)} are expected{hint}")
        row = Row(zip(names, cells))
        row.line = number
        found.append(row)
    return found


def columns(path: str) -> dict[str, list[Any]]:
    """{column: values} of a CSV file of ours, as numpy.array() and pandas.DataFrame() take them:
    numbers where all of a column are, nan among them, else texts.

    Raises BadInput, csv.Error, ValueError.
    """
    table = rows(path)
    found: dict[str, list[Any]] = {}
    for name in table[0] if table else ():
        texts = [row[name] for row in table]
        try:
            found[name] = [float("nan") if text in ("", "nan") else decimal(text) for text in texts]
        except ValueError:
            found[name] = list(texts)
    return found


def read(path: str, what: str, convert: Callable[[list[Row]], T]) -> T:
    """convert() of all rows of a CSV file. Raises BadInput: 'PATH: not WHAT: why'."""
    return checked(path, what, lambda: convert(rows(path)))


def read_json(path: str, what: str, convert: Callable[[Any], T]) -> T:
    """convert() of the contents of a JSON file. Raises BadInput: 'PATH: not WHAT: why'."""

    return checked(path, what, lambda: convert(_json(read_text(path))))


def _json(text: str) -> Any:
    return json.loads(text, parse_constant=_no_number)


def _no_number(word: str) -> NoReturn:
    raise ValueError(f"{word} is not a finite number")


def number(value: object) -> float:
    """A value of a JSON file as a number. Raises TypeError, ValueError."""
    if abs(value := finite(value)) > LARGEST:
        raise ValueError(f"{value:g} is not within +-{LARGEST:g}")
    return value


def checked(path: str, what: str, read_it: Callable[[], T]) -> T:
    """read_it(), whose errors become BadInput: 'PATH: not WHAT: why'."""
    try:
        return read_it()
    except KeyError as error:
        raise BadInput(f"{path}: not {what}: {error} is missing") from None
    except (
        ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError,
        csv.Error,
    ) as error:  # fmt: skip
        raise BadInput(f"{path}: not {what}: {error}") from None


POINT = (
    "kappa1", "kappa2", "kappa3", "mu", "mu_eq2", "mu_peak", "pressure", "velocity", "strength",
    "viscosity",
)  # fmt: skip
POINT_NEW = ("t95",)  # not in a report of version 1.0.0
POINT_OPEN = ("mu_se", "t_start", "mu_grinding_in")  # null where there is none


def read_fit(path: str, convert: Callable[[dict[str, Any]], T]) -> T:
    """convert() of wr_fit's JSON, a law file or a report, after its checksum. Raises BadInput."""

    def load() -> tuple[T, bool]:
        text = read_text(path)
        data = _json(text)
        if "checksum" in data and not fits_checksum(text):
            raise ValueError(
                f"checksum: {data['checksum']} does not fit: the file was changed since wr_fit "
                "wrote it; to use one that was edited, remove this line"
            )
        return convert(data), "checksum" in data

    found, is_sealed = checked(path, "wr_fit's JSON", load)
    if not is_sealed:
        complain(f"note: {path}: no checksum: a damaged number would not be noticed")
    return found


def fits_checksum(text: str) -> bool:
    """Whether the line of the checksum of wr_fit's JSON is there, as wr_fit wrote it, and fits:
    CRC-32 of all other lines."""
    begin, end = text.find('\n  "checksum": "') + 1, 0
    if begin:
        end = text.find("\n", begin) + 1
    others = text[:begin] + text[end:]
    return bool(end) and text[begin:end] == f'  "checksum": "{zlib.crc32(others.encode()):08x}",\n'


def fit_report(path: str) -> dict[str, Any]:
    """wr_fit's JSON as a dict with report.points, whose numbers are numbers. Raises BadInput."""
    return read_fit(path, checked_report)


def checked_report(data: dict[str, Any]) -> dict[str, Any]:
    """wr_fit's JSON. Raises KeyError, TypeError, ValueError where a number of a point is none."""
    points = data["report"]["points"]
    if not isinstance(points, list):
        raise TypeError("report.points is not a list")
    for k, point in enumerate(points, 1):
        for name in (*POINT, *POINT_OPEN, *(name for name in POINT_NEW if name in point)):
            if name in POINT_OPEN and point[name] is None:
                continue
            try:
                number(point[name])
            except (TypeError, ValueError) as error:
                raise ValueError(f"point {k}: {name}: {error}") from None
    return data
