# SPDX-License-Identifier: GPL-2.0-or-later
"""One steel against velocity and against pressure, beside Eq. 2 and the law of these runs."""

from typing import Any

import numpy as np
from matplotlib import pyplot

import plot_fit
from mcawr.files import save_figure
from mcawr.replicas import groups, half_width, mean_of

from .common import Missing

ALONE = {"velocity": ("pressure", "MPa"), "pressure": ("velocity", "m/s")}  # what is the same
LABELS = {"velocity": "velocity $v$ (m/s)", "pressure": "pressure $p$ (MPa)"}


def law_at(law: dict[str, Any], point: dict[str, Any], key: str, x: Any) -> Any:
    """mu of a law where one quantity of a point, `velocity` (m/s) or `pressure` (MPa), is x."""
    kappa1, kappa2 = point["kappa1"], point["kappa2"]
    if key == "velocity":
        kappa1 = kappa1 * (x / point[key]) ** 2
    else:
        kappa2 = kappa2 * x / point[key]
    return plot_fit.static_part(law, kappa2) + plot_fit.velocity_term(law, kappa1)


def draw(report: dict[str, Any], picture: str) -> None:
    """mu with its 95 % against each of the two, at the value of the other that most runs have.
    Raises Missing."""
    points = report["report"]["points"]
    figure, panels = pyplot.subplots(1, 2, figsize=(10, 4), sharey=True, constrained_layout=True)
    for axes, (key, (same, unit)) in zip(panels, ALONE.items()):
        value, chosen = max(groups(points, lambda p: p[same]).items(), key=lambda g: len(g[1]))
        found = groups(chosen, lambda p: p[key])
        if len(found) < 2:
            raise Missing(f"{len(found)} {key} at {value:g} {unit}: 2 are needed")
        x = np.linspace(min(found), max(found), 200)
        axes.plot(x, law_at(plot_fit.PAPER, chosen[0], key, x), "k--", lw=1.2, label="Eq. 2")
        if "mu0" in report:
            axes.plot(x, law_at(report, chosen[0], key, x), "C1", lw=1.5, label="law of our runs")
        axes.errorbar(
            list(found),
            [mean_of(runs)[0] for runs in found.values()],
            yerr=[half_width(runs) for runs in found.values()],
            fmt="o",
            ms=5,
            capsize=3,
            label="our runs, 95 %",
        )
        axes.set(xlabel=f"{LABELS[key]}, {value:g} {unit}", xlim=(0, None))
        axes.grid(alpha=0.3)
    panels[0].set_ylim(0, None)
    panels[0].set_ylabel("friction coefficient $\\mu$")
    panels[0].legend(fontsize=9)
    save_figure(figure, picture)
