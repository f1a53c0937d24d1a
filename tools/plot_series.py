#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction against pressure, velocity, viscosity, strength or temperature, from wr_fit's JSON:
picture, table.

    plot_series.py pressure.json --against pressure -o fig4.png
    plot_series.py velocity.json --against velocity -o fig6.png --csv fig6.csv
    plot_series.py law.json --against strength --mu -o strength.png

Runs that differ in their seed only are one point: the mean, with 95 % by the runs' errors or by the
scatter between the seeds, whichever is larger, times Student's t of the number of seeds by which
wr_fit knows what seeds differ by; the runs are the small dots. Two logs of one run are one dot, and
runs that wr_fit --solid-only left out are none; those that only its law leaves out, for a drift or
a small kappa2, are drawn. Where other
quantities vary too there is a line for each of their values. pressure: the friction stress, as in
Fig. 4 of the paper (with --mu: mu); velocity: mu, and above it the largest row of the logs, the
static peak (Fig. 6); viscosity, strength: mu; temperature: mu, with the material as it is at each.
The temperature of a run stands in run.json beside a log of tools/campaign, in the head of a packed
one, or in the shipped plan. Grinding-in: the mean before the stationary part, at most 100 ns.
Dashed: Eq. 2 with the paper's numbers. --csv: a row for each condition. Exit codes: 0 ok, 1 no
matplotlib, 2 usage, 3 bad input file, 5 a file cannot be written.
"""

import csv
import io
import itertools
import math
import os
from typing import Any

from campaign_parts import plan as plans
from mcawr import plotting, tables
from mcawr.archive import ENDING
from mcawr.campaign_record import temperature_of
from mcawr.command_line import Parser, file_name
from mcawr.errors import BadInput, run_script
from mcawr.files import check_apart, picture, save_figure, write_all
from mcawr.replicas import groups, half_width, mean_of, spread_of

LABELS = {
    "pressure": "normal pressure $p$ (MPa)",
    "velocity": "sliding velocity $v$ (m/s)",
    "viscosity": "viscosity $\\eta$ (Pa s)",
    "strength": "strength $\\sigma_0$ (MPa)",
    "temperature": "temperature $T$ (K)",
}
NAMES = {"pressure": "$p$ = {:g} MPa", "velocity": "$v$ = {:g} m/s"}
NAMES |= {"strength": "$\\sigma_0$ = {:g} MPa", "youngs_modulus": "$E$ = {:g} GPa"}
NAMES |= {"viscosity": "$\\eta$ = {:g} Pa s", "temperature": "$T$ = {:g} K"}
OF_MATERIAL = ("strength", "youngs_modulus", "viscosity")  # what changes with the temperature
MOST_LINES = 10


def condition_of(point: dict[str, Any]) -> dict[str, float]:
    """{quantity: value} of all that a run was given but the seed; MPa, m/s, Pa s, E in GPa."""
    values = {name: point[name] for name in LABELS if name in point}
    values["youngs_modulus"] = 1e-3 * point["kappa3"] * point["strength"]
    return {name: float(f"{value:.5g}") for name, value in values.items()}


def conditions(points: list[dict[str, Any]]) -> list[tuple[dict[str, float], list[dict[str, Any]]]]:
    """[(condition, the runs of it)]"""
    found = groups(points, lambda point: tuple(condition_of(point).items()))
    return [(dict(key), members) for key, members in found.items()]


def that_count(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The points with a standard error, each run once, without those that wr_fit --solid-only left
    out. What the law alone leaves out is a point all the same."""
    return [
        point
        for point in points
        if point["mu_se"] is not None
        and not str(point.get("left_out")).startswith(("the run of ", "no solid: "))
    ]


def read(path: str) -> list[dict[str, Any]]:
    """The points of wr_fit's JSON that count. Raises BadInput, too where runs differ in more than
    their seed and what is drawn here: in their size, step, laws."""
    report = tables.fit_report(path)["report"]
    for number, condition in enumerate(report.get("conditions", [])):
        for run in condition["runs"]:
            report["points"][run]["condition"] = number
    points = that_count(report["points"])
    if not points:
        raise BadInput(f"{path}: no point with a standard error")
    for _, members in conditions([point for point in points if "condition" in point]):
        for one, other in itertools.pairwise(members):
            if one["condition"] != other["condition"]:
                raise BadInput(
                    f"{path}: {one['file']} and {other['file']} differ in more than the seed, in "
                    "what no axis here shows (size, step, laws, ...): give wr_fit one kind"
                )
    return points


def in_shipped_plan(path: str) -> float | None:
    """The temperature that a shipped plan has for the run of a log in its archive."""
    folder, name = os.path.split(path)
    plan = os.path.join(plans.SHIPPED, os.path.basename(folder).removesuffix(ENDING) + ".yaml")
    if not folder.endswith(ENDING) or not os.path.isfile(plan):
        return None
    found = {run.name: run.values["temperature"] for run in plans.read(plan).runs}
    return found.get(name.removesuffix(".friction"))


def with_temperatures(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The points with what run.json, or the head of a packed log, says. Raises BadInput."""
    found = []
    for point in points:
        temperature = temperature_of(point["file"]) or in_shipped_plan(point["file"])
        if temperature is None:
            raise BadInput(f"{point['file']}: no temperature: not in run.json, its head or a plan")
        found.append({**point, "temperature": temperature})
    return found


def table_text(points: list[dict[str, Any]]) -> str:
    """CSV: a row for each condition."""
    text = io.StringIO(newline="")
    text.write(
        "# MPa, m/s, Pa s, E in GPa; mu_se: the larger of own_error (the runs') and scatter "
        "(between seeds), standard errors of the mean\n"
    )
    writer = csv.writer(text, lineterminator="\n")
    names = list(condition_of(points[0]))
    writer.writerow([*names, "runs", "mu", "mu_se", "own_error", "scatter", "mu_eq2", "mu_peak"])
    for condition, members in conditions(points):
        mean, own, scatter = spread_of(members)
        numbers = (mean, mean_of(members)[1], own, scatter, members[0]["mu_eq2"])
        peak = mean_of(members, "mu_peak")[0]
        writer.writerow(
            [f"{condition[name]:g}" for name in names]
            + [len(members)]
            + ["" if math.isnan(x) else f"{x:.5g}" for x in (*numbers, peak)]
        )
    return text.getvalue()


def lines_of(points: list[dict[str, Any]], against: str) -> dict[Any, Any]:
    """{what is the same along a line: [(x, runs)]}"""
    found: dict[Any, Any] = {}
    for condition, members in conditions(points):
        x = condition.pop(against)
        if against == "temperature":
            condition = {n: v for n, v in condition.items() if n not in OF_MATERIAL}
        found.setdefault(tuple(condition.items()), []).append((x, members))
    return {key: sorted(line, key=lambda at: at[0]) for key, line in sorted(found.items())}


def name_of(line: Any, lines: Any) -> str:
    """What tells a line from the others."""
    differ = [k for k in range(len(line)) if len({other[k] for other in lines}) > 1]
    return ", ".join(NAMES[line[k][0]].format(line[k][1]) for k in differ)


def draw_line(axes: Any, line: Any, colour: Any, name: str, stress: Any, single: Any) -> None:
    """Means with their 95 %, runs, grinding-in, Eq. 2 of one line."""
    x = [at for at, _ in line]
    factor = x if stress else [1.0] * len(x)

    def values(key: str) -> list[float]:
        return [f * mean_of(members, key)[0] for f, (_, members) in zip(factor, line)]

    means, errors = values("mu"), [f * half_width(m) for f, (_, m) in zip(factor, line)]
    if any(len(members) > 1 for _, members in line):
        runs = [(at, f * p["mu"]) for f, (at, members) in zip(factor, line) for p in members]
        axes.plot(
            *zip(*runs),
            ".",
            color=colour,
            alpha=0.45,
            ms=5,
            label="single runs" if single else None,
        )
    steady = [all(p["t_start"] is not None for p in members) for _, members in line]
    for wanted, fill, what in (
        (True, colour, "mean of the later part, 95 %"),
        (False, "none", "second half: no stationary part"),
    ):
        chosen = [k for k, found in enumerate(steady) if found == wanted]
        if chosen:
            axes.errorbar(
                *([column[k] for k in chosen] for column in (x, means, errors)),
                fmt="o",
                ms=4.5,
                lw=1.4,
                capsize=3,
                color=colour,
                mfc=fill,
                label=what if single else name if wanted or not any(steady) else None,
            )
    if single:
        axes.plot(
            x, values("mu_grinding_in"), "^", color="C1", ms=5, label="mean of the part before it"
        )
    label = "Eq. 2 with the paper's numbers" if single else None
    axes.plot(x, values("mu_eq2"), "--", color="k" if single else colour, lw=1.2, label=label)


def figure_of(points: list[dict[str, Any]], against: str, stress: Any) -> Any:
    """The figure of wr_fit's points, in order of the quantity on the abscissa."""
    lines = lines_of(points, against)
    if len(lines) > MOST_LINES:
        raise BadInput(f"{len(lines)} lines against {against}, {MOST_LINES} can be told apart")
    plt = plotting.pyplot()
    if against == "velocity":
        figure, (top, axes) = plt.subplots(
            2, 1, figsize=(7, 5.6), sharex=True, layout="constrained", height_ratios=(1, 2.6)
        )
    else:
        figure, axes = plt.subplots(figsize=(7, 4.8), layout="constrained")
    single = len(lines) == 1
    for k, (key, line) in enumerate(lines.items()):
        draw_line(axes, line, f"C{k}", name_of(key, lines), stress, single)
        if against == "velocity":
            peaks = [mean_of(members, "mu_peak")[0] for _, members in line]
            top.plot([x for x, _ in line], peaks, "v-", color=f"C{k}", lw=0.8, ms=5)
    axes.set(xlabel=LABELS[against])
    axes.set_ylabel("friction stress (MPa)" if stress else "friction coefficient $\\mu$")
    if against == "viscosity" and min(point["viscosity"] for point in points) > 0:
        axes.set_xscale("log")
    elif against != "temperature":
        axes.set_xlim(left=0)
    if stress:
        axes.set_ylim(bottom=0)
    else:
        axes.margins(y=0.15)  # errors are small beside mu: its axis does not begin at 0
    if against == "velocity":
        top.set(ylabel="static peak", ylim=(0, 1.1 * max(p["mu_peak"] for p in points)))
        top.grid(alpha=0.3)
    axes.grid(alpha=0.3)
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], labels[::-1], fontsize=9)  # the stationary part first
    return figure


def draw(points: list[dict[str, Any]], against: str, path: str) -> None:
    """Writes the picture of wr_fit's points that count."""
    save_figure(figure_of(that_count(points), against, against == "pressure"), path)


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("json", type=file_name, help="wr_fit's JSON (wr_fit -o)")
    parser.add_argument("--against", choices=list(LABELS), required=True)
    parser.add_argument("-o", "--output", type=file_name, default="series.png", metavar="PNG")
    parser.add_argument("--mu", action="store_true", help="mu, not the stress, against pressure")
    parser.add_argument("--csv", type=file_name, help="table with a row for each condition")
    given = parser.parse_args()
    check_apart([given.json], [given.output, given.csv])
    points = read(given.json)
    if given.against == "temperature":
        points = with_temperatures(points)
    stress = given.against == "pressure" and not given.mu
    files: dict[str, str | bytes] = {
        given.output: picture(figure_of(points, given.against, stress), given.output)
    }
    if given.csv:
        files[given.csv] = table_text(points)
    write_all(files)


if __name__ == "__main__":
    run_script(main)
