"""The same trajectory, whatever the number of ranks, their shapes and the newton setting."""

import pytest

from lmp_run import dump, friction_log, largest_difference, lmp

TRAJECTORY = ["x", "y", "c_state[5]"]
# Round-off of positions is a strain s of about 1e-16, which contacts that touch and part let grow.
# It makes stresses s E, forces s E d h and velocities s c: the scales of the comparison.
VELOCITIES, SOUND = ["vx", "vy"], 5140
STRESSES, MODULUS = ["c_state[1]", "c_state[2]", "c_state[3]", "c_state[4]"], 206000
FORCES = ["fx", "fy", "tqz"]
COUNTS = ["type", "c_state[6]", "c_state[7]"]


def slide(folder, data, **more):
    result = lmp("in.sliding", folder, data=data, v=5, p=30, **more)
    return result, dump(folder / "final.dump")[-1][1], friction_log(folder / "sliding.friction")[1]


def compare(frame, serial):
    assert largest_difference(frame, serial, TRAJECTORY) < 1e-10
    assert largest_difference(frame, serial, VELOCITIES, SOUND) < 1e-10
    assert largest_difference(frame, serial, STRESSES, MODULUS) < 1e-10
    assert largest_difference(frame, serial, FORCES, MODULUS * 2.5) < 1e-10
    for name in COUNTS:
        assert (frame[name] == serial[name]).all(), name


@pytest.fixture(scope="module")
def serial(rough_data, tmp_path_factory):
    return slide(tmp_path_factory.mktemp("serial"), rough_data)


def test_links_break_and_form(serial):
    _, frame, log = serial
    assert log["broken"].sum() > 10 and log["formed"].sum() > 10
    assert frame["c_state[5]"].max() > 1e-3


@pytest.mark.parametrize("ranks,newton,extra", [
    (2, "on", ""), (3, "on", ""), (4, "on", ""),
    (1, "off", ""), (2, "off", ""), (3, "off", ""), (4, "off", ""),
    (4, "on", "processors 4 1 1"), (4, "on", "processors 1 4 1"), (2, "off", "processors 1 2 1"),
])
def test_same_on_all_ranks(serial, rough_data, tmp_path, ranks, newton, extra):
    _, frame, log = slide(tmp_path, rough_data, ranks=ranks, newton=newton, before=extra)
    compare(frame, serial[1])
    for name in ("links", "broken", "formed"):
        assert (log[name] == serial[2][name]).all(), name
    assert largest_difference(log, serial[2], ["shear_stress", "normal_stress", "gap"]) < 1e-6


@pytest.mark.parametrize("newton,extra", [
    ("on", "fix balance all balance 100 1.0 shift xy 10 1.0"),
    ("off", "comm_style tiled"),
    ("off", "comm_style tiled\nfix balance all balance 100 1.0 rcb"),
    ("on", "comm_style tiled\nfix balance all balance 100 1.0 rcb"),
    ("on", "neigh_modify every 1 delay 0 check no"),
    ("on", "neighbor 1.0 bin"),
])
def test_same_with_other_decompositions(serial, rough_data, tmp_path, newton, extra):
    _, frame, log = slide(tmp_path, rough_data, ranks=3, newton=newton, extra=extra)
    compare(frame, serial[1])
    for name in ("links", "broken", "formed"):
        assert (log[name] == serial[2][name]).all(), name
