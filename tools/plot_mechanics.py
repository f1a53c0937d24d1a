#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of doc/howto_mechanics.md: experiments in lmp whose outcome is known exactly.

    plot_mechanics.py surface -o DIR      one figure, DIR/mechanics_surface.png, and its numbers
    plot_mechanics.py all -o DIR          all of them, some minutes

surface  bars with free sides: stress of each row, error of Young's modulus against the number of
         rows
waves    phase speeds against wavelength, of the lattice and of bars
hertz    a rigid cylinder on a block of three sizes: pressure, half-width against the load
diagram  stress-strain diagrams in tension and shear through the points of Fig. 5, with unloading
energy   where the work of sliding goes in 1e5 steps, and what the account misses; an elastic block,
         1e6 steps
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 5 no lmp, or files cannot be written.
"""

import os
import pathlib
import sys
import tempfile
from typing import Any

from mcawr import plotting
from mcawr.command_line import Parser, file_name
from mcawr.errors import Exit, fail, run_script, say
from mcawr.files import make_folder, save_figure

ROOT = pathlib.Path(__file__).resolve().parent.parent


def surface(m: Any, np: Any, plt: Any, work: pathlib.Path) -> Any:
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    for plane, colour in (("strain", "tab:blue"), ("stress", "tab:orange")):
        rows, error, skinned = (6, 10, 20, 40), [], []
        stiffer = 1 / m.surface_row(plane)[2]
        for n in rows:
            r = m.bar(work, n, plane)
            error.append(100 * (r["bar"] - 1))
            skinned.append(100 * (m.bar(work, n, plane, stiffer)["bar"] - 1))
            say(
                f"plane {plane}, {n} rows: E of the bar {error[-1]:+.2f} %, over n - 1/3 rows "
                f"{100 * (r['bar'] * n / (n - 1 / 3) - 1):+.2f} %, interior E "
                f"{r['interior'] - 1:+.1e}, "
                f"Poisson's ratio {r['poisson'] - 1:+.1e}; outermost rows {stiffer:.3f} times "
                "stiffer: "
                f"{skinned[-1]:+.4f} %"
            )
            if n == 10:
                left.plot(
                    np.arange(1, 11),
                    r["sxx"],
                    "o-",
                    color=colour,
                    label=f"$\\sigma_{{xx}}$, plane {plane}",
                )
                left.plot(
                    np.arange(1, 11),
                    r["mean"] / r["mean"][5],
                    "s--",
                    color=colour,
                    mfc="none",
                    label=f"$\\sigma_\\mathrm{{mean}}$, plane {plane}",
                )
        right.plot(rows, error, "o", color=colour, label=f"plane {plane}")
        right.plot(
            rows,
            skinned,
            "^",
            color=colour,
            mfc="none",
            label=f"... with a skin {stiffer:.3f} times stiffer",
        )
    n = np.linspace(5, 42, 200)
    right.plot(n, -100 / (3 * n), "k-", lw=1, label="$-1/(3n)$")
    left.set(xlabel="row", ylabel="over the value of the solid")
    right.set(xlabel="number of rows n", ylabel="error of E, %")
    for axis in (left, right):
        axis.legend(fontsize=8)
    return figure


def waves(m: Any, np: Any, plt: Any, work: pathlib.Path) -> Any:
    figure, axis = plt.subplots(figsize=(5.6, 3.8))
    grid = np.geomspace(3.5, 300, 200)
    for mode, colour, name in (
        ("l", "tab:blue", "longitudinal"),
        ("s", "tab:orange", "transverse"),
    ):
        lengths = (4, 6, 8, 12, 16, 32, 64, 128)
        speeds = [m.wave_speed(work, mode, columns=n)[0] for n in lengths]
        continuum = m.wave_speed(work, mode, columns=4)[1]
        for n, c in zip(lengths, speeds):
            say(
                f"{name}, {n} d: {c:.1f} m/s, {100 * (c / continuum - 1):+.3f} % of the solid's, "
                f"{c / m.lattice_speed(mode, n) - 1:+.1e} of the lattice's"
            )
        axis.plot(lengths, speeds, "o", color=colour, label=f"{name}, lmp")
        axis.plot(
            grid,
            [m.lattice_speed(mode, g) for g in grid],
            "-",
            color=colour,
            label="lattice, exact",
        )
        axis.axhline(continuum, ls=":", color=colour)
    ends, bars = (128, 256), []
    for n in ends:
        c, solid = m.wave_speed(work, "bar", columns=n, rows=20, free=True)
        say(f"bar of 20 rows, {n} d: {c:.1f} m/s, {100 * (c / solid - 1):+.2f} % of the plate's")
        bars.append(c)
    axis.plot(lengths, bars, "^", color="tab:green", label="bar with free sides, lmp")
    axis.axhline(solid, ls=":", color="tab:green")
    axis.set(
        xscale="log",
        xlabel="wavelength / d",
        ylabel="phase speed, m/s (dotted: the solid)",
        ylim=(0, 6500),
    )
    axis.legend(fontsize=8, loc="lower right")
    return figure


def hertz(m: Any, np: Any, plt: Any, work: pathlib.Path) -> Any:
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    sizes, widths, peaks = [], [], []
    for size, marker in ((4, "s"), (8, "^"), (16, "o")):
        r = m.hertz(work, size)
        a, shown = r["hertz"], r["pressure"] > 0
        sizes.append(a / m.D)
        widths.append(r["half_width"] / a - 1)
        peaks.append(r["p0"] / r["hertz_p0"] - 1)
        say(
            f"a = {a / m.D:.2f} d: load {r['load']:.0f} MPa nm, half-width "
            f"{100 * widths[-1]:+.2f} %, "
            f"largest pressure {100 * peaks[-1]:+.2f} %, half a distance {50 * m.D / a:.1f} %"
        )
        left.plot(
            r["x"][shown] / a,
            r["pressure"][shown] / r["hertz_p0"],
            marker,
            ms=4,
            mfc="none",
            label=f"a = {a / m.D:.1f} d",
        )
    x = np.linspace(-1, 1, 400)
    left.plot(x, np.sqrt(1 - x * x), "k-", lw=1, label="Hertz")
    left.set(xlabel="x / a", ylabel="pressure / $p_0$")
    right.plot(sizes, 100 * np.array(widths), "o-", label="half-width")
    right.plot(sizes, 100 * np.array(peaks), "s-", label="largest pressure")
    grid = np.linspace(min(sizes), max(sizes), 100)
    right.fill_between(grid, -50 / grid, 50 / grid, color="0.9", label="half a distance, d/2a")
    right.axhline(0, color="k", lw=0.8)
    right.set(xlabel="half-width a / d", ylabel="error, %")
    for axis in (left, right):
        axis.legend(fontsize=8)
    return figure


def diagram(m: Any, np: Any, plt: Any, work: pathlib.Path) -> Any:
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.5, 3.8))
    points = {m.Y1 / m.E: m.Y1, 0.015: m.Y2, m.BREAKING: m.STRENGTH}
    for kind, law, style in (
        ("tension", "radial", "-"),
        ("tension", "isochoric", "--"),
        ("shear", "radial", "-"),
        ("shear", "isochoric", "--"),
    ):
        r = m.diagram(work, kind, f"plasticity {law}", every=2)
        first = min(e[0] for e in r["events"])
        whole = r["step"] <= first
        strain, stress = m.measured_diagram(r)
        imposed = r["exx" if kind == "tension" else "shear"]
        colour = "tab:blue" if kind == "tension" else "tab:orange"
        left.plot(
            100 * strain[whole], stress[whole], style, color=colour, lw=1.2, label=f"{kind}, {law}"
        )
        left.plot(100 * strain[whole][-1], stress[whole][-1], "x", color=colour, ms=8)
        right.plot(
            100 * strain[whole],
            r["mean"][whole],
            style,
            color=colour,
            lw=1.2,
            label=f"{kind}, {law}",
        )
        say(
            f"{kind}, {law}: "
            + ", ".join(
                f"{np.interp(e, strain, stress):.1f} MPa at {100 * e:.3g} % (Fig. 5: {s:.1f})"
                for e, s in points.items()
            )
            + f"; first break at {100 * np.interp(first, r['step'], imposed):.3f} %, "
            f"mean stress there {r['mean'][whole][-1]:.0f} MPa"
        )
    for kind, colour in (("tension", "tab:blue"), ("shear", "tab:orange")):
        r = m.diagram(work, kind, "plasticity radial fracture none", every=2, reverse=True)
        turn = int(np.argmax(r["exx" if kind == "tension" else "shear"]))
        sign = np.where(r["sxx" if kind == "tension" else "sxy"] < 0, -1, 1)
        strain = m.measured_diagram(r)[0]
        # past the turn, the imposed strain itself: it falls by what is elastic
        back = (
            strain[turn] - (r["exx"][turn] - r["exx"])
            if kind == "tension"
            else strain[turn] - (r["shear"][turn] - r["shear"]) / np.sqrt(3)
        )
        left.plot(
            100 * back[turn:],
            (sign * r["equivalent"])[turn:],
            ":",
            color=colour,
            lw=1.2,
            label=f"{kind}, unloaded and reversed",
        )
    left.plot(
        [100 * e for e in points],
        list(points.values()),
        "ko",
        mfc="none",
        ms=9,
        label="Fig. 5",
        zorder=5,
    )
    left.set(xlabel="equivalent strain, % (x: first link breaks)", ylabel="equivalent stress, MPa")
    right.set(xlabel="equivalent strain, %", ylabel="mean stress, MPa")
    for axis in (left, right):
        axis.legend(fontsize=7, loc=(0.03, 0.12) if axis is left else "best")
    return figure


def energy(m: Any, np: Any, plt: Any, work: pathlib.Path) -> Any:
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    slide = m.lmp("in.energy_sliding", work, steps=100000).thermo[0]
    time, account = 5e-5 * slide["Step"], [slide[f"c_energy[{k}]"] for k in range(1, 7)]
    left.stackplot(time, account[2:5], labels=["plastic flow", "breaking", "viscosity"], alpha=0.7)
    left.plot(time, account[5], "k-", lw=1, label="work of the driven layer")
    left.set(xlabel="time, ns", ylabel="energy, 1e-21 J")
    left.legend(fontsize=8, loc="upper left")
    lost = sum(account[2:5])
    missed = np.abs(slide["c_energy"][1:] / lost[1:])
    right.semilogy(slide["Step"][1:], missed, label="sliding: error / dissipated")
    block = m.lmp("in.energy_elastic", work, steps=1000000).thermo[0]
    held = block["c_energy[1]"][0] + block["c_energy[2]"][0]
    swing = np.abs(block["c_energy"][1:] / held)
    right.semilogy(block["Step"][1:], swing, "o", label="elastic block: error / energy")
    right.set(xlabel="step", ylabel="error of the account")
    right.legend(fontsize=8)
    shares = ", ".join(
        f"{name} {100 * part[-1] / lost[-1]:.1f} %"
        for name, part in zip(("plastic", "fracture", "viscous"), account[2:5])
    )
    say(
        f"sliding, 1e5 steps: {shares}; error {missed[-1]:.1e} of what was dissipated, at most "
        f"{missed.max():.1e}"
    )
    say(f"elastic block, 1e6 steps: error at most {swing.max():.1e} of its energy")
    return figure


FIGURES = {"surface": surface, "waves": waves, "hertz": hertz, "diagram": diagram, "energy": energy}


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("figure", choices=[*FIGURES, "all"])
    parser.add_argument(
        "-o", "--out", type=file_name, default=".", metavar="DIR", help="folder of the pictures"
    )
    parser.add_argument(
        "--build",
        type=file_name,
        default=os.environ.get("MCAWR_BUILD", ROOT / "build"),
        metavar="DIR",
        help="build folder with bin/lmp [build/ of the checkout]",
    )
    options = parser.parse_args()
    build = pathlib.Path(options.build).resolve()
    plt = plotting.pyplot()
    import numpy as np

    program = build / "bin" / "lmp"
    if not (program.is_file() and os.access(program, os.X_OK)):
        fail(Exit.IO, f"no {program}: build the project first, or give --build FOLDER")
    make_folder(options.out)
    os.environ.update(
        MCA_LMP=str(program),
        PROJECT_SOURCE=str(ROOT),
        MCA_PLUGIN=str(build / "lib" / "mcaplugin.so"),
    )
    sys.path.append(str(ROOT / "unittest" / "MCA"))  # the experiments are those of the tests
    import mechanics

    for name in FIGURES if options.figure == "all" else [options.figure]:
        with tempfile.TemporaryDirectory() as work:
            figure = FIGURES[name](mechanics, np, plt, pathlib.Path(work))
        figure.tight_layout()
        path = os.path.join(options.out, f"mechanics_{name}.png")
        save_figure(figure, path, dpi=110)
        say(path)


if __name__ == "__main__":
    run_script(main)
