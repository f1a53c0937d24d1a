# SPDX-License-Identifier: GPL-2.0-or-later
"""The errors of the programs as exceptions, one for each exit code, and small results."""

from typing import NamedTuple


class Error(Exception):
    """What a user can act on, in one line: `code` is the exit code of the programs, `file`, `line`
    (0: none) and `keyword` say where the fault is; empty where it is in no file."""

    code = 1

    def __init__(self, message: str, file: str = "", line: int = 0, keyword: str = "") -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.keyword = keyword


class InternalError(Error):
    """A bug of ours."""


class UsageError(Error, ValueError):
    """An argument of the call."""

    code = 2


class BadInput(Error, ValueError):
    """A case, or a file, that is missing, unreadable or wrong."""

    code = 3


class NotConverged(Error, ArithmeticError):
    """Not converged, or not determined by the data."""

    code = 4


class OutputError(Error, OSError):
    """A file that cannot be written."""

    code = 5


CLASSES = {
    one.code: one for one in (InternalError, UsageError, BadInput, NotConverged, OutputError)
}


class Forces(NamedTuple):
    """On the wheel, against its slip: N, N, and N m about the normal through the origin."""

    force_x: float
    force_y: float
    moment_z: float
