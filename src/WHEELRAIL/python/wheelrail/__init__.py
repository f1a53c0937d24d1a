# SPDX-License-Identifier: GPL-2.0-or-later
"""Rolling contact of wheel and rail: what wr_creep and wr_fit compute, as numpy arrays.

>>> import wheelrail
>>> case = wheelrail.Case("examples/wheelrail/patch.yaml", {"creep": [0.001, 0.01]})
>>> case.solve()["force_x"]

A `Case` is what a case file asks for, `Result` what comes out of it, `Contact` a point contact that
is asked for one operating point after the other; `read_logs` and `fit` are wr_fit. Everything is
in SI units but for friction logs, which are in their own (ns, nm, MPa). What is wrong is an
`Error`."""

from ._core import Case, Contact, Fit, FrictionLog, Law, Result, __version__, fit, read_logs
from ._types import BadInput, Error, Forces, InternalError, NotConverged, OutputError, UsageError

__all__ = [
    "BadInput",
    "Case",
    "Contact",
    "Error",
    "Fit",
    "Forces",
    "FrictionLog",
    "InternalError",
    "Law",
    "NotConverged",
    "OutputError",
    "Result",
    "UsageError",
    "__version__",
    "fit",
    "read_logs",
]
