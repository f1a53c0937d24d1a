# SPDX-License-Identifier: GPL-2.0-or-later
"""What the figures share: texts and means over seeds."""

import math
import os
from typing import Any

import numpy as np

from campaign_parts import plan as plans
from mcawr.archive import ENDING
from mcawr.errors import BadInput

STEEL = 2239  # kappa3 = E/sigma_0 of the paper's weakest steel, 206 GPa over 92 MPa


class Missing(BadInput):
    """What a figure needs and is not there, in one line."""


def run_name(point: dict[str, Any]) -> str:
    """Name of the run that a log belongs to: of its folder, or of the packed file."""
    folder, name = os.path.split(point["file"])
    return os.path.basename(folder) if name == "run.friction" else name.removesuffix(".friction")


def plan_name(point: dict[str, Any]) -> str:
    """Name of the plan that a log belongs to: of the archive or the folder with its runs."""
    folder, name = os.path.split(point["file"])
    runs = os.path.dirname(folder) if name == "run.friction" else folder
    return os.path.basename(runs).removesuffix(ENDING)


def planned(plan: str, points: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """{name of a run: its values} of a plan. Raises Missing where a point is of no run of it."""
    of = {run.name: run.values for run in plans.read(plans.find(plan)).runs}
    if strange := {run_name(point) for point in points} - of.keys():
        raise Missing(f"not of the plan {plan}: {', '.join(sorted(strange))}")
    return of


def with_own_errors(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The points with what each run knows of itself as the error of mu: where wr_fit would take
    runs that differ on purpose for replicas."""
    return [{**point, "mu_se": point["mu_se_own"]} for point in points]


def table(head: list[str], rows: list[list[str]]) -> list[str]:
    """Lines of a table of texts, columns as wide as needed."""
    cells = [head, *rows]
    width = [max(len(row[k]) for row in cells) for k in range(len(head))]
    return [
        "  ".join(
            c.ljust(w) if k == 0 else c.rjust(w) for k, (c, w) in enumerate(zip(row, width))
        ).rstrip()
        for row in cells
    ]


def percent(ours: float, paper: float) -> str:
    """Relative difference of two numbers of one unit, as text."""
    return f"{round(100 * (ours / paper - 1), 1) + 0.0:+.1f} %"  # 0.0: no -0.0


def quotient(over: tuple[float, float], under: tuple[float, float]) -> tuple[float, float]:
    """(ratio, its standard error) of two independent (means, their standard errors), neither 0."""
    ratio = over[0] / under[0]
    return ratio, abs(ratio) * math.hypot(over[1] / over[0], under[1] / under[0])


def scatter_of(values: Any, errors: Any) -> tuple[float, float]:
    """Standard deviation of values over their mean, and what their own standard errors explain of
    it, both in %."""
    mean = np.mean(values)
    return 100 * np.std(values, ddof=1) / mean, 100 * math.sqrt(np.mean(np.square(errors))) / mean


def straight_line(x: Any, y: Any, errors: Any) -> tuple[float, float, float, float]:
    """(a, b, their standard errors) of y = a + b x: least squares with the standard errors of y and
    the scatter beyond them, up to 1, that makes chi^2 the degrees of freedom, as wr_fit."""
    low, high = 0.0, 1.0
    for _ in range(60):
        scatter = 0.5 * (low + high)
        weight = 1 / np.hypot(errors, scatter)
        (b, a), covariance = np.polyfit(x, y, 1, w=weight, cov="unscaled")
        chi_squared = np.sum((weight * (y - a - b * x)) ** 2)
        low, high = (scatter, high) if chi_squared > len(x) - 2 else (low, scatter)
    b_error, a_error = np.sqrt(np.diag(covariance))
    return a, b, a_error, b_error


def power_law(x: Any, y: Any, errors: Any) -> tuple[float, float, float, float]:
    """(A, n, their standard errors) of y = A x^n: a straight line through the logarithms, with the
    relative standard errors of y."""
    a, n, a_error, n_error = straight_line(np.log(x), np.log(y), errors)
    return math.exp(a), n, math.exp(a) * a_error, n_error
