# SPDX-License-Identifier: GPL-2.0-or-later
"""Sets of laws crossed: which rubs alike at equal kappa1 and kappa2, and how near to Eq. 2."""

import dataclasses
import math

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import groups, spread_of

from . import layer
from .common import Missing, run_name, table

EQUAL = ("base", "thin", "thick", "soft", "stiff", "smooth")  # kappa1 = 2.571, kappa2 = 123.6
BESIDE = ("slow", "dense", "strong")
BEGIN, END, BLOCKS = 75.0, 150.0, 5  # ns of the averages, blocks of the layer's depth
FOURFOLD = math.log(4.0)  # thick has four times the viscosity of thin, stiff four times soft's E/sigma_0


@dataclasses.dataclass
class Mean:
    """A mean over the seeds, of mu or of a depth in nm, and its standard error."""

    value: float
    error: float

    @property
    def relative(self):
        """Standard error of the logarithm."""
        return self.error / self.value


def set_of(point):
    """`b plasticity j2` of base-seed1-lawsb_plasticity_j2."""
    return run_name(point).split("-laws")[1].replace("_", " ")


def condition_of(point):
    return run_name(point).split("-")[0]


def mean_of_seeds(members):
    """mu by the scatter of the seeds: runs of one condition differ by more than their own errors
    say."""
    mean, _, scatter = spread_of(members)
    return Mean(mean, scatter)


def depth_of(members):
    """Depth of the layer (nm) over the averages' time, the error from the scatter of the seeds."""
    layers = [found for p in members if (found := layer.read(p["file"])) is not None]
    depths = [layer.window([(at.time, at.depth)], BEGIN, END, BLOCKS)[0] for at in layers]
    if len(depths) < 2:
        return None
    return Mean(float(np.mean(depths)), float(np.std(depths, ddof=1) / math.sqrt(len(depths))))


def scatter_at_equal(mu):
    """(root mean square of ln(mu/mean) over the conditions of equal kappas, its standard error)."""
    logs = np.log([mu[c].value for c in EQUAL])
    away = logs - logs.mean()
    size = math.sqrt(np.mean(away**2))
    error = math.sqrt(sum((d * mu[c].relative) ** 2 for d, c in zip(away, EQUAL))) / (6 * size)
    return size, error


def distance(mu, paper):
    """(root mean square of mu/mu(Eq. 2) - 1 over all conditions, its standard error)."""
    away = {c: mu[c].value / paper[c] - 1 for c in mu}
    size = math.sqrt(np.mean(np.square(list(away.values()))))
    error = math.sqrt(sum((away[c] * mu[c].error / paper[c]) ** 2 for c in mu))
    return size, error / (len(mu) * size)


def exponent(small, large):
    """(n of a power law from a quantity to four times as much, its standard error)."""
    n = math.log(large.value / small.value) / FOURFOLD
    return n, math.hypot(small.relative, large.relative) / FOURFOLD


def draw(sets, paper, picture):
    """mu over Eq. 2 at each condition, a row of points for each set."""
    figure, axes = pyplot.subplots(figsize=(10, 5), constrained_layout=True)
    conditions = [*EQUAL, *BESIDE]
    for k, (name, mu) in enumerate(sets.items()):
        x = np.arange(len(conditions)) + 0.1 * (k - 0.5 * (len(sets) - 1))
        axes.errorbar(
            x,
            [mu[c].value / paper[c] for c in conditions],
            yerr=[mu[c].error / paper[c] for c in conditions],
            fmt="os^v"[k % 4],
            mfc="none" if "viscosity both" in name else None,
            color=f"C{k % 4}",
            ms=4,
            capsize=2,
            label=name,
        )
    axes.axhline(1, color="k", ls="--", lw=1, label="Eq. 2")
    axes.axvline(len(EQUAL) - 0.5, color="0.7", lw=1)
    axes.set_xticks(range(len(conditions)), conditions)
    axes.set(ylabel=r"$\mu/\mu$(Eq. 2)", ylim=(0, None))
    axes.grid(alpha=0.3, axis="y")
    axes.legend(fontsize=8, ncols=2)
    save_figure(figure, picture)


def laws(report, picture):
    """Of each set of laws: the scatter at equal kappa1 and kappa2, the exponents of mu in the
    viscosity and in E/sigma_0, of the layer's depth in the viscosity, mu of a third of the
    roughness over that of the base, and the distance from Eq. 2 over all conditions; mu at each."""
    points = report["report"]["points"]
    sets, depths, paper = {}, {}, {}
    for name, members in groups(points, set_of).items():
        found = groups(members, condition_of)
        if set(found) != {*EQUAL, *BESIDE} or min(map(len, found.values())) < 2:
            raise Missing(f"laws '{name}': not every condition has two runs or more")
        sets[name] = {c: mean_of_seeds(found[c]) for c in found}
        depths[name] = {c: depth_of(found[c]) for c in found}
        paper |= {c: found[c][0]["mu_eq2"] for c in found}
    draw(sets, paper, picture)
    rows, values = [], []
    for name, mu in sets.items():
        size, error = scatter_at_equal(mu)
        rms, rms_error = distance(mu, paper)
        depth = depths[name]
        rows.append(
            [
                name,
                f"{100 * size:.1f} +- {100 * error:.1f} %",
                "{:+.2f} +- {:.2f}".format(*exponent(mu["thin"], mu["thick"])),
                "{:+.2f} +- {:.2f}".format(*exponent(mu["soft"], mu["stiff"])),
                "{:+.2f} +- {:.2f}".format(*exponent(depth["thin"], depth["thick"]))
                if depth["thin"] and depth["thick"]
                else "-",
                f"{depth['base'].value:.1f}" if depth["base"] else "-",
                f"{mu['smooth'].value / mu['base'].value:.2f} +- "
                f"{math.hypot(mu['smooth'].relative, mu['base'].relative):.2f}",
                f"{100 * rms:.1f} +- {100 * rms_error:.1f} %",
            ]
        )
        values.append([name, *(f"{mu[c].value:.3f} +- {mu[c].error:.3f}" for c in [*EQUAL, *BESIDE])])
    head = ["", "scatter", "eta", "E/sigma_0", "depth, eta", "depth, nm", "smooth/base", "RMS, Eq. 2"]
    conditions = [*EQUAL, *BESIDE]
    return [
        *table(head, rows),
        "",
        *table(["mu", *conditions], [["Eq. 2", *(f"{paper[c]:.3f}" for c in conditions)], *values]),
    ]
