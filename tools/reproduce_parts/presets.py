# SPDX-License-Identifier: GPL-2.0-or-later
"""One steel with preset b and with preset c, beside Eq. 2."""

import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.friction_log import head_of
from mcawr.replicas import groups, half_width, mean_of

from .common import Missing, percent, run_name, table

PRESETS = {"b": "s", "c": "o"}  # and how they are drawn
SERIES = {"velocity": ("v", "velocity $v$ (m/s), 15 MPa"), "pressure": ("p", "pressure $p$ (MPa)")}


def series(points: list[dict[str, Any]], key: str) -> dict[Any, Any]:
    """{velocity (m/s) or pressure (MPa): {preset: its runs}} of the runs that vary it, from the
    first letter of their names."""
    chosen = [p for p in points if run_name(p).startswith(SERIES[key][0])]
    return {
        value: groups(members, lambda p: head_of(p["file"])["laws"]["preset"])
        for value, members in groups(chosen, lambda p: p[key]).items()
    }


def draw(found: Any, picture: str) -> None:
    """mu against velocity and against pressure: both presets, Eq. 2."""
    figure, panels = pyplot.subplots(1, 2, figsize=(10, 4), sharey=True, constrained_layout=True)
    for axes, (key, (_, label)) in zip(panels, SERIES.items()):
        of_both = found[key]
        paper = [next(iter(runs.values()))[0]["mu_eq2"] for runs in of_both.values()]
        axes.plot(list(of_both), paper, "k--", lw=1.2, label="Eq. 2 with the paper's numbers")
        for name, style in PRESETS.items():
            known = {x: runs[name] for x, runs in of_both.items() if name in runs}
            axes.errorbar(
                list(known),
                [mean_of(runs)[0] for runs in known.values()],
                yerr=[half_width(runs) for runs in known.values()],
                fmt=style,
                ms=5,
                capsize=3,
                label=f"preset {name}, 95 %",
            )
        axes.set(xlabel=label, xlim=(0, None), ylim=(0, 0.75))
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("friction coefficient $\\mu$")
    panels[0].legend(fontsize=9)
    save_figure(figure, picture)


def presets(report: dict[str, Any], picture: str) -> list[str]:
    """mu at each velocity (m/s) and pressure (MPa) with both presets, means over the seeds, and the
    root mean square from Eq. 2."""
    found = {key: series(report["report"]["points"], key) for key in SERIES}
    rows = []
    off: dict[str, list[float]] = {name: [] for name in PRESETS}
    for key, unit in (("velocity", "v = {:g} m/s"), ("pressure", "p = {:g} MPa")):
        for value, runs in found[key].items():
            paper, cells = next(iter(runs.values()))[0]["mu_eq2"], []
            for name in PRESETS:
                if name not in runs:
                    cells += ["-", ""]
                    continue
                mu, error = mean_of(runs[name])
                off[name].append(mu / paper - 1)
                cells += [f"{mu:.3f} +- {error:.3f}", percent(mu, paper)]
            rows.append([unit.format(value), f"{paper:.3f}", *cells])
    if not all(off.values()):
        raise Missing("logs of both presets, b and c, are needed")
    draw(found, picture)
    rms = (f"{100 * math.sqrt(np.mean(np.square(values))):.1f} %" for values in off.values())
    rows.append(["from Eq. 2 (RMS)", "", *(cell for text in rms for cell in ("", text))])
    return table(["mu", "Eq. 2", "preset b", "", "preset c", ""], rows)
