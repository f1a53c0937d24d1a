#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Cases of CONTACT's input files (.inp, module 3) as case files of wr_creep.

    contact_inp.py examples/wheelrail/shift.inp -o cases
    wr_creep cases/case_001.yaml -o results

One case file for each case of CONTACT, named after its number; cases that go on from the one before
(P = 0) become one sequence, named after the first. A gap that is given point by point becomes a
height map beside the case file. What wr_creep cannot do is refused by its control digit and line;
all other cases are written. Cases of an earlier call in DIR go. A case that rolls backwards (CHI =
180 degrees) is turned by half a turn, and its case file says so: creepages and forces in the plane
then have the opposite sign. Stresses below the surface (S) are left to the keyword depths of
wr_creep.
Exit codes: 0 ok, 2 usage, 3 bad input file or a case that is refused, 5 a file cannot be written.
"""

import argparse
import contextlib
import os
import pathlib

from contact_parts.case import BY, case_text
from contact_parts.inp import Refused, groups_of
from mcawr.command_line import Parser, file_name
from mcawr.errors import Exit, Failure, complain, run_script
from mcawr.files import replace_all


def numbered(first: int, count: int) -> str:
    return f"case {first}" if count == 1 else f"cases {first} to {first + count - 1}"


def former(folder: str) -> list[str]:
    """Case files of an earlier call, by their first line, and the maps beside them."""
    found = []
    for case in sorted(pathlib.Path(folder).glob("case_*.yaml")):
        with contextlib.suppress(OSError), open(case, encoding="utf-8", errors="replace") as file:
            if file.readline().rstrip().endswith(BY):
                found += [str(case), str(case.with_suffix(".txt"))]
    return found


def convert(path: str, folder: str) -> int:
    """Number of refused groups."""
    files: dict[str, str] = {}
    refused = 0
    for first, group, reason in groups_of(path):
        stem = f"case_{first:03d}"
        error, known = reason, 0 if reason else len(group)
        while known > 0:  # what goes on beyond what wr_creep can do is left out
            try:
                numbers = numbered(first, known)
                files[f"{stem}.yaml"] = case_text(group[:known], path, numbers, files, stem)
                break
            except Refused as problem:
                error = str(problem)
                known -= 1
        if known < len(group):
            complain(f"{path}:{error} ({numbered(first + known, len(group) - known)})")
            refused += 1
    os.makedirs(folder, exist_ok=True)
    written = {os.path.join(folder, name): content for name, content in files.items()}
    replace_all(written, former(folder))
    count = sum(name.endswith(".yaml") for name in files)
    print(f"{count} case file{'' if count == 1 else 's'} written to {folder}/")
    return refused


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("inp", type=file_name, metavar="INP")
    parser.add_argument("-o", "--output", type=file_name, default=".", metavar="DIR", help="[.]")
    given: argparse.Namespace = parser.parse_args()
    if convert(given.inp, given.output):
        raise Failure(Exit.BAD_INPUT, f"{given.inp}: some cases are refused")


if __name__ == "__main__":
    run_script(main)
