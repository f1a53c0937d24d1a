#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A locomotive's wheelset starts on a wet rail: the slip is controlled at 1 kHz, and each step asks
the contact of one wheel, 48 x 44 cells, for its force.

    /usr/bin/python3 slip_control.py [-o slip_control.png]

The wheelset turns by omega' = (T - 2 R F)/J and moves its share of the train by v' = 2 F/M. A
motor that gives more torque than the rail carries would let the wheels spin; the controller takes
torque away in proportion to the creep beyond the one that it aims at, and to its integral."""

import argparse
import math
import sys
import time

import numpy as np
import wheelrail

STEP = 1e-3  # s
RADIUS = 0.5  # m, of the wheel
INERTIA = 1000.0  # kg m2, wheelset and the motor's through its gear
MASS = 40e3  # kg, that one wheelset moves
TORQUE = 45e3  # N m, what the driver asks for: more than friction carries
TARGET = 0.01  # creep that the controller aims at
PROPORTIONAL, INTEGRAL = 8e5, 4e6  # N m and N m/s per unit of creep
WET = {"law": "polach", "mu0": 0.35, "A": 0.4, "B": "0.6 s/m"}


def contact(friction):
    """100 kN on a rail head of 300 mm."""
    case = {
        "contact": {
            "load": "100 kN",
            "radii": {"wheel_rolling": f"{RADIUS} m", "rail_profile": "0.3 m"},
            "youngs_modulus": "210 GPa",
            "poissons_ratio": 0.3,
        },
        "friction": friction,
        "thermal": "off",
        "speed": "5 m/s",
        "creep": 0,
        "cells": [48, 44],
    }
    return wheelrail.Contact(wheelrail.Case(case))


def drive(seconds, controlled=True, friction=WET):
    """One row a step: time (s), speed (m/s), creep, torque (N m), force (N), time of the call (s).

    The creep is that of a case file, slip of the wheel against the rail over the rolling speed: it
    is negative where the wheel turns faster than it rolls, and the force then drives."""
    wheel = contact(friction)
    speed = wheel.speed
    omega = speed / RADIUS
    integral = 0.0
    rows = []
    for step in range(round(seconds / STEP)):
        creep = (speed - omega * RADIUS) / speed
        before = time.perf_counter()
        force = wheel.step(creep, speed=speed).force_x
        call = time.perf_counter() - before
        excess = -creep - TARGET
        torque = TORQUE
        if controlled:
            integral = max(0.0, integral + INTEGRAL * excess * STEP)
            torque -= max(0.0, PROPORTIONAL * excess + integral)
        rows.append((step * STEP, speed, creep, torque, force, call))
        omega += STEP * (torque - 2.0 * RADIUS * force) / INERTIA
        speed += STEP * 2.0 * force / MASS
        if not math.isfinite(omega) or -creep > 5.0:
            break
    return np.array(rows)


def picture(path, runs):
    """Creep, force of a wheel and torque over time, with the controller and without."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(3, 1, sharex=True, figsize=(6.4, 6.4), layout="constrained")
    for name, rows in runs.items():
        t, _, creep, torque, force, _ = rows.T
        for axis, values in zip(axes, (-100 * creep, force / 1e3, torque / 1e3)):
            axis.plot(t, values, label=name)
    axes[0].axhline(100 * TARGET, color="0.6", linewidth=0.8, linestyle="--")
    axes[0].set(yscale="log", ylim=(0.03, None), ylabel="slip over speed (%)")
    axes[1].set(ylabel="force of a wheel (kN)")
    axes[2].set(ylabel="torque (kN m)", xlabel="time (s)")
    axes[0].legend(frameon=False)
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--seconds", type=float, default=2.0, help="[%(default)s]")
    parser.add_argument("-o", "--output", metavar="PICTURE", help="creep, force, torque over time")
    options = parser.parse_args()
    runs = {
        "controlled": drive(options.seconds),
        "not controlled": drive(options.seconds, controlled=False),
    }
    for name, rows in runs.items():
        t, speed, creep, torque, force, _ = rows[-1]
        print(
            f"{name:14s} after {t + STEP:.3f} s: slip {-100 * creep:6.2f} % of the speed "
            f"{speed:.2f} m/s, force of a wheel {force / 1e3:4.1f} kN, "
            f"torque {torque / 1e3:4.1f} kN m"
        )
    median, slow = np.percentile(1e3 * runs["controlled"][:, -1], (50, 99))
    print(f"a call: median {median:.2f} ms, 99 % below {slow:.2f} ms", file=sys.stderr)
    if options.output:
        picture(options.output, runs)
    return 0


if __name__ == "__main__":
    sys.exit(main())
