# SPDX-License-Identifier: GPL-2.0-or-later
"""The layer and its age: figures from the profiles beside the logs, and from the whole of the
logs."""

import itertools
import math
import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib import pyplot

import plot_friction
from mcawr.files import save_figure
from mcawr.replicas import NORMAL, groups, student95

from . import layer
from .common import Missing, power_law, run_name, table

PAPER_DEPTH = 10.0  # nm, of the quasi-liquid layer
ROUGHNESS = 3.25  # nm, of the blocks of most plans
TIMES = ((10, 25), (25, 50), (50, 100), (100, 200), (200, 500))  # ns
LOADS = (0, 0.05, 0.1, 0.15, 0.2, 0.5)  # p/sigma_0, between which runs are taken together
NOISY = 0.2  # standard error of mu over mu
ALMOST = 1.01  # rows of compact logs may end a little before their run
AGED, BLOCK, FAST = 50, 10, 4  # ns from which mu ~ t^n is fitted, to means over so many ns; m/s


def friction_series(points: Iterable[dict[str, Any]]) -> list[Any]:
    """Times (ns) and mu of the logs of runs."""
    return [np.array(plot_friction.read_log(p["file"])[1:]) for p in points]


def depth_series(members: Any) -> list[Any]:
    """Times (ns) and depth (nm) of the layers of runs (point, layer)."""
    return [(found.time, found.depth) for _, found in members]


def shortest(members: Any) -> float:
    """Time (ns) that all runs (point, layer) have reached; inf of none."""
    return min((f.time[-1] for _, f in members), default=math.inf)


def second_half(members: Any, end: float) -> Any:
    """Cells of depth (nm) and mu of runs (point, layer) from half of the time `end` (ns) up to it;
    and the depth, its error, what of it 95 % reach by the number of runs, mu, its error."""
    depth, error = layer.mean_depth([f for _, f in members], end)
    mu, mu_error = layer.window(friction_series(p for p, _ in members), end / 2, end, 8)
    return (
        [f"{depth:.1f} +- {error:.1f}", f"mu {mu:.3f} +- {mu_error:.3f}"],
        depth,
        error,
        error * (student95(len(members) - 1) if len(members) > 1 else NORMAL),
        mu,
        mu_error,
    )


def growth(members: Any, axes: Any) -> Any:
    """Rows of depth (nm) and mu of the runs (point, layer) in times (ns) that double; draws the
    power law of the depth, fitted to the first third of the time, while the layer grows."""
    end, growing, rows = shortest(members), [], []
    depths, logs = depth_series(members), friction_series(p for p, _ in members)
    for late in (end / 12, end / 6, end / 3, 2 * end / 3, end):
        early = late / 2 if late < end else 2 * end / 3
        (depth, error), (mu, mu_error) = (
            layer.window(depths, early, late, 2),
            layer.window(logs, early, late, 8),
        )
        growing.append((math.sqrt(early * late), depth, mu))
        rows.append(
            [
                f"{early:.3g} to {late:.3g} ns",
                "",
                f"{depth:.1f} +- {error:.1f}",
                f"mu {mu:.3f} +- {mu_error:.3f}",
            ]
        )
    time, depth, mu = np.log(growing[:3]).T
    power, factor = np.polyfit(time, depth, 1)
    line = np.linspace(0, end / 3, 100)
    axes.plot(
        line,
        math.exp(factor) * line**power,
        "k",
        lw=1,
        label=f"in proportion to $t^{{{power:.2f}}}$ to {end / 3:.3g} ns",
    )
    return [
        *rows,
        [
            f"exponent of depth ~ t^n to {end / 3:.3g} ns",
            "",
            f"{power:.2f}",
            f"of mu {np.polyfit(time, mu, 1)[0]:.2f}",
        ],
    ]


def with_layers(points: list[dict[str, Any]]) -> Any:
    """The runs (point, layer) of the points."""
    members = [(point, layer.read(point["file"])) for point in points]
    for point, found in members:
        if found is None:
            raise Missing(
                f"{point['file']}: no profile beside it (a plan with `profile` makes one)"
            )
    return members


def roughness_of(point: dict[str, Any]) -> float | None:
    """Largest deviation (nm) of a run of `roughness`: 1.4 of roughness1.4-seed1; None of others."""
    found = re.match("roughness([0-9.]+)", run_name(point))
    return float(found[1]) if found else None


def of_one_material(point: dict[str, Any], rough: Any) -> bool:
    """Whether a run differs from those of `roughness` (point, layer) in its viscosity at most."""
    keys = ("velocity", "pressure", "strength", "kappa1", "kappa2")
    return bool(rough) and all(math.isclose(point[k], rough[0][0][k], rel_tol=1e-6) for k in keys)


def fig3(report: dict[str, Any], picture: str) -> list[str]:
    """Depth of the layer, from the profiles beside the logs, and mu: against initial roughness, in
    times that double, against viscosity."""
    layers = with_layers(report["report"]["points"])
    rough = [(p, f) for p, f in layers if roughness_of(p) is not None]
    viscous = groups(
        [(p, f) for p, f in layers if roughness_of(p) is None and of_one_material(p, rough)],
        lambda x: x[0]["viscosity"],
    )
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    rows = []
    for k, (amplitude, members) in enumerate(groups(rough, lambda x: roughness_of(x[0])).items()):
        for number, (_, found) in enumerate(members):
            left.plot(
                found.time,
                found.depth,
                color=f"C{k}",
                lw=1,
                label=None if number else f"initial roughness {amplitude:g} nm",
            )
        cells, *_ = second_half(members, shortest(rough))
        rows.append([f"roughness {amplitude:g} nm", f"{PAPER_DEPTH:g}", *cells])
    usual = [(p, f) for p, f in rough if roughness_of(p) == ROUGHNESS]
    if not usual:
        raise Missing(f"no run of roughness {ROUGHNESS} nm")
    rows += growth(usual, left)
    left.axhline(PAPER_DEPTH, color="k", ls="--", lw=1, label="about 10 nm (paper)")
    left.set(
        xlabel="time (ns)",
        ylabel="depth of the layer (nm), 10 to 90 % of $v$",
        xlim=(0, None),
        ylim=(0, None),
    )
    left.legend(fontsize=9)
    found = []
    for value, members in viscous.items():
        cells, *values = second_half(members, shortest([m for of in viscous.values() for m in of]))
        found.append((value, *values))
        rows.append([f"viscosity {value:g} Pa s", f"{PAPER_DEPTH * value / 0.41:.1f}", *cells])
    eta, depth, error, reach, mu, mu_error = np.array(found).reshape(-1, 6).T
    right.errorbar(eta, depth, yerr=reach, fmt="o", capsize=2, label="our runs, 95 %")
    if len(eta) > 2:
        line = np.array([min(eta), max(eta)])
        right.plot(
            line, PAPER_DEPTH * line / 0.41, "k--", lw=1, label="in proportion (paper: roughly)"
        )
        depth_power, mu_power = (
            "{1:+.2f} +- {3:.2f}".format(*power_law(eta, y, e / y))
            for y, e in ((depth, error), (mu, mu_error))
        )
        rows.append(
            ["exponent of depth ~ eta^n", "about 1", depth_power, f"of mu (paper: 0) {mu_power}"]
        )
    right.set(
        xlabel="viscosity $\\eta$ (Pa s)",
        ylabel="depth of the layer (nm)",
        xscale="log",
        yscale="log",
    )
    right.set_xticks(eta, [f"{value:.2g}" for value in eta])
    right.set_yticks([2, 5, 10, 20, 50], ["2", "5", "10", "20", "50"])
    right.minorticks_off()
    right.legend(fontsize=9)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    save_figure(figure, picture)
    return table(["", "paper, nm", "ours, nm", ""], rows)


def blocks_of(series: Any) -> Any:
    """Times (ns) and means over BLOCK ns from AGED on, a pair for each block.

    series: a pair of arrays for each run, times (ns) and y of any unit."""
    points = []
    for time, y in series:
        edges = np.arange(AGED, time[-1] * ALMOST, BLOCK) * (1 + 1e-9)
        points += [
            (0.5 * (low + high), y[(time > low) & (time <= high)].mean())
            for low, high in itertools.pairwise(edges)
        ]
    return points


def power_of_time(series: Any) -> tuple[float, float, float]:
    """n of y ~ t^n, its standard error, and y at 1 ns: a straight line through the logarithms of
    the blocks of a series."""
    points = blocks_of(series)
    if not all(y > 0 for _, y in points):
        raise Missing(f"a mean over {BLOCK} ns is not above 0: no power of time")
    times, values = np.log(points).T
    (n, factor), covariance = np.polyfit(times, values, 1, cov=True)
    return n, math.sqrt(covariance[0, 0]), math.exp(factor)


def by_load(points: list[dict[str, Any]], axes: Any) -> list[list[str]]:
    """Rows of n of mu ~ t^n, the mean over the runs between loads p/sigma_0 (weights 1/s.e.^2, its
    standard error widened by a reduced chi^2 above 1), and of how many of them wr_fit finds no
    stationary part, but for those whose mu is not known to NOISY or is not above 0 in a block;
    draws the runs whose n is known to 0.1."""
    found = []
    for point in points:
        series = friction_series([point])
        end = series[0][0][-1]
        if end * ALMOST < 2 * AGED:
            raise Missing(f"{run_name(point)} ends at {end:g} ns, {2 * AGED} are needed")
        if point["mu_se"] > NOISY * point["mu"] or min(y for _, y in blocks_of(series)) <= 0:
            continue
        found.append(
            (
                point["pressure"] / point["strength"],
                *power_of_time(series)[:2],
                point["t_start"] is None,
                student95(max(1, len(blocks_of(series)) - 2)),
            )
        )
    load, n, error, drifting, t95 = np.array(found).T
    known = error < 0.1
    axes.errorbar(
        load[known],
        n[known],
        yerr=(t95 * error)[known],
        fmt="o",
        ms=3,
        lw=0.8,
        color="0.6",
        label="runs known to 0.1, 95 %",
    )
    rows: list[list[str]] = []
    for low, high in itertools.pairwise(LOADS):
        inside = (low < load) & (load <= high)
        if not inside.any():
            continue
        weight = error[inside] ** -2
        mean = np.average(n[inside], weights=weight)
        reduced = np.sum(weight * (n[inside] - mean) ** 2) / max(1, inside.sum() - 1)
        its = math.sqrt(max(1, reduced) / weight.sum())
        axes.errorbar(
            load[inside].mean(),
            mean,
            yerr=(student95(inside.sum() - 1) if inside.sum() > 1 else t95[inside][0]) * its,
            fmt="C1s",
            capsize=3,
            label=None if rows else "their mean",
        )
        rows.append(
            [
                f"{low:g} to {high:g}",
                str(inside.sum()),
                f"{mean:+.3f} +- {its:.3f}",
                f"{reduced:.1f}",
                f"{drifting[inside].sum():.0f}",
            ]
        )
    axes.axhline(0, color="k", ls="--", lw=1)
    axes.set(
        xlim=(0, None),
        xlabel="$p/\\sigma_0$",
        ylabel=f"n of $\\mu \\sim t^n$ from {AGED} ns on",
        ylim=(-0.3, 0.3),
    )
    return rows


def ageing(report: dict[str, Any], picture: str) -> list[str]:
    """mu in times (ns) that double, and n of mu ~ t^n: at each velocity (m/s), which are drawn, and
    at each pressure (MPa); n against the load of all runs."""
    figure, (axes, right) = pyplot.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True)
    points, rows, powers, fast = report["report"]["points"], [], [], []
    of_steel = [p for p in points if run_name(p)[0] in "vp"]  # of `velocity` and `pressure`
    cases = groups(of_steel, lambda p: (run_name(p).startswith("p"), p["velocity"], p["pressure"]))
    for k, ((of_pressures, velocity, pressure), members) in enumerate(cases.items()):
        case, series = f"{velocity:g} m/s, {pressure:g} MPa", friction_series(members)
        end = min(time[-1] for time, _ in series)
        if end * ALMOST < 2 * AGED:
            raise Missing(f"runs at {case} end at {end:g} ns, {2 * AGED} are needed")
        found = [
            (low, high, *layer.window(series, low, high, 8)) for low, high in TIMES if high <= end
        ]
        n, error, factor = power_of_time(series)
        cells = [f"{mu:.3f} +- {mu_error:.3f}" for _, _, mu, mu_error in found] + [""] * (
            len(TIMES) - len(found)
        )
        rows.append([case, *cells])
        powers.append([case, f"{n:+.3f} +- {error:.3f}"])
        if of_pressures:
            continue
        if velocity >= FAST:
            fast.append((n, error))
        low, high, mu, mu_error = np.array(found).T
        line = np.geomspace(AGED, end, 20)
        axes.errorbar(
            np.sqrt(low * high) * 1.012 ** (k - 4),
            mu,
            yerr=student95(8 * len(members) - 1) * mu_error,  # of blocks
            fmt=f"C{k}o",
            ms=4,
            capsize=2,
            label=f"{velocity:g} m/s",
        )
        axes.plot(line, factor * line**n, f"C{k}", lw=1)
    axes.set(xscale="log", yscale="log", xlabel="time (ns)", ylabel="$\\mu$ with its 95 % interval")
    axes.set_xticks([20, 50, 100, 200, 500], ["20", "50", "100", "200", "500"])
    axes.set_yticks([0.3, 0.4, 0.5, 0.6, 0.7], ["0.3", "0.4", "0.5", "0.6", "0.7"])
    axes.minorticks_off()
    if not fast:
        raise Missing(f"no run of the plan velocity at {FAST} m/s or above")
    loads = by_load(points, right)
    for of_both, columns in ((axes, 2), (right, 1)):
        of_both.grid(alpha=0.3)
        of_both.legend(fontsize=9, ncols=columns)
    save_figure(figure, picture)
    lines = [
        *table(["mu", *(f"{low} to {high} ns" for low, high in TIMES)], rows),
        "",
        *table([f"mu ~ t^n from {AGED} ns on", "n"], powers),
    ]
    n, error = np.array(fast).T
    mean, mean_error = np.average(n, weights=error**-2), math.sqrt(1 / np.sum(error**-2))
    return [
        *lines,
        "",
        *table(
            ["all materials: p/sigma_0", "runs", "mean n", "reduced chi^2", "drifting (wr_fit)"],
            loads,
        ),
        "",
        f"{FAST:g} m/s and above, 15 MPa: n = {mean:+.3f} +- {mean_error:.3f}, mu changes by "
        f"{100 * (2**mean - 1):+.1f} +- {100 * math.log(2) * mean_error:.1f} % when the time "
        "doubles",
    ]
