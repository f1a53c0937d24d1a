#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of contacts in three dimensions from the files of wr_creep.

    plot_patch.py fields smooth/fields_0003.vti rough/fields_0003.vti -o fields.png
    plot_patch.py friction smooth/fields_0003.vti rough/fields_0003.vti -o friction.png
    plot_patch.py curves out/creep.csv -o curves.png
    plot_patch.py curves out/creep.csv --polach polach.csv -o curves.png
    plot_patch.py transient out/series.csv -o start.png
    plot_patch.py transient out/series.csv --against time -o start.png
    plot_patch.py fields out/fields_0001_*.vti --animate -o start.gif

fields     pressure and traction with the border of the stick zones, one column a file, or with
           --animate one frame of a film (GIF) a file
friction   local friction coefficient over the contact and along its middle line (Fig. 13 of the
           paper in three dimensions), one column a file
curves     forces over load against longitudinal and lateral creep and spin, as far as they vary
transient  forces over load, share of stick, and creep and load where they change, with a load that
           changes force and power, too, against the distance rolled or the time, one curve a point
Exit codes: 0 ok, 1 no matplotlib (of --animate: or no Pillow), 2 usage, 3 bad input file, 5 the
picture cannot be written.
"""

import argparse
import os
from typing import Any

from mcawr import curves, fields, plotting, tables
from mcawr.command_line import Parser, file_name, number_in
from mcawr.errors import BadInput, Exit, Failure, run_script
from mcawr.files import check_apart, picture, save_figure, write

MOST_ARROWS = 24  # of the traction, along the longer side


# --------------------------------------------------------------------------- fields

np: Any = None  # set by main()
plt: Any = None


def label_of(given: argparse.Namespace, k: int, path: str) -> str:
    if k < len(given.label):
        return given.label[k]
    folder, name = os.path.split(os.path.abspath(path))
    return os.path.join(os.path.basename(folder), os.path.splitext(name)[0])


def read_all(given: argparse.Namespace, needed: Any) -> list[Any]:
    """Fields of all files that are to be drawn side by side. Raises BadInput."""
    columns = []
    for path in given.files:
        data = fields.read_vti(path)
        for name in needed:
            if name not in data.arrays:
                raise BadInput(f"{path}: holds no {name}")
        if not (data.arrays["pressure"] > 0).any():
            raise BadInput(f"{path}: nothing is in contact")
        columns.append(data)
    return columns


def window(columns: Any) -> tuple[tuple[float, float], tuple[float, float]]:
    """What to show of all files: their contacts and a little more."""
    boxes = []
    for data in columns:
        rows, places = np.nonzero(data.arrays["pressure"] > 0)
        boxes.append(
            (
                data.left + places.min() * data.dx,
                data.left + (places.max() + 1) * data.dx,
                data.bottom + rows.min() * data.dy,
                data.bottom + (rows.max() + 1) * data.dy,
            )
        )
    left, right = min(b[0] for b in boxes), max(b[1] for b in boxes)
    low, high = min(b[2] for b in boxes), max(b[3] for b in boxes)
    margin = 0.05 * max(right - left, high - low)
    return (left - margin, right + margin), (low - margin, high + margin)


def only_contact(data: fields.Fields, values: Any) -> Any:
    return np.where(data.arrays["pressure"] > 0, values, np.nan)


def stick_border(axis: Any, data: fields.Fields) -> None:
    """The border of the stick zones as a line along the cells' sides."""
    stick = (data.arrays["state"] == fields.STICK).astype(float)
    if not stick.any():
        return
    padded = np.pad(stick, 1)
    x = data.left + (np.arange(data.nx + 2) - 0.5) * data.dx
    y = data.bottom + (np.arange(data.ny + 2) - 0.5) * data.dy
    axis.contour(x, y, padded, levels=[0.5], colors="deepskyblue", linewidths=1.2)


def arrows(axis: Any, data: fields.Fields) -> None:
    """Directions of the traction on a coarse raster; all of one length."""
    every = max(1, max(data.nx, data.ny) // MOST_ARROWS)
    part = (slice(every // 2, None, every), slice(every // 2, None, every))
    traction = data.arrays["traction"][part]
    size = data.size_of("traction")[part]
    x = data.left + (np.arange(data.nx) + 0.5)[part[1]] * data.dx
    y = data.bottom + (np.arange(data.ny) + 0.5)[part[0]] * data.dy
    rows, places = np.nonzero(size > 1e-3 * size.max())
    unit = traction[rows, places, :2] / size[rows, places, None]
    axis.quiver(
        x[places], y[rows], unit[:, 0], unit[:, 1], color="0.2", pivot="mid", scale=30, width=0.004
    )


def panels(columns: Any, rows: Any, limits: Any, height: float = 3.6) -> tuple[Any, Any]:
    """A row of panels for each field, all with the same scale of lengths."""
    (left, right), (low, high) = limits
    width = height * min(1.6, max(0.6, (right - left) / (high - low)))
    size = (width * len(columns) + 1.4, height * rows)
    figure, axes = plt.subplots(
        rows, len(columns), figsize=size, squeeze=False, layout="constrained"
    )
    return figure, axes


def show(axis: Any, data: fields.Fields, values: Any, limits: Any, **style: Any) -> Any:
    image = axis.imshow(
        values, origin="lower", extent=data.extent, interpolation="nearest", **style
    )
    axis.set(xlim=limits[0], ylim=limits[1], aspect="equal")
    return image


def draw_fields(given: argparse.Namespace) -> None:
    columns = read_all(given, ("state", "pressure", "traction"))
    limits = window(columns)
    highest = [
        max(np.nanpercentile(only_contact(d, d.size_of(name)), 99.5) for d in columns)
        for name in ("pressure", "traction")
    ]
    if not given.animate:
        names = [label_of(given, k, path) for k, path in enumerate(given.files)]
        save_figure(fields_figure(columns, names, limits, highest), given.output, dpi=150)
        return
    pages = []
    for k, (data, path) in enumerate(zip(columns, given.files)):
        name = given.label[k] if k < len(given.label) else moment_of(data, path)
        pages.append(picture(fields_figure([data], [name], limits, highest), "", dpi=100))
    write(given.output, plotting.film(pages, given.rate))


def moment_of(data: fields.Fields, path: str) -> str:
    """When the fields of a file are: what stands before the colon of its title."""
    return data.title.split(":")[0] or os.path.splitext(os.path.basename(path))[0]


def fields_figure(columns: list[Any], names: list[str], limits: Any, highest: list[Any]) -> Any:
    figure, axes = panels(columns, 2, limits)
    for k, data in enumerate(columns):
        top, bottom = axes[0, k], axes[1, k]
        pressure = only_contact(data, data.arrays["pressure"])
        shown = show(top, data, pressure, limits, cmap="magma_r", vmin=0, vmax=highest[0])
        traction = only_contact(data, data.size_of("traction"))
        drawn = show(bottom, data, traction, limits, cmap="viridis", vmin=0, vmax=highest[1])
        for axis in (top, bottom):
            stick_border(axis, data)
        arrows(bottom, data)
        top.set_title(names[k])
        bottom.set_xlabel("x, mm (rolling to the right)")
    for row, image, name in ((0, shown, "pressure"), (1, drawn, "traction")):
        axes[row, 0].set_ylabel("y, mm")
        figure.colorbar(image, ax=list(axes[row]), label=f"{name}, MPa", extend="max")
    figure.suptitle("Blue line: border of stick; arrows: direction of the traction", fontsize=10)
    return figure


def draw_friction(given: argparse.Namespace) -> None:
    columns = read_all(given, ("pressure", "traction", "mu"))
    limits = window(columns)
    figure, axes = panels(columns, 2, limits, height=3.4)
    touching = [only_contact(d, d.arrays["mu"]) for d in columns]
    low = min(np.nanmin(mu) for mu in touching)
    high = max(np.nanmax(mu) for mu in touching)
    if high - low < 1e-9:  # constant friction
        low, high = 0.9 * low, 1.1 * high
    most = max(np.nanmax(d.size_of("traction")) for d in columns)
    for k, (data, path) in enumerate(zip(columns, given.files)):
        image = show(axes[0, k], data, touching[k], limits, cmap="cividis", vmin=low, vmax=high)
        axes[0, k].set(title=label_of(given, k, path))
        middle = int(np.clip(-data.bottom / data.dy, 0, data.ny - 1))
        axes[0, k].axhline(data.bottom + (middle + 0.5) * data.dy, color="crimson", lw=0.8, ls="--")
        along(axes[1, k], data, middle, (low, high), most)
        axes[1, k].set(xlim=limits[0], xlabel="x, mm (rolling to the right)")
    axes[0, 0].set_ylabel("y, mm")
    axes[1, 0].set_ylabel("traction along the dashed line, MPa")
    axes[1, -1].twin.set_ylabel("friction coefficient")
    lines = [*axes[1, -1].lines, *axes[1, -1].twin.lines]
    axes[1, -1].legend(
        handles=lines, fontsize=8, ncols=3, loc="lower right", bbox_to_anchor=(1.0, 1.0)
    )
    figure.colorbar(image, ax=list(axes[0]), label="local friction coefficient", shrink=0.75)
    save_figure(figure, given.output, dpi=150)


def along(axis: Any, data: fields.Fields, row: int, mu_limits: Any, most: float) -> None:
    """Traction, its bound and mu along one row of cells; mu on a scale of its own."""
    x = data.left + (np.arange(data.nx) + 0.5) * data.dx
    pressure, mu = data.arrays["pressure"][row], data.arrays["mu"][row]
    axis.plot(x, mu * pressure, color="0.6", lw=1, label="bound, mu p")
    axis.plot(x, data.size_of("traction")[row], color="C0", lw=1.2, label="traction")
    axis.twin = axis.twinx()
    inside = np.where(pressure > 0, mu, np.nan)
    axis.twin.plot(x, inside, color="crimson", lw=0.9, label="mu")
    margin = 0.1 * (mu_limits[1] - mu_limits[0])
    axis.twin.set_ylim(mu_limits[0] - margin, mu_limits[1] + margin)
    axis.set_ylim(0, 1.15 * most)


# --------------------------------------------------------------------------- curves

PANELS = {  # what is drawn over each creepage: (column, sign and scale, label)
    "creep": [("force_x", "-Fx/N")],
    "lateral": [("force_y", "-Fy/N")],
    "spin": [("force_y", "-Fy/N"), ("moment_z", "Mz/N, mm")],
}
AXES = {"creep": "longitudinal creep", "lateral": "lateral creep", "spin": "spin, 1/mm"}


def read_points(path: str, what: str, needed: Any) -> dict[str, Any]:
    """Columns of numbers. Raises BadInput."""

    def columns_of(rows: list[tables.Row]) -> dict[str, Any]:
        return {key: np.array([row.number(key) for row in rows]) for key in needed(rows)}

    columns = tables.read(path, what, columns_of)
    if not columns or not len(next(iter(columns.values()))):
        raise BadInput(f"{path}: no points")
    return columns


def creep_columns(rows: Any) -> list[str]:
    wanted = ["speed", *curves.CREEPAGES, "load", "force_x", "force_y", "moment_z"]
    more = (*curves.SURFACES, "force_x_se", "force_y_se")
    extra = [name for name in more if rows and name in rows[0]]
    return wanted + extra


def curves_over(points: dict[str, Any], coordinate: str) -> list[tuple[dict[str, Any], Any]]:
    """Rows of each curve: all other coordinates are the same, and at least two of this one."""
    return [
        (key, np.array(rows))
        for key, rows in curves.split(points, coordinate)
        if len(set(points[coordinate][rows])) > 1
    ]


def curve_name(label: str, key: dict[str, Any], points: Any) -> str:
    """What tells a curve from the others of its file."""
    varied = [name for name in key if len(set(points[name])) > 1]
    return ", ".join(filter(None, [label, *curves.words(key, varied)]))


def draw_curves(given: argparse.Namespace) -> None:
    files = [
        read_points(path, "a creep.csv of a 3D contact", creep_columns) for path in given.files
    ]
    varied = [c for c in curves.CREEPAGES if any(curves_over(points, c) for points in files)]
    if not varied:
        raise BadInput(f"{given.files[0]}: no curve: neither creep, lateral nor spin varies")
    law = (
        read_points(given.polach, "a table of wr_creep --polach", polach_columns)
        if (given.polach)
        else None
    )
    count = sum(len(PANELS[c]) for c in varied)
    across = count if count < 4 else 2
    size = (4.6 * across + 0.6, 4.0 * -(-count // across))
    figure, axes = plt.subplots(
        -(-count // across), across, figsize=size, squeeze=False, layout="constrained"
    )
    place = iter(axes.flat)
    for coordinate in varied:
        for column, label in PANELS[coordinate]:
            draw_panel(next(place), given, files, law, coordinate, column, label)
    save_figure(figure, given.output, dpi=150)


def polach_columns(_: Any) -> list[str]:
    return ["speed", *curves.CREEPAGES, "load", "polach_x", "polach_y"]


def draw_panel(
    axis: Any,
    given: argparse.Namespace,
    files: list[dict[str, Any]],
    law: Any,
    coordinate: str,
    column: str,
    label: str,
) -> None:
    sign = 1.0 if column == "moment_z" else -1.0
    for k, points in enumerate(files):
        name = given.label[k] if k < len(given.label) else ""
        for key, rows in curves_over(points, coordinate):
            rows = rows[np.argsort(points[coordinate][rows], kind="stable")]
            force = sign * points[column][rows] / points["load"][rows]
            error = points.get(f"{column}_se")
            axis.errorbar(
                points[coordinate][rows],
                force,
                None if error is None else error[rows] / points["load"][rows],
                fmt=["o-", "s--", "^:", "v-."][k % 4],
                ms=3,
                lw=1.2,
                capsize=2,
                label=curve_name(name, key, points) or None,
            )
    if law is not None and column != "moment_z":
        force = -law[f"polach_{column[-1]}"] / law["load"]
        for n, (_, rows) in enumerate(curves_over(law, coordinate)):
            rows = rows[np.argsort(law[coordinate][rows], kind="stable")]
            axis.plot(
                law[coordinate][rows],
                force[rows],
                "k-",
                lw=0.8,
                label=None if n else "Polach's law",
            )
    values = np.concatenate([p[coordinate] for p in files])
    if given.log and (values[values != 0] > 0).all():
        axis.set_xscale("log")
    else:
        axis.locator_params(axis="x", nbins=6)
    axis.set(xlabel=AXES[coordinate], ylabel=label)
    axis.grid(alpha=0.3)
    if axis.get_legend_handles_labels()[0]:
        axis.legend(fontsize=7)


# --------------------------------------------------------------------------- transients


def series_columns(rows: Any) -> list[str]:
    """Stages at rest have neither distance nor creep nor power."""
    rolling = [name for name in ("distance", "creep", "power") if rows and name in rows[0]]
    return ["point", "time", "load", "force_x", "force_y", "stick_fraction", *rolling]


AGAINST = {"distance": "distance rolled, mm", "time": "time, s"}
# name, label, scale; where the load changes, the force and its power say more than T/N
CHANGING = [("creep", "creep, %", 100.0), ("load", "load, kN", 1e-3)]
UNDER_A_LOAD = [("force", "tangential force, kN", 1e-3), ("power", "frictional power, W", 1.0)]


def read_series(path: str, against: str) -> dict[str, Any]:
    series = read_points(path, "a series.csv of wr_creep", series_columns)
    if against not in series:
        raise BadInput(f"{path}: stages at rest have no distance: --against time")
    series["force"] = np.hypot(series["force_x"], series["force_y"])
    return series


def draw_transient(given: argparse.Namespace) -> None:
    files = [read_series(path, given.against) for path in given.files]
    extra = [one for one in CHANGING if any(varies(s, one[0]) for s in files)]
    if any(varies(s, "load") for s in files):
        extra += [one for one in UNDER_A_LOAD if any(varies(s, one[0]) for s in files)]
    count = 2 + len(extra)
    figure, axes = plt.subplots(
        count, 1, figsize=(7, 2 + 2 * min(count, 4)), sharex=True, layout="constrained"
    )
    for k, (path, series) in enumerate(zip(given.files, files)):
        name = given.label[k] if k < len(given.label) else ""
        for point in sorted(set(series["point"])):
            rows = series["point"] == point
            way, ratio = series[given.against][rows], (series["force"] / series["load"])[rows]
            several = len(set(series["point"])) > 1
            label = ", ".join(filter(None, [name, f"point {point:g}" if several else ""]))
            style = ["-", "--", ":", "-."][k % 4]
            axes[0].plot(way, ratio, style, lw=1.2, label=label or None)
            axes[1].plot(way, 100 * series["stick_fraction"][rows], style, lw=1.2)
            for axis, (column, _, scale) in zip(axes[2:], extra):
                if column in series:
                    axis.plot(way, scale * series[column][rows], style, lw=1.2)
    axes[0].set(ylabel="tangential force\nover load, T/N", ylim=(0, None))
    axes[1].set(ylabel="stick, % of the contact", ylim=(0, 100))
    for axis, (_, label, _) in zip(axes[2:], extra):
        axis.set(ylabel=label)
    axes[-1].set(xlabel=AGAINST[given.against])
    for axis in axes:
        axis.grid(alpha=0.3)
    if axes[0].get_legend_handles_labels()[0]:
        axes[0].legend(fontsize=8)
    save_figure(figure, given.output, dpi=150)


def varies(series: dict[str, Any], column: str) -> bool:
    if column not in series:
        return False
    values, points = series[column], series["point"]
    return any(np.ptp(values[points == p]) > 1e-9 * abs(values).max() for p in set(points))


PICTURES = {
    "fields": (draw_fields, ".vti files of wr_creep"),
    "friction": (draw_friction, ".vti files of wr_creep"),
    "curves": (draw_curves, "creep.csv of wr_creep"),
    "transient": (draw_transient, "series.csv of wr_creep"),
}


def main() -> None:
    parser = Parser(__doc__)
    commands = parser.add_subparsers(dest="picture", required=True, metavar="PICTURE")
    for name, (_, files) in PICTURES.items():
        command = commands.add_parser(name)
        command.add_argument("files", nargs="+", type=file_name, metavar="FILE", help=files)
        command.add_argument(
            "-o",
            "--output",
            type=file_name,
            default=f"{name}.png",
            metavar="PNG",
            help="[%(default)s]",
        )
        command.add_argument(
            "--label", action="append", default=[], help="name of a file, in order"
        )
        if name == "curves":
            command.add_argument(
                "--polach", type=file_name, metavar="CSV", help="table of wr_creep --polach"
            )
            command.add_argument("--log", action="store_true", help="logarithmic creepages")
        if name == "transient":
            command.add_argument(
                "--against", choices=list(AGAINST), default="distance", help="[%(default)s]"
            )
        if name == "fields":
            command.add_argument("--animate", action="store_true", help="a film, one frame a file")
            command.add_argument(
                "--rate", type=number_in(0.1, 50), default=2, help="frames per second of a film [2]"
            )
    given = parser.parse_args()
    if getattr(given, "animate", False):
        if given.output == "fields.png":
            given.output = "fields.gif"
        if not given.output.lower().endswith(".gif"):
            raise Failure(Exit.USAGE, f"{given.output}: a film's name must end in .gif")
    read = [*given.files, *filter(None, [getattr(given, "polach", None)])]
    check_apart(read, [given.output])
    global plt, np
    plt = plotting.pyplot()
    import numpy as np

    PICTURES[given.picture][0](given)


if __name__ == "__main__":
    run_script(main)
