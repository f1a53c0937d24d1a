# SPDX-License-Identifier: GPL-2.0-or-later
"""The measured locomotive beside the rail steel's law and the paper's: nothing is fitted to it."""

import dataclasses
import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr import tables
from mcawr.files import save_figure

from . import locomotive_runs as made
from .common import Missing, table

# %: from, to; the bins of the measured points, which leave out where they are few
BINS = ((0, 0.6), (0.8, 1), (1, 1.2), (2, 3), (4, 5), (6, 8), (8, 12), (12, 14), (17, 22))
JUDGED = 0.8  # %, from which bin on a curve is compared in per cent
FALLS = (0.107, 0.195)  # creeps at which T/N over the peak is told
WITHIN, FALL_WITHIN = 0.20, 0.10  # the aims: of each bin, and of the fall
OURS, TABLE, PAPER = *made.MODELS, made.PAPER
NAMES = {OURS: "our law", TABLE: "our table", PAPER: "the paper's law"}

Rows = list[dict[str, Any]]


@dataclasses.dataclass
class Curve:
    """T/N over creep of one surface, and limits by the law's errors where they are known."""

    creep: Any
    ratio: Any
    low: Any
    high: Any

    def at(self, creep: Any) -> Any:
        """T/N between the points, linear over the logarithm of the creep."""
        return np.interp(np.log(creep), np.log(self.creep), self.ratio)

    @property
    def peak(self) -> float:
        return float(self.ratio.max())


@dataclasses.dataclass
class Measured:
    """The points, and means of bins."""

    points: Any  # creep, T/N
    creep: Any
    ratio: Any
    scatter: Any  # standard deviation in a bin

    def fall(self, creep: float) -> float:
        """Traction of the bin at this creep, over the largest."""
        return float(self.ratio[np.abs(self.creep - creep).argmin()] / self.ratio.max())


def measured() -> Measured:
    """The measured points of examples/wheelrail/eurosprinter.csv."""
    points = np.array(
        tables.read(
            made.MEASURED,
            "a table of creep_percent and traction_ratio",
            lambda rows: [
                (row.number("creep_percent"), row.number("traction_ratio")) for row in rows
            ],
        )
    )
    bins = [points[(points[:, 0] >= low) & (points[:, 0] < high)] for low, high in BINS]
    creep, ratio = np.array([found.mean(axis=0) for found in bins]).T
    scatter = np.array([found[:, 1].std(ddof=1) for found in bins])
    return Measured(points * [0.01, 1], 0.01 * creep, ratio, scatter)


def curves(rows: Rows, band: bool = False, **labels: Any) -> list[Curve]:
    """The curves with these labels, one a seed. band: those with limits. Raises Missing."""

    def fits(row: dict[str, Any]) -> bool:
        has_band = not math.isnan(row.get("law_low", math.nan))
        return has_band == band and all(row[k] == v for k, v in labels.items())

    by_seed: dict[float, Rows] = {}
    for row in rows:
        if fits(row) and not math.isnan(row["traction_ratio"]):
            by_seed.setdefault(row["seed"], []).append(row)
    if not by_seed:
        raise Missing(f"no run of {labels}: all runs of the plan are needed")
    keys = ("creep", "traction_ratio", "law_low", "law_high")
    return [
        Curve(*np.array([[row.get(k, math.nan) for k in keys] for row in found]).T)
        for found in by_seed.values()
    ]


def envelope(found: list[Curve]) -> tuple[Any, Any, Any, Any]:
    """(creeps, least, mean, largest T/N) of curves at the same creeps. Raises Missing."""
    if len({len(curve.creep) for curve in found}) > 1:
        raise Missing("a curve lacks points: all runs of the plan are needed")
    ratios = np.array([curve.ratio for curve in found])
    return found[0].creep, ratios.min(axis=0), ratios.mean(axis=0), ratios.max(axis=0)


# table --------------------------------------------------------------------------------------------
def judged(curve: Curve, real: Measured) -> dict[str, float]:
    """A curve beside the bins."""
    ours = curve.at(real.creep)
    relative = np.abs(ours / real.ratio - 1)[real.creep >= 0.01 * JUDGED]
    return {
        "rms": float(np.sqrt(np.mean((ours - real.ratio) ** 2))),
        "worst": float(relative.max()),
        "peak": curve.peak,
        "place": float(curve.creep[curve.ratio.argmax()]),
        **{f"fall{k}": float(curve.at(creep) / curve.peak) for k, creep in enumerate(FALLS)},
        "start": float(curve.ratio[0]),
    }


def span(values: list[float], form: str, scale: float = 1.0) -> str:
    """Least and largest value, or one where they read the same."""
    low, high = (f"{scale * end:{form}}" for end in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def row_of(name: list[str], found: list[Curve], real: Measured) -> list[str]:
    values = [judged(curve, real) for curve in found]

    def column(key: str, form: str, scale: float = 1.0) -> str:
        return span([value[key] for value in values], form, scale)

    return [
        *name,
        column("rms", ".3f"),
        column("worst", ".0f", 100),
        column("peak", ".3f"),
        column("place", ".2g", 100),
        column("fall0", ".2f"),
        column("fall1", ".2f"),
        column("start", ".3f"),
    ]


HEAD = [
    "law",
    "rms slope",
    "RMS",
    "worst, %",
    "peak",
    "at, %",
    "at 10.7 %",
    "at 19.5 %",
    "at 0.1 %",
]


def comparison(rows: Rows, real: Measured) -> list[str]:
    """The table: each law and surface beside the bins."""
    peak = float(real.ratio.max())
    place = float(real.creep[real.ratio.argmax()])
    falls = [f"{real.fall(creep):.2f}" for creep in FALLS]
    lines = [["measured", "", "", "", f"{peak:.3f}", f"{100 * place:.2g}", *falls, ""]]
    for law, name in NAMES.items():
        lines.append(row_of([name, "smooth"], curves(rows, law=law, mode="smooth"), real))
        for slope in made.SLOPES:
            found = curves(rows, law=law, mode="frozen", slope=slope)
            lines.append(row_of([name, f"{slope:g}"], found, real))
    moving = curves(rows, law=OURS, mode="moving")
    lines.append(row_of([NAMES[OURS], f"{made.ONE_SLOPE:g}, moving"], moving, real))
    return table(HEAD, lines)


def aims(rows: Rows, real: Measured) -> list[str]:
    """Whether our law, rough, is where the aims want it for some roughness, with its numbers."""
    every = [
        (judged(curve, real), f"rms slope {slope:g}, {mode}")
        for mode, slopes in (("frozen", made.SLOPES), ("moving", (made.ONE_SLOPE,)))
        for slope in slopes
        for curve in curves(rows, law=OURS, mode=mode, slope=slope)
    ]
    best, name = min(every, key=lambda found: found[0]["worst"])
    alike = [values["worst"] for values, other in every if other == name]
    lines = [
        f"each bin from {JUDGED + 0.1:g} % on within {100 * WITHIN:.0f} %: "
        f"{said(best['worst'] <= WITHIN)}, {100 * best['worst']:.0f} % ({name}; "
        f"{sum(worst <= WITHIN for worst in alike)} of {len(alike)} seeds)"
    ]
    for k, creep in enumerate(FALLS):
        wanted = real.fall(creep)
        offs = [abs(values[f"fall{k}"] - wanted) for values, _ in every]
        off = min(offs)
        best, name = every[offs.index(off)]
        lines.append(
            f"T/N over its peak at {100 * creep:g} % within {FALL_WITHIN:.2f} of {wanted:.2f}: "
            f"{said(off <= FALL_WITHIN)}, {best[f'fall{k}']:.2f} ({name})"
        )
    return lines


def said(is_met: bool) -> str:
    return "met" if is_met else "not met"


def moved(rows: Rows) -> list[str]:
    """Moving roughness beside frozen of the same seeds, and over the smooth contact."""
    smooth = curves(rows, law=OURS, mode="smooth")[0]
    moving = curves(rows, law=OURS, mode="moving")
    frozen = curves(rows, law=OURS, mode="frozen", slope=made.ONE_SLOPE)[: len(moving)]
    lines = []
    for k, creep in enumerate(moving[0].creep):
        ours = [float(curve.ratio[k]) for curve in moving]
        still = [float(curve.at(creep)) for curve in frozen]
        plain = float(smooth.at(creep))
        lines.append(
            [
                f"{100 * creep:g} %",
                f"{plain:.3f}",
                span(still, ".3f"),
                span(ours, ".3f"),
                f"{np.mean(ours) / np.mean(still):.2f}",
                f"{np.mean(ours) / plain:.2f}",
            ]
        )
    head = ["T/N at", "smooth", "frozen", "moving", "moving/frozen", "moving/smooth"]
    return table(head, lines)


def quoted(rows: Rows, creep: float) -> str:
    """One line to quote: T/N, and how far law and roughness let it vary."""
    band = curves(rows, band=True, law=OURS, mode="frozen")[0]
    low, high = (
        float(np.interp(math.log(creep), np.log(band.creep), ends))
        for ends in (band.low, band.high)
    )
    one = curves(rows, law=OURS, mode="frozen", slope=made.ONE_SLOPE)
    every = [
        float(curve.at(creep))
        for slope in made.SLOPES
        for curve in curves(rows, law=OURS, mode="frozen", slope=slope)
    ]
    seeds = [float(curve.at(creep)) for curve in one]
    return (
        f"T/N at {100 * creep:g} % creep, {made.SPEED:g} m/s: {np.mean(seeds):.3f} (rms slope "
        f"{made.ONE_SLOPE:g}), 95 % of law {low:.3f}..{high:.3f}, of seeds "
        f"{min(seeds):.3f}..{max(seeds):.3f}, of rms slopes {min(made.SLOPES):g} to "
        f"{max(made.SLOPES):g} {min(every):.3f}..{max(every):.3f}"
    )


# picture ------------------------------------------------------------------------------------------
def draw_measured(axes: Any, real: Measured) -> None:
    axes.plot(*(real.points * [100, 1]).T, ".", color="0.6", ms=3, zorder=1)
    axes.errorbar(
        100 * real.creep,
        real.ratio,
        real.scatter,
        fmt="ko",
        ms=5,
        capsize=3,
        lw=1,
        zorder=6,
        label="measured, means of bins and scatter",
    )


def draw_rough(axes: Any, rows: Rows, law: str, color: str) -> None:
    """The band of all roughnesses, and a line for each slope with the band of its seeds."""
    all_found = [curves(rows, law=law, mode="frozen", slope=slope) for slope in made.SLOPES]
    creep, least, _, most = envelope([curve for found in all_found for curve in found])
    axes.fill_between(
        100 * creep,
        least,
        most,
        color=color,
        alpha=0.10,
        lw=0,
        label=f"roughness not known: rms slope {min(made.SLOPES):g} to {max(made.SLOPES):g}",
    )
    for slope, line, found in zip(made.SLOPES, ("-", "--", ":"), all_found):
        creep, low, mean, high = envelope(found)
        axes.fill_between(100 * creep, low, high, color=color, alpha=0.30, lw=0)
        axes.plot(
            100 * creep,
            mean,
            color=color,
            ls=line,
            lw=1.8,
            label=f"rough, frozen, rms slope {slope:g} (dark: {len(found)} seeds)",
        )


def draw_law_band(axes: Any, band: Curve, color: str, label: str) -> None:
    """Bars, so that they are told from the shades of roughness."""
    middle, half = 0.5 * (band.low + band.high), 0.5 * (band.high - band.low)
    beside = 93 * band.creep  # %; to the left of the bins
    axes.errorbar(
        beside, middle, half, fmt="none", ecolor=color, capsize=4, lw=2, zorder=4, label=label
    )


def locomotive(found: dict[str, Any], picture: str) -> list[str]:
    """T/N against creep, both laws, beside the measured points."""
    rows, real = found[made.PLAN], measured()
    figure, panels = pyplot.subplots(1, 2, figsize=(12, 5.8), sharey=True, constrained_layout=True)
    titles = ("friction law of our rail steel", "the paper's law")
    for axes, law, color, title in zip(panels, (OURS, PAPER), ("C3", "C0"), titles):
        draw_measured(axes, real)
        draw_rough(axes, rows, law, color)
        smooth = curves(rows, law=law, mode="smooth")[0]
        axes.plot(100 * smooth.creep, smooth.ratio, color="0.25", lw=1.8, label="smooth")
        axes.set(title=title, xlabel="creep, %", xscale="log", xlim=(0.095, 22), ylim=(0, 0.47))
        ticks = (0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
        axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.minorticks_off()
        axes.grid(alpha=0.3)
    ours = panels[0]
    for mode, color in (("smooth", "0.25"), ("frozen", "darkred")):
        band = curves(rows, band=True, law=OURS, mode=mode)[0]
        label = "95 % by the law's errors" if mode == "frozen" else ""
        draw_law_band(ours, band, color, label)
    moving = curves(rows, law=OURS, mode="moving")
    creep, _, mean, _ = envelope(moving)
    ours.plot(
        100 * creep,
        mean,
        "s",
        color="darkred",
        mfc="white",
        ms=7,
        zorder=5,
        label=f"rough, moving, rms slope {made.ONE_SLOPE:g} ({len(moving)} seeds)",
    )
    ours.set_ylabel("T/N")
    for axes in panels:
        style = {"fontsize": 7, "ncols": 2, "handlelength": 1.6, "columnspacing": 1.0}
        axes.legend(loc="upper center", bbox_to_anchor=(0.48, -0.11), **style)
    save_figure(figure, picture)
    pyplot.close(figure)
    return [
        "T/N over nine bins of the measured points; worst: of those from 0.9 % on; T/N over its "
        "peak at 10.7 and 19.5 %; T/N at 0.1 %; spans: of seeds",
        *comparison(rows, real),
        "",
        f"aims for {NAMES[OURS]}, rough, of some roughness:",
        *aims(rows, real),
        "",
        *moved(rows),
        "",
        quoted(rows, 0.1),
    ]
