#!/usr/bin/python3
"""Friction coefficient against time with its running mean, from friction logs (*.friction).

    plot_friction.py run.friction -o friction.png
    plot_friction.py a.friction b.friction --window 5 --points points.csv -o both.png

Grey: the rows of the log. Coloured: mean over a window centred on each row. Dashed: what wr_fit
took for the stationary part (with --points). Exit codes: 0 ok, 1 no matplotlib, 2 usage,
3 bad input file, 5 the picture cannot be written.
"""
import argparse
import csv
import math
import os
import sys


def fail(code, text):
    print(f"plot_friction.py: {text}", file=sys.stderr)
    sys.exit(code)


def read_log(path):
    """(loading line, time in ns, mu) of a friction log; a cut last line is left out."""
    import yaml

    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().split("\n")
    except (OSError, UnicodeDecodeError) as error:
        fail(3, f"{path}: cannot be read: {error}")
    head = [line[1:].removeprefix(" ") for line in lines if line.startswith("#")]
    try:
        header = yaml.safe_load("\n".join(head))
        if header["format"] != "mca-friction 1":
            fail(3, f"{path}: format '{header['format']}', must be 'mca-friction 1'")
        label = (f"p = {header['loading']['pressure']:g} MPa, v = {header['loading']['velocity']:g} m/s, "
                 f"$\\sigma_0$ = {header['material']['strength']:g} MPa")
        names = lines[len(head)].split()
        time, mu = names.index("time"), names.index("mu")
    except (yaml.YAMLError, KeyError, TypeError, ValueError, IndexError):
        fail(3, f"{path}: no friction log: its head or its column names are incomplete")
    times, values = [], []
    body = lines[len(head) + 1:-1]  # what follows the last end of line was cut
    for number, line in enumerate(body, len(head) + 2):
        words = line.split()
        if number == len(head) + 1 + len(body) and len(words) < len(names):
            break
        if len(words) != len(names):
            fail(3, f"{path}:{number}: {len(words)} columns, {len(names)} are expected")
        try:
            row = float(words[time]), float(words[mu])
        except ValueError:
            fail(3, f"{path}:{number}: not a row of numbers")
        if not all(map(math.isfinite, row)):
            fail(3, f"{path}:{number}: not a finite number")
        times.append(row[0])
        values.append(row[1])
    if len(times) < 2:
        fail(3, f"{path}: fewer than two rows")
    return label, times, values


def running_mean(values, half):
    """Mean over 2 half + 1 rows centred on each; at the ends over those of them that are there."""
    total = [0.0]
    for value in values:
        total.append(total[-1] + value)
    result = []
    for i in range(len(values)):
        first, last = max(0, i - half), min(len(values) - 1, i + half)
        result.append((total[last + 1] - total[first]) / (last + 1 - first))
    return result


def read_points(path):
    """file name -> (mu, t_start) of wr_fit's points.csv."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            return {os.path.realpath(r["file"]): (float(r["mu"]), float(r["t_start"])) for r in rows}
    except (OSError, KeyError, ValueError) as error:
        fail(3, f"{path}: not wr_fit's points.csv: {error}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("logs", nargs="+", metavar="LOG")
    parser.add_argument("-o", "--output", default="friction.png", metavar="PNG")
    parser.add_argument("--window", type=float, metavar="NS", help="width of the running mean [a tenth of the log]")
    parser.add_argument("--points", metavar="CSV", help="wr_fit's points.csv: shows the stationary means")
    given = parser.parse_args()
    if given.window is not None and not given.window > 0:
        fail(2, f"--window {given.window:g}: must be > 0")
    logs = [read_log(path) for path in given.logs]
    points = read_points(given.points) if given.points else {}
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        fail(1, "matplotlib is missing (Debian: apt-get install python3-matplotlib); no picture made")

    figure, axes = plt.subplots(figsize=(8, 4.5), constrained_layout=True)
    top = 0.0
    for number, (path, (label, times, values)) in enumerate(zip(given.logs, logs)):
        colour = f"C{number}"
        window = given.window or 0.1 * times[-1]
        half = max(1, round(0.5 * window / (times[1] - times[0])))
        mean = running_mean(values, half)
        single = len(logs) == 1
        axes.plot(times, values, color="0.75" if single else colour, alpha=1 if single else 0.25, lw=0.8,
                  label="rows of the log" if single else None)
        axes.plot(times, mean, color=colour, lw=2,
                  label=f"running mean over {window:.3g} ns" + ("" if single else f": {label}"))
        if os.path.realpath(path) in points:
            mu, start = points[os.path.realpath(path)]
            if math.isfinite(start):
                axes.plot([start, times[-1]], [mu, mu], color=colour, ls="--", lw=1.5,
                          label=f"stationary part: {mu:.3f}")
        # the static peak may be several times the rest
        ordered = sorted(values)
        top = max(top, 1.3 * ordered[int(0.98 * (len(ordered) - 1))], 1.1 * max(mean))
        axes.set_title(label if single else "Sliding friction", fontsize=11)
    axes.set_xlabel("time (ns)")
    axes.set_ylabel("friction coefficient $\\mu$")
    axes.set_xlim(left=0)
    low = min(0.0, *(min(running_mean(v, 2)) for _, _, v in logs))
    axes.set_ylim(low, top)
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
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
