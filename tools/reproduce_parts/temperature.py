# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction of a rail steel against temperature, beside Eqs. 2, 9 and 10."""

import os
import re
from typing import Any

import numpy as np
from matplotlib import pyplot

from campaign_parts import material, plan
from campaign_parts.quantities import Run
from mcawr.files import save_figure
from mcawr.replicas import groups, half_width, mean_of
from plot_fit import PAPER, static_part, velocity_term

from .common import Missing, run_name, table

STRENGTH_TEMPERATURE = 1250.0  # K of temperature rise that leaves no strength, Eq. 10
LIMIT = 3.0  # pressures of Eq. 9 go up to so many strengths, the hardness
SIZES = {
    "": ("", "C0", "s", 0),
    "half-wide": ("half width", "C1", "v", -9),
    "wide": ("double width", "C2", "^", 9),
    "widest": ("double width", "C2", "^", 9),
}  # label, color, marker and shift (K) of the runs, by what stands before the temperature


def eq2(values: dict[str, Any]) -> float:
    """Eq. 2 with the paper's parameters at the quantities of a run."""
    run = Run("", values, "")
    return static_part(PAPER, run.kappa2) + velocity_term(PAPER, run.kappa1)


def eq9(values: dict[str, Any]) -> float:
    """Eq. 9: the mean of Eq. 2 over a rough contact, pressures uniform in 0 .. 3 sigma_0, weighted
    with the load."""
    run = Run("", {**values, "p": LIMIT * values["strength"]}, "")
    k = PAPER["c"] * run.kappa2
    mean = 2 * (1 / k - np.log1p(k) / k**2)
    return PAPER["mu0"] + PAPER["mu2"] * mean + velocity_term(PAPER, run.kappa1)


def by_eq10(values: dict[str, Any], cold: dict[str, Any], temperature: float) -> dict[str, Any]:
    """The quantities with the strength of Eq. 10, the modulus of the cold."""
    softer = 1 - (temperature - cold["temperature"]) / STRENGTH_TEMPERATURE
    return {**values, "strength": cold["strength"] * softer, "E": cold["E"]}


def temperature_of(point: dict[str, Any], runs: Any) -> float:
    """The temperature (K) of the plan's run with the point's strength and modulus, which no log's
    head tells by itself."""
    for values in runs:
        same = (values["strength"], values["E"] / values["strength"])
        if np.allclose(same, (point["strength"], point["kappa3"]), rtol=1e-4):
            return values["temperature"]
    raise Missing(f"{point['file']}: not a run of the plan")


def temperature(report: dict[str, Any], picture: str) -> list[str]:
    """mu at each temperature, means over the seeds, beside Eq. 2 with the strengths of the
    potential file and of Eq. 10, and beside Eq. 9 with Eq. 10; then that of other widths."""
    runs = [run.values for run in plan.read(plan.find("temperature")).runs]
    cold = min(runs, key=lambda values: values["temperature"])
    points = report["report"]["points"]
    sizes = groups(points, lambda point: re.split(r"-?(temperature|seed)?\d|$", run_name(point))[0])
    names = ["Eq. 2", "Eq. 2 with Eq. 10", "Eq. 9 with Eq. 10"]

    def laws(at: float, values: dict[str, Any]) -> tuple[float, float, float]:
        softer = by_eq10(values, cold, at)
        return eq2(values), eq2(softer), eq9(softer)

    figure, axes = pyplot.subplots(figsize=(7, 4.6), constrained_layout=True)
    rows = []
    for size, (label, color, style, shift) in SIZES.items():
        found = groups(sizes.get(size, []), lambda point: temperature_of(point, runs))
        for at, members in found.items():
            mu, error = mean_of(members)
            if len(members) > 1:
                single = [p["mu"] for p in members]
                axes.plot([at + shift] * len(single), single, "o", mfc="none", color=color)
            reach = half_width(members)
            axes.errorbar(at + shift, mu, yerr=reach, fmt=style, color=color, capsize=3)
            values = next(values for values in runs if values["temperature"] == at)
            each = "  ".join(f"{p['mu']:.3f}" for p in sorted(members, key=lambda p: p["seed"]))
            rows.append(
                [
                    ", ".join([f"{at:g} K", *([label] if label else [])]),
                    f"{values['strength']:.0f}",
                    f"{values['E'] / 1000:.0f}",
                    f"{members[0]['kappa2']:.1f}",
                    f"{mu:.3f} +- {error:.3f}",
                    each,
                    *(f"{law:.3f}" for law in laws(at, values)),
                ]
            )
    temperatures = [values["temperature"] for values in runs]
    grid = np.linspace(min(temperatures), max(temperatures), 59)
    file = os.path.join(plan.ROOT, "potentials", cold["material"])
    curves = np.array([laws(at, {**cold, **material.read(file, at)}) for at in grid]).T
    styles = zip(names, ("with the strengths of the file", "", ""), ("-", "--", ":"), curves)
    for name, more, style, curve in styles:
        axes.plot(grid, curve, style, color="0.4", label=f"{name} {more}".strip())
    axes.plot([], [], "o", mfc="none", color="C0", label="a run")
    axes.errorbar([], [], yerr=[], fmt="s", color="C0", capsize=3, label="mean, 95 %")
    for label, color, style, _ in list(SIZES.values())[1:3]:
        axes.errorbar([], [], yerr=[], fmt=style, color=color, capsize=3, label=label)
    axes.set(xlabel="temperature (K)", ylabel=r"$\mu$")
    axes.set_ylim(0, 0.85)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9, loc="upper right", ncols=2)
    save_figure(figure, picture)
    pyplot.close(figure)
    head = ["", "sigma_0", "E", "kappa2", "mu", "of each seed", "Eq. 2", "Eqs. 2,10", "Eqs. 9,10"]
    return table(head, rows)
