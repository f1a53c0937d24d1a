# SPDX-License-Identifier: GPL-2.0-or-later
"""What would lose data or give silent nonsense: one ERROR line, or one warning with the number."""

import os
import re
import stat
import subprocess
from pathlib import Path

import pytest

from lmp_run import INPUTS, LMP, fails, friction_log, lmp

WR_FIT = Path(LMP).parent / "wr_fit"
LONG = pytest.mark.long
RANKS = [1, pytest.param(2, marks=LONG)]
HEAD = """
units nano
dimension 2
boundary p s p
atom_style sphere
timestep 3e-5
neighbor 0.4 bin
lattice hex 2.5
"""
BOX = """
region box block 0 30 -0.2 $(5*2.5*sqrt(3)/2+0.2) -0.5 0.5 units box
create_box 1 box
create_atoms 1 box
region bottom block INF INF INF 1 INF INF units box
region top block INF INF 10 INF INF INF units box
group bottom region bottom
group top region top
group rest subtract all top
"""
LAWS = """
pair_style mca
pair_coeff * * steel.mca
mca_links create all all
"""
MOVED = "fix integrate all nve/mca\nfix hold bottom freeze\n"
BLOCK = HEAD + BOX + LAWS + MOVED
DRIVE = "fix drive top mca/drive velocity 5 pressure 15 "
FILE = "file x.friction every 50\n"


def warned(text, folder, *parts, times=1, **more):
    """The run goes on, with one warning that says all parts."""
    result = lmp(text, folder, **more)
    lines = [s for s in (result.out + result.err).splitlines() if s.startswith("WARNING")]
    assert sum(all(p in line for p in parts) for line in lines) == times, lines
    return result


# ---- logs


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """A run of 200 steps with its log and the restart file of its end."""
    folder = tmp_path_factory.mktemp("first")
    lmp(BLOCK + DRIVE + FILE + "run 200\nwrite_restart end.restart\n", folder)
    return folder


@pytest.fixture
def again(first, tmp_path):
    """What `first` left, in a folder of its own, and the commands that go on from there."""
    for name in ("x.friction", "end.restart"):
        (tmp_path / name).write_bytes((first / name).read_bytes())
    return tmp_path


READ = "read_restart end.restart\nneighbor 0.4 bin\n" + MOVED


def kept(folder, first):
    assert (folder / "x.friction").read_bytes() == (first / "x.friction").read_bytes()


def test_a_restart_goes_on_with_its_log(again):
    lmp(READ + DRIVE + FILE + "run 100\n", again)
    assert list(friction_log(again / "x.friction")[1]["step"]) == [50, 100, 150, 200, 250, 300]


@pytest.mark.parametrize(
    "drive, part",
    [
        (
            DRIVE.replace("fix drive", "fix other") + FILE,
            "the restart file holds no log of that name",
        ),
        (DRIVE.replace("pressure 15", "pressure 26") + FILE, "pressure is 15 in the log, 26 in"),
        (DRIVE.replace("velocity 5", "velocity 6") + FILE, "velocity is 5 in the log, 6 in"),
        (DRIVE + FILE.replace("50", "100"), "every is 50 in the log, 100 in"),
        (DRIVE + FILE.replace("\n", " seed 2\n"), "seed is 0 in the log, 2 in"),
        ("pair_coeff * * steel.mca strength 552\n" + DRIVE + FILE, "in the log"),
        ("timestep 2e-5\n" + DRIVE + FILE, "timestep is 3.0e-05 in the log, 2.0e-05 in"),
    ],
)
@pytest.mark.parametrize("ranks", RANKS)
def test_no_other_log_is_erased_after_a_restart(again, first, drive, part, ranks):
    fails(READ + drive + "run 100\n", again, "x.friction", part, ranks=ranks)
    kept(again, first)


def test_a_log_of_another_run_is_not_continued(again, first):
    other = again / "other.friction"
    text = (again / "x.friction").read_text()
    other.write_text("\n".join(text.splitlines()[:-1]) + "\n")  # a row less
    before = other.read_bytes()
    drive = DRIVE + FILE.replace("x.", "other.")
    fails(READ + drive + "run 100\n", again, "3 rows", "4 rows, the last one of step 200")
    assert other.read_bytes() == before
    kept(again, first)


def test_a_log_that_is_not_there_begins_anew_with_a_warning(again):
    (again / "x.friction").unlink()
    warned(READ + DRIVE + FILE + "run 100\n", again, "x.friction with 4 rows", "a new one begins")
    assert list(friction_log(again / "x.friction")[1]["step"]) == [250, 300]


def test_a_drive_after_another_does_not_erase_its_log(tmp_path):
    script = BLOCK + DRIVE + FILE + "run 100\nunfix drive\n" + DRIVE + FILE + "run 100\n"
    fails(script, tmp_path, "has rows from step 50 on", "at step 100")
    assert list(friction_log(tmp_path / "x.friction")[1]["step"]) == [50, 100]


def test_no_file_of_other_contents_is_replaced(tmp_path):
    (tmp_path / "x.friction").write_text("my notes\n")
    fails(BLOCK + DRIVE + FILE + "run 100\n", tmp_path, "x.friction", "its first line is not")
    assert (tmp_path / "x.friction").read_text() == "my notes\n"


def test_a_run_from_the_beginning_replaces_its_log(tmp_path):
    for _ in range(2):
        lmp(BLOCK + DRIVE + FILE + "run 100\n", tmp_path)
    assert list(friction_log(tmp_path / "x.friction")[1]["step"]) == [50, 100]


@pytest.mark.parametrize("name", ["x.friction", "link", "./x.friction"])
def test_two_drives_on_one_file(tmp_path, name):
    (tmp_path / "link").symlink_to("x.friction")
    second = f"fix more bottom mca/drive velocity 0 pressure 15 file {name} every 50\n"
    fails(
        BLOCK.replace("fix hold bottom freeze\n", "") + DRIVE + FILE + second + "run 100\n",
        tmp_path,
        name,
        "another fix or program writes this file",
    )


@pytest.mark.parametrize(
    "writer, part",
    [
        ("dump d all custom 50 ./x.friction id\n", "is also the file of dump d"),
        (
            "fix events all mca/events 50 step id1\ndump d all local 50 x.friction f_events[*]\n",
            "is also the file of dump d",
        ),
        ("run 60\nmca_links write x.friction\n", "another fix or program writes this file"),
        ("run 60\nprint x file x.friction\n", "another fix or program writes this file"),
    ],
)
def test_another_writer_on_the_log(tmp_path, writer, part):
    fails(BLOCK + DRIVE + FILE + writer + "run 100\n", tmp_path, "x.friction", part)


def test_devices_pipes_and_links_stay(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    pipe = os.open(tmp_path / "pipe", os.O_RDONLY | os.O_NONBLOCK)
    (tmp_path / "link").symlink_to("real")
    try:
        os.mknod(tmp_path / "null", 0o600 | stat.S_IFCHR, os.makedev(1, 3))
    except PermissionError:  # only root makes devices
        (tmp_path / "null").symlink_to("/dev/null")
    kind = (tmp_path / "null").lstat().st_mode
    for name in ("pipe", "link", "null"):
        lmp(BLOCK + DRIVE + FILE.replace("x.friction", name) + "run 100\n", tmp_path)
    assert os.read(pipe, 100000).count(b"\n") == 11
    lmp(BLOCK + "mca_links write link\nmca_links write null\n", tmp_path)
    os.close(pipe)
    assert stat.S_ISFIFO((tmp_path / "pipe").lstat().st_mode)
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text().startswith("LAMMPS data file")
    assert (tmp_path / "null").lstat().st_mode == kind
    assert not list(tmp_path.glob("*.part*"))


@pytest.mark.parametrize("words", ["velocity -5 pressure 15", "velocity 0 pressure 0"])
def test_wr_fit_reads_what_is_written(tmp_path, words):
    """The range of numbers of a head is one for both, friction_log_format.h."""
    script = f"fix drive top mca/drive {words} " + FILE.replace("\n", " seed -1\n")
    lmp(BLOCK + script + "run 2000\n", tmp_path)
    if not WR_FIT.exists():
        pytest.skip("wr_fit is not built")
    done = subprocess.run(
        [WR_FIT, "x.friction"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode != 3, done.stderr  # 3 is a log that is refused


# ---- loads and motion


@pytest.mark.parametrize(
    "script, parts",
    [
        (  # nothing moves the layer
            HEAD + BOX + LAWS + "fix integrate rest nve/mca\n" + DRIVE + "\n",
            ["nothing moves 12 of the 12 automata of group top"],
        ),
        (BLOCK + DRIVE + "\nfix more all mca/drive velocity 1 pressure 1\n", ["both drive 12"]),
        (BLOCK + "fix hold top freeze\n" + DRIVE, ["fix hold freeze moves or holds 12 of its"]),
        (BLOCK + "fix go top move linear 1 0 0\n" + DRIVE, ["fix go move moves or holds 12"]),
        (
            BLOCK
            + "variable upper atom y>10\ngroup upper dynamic all var upper every 5\n"
            + DRIVE.replace("top", "upper"),
            ["group upper is dynamic", "a static group"],
        ),
        (BLOCK + DRIVE.replace("15", "1e9"), ["pressure is 1", "below Young's modulus, 206000"]),
        (BLOCK + DRIVE.replace("5 p", "1e15 p"), ["velocity is 1", "below the speed of sound"]),
        (
            BLOCK + "variable p equal 15-30*(step>20)\n" + DRIVE.replace("15", "v_p"),
            ["pressure is -15 in step 21", ">= 0"],
        ),
        (
            BLOCK + "variable v equal 1e6*(step>20)\n" + DRIVE.replace("5 p", "v_v p"),
            ["velocity is 1000000", "in step 21"],
        ),
        (BLOCK + "timestep -5e-5\n", ["Timestep -5e-05 is not allowed", "> 0"]),
        (BLOCK + "timestep 0\n", ["Timestep 0 is not allowed", "> 0"]),
        (BLOCK + DRIVE + FILE + "run 50\ntimestep 2e-5\n", ["2e-05", "x.friction is open"]),
        (BLOCK + "velocity all set 1e15 0 0\n", ["velocity", "above", "in step 0"]),
        (BLOCK + "velocity rest set 0 -1e12 0\n", ["velocity", "above", "in step 0"]),
    ],
)
def test_refused(tmp_path, script, parts):
    fails(script + "\nrun 100\n", tmp_path, *parts)


def test_a_variable_that_is_deleted_within_a_run(tmp_path):
    drive = "variable p equal 15\n" + DRIVE.replace("15", "v_p")
    script = BLOCK + drive + '\nrun 20 pre no every 10 "variable p delete"\nprint "went on"\n'
    assert "went on" not in fails(script, tmp_path, "no equal-style variable p").out


def test_a_pressure_above_the_strength_is_told(tmp_path):
    script = BLOCK + DRIVE.replace("15", "1000") + "\nrun 10\nrun 10\n"
    warned(script, tmp_path, "pressure 1000 is above the strength", "92")


# ---- overlap, nan


@pytest.mark.parametrize("ranks", RANKS)
def test_overlapping_blocks(tmp_path, ranks):
    """The script of the README with another seed for the upper block."""
    text = (INPUTS.parents[2] / "README.md").read_text()
    script = re.search(r"```lammps\n(.*?)```", text, re.DOTALL)[1]
    lower, upper = "14.07 3.25 5 ${seed}", "above 14.07 3.25 5 2"
    script = script.replace(f"above {lower}", upper)
    assert upper in script
    result = fails(script, tmp_path, "overlap:", "diameter of 2.5", ranks=ranks)
    message = "\n".join(result.error_lines)
    apart = re.search(r"Automata \d+ and \d+ overlap: (\S+) apart", message)[1]
    assert float(apart) <= 2.5 / 3**0.5


@pytest.mark.parametrize("less", ["", "group one id 3\ndelete_atoms group one\n"])
def test_an_automaton_created_on_another_one(tmp_path, less):
    more = "run 10\n" + less + "create_atoms 1 single 10.1 5.1 0 units box\nrun 10\n"
    fails(BLOCK + more, tmp_path, "overlap")


@pytest.mark.parametrize("ranks", RANKS)
@pytest.mark.parametrize("steps", [20, 250])
def test_nan_ends_the_run(tmp_path, ranks, steps):
    """At the end of a short run, or within 100 steps; never in the log."""
    script = BLOCK + DRIVE + FILE.replace("50", "10")
    script += "variable f equal exp(1e3*(step>=15))-1\nfix push rest addforce v_f 0 0\n"
    script += f"run {steps}\n"
    result = fails(script, tmp_path, "Automata ", "is nan, infinite", ranks=ranks)
    step = int(re.search(r"in step (\d+)", "\n".join(result.error_lines))[1])
    assert step <= 115
    assert "nan" not in (tmp_path / "x.friction").read_text()


@pytest.mark.parametrize("ranks", RANKS)
def test_a_plastic_strain_that_is_infinite_ends_the_run(tmp_path, ranks):
    """Of an automaton that is held, too, whose place tells nothing."""
    script = BLOCK + "fix hold all freeze\nrun 10\nvariable bad atom exp(1e3)\n"
    result = fails(
        script + "set atom 5 d_mca_kappa v_bad\nrun 10\n", tmp_path, "Automata 5:", ranks=ranks
    )
    assert "plastic strain is nan, infinite" in "\n".join(result.error_lines)


def test_automata_at_one_place(tmp_path):
    script = HEAD + BOX + "create_atoms 1 single 10.1 5.1 0 units box\n" + LAWS + MOVED
    fails(script.replace("mca_links create all all\n", "") + "run 1\n", tmp_path, "overlap")


# ---- internal fixes


GONE = [
    ("unfix MCA_STATE", "MCA_STATE"),
    ("unfix MCA_HISTORY", "MCA_HISTORY"),
    ("unfix MCA_SPINS", "MCA_SPINS"),
    ("plugin unload fix MCA_STATE", "MCA_STATE"),
    ("plugin unload fix MCA_HISTORY", "MCA_HISTORY"),
    ("unfix MCA_ENERGY", "MCA_ENERGY"),
    ("plugin unload fix MCA_ENERGY", "MCA_ENERGY"),
]
USES = [
    "run 10",
    "mca_links create all all\nrun 10",
    "write_restart x.restart\nrun 10",
    "write_dump all custom x.dump id c_state[1]\nrun 10",
    "run 10 pre no",
]


@pytest.mark.parametrize(
    "command, fix, use",
    [  # each fix and each use once, the others are long
        pytest.param(*gone, use, marks=[LONG] if i and k else [])
        for i, gone in enumerate(GONE)
        for k, use in enumerate(USES)
    ],
)
def test_internal_fixes_that_are_gone(tmp_path, command, fix, use):
    computes = "compute state all mca/atom plastic links\ncompute e all mca/energy\n"
    block = BLOCK
    script = block + computes + f"thermo_style custom step c_e\nrun 10\n{command}\n{use}\n"
    result = fails(script, tmp_path, f"Fix {fix}, ", "is gone")
    assert result.rc > 0  # no signal


@pytest.mark.parametrize("when", ["run 10\n", pytest.param("", marks=LONG)])
@pytest.mark.parametrize("name", ["MCA_HISTORY 8", "MCA_STATE d_x", "MCA_ENERGY"])
def test_internal_fixes_are_not_for_scripts(tmp_path, when, name):
    fails(BLOCK + when + f"fix mine all {name}\n", tmp_path, "is internal to")


def test_placeholders_that_are_gone(tmp_path):
    script = BLOCK.replace("pair_coeff", "unfix MCA_STATE_DUMMY\npair_coeff")
    fails(script + "run 0\n", tmp_path, "MCA_STATE_DUMMY", "is gone")


@pytest.mark.parametrize("use", ["run 10", "write_dump all custom x.dump id c_state[1]"])
def test_the_pair_style_is_gone(tmp_path, use):
    compute = "compute state all mca/atom plastic links\n"
    script = BLOCK + compute + f"run 10\nplugin unload pair mca\n{use}\n"
    fails(script, tmp_path, "requires pair_style mca")


# ---- warnings of what is hardly meant


def block(laws=LAWS, lattice="hex 2.5", moved=MOVED):
    return HEAD.replace("hex 2.5", lattice) + BOX + laws + moved


STRESSED = ["pairs are stressed above the strength", "does the lattice fit the diameter"]


@pytest.mark.parametrize(
    "script, parts",
    [
        (block(LAWS.replace("mca_links create all all\n", "")), ["no links among 72 automata"]),
        (block(LAWS.replace("steel.mca", "steel.mca diameter 2")), ["no links among", "0 pairs"]),
        (block(lattice="sq 2.5"), ["no automaton has the 6 links of packing hex, the most is 4"]),
        (block(moved="fix 1 all nve\n"), ["fix 1 nve moves 72 automata"]),
        (block(moved="fix 1 all nve/sphere\n"), ["fix 1 nve/sphere moves 72 automata"]),
        (block("set group all diameter 2\n" + LAWS), ["diameters of 72", "densities of 0"]),
        (block("set group all density 2.7\n" + LAWS), ["diameters of 0", "densities of 72"]),
        # between the set-up of links and the first run, and between two runs
        (block(LAWS + "set group all diameter 2\n"), ["diameters of 72", "densities of 0"]),
        (block() + "run 1\nset group all mass 2.7\n", ["diameters of 0", "densities of 72"]),
        (
            block(LAWS.replace("steel.mca", "steel.mca density 2700")),
            ["type 1 travel at 8.73 m/s", "units nano"],
        ),
        # links 2 % shorter and 0.8 % longer than the diameter
        (block(lattice="hex 2.45").replace("block 0 30", "block 0 29.4"), STRESSED),
        (block(lattice="hex 2.52").replace("block 0 30", "block 0 30.24"), STRESSED),
        # the period 0.2 nm too short: pairs over the side
        (block().replace("block 0 30", "block 0 29.8"), STRESSED),
    ],
)
def test_told_once(tmp_path, script, parts):
    warned(script + "run 0\nrun 0\n", tmp_path, *parts)


def test_stress_of_a_sample_that_was_loaded_before_is_no_surprise(tmp_path):
    """It has flowed, or comes from a restart file."""
    loaded = block(lattice="hex 2.45").replace("block 0 30", "block 0 29.4") + "run 50\n"
    lmp(loaded + "mca_links write x.data\nwrite_restart x.restart\n", tmp_path)
    text = "units nano\nread_restart x.restart\n" + MOVED + "run 1\n"
    result = lmp(text, tmp_path)
    assert "stressed above" not in result.out + result.err


def test_a_plain_sample_gives_no_warning(tmp_path):
    wide = BLOCK.replace("block 0 30", "block 0 90")
    result = lmp(wide + DRIVE + FILE + "run 100\n", tmp_path)
    assert "WARNING" not in result.out + result.err
