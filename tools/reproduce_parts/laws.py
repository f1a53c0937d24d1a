# SPDX-License-Identifier: GPL-2.0-or-later
"""Sets of laws in wide fragments, the plans `laws` and `laws-long`: which go on, by the rules on
doc/how_chosen.md."""

import dataclasses
import math
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import groups, mean_of, spread_of

from . import layer
from .common import Missing, planned, quotient, run_name, table, with_own_errors

FIRST = ("base", "soft", "strong", "dense", "faint")  # conditions of the first step
SECOND = ("thin", "thick", "smooth", "stiff", "light", "slow")
EQUAL = ("base", "thin", "thick", "soft", "stiff", "smooth")  # kappa1 = 2.571, kappa2 = 123.6
START = "80"  # nm, the second half of 160
LONG = "250"  # of 500
BLOCKS = 4  # of the layer's depth in the second half
FOURFOLD = math.log(4.0)  # viscosity of thick over thin
ALIKE = 0.09  # soft over base
SHORT = {
    "heal 1 healed_strain yield_strain": "heal",
    "link 1 weld none heal none": "one kind",
    "weld 1": "weld",
    "flow ": "",
    "viscosity ": "",
    "worn ": "",
}
BESIDE = ("d", "c", "b")  # go on whatever they give
NO_SOLID = "!: no solid"  # in the log of a run at least


@dataclasses.dataclass
class Mean:
    """A mean, or what is made of some, and its standard error; of mu or of a depth in nm."""

    value: float
    error: float

    @property
    def relative(self) -> float:
        """Standard error of the logarithm."""
        return self.error / self.value

    @property
    def percent(self) -> str:
        return f"{100 * self.value:.0f}({100 * self.error:.0f}) %"


def short(laws: str) -> str:
    """`d normal weld never` of d viscosity normal weld 1 worn never."""
    for words, name in SHORT.items():
        laws = laws.replace(words, name)
    return laws


def is_solid(point: dict[str, Any]) -> bool:
    """No automaton left, and the layer has the room of a solid, as far as the log says it."""
    room = point["room"]
    return not point["lost"] and not point["left_out"] and (room or 1) >= point["least_room"]


def ratio(over: Mean, under: Mean) -> Mean:
    """Of two independent means."""
    return Mean(*quotient((over.value, over.error), (under.value, under.error)))


def exponent(small: Mean, large: Mean) -> Mean:
    """Of a power law, from a quantity to four times as much."""
    n = math.log(large.value / small.value) / FOURFOLD
    return Mean(n, math.hypot(small.relative, large.relative) / FOURFOLD)


def log_scatter(mu: list[Mean]) -> Mean:
    """Root mean square of ln(mu/mean)."""
    logs = np.log([m.value for m in mu])
    away = logs - logs.mean()
    size = math.sqrt(np.mean(away**2))
    error = math.sqrt(sum((d * m.relative) ** 2 for d, m in zip(away, mu)))
    return Mean(size, error / (len(mu) * size))


def distance(mu: dict[str, Mean], paper: dict[str, float]) -> Mean:
    """Root mean square of mu/mu(Eq. 2) - 1 over all conditions."""
    away = {c: mu[c].value / paper[c] - 1 for c in mu}
    size = math.sqrt(np.mean(np.square(list(away.values()))))
    error = math.sqrt(sum((away[c] * mu[c].error / paper[c]) ** 2 for c in mu))
    return Mean(size, error / (len(mu) * size))


def depth_of(points: list[dict[str, Any]], ns: float) -> Mean:
    """Depth of the layer (nm) in the second half of runs of that long, one a seed."""
    series = []
    for point in points:
        if (found := layer.read(point["file"])) is None:
            raise Missing(f"{point['file']}: no profile beside it")
        series.append((found.time, found.depth))
    return Mean(*layer.window(series, ns / 2, ns, BLOCKS))


def seeds_of(points: list[dict[str, Any]]) -> tuple[float, float]:
    """Standard deviation of mu of runs that differ in the seed, over their mean, and how many times
    as much as their own errors say."""
    mean, own, scatter = spread_of(points)
    return scatter * math.sqrt(len(points)) / mean, scatter / own


def shown(mu: Mean) -> str:
    """0.31(2), the error in units of the last digit, at least one."""
    return f"{mu.value:.2f}({max(1, math.ceil(100 * mu.error - 0.5))})"


def reaches(mean: Mean, low: float, high: float) -> bool:
    """A bar is met, or within a standard error."""
    return low - mean.error <= mean.value <= high + mean.error


class Found:
    """A set of laws: mu at its conditions, and what the rules of the first step ask for."""

    def __init__(self, laws: str, points: list[dict[str, Any]], of: dict[str, Any]) -> None:
        by = groups(points, lambda p: run_name(p).split("-")[0])
        self.name = short(laws)
        self.mu = {c: Mean(*mean_of(by[c])) for c in (*FIRST, *SECOND) if c in by}
        self.paper = {c: by[c][0]["mu_eq2"] for c in self.mu}
        self.seeds = [seeds_of(runs) for runs in by.values() if len(runs) > 1]
        self.solid = all(map(is_solid, points))
        self.soft = ratio(self.mu["soft"], self.mu["base"]) if "soft" in self.mu else None
        first = {c: mu for c, mu in self.mu.items() if c in FIRST}
        self.away = distance(first, self.paper) if len(first) == len(FIRST) else None
        self.powers: tuple[Mean, Mean] | None = None  # of mu and of the depth, in the viscosity
        if "thin" in by and "thick" in by:
            depths = [depth_of(by[c], of[run_name(by[c][0])]["ns"]) for c in ("thin", "thick")]
            self.powers = exponent(self.mu["thin"], self.mu["thick"]), exponent(*depths)

    @property
    def label(self) -> str:
        """The name, marked where it is no solid."""
        return self.name + ("" if self.solid else f" {NO_SOLID[0]}")

    @property
    def is_whole(self) -> bool:
        """All conditions ran."""
        return len(self.mu) == len(FIRST) + len(SECOND)

    @property
    def rank(self) -> tuple[bool, bool, bool, float]:
        """In the order of the first step: solid, complete, alike at equal kappas, near to Eq. 2."""
        if not self.away or not self.soft:
            return not self.solid, True, True, 0.0
        alike = abs(self.soft.value - 1) <= max(ALIKE, self.soft.error)
        return not self.solid, False, not alike, self.away.value


class Whole:
    """A set of laws of which all conditions ran: what does not change, and how many of that the
    paper says so."""

    def __init__(self, found: Found) -> None:
        assert found.powers  # thin and thick are among them
        mu = found.mu
        self.found = found
        self.eta, self.depth = found.powers
        self.scatter = log_scatter([mu[c] for c in EQUAL])
        self.smooth = ratio(mu["smooth"], mu["base"])
        self.away = distance(mu, found.paper)
        self.kept = (
            reaches(self.scatter, 0, 0.045)
            + reaches(self.eta, -0.05, 0.05)
            + reaches(self.smooth, 0.95, 1.05)
            + reaches(self.depth, 0.4, math.inf)
        )

    @property
    def rank(self) -> tuple[bool, int, float]:
        """In the order of the second step."""
        return not self.found.solid, -self.kept, self.away.value


def sets_of(plan: str, points: list[dict[str, Any]]) -> list[Found]:
    """Those of a plan with a run of base, in the order of the first step."""
    of = planned(plan, points)
    found = groups(with_own_errors(points), lambda p: of[run_name(p)]["laws"])
    begun = {laws: runs for laws, runs in found.items() if any("base" in run_name(p) for p in runs)}
    if not begun:
        raise Missing("no set of laws has a run of base")
    return sorted((Found(laws, runs, of) for laws, runs in begun.items()), key=lambda s: s.rank)


def draw(sets: list[Found], picture: str) -> None:
    """mu over Eq. 2 at each condition, a row for each set; where they are few, a condition has its
    own height in it."""
    few = len(sets) <= 10
    height = 1.5 + (0.7 if few else 0.24) * len(sets)
    figure, axes = pyplot.subplots(figsize=(8, height), layout="constrained")
    conditions = (*FIRST, *SECOND)
    shifts = np.linspace(-0.36, 0.36, len(conditions)) if few else np.zeros(len(conditions))
    for number, condition in enumerate(conditions):
        rows = [(k, s) for k, s in enumerate(sets) if condition in s.mu]
        if not rows:
            continue
        axes.errorbar(
            [s.mu[condition].value / s.paper[condition] for _, s in rows],
            [k + shifts[number] for k, _ in rows],
            xerr=[s.mu[condition].error / s.paper[condition] for _, s in rows],
            fmt="osD^v<>phdX"[number],
            color=f"C{number}" if number < 10 else "k",
            ms=4,
            lw=1,
            mfc=None if condition in FIRST else "none",
            label=condition,
        )
    axes.axvline(1, color="k", ls="--", lw=1)
    axes.set_yticks(range(len(sets)), [s.name for s in sets], fontsize=8)
    axes.set(xlabel=r"$\mu/\mu$(Eq. 2)", xlim=(0, None), ylim=(len(sets) - 0.5, -0.5))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, ncols=6, loc="lower center", bbox_to_anchor=(0.5, 1))
    save_figure(figure, picture)


def mu_of(sets: list[Found], conditions: tuple[str, ...]) -> list[list[str]]:
    """Cells of the table of mu, a row for each set, and that of Eq. 2."""
    paper = {c: f"{s.paper[c]:.2f}" for s in sets for c in s.paper}
    rows = [[shown(s.mu[c]) if c in s.mu else "-" for c in conditions] for s in sets]
    return [*rows, [paper.get(c, "-") for c in conditions]]


def first_step(sets: list[Found]) -> list[str]:
    """Lines of the table of the first step."""
    rows = []
    for s, mu in zip(sets, mu_of(sets, FIRST)):
        alike = f"{s.soft.value:.2f}({100 * s.soft.error:.0f})" if s.soft else "-"
        away = s.away.percent.removesuffix(" %") if s.away else "-"
        rows.append([s.label, *mu, alike, away])
    rows.append(["Eq. 2", *mu_of(sets, FIRST)[-1], "1.00", ""])
    whole = [s for s in sets if s.away and s.solid and s.name not in BESIDE]
    done = sum(len(s.mu.keys() & set(FIRST)) for s in sets)
    return [
        *table(["mu, errors of the last digit", *FIRST, "soft/base", "RMS %"], rows),
        "",
        "RMS of mu over Eq. 2 less 1; weld: 1, heal: 1 healed_strain yield_strain, one kind: link",
        f"1 weld none heal none; {NO_SOLID}",
        f"{done} runs, {len(whole)} of 37 sets beside {', '.join(BESIDE)} complete and solid",
    ]


def mu_table(sets: list[Found], conditions: tuple[str, ...]) -> list[str]:
    """Lines of the table of mu, a row for each set and one for Eq. 2."""
    rows = zip([*(s.label for s in sets), "Eq. 2"], mu_of(sets, conditions))
    return table(["mu, errors of the last digit", *conditions], [[n, *mu] for n, mu in rows])


def second_step(sets: list[Found]) -> list[str]:
    """Lines of the table of the second step, of the sets that ran there: mu, and the exponents of
    mu and of the layer's depth in the viscosity."""
    conditions = tuple(c for c in SECOND if any(c in s.mu for s in sets))
    rows = [
        [s.label, *mu, *(map(shown, s.powers) if s.powers else ("-", "-"))]
        for s, mu in zip(sets, mu_of(sets, conditions))
    ]
    rows.append(["Eq. 2", *mu_of(sets, conditions)[-1], "0.00", ""])
    return table(["mu, errors of the last digit", *conditions, "n of eta", "n of depth"], rows)


def invariances(sets: list[Found]) -> list[str]:
    """Lines of the table of invariances, of sets of which all conditions ran, in the order of the
    second step; none without."""
    whole = sorted((Whole(s) for s in sets if s.is_whole), key=lambda w: w.rank)
    rows = [
        [
            w.found.label,
            w.scatter.percent,
            shown(w.eta),
            shown(w.smooth),
            shown(w.depth),
            str(w.kept),
            w.away.percent,
        ]
        for w in whole
    ]
    head = ["set", "equal kappas", "n of eta", "smooth/base", "n of depth", "kept", "RMS of 11"]
    return ["", *table(head, rows)] if rows else []


def laws(report: dict[str, Any], picture: str) -> list[str]:
    """mu of each set at the conditions of the first step, in the order of its rule, and of the
    sets that went on at those of the second."""
    sets = sets_of("laws", report["report"]["points"])
    draw(sets, picture)
    more = [s for s in sets if s.mu.keys() & set(SECOND)]
    return [*first_step(sets), *(["", *second_step(more)] if more else [])]


def seeds_differ(found: Found) -> str:
    """How much runs of one condition differ, and how many times as much as their own errors say:
    root mean squares over conditions."""
    apart, times = (
        math.sqrt(np.mean([value**2 for value in values])) for values in zip(*found.seeds)
    )
    return (
        f"{found.name}: seeds differ by {100 * apart:.1f} % of mu, "
        f"{times:.1f} times what their own errors say ({len(found.seeds)} conditions)"
    )


def laws_long(report: dict[str, Any], picture: str) -> list[str]:
    """The same of the third step, over 500 nm; and how much seeds differ."""
    sets = sets_of("laws-long", report["report"]["points"])
    draw(sets, picture)
    away = [
        f"{s.name}: {distance(s.mu, s.paper).percent} from Eq. 2 at {len(s.mu)} conditions"
        for s in sets
    ]
    tables = [*mu_table(sets, FIRST), "", *mu_table(sets, SECOND)]
    seeds = [seeds_differ(s) for s in sets if s.seeds]
    marked = [] if all(s.solid for s in sets) else [NO_SOLID]
    return [*tables, "", *away, *seeds, *marked, *invariances(sets)]
