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

import csv
import io
import math
from typing import Any

from mcawr import plotting
from mcawr.campaign_record import timestep_of
from mcawr.command_line import Parser, file_name, number_in
from mcawr.errors import BadInput, run_script, say
from mcawr.files import check_apart, picture, read_text, write_all
from mcawr.numbers import decimal, whole
from mcawr.tables import LARGEST

COLUMNS = ["vx", "c_state[1]", "v_upper", "v_away2"]


def read_frames(path: str) -> list[Any]:
    """[(step, {column: values from bottom to top})] of rows that hold automata. Raises
    BadInput."""
    import numpy

    frames, names = {}, None
    lines, at = read_text(path).split("\n")[:-1], 0
    while at < len(lines):
        line, words = lines[at], lines[at].split()
        at += 1
        if line.startswith("# Chunk Coord1"):
            names = words[2:]
            if names != ["Coord1", "Ncount", *COLUMNS]:
                raise BadInput(
                    f"{path}:{at}: columns '{' '.join(names)}', must be "
                    f"'Coord1 Ncount {' '.join(COLUMNS)}'"
                )
        elif words and not line.startswith("#"):
            step, count = frame_head(f"{path}:{at}", line, names)
            rows: Any = []
            # a frame that a kill cut short ends at the head of the run that went on
            while len(rows) < count and at < len(lines) and "#" not in lines[at]:
                at += 1
                rows.append(row(f"{path}:{at}", lines[at - 1], names))
            if len(rows) < count:
                continue
            rows = numpy.array(rows)
            rows = rows[rows[:, 1] > 0]
            if not len(rows):
                raise BadInput(f"{path}:{at}: no automaton in the frame of step {step}")
            frames[step] = dict(zip(names or [], rows.T))  # made again after a kill: the later one
    if not frames:
        raise BadInput(f"{path}: no frame")
    return sorted(frames.items())


def frame_head(where: str, line: str, names: Any) -> tuple[int, int]:
    """(step, number of rows) of the line that begins a frame."""
    words = line.split()
    try:
        if names is not None and len(words) == 3 and whole(words[1]) > 0:
            return whole(words[0]), whole(words[1])
    except ValueError:
        pass
    raise BadInput(f"{where}: '{line[:60]}' where a frame should begin")


def row(where: str, line: str, names: Any) -> Any:
    """The numbers of a row after its own number."""
    words = line.split()[1:]
    if len(words) != len(names):
        raise BadInput(f"{where}: {len(words) + 1} columns, {len(names) + 1} are expected")
    try:
        values = [decimal(word) for word in words]
    except ValueError as error:
        raise BadInput(f"{where}: {error}") from None
    if max(abs(value) for value in values) > LARGEST:
        raise BadInput(f"{where}: a number beyond +-{LARGEST:g}")
    return values


def crossing(y: Any, values: Any, level: float, last: bool) -> float:
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


def fragment(frame: Any) -> dict[str, Any]:
    """The frame without the rows beyond the fragment, that hold few automata or none: some may have
    left it through a held layer of one row."""
    import numpy

    full = numpy.flatnonzero(frame["Ncount"] >= 0.4 * frame["Ncount"].max())
    return {name: values[full[0] : full[-1] + 1] for name, values in frame.items()}


def measures(path: str, frames: Any) -> list[dict[str, Any]]:
    """What each frame of a file (read_frames) says of the layer. Raises BadInput."""
    table = []
    for step, frame in frames:
        found = measure(step, frame)
        if math.isnan(found["depth"]):
            raise BadInput(
                f"{path}: step {step}: no sliding layer: the velocity does not pass 10 and 90 % of "
                "the top row's on the way up"
            )
        table.append(found)
    return table


def measure(step: int, frame: Any) -> dict[str, Any]:
    """What a frame says of the layer; depth and mixed are nan where a level is not passed."""
    import numpy

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
        inside = numpy.arange(len(y)) == numpy.argmin(abs(y - 0.5 * (low + high)))
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


def table_text(table: Any) -> str:
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, table[0])
    writer.writeheader()
    writer.writerows(table)
    return text.getvalue()


def draw(path: str, frames: Any, table: Any, step: float, length: Any, time: Any) -> bytes:
    """Bytes of the picture."""
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
    return picture(figure, path, dpi=140)


def show(table: Any) -> None:
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


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("file", type=file_name, help="profile file of in.friction")
    parser.add_argument("-o", "--output", type=file_name, help="picture (.png, .pdf, .svg)")
    parser.add_argument("--csv", type=file_name, help="table with a row for each frame")
    parser.add_argument(
        "--step",
        type=number_in(unit="ns"),
        help="length of a step [of run.json beside the file, else 4e-5 ns]",
    )
    parser.add_argument(
        "--units",
        nargs=2,
        default=["nm", "ns"],
        metavar=("LENGTH", "TIME"),
        help="names of the units for the picture (default: nm ns)",
    )
    args = parser.parse_args()
    check_apart([args.file], [args.output, args.csv])
    step = args.step or timestep_of(args.file) or 4e-5
    frames = read_frames(args.file)
    table = measures(args.file, frames)
    files: dict[str, str | bytes] = {}
    if args.csv:
        files[args.csv] = table_text(table)
    if args.output:
        files[args.output] = draw(args.output, frames, table, step, *args.units)
    write_all(files)
    show(table)


if __name__ == "__main__":
    run_script(main)
