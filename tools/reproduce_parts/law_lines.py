# SPDX-License-Identifier: GPL-2.0-or-later
"""A fitted law beside the paper's, in lines."""

from typing import Any

import numpy as np

import plot_fit

from .common import percent, table

PAPER = plot_fit.PAPER


def law_lines(report: dict[str, Any]) -> list[str]:
    """The fitted parameters beside Eq. 3, the static part beside Eq. 5, the comparison of
    models."""
    body, lines = report["report"], []
    if "fit" in body:
        fit = body["fit"]
        rows = []
        for name, entry in fit["parameters"].items():
            paper = PAPER.get(name, 0)
            low, high = ("open" if end is None else f"{end:.3g}" for end in entry["interval"])
            inside = all(
                end is None or sign * (paper - end) >= 0
                for sign, end in zip((1, -1), entry["interval"])
            )
            rows.append(
                [
                    name,
                    f"{paper:g}",
                    f"{entry['value']:.4g} +- {entry['standard_error']:.2g}",
                    f"{low} .. {high}",
                    "inside" if inside else "outside",
                ]
            )
        lines += table(
            ["Eq. 2", "Eq. 3", "our fit", f"{100 * fit['level']:g} % interval", "the paper's is"],
            rows,
        )
        lines.append(
            f"RMS of the runs against their fit: {100 * report['rms_relative']:.1f} % (paper "
            "about 9 %), "
            f"{report['n']} conditions"
        )
        law = {name: report[name] for name in PAPER}
        rows = []
        for kappa2 in (2.0, 50.0, 150.0, 365.0, 633.0):
            ours, paper = plot_fit.static_part(law, kappa2), plot_fit.static_part(PAPER, kappa2)
            error = float(plot_fit.static_error(law, report["covariance"], np.array([kappa2]))[0])
            rows.append(
                [
                    f"kappa2 = {kappa2:g}",
                    f"{paper:.3f}",
                    f"{ours:.3f} +- {error:.3f}",
                    percent(ours, paper),
                ]
            )
        lines += ["", *table(["mu for v -> 0 (Fig. 8)", "Eq. 5", "our fit", ""], rows)]
    else:
        lines.append(f"No law fitted: {report['reason']}")
    for number in ("kappa3", "ductility"):
        if number in body.get("fit", {}):
            at = body["fit"][number]
            lines.append(f"the law at {number} = {at:g}; it goes with ({number}/{at:g})^n")
    against = body["against_eq2"]
    lines.append(
        f"RMS of our runs against the paper's law: {100 * against['rms_relative']:.1f} %, mean "
        f"{100 * against['mean']:+.1f} % ({against['n']} conditions)"
    )
    for model in body["models"]:
        aicc = "-" if (delta := model.get("delta_aicc")) is None else f"{delta:+.1f}"
        lines.append(
            f"  {model['model']:15} "
            + (
                f"RMS {100 * model['rms_relative']:.1f} %, AICc {aicc}"
                if "rms_relative" in model
                else model["why_not"].removeprefix("the conditions have ")
            )
        )
    return lines
