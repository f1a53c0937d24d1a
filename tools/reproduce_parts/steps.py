# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction against the time step, with plain and with corrected steps."""

import math
import re

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.friction_log import head_of
from mcawr.replicas import groups, mean_of

from .common import Missing, percent, run_name, scatter_of, table


def step_of(log):
    """Time step of a run (ns), from the head of its log."""
    return float(head_of(log)["run"]["timestep"])


def case_of(point):
    """What a run shares with those of other steps: `v5` of v5-dt5e-05-seed1."""
    return re.sub("-(dt.*|seed.*)", "", run_name(point))


def timestep(report, picture):
    """mu at the usual step, half and a quarter of it; for three steps what a straight line makes of
    it at none."""
    rows, lines, cases = [], [], {}
    found = groups(report["report"]["points"], case_of)
    for name, members in sorted(
        found.items(), key=lambda item: (item[0][0], len(item[0]), item[0])
    ):
        at = {
            step: mean_of(runs)
            for step, runs in groups(members, lambda p: step_of(p["file"])).items()
        }
        usual = max(at)
        if 0.25 * usual not in at:
            continue
        cases[name] = members[0], at[usual], at[0.25 * usual]
        full, half, quarter = (
            "{:.3f} +- {:.3f}".format(*at[f * usual]) if f * usual in at else ""
            for f in (1, 0.5, 0.25)
        )
        at_none = ""
        if half:
            dt, (mu, error) = np.array(list(at)), np.array(list(at.values())).T
            (_, none), covariance = np.polyfit(dt, mu, 1, w=1 / error, cov="unscaled")
            lines.append((members[0]["velocity"], none, math.sqrt(covariance[1, 1])))
            at_none = "{:.3f} +- {:.3f}".format(*lines[-1][1:])
        rows.append(
            [
                name,
                f"{members[0]['kappa3']:.0f}",
                f"{members[0]['mu_eq2']:.3f}",
                full,
                half,
                quarter,
                percent(at[0.25 * usual][0], at[usual][0]),
                at_none,
            ]
        )
    if not lines:
        raise Missing("no run at the plans' step, half and a quarter of it")
    equal = [entry[1:] for name, entry in cases.items() if re.match("v5|c", name)]
    (spread, own), (spread_quarter, own_quarter) = (
        scatter_of(*np.array([e[k] for e in equal]).T) for k in (0, 1)
    )
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    for axes, pattern, key in ((left, "v", "velocity"), (right, "v5|c", "kappa3")):
        shown = sorted(
            (p[key], p["mu_eq2"], full, small)
            for name, (p, full, small) in cases.items()
            if re.match(pattern, name)
        )
        x = np.array([entry[0] for entry in shown])
        for k, label in ((2, "usual step"), (3, "a quarter of it")):
            mu, error = np.array([entry[k] for entry in shown]).T
            axes.errorbar(
                x, mu, yerr=1.96 * error, fmt=f"C{k - 2}o", capsize=2, label=f"{label}, 95 %"
            )
        axes.plot(x, [entry[1] for entry in shown], "k--", lw=1, label="Eq. 2")
        axes.grid(alpha=0.3)
    velocity, none, error = np.array(lines).T
    left.errorbar(
        velocity,
        none,
        yerr=1.96 * error,
        fmt="C2s",
        mfc="none",
        capsize=2,
        label="line to no step, 95 %",
    )
    left.set(xlabel="v (m/s)", ylabel="$\\mu$", xlim=(0, None), ylim=(0, None))
    right.set(
        xlabel="$\\kappa_3 = E/\\sigma_0$ at equal $\\kappa_1$, $\\kappa_2$",
        ylabel="$\\mu$",
        ylim=(0, None),
    )
    left.legend(fontsize=9)
    save_figure(figure, picture)
    return [
        *table(
            ["mu", "kappa3", "Eq. 2", "usual step", "half", "a quarter", "", "none (line)"], rows
        ),
        "",
        f"Scatter of the {len(equal)} at equal kappa1 and kappa2: usual step {spread:.1f} % "
        f"(own errors {own:.1f} %),",
        f"a quarter of it {spread_quarter:.1f} % ({own_quarter:.1f} %)",
    ]


def steps_of(log):
    """`plain` or `corrected`: the keyword steps of the laws that made a log; the first logs, of
    plain ones, do not name it."""
    return head_of(log)["laws"].get("steps", "plain")


def corrected(report, picture):
    """mu with plain and with corrected steps: against the step at 5 and 10 m/s, and at the usual
    step against velocity."""
    points = [p for p in report["report"]["points"] if re.fullmatch("v[0-9]+", case_of(p))]
    if not any(steps_of(p["file"]) == "corrected" for p in points):
        raise Missing("no run with `steps corrected`")
    laws = ("plain", "corrected")
    usual = 5e-5
    mu = {
        key: mean_of(runs)
        for key, runs in groups(
            points, lambda p: (steps_of(p["file"]), p["velocity"], step_of(p["file"]))
        ).items()
    }
    steps = sorted({step for _, _, step in mu}, reverse=True)
    shown = [
        v
        for v in sorted({v for _, v, _ in mu})
        if sum(("corrected", v, step) in mu for step in steps) > 1
    ]
    eq2 = {p["velocity"]: p["mu_eq2"] for p in points}
    both = [v for v in eq2 if all((law, v, usual) in mu for law in laws)]
    if not both or not shown:
        raise Missing(
            f"no velocity with both laws at {1e6 * usual:g} fs, or none with `steps corrected` "
            "at two steps"
        )

    def text(law, velocity, step):
        return (
            "{:.3f} +- {:.3f}".format(*mu[law, velocity, step])
            if (law, velocity, step) in mu
            else ""
        )

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    rows = []
    for k, law in enumerate(laws):
        for marker, v in zip("osD", shown):
            rows.append([f"{v:g} m/s, {law}", *(text(law, v, step) for step in steps)])
            known = [(1e6 * step, *mu[law, v, step]) for step in steps if (law, v, step) in mu]
            x, value, error = np.array(known).reshape(-1, 3).T
            left.errorbar(
                x,
                value,
                yerr=1.96 * error,
                fmt=f"C{k}{marker}-",
                lw=0.8,
                capsize=2,
                label=f"{v:g} m/s, {law}",
            )
    velocities = []
    for k, law in enumerate(laws):
        x, value, error = np.array([(v, *mu[law, v, usual]) for v in sorted(both)]).T
        right.errorbar(x, value, yerr=1.96 * error, fmt=f"C{k}o", capsize=2, label=f"{law}, 95 %")
    right.plot(sorted(both), [eq2[v] for v in sorted(both)], "k--", lw=1, label="Eq. 2")
    for v in sorted(both):
        velocities.append(
            [
                f"{v:g} m/s",
                f"{eq2[v]:.3f}",
                *(text(law, v, usual) for law in laws),
                percent(mu["corrected", v, usual][0], mu["plain", v, usual][0]),
            ]
        )
    left.set(xlabel="step (fs)", ylabel="$\\mu$, 95 %", xlim=(0, None))
    right.set(xlabel="v (m/s)", ylabel="$\\mu$", xlim=(0, None), ylim=(0, None))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=9)
    save_figure(figure, picture)
    return [
        *table(["mu", *(f"{1e6 * step:g} fs" for step in steps)], rows),
        "",
        *table([f"{1e6 * usual:g} fs", "Eq. 2", *laws, ""], velocities),
    ]
