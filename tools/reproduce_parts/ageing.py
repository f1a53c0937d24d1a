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
WAYS = ((25, 50), (50, 125), (125, 250), (250, 375), (375, 500))  # nm of sliding
LOADS = (0, 0.05, 0.1, 0.15, 0.2, 0.5)  # p/sigma_0, between which runs are taken together
ALMOST = 1.01  # rows of compact logs may end a little before their run
AGED, BLOCK = 250, 25  # nm from which mu ~ s^n is fitted, to means over so many nm


def friction_series(points: Iterable[dict[str, Any]]) -> list[Any]:
    """Times (ns) and mu of the logs of runs."""
    return [np.array(plot_friction.read_log(p["file"])[1:]) for p in points]


def over_distance(point: dict[str, Any]) -> tuple[Any, Any]:
    """Distance slid (nm: 1 m/s is 1 nm/ns) and mu of the log of a run."""
    time, mu = friction_series([point])[0]
    return time * point["velocity"], mu


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
    power law of the depth, fitted to the first two thirds of the time, while the layer grows."""
    end, growing, rows = shortest(members), [], []
    depths, logs = depth_series(members), friction_series(p for p, _ in members)
    for late in (end / 6, end / 3, 2 * end / 3, end):
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
    line = np.linspace(0, 2 * end / 3, 100)
    axes.plot(
        line,
        math.exp(factor) * line**power,
        "k",
        lw=1,
        label=f"in proportion to $t^{{{power:.2f}}}$ to {2 * end / 3:.3g} ns",
    )
    return [
        *rows,
        [
            f"exponent of depth ~ t^n to {2 * end / 3:.3g} ns",
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


def blocks_of(way: Any, mu: Any) -> tuple[Any, Any]:
    """Distances slid (nm) and means of mu over BLOCK nm from AGED on, arrays of the blocks."""
    edges = np.arange(AGED, way[-1] + 0.5 * BLOCK, BLOCK) * (1 + 1e-9)  # the last one may be half
    if len(edges) < 5:
        raise Missing(f"a run ends at {way[-1]:.3g} nm of sliding, {AGED + 4 * BLOCK} are needed")
    return 0.5 * (edges[:-1] + edges[1:]), np.array(
        [mu[(way > low) & (way <= high)].mean() for low, high in itertools.pairwise(edges)]
    )


def power_of_distance(runs: Any) -> tuple[float, float, float]:
    """n = d(mu)/d(ln s) over the mean of mu, of runs (distances in nm, mu) at one condition, its
    standard error, and how many of those 95 % reach: a straight line through their blocks, so that
    a block may be below 0."""
    blocks = [blocks_of(*run) for run in runs]
    way, mu = (np.concatenate(of) for of in zip(*blocks))
    if mu.mean() <= 0:
        raise Missing(f"the mean from {AGED} nm on is not above 0: no power of the distance")
    (n, _), covariance = np.polyfit(np.log(way), mu / mu.mean(), 1, cov=True)
    return n, math.sqrt(covariance[0, 0]), student95(len(way) - 2)


def weighted(values: Any, errors: Any) -> tuple[float, float, float]:
    """Mean with the weights 1/s.e.^2, its standard error, widened by a reduced chi^2 above 1, and
    that reduced chi^2."""
    weight = errors**-2.0
    mean = np.average(values, weights=weight)
    reduced = np.sum(weight * (values - mean) ** 2) / max(1, len(values) - 1)
    return mean, math.sqrt(max(1, reduced) / weight.sum()), reduced


def by_load(points: list[dict[str, Any]], axes: Any) -> list[list[str]]:
    """Rows of n of mu ~ s^n, the weighted mean over the runs between loads p/sigma_0 and over all;
    draws the runs."""
    load, n, error, t95 = np.array(
        [
            (point["pressure"] / point["strength"], *power_of_distance([over_distance(point)]))
            for point in points
        ]
    ).T
    axes.errorbar(load, n, yerr=t95 * error, fmt="o", ms=3, lw=0.8, color="0.6", label="runs, 95 %")

    def row(low: float, high: float, inside: Any) -> tuple[list[str], float, float]:
        mean, its, reduced = weighted(n[inside], error[inside])
        cells = [f"{low:g} to {high:g}", str(inside.sum()), f"{mean:+.2f} +- {its:.2f}"]
        return [*cells, f"{reduced:.1f}"], mean, its

    rows: list[list[str]] = []
    for low, high in itertools.pairwise(LOADS):
        inside = (low < load) & (load <= high)
        if not inside.any():
            continue
        cells, mean, its = row(low, high, inside)
        axes.errorbar(
            load[inside].mean(),
            mean,
            yerr=(student95(inside.sum() - 1) if inside.sum() > 1 else t95[inside][0]) * its,
            fmt="C1s",
            capsize=3,
            label=None if rows else "their mean",
        )
        rows.append(cells)
    rows.append(row(LOADS[0], LOADS[-1], load > 0)[0])
    axes.axhline(0, color="k", ls="--", lw=1)
    axes.set(
        xlim=(0, None),
        xlabel="$p/\\sigma_0$",
        ylabel=f"n of $\\mu \\sim s^n$ from {AGED} nm on",
        ylim=(-1.5, 1.5),
    )
    return rows


def ageing(report: dict[str, Any], picture: str) -> list[str]:
    """mu over distances slid (nm) at each velocity (m/s), which are drawn, and at each pressure
    (MPa); n of mu ~ s^n against the load of all runs."""
    figure, (axes, right) = pyplot.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True)
    points, rows = report["report"]["points"], []
    cases = groups(points, lambda p: (run_name(p)[0], p["velocity"], p["pressure"]))
    velocities = [case for case in cases if case[0] == "v"]
    for (plan, velocity, pressure), members in cases.items():
        runs, found = [over_distance(p) for p in members], []
        for low, high in WAYS:
            if min(way[-1] for way, _ in runs) * ALMOST < high:
                raise Missing(f"a run at {velocity:g} m/s, {pressure:g} MPa ends before {high} nm")
            found.append(layer.window(runs, low, high, 5))
        n, error, _ = power_of_distance(runs)
        rows.append(
            [
                f"{velocity:g} m/s, {pressure:g} MPa",
                *(f"{mu:.2f}({100 * its:.0f})" for mu, its in found),
                f"{n:+.2f} +- {error:.2f}",
            ]
        )
        if plan != "v":
            continue
        k, middle = velocities.index((plan, velocity, pressure)), np.mean(WAYS, axis=1)
        mu, errors = np.array(found).T
        axes.errorbar(
            middle * 1.012 ** (k - 4),
            mu,
            yerr=student95(5 * len(members) - 1) * errors,  # of blocks
            fmt=f"C{k}o-",
            ms=4,
            lw=1,
            capsize=2,
            label=f"{velocity:g} m/s",
        )
    axes.axvline(AGED, color="k", ls="--", lw=1)
    axes.set(
        xscale="log", xlabel="distance slid (nm)", ylabel="$\\mu$ with its 95 % interval, 15 MPa"
    )
    axes.set_xticks([30, 50, 100, 200, 500], ["30", "50", "100", "200", "500"])
    axes.minorticks_off()
    axes.set_ylim(0, None)
    loads = by_load(points, right)
    for of_both, columns in ((axes, 2), (right, 1)):
        of_both.grid(alpha=0.3)
        of_both.legend(fontsize=9, ncols=columns, loc="lower right")
    save_figure(figure, picture)
    return [
        *table(["mu", *(f"{low}-{high} nm" for low, high in WAYS), "n"], rows),
        "",
        *table(["p/sigma_0", "runs", "mean n", "reduced chi^2"], loads),
    ]
