# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that continues equals the run that wrote the file; damaged files are refused."""

import re

import numpy as np
import pytest

from lmp_run import dump, fails, friction_log, largest_difference, lmp, periodic_block

TRAJECTORY = ["x", "y", "c_state[5]", "c_state[8]"]
VELOCITIES, SOUND = ["vx", "vy"], 5140  # scales as in test_parallel.py
STRESSES = ["fx", "fy", "tqz", "c_state[1]", "c_state[2]", "c_state[3]", "c_state[4]"]
COUNTS = ["type", "c_state[6]", "c_state[7]"]
LONG = pytest.mark.long
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
        lmp(
            "in.sliding",
            folders[ranks],
            ranks=ranks,
            data=rough_data,
            steps=STEPS,
            every=100,
            extra="restart 250 mid.*.restart",
        )
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


def different_bits(folder, other, name="final.dump"):
    """How many numbers of two dumps with 17 digits differ; the lines of LAMMPS's shrink-wrapped box
    aside."""
    (_, a), (_, b) = dump(folder / name)[-1], dump(other / name)[-1]
    return sum((a[c] != b[c]).sum() for c in a)


@pytest.mark.parametrize("ranks", [1, 2])
def test_continues_to_the_same_bits(written, tmp_path, ranks):
    """In a run that writes restart files at the same steps, on the same ranks."""
    go_on(
        tmp_path,
        written[ranks] / "mid.250.restart",
        ranks,
        STEPS - 250,
        extra="restart 250 mid.*.restart",
    )
    assert different_bits(tmp_path, written[ranks]) == 0
    assert (tmp_path / "mid.500.restart").stat().st_size == (
        written[ranks] / "mid.500.restart"
    ).stat().st_size


ISOCHORIC = "b plasticity isochoric flow contacts"
LAWS = [
    "b steps plain",
    "b viscosity both",
    "b viscosity both steps plain",
    "b worn never",
    "b friction 0.4",
]


@pytest.mark.parametrize(
    "ranks, laws",
    [
        (2, ISOCHORIC),
        *((1, laws) for laws in LAWS),
        pytest.param(1, ISOCHORIC, marks=LONG),
        *(pytest.param(2, laws, marks=LONG) for laws in LAWS),
    ],
)
def test_other_laws_continue_to_the_same_bits(rough_data, tmp_path, ranks, laws):
    every = "restart 250 mid.*.restart"
    if "both" in laws:
        every += "\ntimestep 1.25e-5"
    lmp(
        "in.sliding",
        tmp_path / "whole",
        ranks=ranks,
        data=rough_data,
        steps=STEPS,
        every=100,
        laws=laws,
        extra=every,
    )
    go_on(
        tmp_path / "rest", tmp_path / "whole" / "mid.250.restart", ranks, STEPS - 250, extra=every
    )
    assert different_bits(tmp_path / "rest", tmp_path / "whole") == 0


# lists are built at the same steps, whatever is written
ALWAYS = "neigh_modify every 10 delay 0 check no\n"


@pytest.mark.parametrize("ranks", [1, pytest.param(2, marks=LONG)])
@pytest.mark.parametrize(
    "lists", [pytest.param(ALWAYS, id="always"), pytest.param("", id="check", marks=LONG)]
)
def test_driven_to_the_same_bits(rough_data, tmp_path, ranks, lists):
    """Periodic and driven. Writing between two runs changes no bit of the second one, and the file
    goes on as it did. One run, with and without `restart N`, has their bits where lists are built
    at the same steps; else LAMMPS builds them, and wraps positions, once more where files are
    written and runs begin."""
    common = dict(data=rough_data, ranks=ranks, every=100)
    half = 150
    lmp("in.sliding", tmp_path / "two", steps=half, extra=lists + f"run {half}", **common)
    lmp(
        "in.sliding",
        tmp_path / "written",
        steps=half,
        extra=lists + f"run {half}\nwrite_restart half.restart",
        **common,
    )
    go_on(tmp_path / "read", tmp_path / "written" / "half.restart", ranks, half, extra=lists)
    same = ["written", "read"]
    lmp("in.sliding", tmp_path / "one", steps=2 * half, extra=lists, **common)
    if lists:
        lmp(
            "in.sliding",
            tmp_path / "restart",
            steps=2 * half,
            extra=lists + "restart 130 mid.*.restart",
            **common,
        )
        same += ["restart", "one"]
    for name in same:
        assert different_bits(tmp_path / name, tmp_path / "two") == 0, name
    compare(tmp_path / "one", tmp_path / "two", ROUNDOFF)


def test_lists_change_the_bits_of_stock_styles(rough_data, tmp_path):
    """The sample with pair_style lj/cut: one run and two halves without any file between part
    by round-off, and do not where lists are built at the same steps. So it is LAMMPS that makes the
    difference above."""
    script = f"""
variable extra index /dev/null
units nano
dimension 2
boundary p s p
atom_style sphere
timestep 5e-5
read_data {rough_data}
set group all density/disc 8
group upper type 2
pair_style lj/cut 6
pair_coeff * * 300 2.3
neighbor 0.4 bin
neigh_modify every 10 delay 0 check yes
velocity all create 300 4711
velocity upper set 10 0 0 sum yes
fix 1 all nve/sphere disc
fix 2 all enforce2d
include ${{extra}}
run 1000
dump final all custom 1 final.dump id x y vx vy fx fy
dump_modify final sort id format float %.17g
run 0
"""
    different = {}
    for lists in (ALWAYS, ""):
        lmp(script.replace("run 1000", "run 2000"), tmp_path / "one", extra=lists)
        lmp(script, tmp_path / "two", extra=lists + "run 1000")
        different[lists] = different_bits(tmp_path / "one", tmp_path / "two")
    print("numbers of lj/cut that differ:", different[""])
    assert different[ALWAYS] == 0 and different[""] > 0


@pytest.mark.parametrize(
    "ranks,newton",
    [(1, "on"), (2, "off"), pytest.param(1, "off", marks=LONG), pytest.param(2, "on", marks=LONG)],
)
def test_fragments_to_the_same_bits(fragments, tmp_path, ranks, newton):
    """Without periodic sides a run, the same run that writes files, and its parts are one, on one
    rank and with newton off; with newton on the ranks' shares of a sum depend on when lists are
    built."""
    common = dict(data=fragments, ranks=ranks, newton=newton, every=400)
    lmp("in.fragments", tmp_path / "whole", steps=400, **common)
    lmp(
        "in.fragments", tmp_path / "writes", steps=400, extra="restart 130 part.*.restart", **common
    )
    lmp(
        "in.fragments",
        tmp_path / "halves",
        steps=200,
        extra="run 200\nwrite_restart half.restart",
        **common,
    )
    for name in ("writes", "halves"):
        different = different_bits(tmp_path / name, tmp_path / "whole", "state.dump")
        print(name, ranks, newton, different)
        if ranks == 1 or newton == "off":
            assert different == 0


def test_stock_history_loses_what_ours_keeps(rough_data, tmp_path):
    """LAMMPS's fix NEIGH_HISTORY stores stale entries at write_restart between runs. The sum of the
    pairs' states before, after, and of the file: not one bit of ours is lost."""
    total = (
        "compute each all mca/link/local gamma kind plastic\ncompute total all reduce sum "
        "c_each[1] c_each[2] "
        "c_each[3] inputs local\nthermo_style custom step c_total[1] c_total[2] c_total[3]\n"
        "thermo_modify format "
        "float %25.17g\n"
    )
    columns = [f"c_total[{k}]" for k in (1, 2, 3)]
    ours = lmp(
        "in.sliding",
        tmp_path,
        data=rough_data,
        steps=1,
        every=100,
        extra=total + "run 300\nwrite_restart file.restart\nrun 0",
    ).thermo
    kept = go_on(tmp_path, "file.restart", 1, 0, extra=total).thermo
    for column in columns:
        before, after = ours[0][column][-1], ours[1][column][-1]
        assert before != 0.0 and after == before and kept[0][column][-1] == before
    stock = """
units nano
dimension 2
boundary p p p
atom_style sphere
region box block 0 25 0 20 -0.5 0.5
create_box 1 box
create_atoms 1 random 200 4711 NULL
set group all diameter 1.6 density 0.01
pair_style gran/hooke/history 1000 NULL 10 NULL 0.5 1
pair_coeff * *
velocity all create 1e6 815
neighbor 0.3 bin
comm_modify vel yes
timestep 1e-4
fix 1 all nve/sphere disc
fix 2 all enforce2d
compute torque all property/atom tqz
compute mean all reduce sumsq c_torque
thermo_style custom step c_mean
thermo_modify format float %25.17g
run 2000
write_restart stock.restart
run 0
"""
    first, second = lmp(stock, tmp_path / "stock").thermo
    lost = 1 - second["c_mean"][-1] / first["c_mean"][-1]
    print(
        f"stock history: sum of squared torques changes by {lost:.1%} at write_restart; ours by 0"
    )
    assert abs(lost) > 1e-3  # the defect that ours avoids is there


@pytest.mark.parametrize(
    "of,ranks", [(1, 3), (2, 1), pytest.param(1, 2, marks=LONG), pytest.param(2, 4, marks=LONG)]
)
def test_continues_on_other_ranks(whole, written, tmp_path, of, ranks):
    go_on(tmp_path, written[of] / "mid.250.restart", ranks, STEPS - 250)
    compare(tmp_path, written[of], ROUNDOFF)


@pytest.mark.parametrize("ranks,newton", [(1, "on"), (2, "off"), pytest.param(2, "on", marks=LONG)])
def test_two_halves_with_a_file_between(rough_data, tmp_path, ranks, newton):
    """write_restart between two runs loses nothing, neither in this process nor in the file."""
    common = dict(ranks=ranks, newton=newton, data=rough_data, every=100)
    lmp("in.sliding", tmp_path / "whole", steps=500, **common)
    lmp(
        "in.sliding",
        tmp_path / "halves",
        steps=250,
        extra="run 250\nwrite_restart half.restart",
        **common,
    )
    compare(tmp_path / "halves", tmp_path / "whole", ROUNDOFF)
    go_on(tmp_path / "file", tmp_path / "halves" / "half.restart", ranks, 250, newton=newton)
    compare(tmp_path / "file", tmp_path / "whole", ROUNDOFF)


@pytest.mark.parametrize("hybrid", [False, True])
def test_the_time_goes_on(tmp_path, hybrid):
    """A load that follows the time, from a file written within a run."""
    style = "pair_style hybrid/overlay mca zero 3\n" if hybrid else "pair_style mca\n"
    coeff = "pair_coeff * * mca steel.mca\n" if hybrid else "pair_coeff * * steel.mca\n"
    coeff += "pair_coeff * * zero\n" if hybrid else ""
    load = "variable load equal 15*(1+0.5*sin(2*PI*time/0.02))\n"
    more = "fix i all nve/mca\nthermo_style custom step time v_load\nthermo 50\n"
    more += "thermo_modify format float %.15g\nneighbor 0.4 bin\n"
    begin = periodic_block() + style + coeff + "mca_links create all all\n" + load + more
    begin += "run 100\ntimestep 4e-5\nrestart 150 mid.*.restart\nrun 200\n"
    whole = lmp(begin, tmp_path).thermo[-1]
    coeffs = coeff if hybrid else ""
    table = lmp(
        load + "read_restart mid.150.restart\n" + coeffs + more + "run 150\n", tmp_path
    ).thermo[-1]
    assert list(table["Time"]) == list(whole["Time"][1:])
    assert list(table["v_load"]) == list(whole["v_load"][1:])


def test_run_pre_no(rough_data, tmp_path):
    lmp("in.sliding", tmp_path / "whole", steps=400, data=rough_data, every=100)
    lmp(
        "in.sliding",
        tmp_path / "parts",
        steps=200,
        data=rough_data,
        every=100,
        extra="run 100\nrun 100 pre no",
    )
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


def test_read_write_read(written, fragments, tmp_path):
    """Reading a file and writing it again gives the same bytes. Where LAMMPS shrink-wraps the box,
    it leaves a margin of 1e-4 of the former box, hence moves both bounds by some 1e-10 each time:
    these two numbers alone differ."""

    def again(folder, first):
        for k in (1, 2):
            lmp(
                "in.continue",
                folder,
                restart=first if k == 1 else "again1.restart",
                steps=-1,
                after=f"write_restart again{k}.restart",
            )
        files = ((folder / f"again{k}.restart").read_bytes() for k in (1, 2))
        return (without_seal(data) for data in files)

    def box(name):
        out = lmp(
            "in.continue",
            tmp_path,
            restart=name,
            steps=-1,
            after="print 'y: $(ylo:%.17g) $(yhi:%.17g)'",
        ).out
        return [float(y) for y in re.findall(r"^y: (\S+) (\S+)$", out, re.M)[-1]]

    a, b = again(tmp_path, written[1] / "mid.250.restart")
    for name, old, new in zip(("ylo", "yhi"), box("again1.restart"), box("again2.restart")):
        print(f"{name} {old:.17g} {new:.17g}")
        assert abs(new - old) < 1e-9
        assert a.count(np.float64(old).tobytes()) == b.count(np.float64(new).tobytes()) == 1
        a, b = (
            data.replace(np.float64(y).tobytes(), name.encode()) for data, y in ((a, old), (b, new))
        )
    assert a == b  # all the rest, hence every block of ours
    folder = tmp_path / "fixed"
    lmp(
        "in.fragments",
        folder,
        data=fragments,
        boundary="f f",
        steps=300,
        every=300,
        extra="region bottom block INF INF INF 1 INF INF\ngroup bottom region bottom\n"
        "group top subtract upper lower",
        after="write_restart box.restart",
    )
    a, b = again(folder, folder / "box.restart")
    assert a == b


MARK = b"mca-restart 3:\n\0"


def without_seal(data):
    """The checksum of the whole file, behind its mark, is that of the numbers that differ."""
    place = data.index(MARK) + len(MARK)
    assert data.count(MARK) == 1 and data[place : place + 8] != bytes(8)
    return data[:place] + data[place + 8 :]


def refused(data, folder, *parts):
    (folder / "bad.restart").write_bytes(data)
    return fails("in.continue", folder, *parts, restart="bad.restart", steps=0)


@pytest.mark.parametrize("ours, others", [(8, 4), pytest.param(30, 15, marks=LONG)])
def test_no_flipped_bit_is_taken(written, tmp_path, ours, others):
    """Anywhere in the file; what LAMMPS reads before us it may refuse itself."""
    data = (written[1] / "mid.250.restart").read_bytes()
    begin = data.index(MARK)
    random = np.random.default_rng(24)
    spread = random.integers(begin, len(data), ours), random.integers(0, begin, others)
    for place in map(int, np.concatenate(spread)):
        damaged = bytearray(data)
        damaged[place] ^= 1 << int(random.integers(8))
        (tmp_path / "bad.restart").write_bytes(damaged)
        result = lmp("in.continue", tmp_path, restart="bad.restart", steps=0, check=False)
        assert result.rc != 0, f"bit flipped in byte {place}, pair style from {begin}"
        if place >= begin:
            (line,) = result.error_lines
            assert "Restart file is damaged" in line, place


@pytest.mark.parametrize(
    "name",
    [
        b"MCA_STATE\0",
        b"drive\0",
        *(
            pytest.param(n, marks=LONG)
            for n in (b"MCA_HISTORY\0", b"mca/drive\0", b"MCA_STATE\0\n")
        ),
    ],
)
def test_a_flipped_name_or_length_is_refused(written, tmp_path, name):
    """Without a fix's state links would vanish, or a log begin anew."""
    data = (written[1] / "mid.250.restart").read_bytes()
    for place in [m.start() for m in re.finditer(re.escape(name), data)]:
        # a letter; bytes of the lengths of the name and of the state behind it
        for byte in (place, place - 4, place + len(name), place + len(name) + 1):
            damaged = bytearray(data)
            damaged[byte] ^= 2
            refused(damaged, tmp_path, "Restart file is damaged", "checksum")


def test_files_without_checksum_are_refused(written, tmp_path):
    data = (written[1] / "mid.250.restart").read_bytes()
    place = data.index(MARK) + len(MARK)
    refused(data[:place] + bytes(8) + data[place + 8 :], tmp_path, "not written to its end")
    refused(data[: place - len(MARK)] + data[place + 8 :], tmp_path, "of another version")


def test_parts_of_a_file_are_checked(rough_data, tmp_path):
    """A file in several parts: the base by its checksum, records by theirs."""
    lmp("in.sliding", tmp_path, data=rough_data, steps=100, extra="restart 100 part.%.*.restart")
    more = dict(restart="part.%.100.restart", steps=0)
    lmp("in.continue", tmp_path, **more)
    base = tmp_path / "part.base.100.restart"
    data = bytearray(base.read_bytes())
    data[data.index(b"preset b ")] ^= 8
    base.write_bytes(data)
    fails("in.continue", tmp_path, "Restart file is damaged", "checksum", **more)


def places(data):
    """Where the text blocks of the pair style stand: laws and materials."""
    text = [m.start() for m in re.finditer(rb"preset b |206000 0\.2999", data)]
    assert len(text) == 3
    return text


def test_flipped_byte_in_our_block_is_refused(written, tmp_path):
    data = (written[1] / "mid.250.restart").read_bytes()
    for place in places(data):
        damaged = bytearray(data)
        damaged[place] ^= 1
        (tmp_path / "bad.restart").write_bytes(damaged)
        fails("in.continue", tmp_path, "damaged", "checksum", restart="bad.restart", steps=1)


def test_flipped_bit_in_a_record_is_refused(rough_data, tmp_path):
    """Bits of the records of pairs (MCA_HISTORY) and of automata (MCA_STATE), in a part of a file,
    which no checksum of the whole holds."""
    lmp("in.sliding", tmp_path, data=rough_data, steps=250, extra="restart 250 part.%.*.restart")
    part = tmp_path / "part.0.250.restart"
    more = dict(restart="part.%.250.restart", steps=0, check=False)
    data = part.read_bytes()
    refused = {"MCA_HISTORY": 0, "MCA_STATE": 0}
    random = np.random.default_rng(7)
    # a kind of link in a record of pairs, a number of original links in one of state
    for value in (1.0, 6.0):
        found = [m.start() for m in re.finditer(re.escape(np.array([value]).tobytes()), data)]
        for place in random.choice(found, 8, replace=False):
            damaged = bytearray(data)
            damaged[place] ^= 4
            part.write_bytes(damaged)
            result = lmp("in.continue", tmp_path, **more)
            for line in result.error_lines:
                for name in refused:
                    refused[name] += f"damaged: the {name} record of atom" in line
    print("refused:", refused)
    assert refused["MCA_HISTORY"] >= 3 and refused["MCA_STATE"] >= 2


def test_truncated_file_is_refused(written, tmp_path):
    data = (written[1] / "mid.250.restart").read_bytes()
    for part in (0.02, 0.5, 0.97):
        (tmp_path / "cut.restart").write_bytes(data[: int(part * len(data))])
        result = lmp("in.continue", tmp_path, restart="cut.restart", steps=1, check=False)
        assert result.rc != 0
        assert len(result.error_lines) == 1, result.out[-500:] + result.err[-500:]
