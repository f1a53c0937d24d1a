#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction coefficient against time with its running mean, from friction logs (*.friction).

    plot_friction.py run.friction -o friction.png
    plot_friction.py a.friction b.friction --window 5 --runs runs.csv -o both.png

Grey: the rows of the log. Coloured: mean over a window centred on each row. Dashed: what wr_fit
took for the stationary part (with --runs). Exit codes: 0 ok, 1 no matplotlib, 2 usage,
3 bad input file, 5 the picture cannot be written.
"""

import math
import os
from typing import Any

from mcawr import archive, friction_log, plotting, tables
from mcawr.command_line import Parser, file_name, number_in
from mcawr.errors import BadInput, complain, run_script
from mcawr.files import check_apart, save_figure


def read_log(path: str) -> tuple[str, list[float], list[float]]:
    """(loading line, time in ns, mu) of a friction log; a cut last line is left out."""
    if archive.is_archive(path):
        raise BadInput(f"{path}: is an archive: name a log in it, {path}/NAME.friction")
    log = friction_log.read(path, ("time", "mu"))
    try:
        label = (
            f"p = {log.head['loading']['pressure']:g} MPa, "
            f"v = {log.head['loading']['velocity']:g} m/s, "
            f"$\\sigma_0$ = {log.head['material']['strength']:g} MPa"
        )
    except (KeyError, TypeError, ValueError):
        raise BadInput(f"{path}: not a friction log: its head is incomplete") from None
    if len(log.columns["time"]) < 2:
        raise BadInput(f"{path}: fewer than two rows")
    return label, log.columns["time"], log.columns["mu"]


def running_mean(values: list[float], half: int) -> list[float]:
    """Mean over 2 half + 1 rows centred on each; at the ends over those of them that are there."""
    total = [0.0]
    for value in values:
        total.append(total[-1] + value)
    result = []
    for i in range(len(values)):
        first, last = max(0, i - half), min(len(values) - 1, i + half)
        result.append((total[last + 1] - total[first]) / (last + 1 - first))
    return result


def read_runs(path: str) -> dict[str, Any]:
    """file name -> (mu, t_start) of wr_fit's runs.csv, whose names are from where wr_fit was
    called: here, or where the table is."""
    places = ("", os.path.dirname(path))

    def means_of(rows: list[tables.Row]) -> dict[str, Any]:
        return {
            os.path.realpath(os.path.join(place, row["file"])): (
                row.number("mu"),
                math.nan if row["t_start"] == "nan" else row.number("t_start"),
            )
            for row in rows
            for place in places
        }

    return tables.read(path, "wr_fit's runs.csv", means_of)


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("logs", nargs="+", type=file_name, metavar="LOG")
    parser.add_argument("-o", "--output", type=file_name, default="friction.png", metavar="PNG")
    parser.add_argument(
        "--window",
        type=number_in(unit="ns"),
        metavar="NS",
        help="width of the running mean [a tenth of the log]",
    )
    parser.add_argument(
        "--runs",
        "--points",  # its older name
        type=file_name,
        metavar="CSV",
        help="wr_fit's runs.csv: shows the stationary means",
    )
    given = parser.parse_args()
    check_apart([*given.logs, *filter(None, [given.runs])], [given.output])
    logs = [read_log(path) for path in given.logs]
    runs = read_runs(given.runs) if given.runs else {}
    figure, axes = plotting.pyplot().subplots(figsize=(8, 4.5), constrained_layout=True)
    top = 0.0
    for number, (path, (label, times, values)) in enumerate(zip(given.logs, logs)):
        colour = f"C{number}"
        window = given.window or 0.1 * times[-1]
        row = times[1] - times[0]
        half = max(1, round(0.5 * window / row))
        window = (2 * half + 1) * row
        mean = running_mean(values, half)
        single = len(logs) == 1
        axes.plot(
            times,
            values,
            color="0.75" if single else colour,
            alpha=1 if single else 0.25,
            lw=0.8,
            label="rows of the log" if single else None,
        )
        axes.plot(
            times,
            mean,
            color=colour,
            lw=2,
            label=f"running mean over {window:.3g} ns" + ("" if single else f": {label}"),
        )
        if given.runs and os.path.realpath(path) not in runs:
            complain(f"{path}: is in no row of {given.runs}")
        if os.path.realpath(path) in runs:
            mu, start = runs[os.path.realpath(path)]
            if math.isfinite(start):
                axes.plot(
                    [start, times[-1]],
                    [mu, mu],
                    color=colour,
                    ls="--",
                    lw=1.5,
                    label=f"stationary part: {mu:.3f}",
                )
        # the static peak may be several times the rest
        ordered = sorted(values)
        top = max(top, 1.3 * ordered[int(0.98 * (len(ordered) - 1))], 1.1 * max(mean))
        axes.set_title(label if single else "Sliding friction", fontsize=11)
    axes.set_xlabel("time (ns)")
    axes.set_ylabel("friction coefficient $\\mu$")
    axes.set_xlim(left=0)
    low = min(0.0, *(min(running_mean(v, 2)) for _, _, v in logs))
    axes.set_ylim(low, top)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    save_figure(figure, given.output)


if __name__ == "__main__":
    run_script(main)
