"""Each figure: which plans it needs, how it is drawn, and the paper's numbers beside ours."""
import dataclasses
import math
import os
import re

import numpy as np
from matplotlib import pyplot

import plot_fit
import plot_friction
import plot_series
from . import layer

PAPER = plot_fit.PAPER
PAPER_COLLAPSE = 0.035  # scatter of ten runs at equal kappas
PAPER_DEPTH = 10.0      # nm, of the quasi-liquid layer
EQUILIBRIUM = ["--start", "200"]  # ns; from here on mu does not change in runs of 600 ns (Fig. 3)
LATER = ["--start", "50"]  # ns; of plans whose runs end at 100 ns
FROM = f"from {EQUILIBRIUM[1]} ns on"
STEEL = 2239            # kappa3 = E/sigma_0 of the paper's weakest steel, 206 GPa over 92 MPa


class Missing(Exception):
    """What a figure needs and is not there, in one line."""


@dataclasses.dataclass
class Figure:
    """A figure: title, plans whose logs it shows, options of wr_fit, make(report, picture) -> lines."""
    title: str
    plans: list
    make: object
    options: list = dataclasses.field(default_factory=list)


def write_whole(path, text):
    """Writes a text beside and renames it."""
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".part", path)


def save(figure, path):
    """Writes a picture beside and renames it."""
    figure.savefig(path + ".part", dpi=130, format="png")
    os.replace(path + ".part", path)
    pyplot.close(figure)


def run_name(point):
    """Name of the run that a log belongs to: of its folder, or of the packed file."""
    folder, name = os.path.split(point["file"])
    return os.path.basename(folder) if name == "run.friction" else name.removesuffix(".friction")


def table(head, rows):
    """Lines of a table of texts, columns as wide as needed."""
    cells = [head, *rows]
    width = [max(len(row[k]) for row in cells) for k in range(len(head))]
    return ["  ".join(c.ljust(w) if k == 0 else c.rjust(w) for k, (c, w) in enumerate(zip(row, width))).rstrip()
            for row in cells]


def percent(ours, paper):
    """Relative difference of two numbers of one unit, as text."""
    return f"{100 * (ours / paper - 1):+.1f} %"


def groups(points, key):
    """{key(point): points} in order of the key."""
    found = {}
    for point in points:
        found.setdefault(key(point), []).append(point)
    return dict(sorted(found.items()))


def mean_of(points, key="mu"):
    """(mean over replicas, its standard error: the larger of what the runs' own errors and their
    scatter say)."""
    values = [p[key] for p in points if p[key] is not None]
    if not values:
        return math.nan, math.nan
    own = math.sqrt(sum((p["mu_se"] or 0) ** 2 for p in points)) / len(points)
    scatter = np.std(values, ddof=1) / math.sqrt(len(values)) if len(values) > 1 else 0.0
    return float(np.mean(values)), max(own, scatter)


def scatter_of(values, errors):
    """Standard deviation of values over their mean, and what their own standard errors explain of it, both in %."""
    mean = np.mean(values)
    return 100 * np.std(values, ddof=1) / mean, 100 * math.sqrt(np.mean(np.square(errors))) / mean


# fig3 ---------------------------------------------------------------------------------------------
def friction_series(members):
    """Times (ns) and mu of the logs of runs (point, layer)."""
    return [np.array(plot_friction.read_log(p["file"])[1:]) for p, _ in members]


def shortest(members):
    """Time (ns) that all runs (point, layer) have reached; inf of none."""
    return min((f.time[-1] for _, f in members), default=math.inf)


def second_half(members, end):
    """Cells of depth (nm) and mu of runs (point, layer) from half of the time `end` (ns) up to it; and the depth, its error, mu."""
    (depth, error), (mu, mu_error) = layer.mean_depth([f for _, f in members], end), layer.window(friction_series(members), end / 2, end, 8)
    return [f"{depth:.1f} +- {error:.1f}", f"mu {mu:.3f} +- {mu_error:.3f}"], depth, error, mu


def growth(members, axes):
    """Rows of depth (nm) and mu of the runs (point, layer) in times (ns) that double; draws the power law of the depth."""
    end, growing, rows = shortest(members), [], []
    depths, logs = [(f.time, f.depth) for _, f in members], friction_series(members)
    for late in (end / 12, end / 6, end / 3, 2 * end / 3, end):
        early = late / 2 if late < end else 2 * end / 3
        (depth, error), (mu, mu_error) = layer.window(depths, early, late, 2), layer.window(logs, early, late, 8)
        growing.append((math.sqrt(early * late), depth, mu))
        rows.append([f"{early:.3g} to {late:.3g} ns", "", f"{depth:.1f} +- {error:.1f}", f"mu {mu:.3f} +- {mu_error:.3f}"])
    time, depth, mu = np.log(growing).T
    power, factor = np.polyfit(time, depth, 1)
    line = np.linspace(0, end, 100)
    axes.plot(line, math.exp(factor) * line**power, "k", lw=1, label=f"in proportion to $t^{{{power:.2f}}}$")
    return [*rows, ["exponent of depth ~ t^n", "", f"{power:.2f}", f"of mu {np.polyfit(time, mu, 1)[0]:.2f}"]]


def fig3(report, picture):
    """Depth of the layer: from the profiles beside the logs. Of the plan `growth` depth and mu in times that double."""
    layers = []
    for point in report["report"]["points"]:
        found = layer.read(point["file"])
        if found is None:
            raise Missing(f"{point['file']}: no profile beside it (a plan with `profile` makes one)")
        layers.append((point, found))
    rough = [(float(number[1]), p, f) for p, f in layers if (number := re.search("roughness([0-9.]+)", run_name(p)))]
    viscous = groups([(p, f) for p, f in layers if "eta" in run_name(p)], lambda x: x[0]["viscosity"])
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    rows = []
    for k, (amplitude, members) in enumerate(groups(rough, lambda x: x[0]).items()):
        for number, (_, _, found) in enumerate(members):
            left.plot(found.time, found.depth, color=f"C{k}", label=None if number else f"initial roughness {amplitude:g} nm")
        cells, *_ = second_half([(p, f) for _, p, f in members], shortest([(p, f) for _, p, f in rough]))
        rows.append([f"roughness {amplitude:g} nm", f"{PAPER_DEPTH:g}", *cells])
    long = [(p, f) for p, f in layers if run_name(p).startswith("growth")]
    if not long:
        raise Missing("no run of the plan growth")
    for number, (_, found) in enumerate(long):
        left.plot(found.time, found.depth, color="0.6", lw=1, zorder=1, label=None if number else f"{found.time[-1]:.0f} ns")
    rows += growth(long, left)
    left.axhline(PAPER_DEPTH, color="k", ls="--", lw=1, label="about 10 nm (paper)")
    left.set(xlabel="time (ns)", ylabel="depth of the layer (nm), 10 to 90 % of $v$", xlim=(0, None), ylim=(0, None))
    left.legend(fontsize=9)
    eta, depth, error, mu = [], [], [], []
    for value, members in viscous.items():
        cells, *found = second_half(members, shortest([m for of in viscous.values() for m in of]))
        for values, one in zip((eta, depth, error, mu), (value, *found)):
            values.append(one)
        rows.append([f"viscosity {value:g} Pa s", f"{PAPER_DEPTH * value / 0.41:.1f}", *cells])
    right.errorbar(eta, depth, yerr=1.96 * np.array(error), fmt="o", capsize=2, label="our runs, 95 %")
    if eta:
        line = np.array([min(eta), max(eta)])
        right.plot(line, PAPER_DEPTH * line / 0.41, "k--", lw=1, label="in proportion (paper: roughly)")
        exponent = np.polyfit(np.log(eta), np.log(depth), 1)[0] if len(eta) > 1 else math.nan
        slope = np.polyfit(np.log(eta), np.log(mu), 1)[0] if len(eta) > 1 else math.nan
        rows.append(["exponent of depth ~ eta^n", "about 1", f"{exponent:.2f}", f"of mu (paper: 0) {slope:.2f}"])
    right.set(xlabel="viscosity $\\eta$ (Pa s)", ylabel="depth of the layer (nm)", xscale="log", yscale="log")
    right.set_xticks(eta, [f"{value:.2g}" for value in eta])
    right.set_yticks([2, 5, 10, 20, 50], ["2", "5", "10", "20", "50"])
    right.minorticks_off()
    right.legend(fontsize=9)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    save(figure, picture)
    return table(["", "paper, nm", "ours, nm", ""], rows)


# fig4, fig6 ---------------------------------------------------------------------------------------
def fig4(report, picture):
    """Friction stress (MPa) at each pressure (MPa) before and after 100 ns, means over the seeds; exponent of stress ~ p^n."""
    points = report["report"]["points"]
    plot_series.draw(points, "pressure", picture)
    rows, pressures, stresses, errors = [], [], [], []
    for p, members in groups(points, lambda x: x["pressure"]).items():
        (mu, error), (early, _) = mean_of(members), mean_of(members, "mu_grinding_in")
        paper = members[0]["mu_eq2"] * p
        rows.append([f"p = {p:g} MPa", f"{paper:.2f}", f"{mu * p:.2f} +- {error * p:.2f}", percent(mu * p, paper),
                     f"{early * p:.2f}", percent(early, mu)])
        pressures.append(p), stresses.append(mu * p), errors.append(error / mu)
    lines = table(["friction stress, MPa", "Eq. 2", FROM, "", "first 100 ns", "over later"], rows)
    if len(pressures) > 2:
        fit, covariance = np.polyfit(np.log(pressures), np.log(stresses), 1, w=1 / np.array(errors), cov=True)
        paper = np.polyfit(np.log(pressures), np.log([m[0]["mu_eq2"] * p for p, m in
                                                      groups(points, lambda x: x["pressure"]).items()]), 1)[0]
        lines.append(f"stress ~ p^n: n = {fit[0]:.3f} +- {math.sqrt(covariance[0, 0]):.3f}, Eq. 2 {paper:.3f} (Amontons: 1)")
    return lines


def fig6(report, picture):
    """mu at each velocity (m/s), a mean over the seeds, and the largest row of the logs."""
    points = report["report"]["points"]
    plot_series.draw(points, "velocity", picture)
    rows = []
    for v, members in groups(points, lambda x: x["velocity"]).items():
        (mu, error), (peak, _) = mean_of(members), mean_of(members, "mu_peak")
        paper = members[0]["mu_eq2"]
        rows.append([f"v = {v:g} m/s", f"{paper:.3f}", f"{mu:.3f} +- {error:.3f}", percent(mu, paper), f"{peak:.2f}"])
    return table(["mu", "Eq. 2", FROM, "", "peak"], rows)


# fig7 and fig8 ------------------------------------------------------------------------------------
def fig7(report, picture):
    """Eq. 2 fitted to our runs beside Eq. 3; its static part beside Eq. 5; our runs against the paper's law."""
    plot_fit.draw(*plot_fit.contents(report), picture)
    return law_lines(report)


def law_lines(report):
    """The fitted parameters beside Eq. 3, the static part beside Eq. 5, the comparison of models."""
    body, lines = report["report"], []
    if "fit" in body:
        fit = body["fit"]
        rows = []
        for name, paper in {**PAPER, **({"n": 0} if "kappa3" in fit else {})}.items():
            entry = fit["parameters"][name]
            low, high = ("open" if end is None else f"{end:.3g}" for end in entry["interval"])
            inside = all(end is None or sign * (paper - end) >= 0 for sign, end in zip((1, -1), entry["interval"]))
            rows.append([name, f"{paper:g}", f"{entry['value']:.4g} +- {entry['standard_error']:.2g}",
                         f"{low} .. {high}", "inside" if inside else "outside"])
        lines += table(["Eq. 2", "Eq. 3", "our fit", f"{100 * fit['level']:g} % interval", "the paper's is"], rows)
        lines.append(f"RMS of the points against their fit: {100 * report['rms_relative']:.1f} % (paper about 9 %), "
                     f"{report['n']} points")
        law = {name: report[name] for name in PAPER}
        rows = []
        for kappa2 in (2.0, 50.0, 150.0, 365.0, 633.0):
            ours, paper = plot_fit.static_part(law, kappa2), plot_fit.static_part(PAPER, kappa2)
            error = float(plot_fit.static_error(law, report["covariance"], np.array([kappa2]))[0])
            rows.append([f"kappa2 = {kappa2:g}", f"{paper:.3f}", f"{ours:.3f} +- {error:.3f}", percent(ours, paper)])
        lines += ["", *table(["mu for v -> 0 (Fig. 8)", "Eq. 5", "our fit", ""], rows)]
    else:
        lines.append(f"No law fitted: {report['reason']}")
    if "fit" in body and "kappa3" in body["fit"]:
        lines.append(f"the law at kappa3 = {body['fit']['kappa3']:g}; it goes with (kappa3/{body['fit']['kappa3']:g})^n")
    paper = body["against_eq2"]
    lines.append(f"RMS of our points against the paper's law: {100 * paper['rms_relative']:.1f} %, mean "
                 f"{100 * paper['mean']:+.1f} % ({paper['n']} points)")
    for model in body["models"]:
        lines.append(f"  {model['model']:10} " + (f"RMS {100 * model['rms_relative']:.1f} %, AICc {model['delta_aicc']:+.1f}"
                                                 if "rms_relative" in model else model["why_not"]))
    return lines


def power_law(x, y, errors):
    """(A, n, their standard errors) of y = A x^n: least squares in the logarithms, with the relative errors of y and the scatter
    beyond them that makes chi^2 the degrees of freedom, as wr_fit."""
    logs_x, logs_y, low, high = np.log(x), np.log(y), 0.0, 1.0
    for _ in range(60):
        scatter = 0.5 * (low + high)
        weight = 1 / np.hypot(errors, scatter)
        (n, logs_a), covariance = np.polyfit(logs_x, logs_y, 1, w=weight, cov="unscaled")
        chi_squared = np.sum((weight * (logs_y - logs_a - n * logs_x)) ** 2)
        low, high = (scatter, high) if chi_squared > len(x) - 2 else (low, scatter)
    factor, (n_error, factor_error) = math.exp(logs_a), np.sqrt(np.diag(covariance))
    return factor, n, factor * factor_error, n_error


def kappa3(report, picture):
    """mu over Eq. 2 with the paper's numbers against kappa3 = E/sigma_0, a power law through it; and wr_fit's own fit."""
    points = [p for p in report["report"]["points"] if not p["left_out"]]
    x, mu, error, paper = (np.array([p[key] for p in points]) for key in ("kappa3", "mu", "mu_se", "mu_eq2"))
    factor, n, factor_error, n_error = power_law(x / STEEL, mu / paper, error / mu)
    figure, axes = pyplot.subplots(figsize=(7, 4.4), constrained_layout=True)
    axes.errorbar(x, mu / paper, yerr=1.96 * error / paper, fmt="o", ms=4, lw=1, capsize=2, label="our runs, 95 % of their own error")
    line = np.geomspace(0.9 * min(x), 1.1 * max(x), 50)
    axes.plot(line, factor * (line / STEEL) ** n, "C1", lw=2, label=f"{factor:.2f} ($\\kappa_3$/{STEEL:g})$^{{{n:.2f}}}$")
    axes.axhline(1, color="k", ls="--", lw=1, label="Eq. 2")
    axes.set(xscale="log", yscale="log", xlabel="$\\kappa_3 = E/\\sigma_0$", ylabel="$\\mu/\\mu$(Eq. 2)", ylim=(0.25, 4))
    axes.set_xticks([500, 1000, 2000, 4000], ["500", "1000", "2000", "4000"])
    axes.set_yticks([0.3, 0.5, 1, 2, 3], ["0.3", "0.5", "1", "2", "3"])
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    save(figure, picture)
    rms = [100 * math.sqrt(np.mean((mu / (paper * f) - 1) ** 2)) for f in (1, factor * (x / STEEL) ** n)]
    lines = [f"mu/mu(Eq. 2) = A (kappa3/{STEEL:g})^n: A = {factor:.3f} +- {factor_error:.3f}, n = {n:.3f} +- {n_error:.3f} (paper: 1 and 0)",
             f"RMS of our points against Eq. 2 with the paper's numbers {rms[0]:.1f} %, against this {rms[1]:.1f} % ({len(points)} points)", ""]
    return lines + law_lines(report)


# dots: collapse, sensitivity, convergence ---------------------------------------------------------
def dots(labels, values, errors, picture, xlabel, lines=(), band=None):
    """A row for each label: value with its 95 % interval; vertical lines (x, style, label); a band."""
    figure, axes = pyplot.subplots(figsize=(7.5, 1.2 + 0.3 * len(labels)), constrained_layout=True)
    rows = np.arange(len(labels))[::-1]
    axes.errorbar(values, rows, xerr=1.96 * np.array(errors), fmt="o", capsize=2, label="our runs, 95 %")
    for x, style, label in lines:
        axes.axvline(x, **style, lw=1.2, label=label)
    if band:
        axes.axvspan(band[0], band[1], color="C1", alpha=0.2, lw=0, label=band[2])
    axes.set_yticks(rows, labels)
    axes.set(xlabel=xlabel, ylim=(-0.7, len(labels) - 0.3))
    axes.grid(alpha=0.3, axis="x")
    axes.legend(fontsize=9, loc="upper center", bbox_to_anchor=(0.4, -0.85 / (1.2 + 0.3 * len(labels))), ncols=3)
    save(figure, picture)


def parameters(point):
    """What is varied at equal kappas: p, v, sigma_0, E, rho, eta."""
    modulus = point["kappa2"] * point["strength"] ** 2 / point["pressure"]
    density = point["kappa1"] * point["strength"] ** 2 * 1e6 / (modulus * point["velocity"] ** 2)
    return (f"p {point['pressure']:.3g}, v {point['velocity']:.3g}, $\\sigma_0$ {point['strength']:g}, E {1e-3 * modulus:.0f}, "
            f"$\\rho$ {1e-3 * density:.2g}, $\\eta$ {point['viscosity']:g}")


def collapse(report, picture):
    """Scatter of mu over runs at equal kappa1 and kappa2, over its mean."""
    points = report["report"]["points"]
    mu = [p["mu"] for p in points]
    mean = float(np.mean(mu))
    dots([f"{run_name(p)}: {parameters(p)}" for p in points], mu, [p["mu_se"] or math.nan for p in points], picture,
         "friction coefficient $\\mu$",
         [(mean, dict(color="C1"), "their mean"), (points[0]["mu_eq2"], dict(color="k", ls="--"), "Eq. 2")],
         (mean * (1 - PAPER_COLLAPSE), mean * (1 + PAPER_COLLAPSE), "$\\pm$ 3.5 % (paper)"))
    scatter, own = scatter_of(mu, [p["mu_se"] or 0 for p in points])
    rows = [["scatter of mu (standard deviation)", f"{100 * PAPER_COLLAPSE:.1f} %", f"{scatter:.1f} %"],
            ["  what the runs' own errors explain", "", f"{own:.1f} %"],
            ["mean mu", f"{points[0]['mu_eq2']:.3f}", f"{mean:.3f} +- {np.std(mu, ddof=1) / math.sqrt(len(mu)):.3f}"]]
    return table([f"{len(points)} runs", "paper", "ours"], rows)


def condition_of(point):
    """`c1` of c1-lawsb and of its second seed, c1-second-lawsb."""
    return run_name(point).split("-")[0]


def sensitivity(report, picture):
    """mu/mu(Eq. 2) for each set of laws at each condition, a mean over the seeds; root mean square and mean for each set."""
    points = [p for p in report["report"]["points"] if p["mu_se"] is not None]
    sets = groups(points, lambda p: run_name(p).split("-laws")[1].replace("_", " "))
    conditions = sorted({condition_of(p) for p in points})
    figure, axes = pyplot.subplots(figsize=(8, 4.4), constrained_layout=True)
    rows = []
    for k, (laws, members) in enumerate(sets.items()):
        at = {c: np.array(mean_of(runs)) / runs[0]["mu_eq2"] for c, runs in groups(members, condition_of).items()}
        ratio, error = np.array([at.get(c, (math.nan, math.nan)) for c in conditions]).T
        x = np.arange(len(conditions)) + 0.1 * (k - 0.5 * (len(sets) - 1))
        axes.errorbar(x, ratio, yerr=1.96 * np.array(error), fmt="o", ms=4, capsize=2, label=f"preset {laws}")
        known = np.array([(r, e) for r, e in zip(ratio, error) if not math.isnan(r)])
        d = known[:, 0] - 1
        rms = math.sqrt(np.mean(d**2))
        rows.append([f"preset {laws}", *(f"{r:.2f}" if not math.isnan(r) else "-" for r in ratio), f"{100 * np.mean(d):+.0f} %",
                     f"{100 * rms:.1f} +- {100 * math.sqrt(np.sum((d * known[:, 1]) ** 2)) / (rms * len(d)):.1f} %"])
    axes.axhline(1, color="k", ls="--", lw=1, label="Eq. 2")
    first = {condition_of(p): p for p in points}
    axes.set_xticks(range(len(conditions)), [f"{c}\n$\\kappa_1$ {first[c]['kappa1']:.2g}\n$\\kappa_2$ {first[c]['kappa2']:.3g}"
                                             for c in conditions])
    axes.set(ylabel="$\\mu/\\mu$(Eq. 2)", ylim=(0, None))
    axes.grid(alpha=0.3, axis="y")
    axes.legend(fontsize=8, ncols=2)
    save(figure, picture)
    return table(["mu/mu(Eq. 2)", *conditions, "mean", "RMS"], rows)


def convergence(report, picture):
    """mu over that of the base size, and the depth of the layer (nm), for each size and strength (MPa)."""
    points = report["report"]["points"]
    rows, labels, values, errors = [], [], [], []
    for strength, members in groups(points, lambda p: p["strength"]).items():
        sizes = groups(members, lambda p: run_name(p).split("-strength")[0])
        base = mean_of(sizes["base"])
        for name in sorted(sizes, key=lambda n: (n != "base", n)):
            mu, error = mean_of(sizes[name])
            depths = [found for p in sizes[name] if (found := layer.read(p["file"]))]
            depth = "{:.1f} +- {:.1f}".format(*layer.mean_depth(depths)) if depths else ""
            difference = (mu - base[0]) / math.hypot(error, base[1])
            rows.append([f"{strength:g} MPa: {name}", str(len(sizes[name])), f"{mu:.3f} +- {error:.3f}",
                         "" if name == "base" else f"{percent(mu, base[0])} ({difference:+.1f} s.e.)", depth])
            labels.append(f"{strength:g} MPa: {name}"), values.append(mu / base[0]), errors.append(error / base[0])
    dots(labels, values, errors, picture, "$\\mu/\\mu$(base)", [(1, dict(color="k", ls="--"), "base: 40 across, 32 rows, 1 held")])
    return table(["", "runs", "mu", "against base", "depth, nm"], rows)


# timestep -----------------------------------------------------------------------------------------
def step_of(log):
    """Time step of a run (ns), from the head of its log."""
    with open(log, encoding="utf-8") as file:
        return next(float(found[1]) for text in file if (found := re.search(r"^# run: .*timestep: ([-+.e0-9]+)", text)))


def case_of(point):
    """What a run shares with those of other steps: `v5` of v5-dt5e-05-seed1."""
    return re.sub("-(dt.*|seed.*)", "", run_name(point))


def timestep(report, picture):
    """mu at the usual step, half and a quarter of it; for three steps what a straight line makes of it at none."""
    rows, lines, cases = [], [], {}
    found = groups(report["report"]["points"], case_of)
    for name, members in sorted(found.items(), key=lambda item: (item[0][0], len(item[0]), item[0])):
        at = {step: mean_of(runs) for step, runs in groups(members, lambda p: step_of(p["file"])).items()}
        usual = max(at)
        if 0.25 * usual not in at:
            continue
        cases[name] = members[0], at[usual], at[0.25 * usual]
        full, half, quarter = ("{:.3f} +- {:.3f}".format(*at[f * usual]) if f * usual in at else "" for f in (1, 0.5, 0.25))
        at_none = ""
        if half:
            dt, (mu, error) = np.array(list(at)), np.array(list(at.values())).T
            (_, none), covariance = np.polyfit(dt, mu, 1, w=1 / error, cov="unscaled")
            lines.append((members[0]["velocity"], none, math.sqrt(covariance[1, 1])))
            at_none = "{:.3f} +- {:.3f}".format(*lines[-1][1:])
        rows.append([name, f"{members[0]['kappa3']:.0f}", f"{members[0]['mu_eq2']:.3f}", full, half, quarter,
                     percent(at[0.25 * usual][0], at[usual][0]), at_none])
    if not lines:
        raise Missing("no run at the plans' step, half and a quarter of it")
    equal = [entry[1:] for name, entry in cases.items() if re.match("v5|c", name)]
    (spread, own), (spread_quarter, own_quarter) = (scatter_of(*np.array([e[k] for e in equal]).T) for k in (0, 1))
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    for axes, pattern, key in ((left, "v", "velocity"), (right, "v5|c", "kappa3")):
        shown = sorted((p[key], p["mu_eq2"], full, small) for name, (p, full, small) in cases.items() if re.match(pattern, name))
        x = np.array([entry[0] for entry in shown])
        for k, label in ((2, "usual step"), (3, "a quarter of it")):
            mu, error = np.array([entry[k] for entry in shown]).T
            axes.errorbar(x, mu, yerr=1.96 * error, fmt=f"C{k - 2}o", capsize=2, label=f"{label}, 95 %")
        axes.plot(x, [entry[1] for entry in shown], "k--", lw=1, label="Eq. 2")
        axes.grid(alpha=0.3)
    velocity, none, error = np.array(lines).T
    left.errorbar(velocity, none, yerr=1.96 * error, fmt="C2s", mfc="none", capsize=2, label="line to no step, 95 %")
    left.set(xlabel="v (m/s)", ylabel="$\\mu$", xlim=(0, None), ylim=(0, None))
    right.set(xlabel="$\\kappa_3 = E/\\sigma_0$ at equal $\\kappa_1$, $\\kappa_2$", ylabel="$\\mu$", ylim=(0, None))
    left.legend(fontsize=9)
    save(figure, picture)
    return [*table(["mu", "kappa3", "Eq. 2", "usual step", "half", "a quarter", "", "none (line)"], rows), "",
            f"Scatter of the {len(equal)} at equal kappa1 and kappa2: usual step {spread:.1f} % (own errors {own:.1f} %), "
            f"a quarter {spread_quarter:.1f} % ({own_quarter:.1f} %)"]


# corrected ----------------------------------------------------------------------------------------
def steps_of(log):
    """`plain` or `corrected`: the keyword steps of the laws that made a log; the first logs, of plain ones, do not name it."""
    with open(log, encoding="utf-8") as file:
        found = re.search(r"^# laws: .*\bsteps: (\w+)", file.read(4096), re.MULTILINE)
    return found[1] if found else "plain"


def corrected(report, picture):
    """mu with plain and with corrected steps: against the step at 5 and 10 m/s, and at the usual step against velocity."""
    points = [p for p in report["report"]["points"] if re.fullmatch("v[0-9]+", case_of(p))]
    if not any(steps_of(p["file"]) == "corrected" for p in points):
        raise Missing("no run with `steps corrected`")
    laws = ("plain", "corrected")
    usual = 5e-5
    mu = {key: mean_of(runs) for key, runs in
          groups(points, lambda p: (steps_of(p["file"]), p["velocity"], step_of(p["file"]))).items()}
    steps = sorted({step for _, _, step in mu}, reverse=True)
    shown = [v for v in sorted({v for _, v, _ in mu}) if sum(("corrected", v, step) in mu for step in steps) > 1]

    def text(law, velocity, step):
        return "{:.3f} +- {:.3f}".format(*mu[law, velocity, step]) if (law, velocity, step) in mu else ""

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    rows = []
    for k, law in enumerate(laws):
        for marker, v in zip("osD", shown):
            rows.append([f"{v:g} m/s, {law}", *(text(law, v, step) for step in steps)])
            known = [(1e6 * step, *mu[law, v, step]) for step in steps if (law, v, step) in mu]
            x, value, error = np.array(known).T
            left.errorbar(x, value, yerr=1.96 * error, fmt=f"C{k}{marker}-", lw=0.8, capsize=2, label=f"{v:g} m/s, {law}")
    eq2 = {p["velocity"]: p["mu_eq2"] for p in points}
    both = [v for v in eq2 if all((law, v, usual) in mu for law in laws)]
    velocities = []
    for k, law in enumerate(laws):
        x, value, error = np.array([(v, *mu[law, v, usual]) for v in sorted(both)]).T
        right.errorbar(x, value, yerr=1.96 * error, fmt=f"C{k}o", capsize=2, label=f"{law}, 95 %")
    right.plot(sorted(both), [eq2[v] for v in sorted(both)], "k--", lw=1, label="Eq. 2")
    for v in sorted(both):
        velocities.append([f"{v:g} m/s", f"{eq2[v]:.3f}", *(text(law, v, usual) for law in laws),
                           percent(mu["corrected", v, usual][0], mu["plain", v, usual][0])])
    left.set(xlabel="step (fs)", ylabel="$\\mu$, 95 %", xlim=(0, None))
    right.set(xlabel="v (m/s)", ylabel="$\\mu$", xlim=(0, None), ylim=(0, None))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=9)
    save(figure, picture)
    return [*table(["mu", *(f"{1e6 * step:g} fs" for step in steps)], rows), "",
            *table([f"{1e6 * usual:g} fs", "Eq. 2", *laws, ""], velocities)]


FIGURES = {
    "fig3": Figure("Fig. 3: depth of the sliding layer (N1)", ["roughness", "growth", "viscosity"], fig3),
    "fig4": Figure("Fig. 4: friction stress against pressure (N2)", ["pressure"], fig4, ["--grinding-in", "100", *EQUILIBRIUM]),
    "fig6": Figure(f"Fig. 6: mu against velocity, {FROM} (N3)", ["velocity"], fig6, EQUILIBRIUM),
    "collapse": Figure("Equal kappa1 and kappa2, from 50 ns on (N4)", ["collapse10"], collapse, LATER),
    "fig7": Figure("Figs. 7 and 8: the law, from 50 ns on (N5, N6)", ["paper36"], fig7, LATER),
    "steel": Figure(f"The law of one material, E = 206 GPa and sigma_0 = 92 MPa, {FROM}", ["velocity", "pressure"], fig7,
                    EQUILIBRIUM),
    "kappa3": Figure("The law with a third number, kappa3 = E/sigma_0, from 50 ns on", ["paper36", "velocity", "pressure"], kappa3,
                     ["--model", "eq2_kappa3", "--kappa3", str(STEEL), *LATER]),
    "sensitivity": Figure("Sensitivity of mu to the laws, from 15 ns on", ["variants"], sensitivity, ["--start", "15"]),
    "convergence": Figure("Size of the fragment, from 10 ns on", ["convergence"], convergence, ["--start", "10"]),
    "timestep": Figure("Friction with plain steps against the step, from 10 ns on",
                       ["timestep"], timestep, ["--start", "10"]),
    "corrected": Figure("Friction with plain and with corrected steps, from 10 ns on",
                        ["timestep", "corrected"], corrected, ["--start", "10"]),
}
