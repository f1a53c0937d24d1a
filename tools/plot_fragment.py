#!/usr/bin/python3
"""The sheared fragment: automata of a LAMMPS text dump at one moment, and its velocity profile.

    plot_fragment.py friction.dump -o fragment.png
    plot_fragment.py friction.dump --frame 1 --diameter 2.5 -o fragment.png

Left: the automata, coloured by the block they began in; the dark stripes were vertical in the
first frame of the dump, so they show where the material is sheared. Middle: velocity along x; where
it changes is the layer that slides. Right: its mean over each height. The dump needs the columns
id, type, x, y and vx. Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture
cannot be written.
"""
import argparse
import os
import sys

NEEDED = ("id", "type", "x", "y", "vx")
STRIPES = 8  # across the fragment


def fail(code, text):
    print(f"plot_fragment.py: {text}", file=sys.stderr)
    sys.exit(code)


def read_frame(path, lines, number):
    """(step, box, {column: values}, next line number) of the frame that starts at lines[number]."""
    try:
        if lines[number] != "ITEM: TIMESTEP":
            raise ValueError
        step = int(lines[number + 1])
        count = int(lines[number + 3])
        box = [tuple(map(float, lines[number + k].split()[:2])) for k in (5, 6)]
        names = lines[number + 8].split()[2:]
        first = number + 9
        rows = [line.split() for line in lines[first:first + count]]
        if len(rows) < count or any(len(row) != len(names) for row in rows):
            return None  # cut: the run was interrupted while it wrote
    except (IndexError, ValueError):
        fail(3, f"{path}:{number + 1}: not a frame of a LAMMPS text dump")
    missing = [name for name in NEEDED if name not in names]
    if missing:
        fail(3, f"{path}:{number + 9}: column {missing[0]} is missing, needed: {' '.join(NEEDED)}")
    try:
        columns = {name: [float(row[names.index(name)]) for row in rows] for name in NEEDED}
    except ValueError:
        fail(3, f"{path}:{first + 1}: not numbers in this frame")
    return step, box, columns, first + count


def read_dump(path):
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    except (OSError, UnicodeDecodeError) as error:
        fail(3, f"{path}: cannot be read: {error}")
    frames, number = [], 0
    while number < len(lines):
        frame = read_frame(path, lines, number)
        if frame is None:
            break
        *content, number = frame
        frames.append(content)
    if not frames:
        fail(3, f"{path}: no whole frame in it")
    return frames


def nearest_distance(x, y):
    """Diameter of the automata: the spacing in the first frame."""
    return min(((x[0] - a) ** 2 + (y[0] - b) ** 2) ** 0.5 for a, b in zip(x[1:], y[1:]))


def profile(y, vx, height):
    """Mean of vx over slices of that height; (middle of the slice, mean)."""
    slices = {}
    for a, v in zip(y, vx):
        slices.setdefault(a // height, []).append(v)
    return zip(*((height * (k + 0.5), sum(v) / len(v)) for k, v in sorted(slices.items())))


def draw(axes, box, x, y, diameter, colours, **options):
    from matplotlib.collections import EllipseCollection

    discs = EllipseCollection([diameter] * len(x), [diameter] * len(x), [0] * len(x), units="xy",
                              offsets=list(zip(x, y)), offset_transform=axes.transData,
                              linewidths=0, **options)
    if options:
        discs.set_array(colours)
    else:
        discs.set_facecolor(colours)
    axes.add_collection(discs)
    axes.set_aspect("equal")
    axes.set_xlim(*box[0])
    axes.set_ylim(min(y) - diameter, max(y) + diameter)
    axes.set_xlabel("x (nm)")
    return discs


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dump", metavar="DUMP")
    parser.add_argument("-o", "--output", default="fragment.png", metavar="PNG")
    parser.add_argument("--frame", type=int, default=-1, help="frame of the dump, from 0 [the last]")
    parser.add_argument("--diameter", type=float, help="of an automaton, nm [spacing of the first frame]")
    parser.add_argument("--timestep", type=float, default=5e-5, help="ns, for the title [5e-5]")
    given = parser.parse_args()
    frames = read_dump(given.dump)
    if not -len(frames) <= given.frame < len(frames):
        fail(2, f"--frame {given.frame}: the dump has {len(frames)} frames")
    _, box, start, = frames[0]
    step, _, now = frames[given.frame]
    diameter = given.diameter or nearest_distance(start["x"], start["y"])
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        fail(1, "matplotlib is missing (Debian: apt-get install python3-matplotlib); no picture made")

    width = box[0][1] - box[0][0]
    stripe = {i: int((x - box[0][0]) / width * 2 * STRIPES) % 2 for i, x in zip(start["id"], start["x"])}
    paint = {(1, 0): "#9ecae1", (1, 1): "#2171b5", (2, 0): "#fdbe85", (2, 1): "#d94801"}
    colours = [paint.get((int(t), stripe.get(i, 0)), "0.5") for t, i in zip(now["type"], now["id"])]

    figure, (left, middle, right) = plt.subplots(
        1, 3, figsize=(13, 4.2), constrained_layout=True, sharey=True,
        gridspec_kw={"width_ratios": [1, 1.12, 0.45]})
    # the periodic box is drawn once: automata beyond its edges come back on the other side
    x = [box[0][0] + (a - box[0][0]) % width for a in now["x"]]
    draw(left, box, x, now["y"], diameter, colours)
    left.set_title("blocks, with stripes that began vertical", fontsize=10)
    left.set_ylabel("y (nm)")
    top = max(now["vx"])
    heights, means = profile(now["y"], now["vx"], diameter)
    limit = max(abs(v) for v in means)
    discs = draw(middle, box, x, now["y"], diameter, now["vx"], cmap="viridis")
    discs.set_clim(min(0, min(means)), limit)
    figure.colorbar(discs, ax=middle, label="$v_x$ (nm/ns = m/s)", extend="both" if top > limit else "neither")
    middle.set_title("velocity along x", fontsize=10)
    right.plot(means, heights, "o-", ms=3)
    right.set_xlabel("mean $v_x$ (m/s)")
    right.set_title("velocity profile", fontsize=10)
    right.grid(alpha=0.3)
    figure.suptitle(f"{len(x)} automata after {step * given.timestep:.3g} ns of sliding", fontsize=11)
    beside = given.output + ".part"
    try:
        figure.savefig(beside, dpi=130, format="png")
        os.replace(beside, given.output)
    except OSError as error:
        if os.path.exists(beside):
            os.remove(beside)
        fail(5, f"{given.output}: cannot be written: {error.strerror}")


if __name__ == "__main__":
    main()
