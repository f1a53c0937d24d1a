#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Creep-force curves from wr_creep's creep.csv.

    plot_creep.py creep.csv -o creep.png
    plot_creep.py own/creep.csv paper/creep.csv --label "own law" --label paper -o both.png

One curve for each speed (and seed) of each file. Where creep_band.csv lies beside a file, its 95 %
interval from the uncertainty of the friction law is shaded.
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""

import argparse
import os

from mcawr import plotting, tables
from mcawr.errors import BadInput, run_script
from mcawr.files import save_figure

STYLES = ["-", "--", ":", "-."]


def read(path):
    """{(speed, seed): {column: [numbers]}} of a CSV file of wr_creep."""

    def curves_of(rows):
        curves = {}
        for row in rows:
            key = (float(row["speed"]), row.get("seed", ""))
            curve = curves.setdefault(key, {})
            for name, value in row.items():
                if name != "seed":
                    curve.setdefault(name, []).append(float(value))
        return curves

    curves = tables.read(path, "a creep.csv of wr_creep", curves_of)
    if not curves:
        raise BadInput(f"{path}: no points")
    return curves


def band_of(path):
    band = os.path.join(os.path.dirname(path), "creep_band.csv")
    return read(band) if os.path.exists(band) else {}


def draw(axes, path, label, style):
    curves, bands = read(path), band_of(path)
    speeds = sorted({speed for speed, _ in curves})
    for (speed, seed), curve in curves.items():
        color = f"C{speeds.index(speed)}"
        name = " ".join(filter(None, [label, f"{speed:g} m/s", seed and f"seed {seed}"]))
        axes.plot(curve["creep"], curve["traction_ratio"], style, color=color, label=name)
        if (speed, seed) in bands:
            band = bands[speed, seed]
            axes.fill_between(
                band["creep"], band["low"], band["high"], color=color, alpha=0.2, lw=0
            )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("csv", nargs="+", help="creep.csv of wr_creep")
    parser.add_argument("-o", "--output", default="creep.png", metavar="PNG")
    parser.add_argument(
        "--label", action="append", default=[], help="name of a file's curves, in order"
    )
    parser.add_argument(
        "--linear", action="store_true", help="linear instead of logarithmic creep axis"
    )
    given = parser.parse_args()
    figure, axes = plotting.pyplot().subplots(figsize=(7, 4.5), constrained_layout=True)
    for k, path in enumerate(given.csv):
        draw(axes, path, given.label[k] if k < len(given.label) else "", STYLES[k % len(STYLES)])
    if not given.linear:
        axes.set_xscale("log")
    axes.set(
        xlabel="creep, sliding/rolling speed",
        ylabel="traction / load, T/N",
        ylim=(0, None),
        title="Creep-force curves",
    )
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    save_figure(figure, given.output, dpi=150)


if __name__ == "__main__":
    run_script(main)
