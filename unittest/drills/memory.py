#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_creep and wr_fit with less memory than they need: done, or one line and exit code 1.

A limit on the address space (RLIMIT_AS), from just above what the program needs to start up to what
a whole run takes. wr_creep has started when it has read its case: with less, UDUNITS-2 crashes
while it reads its own unit database."""

import resource

from drill import ENVIRONMENT, Drill, problem, run
from writing import inputs_in

STEP = 1 << 20  # bytes


def limited(size):
    """preexec_fn: this much memory."""
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size))


def least(command, folder, low, high):
    """The smallest limit, to a step or 3 %, under which a command ends with 0."""
    while high - low > max(STEP, high // 32):
        middle = (low + high) // 2
        if run(command, folder, preexec_fn=limited(middle)).code == 0:
            high = middle
        else:
            low = middle
    return high


def main():
    """All calls."""
    drill = Drill(__doc__, 8, "limits for each call")
    work = drill.new_folder("work")
    inputs_in(work, drill)
    threads = dict(ENVIRONMENT, OMP_NUM_THREADS="2", MALLOC_ARENA_MAX="1")
    fine = ["--set", "cells=262144", "--set", "speed=[5 m/s, 10 m/s]"]
    plane = ["--set", "cells=[96, 96]", "--threads", "2"]
    calls = {
        "wr_creep line": ["wr_creep", "case.yaml", "-o", "out", "-q", *fine],
        "wr_creep point": ["wr_creep", "patch.yaml", "-o", "out", "-q", *plane],
        "wr_fit": ["wr_fit", "logs", "-q", "-o", "law.json"],
    }
    for name, (program, *words) in calls.items():
        if not drill.wanted(name):
            continue
        command = [drill.program(program), *words]
        started = [words[0], "--print-config"] if program == "wr_creep" else ["--help"]
        start = least([command[0], *started], work, 0, 1 << 32)
        enough = least(command, work, start, 1 << 32)
        for k in range(drill.given.count):
            size = start + (enough - start) * k // drill.given.count + drill.random.randrange(STEP)
            done = run(command, work, env=threads, preexec_fn=limited(size))
            lines = done.err.strip().splitlines()
            wrong = problem(done)
            if wrong:
                drill.fault(name, f"{size} bytes: {wrong}")
            elif done.code == 0:
                drill.count(name, "done")
            elif done.code != 1 or not any("memory" in s or "Thread" in s for s in lines):
                drill.fault(name, f"{size} bytes: exit code {done.code}: {lines}")
            else:
                drill.count(name, "refused")
    drill.end()


if __name__ == "__main__":
    main()
