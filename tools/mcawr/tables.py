# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables and reports of our programs: CSV with comment lines, JSON."""

import csv
import json

from .errors import BadInput


def rows(path):
    """Rows of a CSV file, as {column: text}; lines that begin with # are comments.

    Raises OSError, UnicodeDecodeError.
    """
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def read(path, what, convert):
    """convert() of all rows of a CSV file. Raises BadInput: 'PATH: not WHAT: why'."""
    return _checked(path, what, lambda: convert(rows(path)))


def read_json(path, what, convert):
    """convert() of the contents of a JSON file. Raises BadInput: 'PATH: not WHAT: why'."""

    def load():
        with open(path, encoding="utf-8") as file:
            return convert(json.load(file))

    return _checked(path, what, load)


def _checked(path, what, read_it):
    try:
        return read_it()
    except KeyError as error:
        raise BadInput(f"{path}: not {what}: {error} is missing") from None
    except OSError as error:
        raise BadInput(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, TypeError, AttributeError, ArithmeticError, RecursionError) as error:
        raise BadInput(f"{path}: not {what}: {error}") from None


def fit_report(path):
    """wr_fit's JSON as a dict with report.points. Raises BadInput."""

    def check(data):
        if not isinstance(data["report"]["points"], list):
            raise TypeError("report.points is no list")
        return data

    return read_json(path, "wr_fit's JSON", check)
