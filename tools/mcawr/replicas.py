# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of one condition with several seeds: their mean, and how far it is known."""

import math
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

Point = TypeVar("Point")


def groups(points: Iterable[Point], key: Callable[[Point], Any]) -> dict[Any, list[Point]]:
    """{key(point): points} in order of the key."""
    found: dict[Any, list[Point]] = {}
    for point in points:
        found.setdefault(key(point), []).append(point)
    return dict(sorted(found.items()))


def spread_of(points: list[dict[str, Any]], key: str = "mu") -> tuple[float, float, float]:
    """(mean over the points, standard error of it by the runs' own errors, the same by their
    scatter; nan of a single run)."""
    values = [p[key] for p in points if p[key] is not None]
    if not values:
        return math.nan, math.nan, math.nan
    mean = math.fsum(values) / len(values)
    own = math.sqrt(sum((p["mu_se"] or 0) ** 2 for p in points)) / len(points)
    if len(values) < 2:
        return mean, own, math.nan
    variance = sum((value - mean) ** 2 for value in values) / (len(values) - 1)
    return mean, own, math.sqrt(variance / len(values))


def mean_of(points: list[dict[str, Any]], key: str = "mu") -> tuple[float, float]:
    """(mean over the points, its standard error: the larger of what the runs' own errors and their
    scatter say)."""
    mean, own, scatter = spread_of(points, key)
    return mean, own if math.isnan(scatter) else max(own, scatter)


NORMAL = 1.96  # of 95 % in standard errors that are known


def student95(freedom: float) -> float:
    """How many standard errors 95 % reach where an error is known by its own scatter, with these
    degrees of freedom (at least 1): Student's t, by its integral and bisection."""

    def within(angle: float) -> float:  # of the distribution, x = sqrt(freedom) tan(angle)
        n = 400  # Simpson
        weights = (1 if k in (0, n) else 4 if k % 2 else 2 for k in range(n + 1))
        cosines = (math.cos(angle * k / n) ** (freedom - 1) for k in range(n + 1))
        integral = math.fsum(w * c for w, c in zip(weights, cosines)) * angle / n / 3
        gammas = math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)
        return 2 * integral * math.exp(gammas) / math.sqrt(math.pi)

    low, high = 0.0, math.pi / 2
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if within(middle) < 0.95 else (low, middle)
    return math.sqrt(freedom) * math.tan(low)


def half_width(points: list[dict[str, Any]]) -> float:
    """Half the 95 % interval of the mean over the points: its standard error times Student's t of
    the seeds by which wr_fit knows what seeds differ by."""
    return mean_of(points)[1] * points[0].get("t95", NORMAL)
