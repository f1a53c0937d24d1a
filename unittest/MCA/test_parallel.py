# SPDX-License-Identifier: GPL-2.0-or-later
"""One trajectory, one list of events, whatever the ranks, their shapes, newton and the neighbor
lists."""

import numpy as np
import pytest

from lmp_run import INPUTS, dump, friction_log, largest_difference, lmp

POSITIONS = ["x", "y"]
# Round-off of positions is a strain s of about 1e-16, which contacts that touch and part let grow.
# It makes plastic strains s, stresses s E, forces s E d h and velocities s c: the scales of the
# comparison.
PLASTIC = ["c_state[5]"]
VELOCITIES, SOUND = ["vx", "vy"], 5140
STRESSES, MODULUS = ["c_state[1]", "c_state[2]", "c_state[3]", "c_state[4]"], 206000
FORCES = ["fx", "fy", "tqz"]
COUNTS = ["type", "c_state[6]", "c_state[7]"]


LONG = pytest.mark.long
SETTINGS = [  # ranks, newton, commands before the box, commands before the run
    (2, "on", "", ""),
    (3, "on", "", ""),
    (4, "on", "", ""),
    (1, "off", "", ""),
    (2, "off", "", ""),
    (3, "off", "", ""),
    (4, "off", "", ""),
    (4, "on", "processors 4 1 1", ""),
    (4, "on", "processors 1 4 1", ""),
    (2, "off", "processors 1 2 1", ""),
    (3, "on", "", "fix balance all balance 100 1.0 shift xy 10 1.0"),
    (3, "off", "", "comm_style tiled"),
    (2, "on", "comm_style tiled", ""),
    (3, "off", "", "comm_style tiled\nfix balance all balance 100 1.0 rcb"),
    (4, "on", "", "comm_style tiled\nfix balance all balance 100 1.0 rcb"),
    (3, "on", "", "neigh_modify every 1 delay 0 check no"),
    (2, "on", "", "neighbor 1.0 bin"),
    (1, "on", "atom_modify sort 0 0", "neighbor 0.1 bin\nneigh_modify every 1"),
]
QUICK = (0, 3, 6, 13, 16, 17)  # the others are long
FEW = [SETTINGS[0], *(pytest.param(*SETTINGS[k], marks=LONG) for k in (6, 13))]


def settings(numbers):
    return [pytest.param(*SETTINGS[k], marks=[] if k in QUICK else [LONG]) for k in numbers]


CASES = ["elastic", "plastic", "all"]
PLAIN = "b steps plain"  # preset and keyword of in.sliding
SLIPPING, SLIP_STEP = "b viscosity both", "timestep 1.5e-5"


def events(path):
    """Set of (step, pair, kind before, kind after)."""
    found = set()
    for _, frame in dump(path):
        columns = [frame[f"f_events[{k}]"] for k in range(1, 6)]
        for step, i, j, before, after in zip(*columns):
            row = (step, min(i, j), max(i, j), before, after)
            assert row not in found
            found.add(row)
    return found


def cases(folder, data, **more):
    """State and events of the three cases of in.cases."""
    lmp("in.cases", folder, inputs=INPUTS, data=data, **more)
    return {
        c: (dump(folder / f"state.{c}.dump")[-1][1], events(folder / f"events.{c}.dump"))
        for c in CASES
    }


def slide(folder, data, **more):
    result = lmp("in.sliding", folder, data=data, v=5, p=30, **more)
    return (
        result,
        dump(folder / "final.dump")[-1][1],
        friction_log(folder / "sliding.friction")[1],
        events(folder / "events.dump"),
    )


def compare(frame, serial, tolerance):
    worst = [
        largest_difference(frame, serial, POSITIONS),
        largest_difference(frame, serial, PLASTIC, 1.0),
        largest_difference(frame, serial, VELOCITIES, SOUND),
        largest_difference(frame, serial, STRESSES, MODULUS),
        largest_difference(frame, serial, FORCES, MODULUS * 2.5),
    ]
    print("positions, plastic strains, velocities, stresses, forces:", *(f"{w:.1e}" for w in worst))
    assert max(worst) < tolerance, worst
    for name in COUNTS:
        assert (frame[name] == serial[name]).all(), name


@pytest.fixture(scope="module")
def serial(rough_data, tmp_path_factory):
    return slide(tmp_path_factory.mktemp("serial"), rough_data)


@pytest.fixture(scope="module")
def serial_cases(fragments, tmp_path_factory):
    return cases(tmp_path_factory.mktemp("serial"), fragments)


def test_links_break_and_form(serial, serial_cases):
    _, frame, log, list_of_events = serial
    assert log["broken"].sum() > 10 and log["formed"].sum() > 10
    assert frame["c_state[5]"].max() > 1e-3
    assert len(list_of_events) == (log["broken"] + log["formed"]).sum() + healed(list_of_events)
    assert len(serial_cases["all"][1]) > 100 and healed(serial_cases["all"][1]) > 5
    assert serial_cases["plastic"][0]["c_state[5]"].max() > 1e-3
    for case in ("elastic", "plastic"):
        assert not serial_cases[case][1] and np.ptp(serial_cases[case][0]["c_state[1]"]) > 1


def healed(rows):
    return sum(before > 0 and after > 0 for _, _, _, before, after in rows)


@pytest.mark.parametrize("ranks,newton,before,extra", settings(range(18)))
def test_free_fragments(serial_cases, fragments, tmp_path, ranks, newton, before, extra):
    """Elastic and plastic cases to 1e-12 after 2000 steps, all events of the third one, whose
    contacts touch and part and so let round-off grow to some 1e-12."""
    found = cases(tmp_path, fragments, ranks=ranks, newton=newton, before=before, extra=extra)
    for case, (frame, rows) in serial_cases.items():
        compare(found[case][0], frame, 1e-11 if case == "all" else 1e-12)
        assert found[case][1] == rows


@pytest.mark.parametrize("ranks,newton,before,extra", settings(range(1, 18, 2)))
def test_sliding_blocks(serial, rough_data, tmp_path, ranks, newton, before, extra):
    """Periodic, driven, with contacts that touch and part, which lets round-off grow; events as a
    set."""
    _, frame, log, rows = slide(
        tmp_path, rough_data, ranks=ranks, newton=newton, before=before, extra=extra
    )
    compare(frame, serial[1], 1e-9)
    assert rows == serial[3]
    for name in ("links", "broken", "formed"):
        assert (log[name] == serial[2][name]).all(), name
    assert largest_difference(log, serial[2], ["shear_stress", "normal_stress", "gap"]) < 1e-6


@pytest.mark.parametrize("ranks,newton,before,extra", FEW)
def test_viscosity_along_both_directions(
    slipping, serial, rough_data, tmp_path, ranks, newton, before, extra
):
    """Torques of other ranks matter, too; and it is another law."""
    more = dict(ranks=ranks, newton=newton, before=before, extra=f"{extra}\n{SLIP_STEP}")
    _, frame, _, rows = slide(tmp_path, rough_data, laws=SLIPPING, **more)
    compare(frame, slipping[1], 1e-10)
    assert rows == slipping[3] and len(rows) > 10
    assert largest_difference(frame, serial[1], VELOCITIES, SOUND) > 1e-6


@pytest.fixture(scope="module")
def slipping(rough_data, tmp_path_factory):
    folder = tmp_path_factory.mktemp("slipping")
    return slide(folder, rough_data, laws=SLIPPING, extra=SLIP_STEP)


@pytest.fixture(scope="module")
def plain(rough_data, fragments, tmp_path_factory):
    folder = tmp_path_factory.mktemp("plain")
    return (
        cases(folder / "cases", fragments, scheme="plain viscosity normal"),
        slide(folder / "slide", rough_data, laws=PLAIN),
    )


@pytest.mark.parametrize("ranks,newton,before,extra", FEW)
def test_plain_steps(
    plain, serial, serial_cases, rough_data, fragments, tmp_path, ranks, newton, before, extra
):
    """They send less; and they are another law."""
    more = dict(ranks=ranks, newton=newton, before=before, extra=extra)
    found = cases(tmp_path / "cases", fragments, scheme="plain viscosity normal", **more)
    for case, (frame, rows) in plain[0].items():
        compare(found[case][0], frame, 1e-11 if case == "all" else 1e-12)
        assert found[case][1] == rows
    _, frame, _, rows = slide(tmp_path / "slide", rough_data, laws=PLAIN, **more)
    compare(frame, plain[1][1], 1e-10)
    assert rows == plain[1][3]
    for corrected in (serial[1], serial_cases["plastic"][0]):
        other = frame if corrected is serial[1] else found["plastic"][0]
        assert largest_difference(other, corrected, PLASTIC, 1.0) > 1e-6


FLOWING = "b plasticity isochoric flow contacts"


@pytest.fixture(scope="module")
def flowing(rough_data, fragments, tmp_path_factory):
    folder = tmp_path_factory.mktemp("flowing")
    return (
        cases(folder / "cases", fragments, scheme=f"corrected {FLOWING[2:]}"),
        slide(folder / "slide", rough_data, laws=FLOWING),
    )


@pytest.mark.parametrize("ranks,newton,before,extra", FEW)
def test_flow_that_keeps_the_volume(
    flowing, serial, rough_data, fragments, tmp_path, ranks, newton, before, extra
):
    """Centres of the return cross ranks, too: as near as with radial; and it is another law."""
    more = dict(ranks=ranks, newton=newton, before=before, extra=extra)
    found = cases(tmp_path / "cases", fragments, scheme=f"corrected {FLOWING[2:]}", **more)
    for case, (frame, rows) in flowing[0].items():
        compare(found[case][0], frame, 1e-11 if case == "all" else 1e-12)
        assert found[case][1] == rows
    _, frame, _, rows = slide(tmp_path / "slide", rough_data, laws=FLOWING, **more)
    compare(frame, flowing[1][1], 1e-9)
    assert rows == flowing[1][3] and len(rows) > 10
    assert largest_difference(frame, serial[1], PLASTIC, 1.0) > 1e-6


@LONG
def test_more_ranks_than_cores(fragments, tmp_path):
    """16 ranks, each with some ten automata, nearly all of them at a border."""
    short = dict(steps=200, every=200)
    alone = cases(tmp_path / "one", fragments, **short)
    found = cases(tmp_path / "sixteen", fragments, ranks=16, **short)
    for case, (frame, rows) in alone.items():
        compare(found[case][0], frame, 1e-12)
        assert found[case][1] == rows


# a fragment of which a part is missing, so that equal parts of the box hold unlike numbers
VOID = "region void block 14 INF INF INF INF INF\nregion lower_void block INF INF INF 8 INF INF\n"
VOID += "region voids intersect 2 void lower_void\ndelete_atoms region voids compress no\n"


def fullest(result):
    """Automata of the rank that has most, over the mean."""
    words = next(s for s in result.out.splitlines() if s.startswith("Nlocal:")).split()
    return float(words[3]) / float(words[1])


@pytest.mark.parametrize(
    "ranks,balance",
    [
        pytest.param(4, "fix balance all balance 50 1.0 shift x 10 1.0", marks=LONG),
        (3, "comm_style tiled\nfix balance all balance 50 1.0 rcb"),
    ],
)
def test_balance_of_a_sample_with_a_void(fragments, tmp_path, ranks, balance):
    """Borders between ranks move to where the automata are; the motion stays what it is."""
    more = dict(data=fragments, steps=300, every=300, before="processors * 1 1")
    runs = {}
    for name, given in {
        "alone": dict(extra=VOID),
        "even": dict(extra=VOID, ranks=ranks),
        "balanced": dict(extra=VOID + balance, ranks=ranks),
    }.items():
        result = lmp("in.fragments", tmp_path / name, **more, **given)
        runs[name] = result, dump(tmp_path / name / "state.dump")[-1][1]
    compare(runs["balanced"][1], runs["alone"][1], 1e-11)
    assert fullest(runs["balanced"][0]) < 1.1 < 1.2 < fullest(runs["even"][0])
