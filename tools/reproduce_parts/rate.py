# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction against the shear rate of the layer."""

import itertools

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import groups

from . import ageing, layer
from .common import Missing, straight_line, table

TIMES = (
    (25, 50),
    (50, 100),
    (100, 150),
    (150, 200),
    (200, 300),
    (300, 400),
    (400, 600),
    (600, 1200),
)  # ns
GROUND_IN = 200  # nm of sliding before a window
RATES = (0.1, 0.15, 0.25, 0.35, 0.5, 0.7, 1.2)  # 1/ns, between which windows are taken together


def windows(points):
    """(velocity in m/s, rows, shear rate in 1/ns, mu, its standard error) of each case in each
    window: means over its runs."""
    found = []
    for (v, rows), members in groups(
        ageing.with_layers(points), lambda x: (x[0]["velocity"], ageing.rows_of(x[0]))
    ).items():
        logs, depths, end = (
            ageing.friction_series(p for p, _ in members),
            ageing.depth_series(members),
            ageing.shortest(members),
        )
        for low, high in TIMES:
            if low * v >= GROUND_IN and high <= end * (1 + 1e-9):
                found.append(
                    (
                        v,
                        rows,
                        v / layer.window(depths, low, high, 2)[0],
                        *layer.window(logs, low, high, 8),
                    )
                )
    return found


def rate(report, picture):
    """mu against the mean shear rate of the layer (velocity over depth, 1/ns) at 15 MPa: all
    velocities (m/s), heights and times on one straight line."""
    found = windows(
        [
            p
            for p in report["report"]["points"]
            if p["pressure"] == 15 and ageing.roughness_of(p) in (None, ageing.ROUGHNESS)
        ]
    )
    if len(found) < 3:
        raise Missing(f"{len(found)} windows after {GROUND_IN} nm of sliding: 3 are needed")
    velocity, height, gamma, mu, error = np.array(found).T
    start, slope, start_error, slope_error = straight_line(gamma, mu, error)
    figure, axes = pyplot.subplots(figsize=(7, 4.6), constrained_layout=True)
    for (v, rows), members in groups(found, lambda x: x[:2]).items():
        x, y, e = np.array(members).T[2:]
        color, marker = (
            f"C{sorted(set(velocity)).index(v)}",
            "ovs^D"[sorted(set(height)).index(rows) % 5],
        )
        axes.errorbar(
            x,
            y,
            yerr=1.96 * e,
            fmt=marker,
            color=color,
            ms=5,
            lw=0.8,
            capsize=2,
            label=f"{v:g} m/s, {rows:g} rows",
        )
    line = np.array([0, 1.05 * max(gamma)])
    axes.plot(line, start + slope * line, "k", lw=1, label=f"{start:.3f} + {slope:.3f} ns x rate")
    axes.set(
        xlim=(0, None),
        xlabel="mean shear rate of the layer, $v$ over its depth (1/ns)",
        ylabel="$\\mu$, 95 %",
    )
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, ncols=2)
    save_figure(figure, picture)
    rows, residual = [], mu / (start + slope * gamma) - 1
    for low, high in itertools.pairwise(RATES):
        inside = (low < gamma) & (gamma <= high)
        if inside.any():
            rows.append(
                [
                    f"{low:g} to {high:g} /ns",
                    str(inside.sum()),
                    f"{min(velocity[inside]):g} to {max(velocity[inside]):g}",
                    f"{mu[inside].mean():.3f}",
                    f"{100 * residual[inside].mean():+.1f} %",
                    f"{100 * np.sqrt(np.mean(residual[inside] ** 2)):.1f} %",
                ]
            )
    return [
        *table(
            [
                "shear rate of the layer",
                "windows",
                "m/s",
                "mean mu",
                "over the line",
                "RMS about it",
            ],
            rows,
        ),
        "",
        f"mu = a + b rate: a = {start:.3f} +- {start_error:.3f}, b = {slope:.3f} +- "
        f"{slope_error:.3f} ns, RMS "
        f"{100 * np.sqrt(np.mean(residual**2)):.1f} % ({len(found)} windows, own errors "
        f"{100 * np.sqrt(np.mean((error / mu) ** 2)):.1f} %)",
    ]
