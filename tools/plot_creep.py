#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Creep-force curves from wr_creep's creep.csv.

    plot_creep.py creep.csv -o creep.png
    plot_creep.py own/creep.csv paper/creep.csv --label "own law" --label paper -o both.png
    plot_creep.py creep.csv --measured examples/wheelrail/eurosprinter.csv -o locomotive.png

One curve for each speed, load, surface, lateral creep and spin of each file. Where the
creep_band.csv of the same run lies beside a file, its 95 % interval from the uncertainty of the
friction law is shaded; several are drawn as bars, at places of their own, so that they can be told
apart. Creep is on a logarithmic axis unless some of it is negative. --measured draws points from
any table with a line of column names: creep and traction_ratio, or those that --columns names. A
creep is in per cent where its name ends in percent or %, or after a line "# creep: %".
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""

import argparse
import math
import os
import sys
from typing import Any

from mcawr import curves, plotting, tables, unit_table
from mcawr.command_line import Parser, file_name
from mcawr.errors import BadInput, run_script
from mcawr.files import check_apart, save_figure

STYLES = ["-", "--", ":", "-."]
BARS = 10  # along a band
SLACK = 1e-6  # of T/N: a band without width is rounded as the curve is not


def read(path: str, columns: tuple[str, ...]) -> dict[Any, Any]:
    """{(name, value) of all that tells a curve from others: {column: [numbers]}} of a CSV file of
    wr_creep."""

    def curves_of(rows: list[tables.Row]) -> dict[Any, Any]:
        told = [
            name for name in curves.COORDINATES if rows and (name == "speed" or name in rows[0])
        ]
        points: dict[str, list[Any]] = {
            name: [row[name] if name in curves.SURFACES else row.number(name) for row in rows]
            for name in dict.fromkeys(("creep", *told, *columns))
        }
        return {
            tuple(key.items()): {column: [points[column][k] for k in numbers] for column in columns}
            for key, numbers in curves.split(points, "creep")
        }

    found = tables.read(path, "a creep.csv of wr_creep", curves_of)
    if not found:
        raise BadInput(f"{path}: no points")
    return found


def is_band_of(band: dict[str, Any] | None, curve: dict[str, Any]) -> bool:
    """Are these the limits of this curve: the same points, and its values between them?"""
    if band is None or len(band["creep"]) != len(curve["creep"]):
        return False
    return all(
        math.isclose(at, creep, rel_tol=1e-6) and low - SLACK <= ratio <= high + SLACK
        for at, creep, low, ratio, high in zip(
            band["creep"], curve["creep"], band["low"], curve["traction_ratio"], band["high"]
        )
    )


def band_of(path: str, found: dict[Any, Any]) -> dict[Any, Any]:
    """The band that lies beside a file, where it is that of its curves; one of other results is
    told and not drawn."""
    band = os.path.join(os.path.dirname(path), "creep_band.csv")
    if not os.path.exists(band):
        return {}
    bands = read(band, ("creep", "low", "high"))
    if all(is_band_of(bands.get(key), curve) for key, curve in found.items()):
        return bands
    print(f"plot_creep.py: warning: {band} is not of {path}: not drawn", file=sys.stderr)
    return {}


def curves_of(path: str, label: str, style: str) -> list[tuple[Any, Any, dict[str, Any]]]:
    """[(values, band or None, style of the line)] of a file; of one colour where only the seed
    differs."""
    found = read(path, ("creep", "traction_ratio"))
    bands = band_of(path, found)
    keys = [dict(key) for key in found]
    varied = [name for name in keys[0] if len({key[name] for key in keys}) > 1 or name == "speed"]
    seedless = [tuple(key[name] for name in varied if name != "seed") for key in keys]
    colors = sorted(set(seedless))
    return [
        (
            curve,
            bands.get(tuple(key.items())),
            {
                "color": f"C{colors.index(color)}",
                "ls": style,
                "marker": "." if len(set(curve["creep"])) == 1 else "",  # no line
                "label": ", ".join(filter(None, [label, *curves.words(key, varied)])),
            },
        )
        for (curve, key, color) in zip(found.values(), keys, seedless)
    ]


def draw_band(axes: Any, band: Any, color: str, number: int, count: int) -> None:
    """A shade for a single band; bars for several, each at other places than those of the
    others."""
    if count == 1:
        axes.fill_between(band["creep"], band["low"], band["high"], color=color, alpha=0.2, lw=0)
        return
    every = max(count, len(band["creep"]) // BARS)
    chosen = slice(number * every // count, None, every)
    creep, low, high = (band[name][chosen] for name in ("creep", "low", "high"))
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    half = [0.5 * (b - a) for a, b in zip(low, high)]
    axes.errorbar(creep, middle, half, fmt="none", color=color, lw=1.1, capsize=2.5)


def measured(path: str, columns: tuple[str, str] | None) -> tuple[list[float], list[float]]:
    """(creeps, T/N) of any table, from the columns with these names."""

    def points_of(
        rows: list[tables.Row], units: unit_table.Units
    ) -> tuple[list[float], list[float]]:
        if not rows:
            raise ValueError("no points")
        names = columns or ("creep" if "creep" in rows[0] else "creep_percent", "traction_ratio")
        unit = units.ratio(names[0])
        return (
            [unit * row.number(names[0]) for row in rows],
            [row.number(names[1]) for row in rows],
        )

    return unit_table.read(path, "a table of measured creep and T/N", points_of)


def column_names(text: str) -> tuple[str, str]:
    creep, comma, ratio = text.partition(",")
    if not (creep and comma and ratio) or "," in ratio:
        raise argparse.ArgumentTypeError(f"'{text}': two names of columns, CREEP,RATIO, are needed")
    return creep, ratio


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("csv", nargs="+", type=file_name, help="creep.csv of wr_creep")
    parser.add_argument("-o", "--output", type=file_name, default="creep.png", metavar="PNG")
    parser.add_argument(
        "--label", action="append", default=[], help="name of a file's curves, in order"
    )
    parser.add_argument(
        "--linear", action="store_true", help="linear instead of logarithmic creep axis"
    )
    parser.add_argument(
        "--measured", action="append", default=[], type=file_name, metavar="CSV",
        help="measured points beside the curves",
    )  # fmt: skip
    parser.add_argument(
        "--columns", type=column_names, metavar="CREEP,RATIO",
        help="names of their columns [creep or creep_percent, traction_ratio]",
    )  # fmt: skip
    given = parser.parse_args()
    if len(given.label) > len(given.csv):
        parser.error(f"--label: {len(given.label)} names for {len(given.csv)} files")
    if given.columns and not given.measured:
        parser.error("--columns: goes with --measured, whose columns it names")
    check_apart([*given.csv, *given.measured], [given.output])
    clouds = [measured(path, given.columns) for path in given.measured]
    figure, axes = plotting.pyplot().subplots(figsize=(7, 4.5), constrained_layout=True)
    drawn = []
    for k, path in enumerate(given.csv):
        label = given.label[k] if k < len(given.label) else ""
        drawn += curves_of(path, label, STYLES[k % len(STYLES)])
    banded = [curve for curve in drawn if curve[1]]
    for number, (_, band, style) in enumerate(banded):
        draw_band(axes, band, style["color"], number, len(banded))
    for values, _, style in drawn:
        axes.plot(values["creep"], values["traction_ratio"], **style)
    for number, (path, (creep, ratio)) in enumerate(zip(given.measured, clouds)):
        name = os.path.splitext(os.path.basename(path))[0]
        marker = "*x+."[number % 4]
        axes.plot(creep, ratio, marker, color="0.4", ms=4, zorder=1, label=f"measured: {name}")
    creeps = [x for values, _, _ in drawn for x in values["creep"]]
    creeps += [x for creep, _ in clouds for x in creep]
    least, most = min(creeps), max(creeps)
    if not given.linear and least >= 0 < most:  # a logarithm would hide what is negative
        axes.set_xscale("log")
    axes.set(
        xlabel="creep, sliding/rolling speed",
        ylabel="traction / load, T/N",
        ylim=(0, None) if least >= 0 else None,
        title="Creep-force curves" + (" with 95 % of the law's uncertainty" if banded else ""),
    )
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    save_figure(figure, given.output, dpi=150)


if __name__ == "__main__":
    run_script(main)
