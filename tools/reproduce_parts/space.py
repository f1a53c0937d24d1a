# SPDX-License-Identifier: GPL-2.0-or-later
"""Friction in three dimensions beside that in the plane and Eq. 2."""

from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.friction_log import head_of
from mcawr.replicas import NORMAL, groups, mean_of

from . import layer
from .common import Missing, percent, quotient, run_name, table, with_own_errors

OTHER_SIZES = {"wide": "twice the area", "tall": "12 layers more", "strong-wide": "twice the area"}
QUANTITIES = {"velocity": "v (m/s)", "pressure": "p (MPa)", "strength": r"$\sigma_0$ (MPa)"}


def condition(point: dict[str, Any]) -> tuple[float, ...]:
    """Velocity (m/s), pressure (MPa), strength (MPa)."""
    return tuple(point[name] for name in QUANTITIES)


def is_space(point: dict[str, Any]) -> bool:
    """Is it a run in three dimensions?"""
    return bool(head_of(point["file"])["geometry"]["packing"] != "hex")


def conditions(points: list[dict[str, Any]]) -> tuple[Any, Any]:
    """{condition: points} of the runs in space and of those in the plane that share one."""
    found = groups(points, lambda p: (is_space(p), *condition(p)))
    inside = {key[1:]: members for key, members in found.items() if key[0]}
    plane = {key[1:]: members for key, members in found.items() if key[1:] in inside and not key[0]}
    if not inside:
        raise Missing("no friction log of three dimensions")
    return inside, plane


def depth_of(members: Any) -> tuple[float, float] | None:
    """(mean depth of the layer in nm over the second halves, its standard error) or None."""
    layers = [read for p in members if (read := layer.read(p["file"])) is not None]
    return layer.mean_depth(layers) if layers else None


def draw(inside: Any, plane: Any, picture: str) -> None:
    """mu against each quantity that is varied alone: space, plane, Eq. 2."""
    base = tuple(np.median(column) for column in zip(*inside))
    figure, panels = pyplot.subplots(1, 3, figsize=(10, 3.8), sharey=True, constrained_layout=True)
    for k, (axes, label) in enumerate(zip(panels, QUANTITIES.values())):
        alone = [c for c in inside if all(c[m] == base[m] for m in range(3) if m != k)]
        x = [c[k] for c in alone]
        axes.plot(x, [inside[c][0]["mu_eq2"] for c in alone], "-", color="0.4", label="Eq. 2")
        for name, found, style in (("space", inside, "s"), ("plane", plane, "o")):
            known = [c for c in alone if c in found]
            axes.errorbar(
                [c[k] for c in known],
                [mean_of(found[c])[0] for c in known],
                yerr=[NORMAL * mean_of(found[c])[1] for c in known],
                fmt=style,
                mfc="none" if name == "plane" else None,
                capsize=3,
                label=name,
            )
        axes.set_xlabel(label)
        axes.grid(alpha=0.3)
    panels[0].set_ylabel(r"$\mu$")
    panels[0].set_ylim(bottom=0)
    panels[0].legend()
    save_figure(figure, picture)
    pyplot.close(figure)


def other_sizes(points: list[dict[str, Any]], inside: Any) -> list[str]:
    """mu and depth of the layer in blocks of another size, over mu in those of the same condition;
    nothing for none."""
    rows = []
    for point in points:
        against = inside.get(condition(point))
        mu, error = point["mu"], point["mu_se"]
        depth = depth_of([point])
        row = [
            f"{OTHER_SIZES[run_name(point)]}, {name_of(condition(point))}",
            f"{mu:.3f} +- {error:.3f}",
            "-",
            "-" if depth is None else "{:.1f} +- {:.1f}".format(*depth),
        ]
        if against:
            ratio, ratio_error = quotient((mu, error), mean_of(against))
            row[2] = f"{percent(ratio, 1).removesuffix(' %')} +- {100 * ratio_error:.1f} %"
        rows.append(row)
    return ["", *table(["", "space", "over the above", "depth, nm"], rows)] if rows else []


def name_of(key: tuple[float, ...]) -> str:
    """A condition in words."""
    return "{:g} m/s, {:g} MPa, sigma_0 {:g} MPa".format(*key)


def space(report: dict[str, Any], picture: str) -> list[str]:
    """mu in space and in the plane at the same pressure, velocity and strength, beside Eq. 2, and
    the depth of the layer in space; means over the seeds. Then other sizes of the blocks."""
    # one pair of seeds in space tells nothing of what seeds differ by
    points = with_own_errors(report["report"]["points"])
    others = [p for p in points if run_name(p) in OTHER_SIZES and is_space(p)]
    inside, plane = conditions([p for p in points if p not in others])
    draw(inside, plane, picture)
    rows = []
    for key, members in inside.items():
        mu, error = mean_of(members)
        paper = members[0]["mu_eq2"]
        flat = "{:.3f} +- {:.3f}".format(*mean_of(plane[key])) if key in plane else "-"
        depth = depth_of(members)
        rows.append(
            [
                name_of(key),
                str(len(members)),
                f"{mu:.3f} +- {error:.3f}",
                flat,
                f"{paper:.3f}",
                percent(mu, paper),
                "-" if depth is None else "{:.1f} +- {:.1f}".format(*depth),
            ]
        )
    head = ["", "seeds", "space", "plane", "Eq. 2", "", "depth, nm"]
    return [
        "errors: what a run knows of itself; of two seeds, what they differ by",
        *table(head, rows),
        *other_sizes(others, inside),
    ]
