# SPDX-License-Identifier: GPL-2.0-or-later
"""All conditions of the default laws: mu over a law of kappa1 and kappa2, against the ductility."""

from typing import Any

import numpy as np
from matplotlib import pyplot

from mcawr.files import save_figure
from mcawr.replicas import NORMAL

from .common import STEEL, Missing, plan_name, power_law, table
from .law_lines import law_lines

REFERENCE = 0.04 * STEEL  # breaking strain over sigma_0/E of the paper's weakest steel
COLORS = {
    "paper36": "C0",
    "similar": "C1",
    "equal-kappas": "C2",
    "velocity": "C4",
    "pressure": "C7",
    "ductility": "C3",
}


def ductility(report: dict[str, Any], picture: str) -> list[str]:
    """mu over Eq. 2's form with the fitted numbers, against the ductility; how near each plan is;
    what is left; the fit."""
    body = report["report"]
    if "fit" not in body:
        raise Missing(f"no law with a power of the ductility: {report['reason']}")
    points = body["conditions"]
    plans = np.array([plan_name(body["points"][p["runs"][0]]) for p in points])
    number, mu, error, left, kappa3 = (
        np.array([p[key] for p in points])
        for key in ("ductility", "mu", "mu_se", "residual", "kappa3")
    )
    power = body["fit"]["parameters"]["n"]
    x = number / body["fit"]["ductility"]
    draw(plans, x, (1 + left) * x ** power["value"], error / mu, power, picture)
    rows = [
        [
            name,
            str(sum(of)),
            f"{min(x[of]):.2f} .. {max(x[of]):.2f}",
            f"{100 * np.sqrt(np.mean(left[of] ** 2)):.1f} %",
            f"{100 * np.mean(left[of]):+.1f} %",
        ]
        for name, of in ((name, plans == name) for name in COLORS)
        if any(of)
    ]
    _, n, _, n_error = power_law(kappa3 / STEEL, 1 + left, error / mu)
    return [
        f"ductility over {body['fit']['ductility']:.4g}, that of 4 %, 92 MPa and 206 GPa",
        *table(["plan", "conditions", "ductility", "RMS from the fit", "mean"], rows),
        f"what is left goes like (E/sigma_0)^n: n = {n:.3f} +- {n_error:.3f}",
        "",
        *law_lines(report),
    ]


def draw(plans: Any, x: Any, over: Any, errors: Any, power: dict[str, Any], picture: str) -> None:
    """mu over the law at the reference against the ductility over it, x, and the fitted power with
    its interval. errors: of mu, relative."""
    figure, axes = pyplot.subplots(figsize=(7, 4.4), constrained_layout=True)
    for name, color in COLORS.items():
        if any(of := plans == name):
            bars = NORMAL * over[of] * errors[of]
            axes.errorbar(x[of], over[of], bars, fmt="o", ms=4, lw=1, color=color, label=name)
    line = np.geomspace(0.9 * min(x), 1.1 * max(x), 50)
    axes.plot(line, line ** power["value"], "k", lw=2, label=f"power {power['value']:.2f}")
    if None not in power["interval"]:
        low, high = (line**end for end in power["interval"])
        axes.fill_between(line, low, high, color="k", alpha=0.12, lw=0, label="its 95 %")
    axes.set(
        xscale="log",
        xlabel="ductility $\\varepsilon_c E/\\sigma_0$ over that of the weakest steel",
        ylabel="$\\mu$ over the law of $\\kappa_1$, $\\kappa_2$",
        ylim=(0, None),
    )
    axes.set_xticks([0.2, 0.5, 1, 2, 5], ["0.2", "0.5", "1", "2", "5"])
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9, ncols=2, loc="lower right")
    save_figure(figure, picture)
    pyplot.close(figure)
