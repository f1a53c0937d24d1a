# SPDX-License-Identifier: GPL-2.0-or-later
"""When a sliding layer is no solid any more: the bounds of src/shared/layer_health.h."""

import math
from collections.abc import Mapping, Sequence

SINK = 0.03  # that a layer may shrink by beyond p/K
SMOOTH = 0.05  # of the way, that a layer may slide without a link broken
FALL = 1e-3  # of the work of the drive, that a term of the account may fall by
ENERGIES = ("flow_energy", "breaking_energy", "contact_energy")
NEEDED = (*ENERGIES, "displacement", "shear_stress")  # columns of the log, for fall()


def least_room(pressure: float, youngs_modulus: float, poissons_ratio: float) -> float:
    """Least room of a layer that is a solid: 1 - p/K - SINK."""
    return 1 - pressure * 3 * (1 - 2 * poissons_ratio) / youngs_modulus - SINK


def fall(columns: Mapping[str, Sequence[float]], area: float) -> float:
    """The most that a term of the account fell by, over the work of the drive on an area (nm2); 0
    without an account."""
    way, work = [0.0, *columns["displacement"]], 0.0
    for before, after, shear in zip(way, way[1:], columns["shear_stress"]):
        work += shear * area * (after - before)
    if not work:
        return 0.0
    most_fallen = 0.0
    for name in ENERGIES:
        most = 0.0
        for value in columns[name]:
            most_fallen = max(most_fallen, most - value)
            most = max(most, value)
    return most_fallen / abs(work)


def smooth_share(broken: Sequence[float], way: float, diameter: float) -> float:
    """Share of the rows in which a layer slid without a link broken, by an automaton's diameter at
    least; it slides by `way` in a row (of one unit with the diameter)."""
    smooth = phase = 0
    for count in [*broken, math.inf]:
        if count == 0:
            phase += 1
            continue
        smooth += phase if phase * way >= diameter else 0
        phase = 0
    return smooth / len(broken) if broken else 0.0
