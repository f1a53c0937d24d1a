#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The sliding layer: its place, depth, growth and mixing, from the profiles of in.friction.

    mpirun -np 2 lmp -in in.friction -var ns 100 -var profile 100000
    plot_layer.py friction.profile -o layer.png --csv layer.csv

Each frame of the file (fix ave/chunk of examples/friction/in.friction) is a mean over so many
steps. Depth: height over which the mean velocity rises from 10 to 90 % of the top row's. Mixing:
height over which the share of automata of the upper block rises from 10 to 90 %; mean square
displacement along y in the layer since the beginning. Linked: mean number of links of an automaton
in the layer, over 6. Automata: mean number in a row of the layer; fewer than in one of the solid
where it is looser. Rows at the ends that hold less than 0.4 of what the fullest does are left out.
Times are those of the ends of the frames. Mixing is - where the share does not pass both levels.
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 a file cannot be written.
"""

import argparse
import csv
import io
import math

from mcawr import plotting
from mcawr.errors import BadInput, run_script, say
from mcawr.files import save_figure, write

COLUMNS = ["vx", "c_state[1]", "v_upper", "v_away2"]


def read_frames(path):
    """[(step, {column: values from bottom to top})] of rows that hold automata."""
    import numpy

    frames, names = {}, None
    try:
        with open(path, encoding="utf-8") as file:
            lines = iter(file.read().splitlines())
        for number, line in enumerate(lines, 1):
            words = line.split()
            if line.startswith("# Chunk Coord1"):
                names = words[2:]
                if names[:2] != ["Coord1", "Ncount"] or names[2:] != COLUMNS:
                    raise BadInput(
                        f"{path}:{number}: columns '{' '.join(names)}', must be "
                        f"'Coord1 Ncount {' '.join(COLUMNS)}'"
                    )
            elif words and not line.startswith("#"):
                if names is None or len(words) != 3:
                    raise BadInput(f"{path}:{number}: '{line}' where a frame should begin")
                rows = numpy.array(
                    [next(lines).split()[1:] for _ in range(int(words[1]))], dtype=float
                )
                if rows.shape[1:] != (len(names),):
                    raise BadInput(
                        f"{path}: the frame of step {words[0]} has rows of {rows.shape[1:]} columns"
                    )
                rows = rows[rows[:, 1] > 0]
                frames[int(words[0])] = dict(
                    zip(names, rows.T)
                )  # made again after a kill: the later one
    except StopIteration:
        pass  # the last frame is being written
    except (OSError, UnicodeDecodeError, ValueError) as error:
        raise BadInput(f"{path}: cannot be read: {error}") from None
    if not frames:
        raise BadInput(f"{path}: no frame")
    return sorted(frames.items())


def crossing(y, values, level, last):
    """Height where the profile passes the level: for the last time from the bottom, or the
    first."""
    import numpy

    above = values >= level
    candidates = numpy.flatnonzero(above[1:] != above[:-1])
    if not len(candidates):
        return float("nan")
    k = candidates[-1] if last else candidates[0]
    share = (level - values[k]) / (values[k + 1] - values[k])
    return float(y[k] + share * (y[k + 1] - y[k]))


def fragment(frame):
    """The frame without the rows beyond the fragment, that hold few automata or none: some may have
    left it through a held layer of one row."""
    import numpy

    full = numpy.flatnonzero(frame["Ncount"] >= 0.4 * frame["Ncount"].max())
    return {name: values[full[0] : full[-1] + 1] for name, values in frame.items()}


def measure(step, frame):
    """What a frame says of the layer."""
    frame = fragment(frame)
    y, speed = frame["Coord1"], frame["vx"]
    low, high = (
        crossing(y, speed, 0.1 * speed[-1], True),
        crossing(y, speed, 0.9 * speed[-1], False),
    )
    if high < low:  # a jump inside one row
        low, high = high, low
    inside = (y >= low) & (y <= high)
    if not inside.any():
        inside = abs(y - 0.5 * (low + high)) == abs(y - 0.5 * (low + high)).min()
    weight = frame["Ncount"][inside] / frame["Ncount"][inside].sum()
    first, end = (
        crossing(y, frame["v_upper"], level, last) for level, last in ((0.1, False), (0.9, True))
    )
    return {
        "step": step,
        "centre": 0.5 * (low + high),
        "depth": high - low,
        "mixed": end - first,
        "displacement2": float(weight @ frame["v_away2"][inside]),
        "linked": float(weight @ frame["c_state[1]"][inside]) / 6,
        "automata": float(frame["Ncount"][inside].mean()),
    }


def write_table(path, table):
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, table[0])
    writer.writeheader()
    writer.writerows(table)
    write(path, text.getvalue())


def draw(path, frames, table, step, length, time):
    figure, (left, middle, right) = plotting.pyplot().subplots(
        1, 3, figsize=(10.5, 3.8), layout="constrained"
    )
    shown = sorted({round(k * (len(frames) - 1) / 3) for k in range(4)})
    for k in shown:
        number, frame = frames[k]
        left.plot(frame["vx"], frame["Coord1"], label=f"{number * step:.3g} {time}")
    left.set(xlabel="mean velocity $v_x$", ylabel=f"height y [{length}]")
    left.legend(title="mean until")
    last = frames[-1][1]
    middle.plot(last["c_state[1]"] / 6, last["Coord1"], label="links / 6")
    middle.plot(last["v_upper"], last["Coord1"], label="share of the upper block")
    middle.axhspan(
        table[-1]["centre"] - 0.5 * table[-1]["depth"],
        table[-1]["centre"] + 0.5 * table[-1]["depth"],
        alpha=0.15,
        label="layer",
    )
    middle.set(xlabel="last frame", xlim=(-0.05, 1.05))
    middle.legend(loc="lower center", fontsize=8)
    times = [row["step"] * step for row in table]
    right.plot(times, [row["depth"] for row in table], label="10-90 % of the velocity")
    right.plot(times, [row["mixed"] for row in table], label="10-90 % of the upper block's share")
    right.plot(
        times, [row["displacement2"] ** 0.5 for row in table], label="rms displacement along y"
    )
    right.set(xlabel=f"time [{time}]", ylabel=f"depth [{length}]")
    right.set_ylim(bottom=0)
    right.legend(fontsize=8)
    save_figure(figure, path, dpi=140)


def show(table):
    """Prints a row for each frame."""
    say(
        f"{'step':>9} {'centre':>8} {'depth':>7} {'mixed':>7} {'displ.^2':>9} {'linked':>7} "
        f"{'automata':>8}"
    )
    for row in table:
        mixed = "-" if math.isnan(row["mixed"]) else f"{row['mixed']:.3f}"
        say(
            f"{row['step']:9d} {row['centre']:8.3f} {row['depth']:7.3f} {mixed:>7} "
            f"{row['displacement2']:9.3f} {row['linked']:7.3f} {row['automata']:8.2f}"
        )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("file", help="profile file of in.friction")
    parser.add_argument("-o", "--output", help="picture (.png, .pdf, .svg)")
    parser.add_argument("--csv", help="table with a row for each frame")
    parser.add_argument(
        "--step", type=float, default=5e-5, help="length of a step (default: 5e-5 ns)"
    )
    parser.add_argument(
        "--units",
        nargs=2,
        default=["nm", "ns"],
        metavar=("LENGTH", "TIME"),
        help="names of the units for the picture (default: nm ns)",
    )
    args = parser.parse_args()
    frames = read_frames(args.file)
    table = [measure(*frame) for frame in frames]
    if args.csv:
        write_table(args.csv, table)
    if args.output:
        draw(args.output, frames, table, args.step, *args.units)
    show(table)


if __name__ == "__main__":
    run_script(main)
