# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of wr_creep with a contact along a line, for the tests."""

import csv
import os
import pathlib
import subprocess
import time

BIN = pathlib.Path(os.environ["WHEELRAIL_BIN"]) / "wr_creep"
SOURCE = pathlib.Path(os.environ["PROJECT_SOURCE"])
TABLE2 = SOURCE / "examples/wheelrail/table2.yaml"
DOC = SOURCE / "doc/wr_creep.md"

CASE = """\
contact: {load_per_length: 4000 N/mm, radius: 0.5 m, youngs_modulus: 210 GPa, poissons_ratio: 0.3}
friction: {law: constant, mu: 0.3}
thermal: off
speed: 20 m/s
creep: [2e-4, 5e-4, 1e-3, 1.5e-3, 2e-3, 2.5e-3, 3e-3]
cells: 1000
"""
ROUGH = "roughness={hurst: 0.8, rms_slope: 0.02, wavelength_min: 0.1 mm, wavelength_max: 10 mm}"


def wr_creep(*arguments, **options):
    return subprocess.run([BIN, *map(str, arguments)], capture_output=True, text=True, **options)


def interrupted(by, out, *arguments):
    """Sends the signal as soon as wr_creep keeps a journal in `out`: it ends with 6, the points
    done so far stay, and no table is written. Returns what it says."""
    words = [BIN, *map(str, arguments), "-o", out]
    running = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    journal = out / "wr_creep.journal"
    end = time.monotonic() + 120
    while not journal.exists() and running.poll() is None and time.monotonic() < end:
        time.sleep(0.05)
    running.send_signal(by)
    message = running.communicate(timeout=60)[1]
    assert running.returncode == 6, message
    assert "run the same command again" in message
    assert journal.exists() and not (out / "creep.csv").exists()
    return message


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def law_file(covariance):
    return {
        "format": "mca-friction-law 1",
        "mu0": 0.15,
        "mu1": 0.0442,
        "mu2": 0.3243,
        "b": 0.195,
        "c": 0.00212,
        "covariance": covariance,
        "n": 34,
        "rms_relative": 0.09,
        "kappa1_range": [0, 5],
        "kappa2_range": [2, 1500],
        "source": "test",
    }
