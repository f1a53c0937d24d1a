# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_shakedown.py: Johnson's limits, and operating points on the map."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

import forked_scripts

TOOL = Path(__file__).resolve().parents[2] / "tools" / "plot_shakedown.py"

CREEP = "# units\nspeed,traction_ratio,peak_pressure\n10,0.1,1500\n10,0.3,1800\n"
STRESSES = (
    "# units\nbody,depth,von_mises,max_shear,orthogonal_shear\n"
    "wheel,1,900,500,390\nrail,1,900,500,400\nrail,2,700,450,410\n"
)


@pytest.fixture(name="module")
def fixture_module():
    spec = importlib.util.spec_from_file_location("plot_shakedown", TOOL)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.np = np
    return module


def test_limits_are_johnsons(module):
    first, shakedown = module.limits(0.0)
    assert first == pytest.approx(1 / 0.300, rel=2e-3)  # Johnson, Eq. 4.50
    assert shakedown == pytest.approx(4.0, rel=3e-3)  # sec. 9.2
    assert module.limits(0.36)[1] > 1 / 0.38 and module.limits(0.45)[1] == pytest.approx(1 / 0.45)


def test_stresses_are_in_equilibrium(module):
    h = 1e-5

    def stress(x, z):
        return np.array([s.item() for s in module.cylinder_stress(np.array(x), np.array(z), 0.4)])

    for x, z in ((0.3, 0.5), (-0.7, 0.2), (1.3, 0.4)):
        along = (stress(x + h, z) - stress(x - h, z)) / (2 * h)
        down = (stress(x, z + h) - stress(x, z - h)) / (2 * h)
        assert along[0] + down[2] == pytest.approx(0, abs=1e-8)
        assert along[2] + down[1] == pytest.approx(0, abs=1e-8)
    xx, zz, zx = stress(0.3, 1e-7)
    assert zz == pytest.approx(-np.sqrt(1 - 0.09), abs=1e-6)
    assert zx == pytest.approx(-0.4 * np.sqrt(1 - 0.09), abs=1e-5)
    assert xx == pytest.approx(zz - 2 * 0.4 * 0.3, abs=1e-5)


def plot(tmp_path, *options, creep=CREEP):
    (tmp_path / "creep.csv").write_text(creep, encoding="utf-8")
    (tmp_path / "subsurface_0002.csv").write_text(STRESSES, encoding="utf-8")
    (tmp_path / "subsurface_0000.csv").write_text(STRESSES, encoding="utf-8")
    (tmp_path / "wheel_0002.csv").write_text(STRESSES.split("rail")[0], encoding="utf-8")
    (tmp_path / "zero_0002.csv").write_text(
        STRESSES.replace("400", "0").replace("410", "0"), encoding="utf-8"
    )
    command = [TOOL, "creep.csv", "-o", "map.png", *options]
    return forked_scripts.run(command, tmp_path)


def test_picture(tmp_path):
    done = plot(tmp_path, "--shear-yield", "500", "--stresses", "subsurface_0002.csv")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "map.png").read_bytes()[:4] == b"\x89PNG"


@pytest.mark.parametrize(
    "options, creep, code, words",
    [
        (("--shear-yield", "0"), CREEP, 2, "--shear-yield"),
        (("--shear-yield", "500"), "a,b\n1,2\n", 3, "creep.csv"),
        (("--shear-yield", "500", "--stresses", "creep.csv"), CREEP, 3, "no number"),
        (("--shear-yield", "500", "--stresses", "subsurface_0000.csv"), CREEP, 3, "no number"),
        (("--shear-yield", "500", "--stresses", "wheel_0002.csv"), CREEP, 3, "no row of the rail"),
        (("--shear-yield", "500", "--stresses", "zero_0002.csv"), CREEP, 3, "allowed: > 0"),
        (
            ("--shear-yield", "500", "--stresses", "subsurface_0002.csv"),
            CREEP.rsplit("10,", 1)[0],
            3,
            "no operating point 2",
        ),
    ],
)
def test_faults(tmp_path, options, creep, code, words):
    done = plot(tmp_path, *options, creep=creep)
    assert done.returncode == code, done.stderr
    assert words in done.stderr and done.stderr.count("\n") == 1
