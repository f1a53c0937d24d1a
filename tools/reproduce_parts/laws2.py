# SPDX-License-Identifier: GPL-2.0-or-later
"""The laws once more, in wide fragments: which sets of the plan `laws2` go on, by the rules on
doc/how_chosen.md."""

import math
from typing import Any

from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import groups, mean_of

from .common import Missing, planned, run_name, table, with_own_errors
from .laws import Mean, distance

FIRST = ("base", "soft", "strong", "dense", "faint")
START = "80"  # nm, the second half of 160
ALIKE = 0.09  # soft over base
SHORT = {
    "heal 1 healed_strain yield_strain": "heal",
    "weld 1": "weld",
    "flow ": "",
    "viscosity ": "",
    "worn ": "",
}
BESIDE = ("d", "c", "b")  # go on whatever they give


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
    value = over.value / under.value
    return Mean(value, value * math.hypot(over.relative, under.relative))


def shown(mu: Mean) -> str:
    """0.31(2), the error in units of the last digit, at least one."""
    return f"{mu.value:.2f}({max(1, math.ceil(100 * mu.error - 0.5))})"


class Found:
    """A set of laws in the first step: mu at its conditions, and what the rule asks for."""

    def __init__(self, laws: str, points: list[dict[str, Any]]) -> None:
        by = groups(points, lambda p: run_name(p).split("-")[0])
        self.name = short(laws)
        self.mu = {c: Mean(*mean_of(by[c])) for c in FIRST if c in by}
        self.paper = {c: by[c][0]["mu_eq2"] for c in self.mu}
        self.solid = all(map(is_solid, points))
        self.soft = ratio(self.mu["soft"], self.mu["base"]) if "soft" in self.mu else None
        self.away = distance(self.mu, self.paper) if len(self.mu) == len(FIRST) else None

    @property
    def rank(self) -> tuple[bool, bool, bool, float]:
        """In the order of the rule: solid, complete, alike at equal kappas, near to Eq. 2."""
        if not self.away or not self.soft:
            return not self.solid, True, True, 0.0
        alike = abs(self.soft.value - 1) <= max(ALIKE, self.soft.error)
        return not self.solid, False, not alike, self.away[0]


def sets_of(points: list[dict[str, Any]]) -> list[Found]:
    """Those with a run of base, in the order of the rule."""
    of = planned("laws2", points)
    found = groups(with_own_errors(points), lambda p: of[run_name(p)]["laws"])
    begun = {laws: runs for laws, runs in found.items() if any("base" in run_name(p) for p in runs)}
    if not begun:
        raise Missing("no set of laws has a run of base")
    return sorted((Found(laws, runs) for laws, runs in begun.items()), key=lambda s: s.rank)


def draw(sets: list[Found], picture: str) -> None:
    """mu over Eq. 2 at each condition, a row for each set."""
    figure, axes = pyplot.subplots(figsize=(8, 1.5 + 0.24 * len(sets)), layout="constrained")
    for number, condition in enumerate(FIRST):
        rows = [(k, s) for k, s in enumerate(sets) if condition in s.mu]
        axes.errorbar(
            [s.mu[condition].value / s.paper[condition] for _, s in rows],
            [k for k, _ in rows],
            xerr=[s.mu[condition].error / s.paper[condition] for _, s in rows],
            fmt="osD^v"[number],
            ms=4,
            lw=1,
            label=condition,
        )
    axes.axvline(1, color="k", ls="--", lw=1)
    axes.set_yticks(range(len(sets)), [s.name for s in sets], fontsize=8)
    axes.set(xlabel=r"$\mu/\mu$(Eq. 2)", xlim=(0, None), ylim=(len(sets) - 0.5, -0.5))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8, ncols=len(FIRST), loc="lower center", bbox_to_anchor=(0.5, 1))
    save_figure(figure, picture)


def laws2(report: dict[str, Any], picture: str) -> list[str]:
    """mu of each set at the conditions of the first step, in the order of the rule."""
    sets = sets_of(report["report"]["points"])
    draw(sets, picture)
    rows = []
    for s in sets:
        mu = [shown(s.mu[c]) if c in s.mu else "-" for c in FIRST]
        alike = f"{s.soft.value:.2f}({100 * s.soft.error:.0f})" if s.soft else "-"
        away = f"{100 * s.away[0]:.0f}({100 * s.away[1]:.0f}) %" if s.away else "-"
        rows.append([s.name + ("" if s.solid else " !"), *mu, alike, away])
    paper = {c: f"{s.paper[c]:.2f}" for s in sets for c in s.paper}
    rows.append(["Eq. 2", *(paper.get(c, "-") for c in FIRST), "1.00", ""])
    lines = table(["mu, errors of the last digit", *FIRST, "soft/base", "RMS"], rows)
    whole = [s for s in sets if s.away and s.solid and s.name not in BESIDE]
    done = sum(len(s.mu) for s in sets)
    return [
        *lines,
        "",
        "RMS of mu over Eq. 2 less 1; weld: 1, heal: 1 healed_strain yield_strain; !: no solid",
        f"{done} runs, {len(whole)} of 31 sets beside {', '.join(BESIDE)} complete and solid",
    ]
