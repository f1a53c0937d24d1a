#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Time of an automaton-step against the size of the sample, from tools/benchmark.py's JSON.

    benchmark.py --sizes 1000 1600 6400 40000 160000 1000000 --ranks 1 -o sizes.json
    plot_benchmark.py sizes.json -o sizes.png

A line for each style and number of ranks: the median of the rounds, bars from the smallest to the
largest. Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be
written.
"""

import argparse

from mcawr import plotting, tables
from mcawr.errors import run_script
from mcawr.files import save_figure

FORMAT = "mca-benchmark 1"


def read_cases(path):
    """{(style, ranks): [(automata, ns a step: median, least, most)]}"""

    def cases_of(content):
        if content["format"] != FORMAT:
            raise ValueError(f"format '{content['format']}', must be '{FORMAT}'")
        lines = {}
        for case in content["cases"]:
            rate = case["rate"]
            times = tuple(1e3 / rate[name] for name in ("median", "max", "min"))
            lines.setdefault((case["style"], case["ranks"]), []).append((case["automata"], *times))
        return {key: sorted(values) for key, values in lines.items()}

    return tables.read_json(path, "a benchmark file", cases_of)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("file", help="JSON of tools/benchmark.py")
    parser.add_argument("-o", "--output", required=True, help="picture (.png, .pdf, .svg)")
    args = parser.parse_args()
    figure, axes = plotting.pyplot().subplots(figsize=(6.4, 4.0), layout="constrained")
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
    save_figure(figure, args.output, dpi=140)


if __name__ == "__main__":
    run_script(main)
