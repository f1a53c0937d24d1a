# SPDX-License-Identifier: GPL-2.0-or-later
"""Conditions of many materials: preset d beside preset c and the paper's law."""

import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import NORMAL, groups, mean_of

from .common import STEEL, Missing, percent, plan_name, power_law, run_name, table, with_own_errors

OLD, NEW = "paper36", "paper36-d"  # plans of the same conditions
PRESETS = {OLD: "preset c", NEW: "preset d"}
FAST = 4.0  # m/s


def over_eq2(members: list[dict[str, Any]]) -> tuple[float, float]:
    """(mu over Eq. 2, its standard error), means over the seeds."""
    mu, error = mean_of(members)
    return mu / members[0]["mu_eq2"], error / members[0]["mu_eq2"]


def summary(first: list[dict[str, Any]], ratios: list[tuple[float, float]]) -> list[str]:
    """RMS from Eq. 2 and mean, the RMS of the fast ones, the exponent in E/sigma_0."""
    over, errors = (np.array(column) for column in zip(*ratios))
    fast = np.array([p["velocity"] >= FAST for p in first])
    cells = [
        f"{100 * math.sqrt(np.mean((over - 1) ** 2)):.1f} %",
        f"{100 * math.sqrt(np.mean(errors**2)):.1f} %",
        percent(float(np.mean(over)), 1),
        f"{100 * math.sqrt(np.mean((over[fast] - 1) ** 2)):.1f} %" if any(fast) else "-",
    ]
    kappa3 = np.array([p["kappa3"] for p in first])
    if len(over) > 2 and len(set(kappa3)) > 1:
        _, n, _, n_error = power_law(kappa3 / STEEL, over, errors / over)
        return [*cells, f"{n:+.2f} +- {n_error:.2f}"]
    return [*cells, "-"]


def materials(report: dict[str, Any], picture: str) -> list[str]:
    """mu over Eq. 2 at the conditions that ran with both sets of laws."""
    # what seeds differ by follows from those of one set of laws
    of_plan = groups(with_own_errors(report["report"]["points"]), plan_name)
    by_condition = {
        plan: groups(of_plan.get(plan, []), lambda point: run_name(point).split("-seed")[0])
        for plan in PRESETS
    }
    names = [name for name in by_condition[OLD] if name in by_condition[NEW]]
    if not names:
        raise Missing(f"no condition of {NEW} is one of {OLD}")
    first = [by_condition[NEW][name][0] for name in names]
    ratios = {plan: [over_eq2(by_condition[plan][name]) for name in names] for plan in PRESETS}
    draw(first, ratios, picture)
    rows = [
        [
            name,
            f"{p['strength']:g}",
            f"{p['kappa3'] / STEEL:.2f}",
            f"{p['pressure']:g}",
            f"{p['velocity']:g}",
            f"{p['kappa1']:.3g}",
            f"{p['kappa2']:.3g}",
            f"{p['mu_eq2']:.3f}",
            *("{:.2f} +- {:.2f}".format(*ratios[plan][k]) for plan in PRESETS),
        ]
        for k, (name, p) in enumerate(zip(names, first))
    ]
    head = ["mu over Eq. 2", "MPa", "E/sigma_0", "p", "v", "kappa1", "kappa2", "Eq. 2"]
    lines = table([*head, *PRESETS.values()], rows)
    lines += ["", f"{len(names)} conditions; E/sigma_0 over that of 92 MPa and 206 GPa"]
    return lines + table(
        [
            "",
            "RMS from Eq. 2",
            "of it errors",
            "mean",
            f"RMS from {FAST:g} m/s on",
            "n of (E/s0)^n",
        ],
        [[PRESETS[plan], *summary(first, ratios[plan])] for plan in PRESETS],
    )


def draw(
    first: list[dict[str, Any]], ratios: dict[str, list[tuple[float, float]]], picture: str
) -> None:
    """mu over Eq. 2 against E/sigma_0, both sets of laws."""
    figure, axes = pyplot.subplots(figsize=(7, 4.4), constrained_layout=True)
    x = np.array([p["kappa3"] for p in first])
    for plan, color, fill, shift in ((OLD, "0.5", "none", 0.985), (NEW, "C0", None, 1.015)):
        over, errors = (np.array(column) for column in zip(*ratios[plan]))
        axes.errorbar(
            shift * x,
            over,
            yerr=NORMAL * errors,
            fmt="o",
            color=color,
            mfc=fill,
            ms=4,
            lw=1,
            capsize=2,
            label=PRESETS[plan],
        )
    axes.axhline(1, color="k", ls="--", lw=1, label="Eq. 2")
    axes.set(xscale="log", xlabel="$E/\\sigma_0$", ylabel="$\\mu/\\mu$(Eq. 2)")
    axes.set_xticks([500, 1000, 2000, 4000], ["500", "1000", "2000", "4000"])
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    save_figure(figure, picture)
    pyplot.close(figure)
