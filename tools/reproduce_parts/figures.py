# SPDX-License-Identifier: GPL-2.0-or-later
"""Each figure: which plans it needs, how it is drawn, and the paper's numbers beside ours."""

import dataclasses
import math
import re
from typing import Any

import numpy as np

import plot_fit
import plot_series
from mcawr.replicas import groups, half_width, mean_of

from . import (
    ageing,
    ductility,
    laws,
    layer,
    locomotive_runs,
    materials,
    rail,
    space as three,
    steel as series,
    temperature as heat,
    width,
)
from .common import (
    STEEL,
    Missing,
    percent,
    plan_name,
    power_law,
    run_name,
    scatter_of,
    table,
    with_own_errors,
)
from .dots import dots
from .law_lines import law_lines

PAPER_COLLAPSE = 0.035  # scatter of ten runs at equal kappas
START = ["--start", "50", "--start-distance", "250"]  # ns, nm; each run slides 500 nm or more
FROM = f"from {START[1]} ns and {START[3]} nm on"
LATE = ["--start-distance", str(ageing.AGED)]  # nm; each run of preset d slides 500 nm
LATER = f"from {LATE[1]} nm on"
FIRST = "50"  # ns, 250 nm at 5 m/s


@dataclasses.dataclass
class Figure:
    """A figure: title, plans whose logs it shows, options of wr_fit, make(report, picture) ->
    lines."""

    title: str
    plans: list
    make: object
    options: list = dataclasses.field(default_factory=list)


# fig4, fig6 ---------------------------------------------------------------------------------------
def fig4(report: dict[str, Any], picture: str) -> list[str]:
    """Friction stress (MPa) at each pressure (MPa) in the first 50 ns and after, means over the
    seeds; exponent of stress ~ p^n."""
    points = report["report"]["points"]
    plot_series.draw(points, "pressure", picture)
    rows, pressures, stresses, papers, errors = [], [], [], [], []
    for p, members in groups(points, lambda x: x["pressure"]).items():
        (mu, error), (early, _) = mean_of(members), mean_of(members, "mu_grinding_in")
        paper = members[0]["mu_eq2"] * p
        rows.append(
            [
                f"p = {p:g} MPa",
                f"{paper:.2f}",
                f"{mu * p:.3f} +- {error * p:.3f}",
                percent(mu * p, paper),
                f"{early * p:.2f}",
                percent(early, mu),
            ]
        )
        pressures.append(p)
        stresses.append(mu * p)
        papers.append(paper)
        errors.append(error / mu)
    lines = table(
        ["friction stress, MPa", "Eq. 2", "later", "", f"first {FIRST} ns", "over later"], rows
    )
    if len(pressures) > 2:
        relative = np.array(errors)
        _, n, _, n_error = power_law(np.array(pressures), np.array(stresses), relative)
        # Eq. 2 is no power: the same weights
        paper = np.polyfit(np.log(pressures), np.log(papers), 1, w=1 / relative)[0]
        lines += [
            f"stress ~ p^n: n = {n:.3f} +- {n_error:.3f}, Eq. 2 {paper:.3f} (Amontons: 1)",
            f"fall of mu with p over that of Eq. 2, (1 - n)/(1 - n of Eq. 2): "
            f"{(1 - n) / (1 - paper):.2f} +- {n_error / (1 - paper):.2f}",
        ]
    return lines


def fig6(report: dict[str, Any], picture: str) -> list[str]:
    """mu at each velocity (m/s), a mean over the seeds, and the largest row of the logs."""
    points = report["report"]["points"]
    plot_series.draw(points, "velocity", picture)
    rows = []
    for v, members in groups(points, lambda x: x["velocity"]).items():
        (mu, error), (peak, _) = mean_of(members), mean_of(members, "mu_peak")
        paper = members[0]["mu_eq2"]
        rows.append(
            [
                f"v = {v:g} m/s",
                f"{paper:.3f}",
                f"{mu:.3f} +- {error:.3f}",
                percent(mu, paper),
                f"{peak:.2f}",
            ]
        )
    return table(["mu", "Eq. 2", "ours", "", "peak"], rows)


# fig7 and fig8 ------------------------------------------------------------------------------------
def fig7(report: dict[str, Any], picture: str) -> list[str]:
    """Eq. 2 fitted to our runs beside Eq. 3; its static part beside Eq. 5; our runs against the
    paper's law."""
    plot_fit.draw(*plot_fit.contents(report), picture)
    return law_lines(report)


def steel(report: dict[str, Any], picture: str) -> list[str]:
    """mu of one material against velocity (m/s) and pressure (MPa), and its law."""
    series.draw(report, picture)
    return law_lines(report)


# dots: collapse, convergence ----------------------------------------------------------------------
def parameters(point: dict[str, Any]) -> str:
    """What is varied at equal kappas: p, v, sigma_0, E, rho, eta."""
    modulus = point["kappa2"] * point["strength"] ** 2 / point["pressure"]
    density = point["kappa1"] * point["strength"] ** 2 * 1e6 / (modulus * point["velocity"] ** 2)
    return (
        f"p {point['pressure']:.3g}, v {point['velocity']:.3g}, $\\sigma_0$ "
        f"{point['strength']:g}, E {1e-3 * modulus:.0f}, "
        f"$\\rho$ {1e-3 * density:.2g}, $\\eta$ {point['viscosity']:g}"
    )


def collapse(report: dict[str, Any], picture: str) -> list[str]:
    """Scatter of mu, a mean over the seeds, over runs at equal kappa1 and kappa2, over its mean."""
    return collapse_of(report["report"]["points"], picture)


def similar(report: dict[str, Any], picture: str) -> list[str]:
    """The same over those of similar stress-strain diagrams: the runs of the plan similar, s05, and
    those of equal-kappas that have the diagram of c01. Then the plan's conditions of paper36, r09,
    beside the runs of paper36, which have the strains of the paper.
    """
    points = report["report"]["points"]
    equal = [
        p
        for p in points
        if run_name(p).startswith("s")
        or (run_name(p).startswith("c") and math.isclose(p["kappa3"], STEEL, rel_tol=1e-3))
    ]
    return collapse_of(equal, picture) + beside_eq2(points)


def beside_eq2(points: list[dict[str, Any]]) -> list[str]:
    """mu of the conditions r09 of similar, and of the same of paper36, means over their seeds,
    beside Eq. 2; nothing for none."""
    found = groups(points, lambda p: (plan_name(p), run_name(p).split("-seed")[0]))
    rows: list[list[str]] = []
    ratios: dict[str, list[float]] = {"strains of the paper": [], "similar diagrams": []}
    for name in [name for plan, name in found if plan == "similar" and name.startswith("r")]:
        first = found["similar", name][0]
        cells = []
        for plan, over in zip(("paper36", "similar"), ratios):
            if (members := found.get((plan, name))) is None:
                cells += ["", ""]
                continue
            mu, error = mean_of(members)
            ratios[over].append(mu / first["mu_eq2"])
            cells += [f"{mu:.3f} +- {error:.3f}", f"{ratios[over][-1]:.2f}"]
        rows.append(
            [
                name,
                f"{first['kappa1']:.3g}",
                f"{first['kappa2']:.3g}",
                f"{first['kappa3'] / STEEL:.2f}",
                f"{first['mu_eq2']:.3f}",
                *cells,
            ]
        )
    if not rows:
        return []
    head = ["condition", "kappa1", "kappa2", "E/sigma_0", "Eq. 2"]
    head += ["paper's strains", "over it", "similar", "over it"]
    errors = [
        f"RMS from Eq. 2, {over}: {100 * math.sqrt(np.mean((np.array(r) - 1) ** 2)):.1f} % "
        f"({len(r)} conditions)"
        for over, r in ratios.items()
        if r
    ]
    return ["", "beside Eq. 2; E/sigma_0 over that of c01", *table(head, rows), *errors]


def collapse_of(points: list[dict[str, Any]], picture: str) -> list[str]:
    """Draws the conditions of the points, and tells what they scatter by and go with."""
    found = groups(points, lambda p: run_name(p).split("-seed")[0])
    if len(found) < 2:
        raise Missing("one condition has no scatter: 2 are needed")
    first = {name: members[0] for name, members in found.items()}
    mu, errors = zip(*(mean_of(members) for members in found.values()))
    mean, paper = float(np.mean(mu)), next(iter(first.values()))["mu_eq2"]
    dots(
        [f"{name}: {parameters(p)}" for name, p in first.items()],
        mu,
        [half_width(members) for members in found.values()],
        picture,
        "friction coefficient $\\mu$",
        [(mean, dict(color="C1"), "their mean"), (paper, dict(color="k", ls="--"), "Eq. 2")],
        (mean * (1 - PAPER_COLLAPSE), mean * (1 + PAPER_COLLAPSE), "$\\pm$ 3.5 % (paper)"),
        "MPa, m/s, MPa, GPa, g/cm$^3$, Pa s",
    )
    scatter, own = scatter_of(mu, errors)
    rows = [
        ["scatter of mu (standard deviation)", f"{100 * PAPER_COLLAPSE:.1f} %", f"{scatter:.1f} %"],
        ["  what the errors of the means explain", "", f"{own:.1f} %"],
        ["mean mu", f"{paper:.3f}", f"{mean:.3f} +- {np.std(mu, ddof=1) / math.sqrt(len(mu)):.3f}"],
    ]
    if len(mu) > 3:
        rows += power_rows(list(first.values()), mu)
    return table([f"{len(mu)} conditions", "paper", "ours"], rows)


def power_rows(points: list[dict[str, Any]], mu: Any) -> list[list[str]]:
    """The exponents of mu in E/sigma_0 and in eta v/sigma_0, by least squares of the logarithms,
    with standard errors from what is left."""
    columns = [
        [math.log(p["kappa3"]), math.log(p["viscosity"] * p["velocity"] / p["strength"]), 1.0]
        for p in points
    ]
    matrix, y = np.array(columns), np.log(mu)
    found, *_ = np.linalg.lstsq(matrix, y, rcond=None)
    left = np.sum((y - matrix @ found) ** 2) / (len(y) - 3)
    errors = np.sqrt(np.diag(left * np.linalg.inv(matrix.T @ matrix)))
    names = ("mu ~ (E/sigma_0)^n: n", "mu ~ (eta v/(d sigma_0))^n: n")
    return [[name, "0", f"{n:+.2f} +- {error:.2f}"] for name, n, error in zip(names, found, errors)]


SIZES = {
    "base": "base",
    "half-wide": "half as wide",
    "wide": "twice as wide",
    "high": "six rows more",
    "held5": "5 rows held",
    "fine": "half the step",
    "poisson-nu0.25": "Poisson's ratio 0.25",
    "poisson-nu0.34": "Poisson's ratio 0.34",
    "poisson-nu0.4": "Poisson's ratio 0.4",
    "ductile-breaking_strain0.02": "breaks at 2 %",
    "ductile-breaking_strain0.1": "breaks at 10 %",
    "ductile-breaking_strain0.2": "breaks at 20 %",
}  # of the plans convergence and ductility, in the order of figures


def size_of(point: dict[str, Any]) -> str:
    """The key in SIZES of a run: `wide` of wide-strength92-seed3, `fine` of fine-v10-seed3."""
    size = re.sub(r"-(strength|v|seed)\d.*", "", run_name(point))
    return "base" if size == "poisson-nu0.3" else size


def convergence(report: dict[str, Any], picture: str) -> list[str]:
    """mu over that of the base size, and the depth of the layer (nm), for each size at a strength
    (MPa) and velocity (m/s)."""
    points = with_own_errors(report["report"]["points"])
    rows, labels, values, bars = [], [], [], []
    for (strength, v), members in groups(points, lambda p: (p["strength"], p["velocity"])).items():
        sizes = groups(members, size_of)
        if strange := sizes.keys() - SIZES:
            raise Missing(f"of no plan: {', '.join(sorted(strange))}")
        if "base" not in sizes:
            raise Missing(f"no run of the base size at {strength:g} MPa, {v:g} m/s")
        base, base_error = mean_of(sizes["base"])
        for size in (size for size in SIZES if size in sizes):
            mu, error = mean_of(sizes[size])
            depths = [found for p in sizes[size] if (found := layer.read(p["file"]))]
            depth = "{:.1f} +- {:.1f}".format(*layer.mean_depth(depths)) if depths else ""
            reach, against = half_width(sizes[size]) / mu, ""
            if size != "base":
                reach = math.hypot(reach, half_width(sizes["base"]) / base)
                difference = (mu - base) / math.hypot(error, base_error)
                against = f"{percent(mu, base)} ({difference:+.1f} s.e.)"
            labels.append(f"{strength:g} MPa, {v:g} m/s: {SIZES[size]}")
            values.append(mu / base)
            bars.append(reach * mu / base)
            number, cell = str(len(sizes[size])), f"{mu:.3f} +- {error:.3f}"
            rows.append([labels[-1], number, cell, against, depth])
    dots(
        labels,
        values,
        bars,
        picture,
        "$\\mu/\\mu$(base)",
        [(1, dict(color="k", ls="--"), "what it stands against")],
    )
    return table(["", "runs", "mu", "against base", "depth, nm"], rows)


FIGURES = {
    "fig3": Figure(
        "Fig. 3: depth of the sliding layer",
        ["roughness", "viscosity", "equal-kappas"],
        ageing.fig3,
    ),
    "fig4": Figure(
        "Fig. 4: friction stress against pressure",
        ["pressure"],
        fig4,
        ["--grinding-in", FIRST, *LATE],
    ),
    "fig6": Figure(f"Fig. 6: mu against velocity, {LATER}", ["velocity"], fig6, LATE),
    "ageing": Figure(
        f"Ageing: mu against the distance slid, and n of mu ~ s^n {LATER}",
        ["velocity", "pressure"],
        ageing.ageing,
        LATE,
    ),
    "collapse": Figure(f"Equal kappa1 and kappa2, {LATER}", ["equal-kappas"], collapse, LATE),
    "similar": Figure(
        f"Equal kappa1 and kappa2 with similar stress-strain diagrams, {LATER}",
        ["similar", "equal-kappas", "paper36"],
        similar,
        LATE,
    ),
    "fig7": Figure(f"Figs. 7 and 8: the law, {FROM}", ["paper36"], fig7, START),
    "steel": Figure(
        f"The law of one material, E = 206 GPa and sigma_0 = 92 MPa, {LATER}",
        ["velocity", "pressure"],
        steel,
        ["--model", "velocity", *LATE],
    ),
    "kappa3": Figure(
        f"The law with a third number, kappa3 = E/sigma_0, {FROM}",
        ["paper36"],
        materials.kappa3,
        ["--model", "eq2_kappa3", "--kappa3", str(STEEL), *START],
    ),
    "ductility": Figure(
        f"mu and the ductility, breaking strain over sigma_0/E, {LATER}",
        [*ductility.COLORS],
        ductility.ductility,
        ["--model", "eq2_ductility", "--ductility", f"{ductility.REFERENCE:g}", *LATE],
    ),
    "temperature": Figure(
        f"Friction of a rail steel (MPa, GPa) against temperature, {LATER}",
        ["temperature"],
        heat.temperature,
        LATE,
    ),
    "rail": Figure(
        f"Friction of a rail steel up to its hardness, from {locomotive_runs.START_DISTANCE} nm on",
        [locomotive_runs.LOGS_PLAN],
        rail.rail,
        locomotive_runs.FIT + ["--model", locomotive_runs.MODELS[0]],
    ),
    "rail-checks": Figure(
        "Other widths, heights and steps beside the runs of the rail steel's law",
        [locomotive_runs.LOGS_PLAN, "rail-checks"],
        rail.checks,
        locomotive_runs.FIT + ["--model", locomotive_runs.MODELS[0]],
    ),
    "space": Figure(
        f"Friction in three dimensions and in the plane, {LATER}",
        ["space", "velocity", "pressure", "paper36"],
        three.space,
        LATE,
    ),
    "laws": Figure(
        f"Sets of laws in wide fragments, from {laws.START} nm on",
        ["laws"],
        laws.laws,
        ["--start-distance", laws.START],
    ),
    "laws-long": Figure(
        f"Sets of laws over 500 nm, from {laws.LONG} nm on",
        ["laws-long"],
        laws.laws_long,
        ["--start-distance", laws.LONG],
    ),
    "convergence": Figure(
        f"Size of the fragment, time step, Poisson's ratio, breaking strain, {LATER}",
        ["convergence", "ductility"],
        convergence,
        LATE,
    ),
    "width": Figure(f"How wide a fragment has to be, {FROM}", ["width"], width.width, START),
    "width-long": Figure(
        f"Slow blocks over 1000 nm, from {width.SETTLED} nm on",
        ["width-long"],
        width.width_long,
        ["--start-distance", str(width.SETTLED)],
    ),
    "light": Figure(
        f"Light loads in blocks of 640 columns, {FROM}",
        ["light", "pressure", "paper36"],
        width.light,
        START,
    ),
}
