#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Figs. 7 and 8 of the paper with our points, from wr_fit's JSON.

    plot_fit.py law.json -o fit.png

Left (Fig. 7): mu of the runs against mu of the law; runs that differ in their seed only are one
point, as in the fit. Right (Fig. 8): the pressure-dependent part of
the law, mu without its velocity term, against kappa2. Without a fitted law the paper's is used.
A law of one material (wr_fit --material) is refused.
With a power of kappa3 or of the ductility in wr_fit's model, mu of the runs is brought to that of
the law by it.
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""

from typing import Any

from mcawr import plotting, tables
from mcawr.command_line import Parser, file_name
from mcawr.errors import BadInput, run_script
from mcawr.files import check_apart, save_figure
from mcawr.replicas import NORMAL

PAPER = {"mu0": 0.15, "mu1": 0.0442, "mu2": 0.3243, "b": 0.195, "c": 0.00212}  # Eq. 3
PAPER_RMS = 0.09
OF_MATERIAL = "mca-friction-law 2"  # format

# law or None, its relative RMS, points, covariance or None
Contents = tuple[dict[str, Any] | None, float, list[dict[str, Any]], Any]


# what a law may have a power of, and how it is written
THIRD = {"kappa3": "$\\kappa_3$", "ductility": "ductility"}


def points_of(data: dict[str, Any]) -> list[dict[str, Any]]:
    """What is fitted, replicas as one point, and the runs that are left out, of wr_fit's JSON."""
    report = tables.checked_report(data)["report"]
    more = THIRD.keys() & report.get("fit", {}).keys()
    names = {"kappa1", "kappa2", "kappa3", "mu", "mu_se", *more}
    fitted = [
        {
            **{name: tables.number(c[name]) for name in names},
            "t95": tables.number(c.get("t95", NORMAL)),
            "left_out": "",
            "runs": len(c["runs"]),
        }
        for c in report["conditions"]
    ]
    return fitted + [{"t95": NORMAL, **p, "runs": 1} for p in report["points"] if p["left_out"]]


def contents(data: dict[str, Any]) -> Contents:
    """(law or None, its relative RMS, points, covariance) of wr_fit's JSON."""
    law = {name: tables.number(data[name]) for name in PAPER} if "mu0" in data else None
    points, fit = points_of(data), data["report"].get("fit", {})
    if not points:
        raise ValueError("it holds no point")
    for third in THIRD.keys() & fit.keys():
        if law is None:
            raise ValueError(f"it holds {third}, but no law")
        law[third] = tables.number(fit[third])
        exponent = tables.number(fit["parameters"]["n"]["value"])
        factors = [(law[third] / tables.number(p[third])) ** exponent for p in points]
        points = [
            {**p, **{key: None if p[key] is None else f * p[key] for key in ("mu", "mu_se")}}
            for f, p in zip(factors, points)
        ]
    covariance: Any = data.get("covariance")
    if covariance is not None:
        covariance = [[tables.number(x) for x in row] for row in covariance]
        if [len(row) for row in covariance] != 5 * [5]:
            raise ValueError("covariance: 5 rows of 5 numbers are expected")
    return law, tables.number(data.get("rms_relative", 0)), points, covariance


def read(path: str) -> Contents:
    """(law or None, its relative RMS, points, covariance) of wr_fit's JSON. Raises BadInput."""

    def of_eq2(data: dict[str, Any]) -> Contents:
        if data.get("format") == OF_MATERIAL:
            raise BadInput(f"{path}: is a law of one material: Figs. 7 and 8 are of Eq. 2")
        return contents(data)

    return tables.read_fit(path, of_eq2)


def velocity_term(law: dict[str, Any], kappa1: Any) -> Any:
    return law["mu1"] * kappa1 / (1 + law["b"] * kappa1)


def static_part(law: dict[str, Any], kappa2: Any) -> Any:
    return law["mu0"] + law["mu2"] / (1 + law["c"] * kappa2)


def static_error(law: dict[str, Any], covariance: Any, kappa2: Any) -> Any:
    """Standard error of the static part from the law's covariance (mu0, mu1, mu2, b, c)."""
    import numpy as np

    g = 1 / (1 + law["c"] * kappa2)
    gradient = np.array([np.ones_like(kappa2), 0 * g, g, 0 * g, -law["mu2"] * kappa2 * g * g])
    return np.sqrt(np.einsum("ik,ij,jk->k", gradient, np.array(covariance), gradient))


def draw(
    law: dict[str, Any] | None,
    rms: float,
    points: list[dict[str, Any]],
    covariance: Any,
    path: str,
    kind: str = "png",
) -> Any:
    """The picture of the contents of wr_fit's JSON; kind: its format if the path has no ending."""
    plt = plotting.pyplot()
    import numpy as np

    used = [p for p in points if not p["left_out"]]
    rest = [p for p in points if p["left_out"]]
    runs = sum(p["runs"] for p in used)
    shown, shown_rms, name = (
        (law, rms, "our fit") if law else (PAPER, PAPER_RMS, "Eq. 3 of the paper")
    )
    of_runs = "$\\mu$ of the runs" + "".join(
        f", brought to {word} = {law[third]:.4g}"
        for third, word in THIRD.items()
        if law and third in law
    )
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.8), constrained_layout=True)

    def column(rows: list[dict[str, Any]], key: str) -> Any:
        return np.array([np.nan if row[key] is None else row[key] for row in rows], dtype=float)

    def scatter(axes: Any, rows: list[dict[str, Any]], x: Any, y: Any, **style: Any) -> None:
        axes.errorbar(
            x,
            y,
            yerr=column(rows, "t95") * column(rows, "mu_se"),
            ls="none",
            ms=5,
            lw=1,
            capsize=2,
            **style,
        )

    def predicted(rows: list[dict[str, Any]]) -> Any:
        return static_part(shown, column(rows, "kappa2")) + velocity_term(
            shown, column(rows, "kappa1")
        )

    for axes in (left, right):
        axes.grid(alpha=0.3)
    filled = dict(
        fmt="o",
        color="C0",
        label=f"{runs} run{'s' * (runs != 1)}, {len(used)} condition{'s' * (len(used) != 1)}, 95 %",
    )
    hollow = dict(fmt="o", color="0.6", mfc="none", label="left out of the fit")
    if used:
        scatter(left, used, predicted(used), column(used, "mu"), **filled)
    if rest:
        scatter(left, rest, predicted(rest), column(rest, "mu"), **hollow)
    bars = column(points, "mu") + column(points, "t95") * np.nan_to_num(column(points, "mu_se"))
    top = 1.05 * np.nanmax(np.concatenate([predicted(points), bars]))
    line = np.array([0, top])
    left.plot(line, line, color="k", lw=1)
    left.fill_between(
        line,
        (1 - shown_rms) * line,
        (1 + shown_rms) * line,
        color="C1",
        alpha=0.25,
        lw=0,
        label=f"$\\pm$ {100 * shown_rms:.1f} % (RMS of {name})",
    )
    left.set(
        xlim=(0, top),
        ylim=(0, top),
        xlabel=f"$\\mu$ of {name}",
        ylabel=of_runs,
        title="Runs against the law (Fig. 7)",
    )
    left.legend(fontsize=9, loc="lower right")

    reach = max(650.0, 1.1 * max(p["kappa2"] for p in points))
    kappa2 = np.linspace(0, reach, 400)
    if law:
        right.plot(kappa2, static_part(law, kappa2), color="C1", lw=2, label="our fit")
        if covariance:
            error = 1.96 * static_error(law, covariance, kappa2)
            right.fill_between(
                kappa2,
                static_part(law, kappa2) - error,
                static_part(law, kappa2) + error,
                color="C1",
                alpha=0.2,
                lw=0,
                label="its 95 % band",
            )
    right.plot(kappa2, static_part(PAPER, kappa2), color="k", ls="--", label="Eq. 5 of the paper")
    for rows, style in ((used, filled), (rest, hollow)):
        if rows:
            reduced = column(rows, "mu") - velocity_term(shown, column(rows, "kappa1"))
            scatter(right, rows, column(rows, "kappa2"), reduced, **(style | {"label": None}))
    right.set(
        xlim=(0, reach),
        ylim=(0, top),
        xlabel="$\\kappa_2 = p E/\\sigma_0^2$",
        ylabel="$\\mu - \\mu_1\\kappa_1/(1+b\\,\\kappa_1)$",
        title="Without the velocity term (Fig. 8)",
    )
    right.legend(fontsize=9)
    save_figure(figure, path, kind=kind)


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("json", type=file_name, help="wr_fit's JSON (wr_fit -o)")
    parser.add_argument("-o", "--output", type=file_name, default="fit.png", metavar="PNG")
    parser.add_argument(
        "--format", default="png", metavar="ENDING", help="of a picture whose name has no ending"
    )
    given = parser.parse_args()
    check_apart([given.json], [given.output])
    draw(*read(given.json), given.output, given.format)


if __name__ == "__main__":
    run_script(main)
