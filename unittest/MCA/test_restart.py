"""A run that continues equals the run that wrote the file; damaged files are refused."""

import re

import pytest

from lmp_run import dump, fails, friction_log, largest_difference, lmp

TRAJECTORY = ["x", "y", "c_state[5]", "c_state[8]"]
VELOCITIES, SOUND = ["vx", "vy"], 5140  # scales as in test_parallel.py
STRESSES = ["fx", "fy", "tqz", "c_state[1]", "c_state[2]", "c_state[3]", "c_state[4]"]
COUNTS = ["type", "c_state[6]", "c_state[7]"]
STEPS = 600
ROUNDOFF = 1e-12


def compare(folder, other, tolerance):
    a, b = (dump(f / "final.dump")[-1][1] for f in (folder, other))
    for name in COUNTS:
        assert (a[name] == b[name]).all(), name
    assert largest_difference(a, b, TRAJECTORY) < tolerance
    assert largest_difference(a, b, VELOCITIES, SOUND) < tolerance
    assert largest_difference(a, b, STRESSES, 206000) < tolerance


@pytest.fixture(scope="module")
def whole(rough_data, tmp_path_factory):
    """Runs without a break, by number of ranks."""
    folders = {}
    for ranks in (1, 2):
        folders[ranks] = tmp_path_factory.mktemp(f"whole{ranks}")
        lmp("in.sliding", folders[ranks], ranks=ranks, data=rough_data, steps=STEPS, every=100)
    return folders


@pytest.fixture(scope="module")
def written(rough_data, tmp_path_factory):
    """Runs that write restart files on their way (`restart N`) and go on."""
    folders = {}
    for ranks in (1, 2):
        folders[ranks] = tmp_path_factory.mktemp(f"written{ranks}")
        lmp("in.sliding", folders[ranks], ranks=ranks, data=rough_data, steps=STEPS, every=100,
            extra="restart 250 mid.*.restart")
    return folders


def go_on(folder, restart, ranks, steps, **more):
    return lmp("in.continue", folder, ranks=ranks, restart=restart, steps=steps, every=100, **more)


def test_events_after_the_restart(whole):
    log = friction_log(whole[1] / "sliding.friction")[1]
    late = log["step"] > 250
    assert log["broken"][late].sum() + log["formed"][late].sum() > 5


@pytest.mark.parametrize("ranks", [1, 2])
def test_writing_changes_nothing(whole, written, ranks):
    """`restart N` makes LAMMPS rebuild its lists at that step, which changes the order of sums;
    the round-off of 1e-16 grows by the contacts' instability."""
    compare(written[ranks], whole[ranks], ROUNDOFF)


@pytest.mark.parametrize("ranks", [1, 2])
def test_continues_exactly(whole, written, tmp_path, ranks):
    go_on(tmp_path, written[ranks] / "mid.250.restart", ranks, STEPS - 250)
    compare(tmp_path, written[ranks], ROUNDOFF)


@pytest.mark.parametrize("of,ranks", [(1, 2), (1, 3), (2, 1), (2, 4)])
def test_continues_on_other_ranks(whole, written, tmp_path, of, ranks):
    go_on(tmp_path, written[of] / "mid.250.restart", ranks, STEPS - 250)
    compare(tmp_path, written[of], 1e-10)


@pytest.mark.parametrize("ranks,newton", [(1, "on"), (2, "on"), (2, "off")])
def test_two_halves_with_a_file_between(rough_data, tmp_path, ranks, newton):
    """write_restart between two runs loses nothing, neither in this process nor in the file."""
    common = dict(ranks=ranks, newton=newton, data=rough_data, every=100)
    lmp("in.sliding", tmp_path / "whole", steps=500, **common)
    lmp("in.sliding", tmp_path / "halves", steps=250,
        extra="run 250\nwrite_restart half.restart", **common)
    compare(tmp_path / "halves", tmp_path / "whole", ROUNDOFF)
    go_on(tmp_path / "file", tmp_path / "halves" / "half.restart", ranks, 250, newton=newton)
    compare(tmp_path / "file", tmp_path / "whole", ROUNDOFF)


def test_run_pre_no(rough_data, tmp_path):
    lmp("in.sliding", tmp_path / "whole", steps=400, data=rough_data, every=100)
    lmp("in.sliding", tmp_path / "parts", steps=200, data=rough_data, every=100,
        extra="run 100\nrun 100 pre no")
    compare(tmp_path / "parts", tmp_path / "whole", ROUNDOFF)


def test_log_goes_on(whole, written, tmp_path):
    """The continued log equals the one of the run without a break."""
    text = (written[1] / "sliding.friction").read_text()
    (tmp_path / "sliding.friction").write_text(text)  # with rows later than the restart
    go_on(tmp_path, written[1] / "mid.250.restart", 1, STEPS - 250)
    a = friction_log(tmp_path / "sliding.friction")[1]
    b = friction_log(whole[1] / "sliding.friction")[1]
    for name in b:
        assert a[name] == pytest.approx(b[name], rel=1e-6, abs=1e-9), name


def test_read_write_read(written, tmp_path):
    """Reading a file and writing it again gives the same bytes (but for the box, which LAMMPS shrink-wraps anew)."""
    first = written[1] / "mid.250.restart"
    for k in (1, 2):
        lmp("in.continue", tmp_path, restart=first if k == 1 else tmp_path / "again1.restart",
            steps=-1, after=f"write_restart again{k}.restart")
    a, b = ((tmp_path / f"again{k}.restart").read_bytes() for k in (1, 2))
    assert len(a) == len(b)
    assert sum(x != y for x, y in zip(a, b)) <= 16  # ylo and yhi


def blocks(data):
    """Places of the text of our own blocks."""
    places = [m.start() for m in re.finditer(rb"preset b |2\.5 206000|206000 0\.2999", data)]
    assert places
    return places


def test_flipped_byte_in_our_block_is_refused(written, tmp_path):
    data = bytearray((written[1] / "mid.250.restart").read_bytes())
    for place in blocks(bytes(data)):
        damaged = bytearray(data)
        damaged[place] ^= 1
        (tmp_path / "bad.restart").write_bytes(damaged)
        fails("in.continue", tmp_path, "damaged", "checksum", restart="bad.restart", steps=1)


def test_truncated_file_is_refused(written, tmp_path):
    data = (written[1] / "mid.250.restart").read_bytes()
    for part in (0.02, 0.5, 0.97):
        (tmp_path / "cut.restart").write_bytes(data[:int(part * len(data))])
        result = lmp("in.continue", tmp_path, restart="cut.restart", steps=1, check=False)
        assert result.rc != 0
        assert len(result.error_lines) == 1, result.out[-500:] + result.err[-500:]
