# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction of the rail steel up to its hardness: mu over p/sigma_0(T), the bound by the shear
strength, the forms of the law beside each other."""

import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from campaign_parts import plan
from mcawr.files import save_figure
from mcawr.replicas import NORMAL, groups, half_width, mean_of

from . import locomotive_runs as made, temperature as heat
from .common import Missing, percent, quotient, run_name, table, with_own_errors
from .dots import dots

SHEAR = 1 / math.sqrt(3)  # shear strength over sigma_0, von Mises
SPEED = 5.0  # m/s, of the runs that the law is fitted to


def law_at(law: dict[str, Any], ratio: Any, kappa1: Any, kappa3: float) -> Any:
    """mu [-] of a law of the form that wr_fit --material writes (doc/wr_fit.md), at p/sigma_0 > 0,
    kappa1 and kappa3 [-]; ratio or kappa1 may be an array."""
    free = law["mu0"] + law["mu1"] * kappa1 / (1 + law["b"] * kappa1)
    free = free + law["mu2"] / (1 + law["c"] * kappa3 * ratio)
    free = free * (kappa3 / law["kappa3"]) ** law["kappa3_exponent"]
    limit = law["s"] + law["s1"] * kappa1 / (1 + law["d"] * kappa1)
    q = law["q"]
    return (free**-q + (limit / ratio) ** -q) ** (-1 / q)


def by_temperature(report: dict[str, Any]) -> list[tuple[Any, float, list[dict[str, Any]]]]:
    """The points that are not left out: (colour, K, points) of each temperature."""
    runs = [run.values for run in plan.read(plan.find("rail")).runs]
    points = [p for p in report["report"]["points"] if not p["left_out"]]
    found = groups(points, lambda point: heat.temperature_of(point, runs))
    colors = pyplot.get_cmap("turbo")(np.linspace(0.05, 0.92, len(found)))
    return [(color, kelvin, members) for color, (kelvin, members) in zip(colors, found.items())]


def shifts(count: int) -> Any:
    """Factors that set the points of so many temperatures at one load beside each other."""
    return np.geomspace(0.92, 1 / 0.92, count)


def at_speed(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Those at SPEED."""
    return [p for p in points if math.isclose(p["velocity"], SPEED)]


def seeds_apart(points: list[dict[str, Any]], ratios: list[float]) -> list[str]:
    """By how much the two runs of a condition differ, over their mean: RMS at each p/sigma_0, as
    text."""
    squares = groups(
        (
            (rounded(same[0]), (same[0]["mu"] - same[1]["mu"]) ** 2 / mean_of(same)[0] ** 2)
            for same in groups(
                points, lambda p: (p["kappa3"], p["strength"], p["velocity"], rounded(p))
            ).values()
            if len(same) == 2
        ),
        lambda found: found[0],
    )
    return [
        f"{100 * math.sqrt(np.mean([square for _, square in squares[ratio]])):.1f} %"
        if ratio in squares
        else ""
        for ratio in ratios
    ]


def slower_than_speed(points: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The others."""
    return [p for p in points if p not in at_speed(points)]


def rail(report: dict[str, Any], picture: str) -> list[str]:
    """mu at each temperature, p/sigma_0 and speed, means over the seeds; the law at each
    temperature."""
    found = by_temperature(report)
    ratios = sorted({rounded(p) for _, _, members in found for p in at_speed(members)})
    slower = sorted({rounded(p) for _, _, members in found for p in slower_than_speed(members)})
    markers = dict(zip(slower, "os^D"))
    size = {"figsize": (13 if slower else 11, 4.4), "constrained_layout": True}
    figure, (left, right, *slow) = pyplot.subplots(1, 3 if slower else 2, **size)
    rows, speeds = [], []
    x = np.geomspace(0.8 * min(ratios), 1.15 * max(ratios), 200)
    has_law = "fit" in report["report"]
    for (color, kelvin, members), aside in zip(found, shifts(len(found))):
        fast = at_speed(members)
        same_load = groups(fast, rounded)
        means = {ratio: mean_of(same) for ratio, same in same_load.items()}
        at, mu, half = np.array(
            [(ratio, means[ratio][0], half_width(same)) for ratio, same in same_load.items()]
        ).T
        style = {"fmt": "o", "ms": 5, "capsize": 2, "color": color}
        left.errorbar(at * aside, mu, half, label=f"{kelvin:g} K", **style)
        right.errorbar(at * aside, mu * at, half * at, **style)
        cells = [
            f"{means[x][0]:.3f}({1000 * means[x][1]:.0f})" if x in means else "" for x in ratios
        ]
        rows.append([f"{kelvin:g} K", *cells])
        if has_law:
            curve = law_at(report, x, fast[0]["kappa1"], fast[0]["kappa3"])
            left.plot(x, curve, color=color, lw=1)
            right.plot(x, curve * x, color=color, lw=1)
        for axes in slow:
            law = report if has_law else None
            speeds += draw_speeds(axes, law, markers, color, kelvin, members)
    for axes, factor in ((left, 1 / x), (right, np.ones_like(x))):
        axes.plot(x, SHEAR * factor, "k--", lw=1, label=r"shear strength, $\sigma_0/\sqrt{3}$")
        axes.set(xlabel=r"$p/\sigma_0(T)$", xscale="log")
        axes.grid(alpha=0.3)
    left.set(ylabel=r"$\mu$", ylim=(0, 0.9))
    right.set(ylabel=r"friction stress over $\sigma_0(T)$", ylim=(0, 0.65))
    left.legend(fontsize=8, ncols=2, loc="lower left", title=f"lines: law, {SPEED:g} m/s")
    for axes in slow:
        axes.set(xlabel="speed, m/s", ylabel=r"$\mu$", xscale="log", ylim=(0, 0.75))
        axes.set_xticks([0.5, 1, 2, 5], ["0.5", "1", "2", "5"])
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, ncols=2, loc="upper left")
    save_figure(figure, picture)
    pyplot.close(figure)
    every = [point for _, _, members in found for point in members]
    rows.append(["two seeds differ by (RMS)", *seeds_apart(at_speed(every), ratios)])
    if slower:
        rows.append(["the same of slower runs", *seeds_apart(slower_than_speed(every), ratios)])
    return [
        "in brackets: standard error in units of 0.001, with what seeds differ by",
        *table([f"mu at {SPEED:g} m/s, p/sigma_0", *(f"{x:g}" for x in ratios)], rows),
        "",
        *(table(["", "p/sigma_0", "m/s", "kappa1", "runs", "mu", "law"], speeds) if slower else []),
        *([""] if slower else []),
        *law_lines(report),
    ]


def draw_speeds(
    axes: Any,
    law: dict[str, Any] | None,
    markers: dict[float, str],
    color: Any,
    kelvin: float,
    points: list[dict[str, Any]],
) -> list[list[str]]:
    """mu against speed at the loads of a temperature that have several, with the law; rows of a
    table. markers: of each p/sigma_0."""
    rows = []
    for ratio in sorted({rounded(p) for p in slower_than_speed(points)}):
        same = groups([p for p in points if rounded(p) == ratio], lambda p: p["velocity"])
        found = [(v, *mean_of(members), members) for v, members in sorted(same.items())]
        v, mu, half = np.array([(v, mu, half_width(same)) for v, mu, _, same in found]).T
        label = rf"{kelvin:g} K, {ratio:g} $\sigma_0$"
        axes.errorbar(v, mu, half, fmt=markers[ratio], ms=5, capsize=2, color=color, label=label)
        any_point = found[0][3][0]
        unit = any_point["kappa1"] / any_point["velocity"] ** 2
        if law:
            x = np.geomspace(0.8 * min(v), 1.15 * max(v), 100)
            axes.plot(x, law_at(law, ratio, unit * x**2, any_point["kappa3"]), color=color, lw=1)
        for speed, mean, se, members in found:
            ours = law_at(law, ratio, unit * speed**2, any_point["kappa3"]) if law else math.nan
            rows.append(
                [f"{kelvin:g} K", f"{ratio:g}", f"{speed:g}", f"{unit * speed**2:.2g}",
                 str(len(members)), f"{mean:.3f} +- {se:.3f}", f"{ours:.3f}"]
            )  # fmt: skip
    return rows


def rounded(point: dict[str, Any]) -> float:
    """p/sigma_0 as the plan has it, to two digits."""
    return float(f"{point['pressure'] / point['strength']:.2g}")


def law_lines(report: dict[str, Any]) -> list[str]:
    """The parameters, and the forms of the law by AICc."""
    if "fit" not in report["report"]:
        return ["too few conditions for a law"]
    seeds = len({p["seed"] for p in report["report"]["points"]})
    lines = f"law {made.MODELS[0]}; {made.told(report)}, {seeds} seed(s)".split("; ")
    rows = [
        [m["model"], f"{100 * m['rms_relative']:.1f} %", f"{m['delta_aicc']:.1f}"]
        for m in report["report"]["models"]
        if "aicc" in m
    ]
    lines += ["", *table(["form", "RMS", "AICc above the best"], rows)]
    others = [m["model"] for m in report["report"]["models"] if "why_not" in m]
    return lines + ([f"not determined: {', '.join(others)}"] if others else [])


def checks(report: dict[str, Any], picture: str) -> list[str]:
    """Other widths, heights and steps beside the runs of the law at their place."""
    # widths differ in what their seeds differ by, so that one share for all of them tells nothing
    points = with_own_errors([p for p in at_speed(report["report"]["points"]) if not p["left_out"]])
    runs = [run.values for run in plan.read(plan.find("rail")).runs]
    of_law = [p for p in points if base_name(p).startswith("t")]
    rows, labels, values, bars = [], [], [], []
    for name, members in groups(points, base_name).items():
        place = (members[0]["strength"], members[0]["pressure"])
        others = [p for p in of_law if (p["strength"], p["pressure"]) == place]
        if name.startswith("t") or not others:
            continue
        (mu, error), (base, base_error) = mean_of(members), mean_of(others)
        ratio, ratio_error = quotient((mu, error), (base, base_error))
        kelvin = heat.temperature_of(members[0], runs)
        labels.append(f"{name}, {kelvin:g} K")
        values.append(ratio)
        bars.append(NORMAL * ratio_error)
        rows.append(
            [name, f"{kelvin:g}", f"{rounded(members[0]):g}", str(len(members)),
             f"{mu:.3f} +- {error:.3f}", f"{base:.3f} +- {base_error:.3f}", percent(mu, base)]
        )  # fmt: skip
    if not rows:
        raise Missing("no run of another width, height or step")
    line = (1.0, {"color": "k", "ls": "--"}, "runs of the law")
    dots(labels, values, bars, picture, r"$\mu$ over that of the law's runs", [line])
    head = ["", "K", "p/sigma_0", "runs", "mu", "of the law's runs", "over them"]
    return [
        "errors: what a run knows of itself; of two seeds, what they differ by",
        *table(head, rows),
    ]


def base_name(point: dict[str, Any]) -> str:
    """Name of a run, without its seed and pressure: columns80, rows24, step2e-5, v2-t673, t673."""
    return run_name(point).split("-seed")[0]
