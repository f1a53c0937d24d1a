# SPDX-License-Identifier: GPL-2.0-or-later
"""The same physics in every unit style: a case with flow, fracture, welds and contacts, one
potential file in nano for all of them."""

import numpy as np
import pytest
from conftest import write_fragments

from lmp_run import dump, lmp

# units of the run in nm, ns, MPa; the mass unit follows from LAMMPS's own constants
SCALES = {
    "nano": (1, 1, 1),
    "si": (1e-9, 1e-9, 1e6),
    "cgs": (1e-7, 1e-9, 1e7),
    "micro": (1e-3, 1e-3, 1e3),
    "metal": (10, 1e3, 10),
    "real": (10, 1e6, 1 / 0.101325),
}
SOUND, MODULUS, LENGTH = 5140, 206000, 40  # scales of the comparison: m/s, MPa, nm


def collide(folder, style):
    length, time, stress = SCALES[style]
    data = write_fragments(folder / "fragments.data", length)
    lmp(
        "in.fragments",
        folder,
        data=data,
        units=style,
        length=repr(length),
        time=repr(time),
        stress=repr(stress),
        steps=400,
        every=400,
    )
    frame = dump(folder / "state.dump")[-1][1]
    events = dump(folder / "events.dump")[-1][1]
    scaled = {"x": frame["x"] / length, "y": frame["y"] / length}
    for v in ("vx", "vy"):
        scaled[v] = frame[v] * time / length
    for k in (1, 2, 3, 4):
        scaled[f"s{k}"] = frame[f"c_state[{k}]"] / stress
    counts = np.array([frame[f"c_state[{k}]"] for k in (6, 7)])
    rows = sorted(zip(*(events[f"f_events[{k}]"] for k in range(1, 6))))
    return scaled, frame["c_state[5]"], counts, rows


@pytest.fixture(scope="module")
def nano(tmp_path_factory):
    return collide(tmp_path_factory.mktemp("nano"), "nano")


@pytest.mark.parametrize("style", ["si", "cgs", "micro", "metal", "real"])
def test_same_physics(nano, tmp_path, style):
    scaled, plastic, counts, rows = collide(tmp_path, style)
    expected = nano[0]
    worst = {
        name: np.abs(scaled[name] - expected[name]).max() / size
        for names, size in (
            ("xy", LENGTH),
            (("vx", "vy"), SOUND),
            (("s1", "s2", "s3", "s4"), MODULUS),
        )
        for name in names
    }
    assert len(nano[3]) > 50 and nano[1].max() > 1e-3
    assert rows == nano[3]
    assert (counts == nano[2]).all()
    worst["plastic"] = np.abs(plastic - nano[1]).max()
    print(style, {k: f"{v:.1e}" for k, v in worst.items()})
    assert max(worst.values()) < 1e-10, worst
