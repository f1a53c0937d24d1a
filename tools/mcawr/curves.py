# SPDX-License-Identifier: GPL-2.0-or-later
"""Curves in the tables of wr_creep: which operating points belong to one, and what it is called."""

from collections.abc import Container, Mapping
from typing import Any

CREEPAGES = ("creep", "lateral", "spin")
SURFACES = ("seed", "surface", "profile")  # of generated ones, measured maps, measured profiles
COORDINATES = ("speed", "load", *CREEPAGES, *SURFACES)
UNITS = {"speed": "m/s", "load": "N", "spin": "/mm"}


def split(points: Mapping[str, Any], coordinate: str) -> list[tuple[dict[str, Any], list[int]]]:
    """[({name: value}, its rows)] of each curve over a coordinate: all others are the same.

    points: {column: values}, as many coordinates as the table has. A creepage that is another in
    each row was found under a force: it tells no curves apart.
    """
    count = len(points[coordinate])
    found = [name for name in CREEPAGES if name in points and len(set(points[name])) == count]
    others = [name for name in COORDINATES if name in points and name not in (coordinate, *found)]
    curves: dict[Any, list[int]] = {}
    for k in range(count):
        curves.setdefault(tuple(points[name][k] for name in others), []).append(k)
    return [(dict(zip(others, key)), rows) for key, rows in curves.items()]


def words(key: Mapping[str, Any], varied: Container[str]) -> list[str]:
    """Those coordinates of a curve that are varied, with their units."""
    return [
        f"{name} {value if isinstance(value, str) else format(value, 'g')} {UNITS.get(name, '')}"
        .strip()
        for name, value in key.items()
        if name in varied
    ]  # fmt: skip
