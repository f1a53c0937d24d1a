# SPDX-License-Identifier: GPL-2.0-or-later
"""Sets of laws crossed: which rubs alike at equal kappa1 and kappa2, and how near to Eq. 2. Of the
plan laws all of them; of the plan laws-links the best of them, and these with other rules for
links."""

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import groups, mean_of

from . import layer
from .common import Missing, run_name, table

EQUAL = ("base", "thin", "thick", "soft", "stiff", "smooth")  # kappa1 = 2.571, kappa2 = 123.6
BESIDE = ("slow", "dense", "strong")
CONDITIONS = (*EQUAL, *BESIDE)
SCREENED = ("base", *BESIDE)
COLOURS = ("0.5", "C0", "C1", "C3")  # nothing more, contacts, both, contacts and both
BEGIN, END = 75.0, 150.0  # ns, of the averages of the plan laws
LINKS_BEGIN, LINKS_END = 50.0, 100.0  # of the plan laws-links
BLOCKS = 5  # of the layer's depth
BEST = "b contacts both"  # of the plan laws; with weld 0.554 preset c
FOURFOLD = math.log(4.0)  # viscosity of thick over thin, E/sigma_0 of stiff over soft


@dataclasses.dataclass
class Mean:
    """A mean over the seeds, of mu or of a depth in nm, and its standard error."""

    value: float
    error: float

    @property
    def relative(self) -> float:
        """Standard error of the logarithm."""
        return self.error / self.value


def set_of(point: dict[str, Any]) -> str:
    """`b j2 contacts both`, the values without their keywords but for heal, of
    base-seed1-lawsb_plasticity_j2_flow_contacts_viscosity_both."""
    preset, *words = run_name(point).split("-laws")[1].split("_")
    pairs = zip(words[::2], words[1::2])
    return " ".join([preset, *(f"heal {v}" if key == "heal" else v for key, v in pairs)])


def with_error(value: float, error: float) -> str:
    """An exponent and its standard error, as text."""
    return f"{value:+.2f} +- {error:.2f}"


def condition_of(point: dict[str, Any]) -> str:
    return run_name(point).split("-")[0]


def depth_of(members: Any, window: tuple[float, float]) -> Mean:
    """Depth of the layer (nm) in a window (ns), the error from blocks of it."""
    layers = [found for p in members if (found := layer.read(p["file"])) is not None]
    if not layers:
        raise Missing(f"{members[0]['file']}: no profile beside it")
    return Mean(*layer.window([(at.time, at.depth) for at in layers], *window, BLOCKS))


def scatter_at_equal(mu: Any) -> tuple[float, float]:
    """(root mean square of ln(mu/mean) over the conditions of equal kappas, its standard error)."""
    logs = np.log([mu[c].value for c in EQUAL])
    away = logs - logs.mean()
    size = math.sqrt(np.mean(away**2))
    error = math.sqrt(sum((d * mu[c].relative) ** 2 for d, c in zip(away, EQUAL)))
    return size, error / (len(EQUAL) * size)


def distance(mu: Any, paper: Any) -> tuple[float, float]:
    """(root mean square of mu/mu(Eq. 2) - 1 over all conditions, its standard error)."""
    away = {c: mu[c].value / paper[c] - 1 for c in mu}
    size = math.sqrt(np.mean(np.square(list(away.values()))))
    error = math.sqrt(sum((away[c] * mu[c].error / paper[c]) ** 2 for c in mu))
    return size, error / (len(mu) * size)


def exponent(small: Mean, large: Mean) -> tuple[float, float]:
    """(n of a power law from a quantity to four times as much, its standard error)."""
    n = math.log(large.value / small.value) / FOURFOLD
    return n, math.hypot(small.relative, large.relative) / FOURFOLD


def marker_of(name: str) -> dict[str, Any]:
    """Open squares: plasticity j2."""
    return dict(fmt="s", mfc="none") if "j2" in name else dict(fmt="o")


def style_of_laws(name: str) -> dict[str, Any]:
    """Colour: what flows and resists slip."""
    colour = COLOURS[("contacts" in name) + 2 * ("both" in name)]
    return dict(color=colour, **marker_of(name))


def style_of_links(name: str) -> dict[str, Any]:
    """Colour: whether worn contacts link again, and at which stress welds break."""
    colour = f"C{('0.554' in name) + 2 * ('never' in name)}"
    return dict(color=colour, **marker_of(name))


def draw(sets: Any, paper: Any, style: Callable[[str], dict[str, Any]], picture: str) -> None:
    """mu over Eq. 2 at each condition, a row of points for each set that ran in all of them."""
    sets = {name: mu for name, mu in sets.items() if set(CONDITIONS) <= set(mu)}
    figure, axes = pyplot.subplots(figsize=(10, 5), constrained_layout=True)
    for k, (name, mu) in enumerate(sets.items()):
        x = np.arange(len(CONDITIONS)) + 0.1 * (k - 0.5 * (len(sets) - 1))
        axes.errorbar(
            x,
            [mu[c].value / paper[c] for c in CONDITIONS],
            yerr=[mu[c].error / paper[c] for c in CONDITIONS],
            ms=5,
            capsize=2,
            label=name,
            **style(name),
        )
    axes.axhline(1, color="k", ls="--", lw=1, label="Eq. 2")
    axes.axvline(len(EQUAL) - 0.5, color="0.7", lw=1)
    axes.set_xticks(range(len(CONDITIONS)), CONDITIONS)
    axes.set(ylabel=r"$\mu/\mu$(Eq. 2)", ylim=(0, None))
    axes.grid(alpha=0.3, axis="y")
    axes.legend(fontsize=9, ncols=4, loc="lower center")
    save_figure(figure, picture)


def means(points: list[dict[str, Any]], window: tuple[float, float]) -> tuple[Any, Any, Any]:
    """{set: {condition: mean}} of mu and of the layer's depth (nm) in a window (ns), and
    {condition: mu of Eq. 2}."""
    sets: dict[Any, Any] = {}
    depths: dict[Any, Any] = {}
    paper: dict[Any, float] = {}
    for name, members in groups(points, set_of).items():
        found = groups(members, condition_of)
        sets[name] = {c: Mean(*mean_of(found[c])) for c in found}
        depths[name] = {c: depth_of(found[c], window) for c in found}
        paper |= {c: found[c][0]["mu_eq2"] for c in found}
    return sets, depths, paper


def values_of(sets: Any, paper: Any) -> list[str]:
    """Lines of the tables of mu and of its standard error at each condition."""
    values, errors = [], []
    for name, mu in sets.items():
        values.append([name, *(f"{mu[c].value:.3f}" if c in mu else "-" for c in CONDITIONS)])
        errors.append([name, *(f"{mu[c].error:.3f}" if c in mu else "-" for c in CONDITIONS)])
    values.append(["Eq. 2", *(f"{paper[c]:.3f}" if c in paper else "-" for c in CONDITIONS)])
    return [
        *table(["mu", *CONDITIONS], values),
        "",
        *table(["its standard error", *CONDITIONS], errors),
    ]


def compared(
    points: list[dict[str, Any]],
    window: tuple[float, float],
    style: Callable[[str], dict[str, Any]],
    picture: str,
) -> list[str]:
    """Draws the sets; tables of the scatter at equal kappa1 and kappa2, the exponents of mu in the
    viscosity and in E/sigma_0, the distance from Eq. 2 over all conditions (-: not all were run),
    the layer's depth, its exponent in the viscosity, mu of a third of the roughness over that of
    the base; mu at each condition."""
    sets, depths, paper = means(points, window)
    draw(sets, paper, style, picture)
    mus, layers = [], []
    for name, mu in sets.items():
        if not set(EQUAL) <= set(mu):
            continue
        size, error = scatter_at_equal(mu)
        away = distance(mu, paper) if set(BESIDE) <= set(mu) else None
        depth, smooth = depths[name], mu["smooth"].value / mu["base"].value
        smooth_error = smooth * math.hypot(mu["smooth"].relative, mu["base"].relative)
        mus.append(
            [
                name,
                f"{100 * size:.1f} +- {100 * error:.1f} %",
                with_error(*exponent(mu["thin"], mu["thick"])),
                with_error(*exponent(mu["soft"], mu["stiff"])),
                f"{100 * away[0]:.1f} +- {100 * away[1]:.1f} %" if away else "-",
            ]
        )
        layers.append(
            [
                name,
                f"{depth['base'].value:.1f} +- {depth['base'].error:.1f}",
                with_error(*exponent(depth["thin"], depth["thick"])),
                f"{smooth:.2f} +- {smooth_error:.2f}",
            ]
        )
    if not mus:
        raise Missing(f"no set of laws has a run of each of {', '.join(EQUAL)}")
    return [
        *table(["mu of a set", "scatter", "n of eta", "n of E/sigma_0", "RMS from Eq. 2"], mus),
        "",
        *table(["its layer", "depth, nm", "n of eta", "mu smooth/base"], layers),
        "",
        *values_of(sets, paper),
    ]


def screening(points: list[dict[str, Any]]) -> list[str]:
    """Lines of a table: the distance from Eq. 2 of each set over base, slow, dense and strong, by
    the first seed alone, by which the plan laws-links chose."""
    chosen = []
    for name, members in groups(points, set_of).items():
        first = [p for p in members if "-seed1-" in run_name(p)]
        mu = {condition_of(p): Mean(*mean_of([p])) for p in first if condition_of(p) in SCREENED}
        if len(mu) == len(SCREENED):
            size, error = distance(mu, {condition_of(p): p["mu_eq2"] for p in first})
            chosen.append([name, f"{100 * size:.0f} +- {100 * error:.0f} %"])
    return table([f"{', '.join(SCREENED)}, seed 1", "RMS from Eq. 2"], chosen)


def laws(report: dict[str, Any], picture: str) -> list[str]:
    """The sets of the plan laws."""
    return compared(report["report"]["points"], (BEGIN, END), style_of_laws, picture)


def links(report: dict[str, Any], picture: str) -> list[str]:
    """The best of these sets, and this and others with other laws of links, of the plan
    laws-links."""
    points = [
        p
        for p in report["report"]["points"]
        if set_of(p) == BEST or any(law in run_name(p) for law in ("_weld_", "_worn_", "_heal_"))
    ]
    lines = compared(points, (LINKS_BEGIN, LINKS_END), style_of_links, picture)
    return [*lines, "", *screening(points)]
