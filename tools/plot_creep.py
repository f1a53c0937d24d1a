#!/usr/bin/python3
"""Creep-force curves from wr_creep's creep.csv.

    plot_creep.py creep.csv -o creep.png
    plot_creep.py own/creep.csv paper/creep.csv --label "own law" --label paper -o both.png

One curve for each speed (and seed) of each file. Where creep_band.csv lies beside a file, its 95 %
interval from the uncertainty of the friction law is shaded.
Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""
import argparse
import csv
import os
import sys

STYLES = ["-", "--", ":", "-."]


def fail(code, text):
    print(f"plot_creep.py: {text}", file=sys.stderr)
    sys.exit(code)


def read(path):
    """{(speed, seed): {column: [numbers]}} of a CSV file of wr_creep."""
    curves = {}
    try:
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                key = (float(row["speed"]), row.get("seed", ""))
                curve = curves.setdefault(key, {})
                for name, value in row.items():
                    if name != "seed":
                        curve.setdefault(name, []).append(float(value))
    except (OSError, ValueError, KeyError, TypeError) as error:
        fail(3, f"{path}: not a creep.csv of wr_creep: {error}")
    if not curves:
        fail(3, f"{path}: no points")
    return curves


def band_of(path):
    band = os.path.join(os.path.dirname(path), "creep_band.csv")
    return read(band) if os.path.exists(band) else {}


def draw(axes, path, label, style):
    curves, bands = read(path), band_of(path)
    speeds = sorted({speed for speed, _ in curves})
    for (speed, seed), curve in curves.items():
        color = f"C{speeds.index(speed)}"
        name = " ".join(filter(None, [label, f"{speed:g} m/s", seed and f"seed {seed}"]))
        axes.plot(curve["creep"], curve["traction_ratio"], style, color=color, label=name)
        if (speed, seed) in bands:
            band = bands[speed, seed]
            axes.fill_between(band["creep"], band["low"], band["high"], color=color, alpha=0.2, lw=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", nargs="+", help="creep.csv of wr_creep")
    parser.add_argument("-o", "--output", default="creep.png", metavar="PNG")
    parser.add_argument("--label", action="append", default=[], help="name of a file's curves, in order")
    parser.add_argument("--linear", action="store_true", help="linear instead of logarithmic creep axis")
    given = parser.parse_args()
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError as error:
        fail(1, f"{error}: install matplotlib (python3-matplotlib) to get pictures")
    figure, axes = plt.subplots(figsize=(7, 4.5), constrained_layout=True)
    for k, path in enumerate(given.csv):
        draw(axes, path, given.label[k] if k < len(given.label) else "", STYLES[k % len(STYLES)])
    if not given.linear:
        axes.set_xscale("log")
    axes.set(xlabel="creep, sliding/rolling speed", ylabel="traction / load, T/N", ylim=(0, None),
             title="Creep-force curves")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    try:
        figure.savefig(given.output, dpi=150)
    except OSError as error:
        fail(5, f"{given.output}: {error}")


if __name__ == "__main__":
    main()
