# SPDX-License-Identifier: GPL-2.0-or-later
"""The whole way in one picture: the fragment, mu of the rail steel, the measured locomotive."""

import os
import tempfile
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr import tables
from mcawr.files import save_figure
from mcawr.replicas import groups, half_width, mean_of

from . import locomotive, locomotive_runs as made, patch_runs, rail

FRAGMENT = os.path.join(patch_runs.ROOT, "examples", "friction", "fragment.png")
STRIPES = (0.052, 0.402, 0.25, 0.802)  # left, right, top, bottom of its first panel, shares


def draw_fragment(axes: Any) -> None:
    """The first panel of plot_fragment.py's picture, the left two thirds of it."""
    image = pyplot.imread(FRAGMENT)
    height, width = image.shape[:2]
    left, right, top, bottom = STRIPES
    right = left + 0.66 * (right - left)
    rows = slice(int(top * height), int(bottom * height))
    axes.imshow(image[rows, int(left * width) : int(right * width)])
    axes.set_axis_off()
    axes.set_title("two blocks after 40 ns of sliding\n(66 nm; automata of 2.5 nm)", fontsize=11)


def draw_law(axes: Any, report: dict[str, Any]) -> None:
    """mu of the logs over p/sigma_0 and the law, colours by temperature."""
    x = np.geomspace(0.025, 3, 200)
    found_at = rail.by_temperature(report)
    for (color, kelvin, members), aside in zip(found_at, rail.shifts(len(found_at))):
        fast = rail.at_speed(members)
        found = [
            (ratio, mean_of(same)[0], half_width(same))
            for ratio, same in groups(fast, rail.rounded).items()
        ]
        at, mu, half = np.array(found).T
        axes.errorbar(at, mu, half, fmt="o", ms=4, color=color, capsize=2, label=f"{kelvin:g} K")
        axes.plot(x, rail.law_at(report, x, fast[0]["kappa1"], fast[0]["kappa3"]), color=color)
    axes.plot(x, rail.SHEAR / x, "k--", lw=1, label="shear strength")
    axes.set(xlabel="pressure over strength at the temperature", xscale="log", ylim=(0, 0.9))
    axes.set_ylabel(r"$\mu$")
    axes.set_title("friction coefficient of rail steel", fontsize=11)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7.5, ncols=2, loc="lower left")


def draw_wheel(axes: Any, rows: Any) -> None:
    """Our law, smooth, frozen and moving, beside the measured points."""
    locomotive.draw_measured(axes, locomotive.measured())
    ours, slope = locomotive.OURS, made.ONE_SLOPE
    smooth = locomotive.curves(rows, law=ours, mode="smooth")[0]
    axes.plot(100 * smooth.creep, smooth.ratio, color="0.25", lw=1.5, label="computed, smooth")
    frozen = locomotive.curves(rows, law=ours, mode="frozen", slope=slope)
    creep, low, mean, high = locomotive.envelope(frozen)
    axes.fill_between(100 * creep, low, high, color="C3", alpha=0.25, lw=0)
    axes.plot(100 * creep, mean, "C3", lw=1.8, label="computed, rough, frozen")
    creep, _, mean, _ = locomotive.envelope(locomotive.curves(rows, law=ours, mode="moving"))
    axes.plot(
        100 * creep, mean, "s--", color="darkred", mfc="white", label="computed, rough, moving"
    )
    axes.set(xlabel="creep, %", xscale="log", xlim=(0.095, 22), ylim=(0, 0.4), ylabel="T/N")
    axes.set_xticks([0.1, 1, 10], ["0.1", "1", "10"])
    axes.set_title("traction of a locomotive over its load, 36 km/h", fontsize=11)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, loc="lower right")


def chain(found: dict[str, Any], picture: str) -> list[str]:
    """The picture; the numbers stand in those of rail and locomotive."""
    with tempfile.TemporaryDirectory() as folder:
        path, _ = made.fit(made.MODELS[0], found[made.LOGS_PLAN], folder)
        report = tables.fit_report(path)
    figure, panels = pyplot.subplots(
        1, 3, figsize=(13, 3.9), width_ratios=(1.25, 1, 1.35), constrained_layout=True
    )
    draw_fragment(panels[0])
    draw_law(panels[1], report)
    draw_wheel(panels[2], found[made.PLAN])
    save_figure(figure, picture)
    pyplot.close(figure)
    return [made.told(report)]
