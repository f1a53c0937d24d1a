#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Shakedown map: operating points of wr_creep against what a rail bears again and again.

    plot_shakedown.py out/creep.csv --shear-yield 500 -o map.png
    plot_shakedown.py smooth/creep.csv rough/creep.csv --shear-yield 500 -o map.png
    plot_shakedown.py out/creep.csv --stresses out/subsurface_0003.csv --shear-yield 500 -o map.png

Each operating point of a point contact stands at its T/N and its largest pressure over the shear
yield stress k (--shear-yield, MPa). Lines, of a line contact that slides in full with T/N, from the
exact stresses of a cylinder (K. L. Johnson, Contact Mechanics, 1985, secs. 7.1, 9.2):
  first yield            the largest shear stress anywhere reaches k
  elastic shakedown      above it each passage flows anew: the shear stress along the surface, which
                         no residual stress takes away, reaches k below the surface or on it
--stresses draws, for the operating point whose number stands in the name of the file, where its
own largest shear stress and its own orthogonal shear stress (of the rail) would reach k.
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""

import argparse
import os
import re
from typing import Any

from mcawr import plotting, tables
from mcawr.command_line import Parser, file_name, number_in
from mcawr.errors import BadInput, run_script
from mcawr.files import check_apart, save_figure

np: Any = None  # set by main()


def cylinder_stress(x: Any, z: Any, mu: float) -> tuple[Any, Any, Any]:
    """xx, zz, zx below a cylinder, half-width and p0 1, that slides with mu to larger x (the
    traction on the body points there); plane."""
    a = 1.0 - x**2 + z**2
    root = np.sqrt(a**2 + 4.0 * x**2 * z**2)
    m = np.sqrt(0.5 * (root + a))
    n = np.sign(x) * np.sqrt(np.maximum(0.0, 0.5 * (root - a)))
    both = m**2 + n**2
    xx = -(m * (1.0 + (z**2 + n**2) / both) - 2.0 * z)
    zz = -m * (1.0 - (z**2 + n**2) / both)
    zx = -n * (m**2 - z**2) / both
    along = n * (2.0 - (z**2 - m**2) / both) - 2.0 * x
    return xx + mu * along, zz + mu * zx, zx + mu * xx


def limits(mu: float) -> tuple[float, float]:
    """p0/k at first yield (Tresca, nu 0.3) and at the limit of elastic shakedown."""
    x, z = np.meshgrid(np.linspace(-1.5, 1.5, 201), np.linspace(0.004, 1.2, 150))
    xx, zz, zx = cylinder_stress(x, z, mu)
    middle, radius = 0.5 * (xx + zz), np.hypot(0.5 * (xx - zz), zx)
    yy = 0.3 * (xx + zz)
    principal = np.sort(np.stack([middle - radius, middle + radius, yy]), axis=0)
    shear = 0.5 * (principal[2] - principal[0]).max()
    return 1.0 / shear, 1.0 / max(abs(zx).max(), mu)  # on the surface zx is the traction


def read_points(path: str) -> dict[str, Any]:
    names = ("traction_ratio", "peak_pressure")

    def columns(rows: list[tables.Row]) -> dict[str, Any]:
        return {name: np.array([row.number(name) for row in rows]) for name in names}

    found = tables.read(path, "a creep.csv of a point contact", columns)
    if not len(found["traction_ratio"]):
        raise BadInput(f"{path}: no operating points")
    return found


def read_stresses(path: str) -> tuple[int, dict[str, float]]:
    """Number of the operating point and the largest stresses of the rail over all depths."""
    number = re.search(r"(\d+)\.csv$", path)
    if not number or int(number[1]) < 1:
        raise BadInput(f"{path}: no number of an operating point in the name, 1 the first")

    def largest(rows: list[tables.Row]) -> dict[str, float]:
        rail = [row for row in rows if row["body"] == "rail"]
        if not rail:
            raise BadInput(f"{path}: no row of the rail")
        names = ("max_shear", "orthogonal_shear")
        found = {name: max(row.number(name) for row in rail) for name in names}
        for name, stress in found.items():
            if not stress > 0:
                raise BadInput(f"{path}: largest {name} of the rail {stress:g}, allowed: > 0")
        return found

    return int(number[1]), tables.read(path, "a subsurface table of wr_creep", largest)


def draw(given: argparse.Namespace, plt: Any) -> None:
    figure, axis = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
    all_points = {path: read_points(path) for path in given.files}
    widest = max(0.6, *(1.05 * p["traction_ratio"].max() for p in all_points.values()))
    ratios = np.linspace(0.0, widest, 61)
    first, shakedown = np.array([limits(mu) for mu in ratios]).T
    axis.plot(ratios, first, color="0.4", ls="--", label="first yield, line contact")
    axis.plot(ratios, shakedown, color="k", label="elastic shakedown, line contact")
    axis.fill_between(ratios, shakedown, 20.0, color="tab:red", alpha=0.08, lw=0)
    highest = 6.0
    for path, points in all_points.items():
        loads = points["peak_pressure"] / given.shear_yield
        highest = max(highest, 1.15 * loads.max())
        name = os.path.basename(os.path.dirname(os.path.abspath(path)))
        axis.plot(points["traction_ratio"], loads, "o", ms=4, label=name)
    points = all_points[given.files[0]]
    for path in given.stresses:
        number, stress = read_stresses(path)
        if number > len(points["traction_ratio"]):
            raise BadInput(f"{path}: {given.files[0]} has no operating point {number}")
        ratio = points["traction_ratio"][number - 1]
        for name, mark in (("max_shear", "_"), ("orthogonal_shear", "x")):
            load = points["peak_pressure"][number - 1] / stress[name]
            highest = max(highest, 1.15 * load)
            label = f"k = its {name.replace('_', ' ')}" if path == given.stresses[0] else None
            axis.plot(ratio, load, mark, ms=9, color="tab:red", label=label)
    axis.set(xlim=(0, widest), ylim=(0, highest), xlabel="T/N")
    axis.set_ylabel(f"largest pressure over k = {given.shear_yield:g} MPa")
    axis.legend(fontsize=8)
    save_figure(figure, given.output, dpi=150)


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("files", nargs="+", metavar="creep.csv", type=file_name)
    parser.add_argument("--stresses", nargs="+", default=[], metavar="CSV", type=file_name)
    parser.add_argument("--shear-yield", required=True, metavar="MPa", type=number_in(unit="MPa"))
    parser.add_argument("-o", "--output", required=True, metavar="PNG", type=file_name)
    given = parser.parse_args()
    check_apart([*given.files, *given.stresses], [given.output])
    plt = plotting.pyplot()
    global np
    import numpy as np

    draw(given, plt)


if __name__ == "__main__":
    run_script(main)
