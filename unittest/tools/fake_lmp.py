#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Stands in for lmp with in.friction in the tests of tools/campaign: the same files, made in no
time.

mu depends on the step alone, so that a run which went on after a kill must give the very same log.
v = 13 fails with a LAMMPS-like error. FAKE_LMP_ROW: seconds a row takes.
"""

import os
import sys
import time

import friction_logs

KEYWORDS = {"E": "youngs_modulus", "rho": "density", "strength": "strength"}
END = b"LammpS RestartT\0"


def main():
    words, var = sys.argv[1:], {}
    for i, word in enumerate(words):
        if word == "-var":
            var.setdefault(words[i + 1], words[i + 2])
    log = words[words.index("-log") + 1]
    with open(log, "w", encoding="utf-8") as file:
        file.write("LAMMPS (fake)\n")
        if var["v"] == "13":
            file.write("ERROR: Lost atoms: original 1280 current 1279 (src/thermo.cpp:494)\n")
            return 1
    dt, every, checkpoint = float(var["dt"]), int(var["every"]), int(var["checkpoint"])
    steps = round(float(var["ns"]) / dt)
    step = 0
    if var.get("continue") == "1":
        with open(var["restart"], "rb") as file:
            data = file.read()
        assert data.endswith(END)
        step = int(data[: -len(END)])
        with open(var["log"], encoding="utf-8") as file:
            kept = [
                line
                for line in file.read().split("\n")[:-1]
                if not line[:1].isdigit() or int(line.split()[0]) <= step
            ]
    else:
        words = var.get("upper_values", "").split()
        lower = {key: var[name] for name, key in KEYWORDS.items()}
        upper = {**lower, **dict(zip(words[::2], words[1::2]))}
        weaker = min(lower, upper, key=lambda block: float(block["strength"]))
        kept = [
            friction_logs.HEAD.format(
                E=weaker["youngs_modulus"],
                rho=float(weaker["density"]) * 1e6,
                p=var["p"],
                v=var["v"],
                strength=weaker["strength"],
                breaking_strain=0.04,
                seed=var["seed"],
                preset="B",
                every=every,
            ).rstrip("\n")
        ]
    with open(var["log"], "w", encoding="utf-8") as file:
        file.write("\n".join(kept) + "\n")
    number = step // checkpoint
    with open(var["log"], "a", encoding="utf-8") as file:
        while step < steps:
            step += every
            mu = 0.4 + 0.1 * ((step * 7919) % 1000 / 1000 - 0.5)
            file.write(
                f"{step} {step * dt:.10g} {step * dt * float(var['v']):.10g} "
                f"{mu * float(var['p']):.8g} "
                f"{var['p']} {mu:.8g} 3456 2 1 -0.01\n"
            )
            file.flush()
            time.sleep(float(os.environ.get("FAKE_LMP_ROW", "0")))
            if step % checkpoint == 0:
                name = f"{var['name']}.{'ab'[number % 2]}.restart"
                number += 1
                with open(name, "wb") as restart:  # like LAMMPS: not atomic, the end marked
                    restart.write(str(step).encode())
                    restart.flush()
                    time.sleep(float(os.environ.get("FAKE_LMP_ROW", "0")))
                    restart.write(END)
    with open(f"{var['name']}.restart", "wb") as restart:
        restart.write(str(step).encode() + END)
    return 0


if __name__ == "__main__":
    sys.exit(main())
