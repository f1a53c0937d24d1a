#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Dry friction from Python: runs examples/friction/in.friction through the module lammps and goes
on with the friction coefficient as numpy array.

  source build/env.sh                                  (installed: share/mca-wheelrail/env.sh)
  examples/python/friction.py [NS]                     NS: time to run, ns [10]

The run leaves its friction log, python.friction, and python.restart in the current folder.
"""

import re
import sys
from pathlib import Path

import numpy as np
from lammps import LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, lammps

INPUT = Path(__file__).resolve().parent.parent / "friction" / "in.friction"
ROW = 100  # steps between two rows of the array


def known_variables():
    """Names of the variables that the script lets one set."""
    head = INPUT.read_text(encoding="utf-8").split("\nunits ")[0]
    return re.findall(r"^variable +(\w+) +index ", head, re.MULTILINE)


def slide(ns, **variables):
    """Runs the example for `ns` nanoseconds, with other `variables` of its script if given. Raises
    TypeError for one that it does not have: LAMMPS would take it and run without it.

    Returns (series, positions): float arrays (rows, 3) of time (ns), shear stress (MPa) and
    friction coefficient, a row each ROW steps from the start on, and (automata, 3) in nm.
    """
    known = known_variables()
    for name in variables:
        if name not in known:
            raise TypeError(f"{INPUT.name} has no variable '{name}', it has: {', '.join(known)}")
    given = dict(variables, ns=0, frames=0, name="python")
    words = [word for name, value in given.items() for word in ("-var", name, str(value))]
    lmp = lammps(cmdargs=["-log", "none", "-screen", "none", *words])
    lmp.file(str(INPUT))  # builds the two blocks; 0 ns do no step
    dt = lmp.extract_global("dt")

    def row():
        tau, mu = (
            lmp.numpy.extract_fix("drive", LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, nrow=k)
            for k in (0, 2)
        )
        return lmp.extract_global("ntimestep") * dt, tau, mu

    rows = []
    for _ in range(round(ns / (ROW * dt))):
        lmp.command(f"run {ROW} post no")
        rows.append(row())
    positions = lmp.numpy.extract_atom("x")[: lmp.extract_global("nlocal")].copy()
    lmp.close()
    return np.array(rows), positions


def main():
    """Prints mean and scatter of the second half."""
    try:
        (ns,) = map(float, sys.argv[1:] or [10])
    except ValueError:
        given = " ".join(sys.argv[1:])
        print(f"friction.py: '{given}' is not allowed, must be a time in ns", file=sys.stderr)
        sys.exit(2)
    series, positions = slide(ns)
    mu = series[len(series) // 2 :, 2]
    print(f"{len(positions)} automata, {len(series)} rows up to {series[-1, 0]:g} ns")
    print(f"friction coefficient of the second half: {mu.mean():.3f}, scatter {mu.std():.3f}")


if __name__ == "__main__":
    main()
