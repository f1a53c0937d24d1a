# SPDX-License-Identifier: GPL-2.0-or-later
"""How wide a fragment has to be: the plans `width`, `width-long` and `light`, by the rules of
doc/how_chosen.md."""

import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from campaign_parts import size
from mcawr.files import save_figure
from mcawr.replicas import NORMAL, groups, mean_of

from .ageing import over_distance
from .common import Missing, percent, plan_name, planned, quotient, run_name, table, with_own_errors
from .dots import dots
from .layer import window

ENOUGH = 0.03  # of mu: what twice and four times the width may change beyond the errors
WIDEST = 320  # columns
SETTLED = 500  # nm from which the means of the plan width-long are taken
WAYS = ((0, 250), (250, 500), (500, 750), (750, 1000))  # nm of sliding
BLOCK = 50  # nm over which the picture of width-long takes means


def is_enough(means: dict[int, tuple[float, float]], columns: int) -> bool | None:
    """Rule 1: neither twice nor four times of it changes mu by more than 3 % or its standard error.
    None where no wider one ran."""
    wider = [means[n] for n in (2 * columns, 4 * columns) if n in means]
    mu, error = means[columns]
    change = [(abs(other - mu), max(ENOUGH * mu, math.hypot(error, e))) for other, e in wider]
    return all(by <= most for by, most in change) if change else None


def least_enough(means: dict[int, tuple[float, float]]) -> int:
    """Rule 3: the least width from which on all are enough; the widest that ran where none is."""
    widths = sorted(means)
    enough = [n for n in widths if all(is_enough(means, m) is not False for m in widths if m >= n)]
    return enough[0]


def against_wider(means: dict[int, tuple[float, float]], columns: int) -> tuple[str, str]:
    """Cells of a width: its mu against that of the widest, and whether it is enough; both empty of
    the widest."""
    if WIDEST not in means or columns == WIDEST:
        of_widest = ""
    else:
        of_widest = percent(means[columns][0], means[WIDEST][0])
    return of_widest, {None: "", True: "yes", False: "no"}[is_enough(means, columns)]


def scatter_in_bins(numbers: list[float], ratios: list[float]) -> tuple[float, int]:
    """Rule 2: (standard deviation of ratios from the means of their bins, a factor 2 of their
    numbers wide, number of bins). Each bin has lost the degree of freedom of its mean, so that many
    bins of few do not leave less by themselves; nan where every bin has one ratio only."""
    bins = groups(zip(numbers, ratios), lambda pair: math.floor(math.log2(pair[0])))
    left = [r - np.mean([y for _, y in members]) for members in bins.values() for _, r in members]
    freedom = len(left) - len(bins)
    return (math.sqrt(np.sum(np.square(left)) / freedom) if freedom else math.nan), len(bins)


def width(report: dict[str, Any], picture: str) -> list[str]:
    """mu against columns at each condition, and over that of the widest against what may decide."""
    # what seeds differ by follows from those of one width
    points = with_own_errors(report["report"]["points"])
    of = planned("width", points)

    def condition(point: dict[str, Any]) -> tuple[float, str]:
        return point["pressure"] / point["strength"], run_name(point).split("-columns")[0]

    rows, ratios, least = [], [], []
    figure, axes = pyplot.subplots(1, 2, figsize=(9.6, 4.2), layout="constrained")
    for number, ((share, name), members) in enumerate(groups(points, condition).items()):
        widths = groups(members, lambda point: of[run_name(point)]["columns"])
        means = {columns: mean_of(runs) for columns, runs in widths.items()}
        junctions = {n: size.junctions(of[run_name(runs[0])]) for n, runs in widths.items()}
        for columns, runs in widths.items():
            (mu, error), (smooth, _) = means[columns], mean_of(runs, "smooth")
            of_widest, enough = against_wider(means, columns)
            if WIDEST in means and columns < WIDEST:
                ratios.append((columns, junctions[columns], mu / means[WIDEST][0]))
            rows.append(
                [
                    f"{name}: {columns} columns",
                    f"{share:.3g}",
                    f"{junctions[columns]:.2g}",
                    str(len(runs)),
                    f"{mu:.3f} +- {error:.3f}",
                    of_widest,
                    f"{100 * smooth:.0f} %",
                    enough,
                ]
            )
        least.append(f"{name} {least_enough(means)}")
        label = f"{name}: $p/\\sigma_0$ = {share:.3g}"
        draw(axes[0], list(widths), means, f"C{number}", label)
        draw(axes[1], list(junctions.values()), means, f"C{number}")
    axes[0].set(xlabel="columns", ylabel="friction coefficient $\\mu$")
    axes[1].set(xlabel="junctions at once, $p W/(d \\sigma_{link})$")
    for one in axes:
        one.set_xscale("log", base=2)
        one.xaxis.set_major_formatter("{x:g}")
        one.set_ylim(0, 1)
        one.grid(alpha=0.3)
    axes[0].set_xticks([20, 40, 80, 160, WIDEST])
    axes[0].legend(fontsize=8, ncols=2, loc="lower center")
    save_figure(figure, picture)
    head = ["", "p/sigma_0", "junctions", "runs", "mu", f"of {WIDEST}", "smooth", "enough"]
    return [*table(head, rows), "", f"columns by the rule: {', '.join(least)}", *decided(ratios)]


def draw(axes: Any, x: list[Any], means: Any, colour: str, label: str | None = None) -> None:
    """mu of one condition, bars of 95 %."""
    mu, errors = zip(*means.values())
    bars = [NORMAL * error for error in errors]
    axes.errorbar(x, mu, bars, color=colour, marker="o", ms=4, lw=1, capsize=2, label=label)


def decided(ratios: list[tuple[int, float, float]]) -> list[str]:
    """Which number leaves the smaller scatter of mu over that of the widest."""
    if len(ratios) < 3:
        return []
    values = [ratio for *_, ratio in ratios]
    lines = ["", f"scatter of mu over that of {WIDEST} columns in bins of a factor 2"]
    for title, at in (("columns", 0), ("junctions", 1)):
        scatter, bins = scatter_in_bins([row[at] for row in ratios], values)
        lines.append(f"  by {title}: {100 * scatter:.1f} %, {bins} bins")
    return lines


def width_long(report: dict[str, Any], picture: str) -> list[str]:
    """mu of slow blocks against the distance slid (nm), and what of their columns is enough."""
    points = with_own_errors(report["report"]["points"])
    of, last = planned("width-long", points), WAYS[-1][1]
    conditions = groups(points, lambda point: run_name(point).split("-")[0])
    figure, panels = pyplot.subplots(
        1, len(conditions), figsize=(10, 4), sharey=True, squeeze=False, layout="constrained"
    )
    rows, enough_from = [], []
    for axes, (name, members) in zip(panels[0], conditions.items()):
        widths = groups(members, lambda point: of[run_name(point)]["columns"])
        means = {columns: mean_of(runs) for columns, runs in widths.items()}
        paper = members[0]["mu_eq2"]
        for number, (columns, runs) in enumerate(widths.items()):
            series = [over_distance(run) for run in runs]
            draw_ways(axes, series, f"C{number}", f"{columns} columns")
            (mu, error), (of_widest, enough) = means[columns], against_wider(means, columns)
            rows.append(
                [
                    f"{name}: {columns} columns",
                    str(len(runs)),
                    *(f"{window(series, low, high, 5)[0]:.3f}" for low, high in WAYS),
                    f"{mu:.3f} +- {error:.3f}",
                    f"{paper:.3f}",
                    of_widest,
                    enough,
                ]
            )
        if len(means) > 1:
            enough_from.append(f"{name} {least_enough(means)}")
        axes.axhline(paper, color="k", ls=":", lw=1, label="Eq. 2")
        axes.axvline(SETTLED, color="k", ls="--", lw=1)
        axes.set(title=name, xlabel="distance slid (nm)", xlim=(0, last), ylim=(0, None))
        axes.grid(alpha=0.3)
        axes.legend()
    panels[0][0].set_ylabel(f"$\\mu$ over {BLOCK} nm")
    save_figure(figure, picture)
    ways = [f"{low}-{high}" for low, high in WAYS]
    head = ["mu over nm", "runs", *ways, f"from {SETTLED}", "Eq. 2", f"of {WIDEST}", "enough"]
    return [*table(head, rows), "", f"columns by the rule: {', '.join(enough_from)}"]


def draw_ways(axes: Any, series: list[Any], colour: str, label: str) -> None:
    """mu of the runs (distances in nm, mu) of one width, means over BLOCK nm."""
    blocks = [(low, low + BLOCK) for low in range(0, WAYS[-1][1], BLOCK)]
    for number, one in enumerate(series):
        axes.plot(
            [0.5 * (low + high) for low, high in blocks],
            [window([one], low, high, 2)[0] for low, high in blocks],
            color=colour,
            ls=("-", "--")[number % 2],
            label=None if number else label,
        )


def light(report: dict[str, Any], picture: str) -> list[str]:
    """mu of the conditions of the plan light over that of the same in the size that their load
    gets, in the plans pressure and paper36; the mean of the ratios."""
    points = with_own_errors(report["report"]["points"])
    of = {name: planned(name, runs) for name, runs in groups(points, plan_name).items()}
    rows, names, ratios, bars = [], [], [], []
    for name, members in groups(points, lambda p: run_name(p).split("-seed")[0]).items():
        plans = groups(members, plan_name)
        if (wide := plans.pop("light", None)) is None:
            continue
        if len(plans) != 1:
            raise Missing(f"{name}: stands in {len(plans)} of the plans pressure and paper36")
        cells, means = [], [mean_of(runs) for runs in (*plans.values(), wide)]
        for runs, (mu, error) in zip((*plans.values(), wide), means):
            planned_as = of[plan_name(runs[0])][run_name(runs[0])]
            cells += [f"{size.junctions(planned_as):.2g}", f"{mu:.3f} +- {error:.3f}"]
        names.append(name)
        ratio, error = quotient(means[1], means[0])
        ratios.append(ratio)
        bars.append(error)
        kappa2, eq2 = f"{wide[0]['kappa2']:.3g}", f"{wide[0]['mu_eq2']:.3f}"
        rows.append([name, kappa2, eq2, *cells, f"{ratio:.2f} +- {error:.2f}"])
    if not rows:
        raise Missing("no run of the plan light")
    mean, error = mean_of([{"mu": y, "mu_se": bar} for y, bar in zip(ratios, bars)])
    dots(
        names,
        ratios,
        [NORMAL * bar for bar in bars],
        picture,
        "$\\mu$(640 columns)/$\\mu$",
        [
            (1, {"color": "k", "ls": "--"}, "the size that the load gets"),
            (mean, {"color": "C1"}, "mean"),
        ],
    )
    head = ["", "kappa2", "Eq. 2", "junctions", "mu", "640 columns", "mu", "over it"]
    return [*table(head, rows), f"mean of the ratios: {mean:.3f} +- {error:.3f}"]
