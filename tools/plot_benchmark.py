#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Time of an automaton-step against the size of the sample, from tools/benchmark.py's JSON.

    benchmark.py --sizes 1600 6400 40000 160000 1000000 --ranks 1 -o sizes.json
    plot_benchmark.py sizes.json -o sizes.png

A line for each style and number of ranks: the median of the rounds, bars from the smallest to the
largest. Exit codes: 0 ok, 1 no matplotlib, 2 usage, 3 bad input file, 5 the picture cannot be
written.
"""

from typing import Any

from mcawr import plotting, tables
from mcawr.command_line import Parser, file_name
from mcawr.errors import BadInput, run_script
from mcawr.files import check_apart, save_figure

FORMAT = "mca-benchmark 2"
ROW = "default laws"


def read_cases(path: str) -> dict[Any, Any]:
    """{(style, ranks): [(automata, ns a step: median, least, most)]}"""

    def cases_of(content: Any) -> dict[Any, Any]:
        if content["format"] != FORMAT:
            raise ValueError(f"format '{content['format']}', must be '{FORMAT}'")
        lines: dict[Any, Any] = {}
        for case in content["cases"]:
            if case["row"] != ROW or case["other"]:
                continue
            rates = [tables.number(case["rate"][name]) for name in ("median", "max", "min")]
            size, ranks = (tables.number(case[name]) for name in ("automata", "ranks"))
            if min(size, ranks, *rates) <= 0:
                raise ValueError("automata, ranks and rates must be > 0")
            line = lines.setdefault((str(case["style"]), ranks), [])
            line.append((size, *(1e3 / rate for rate in rates)))
        return {key: sorted(values) for key, values in lines.items()}

    cases = tables.read_json(path, "a benchmark file", cases_of)
    if not cases:
        raise BadInput(f"{path}: no case")
    return cases


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("file", type=file_name, help="JSON of tools/benchmark.py")
    parser.add_argument(
        "-o", "--output", type=file_name, required=True, help="picture (.png, .pdf, .svg)"
    )
    args = parser.parse_args()
    check_apart([args.file], [args.output])
    lines = read_cases(args.file)
    figure, axes = plotting.pyplot().subplots(figsize=(6.4, 4.0), layout="constrained")
    marks = iter("os^Dv<>")
    for (style, ranks), values in lines.items():
        size, median, least, most = zip(*values)
        bars = [[m - a for m, a in zip(median, least)], [b - m for m, b in zip(median, most)]]
        label = f"{style}, {ranks:g} rank{'s' * (ranks > 1)}"
        axes.errorbar(size, median, bars, marker=next(marks, "o"), capsize=3, label=label)
    axes.set(xscale="log", xlabel="automata", ylabel="time of an automaton-step [ns]")
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3)
    axes.legend()
    save_figure(figure, args.output, dpi=140)


if __name__ == "__main__":
    run_script(main)
