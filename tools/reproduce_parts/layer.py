# SPDX-License-Identifier: GPL-2.0-or-later
"""The sliding layer of a run, from the profile beside its friction log."""

import dataclasses
import itertools
import math
from typing import Any

import numpy as np

import plot_layer
from mcawr.files import is_there
from mcawr.friction_log import head_of

from .common import Missing


@dataclasses.dataclass
class Layer:
    """Depth (nm) of the layer at the ends of the frames (ns)."""

    time: np.ndarray
    depth: np.ndarray


def read(log: str) -> Layer | None:
    """The layer of a run; None without a profile beside the log."""
    profile = log.removesuffix(".friction") + ".profile"
    if not is_there(profile):
        return None
    measures = plot_layer.measures(profile, plot_layer.read_frames(profile))
    step, depth = (np.array([m[key] for m in measures]) for key in ("step", "depth"))
    return Layer(step * float(head_of(log)["run"]["timestep"]), depth)


def window(series: Any, begin: float, end: float, blocks: int) -> tuple[float, float]:
    """(mean, its standard error) of several runs over begin < time <= end (ns).

    series: a pair of arrays for each run, times (ns) and values of any unit, of which every block
    holds one or more: raises Missing. The error is that of the mean of all blocks, equal parts of
    the window: too small if values correlate over longer than one."""
    edges = np.linspace(begin, end, blocks + 1) * (1 + 1e-9)
    parts = [
        values[(time > low) & (time <= high)]
        for time, values in series
        for low, high in itertools.pairwise(edges)
    ]
    if not all(map(len, parts)):
        raise Missing(f"nothing in a part of {begin:.3g} to {end:.3g} ns: more frames are needed")
    means = [part.mean() for part in parts]
    return float(np.mean(means)), float(np.std(means, ddof=1) / math.sqrt(len(means)))


def mean_depth(layers: Any, until: float = math.inf) -> tuple[float, float]:
    """(mean over the second halves of the runs up to a time in ns, its standard error from frames
    and runs)."""
    depths = [layer.depth[layer.time <= until * (1 + 1e-6)] for layer in layers]
    halves = [depth[len(depth) // 2 :] for depth in depths]
    means = [float(np.mean(h)) for h in halves]
    own = math.sqrt(sum(np.var(h, ddof=1) / len(h) if len(h) > 1 else 0.0 for h in halves)) / len(
        halves
    )
    scatter = float(np.std(means, ddof=1)) / math.sqrt(len(means)) if len(means) > 1 else 0.0
    return float(np.mean(means)), max(own, scatter)
