# SPDX-License-Identifier: GPL-2.0-or-later
"""A picture of values with their intervals, one below the other."""

from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure


def dots(
    labels: Any,
    values: Any,
    bars: Any,
    picture: str,
    xlabel: Any,
    lines: Any = (),
    band: Any = None,
    heading: str = "",
) -> None:
    """A row for each label: value with its 95 % interval; vertical lines (x, style, label); a band;
    a heading above the labels."""
    figure, axes = pyplot.subplots(figsize=(7.5, 1.2 + 0.3 * len(labels)), constrained_layout=True)
    rows = np.arange(len(labels))[::-1]
    axes.errorbar(values, rows, xerr=bars, fmt="o", capsize=2, label="our runs, 95 %")
    for x, style, label in lines:
        axes.axvline(x, **style, lw=1.2, label=label)
    if band:
        axes.axvspan(band[0], band[1], color="C1", alpha=0.2, lw=0, label=band[2])
    axes.set_yticks(rows, labels)
    axes.text(-0.02, 1.02, heading, transform=axes.transAxes, ha="right", fontsize=9)
    axes.set(xlabel=xlabel, ylim=(-0.7, len(labels) - 0.3))
    axes.grid(alpha=0.3, axis="x")
    axes.legend(
        fontsize=9,
        loc="upper center",
        bbox_to_anchor=(0.4, -0.85 / (1.2 + 0.3 * len(labels))),
        ncols=3,
    )
    save_figure(figure, picture)
