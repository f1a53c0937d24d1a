# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction of the rail steel up to its hardness: mu over p/sigma_0(T), the bound by the shear
strength, the forms of the law beside each other."""

import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from campaign_parts import plan
from mcawr.files import save_figure
from mcawr.replicas import NORMAL, groups, mean_of

from . import locomotive_runs as made, temperature as heat
from .common import Missing, percent, run_name, table
from .dots import dots

SHEAR = 1 / math.sqrt(3)  # shear strength over sigma_0, von Mises
SPEED = 5.0  # m/s, of the runs that the law is fitted to


def law_at(law: dict[str, Any], ratio: Any) -> Any:
    """mu [-] of a law at p/sigma_0 [-], one value or an array > 0 (wr_fit's forms bounded,
    bounded_kappa3 and bounded_eq4): B bounded by s sigma_0/p, B = mu0 + mu2/(1 + c kappa2). At the
    geometric mean of the points' E/sigma_0, where the power of kappa3 is 1 but for seeds; E/sigma_0
    is 189 to 234 at the temperatures of the plan."""
    kappa3 = math.exp(np.mean([math.log(p["kappa3"]) for p in law["report"]["points"]]))
    free = law["mu0"] + law["mu2"] / (1 + law["c"] * kappa3 * ratio)
    q = law["q"]
    return (free**-q + (law["s"] / ratio) ** -q) ** (-1 / q)


def rail(report: dict[str, Any], picture: str) -> list[str]:
    """mu at each temperature and p/sigma_0, means over the seeds."""
    runs = [run.values for run in plan.read(plan.find("rail")).runs]
    points = [p for p in report["report"]["points"] if not p["left_out"]]
    fitted = [p for p in points if math.isclose(p["velocity"], SPEED)]
    by_heat = groups(fitted, lambda point: heat.temperature_of(point, runs))
    ratios = sorted({rounded(p) for p in fitted})
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    rows = []
    colors = pyplot.get_cmap("inferno")(np.linspace(0.05, 0.85, len(by_heat)))
    for color, (kelvin, members) in zip(colors, by_heat.items()):
        means = {x: mean_of(found) for x, found in groups(members, rounded).items()}
        x, mu, error = np.array([(x, *mean) for x, mean in means.items()]).T
        style = {"fmt": "o", "ms": 5, "capsize": 2, "color": color}
        left.errorbar(x, mu, 1.96 * error, label=f"{kelvin:g} K", **style)
        right.errorbar(x, mu * x, 1.96 * error * x, **style)
        cells = [
            f"{means[x][0]:.3f}({1000 * means[x][1]:.0f})" if x in means else "" for x in ratios
        ]
        rows.append([f"{kelvin:g} K", *cells])
    x = np.geomspace(0.8 * min(ratios), 1.15 * max(ratios), 200)
    has_law = "fit" in report["report"]
    for axes, factor in ((left, 1 / x), (right, np.ones_like(x))):
        if has_law:
            axes.plot(x, law_at(report, x) * x * factor, "C0", lw=2, label="law")
        axes.plot(x, SHEAR * factor, "k--", lw=1, label=r"shear strength, $\sigma_0/\sqrt{3}$")
        axes.set(xlabel=r"$p/\sigma_0(T)$", xscale="log")
        axes.grid(alpha=0.3)
    left.set(ylabel=r"$\mu$", ylim=(0, 0.62))
    right.set(ylabel=r"friction stress over $\sigma_0(T)$", ylim=(0, 0.65))
    left.legend(fontsize=8, ncols=2, loc="lower left")
    save_figure(figure, picture)
    pyplot.close(figure)
    return [
        "in brackets: standard error in units of 0.001, with what seeds differ by",
        *table(["mu at p/sigma_0", *(f"{x:g}" for x in ratios)], rows),
        "",
        *law_lines(report),
    ]


def rounded(point: dict[str, Any]) -> float:
    """p/sigma_0 as the plan has it, to two digits."""
    return float(f"{point['pressure'] / point['strength']:.2g}")


def law_lines(report: dict[str, Any]) -> list[str]:
    """The parameters, and the forms of the law by AICc."""
    if "fit" not in report["report"]:
        return ["too few conditions for a law"]
    seeds = len({p["seed"] for p in report["report"]["points"]})
    lines = f"{made.MODELS[0]}: {made.told(report)}, {seeds} seed(s)".split("; ")
    rows = [
        [m["model"], f"{100 * m['rms_relative']:.1f} %", f"{m['delta_aicc']:.1f}"]
        for m in report["report"]["models"]
        if "aicc" in m
    ]
    lines += ["", *table(["form", "RMS", "AICc above the best"], rows)]
    others = [m["model"] for m in report["report"]["models"] if "why_not" in m]
    return lines + ([f"not determined: {', '.join(others)}"] if others else [])


def checks(report: dict[str, Any], picture: str) -> list[str]:
    """Other speeds, widths, heights and steps beside the runs of the law at their place."""
    # widths differ in what their seeds differ by, so that one share for all of them tells nothing
    points = [
        {**p, "mu_se": p["mu_se_own"]} for p in report["report"]["points"] if not p["left_out"]
    ]
    runs = [run.values for run in plan.read(plan.find("rail")).runs]
    of_law = [p for p in points if base_name(p).startswith("t")]
    rows, labels, values, bars = [], [], [], []
    for name, members in groups(points, base_name).items():
        place = (members[0]["strength"], members[0]["pressure"])
        others = [p for p in of_law if (p["strength"], p["pressure"]) == place]
        if name.startswith("t") or not others:
            continue
        (mu, error), (base, base_error) = mean_of(members), mean_of(others)
        kelvin = heat.temperature_of(members[0], runs)
        labels.append(f"{name}, {kelvin:g} K")
        values.append(mu / base)
        bars.append(NORMAL * error / base)
        rows.append(
            [name, f"{kelvin:g}", f"{rounded(members[0]):g}", str(len(members)),
             f"{mu:.3f} +- {error:.3f}", f"{base:.3f} +- {base_error:.3f}", percent(mu, base)]
        )  # fmt: skip
    if not rows:
        raise Missing("no run of another speed, width, height or step")
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
