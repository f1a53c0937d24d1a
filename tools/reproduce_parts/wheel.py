# SPDX-License-Identifier: GPL-2.0-or-later
"""Fig. 15 on the paper's wheel (Table 2, a line contact): the law of the rail steel beside the
paper's. Its runs of wr_creep take seconds."""

import os
import tempfile
from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr import tables
from mcawr.files import save_figure

from . import locomotive_runs as made, patch_runs
from .common import table

CASE = os.path.join(patch_runs.ROOT, "examples", "wheelrail", "table2.yaml")
SPEEDS = (10, 20, 40)  # m/s
SLOPE, SEEDS = 0.02, (1, 2, 3, 4)
SHOWN = (0.1, 0.2)  # creeps at which the table says how far T/N has fallen
CHANGES = (
    "thermal={model: local, conductivity: 50 W/(m K), density: 7800 kg/m3, "
    "specific_heat: 450 J/(kg K)}",
    "contact.hardness_limit=true",
    "creep={from: 2e-4, to: 0.2, n: 37, spacing: log}",
    f"speed=[{', '.join(f'{v} m/s' for v in SPEEDS)}]",
)


def curves(folder: str, law: str, seed: int) -> dict[float, Any]:
    """T/N over creep at each speed; seed 0: smooth."""
    rough = "none"
    if seed:
        rough = f"{{hurst: {patch_runs.HURST}, rms_slope: {SLOPE}, seed: {seed}, "
        rough += "wavelength_min: 0.1 mm, wavelength_max: 10 mm}"
    changes = (f"friction={{{law}}}", f"roughness={rough}", *CHANGES)
    patch_runs.call(patch_runs.words_of(CASE, changes, "-o", folder, "-q"))
    found: dict[float, list[tuple[float, float]]] = {v: [] for v in SPEEDS}
    for row in tables.rows(os.path.join(folder, "creep.csv")):
        found[row.number("speed")].append((row.number("creep"), row.number("traction_ratio")))
    return {speed: np.array(points).T for speed, points in found.items()}


def fallen(curves_of_seeds: Any) -> list[str]:
    """The mean of the largest T/N, and the range of T/N at each of SHOWN over it, %."""
    peaks = [ratio.max() for _, ratio in curves_of_seeds]
    cells = [f"{np.mean(peaks):.3f}"]
    for shown in SHOWN:
        shares = [
            100 * np.interp(shown, creep, ratio) / peak
            for (creep, ratio), peak in zip(curves_of_seeds, peaks)
        ]
        ends = sorted({f"{min(shares):.1f}", f"{max(shares):.1f}"}, key=float)
        cells.append(" to ".join(ends) + " %")
    return cells


def fig15(found: dict[str, Any], picture: str) -> list[str]:
    figure, panels = pyplot.subplots(1, 2, figsize=(11, 4.4), sharey=True, constrained_layout=True)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        ours, _law = made.fit(made.MODELS[0], found[made.LOGS_PLAN], folder)
        laws = {
            "law of the rail steel": f"law: {ours}",
            "the paper's, local": "law: bucher2006, local: true",
        }
        for axes, (name, law) in zip(panels, laws.items()):
            for surface, line, seeds in (("smooth", "-", (0,)), (f"slope {SLOPE}", "--", SEEDS)):
                of_seeds = [curves(os.path.join(folder, "run"), law, seed) for seed in seeds]
                for k, speed in enumerate(SPEEDS):
                    same = np.array([one[speed] for one in of_seeds])
                    creep, ratio = same.mean(axis=0)
                    label = f"{surface}, {speed} m/s"
                    axes.plot(100 * creep, ratio, line, color=f"C{k}", label=label)
                    rows.append([f"{name}, {label}", *fallen(same)])
            axes.set(xlabel="creep, %", title=name, xlim=(0, 20), ylim=(0, 0.45))
            axes.grid(alpha=0.3)
            axes.legend(fontsize=8, ncols=2, loc="lower right")
    panels[0].set_ylabel("T/N")
    save_figure(figure, picture)
    pyplot.close(figure)
    return table(["", "largest T/N", *(f"at {100 * x:g} % creep, over it" for x in SHOWN)], rows)
