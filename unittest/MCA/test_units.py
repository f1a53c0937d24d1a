# SPDX-License-Identifier: GPL-2.0-or-later
"""Every unit style has one physics: a case with flow, fracture, welds and contacts, one
potential file in nano for all of them."""

import re

import numpy as np
import pytest
from conftest import write_fragments

from lmp_run import STEEL, dump, lmp

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


# what of a line of the README's first script is a length, a time, a stress or a velocity
QUANTITIES = {
    r"(timestep\s+)(\S+)": "time",
    r"(neighbor\s+)(\S+)": "length",
    r"(lattice\s+hex )(\S+)": "length",
    r"(region\s+box block )(.*)( units box)": "length",
    r"(region\s+(?:lower|upper) mca/rough \w+ )([-\d. ]+)(.*)": "length",
    r"(region\s+bottom block INF INF INF )(\S+)(.*)": "length",
    r"(region\s+top block INF INF )(\S+)(.*)": "length",
    r"(pair_coeff .* strength )(\S+)": "stress",
    r"(velocity\s+upper set )(\S+)(.*)": "velocity",
    r"(fix\s+drive top mca/drive velocity )(\S+)(.*)": "velocity",
    r"(fix\s+drive .* pressure )(\S+)(.*)": "stress",
}


def first_script(folder, style, steps):
    """The README's first script in the units of a style: places and velocities by automaton, in
    those of nano, and the account's terms as shares of the kinetic energy."""
    length, time, stress = SCALES[style]
    sizes = {"length": length, "time": time, "stress": stress, "velocity": length / time}
    readme = (STEEL.parents[1] / "README.md").read_text(encoding="utf-8")
    script = re.search(r"^```lammps\n(.*?)^```", readme, re.MULTILINE | re.DOTALL)[1]
    script = re.sub(r"[ \t]+#.*", "", script)
    script = re.sub(r"(units\s+)nano", rf"\g<1>{style}", script)
    for pattern, quantity in QUANTITIES.items():
        script, found = re.subn(
            pattern,
            lambda m, size=sizes[quantity]: m[1]
            + " ".join(repr(float(w) * size) for w in m[2].split())
            + "".join(" " + m[k] for k in range(3, m.re.groups + 1)),
            script,
        )
        assert found, pattern
    begin = script.rsplit("run ", 1)[0]
    lmp(
        begin
        + f"dump state all custom {steps} state.dump id x y vx vy omegaz\n"
        + "dump_modify state sort id format float %.17g\n"
        + f"run {steps}\n",
        folder,
    )
    frame = dump(folder / "state.dump")[-1][1]
    places = [frame[c] / length / LENGTH for c in "xy"]
    speeds = [frame[c] * time / length / SOUND for c in ("vx", "vy")]
    return np.array([*places, *speeds, frame["omegaz"] * time * 2.5 / SOUND])


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    return first_script(tmp_path_factory.mktemp("first"), "nano", 400)


@pytest.mark.parametrize("style", ["si", "cgs", "micro", "metal", "real"])
def test_first_script_of_the_readme(first, tmp_path, style):
    """Automata of both blocks stand at exactly r = d: whether they are pressed is no matter of
    round-off."""
    off = np.abs(first_script(tmp_path, style, 400) - first).max(axis=1)
    print(style, "x y vx vy omega", off)
    assert np.abs(first[3]).max() > 1e-5
    assert off.max() < 1e-12
