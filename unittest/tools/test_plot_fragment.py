# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/plot_fragment.py: a picture from a dump, or one clear line and no file."""

import json
import subprocess
from pathlib import Path

import pytest

import forked_scripts
from mcawr.campaign_record import timestep_of
from mcawr.dump import Film
from script_calls import load

LONG = pytest.mark.long
PLOT = Path(__file__).resolve().parents[2] / "tools" / "plot_fragment.py"
HEAD = "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS pp ss pp\n0 5\n0 2.2\n-1 1\n"
FRAME = HEAD + (
    "ITEM: ATOMS id type x y vx c_state[1]\n1 1 0 0 0 4\n2 1 2.5 0 0 4\n"
    "3 2 1.25 2.165 5 4\n4 2 6.25 2.165 5 4\n"
)
GOOD = FRAME.format(0) + FRAME.format(20000)


def plot(tmp_path, content, *options):
    dump, picture = tmp_path / "a.dump", tmp_path / "a.png"
    if content is not None:
        dump.write_text(content)
    return forked_scripts.run([PLOT, dump, "-o", picture, *options], tmp_path), picture


TIMES = (
    "ITEM: UNITS\nnano\nITEM: TIME\n0\n"
    + FRAME.format(0)
    + "ITEM: TIME\n1.5\n"
    + FRAME.format(20000)
)


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(GOOD, id="whole"),
        pytest.param(GOOD + FRAME.format(40000)[:150], id="cut", marks=LONG),
        pytest.param(TIMES, id="times", marks=LONG),
    ],
)
def test_picture(tmp_path, content):
    done, picture = plot(tmp_path, content)
    assert done.returncode == 0, done.stderr
    assert picture.read_bytes()[:4] == b"\x89PNG"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.dump", "a.png"]


@pytest.mark.parametrize(
    "content, word",
    [
        (None, "cannot be read"),
        ("", "no complete frame"),
        ("nonsense\n", ":1:"),
        (FRAME.format("x"), ":1:"),
        (FRAME.format(0).replace("5 4\n", "five 4\n"), "vx is 'five'"),
        (FRAME.format(0).replace(" vx", " vz"), "vx"),
        (HEAD.format(0), "frame"),
    ],
)
def test_bad_dump(tmp_path, content, word):
    done, picture = plot(tmp_path, content)
    assert done.returncode == 3
    assert done.stderr.count("\n") == 1 and word in done.stderr
    assert not picture.exists()


def test_options(tmp_path):
    assert plot(tmp_path, GOOD, "--frame", "2")[0].returncode == 2
    done, _ = plot(tmp_path, GOOD, "-o", tmp_path / "no" / "a.png")
    assert done.returncode == 5 and done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "show",
    [
        ["stripes", "links"],
        *(pytest.param(s, marks=LONG) for s in (["vx"], ["c_state[1]"], ["links", "type"])),
    ],
)
def test_panels(tmp_path, show):
    done, picture = plot(tmp_path, GOOD, "--no-profile", "--show", *show)
    assert done.returncode == 0, done.stderr
    assert picture.read_bytes()[:4] == b"\x89PNG"


def drawn_of(tmp_path, monkeypatch, content):
    """(x of the discs of the last frame, limits of the axis)."""
    plotter = load("plot_fragment.py")
    (tmp_path / "a.dump").write_text(content)
    words = ["plot_fragment.py", str(tmp_path / "a.dump"), "--show", "type", "--no-profile"]
    monkeypatch.setattr("sys.argv", words)
    given = plotter.arguments()
    picture = plotter.Picture(plotter.plotting.pyplot(), plotter.read(given.dump), given)
    picture.show(-1)
    axes = picture.axes["type"]
    return sorted(axes.collections[0].get_offsets()[:, 0].tolist()), axes.get_xlim()


def test_images_stand_beside_a_periodic_side_only(tmp_path, monkeypatch):
    """Automata at 0, 1.25, 2.5 and 6.25 nm in a box of 5 nm."""
    x, limits = drawn_of(tmp_path, monkeypatch, GOOD)
    assert x == [0, 1.25, 1.25, 2.5, 5] and limits == (0, 5)
    open_box = GOOD.replace("pp ss pp", "ff ss pp")
    x, limits = drawn_of(tmp_path, monkeypatch, open_box)
    assert x == [0, 1.25, 2.5, 6.25] and limits == pytest.approx((-1.25, 7.5), abs=1e-3)


def test_a_triclinic_box_is_refused(tmp_path):
    tilted = GOOD.replace("BOUNDS pp", "BOUNDS xy xz yz pp").replace("0 5\n", "0 5 1\n")
    done, picture = plot(tmp_path, tilted)
    assert done.returncode == 3 and done.stderr.count("\n") == 1
    assert "a triclinic box cannot be drawn" in done.stderr and not picture.exists()


def test_unknown_column(tmp_path):
    done, picture = plot(tmp_path, GOOD, "--show", "plastic")
    assert done.returncode == 3 and "plastic" in done.stderr and ":9:" in done.stderr
    assert not picture.exists()


def test_animation(tmp_path):
    film = tmp_path / "a.gif"
    done, _ = plot(tmp_path, GOOD, "--dpi", "40", "-o", film)
    assert done.returncode == 0, done.stderr
    assert film.read_bytes()[:6] == b"GIF89a"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.dump", "a.gif"]


def test_dump_of_space(tmp_path):
    """Automata above each other, in a dump with the third coordinate or without it."""
    above = GOOD.replace("2 1 2.5 0 0 4", "2 1 0 0 0 4")
    done, picture = plot(tmp_path, above)
    assert done.returncode == 3 and not picture.exists()
    assert done.stderr.count("\n") == 1 and "a.dump:9: two automata" in done.stderr
    deep = GOOD.replace("vx c_state[1]", "vx z").replace("5 4\n", "5 2\n")
    done, picture = plot(tmp_path, deep)
    assert done.returncode == 3 and not picture.exists()
    assert done.stderr.count("\n") == 1 and "z goes from 2 to 4" in done.stderr


def test_frames_of_a_campaign_are_put_in_order_with_the_step_of_run_json(tmp_path):
    """One file a frame, as the shell names them: 100000 before 20000."""
    for step in (0, 20000, 100000):
        (tmp_path / f"run.{step}.dump").write_text(FRAME.format(step))
    attempts = [{"command": "lmp -in in.friction -var p 15 -var dt 2.5e-05 -var every 2000"}]
    (tmp_path / "run.json").write_text(json.dumps({"parameters": {}, "attempts": attempts}))
    dumps = sorted(str(path) for path in tmp_path.glob("*.dump"))
    assert dumps[1].endswith("run.100000.dump")
    film = Film(dumps)
    assert [frame["step"] for frame in film.frames] == [0, 20000, 100000]
    assert film.path_of(2) == dumps[1] and film.columns(2, ["id"])["id"] == [1, 2, 3, 4]
    assert timestep_of(dumps[0]) == 2.5e-5 and timestep_of(str(tmp_path / "no" / "x")) is None
    picture = tmp_path / "a.svg"
    done = subprocess.run(
        [PLOT, *dumps, "-o", picture], text=True, capture_output=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "4 automata after 2.5 ns" in picture.read_text()
