"""The layer and its age: figures from the profiles beside the logs, and from the whole of the logs."""
import math
import re

import numpy as np
from matplotlib import pyplot

import plot_friction
from . import layer
from .common import Missing, groups, run_name, save, table

PAPER_DEPTH = 10.0          # nm, of the quasi-liquid layer
ROWS, ROUGHNESS = 32, 3.25  # of the blocks of all other plans; the roughness in nm
TIMES = ((50, 100), (100, 200), (200, 400))             # ns
LONG_TIMES = ((25, 50), *TIMES, (400, 600))             # ns
AGED, BLOCK, FAST = 100, 25, 4  # ns from which mu ~ t^n is fitted, to means over so many ns; m/s


def friction_series(points):
    """Times (ns) and mu of the logs of runs."""
    return [np.array(plot_friction.read_log(p["file"])[1:]) for p in points]


def depth_series(members):
    """Times (ns) and depth (nm) of the layers of runs (point, layer)."""
    return [(found.time, found.depth) for _, found in members]


def shortest(members):
    """Time (ns) that all runs (point, layer) have reached; inf of none."""
    return min((f.time[-1] for _, f in members), default=math.inf)


def second_half(members, end):
    """Cells of depth (nm) and mu of runs (point, layer) from half of the time `end` (ns) up to it; and the depth, its error, mu."""
    depth, error = layer.mean_depth([f for _, f in members], end)
    mu, mu_error = layer.window(friction_series(p for p, _ in members), end / 2, end, 8)
    return [f"{depth:.1f} +- {error:.1f}", f"mu {mu:.3f} +- {mu_error:.3f}"], depth, error, mu


def growth(members, axes):
    """Rows of depth (nm) and mu of the runs (point, layer) in times (ns) that double; draws the power law of the depth."""
    end, growing, rows = shortest(members), [], []
    depths, logs = depth_series(members), friction_series(p for p, _ in members)
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


def with_layers(points):
    """The runs (point, layer) of the points."""
    members = [(point, layer.read(point["file"])) for point in points]
    for point, found in members:
        if found is None:
            raise Missing(f"{point['file']}: no profile beside it (a plan with `profile` makes one)")
    return members


def roughness_of(point):
    """Largest deviation (nm) of a run of `roughness`: 1.4 of roughness1.4-seed1; None of others."""
    found = re.match("roughness([0-9.]+)", run_name(point))
    return float(found[1]) if found else None


def fig3(report, picture):
    """Depth of the layer, from the profiles beside the logs, and mu: against initial roughness, in times that double, against viscosity."""
    layers = with_layers(report["report"]["points"])
    rough = [(p, f) for p, f in layers if roughness_of(p) is not None]
    viscous = groups([(p, f) for p, f in layers if "eta" in run_name(p)], lambda x: x[0]["viscosity"])
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    rows = []
    for k, (amplitude, members) in enumerate(groups(rough, lambda x: roughness_of(x[0])).items()):
        for number, (_, found) in enumerate(members):
            left.plot(found.time, found.depth, color=f"C{k}", lw=1, label=None if number else f"initial roughness {amplitude:g} nm")
        cells, *_ = second_half(members, shortest(rough))
        rows.append([f"roughness {amplitude:g} nm", f"{PAPER_DEPTH:g}", *cells])
    usual = [(p, f) for p, f in rough if roughness_of(p) == ROUGHNESS]
    if not usual:
        raise Missing(f"no run of roughness {ROUGHNESS} nm")
    rows += growth(usual, left)
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


def rows_of(point):
    """Rows of automata of a run: 24 of rows24-seed1."""
    found = re.match("rows([0-9]+)", run_name(point))
    return int(found[1]) if found else ROWS


def power_of_time(series):
    """n of y ~ t^n, its standard error, and y at 1 ns: a straight line through the logarithms of means over BLOCK ns from AGED on.

    series: a pair of arrays for each run, times (ns) and y of any unit."""
    points = []
    for time, y in series:
        edges = np.arange(AGED, time[-1] * (1 + 1e-9), BLOCK) * (1 + 1e-9)
        points += [(0.5 * (low + high), y[(time > low) & (time <= high)].mean()) for low, high in zip(edges, edges[1:])]
    (n, factor), covariance = np.polyfit(*np.log(points).T, 1, cov=True)
    return n, math.sqrt(covariance[0, 0]), math.exp(factor)


def power_text(fit):
    """Cell of what power_of_time found."""
    return f"{fit[0]:+.3f} +- {fit[1]:.3f}"


def height(report, picture):
    """Depth of the layer (nm) and mu in times that double, and their powers of time, for each number of rows."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    points = [p for p in report["report"]["points"] if roughness_of(p) in (None, ROUGHNESS)]
    lines = []
    for k, (rows, members) in enumerate(groups(with_layers(points), lambda x: rows_of(x[0])).items()):
        if shortest(members) < TIMES[-1][1]:
            raise Missing(f"runs of {rows} rows end at {shortest(members):g} ns, {TIMES[-1][1]} are needed")
        for number, (_, found) in enumerate(members):
            left.plot(found.time, found.depth, f"C{k}", lw=1.2, label=None if number else f"{rows} rows")
        depths, logs = depth_series(members), friction_series(p for p, _ in members)
        depth, mu = ([layer.window(series, *ends, blocks) for ends in TIMES] for series, blocks in ((depths, 2), (logs, 8)))
        for name, series, values, digits in (("depth, nm", depths, depth, 1), ("mu", logs, mu, 3)):
            cells = [f"{value:.{digits}f} +- {error:.{digits}f}" for value, error in values]
            lines.append([f"{name}, {rows} rows", *cells, power_text(power_of_time(series))])
        value, error = np.array(mu).T
        right.errorbar(np.mean(TIMES, axis=1) * (1 + 0.03 * (k - 1)), value, yerr=1.96 * error, fmt=f"C{k}o", capsize=2,
                       label=f"{rows} rows, 95 %")
    left.set(xlabel="time (ns)", ylabel="depth of the layer (nm), 10 to 90 % of $v$", xlim=(0, TIMES[-1][1]), ylim=(0, None))
    right.set(xlabel="time (ns)", ylabel="$\\mu$", xlim=(0, TIMES[-1][1]))
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=9)
    save(figure, picture)
    lines.sort(key=lambda cells: cells[0].startswith("mu"))
    return table(["", *(f"{begin} to {end} ns" for begin, end in TIMES), f"~ t^n from {AGED} ns"], lines)


def ageing(report, picture):
    """mu in times (ns) that double, and n of mu ~ t^n: at each velocity (m/s), which are drawn, and at each pressure (MPa)."""
    figure, axes = pyplot.subplots(figsize=(7.5, 4.6), constrained_layout=True)
    rows, fast = [], []
    cases = groups(report["report"]["points"], lambda p: (run_name(p).startswith("p"), p["velocity"], p["pressure"]))
    for k, ((of_pressures, velocity, pressure), members) in enumerate(cases.items()):
        case, series = f"{velocity:g} m/s, {pressure:g} MPa", friction_series(members)
        end = min(time[-1] for time, _ in series)
        if end < 2 * AGED:
            raise Missing(f"runs at {case} end at {end:g} ns, {2 * AGED} are needed")
        found = [(low, high, *layer.window(series, low, high, 8)) for low, high in LONG_TIMES if high <= end]
        n, error, factor = fit = power_of_time(series)
        cells = [f"{mu:.3f} +- {mu_error:.3f}" for _, _, mu, mu_error in found] + [""] * (len(LONG_TIMES) - len(found))
        rows.append([case, *cells, power_text(fit)])
        if of_pressures:
            continue
        if velocity >= FAST:
            fast.append((n, error))
        low, high, mu, mu_error = np.array(found).T
        line = np.geomspace(AGED, end, 20)
        axes.errorbar(np.sqrt(low * high) * 1.012**(k - 4), mu, yerr=1.96 * mu_error, fmt=f"C{k}o", ms=4, capsize=2, label=f"{velocity:g} m/s")
        axes.plot(line, factor * line**n, f"C{k}", lw=1)
    axes.set(xscale="log", yscale="log", xlabel="time (ns)", ylabel="$\\mu$, 95 %")
    axes.set_xticks([30, 100, 300], ["30", "100", "300"])
    axes.set_yticks([0.3, 0.35, 0.4, 0.45, 0.5], ["0.3", "0.35", "0.4", "0.45", "0.5"])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9, ncols=2)
    if not fast:
        raise Missing(f"no run of the plan velocity at {FAST} m/s or above")
    save(figure, picture)
    lines = table(["mu", *(f"{low} to {high} ns" for low, high in LONG_TIMES), f"mu ~ t^n from {AGED} ns"], rows)
    n, error = np.array(fast).T
    mean, mean_error = np.average(n, weights=error**-2), math.sqrt(1 / np.sum(error**-2))
    return [*lines, f"{FAST:g} m/s and above, 15 MPa: n = {mean:+.3f} +- {mean_error:.3f}, mu changes by "
                    f"{100 * (2**mean - 1):+.1f} +- {100 * math.log(2) * mean_error:.1f} % when the time doubles"]
