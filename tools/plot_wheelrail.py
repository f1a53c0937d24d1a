#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures 10, 12, 13, 14 and 15 of Bucher et al., Wear 261 (2006) 874, computed with wr_creep.

    plot_wheelrail.py fig14 -o DIR        one figure: DIR/fig14.png, fig14.csv and fig14.json
    plot_wheelrail.py all -o DIR          all of them, about a minute

fig10  pressure in the rough contact: along x for three rms slopes, and as a map over the load
fig12  share of the nominal area that carries more than a pressure, for cut-offs 10, 0.1, 0.025 mm
fig13  local friction coefficient, traction and its bound along the contact
fig14  creep curves at low creep: smooth and rough, for several friction coefficients
fig15  creep curves at high creep: fall with temperature at 10, 20 and 40 m/s
area   real contact area and peak pressure against load
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 5 files cannot be written; otherwise that of wr_creep.
"""

import argparse
import csv
import io
import json
import os
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from typing import Any

from mcawr import plotting, programs, tables
from mcawr.command_line import Parser, file_name, whole_in
from mcawr.errors import Exit, fail, fail_as, run_script, say
from mcawr.files import make_folder, picture, write_all

ROOT = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
CASE = os.path.join(ROOT, "examples", "wheelrail", "table2.yaml")
SLOPES = (0.01, 0.02, 0.04)
CUTOFFS = (
    9.39,
    0.1,
    0.025,
)  # mm; 9.39 is the one wave near 10 mm that has whole periods on the domain
HEIGHT = 7.94  # um, rms height of the surface with slope 0.02 and cut-off 0.1 mm
NOTHING = ["friction={law: constant, mu: 0.3}", "thermal=off", "speed=20 m/s", "creep=[1e-3]"]
HALF_WIDTH = 4.697817  # mm, Table 2

given: argparse.Namespace  # set by main(), as the modules that take a while to load are
np: Any = None
plt: Any = None


def rough(shortest: float = 0.1, **amplitude: object) -> str:
    """The roughness keyword of a standard surface."""
    size = ", ".join(f"{name}: {value}" for name, value in amplitude.items())
    waves = f"wavelength_min: {shortest} mm, wavelength_max: 10 mm"
    return f"roughness={{hurst: 0.8, {size}, {waves}, seed: {given.seed}}}"


def wr_creep(
    *changes: str,
) -> tuple[dict[float, dict[str, list[float]]], dict[str, Any], dict[str, Any]]:
    """(creep rows by speed, contact columns, summary) of Table 2 with these changes."""
    with tempfile.TemporaryDirectory() as folder:
        command = [given.wr_creep, CASE, "-o", folder, "-q"]
        for change in changes:
            command += ["--set", change]
        try:
            done = subprocess.run(
                command, stderr=subprocess.PIPE, text=True, errors="replace", check=False
            )
        except OSError as error:
            fail(
                Exit.IO, f"{given.wr_creep}: {error.strerror}; build it, or name it with --wr-creep"
            )
        if done.returncode:
            fail_as(given.wr_creep, done)
        speeds: dict[float, dict[str, list[float]]] = {}
        contact: dict[str, Any] = {}
        for row in tables.rows(os.path.join(folder, "creep.csv")):
            for name in row:
                speeds.setdefault(row.number("speed"), {}).setdefault(name, []).append(
                    row.number(name)
                )
        for row in tables.rows(os.path.join(folder, "contact.csv")):
            for name, value in row.items():
                contact.setdefault(name, []).append(value if name == "state" else row.number(name))
        summary = tables.read_json(
            os.path.join(folder, "summary.json"), "a summary", lambda found: dict[str, Any](found)
        )
    return speeds, {k: v if k == "state" else np.array(v) for k, v in contact.items()}, summary


def path_of(name: str) -> str:
    return os.path.join(given.output, name)


def finish(
    figure: Any,
    name: str,
    comment: str,
    header: Sequence[str],
    rows: Iterable[Iterable[Any]],
    **facts: Any,
) -> None:
    """The picture, and its numbers as CSV and as JSON: {"figure", "comment", ..., "columns": {name:
    [values]}}."""
    rows = [[float(f"{v:.8g}") if isinstance(v, float) else v for v in row] for row in rows]
    table = io.StringIO()
    table.write(f"# {comment}\n")
    writer = csv.writer(table, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    columns = dict(zip(header, map(list, zip(*rows))))
    facts = {"figure": name, "comment": comment, **facts, "columns": columns}
    write_all(
        {
            path_of(name + ".csv"): table.getvalue(),
            path_of(name + ".json"): json.dumps(facts),
            path_of(name + ".png"): picture(figure, path_of(name + ".png"), dpi=150),
        }
    )
    say(f"{path_of(name)}.png, .csv, .json")


def fig10() -> None:
    figure, axes = plt.subplots(2, 2, figsize=(10, 7), constrained_layout=True)
    rows, facts = [], {}
    for axis, slope in zip(axes.flat, SLOPES):
        _, contact, summary = wr_creep(*NOTHING, "cells=4096", rough(rms_slope=slope))
        x, p = contact["x"], contact["pressure"]
        axis.fill_between(x, p, color="C0", lw=0)
        inside = np.abs(x) < HALF_WIDTH
        hertz = np.where(inside, 542.056 * np.sqrt(np.maximum(0, 1 - (x / HALF_WIDTH) ** 2)), 0)
        axis.plot(x, hertz, "k", lw=1, label="smooth (Hertz)")
        facts[slope] = {
            k: summary["contacts"][0][k]
            for k in ("real_area_ratio", "peak_pressure_MPa", "micro_contacts")
        }
        axis.set(
            xlim=(-8, 8),
            ylim=(0, None),
            xlabel="x, mm",
            ylabel="pressure, MPa",
            title=f"rms slope {slope}: real area {100 * facts[slope]['real_area_ratio']:.0f} %, "
            f"peak {facts[slope]['peak_pressure_MPa']:.0f} MPa",
        )
        axis.legend(fontsize=8)
        rows += [(slope, float(a), float(b)) for a, b in zip(x, p)]
    loads = np.linspace(250, 6000, 24)
    field = []
    for (
        load
    ) in loads:  # one domain for all loads: contact.domain counts in the load's own half-width
        domain = 4 * np.sqrt(4000 / load)
        _, contact, _ = wr_creep(
            *NOTHING,
            f"contact.load_per_length={load} N/mm",
            f"contact.domain={domain:.12g}",
            "cells=2048",
            rough(rms_slope=0.02),
        )
        field.append(np.where(contact["pressure"] > 0, contact["pressure"], np.nan))
    mesh = axes[1, 1].pcolormesh(
        contact["x"], loads, np.array(field), shading="nearest", cmap="magma_r", vmin=0
    )
    figure.colorbar(mesh, ax=axes[1, 1], label="pressure, MPa")
    axes[1, 1].set(
        xlim=(-8, 8), xlabel="x, mm", ylabel="load, N/mm", title="rms slope 0.02, growing load"
    )
    finish(
        figure,
        "fig10",
        "pressure along the contact of Table 2; x: mm; pressure: MPa",
        ("rms_slope", "x", "pressure"),
        rows,
        contacts=facts,
    )


def fig12() -> None:
    figure, axis = plt.subplots(figsize=(7, 4.5), constrained_layout=True)
    levels = np.linspace(0, 6000, 301)
    columns = {}
    for cutoff in CUTOFFS:
        _, contact, summary = wr_creep(
            *NOTHING, "cells=8192", rough(cutoff, rms_height=f"{HEIGHT} um")
        )
        p = contact["pressure"]
        cell = contact["x"][1] - contact["x"][0]
        share = np.array([np.sum(p > level) for level in levels]) * cell / (2 * HALF_WIDTH)
        columns[cutoff] = share
        area = summary["contacts"][0]["real_area_ratio"]
        axis.plot(levels, 100 * share, label=f"cut-off {cutoff:g} mm: real area {100 * area:.0f} %")
    hertz = np.sqrt(np.maximum(0, 1 - (levels / 542.056) ** 2))
    axis.plot(levels, 100 * hertz, "k--", lw=1, label="smooth (Hertz)")
    axis.set(
        xlabel="pressure, MPa",
        ylabel="area with more than this pressure, % of nominal",
        xlim=(0, 6000),
        ylim=(0, None),
        title="Distribution of pressure over area (rms height 7.9 um)",
    )
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)
    finish(
        figure,
        "fig12",
        "share of the nominal area that carries more than the pressure (MPa), by cut-off (mm)",
        ["pressure"] + [f"cutoff_{c:g}" for c in CUTOFFS],
        [[float(v)] + [float(columns[c][k]) for c in CUTOFFS] for k, v in enumerate(levels)],
    )


def fig13() -> None:
    figure, axes = plt.subplots(2, 2, figsize=(10, 6), sharex=True, constrained_layout=True)
    rows = []
    local = [
        "friction={law: bucher2006, local: true, velocity_term: false}",
        "thermal=off",
        "speed=20 m/s",
        "creep=[2e-3]",
    ]
    for column, surface in enumerate(["roughness=none", rough(rms_slope=0.01)]):
        _, c, _ = wr_creep(*local, "cells=4096", surface)
        name = "smooth" if column == 0 else "rms slope 0.01"
        touching = c["pressure"] > 0
        mu = np.where(touching, c["mu"], np.nan)
        axes[0, column].plot(c["x"], mu, "C0")
        axes[0, column].axhline(0.4743, color="k", ls=":", lw=1, label="p -> 0: 0.4743 (Eq. 12)")
        axes[0, column].set(ylabel="local mu (Eq. 5)", ylim=(0.25, 0.5), title=name)
        axes[0, column].legend(fontsize=8)
        axes[1, column].plot(c["x"], c["mu"] * c["pressure"], "0.6", label="bound mu p")
        axes[1, column].plot(c["x"], c["traction"], "C3", lw=1, label="traction at creep 0.002")
        axes[1, column].set(
            xlabel="x, mm (leading edge right)", ylabel="MPa", xlim=(-6, 6), ylim=(0, None)
        )
        axes[1, column].legend(fontsize=8)
        rows += [
            (name, float(a), float(b), float(m), float(q))
            for a, b, m, q in zip(c["x"], c["pressure"], c["mu"], c["traction"])
            if b > 0
        ]
    finish(
        figure,
        "fig13",
        "x: mm; pressure, traction: MPa",
        ("surface", "x", "pressure", "mu", "traction"),
        rows,
    )


def curves(axis: Any, cases: Any, creep: Any, speed: str, points: int = 2048) -> Any:
    """Draws T/N and returns rows; cases: (label, style, changes)."""
    rows = []
    for label, style, changes in cases:
        by_speed, _, _ = wr_creep(f"creep={creep}", f"speed={speed}", f"cells={points}", *changes)
        for v, curve in by_speed.items():
            name = label.format(v=v)
            axis.plot(curve["creep"], curve["traction_ratio"], **style(v), label=name)
            rows += [
                (name, c, t, h)
                for c, t, h in zip(
                    curve["creep"], curve["traction_ratio"], curve["temperature_rise"]
                )
            ]
    return rows


def fig14() -> None:
    figure, axis = plt.subplots(figsize=(7.5, 5), constrained_layout=True)
    cases = []
    for k, surface in enumerate(["smooth"] + [f"rms slope {s}" for s in SLOPES]):
        change = "roughness=none" if k == 0 else rough(rms_slope=SLOPES[k - 1])
        for mu, line in ((0.2, ":"), (0.3, "-"), (0.4, "--")):
            cases.append(
                (
                    f"{surface}, mu = {mu}",
                    lambda v, k=k, line=line: {"color": f"C{k}", "ls": line},
                    [change, f"friction={{law: constant, mu: {mu}}}", "thermal=off"],
                )
            )
    rows = curves(axis, cases, "{from: 0, to: 0.005, n: 51, spacing: linear}", "20 m/s")
    axis.set(
        xlabel="creep",
        ylabel="T/N",
        xlim=(0, 0.005),
        ylim=(0, 0.42),
        title="Low creep, frozen roughness",
    )
    axis.grid(alpha=0.3)
    axis.legend(fontsize=7, ncol=2)
    finish(
        figure,
        "fig14",
        "creep curves at low creep, constant friction, frozen roughness",
        ("curve", "creep", "traction_ratio", "temperature_rise"),
        rows,
    )


def fig15() -> None:
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), sharey=True, constrained_layout=True)
    material = "conductivity: 50 W/(m K), density: 7800 kg/m3, specific_heat: 450 J/(kg K)"
    creep = "{from: 0, to: 0.1, n: 101, spacing: linear}"
    color = {10.0: "C0", 20.0: "C1", 40.0: "C2"}
    cases = [
        ("smooth, {v:g} m/s", lambda v: {"color": color[v]}, [f"thermal={{{material}}}"]),
        (
            "rms slope 0.02, {v:g} m/s",
            lambda v: {"color": color[v], "ls": "--"},
            [f"thermal={{{material}}}", rough(rms_slope=0.02)],
        ),
    ]
    rows = [
        ("averaged",) + row for row in curves(axes[0], cases, creep, "[10 m/s, 20 m/s, 40 m/s]")
    ]
    cases = [
        (
            label,
            style,
            changes[1:]
            + [f"thermal={{{material}, model: local}}", "friction={law: bucher2006, local: true}"],
        )
        for label, style, changes in cases
    ]
    rows += [("local",) + row for row in curves(axes[1], cases, creep, "[10 m/s, 20 m/s, 40 m/s]")]
    for axis, title in zip(axes, ("averaged law and Eq. 11", "local law and flash temperature")):
        axis.set(xlabel="creep", ylabel="T/N", xlim=(0, 0.1), ylim=(0, 0.45), title=title)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    finish(
        figure,
        "fig15",
        "creep curves at high creep, law bucher2006; temperature_rise: K",
        ("friction", "curve", "creep", "traction_ratio", "temperature_rise"),
        rows,
    )


def area() -> None:
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
    rows = []
    for slope in SLOPES:
        loads = np.geomspace(125, 8000, 19)
        shares, peaks = [], []
        for load in loads:
            # the profile of Table 2's domain for every load; wide enough for the largest
            _, _, s = wr_creep(
                *NOTHING,
                f"contact.load_per_length={load} N/mm",
                f"contact.domain={4 * np.sqrt(4000 / load):.12g}",
                "cells=4096",
                rough(rms_slope=slope),
            )
            contact = s["contacts"][0]
            shares.append(contact["real_contact_length_mm"])
            peaks.append(contact["peak_pressure_MPa"])
            rows.append(
                (
                    slope,
                    float(load),
                    contact["real_contact_length_mm"],
                    contact["real_area_ratio"],
                    contact["peak_pressure_MPa"],
                )
            )
        axes[0].plot(loads, shares, "o-", ms=3, label=f"rms slope {slope}")
        axes[1].plot(loads, peaks, "o-", ms=3, label=f"rms slope {slope}")
    axes[0].plot(loads, 2 * HALF_WIDTH * np.sqrt(loads / 4000), "k--", label="smooth (Hertz)")
    axes[1].plot(loads, 542.056 * np.sqrt(loads / 4000), "k--", label="smooth (Hertz)")
    loads_shown = (200, 500, 1000, 2000, 5000)
    for axis, label, shown in (
        (axes[0], "real contact length, mm", (0.1, 0.2, 0.5, 1, 2, 5, 10)),
        (axes[1], "peak pressure, MPa", (100, 200, 500, 1000, 2000, 5000)),
    ):
        axis.set(xscale="log", yscale="log", xlabel="load, N/mm", ylabel=label)
        axis.set_xticks(loads_shown, map(str, loads_shown))
        axis.set_yticks(shown, map(str, shown))
        axis.minorticks_off()
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    finish(
        figure,
        "area",
        "load: N/mm; length: mm; peak: MPa",
        ("rms_slope", "load", "real_contact_length", "real_area_ratio", "peak_pressure"),
        rows,
    )


FIGURES = {
    "fig10": fig10,
    "fig12": fig12,
    "fig13": fig13,
    "fig14": fig14,
    "fig15": fig15,
    "area": area,
}


def arguments() -> argparse.Namespace:
    parser = Parser(__doc__)
    parser.add_argument("figure", choices=[*FIGURES, "all"])
    parser.add_argument(
        "-o", "--output", type=file_name, default=".", metavar="DIR", help="folder for the files"
    )
    parser.add_argument(
        "--seed", type=whole_in(0, 2**31 - 1), default=1, help="of the generated profiles [1]"
    )
    parser.add_argument(
        "--wr-creep", type=file_name, default=programs.program("wr_creep"), metavar="PROGRAM"
    )
    return parser.parse_args()


def main() -> None:
    global given, np, plt
    given = arguments()
    plt = plotting.pyplot()
    import numpy as np

    make_folder(given.output)
    for name in FIGURES if given.figure == "all" else [given.figure]:
        FIGURES[name]()


if __name__ == "__main__":
    run_script(main)
