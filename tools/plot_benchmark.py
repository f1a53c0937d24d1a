#!/usr/bin/python3
"""Time of an automaton-step against the size of the sample, from tools/benchmark.py's JSON.

    benchmark.py --sizes 1000 1600 6400 40000 160000 1000000 --ranks 1 -o sizes.json
    plot_benchmark.py sizes.json -o sizes.png

A line for each style and number of ranks: the median of the rounds, bars from the smallest to the
largest. Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be written.
"""
import argparse
import json
import os
import sys


def fail(code, text):
    print(f"plot_benchmark.py: {text}", file=sys.stderr)
    sys.exit(code)


def read_cases(path):
    """{(style, ranks): [(automata, ns a step: median, least, most)]}"""
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
        if content["format"] != "mca-benchmark 1":
            fail(3, f"{path}: format '{content['format']}', must be 'mca-benchmark 1'")
        lines = {}
        for case in content["cases"]:
            rate = case["rate"]
            times = tuple(1e3 / rate[name] for name in ("median", "max", "min"))
            lines.setdefault((case["style"], case["ranks"]), []).append((case["automata"], *times))
        return {key: sorted(values) for key, values in lines.items()}
    except (OSError, ValueError, KeyError, TypeError, ZeroDivisionError) as error:
        fail(3, f"{path}: not a benchmark file: {error}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("file", help="JSON of tools/benchmark.py")
    parser.add_argument("-o", "--output", required=True, help="picture (.png, .pdf, .svg)")
    args = parser.parse_args()
    try:
        import matplotlib
    except ImportError:
        fail(1, "needs matplotlib (Debian: python3-matplotlib)")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6.4, 4.0), layout="constrained")
    marks = iter("os^Dv<>")
    for (style, ranks), values in read_cases(args.file).items():
        size, median, least, most = zip(*values)
        bars = [[m - a for m, a in zip(median, least)], [b - m for m, b in zip(median, most)]]
        label = f"{style}, {ranks} rank{'s' * (ranks > 1)}"
        axes.errorbar(size, median, bars, marker=next(marks, "o"), capsize=3, label=label)
    axes.set(xscale="log", xlabel="automata", ylabel="time of an automaton-step [ns]")
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3)
    axes.legend()
    root, extension = os.path.splitext(args.output)
    partial = f"{root}.part{extension}"
    try:
        figure.savefig(partial, dpi=140)
        os.replace(partial, args.output)
    except (OSError, ValueError) as error:
        fail(5, f"{args.output}: cannot be written: {error}")


if __name__ == "__main__":
    main()
