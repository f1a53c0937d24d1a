#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The sheared fragment: automata of a LAMMPS text dump as discs, and the velocity profile.

    plot_fragment.py friction.dump -o fragment.png
    plot_fragment.py friction.dump --show vx links --frame 1 -o fragment.png
    plot_fragment.py friction.dump --show stripes -o fragment.gif
    plot_fragment.py DIR/NAME/run.*.dump --show vx -o fragment.gif

One panel for each word after --show:
  stripes    the block an automaton began in; the dark stripes were vertical in the first frame of
             the dump, so they show where the material is sheared and mixed
  type       the same without stripes
  vx, vy     velocity; where vx changes is the layer that slides
  links, welds, plastic, intensity
             columns of compute mca/atom, under these names or as in.friction writes them
             (c_state[1] to c_state[4])
  any other column by its name in the dump, for instance c_state[2]
The last panel is the mean of vx over each height. The dump needs the columns id, type, x, y and vx.
Several dumps, such as the files of a campaign, one a frame, are put in the order
of their steps; the time step is that of run.json beside them.
Where the box is periodic along x, automata are drawn within one period. A triclinic box is refused.
An output that ends in .gif is an animation of all frames. Exit codes: 0 ok, 1 no matplotlib or no
Pillow, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""

import argparse
import io
import math
from typing import Any

from mcawr import plotting
from mcawr.campaign_record import timestep_of
from mcawr.command_line import Parser, file_name, number_in, whole_in
from mcawr.dump import Film
from mcawr.errors import BadInput, Exit, complain, fail, run_script
from mcawr.files import check_apart, check_size, save_figure, write

NEEDED = ("id", "type", "x", "y", "vx")
HEIGHTS = {"z", "zu", "zs", "zsu"}
STRIPES = 8  # across the fragment
MOST_LINKS = 100  # of an automaton; a contact of discs has 6
STATE = {
    name: f"c_state[{k}]" for k, name in enumerate(("links", "welds", "plastic", "intensity"), 1)
}
TITLES = {
    "vx": "velocity along x",
    "vy": "velocity along y",
    "links": "links",
    "welds": "welds",
    "type": "blocks",
    "stripes": "blocks, with stripes that began vertical",
    "plastic": "equivalent plastic strain",
    "intensity": "stress intensity (von Mises)",
}
LABELS = {
    "vx": "$v_x$ (nm/ns = m/s)",
    "vy": "$v_y$ (nm/ns = m/s)",
    "links": "links of an automaton",
    "welds": "welds of an automaton",
    "plastic": "plastic strain (-)",
    "intensity": "stress intensity (MPa)",
}
PAINT = {1: ("#9ecae1", "#2171b5"), 2: ("#fdbe85", "#d94801")}  # of each type light and dark


def nearest_distance(x: list[float], y: list[float]) -> float:
    """Diameter of the automata: the spacing in the first frame."""
    return min((math.hypot(x[0] - a, y[0] - b) for a, b in zip(x[1:], y[1:])), default=1.0)


def profile(y: list[float], vx: list[float], height: float) -> tuple[list[float], list[float]]:
    """Mean of vx over slices of that height; (means, middles of the slices)."""
    slices: dict[float, list[float]] = {}
    for a, v in zip(y, vx):
        slices.setdefault(a // height, []).append(v)
    rows = [(sum(v) / len(v), height * (k + 0.5)) for k, v in sorted(slices.items())]
    return [mean for mean, _ in rows], [middle for _, middle in rows]


class Picture:
    """All panels of one figure; show(number) draws a frame."""

    def __init__(self, plt: Any, dump: Film, given: argparse.Namespace) -> None:
        self.dump, self.given = dump, given
        self.names = set(NEEDED) | {p for p in given.show if p != "stripes"}
        begin = dump.columns(0, NEEDED)
        spacing = nearest_distance(begin["x"], begin["y"])
        if spacing == 0:
            raise of_space(dump, "two automata have the same x and y")
        _, _, (back, front) = dump.frames[0]["box"]
        if not HEIGHTS & set(dump.frames[0]["names"]) and front - back > 2 * spacing:
            raise of_space(
                dump, f"the box goes from z = {back:g} to {front:g}, and there is no column z"
            )
        self.diameter = given.diameter or spacing
        low, high = self.sides(dump.frames[0], [begin])
        if self.diameter > high - low:
            fail(Exit.USAGE, f"--diameter {self.diameter:g}: the box is {high - low:g} wide")
        self.stripe = {
            i: int((x - low) / (high - low) * 2 * STRIPES) % 2
            for i, x in zip(begin["id"], begin["x"])
        }
        # everything that must not change within an animation
        frames = range(len(dump.frames)) if given.animated else [given.frame]
        everything = [dump.columns(k, self.names) for k in frames]
        self.left, self.right = self.sides(dump.frames[given.frame], everything)
        self.low = min(min(c["y"]) for c in everything) - self.diameter
        self.high = max(max(c["y"]) for c in everything) + self.diameter
        self.range = {
            p: self.limits(p, everything) for p in given.show if p not in ("stripes", "type")
        }

        self.lay_out(plt, (self.high - self.low) / (self.right - self.left))

    def sides(self, frame: dict[str, Any], shown: list[dict[str, Any]]) -> tuple[float, float]:
        """Limits of x: the period, or a radius beyond the box and the automata that are shown."""
        low, high = frame["box"][0]
        if frame["periodic"][0]:
            return low, high
        radius = 0.5 * self.diameter
        low = min(low, *(min(columns["x"]) for columns in shown))
        high = max(high, *(max(columns["x"]) for columns in shown))
        return low - radius, high + radius

    def lay_out(self, plt: Any, ratio: float) -> None:
        """Axes of the panels, their colour bars and the profile, all of the same height."""
        left, bottom, top, gap, bar = 0.65, 0.55, 0.7, 0.35, 1.0  # inches
        wide, tall, narrow = 4.6, max(4.6 * ratio, 1.0), 1.5
        places, at = [], left
        for panel in self.given.show:
            places.append((panel, at, wide))
            at += wide + gap
            if panel in self.range:
                places.append((panel + " bar", at - gap + 0.1, 0.15))
                at += bar - gap
        if self.given.profile:
            places.append(("profile", at, narrow))
            at += narrow + gap
        self.figure = plt.figure(figsize=(at, bottom + tall + top))
        self.axes = {
            name: self.figure.add_axes(
                (x / at, bottom / (bottom + tall + top), w / at, tall / (bottom + tall + top)),
                label=name,
            )
            for name, x, w in places
        }

    def limits(self, panel: str, everything: Any) -> tuple[float, float]:
        values = sorted(v for columns in everything for v in columns[panel])
        if panel in ("links", "welds"):
            if values[0] < 0 or values[-1] > MOST_LINKS:
                raise BadInput(
                    f"{self.dump.path}: {panel} from {values[0]:g} to {values[-1]:g}: 0 to "
                    f"{MOST_LINKS} of an automaton are expected"
                )
            return -0.5, max(values[-1], 6 if panel == "links" else 1) + 0.5
        # single debris may fly much faster than all the rest
        low, high = (values[round(q * (len(values) - 1))] for q in (0.01, 0.99))
        if panel == "vx" or values[0] >= 0.0:
            low = min(0.0, low)
        return (low, high) if high > low else (low, low + 1.0)

    def show(self, number: int) -> None:
        frame, columns = self.dump.frames[number], self.dump.columns(number, self.names)
        for axes in self.axes.values():
            axes.cla()
        for panel in self.given.show:
            self.panel(self.axes[panel], panel, frame, columns)
        self.axes[self.given.show[0]].set_ylabel("y (nm)")
        for panel in self.given.show[1:]:
            self.axes[panel].tick_params(labelleft=False)
        if self.given.profile:
            self.velocities(self.axes["profile"], columns)
        time = frame["time"] if frame["time"] is not None else frame["step"] * self.given.timestep
        self.figure.suptitle(f"{frame['count']} automata after {time:.3g} ns", fontsize=11, y=0.985)

    def velocities(self, axes: Any, columns: dict[str, Any]) -> None:
        means, heights = profile(columns["y"], columns["vx"], self.diameter)
        axes.plot(means, heights, "o-", ms=3)
        axes.set_xlabel("mean $v_x$ (m/s)")
        axes.set_title("velocity profile", fontsize=10)
        if "vx" in self.range:
            low, high = self.range["vx"]
            axes.set_xlim(low - 0.1 * (high - low), high + 0.1 * (high - low))
        axes.set_ylim(self.low, self.high)
        axes.tick_params(labelleft=False)
        axes.grid(alpha=0.3)

    def panel(self, axes: Any, panel: str, frame: dict[str, Any], columns: dict[str, Any]) -> None:
        x, y, which = self.images(frame, columns)
        discs = self.discs(axes, x, y)
        if panel in ("stripes", "type"):
            shade = self.stripe if panel == "stripes" else {}
            paint = [
                PAINT.get(int(t), ("0.75", "0.45"))[shade.get(i, 0)]
                for i, t in zip(columns["id"], columns["type"])
            ]
            discs.set_facecolor([paint[k] for k in which])
        else:
            self.colour(axes, discs, panel, columns[panel], which)
        axes.set_aspect("equal")
        axes.set_xlim(frame["box"][0] if frame["periodic"][0] else (self.left, self.right))
        axes.set_ylim(self.low, self.high)
        axes.set_xlabel("x (nm)")
        axes.set_title(TITLES.get(panel, panel), fontsize=10)

    def images(
        self, frame: dict[str, Any], columns: dict[str, Any]
    ) -> tuple[list[float], list[float], Any]:
        """x, y and rows of all discs: one on the edge of a period is seen on both sides."""
        if not frame["periodic"][0]:
            return columns["x"], columns["y"], range(len(columns["x"]))
        low, high = frame["box"][0]
        width, radius = high - low, 0.5 * self.diameter
        x, y, which = [], [], []
        for k, (a, b) in enumerate(zip(columns["x"], columns["y"])):
            a = low + (a - low) % width
            for image in (a, a + width, a - width):
                if low - radius < image < high + radius:
                    x.append(image)
                    y.append(b)
                    which.append(k)
        return x, y, which

    def discs(self, axes: Any, x: Any, y: Any) -> Any:
        from matplotlib.collections import EllipseCollection

        size = [self.diameter] * len(x)
        discs = EllipseCollection(
            size,
            size,
            [0] * len(x),
            units="xy",
            offsets=list(zip(x, y)),
            offset_transform=axes.transData,
            linewidths=0,
        )
        axes.add_collection(discs)
        return discs

    def colour(self, axes: Any, discs: Any, panel: str, values: Any, which: Any) -> None:
        import matplotlib

        low, high = self.range[panel]
        counted = panel in ("links", "welds")
        steps = round(high - low)
        discs.set_cmap(matplotlib.colormaps["viridis"].resampled(steps) if counted else "viridis")
        discs.set_array([values[k] for k in which])
        discs.set_clim(low, high)
        beyond = (min(values) < low, max(values) > high) if not counted else (False, False)
        extend = {(True, True): "both", (True, False): "min", (False, True): "max"}.get(
            beyond, "neither"
        )
        self.figure.colorbar(
            discs,
            cax=self.axes[panel + " bar"],
            label=LABELS.get(panel, panel),
            extend=extend,
            ticks=range(steps) if counted else None,
        )


def animate(picture: Picture, frames: Any, rate: float, dpi: float) -> bytes:
    """Bytes of a GIF that shows all frames in turn, for ever."""
    pages = []
    check_size(picture.figure, dpi)
    for number in range(frames):
        picture.show(number)
        page = io.BytesIO()
        picture.figure.savefig(page, dpi=dpi, format="png")
        pages.append(page.getvalue())
    return plotting.film(pages, rate)


def arguments() -> argparse.Namespace:
    parser = Parser(__doc__)
    parser.add_argument("dump", type=file_name, metavar="DUMP", nargs="+")
    parser.add_argument(
        "-o",
        "--output",
        type=file_name,
        default="fragment.png",
        metavar="FILE",
        help="*.png or *.gif",
    )
    parser.add_argument(
        "--show",
        nargs="+",
        default=["stripes", "vx"],
        metavar="WHAT",
        help="panels, see above [stripes vx]",
    )
    parser.add_argument(
        "--no-profile", dest="profile", action="store_false", help="without the velocity profile"
    )
    parser.add_argument(
        "--frame",
        type=whole_in(-(10**9), 10**9),
        default=-1,
        help="frame of the dump, from 0, or from the end, -1 [the last]",
    )
    parser.add_argument(
        "--diameter",
        type=number_in(),
        metavar="NM",
        help="of an automaton [the spacing in the first frame]",
    )
    parser.add_argument(
        "--timestep",
        type=number_in(),
        metavar="NS",
        help="for the title, where the dump has no time [that of run.json beside it, or 4e-5]",
    )
    parser.add_argument(
        "--rate", type=number_in(0.1, 50), default=5, help="frames per second of a GIF [5]"
    )
    parser.add_argument("--dpi", type=number_in(10, 1200), default=130, help="[130]")
    given = parser.parse_args()
    check_apart(given.dump, [given.output])
    if given.timestep is None:
        given.timestep = timestep_of(given.dump[0]) or 4e-5
    given.show = list(dict.fromkeys(given.show))
    given.animated = given.output.lower().endswith(".gif")
    return given


def read(paths: list[str]) -> Film:
    dump = Film(paths, STATE)
    for path in dump.cut:
        complain(f"{path}: the last frame is cut and left out")
    for number, frame in enumerate(dump.frames):
        if frame["count"] == 0:
            raise BadInput(f"{dump.path_of(number)}:{frame['head'] + 1}: no automaton")
        if frame["triclinic"]:
            raise BadInput(f"{dump.path_of(number)}: a triclinic box cannot be drawn")
    for height in sorted(HEIGHTS.intersection(dump.frames[0]["names"])):
        values = dump.columns(0, [height])[height]
        if max(values) > min(values):
            raise of_space(dump, f"{height} goes from {min(values):g} to {max(values):g}")
    return dump


def of_space(dump: Film, why: str) -> BadInput:
    """The error for a dump of three dimensions."""
    return BadInput(
        f"{dump.path}:{dump.frames[0]['head'] + 1}: {why}: only a dump of two dimensions can be "
        "drawn; dump_to_vtk.py takes this one"
    )


def main() -> None:
    given = arguments()
    dump = read(given.dump)
    if not -len(dump.frames) <= given.frame < len(dump.frames):
        fail(Exit.USAGE, f"--frame {given.frame}: the dump has {len(dump.frames)} frames")
    for number in (0, given.frame):
        dump.columns(number, set(NEEDED) | {p for p in given.show if p != "stripes"})
    picture = Picture(plotting.pyplot(), dump, given)
    if given.animated:
        write(given.output, animate(picture, len(dump.frames), given.rate, given.dpi))
    else:
        picture.show(given.frame)
        save_figure(picture.figure, given.output, given.dpi)


if __name__ == "__main__":
    run_script(main)
