#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Figs. 4 and 6 of the paper from wr_fit's JSON: friction against pressure, velocity or viscosity.

    plot_series.py pressure.json --against pressure -o fig4.png
    plot_series.py velocity.json --against velocity -o fig6.png

pressure: friction stress, grinding-in and stationary (Fig. 4). velocity: mu, stationary, with the
static peak of each run (Fig. 6). viscosity, strength: mu. Bars: 95 % of each run's own error; line:
Eq. 2 with the paper's numbers. Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the
picture cannot be written.
"""

import argparse
import math

from mcawr import plotting, tables
from mcawr.errors import BadInput, run_script
from mcawr.files import save_figure

LABELS = {
    "pressure": "normal pressure $p$ (MPa)",
    "velocity": "sliding velocity $v$ (m/s)",
    "viscosity": "viscosity $\\eta$ (Pa s)",
    "strength": "strength $\\sigma_0$ (MPa)",
}


def read(path):
    """The points of wr_fit's JSON that have a standard error."""

    def points_of(data):
        return [p for p in data["report"]["points"] if p["mu_se"] is not None]

    return tables.read_json(path, "wr_fit's JSON", points_of)


def number(value):
    return math.nan if value is None else value


def draw(points, against, path):
    """The picture of wr_fit's points, in order of the quantity on the abscissa."""
    plt = plotting.pyplot()
    points = sorted((p for p in points if p["mu_se"] is not None), key=lambda p: p[against])
    stress = against == "pressure"
    factor = [p["pressure"] if stress else 1.0 for p in points]
    x = [p[against] for p in points]
    figure, axes = plt.subplots(figsize=(7, 4.8), constrained_layout=True)

    def values(key):
        return [number(p[key]) * f for p, f in zip(points, factor)]

    steady = [i for i, p in enumerate(points) if p["t_start"] is not None]
    drifting = [i for i, p in enumerate(points) if p["t_start"] is None]
    mu, error = values("mu"), [1.96 * e for e in values("mu_se")]
    for chosen, style in (
        (steady, dict(fmt="o", color="C0", label="stationary part, or from a given time on")),
        (drifting, dict(fmt="o", color="C0", mfc="none", label="no stationary part: second half")),
    ):
        if chosen:
            axes.errorbar(
                [x[i] for i in chosen],
                [mu[i] for i in chosen],
                yerr=[error[i] for i in chosen],
                ms=5,
                lw=1,
                capsize=2,
                **style,
            )
    axes.plot(
        x,
        values("mu_grinding_in"),
        "^",
        color="C1",
        ms=5,
        label="grinding-in (before, at most 100 ns)",
    )
    if against == "velocity":
        axes.plot(
            x,
            values("mu_peak"),
            "v",
            color="C3",
            ms=5,
            label="largest row of the log (static peak)",
        )
    same = (
        len(
            {
                (
                    p["strength"],
                    p["velocity"] if against != "velocity" else 0,
                    p["pressure"] if against != "pressure" else 0,
                )
                for p in points
            }
        )
        == 1
    )
    if same or against == "strength":  # else Eq. 2 is no line over this abscissa
        axes.plot(x, values("mu_eq2"), "k--", label="Eq. 2 with the paper's numbers")
    axes.set_xlabel(LABELS[against])
    axes.set_ylabel("friction stress (MPa)" if stress else "friction coefficient $\\mu$")
    if against == "viscosity":
        axes.set_xscale("log")
    else:
        axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3)
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], labels[::-1], fontsize=9)  # the stationary part first
    save_figure(figure, path)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("json", help="wr_fit's JSON (wr_fit -o)")
    parser.add_argument("--against", choices=list(LABELS), required=True)
    parser.add_argument("-o", "--output", default="series.png", metavar="PNG")
    given = parser.parse_args()
    points = read(given.json)
    if not points:
        raise BadInput(f"{given.json}: no point with a standard error")
    draw(points, given.against, given.output)


if __name__ == "__main__":
    run_script(main)
