# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of wr_creep with a point contact, for the tests."""

import csv
import os
import pathlib
import subprocess

import numpy

BIN = pathlib.Path(os.environ["WHEELRAIL_BIN"]) / "wr_creep"
SOURCE = pathlib.Path(os.environ["PROJECT_SOURCE"])

# E = 2 G (1 + nu) of G = 82 GPa, nu = 0.28
STEEL = "youngs_modulus: 209.92 GPa, poissons_ratio: 0.28"
CASE = f"""\
contact: {{load: 10 kN, semi_axes: [3 mm, 4 mm], {STEEL}}}
friction: {{law: constant, mu: 0.3}}
thermal: off
speed: 20 m/s
creep: [1e-3]
cells: [32, 32]
sensitivities: false
fields: none
"""
ROUGH = "{hurst: 0.8, rms_slope: 0.01, wavelength_min: 2.6 mm, wavelength_max: 10 mm}"


def wr_creep(*arguments, **options):
    return subprocess.run([BIN, *map(str, arguments)], capture_output=True, text=True, **options)


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def numbers(rows, column):
    return numpy.array([float(row[column]) for row in rows])


def run(case, out, *changes, code=0, options=()):
    arguments = [part for change in changes for part in ("--set", change)]
    done = wr_creep(case, "-o", out, *arguments, *options)
    assert done.returncode == code, done.stderr
    return done


def creep_rows(case, out, *changes, **options):
    run(case, out, *changes, **options)
    return table(out / "creep.csv")


def gsf_map(path, seed, nx=96, ny=80, spacing=0.2e-3, holes=False):
    """A map in the form that Gwyddion writes."""
    draw = numpy.random.default_rng(seed)
    x, y = numpy.meshgrid(numpy.arange(nx) * spacing, numpy.arange(ny) * spacing)
    z = sum(
        0.2e-6 * numpy.cos(2 * numpy.pi * (x * kx + y * ky) + phase)
        for kx, ky, phase in draw.uniform(-200, 200, (20, 3))
    )
    if holes:
        z[10:12, 20:23] = numpy.nan
    head = (
        f"Gwyddion Simple Field 1.0\nXRes = {nx}\nYRes = {ny}\n"
        f"XReal = {nx * spacing}\nYReal = {ny * spacing}\n"
        "XYUnits = m\nZUnits = m\n"
    ).encode()
    head += b"\0" * (4 - len(head) % 4)
    path.write_bytes(head + z.astype("<f4").tobytes())
