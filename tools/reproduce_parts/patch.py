# SPDX-License-Identifier: GPL-2.0-or-later
"""The paper's Figs. 13 to 15 for a point contact, smooth, frozen and moving."""

import dataclasses
import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import NORMAL, student95

from . import chain, locomotive, locomotive_runs, patch_pictures, patch_runs, wheel
from .common import Missing, table

SMOOTH, FROZEN, MOVING = ("C0", "smooth"), ("C3", "frozen"), ("C2", "moving")
# of dry and of wet rails, as Open Rails (Axle.cs) takes them for those of Polach, Wear 258 (2005)
# 992
PUBLISHED = {"dry": (1.0, 0.4), "wet": (0.3, 0.1)}  # kA, kS


@dataclasses.dataclass
class PatchFigure:
    """A figure: title, plans whose tables it shows, make(tables, picture) -> lines; logs: plans
    whose friction logs give its law, of which make gets the path beside the tables."""

    title: str
    plans: list
    make: object
    logs: tuple = ()


Rows = list[dict[str, Any]]  # of a table of runs


def chosen(rows: Rows, **labels: Any) -> Rows:
    """Rows with these labels (numbers to six digits), which have a solution."""

    def fits(row: dict[str, Any]) -> bool:
        return all(
            row[k] == v if isinstance(v, str) else math.isclose(row[k], v, rel_tol=1e-5)
            for k, v in labels.items()
        )

    return [row for row in rows if fits(row) and not math.isnan(row["traction_ratio"])]


def standard(rows: Rows, mode: str, **labels: Any) -> Rows:
    """Rows of the surfaces of most figures."""
    if mode != "smooth":
        labels["slope"] = patch_runs.SLOPE
    return chosen(rows, mode=mode, wave=patch_runs.WAVE, cells=patch_runs.CELLS, **labels)


def mean(values: Any) -> tuple[float, float]:
    """(mean, standard error of it from the scatter; 0 of one)."""
    values = np.array(values, dtype=float)
    if not len(values):
        raise Missing("a point has no run: all runs of the plan are needed")
    error = values.std(ddof=1) / math.sqrt(len(values)) if len(values) > 1 else 0.0
    return float(values.mean()), float(error)


def by_seed(rows: Rows, key: str) -> dict[int, float]:
    """{seed: value}; a seed counts once, whatever runs of it there are."""
    return {row["seed"]: row[key] for row in rows}


def curve(rows: Rows, key: str = "traction_ratio") -> tuple[Any, Any, Any, list[int]]:
    """(creeps, means over the seeds, standard errors, numbers of seeds). Raises Missing of no
    rows."""
    if not rows:
        raise Missing("a curve has no run: smooth, frozen and moving ones are needed")
    creeps = sorted({row["creep"] for row in rows})
    found = [by_seed([r for r in rows if r["creep"] == xi], key) for xi in creeps]
    means, errors = np.array([mean(list(v.values())) for v in found]).T
    return np.array(creeps), means, errors, [len(v) for v in found]


def reach(errors: Any, seeds: list[int]) -> Any:
    """Half the 95 % intervals of means over these numbers of seeds, whose standard errors come from
    the seeds: Student's t; 0 of one."""
    return np.array([e * student95(n - 1) if n > 1 else 0.0 for e, n in zip(errors, seeds)])


def text_of(value: float, error: float = 0.0, digits: int = 3) -> str:
    return f"{value:.{digits}f}" + (f" +- {error:.{digits}f}" if error else "")


def share(rows: Rows, smooth: Any, key: str = "traction_ratio") -> Any:
    """Mean over the seeds of the rows' value over that of the smooth contact, with its error."""
    value, error = mean(list(by_seed(rows, key).values()))
    return value / smooth, error / smooth


def at(rows: Rows, creep: float, **labels: Any) -> Rows:
    return chosen(rows, creep=creep, **labels)


def first(rows: Rows) -> dict[str, Any]:
    """The first of rows that must be there."""
    if not rows:
        raise Missing("a point has no run: all runs of the plan are needed")
    return rows[0]


# fig14 --------------------------------------------------------------------------------------------
def fig14(tables: dict[str, Any], picture: str) -> list[str]:
    """Low creep without temperature, and the initial slope against the real area."""
    low, slopes = tables["patch-low"], tables["patch-slope"]
    curves = {mode: standard(low, mode) for _, mode in (SMOOTH, FROZEN, MOVING)}
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    for color, mode in (SMOOTH, FROZEN, MOVING):
        creep, ratio, error, count = curve(curves[mode])
        label = mode if mode == "smooth" else f"{mode}, mean of {max(count)} seeds, 95 %"
        style = {"fmt": "s" if mode == "moving" else "o-", "ms": 5 if mode == "moving" else 3}
        left.errorbar(
            100 * creep, ratio, reach(error, count), color=color, capsize=2, label=label, **style
        )
    for seed in {row["seed"] for row in curves["frozen"]}:
        creep, ratio, *_ = curve([r for r in curves["frozen"] if r["seed"] == seed])
        left.plot(100 * creep, ratio, color="C3", lw=0.4, alpha=0.6)
    left.set(xlabel="creep, %", ylabel="T/N", xlim=(0, 1.05), ylim=(0, 0.45))
    left.legend(fontsize=8, loc="lower right")
    smooth = first(chosen(slopes, mode="smooth", cells=patch_runs.CELLS))
    rows = [["smooth", "", f"{smooth['peak_pressure']:.0f}", "100 %", "1", "1"]]
    groups = [
        (f"rms slope {s:g}", {"slope": s, "wave": patch_runs.WAVE}) for s in patch_runs.SLOPES
    ]
    groups += [
        (f"waves from {w:g} mm", {"slope": patch_runs.standard_slope(w), "wave": w})
        for w in patch_runs.CUTOFFS
    ]
    for k, (name, labels) in enumerate(groups):
        found = at(slopes, 1e-3, mode="frozen", cells=patch_runs.CELLS, **labels)
        area = share(found, smooth["real_area"], "real_area")
        c11, c22 = (share(found, smooth[key], key) for key in ("c11", "c22"))
        peak, _ = mean(list(by_seed(found, "peak_pressure").values()))
        rows.append(
            [
                name,
                f"{labels['slope']:.4f}",
                f"{peak:.0f}",
                f"{100 * area[0]:.1f} +- {100 * area[1]:.1f} %",
                text_of(*c11),
                text_of(*c22),
            ]
        )
        own = k < len(patch_runs.SLOPES)
        right.plot(
            [100 * r["real_area"] / smooth["real_area"] for r in found],
            [r["c11"] / smooth["c11"] for r in found],
            "os^Dv<>p"[k % 8],
            ms=4,
            color=f"C{1 if own else 4}",
            mfc=None if own else "none",
            label=name,
        )
    start = min(r["creep"] for r in curves["moving"])
    still = first(at(curves["smooth"], start))
    moved = at(curves["moving"], start)
    right.errorbar(
        100 * share(moved, still["real_area"], "real_area")[0],
        share(moved, still["traction_ratio"])[0],
        reach([share(moved, still["traction_ratio"])[1]], [len(by_seed(moved, "creep"))]),
        fmt="C2s",
        ms=7,
        capsize=3,
        label=f"moving, rms slope {patch_runs.SLOPE:g}",
    )
    right.plot([0, 100], [0, 1], "k--", lw=1, label="in proportion (line contact)")
    right.set(
        xlabel="real contact area, % of the smooth contact's",
        ylabel="initial slope over that of the smooth contact",
        xlim=(0, 103),
        ylim=(0, 1.05),
    )
    right.legend(fontsize=7, ncols=2)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    save_figure(figure, picture)
    return [
        *creep_table(curves, (1e-4, 1e-3, 2.5e-3, 0.01, 0.1)),
        "",
        *table(
            ["initial slope", "rms slope", "peak, MPa", "real area", "frozen, C11", "C22"], rows
        ),
        "",
        *maximum(curves),
    ]


def creep_table(curves: dict[str, Any], creeps: tuple[float, ...]) -> list[str]:
    """T/N of the three, and over the smooth contact's."""
    rows = []
    for creep in creeps:
        cells = []
        smooth = first(at(curves["smooth"], creep))["traction_ratio"]
        for mode in ("frozen", "moving"):
            found = at(curves[mode], creep)
            cells.append(text_of(*mean(list(by_seed(found, "traction_ratio").values())), 4))
            cells.append(text_of(*share(found, smooth)))
        rows.append([f"creep {100 * creep:g} %", f"{smooth:.4f}", *cells])
    return table(["T/N", "smooth", "frozen", "over smooth", "moving", "over smooth"], rows)


def maximum(curves: dict[str, Any]) -> list[str]:
    """Whether T/N has a maximum, from the table's creeps."""
    lines = []
    for mode in ("smooth", "frozen", "moving"):
        creep, ratio, *_ = curve(curves[mode])
        best = int(np.argmax(ratio))
        lines.append(
            f"largest T/N, {mode}: {ratio[best]:.4f} at {100 * creep[best]:g} % creep; at "
            f"{100 * creep[-1]:g} % {100 * ratio[-1] / ratio[best]:.1f} % of it"
        )
    return lines


# fig15 --------------------------------------------------------------------------------------------
def fig15(tables: dict[str, Any], picture: str) -> list[str]:
    """High creep with temperature."""
    high = tables["patch-high"]
    figure, panels = pyplot.subplots(1, 2, figsize=(11, 4.4), sharey=True, constrained_layout=True)
    rows, hot = [], []
    for axes, (heat, title) in zip(
        panels, (("averaged", "mean temperature, Eq. 11"), ("local", "local flash temperature"))
    ):
        for k, speed in enumerate(patch_runs.SPEEDS):
            for mode, line in (("smooth", "-"), ("frozen", "--"), ("moving", "s")):
                found = standard(high, mode, heat=heat, speed=speed)
                if not found:
                    continue
                creep, ratio, error, count = curve(found)
                axes.errorbar(
                    100 * creep,
                    ratio,
                    reach(error, count),
                    fmt=line,
                    color=f"C{k}",
                    mfc="none",
                    ms=6,
                    lw=1.2,
                    capsize=2,
                    label=f"{mode}, {speed:g} m/s",
                )
                if mode != "moving":
                    best = ratio.max()
                    last = by_seed([r for r in found if r["creep"] == creep[-1]], "traction_ratio")
                    fall = mean(list(last.values()))
                    warm = mean([r["temperature_max"] for r in found if r["creep"] == creep[-1]])
                    rows.append(
                        [
                            f"{mode}, {heat}, {speed:g} m/s",
                            f"{best:.4f} at {100 * creep[int(ratio.argmax())]:g} %",
                            f"{100 * creep[-1]:g} %",
                            text_of(*fall, 4),
                            f"{100 * fall[0] / best:.1f} %",
                            f"{warm[0]:.0f}",
                        ]
                    )
        hot += moving_rows(high, heat)
        axes.set(xlabel="creep, %", title=title, xlim=(0, 10.5), ylim=(0, 0.45))
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, ncols=2, loc="lower right")
    panels[0].set_ylabel("T/N")
    save_figure(figure, picture)
    return [
        *table(["T/N", "largest", "creep", "there", "of the largest", "hottest, K"], rows),
        "",
        *table(["moving, 20 m/s", "seeds", "moving", "over smooth", "frozen", "hottest, K"], hot),
    ]


def moving_rows(high: Any, heat: Any) -> list[list[str]]:
    """Moving roughness beside the others at its creeps."""
    rows = []
    every = [r for r in high if r["mode"] == "moving" and r["heat"] == heat]
    for creep in sorted({r["creep"] for r in every}):
        asked = sum(r["creep"] == creep for r in every)
        found = at(standard(high, "moving", heat=heat), creep)
        name = f"{heat}, creep {100 * creep:g} %"
        if not found:
            rows.append([name, f"0 of {asked}", "no strength left", "", "", ""])
            continue
        smooth = standard(high, "smooth", heat=heat, speed=20)
        smooth = first(at(smooth, creep))["traction_ratio"]
        frozen = at(standard(high, "frozen", heat=heat, speed=20), creep)
        rows.append(
            [
                name,
                f"{len(found)} of {asked}",
                text_of(*mean([r["traction_ratio"] for r in found]), 4),
                text_of(*share(found, smooth)),
                text_of(*share(frozen, smooth)),
                f"{mean([r['temperature_max'] for r in found])[0]:.0f}",
            ]
        )
    return rows


# polach -------------------------------------------------------------------------------------------
def polach_law(epsilon: Any, kA: float, kS: float) -> Any:
    """F/(mu N) of Polach's law of 2005 at epsilon."""
    adhesion = kA * epsilon / (1 + (kA * epsilon) ** 2)
    return 2 / math.pi * (adhesion + np.arctan(kS * epsilon))


def polach(tables: dict[str, Any], picture: str) -> list[str]:
    """kA and kS of each surface, and the curves over what slides in full."""
    fits, low = tables["patch-low-polach"], tables["patch-low"]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    rows = []
    stiffness = 80769.2 * math.pi / 4 * patch_runs.AXES[0] * patch_runs.AXES[1] / 1e5  # over c11
    for color, mode in (SMOOTH, FROZEN, MOVING):
        found = [fit for fit in fits if fit["mode"] == mode]
        if not found:
            raise Missing(f"no fit of Polach's law to {mode} roughness")
        values = {key: mean([f[key] for f in found]) for key in ("kA", "kS", "mu0", "rms")}
        half = mean([0.5 * (f["kA"] + f["kS"]) for f in found])
        ratio = mean([f["kS"] / f["kA"] for f in found])
        left.errorbar(
            [f["kA"] for f in found],
            [f["kS"] for f in found],
            [NORMAL * f["kS_se"] for f in found],
            [NORMAL * f["kA_se"] for f in found],
            fmt="o",
            ms=4,
            lw=0.6,
            color=color,
            label=f"{mode}",
        )
        rows.append(
            [
                mode,
                str(len(found)),
                text_of(*values["kA"]),
                text_of(*values["kS"]),
                text_of(*half),
                text_of(*ratio, 2),
                text_of(*values["mu0"]),
                f"{values['rms'][0]:.4f}",
            ]
        )
        computed = standard(low, mode)
        creep, force, error, count = curve(computed)
        c11 = first(chosen(low, mode="smooth", cells=patch_runs.CELLS))["c11"]
        limit = force[-1]
        right.errorbar(
            stiffness * c11 * creep / limit,
            force / limit,
            reach(error, count) / limit,
            fmt="s" if mode == "moving" else "o-",
            ms=4,
            lw=1.2,
            capsize=2,
            color=color,
            label=mode,
        )
    epsilon = np.geomspace(0.02, 200, 200)
    for (name, (kA, kS)), line in zip(PUBLISHED.items(), ("--", ":")):
        left.plot(kA, kS, "k*" if name == "dry" else "kX", ms=10, label=f"Polach 2005, {name}")
        right.plot(epsilon, polach_law(epsilon, kA, kS), "k" + line, label=f"Polach 2005, {name}")
        rows.append(
            [f"Polach 2005, {name}", "", f"{kA:.3f}", f"{kS:.3f}", f"{0.5 * (kA + kS):.3f}",
             f"{kS / kA:.2f}", "", ""]
        )  # fmt: skip
    left.plot([0, 1.1], [0, 1.1], "k", lw=0.6, alpha=0.5)
    left.set(xlabel="$k_A$ (adhesion)", ylabel="$k_S$ (slip)", xlim=(0, 1.15), ylim=(0, 1.15))
    right.set(
        xlabel="$\\varepsilon = G \\pi a b\\, C_{11} \\xi / (4 \\mu N)$, Kalker's",
        ylabel="T over that of full sliding",
        xscale="log",
        xlim=(0.03, 100),
        ylim=(0, 1.1),
    )
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    save_figure(figure, picture)
    head = ["", "surfaces", "kA", "kS", "(kA + kS)/2", "kS/kA", "mu0", "rms of T/N"]
    return table(head, rows)


# grid ---------------------------------------------------------------------------------------------
def grid(tables: dict[str, Any], picture: str) -> list[str]:
    """Seed 1 on finer grids."""
    slopes = tables["patch-slope"]
    figure, axes = pyplot.subplots(figsize=(6.5, 4.2), constrained_layout=True)
    rows = []
    lines: dict[str, Any] = {}
    for cells in patch_runs.GRIDS:
        smooth = first(chosen(slopes, mode="smooth", cells=cells))
        labels = {"slope": patch_runs.SLOPE, "wave": patch_runs.WAVE, "cells": cells, "seed": 1}
        frozen = first(at(slopes, 1e-3, mode="frozen", **labels))
        slid = first(at(slopes, 0.01, mode="frozen", **labels))
        moving = at(slopes, 1e-3, mode="moving", **labels)
        values = {
            "frozen: initial slope": frozen["c11"] / smooth["c11"],
            "frozen: T/N at 0.1 %": frozen["traction_ratio"] / smooth["traction_ratio"],
            "frozen: T/N at 1 %": slid["traction_ratio"],
            "real area": frozen["real_area"] / smooth["real_area"],
        }
        if moving:
            values["moving: T/N at 0.1 %"] = moving[0]["traction_ratio"] / smooth["traction_ratio"]
        for name, value in values.items():
            lines.setdefault(name, []).append((cells, value))
        rows.append([f"{cells} cells a wave", *(f"{value:.4f}" for value in values.values())])
        rows[-1] += [""] * (6 - len(rows[-1]))
    for name, found in lines.items():
        number, value = np.array(found).T
        if len(number) > 2:
            axes.plot(1 / number, 100 * (value / value[-1] - 1), "o-", ms=4, label=name)
    axes.set(
        xlabel="1/(cells on the shortest wave)",
        ylabel=f"over the value at {patch_runs.GRIDS[-1]} cells, %",
        xlim=(0, None),
    )
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    save_figure(figure, picture)
    head = ["seed 1, over smooth", "slope", "0.1 %", "T/N at 1 %", "real area", "moving, 0.1 %"]
    return table(head, rows)


FIGURES = {
    "fields-3d": PatchFigure("Pressure and traction of a point contact", [], patch_pictures.fields),
    "fig13-3d": PatchFigure("Fig. 13, point contact: local friction", [], patch_pictures.fig13),
    "curves-3d": PatchFigure("Creep forces of a point contact", [], patch_pictures.curves),
    "fig14-3d": PatchFigure(
        "Fig. 14, point contact: low creep, no temperature", ["patch-low", "patch-slope"], fig14
    ),
    "fig15-3d": PatchFigure("Fig. 15, point contact: high creep", ["patch-high"], fig15),
    "polach-3d": PatchFigure("Polach's kA and kS of a point contact", ["patch-low"], polach),
    "grid-3d": PatchFigure("Grids for a point contact", ["patch-slope"], grid),
    "fig15": PatchFigure(
        "Fig. 15, line contact: rail steel beside the paper",
        [],
        wheel.fig15,
        (locomotive_runs.LOGS_PLAN,),
    ),
    "locomotive": PatchFigure(
        "A measured locomotive", [locomotive_runs.PLAN], locomotive.locomotive
    ),
    "chain": PatchFigure(
        "From the nanometre to a measured locomotive",
        [locomotive_runs.PLAN],
        chain.chain,
        (locomotive_runs.LOGS_PLAN,),
    ),
    "start-3d": PatchFigure("A start from rest of a point contact", [], patch_pictures.start),
}
