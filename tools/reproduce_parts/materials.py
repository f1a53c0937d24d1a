# SPDX-License-Identifier: GPL-2.0-or-later
"""Conditions of many materials beside the paper's law, and what they have over it."""

import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import NORMAL

from .common import STEEL, Missing, power_law, run_name, table
from .law_lines import law_lines

FAST = 4.0  # m/s


def kappa3(report: dict[str, Any], picture: str) -> list[str]:
    """mu over Eq. 2 with the paper's numbers against kappa3 = E/sigma_0, a power law through it;
    each condition; wr_fit's own fit."""
    logs, points = (report["report"][key] for key in ("points", "conditions"))
    x, mu, error, paper = (
        np.array([p[key] for p in points]) for key in ("kappa3", "mu", "mu_se", "mu_eq2")
    )
    if len(x) < 3 or min(x) == max(x):
        raise Missing(f"{len(x)} conditions of {len(set(x))} different kappa3: 3 of 2 are needed")
    factor, n, factor_error, n_error = power_law(x / STEEL, mu / paper, error / mu)
    draw(points, (factor, n), picture)
    over = mu / paper
    fast = np.array([p["velocity"] >= FAST for p in points])
    parts = {
        "all": over,
        f"from {FAST:g} m/s on": over[fast],
        "slower": over[~fast],
        "all, over the power law": over / (factor * (x / STEEL) ** n),
    }
    lines = [
        f"mu/mu(Eq. 2) = A (kappa3/{STEEL:g})^n: A = {factor:.3f} +- {factor_error:.3f}, n = "
        f"{n:.3f} +- {n_error:.3f} (paper: 1 and 0)",
        *table(
            ["our runs over Eq. 2 with the paper's numbers", "conditions", "RMS from 1", "mean"],
            [
                [name, str(len(part)), f"{rms_from_one(part):.1f} %", f"{np.mean(part):.3f}"]
                for name, part in parts.items()
                if len(part)
            ],
        ),
        f"errors of the means, RMS: {100 * math.sqrt(np.mean((error / paper) ** 2)):.1f} %",
        "",
        *conditions([run_name(logs[p["runs"][0]]).split("-seed")[0] for p in points], points),
        "",
    ]
    return lines + law_lines(report)


def rms_from_one(over: Any) -> float:
    """RMS distance from 1, in %."""
    return 100 * math.sqrt(np.mean((over - 1) ** 2))


def conditions(names: list[str], points: list[dict[str, Any]]) -> list[str]:
    """Lines of a table: each condition, and mu over Eq. 2."""
    rows = [
        [
            name,
            f"{p['strength']:g}",
            f"{p['kappa3'] / STEEL:.2f}",
            f"{p['pressure']:g}",
            f"{p['velocity']:g}",
            f"{p['kappa1']:.3g}",
            f"{p['kappa2']:.3g}",
            f"{p['mu']:.3f} +- {p['mu_se']:.3f}",
            f"{p['mu_eq2']:.3f}",
            f"{p['mu'] / p['mu_eq2']:.2f}",
        ]
        for name, p in sorted(zip(names, points), key=lambda pair: pair[0])
    ]
    head = ["", "MPa", "E/sigma_0", "p", "v", "kappa1", "kappa2", "mu", "Eq. 2", "over it"]
    return ["E/sigma_0 over that of 92 MPa and 206 GPa", *table(head, rows)]


def draw(points: list[dict[str, Any]], law: tuple[float, float], picture: str) -> None:
    """mu over Eq. 2 against E/sigma_0, fast conditions apart from slow ones, and A (E/sigma_0)^n,
    law = (A, n)."""
    figure, axes = pyplot.subplots(figsize=(7, 4.4), constrained_layout=True)
    for fast, name, color in (
        (True, f"{FAST:g} m/s and more, 95 %", "C0"),
        (False, "slower", "C3"),
    ):
        part = [p for p in points if (p["velocity"] >= FAST) == fast]
        axes.errorbar(
            [p["kappa3"] for p in part],
            [p["mu"] / p["mu_eq2"] for p in part],
            yerr=[p["mu_se"] * p.get("t95", NORMAL) / p["mu_eq2"] for p in part],
            fmt="o" if fast else "s",
            color=color,
            mfc=None if fast else "none",
            ms=4,
            lw=1,
            capsize=2,
            label=name,
        )
    x = [p["kappa3"] for p in points]
    line = np.geomspace(0.9 * min(x), 1.1 * max(x), 50)
    factor, n = law
    label = f"{factor:.2f} ($\\kappa_3$/{STEEL:g})$^{{{n:.2f}}}$"
    axes.plot(line, factor * (line / STEEL) ** n, "C1", lw=2, label=label)
    axes.axhline(1, color="k", ls="--", lw=1, label="Eq. 2")
    axes.set(
        xscale="log",
        xlabel="$\\kappa_3 = E/\\sigma_0$",
        ylabel="$\\mu/\\mu$(Eq. 2)",
        ylim=(0, None),
    )
    axes.set_xticks([500, 1000, 2000, 4000], ["500", "1000", "2000", "4000"])
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    save_figure(figure, picture)
    pyplot.close(figure)
