# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/dump_to_vtk.py: what ParaView will read, read back by a parser of our own, against the
dumps of a real run."""

import base64
import os
import resource
import subprocess
import zlib
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / "tools" / "dump_to_vtk.py"
LMP = Path(os.environ.get("MCAWR_TEST_LMP", ROOT / "build" / "bin" / "lmp"))
RUN = """
units nano
dimension 2
boundary p s p
atom_style sphere
timestep 5e-5
lattice hex 2.5
region box block 0 20 -0.2 22 -0.5 0.5 units box
create_box 1 box
create_atoms 1 box
pair_style mca preset c
pair_coeff * * steel.mca
neighbor 0.4 bin
mca_links create all all
variable pull atom 70*(y-11)/11
velocity all set 0 v_pull 0
fix integrate all nve/mca
compute state all mca/atom plastic links
compute links all mca/link/local id1 id2 kind sigma
dump atoms all custom 100 a.dump id type x y vy c_state[*]
dump_modify atoms format float %.17g time yes units yes colname c_state[1] plastic
dump links all local 200 links.dump index c_links[*]
dump_modify links format float %.17g time yes label BONDS
dump_modify links colname 2 batom1 colname 3 batom2 colname 4 btype colname 5 sigma
run 400
"""
HEAD = "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp ss pp\n0 5\n0 2.2\n-1 1\n"
ATOMS = HEAD + "ITEM: ATOMS id type x y\n3 1 0 0\n1 1 2.5 0\n2 2 4.9 2\n"
LINKS = HEAD.replace("ATOMS\n3", "ENTRIES\n2") + "ITEM: ENTRIES id1 id2 sigma\n1 2 -5\n2 3 0.25\n"


def convert(tmp_path, *options, preexec=None, **files):
    for name, content in files.items():
        (tmp_path / f"{name}.dump").write_text(content)
    return subprocess.run(
        [TOOL, "a.dump", *options],
        cwd=tmp_path,
        text=True,
        capture_output=True,
        timeout=60,
        preexec_fn=preexec,
        check=False,
    )


def tables(path):
    """Rows of a dump by step: {step: (time, bounds, {column: values})}."""
    found, lines = {}, iter(path.read_text().splitlines())
    for line in lines:
        item = line.removeprefix("ITEM: ")
        if item == "TIME":
            time = float(next(lines))
        elif item == "TIMESTEP":
            step = int(next(lines))
        elif item.startswith("NUMBER"):
            count = int(next(lines))
        elif item.startswith("BOX"):
            box = [[float(w) for w in next(lines).split()] for _ in range(3)]
        elif item.startswith(("ATOMS", "BONDS")):
            rows = np.array([next(lines).split() for _ in range(count)], dtype=float)
            found[step] = time, box, dict(zip(item.split()[1:], rows.T))
    return found


def vtu(path):
    """Points, cells (kind, ends), point and cell arrays of a VTK XML file of compressed blocks."""
    root = ElementTree.parse(path).getroot()
    assert (
        root.get("type") == "UnstructuredGrid" and root.get("compressor") == "vtkZLibDataCompressor"
    )
    piece = root.find("UnstructuredGrid/Piece")

    def array(node):
        text = node.text.strip()
        blocks = np.frombuffer(base64.b64decode(text[:8])[:4], np.uint32)[0]
        head = -(-4 * (3 + int(blocks)) // 3 * 4 // 4) * 4  # base64 of 3 + blocks words, padded
        sizes = np.frombuffer(base64.b64decode(text[:head]), np.uint32)[3:]
        packed, at, data = base64.b64decode(text[head:]), 0, b""
        for size in sizes:
            data += zlib.decompress(packed[at : at + size])
            at += size
        values = np.frombuffer(
            data, {"Float64": float, "Int64": np.int64, "Int32": np.int32}[node.get("type")]
        )
        return values.reshape(
            -1,
            *([int(node.get("NumberOfComponents"))] if "NumberOfComponents" in node.keys() else []),
        )

    def arrays(part):
        return {node.get("Name"): array(node) for node in piece.findall(f"{part}/DataArray")}

    cells = arrays("Cells")
    count = np.diff(cells["offsets"], prepend=0)
    assert len(set(count)) == 1 and len(set(cells["types"])) == 1
    return (
        arrays("Points")["Points"],
        cells["types"][0],
        cells["connectivity"].reshape(-1, count[0]),
        arrays("PointData"),
        arrays("CellData"),
    )


def collection(path):
    return [
        (float(node.get("timestep")), path.parent / node.get("file"))
        for node in ElementTree.parse(path).getroot().findall("Collection/DataSet")
    ]


@pytest.mark.skipif(not LMP.exists(), reason="lmp is not built")
def test_frames_of_a_run(tmp_path):
    (tmp_path / "in").write_text(RUN)
    done = subprocess.run(
        [LMP, "-in", "in", "-log", "none"],
        cwd=tmp_path,
        text=True,
        capture_output=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    # label and names by which OVITO's reader of dump local knows bonds
    assert "ITEM: NUMBER OF BONDS\n" in (tmp_path / "links.dump").read_text()
    assert "ITEM: BONDS index batom1 batom2 btype sigma" in (tmp_path / "links.dump").read_text()
    done = convert(tmp_path, "--links", "links.dump", "-o", "view")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    automata, links = tables(tmp_path / "a.dump"), tables(tmp_path / "links.dump")
    assert [t for t, _ in collection(tmp_path / "view.pvd")] == [0.0, 0.005, 0.01, 0.015, 0.02]
    for (time, path), (step, (expected, _, columns)) in zip(
        collection(tmp_path / "view.pvd"), automata.items()
    ):
        assert time == expected and path.name == f"automata.{step}.vtu"
        points, kind, ends, data, _ = vtu(path)
        assert kind == 1 and (ends[:, 0] == np.arange(len(points))).all()
        assert (points == np.column_stack([columns["x"], columns["y"], 0 * columns["x"]])).all()
        assert set(data) == set(columns) == {"id", "type", "x", "y", "vy", "plastic", "c_state[2]"}
        for name, values in columns.items():
            assert (data[name] == values).all(), name
        assert data["id"].dtype == np.int64
    counts = []
    for (time, path), (step, (expected, box, columns)) in zip(
        collection(tmp_path / "view_links.pvd"), links.items()
    ):
        assert time == expected and path.name == f"links.{step}.vtu"
        points, kind, ends, _, data = vtu(path)
        ids, period = automata[step][2]["id"], box[0][1] - box[0][0]
        assert kind == 3 and set(data) == set(columns)
        drawn = {pair: k for k, pair in enumerate(zip(ids[ends[:, 0]], ids[ends[:, 1]]))}
        place = dict(zip(ids, zip(automata[step][2]["x"], automata[step][2]["y"])))
        for k, pair in enumerate(zip(columns["batom1"], columns["batom2"])):
            across = abs(place[pair[0]][0] - place[pair[1]][0]) > period / 2
            assert (pair in drawn) != across
            if not across:
                assert all(data[name][drawn[pair]] == columns[name][k] for name in columns)
        counts.append((len(columns["batom1"]), len(columns["batom1"]) - len(drawn)))
    assert len(counts) == 3 and all(across > 0 for _, across in counts)
    assert counts[-1][0] < counts[0][0]  # some broke
    assert f"3 frames, {sum(across for _, across in counts)} links" in done.stdout
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "a.dump",
        "in",
        "links.dump",
        "view.pvd",
        "view_frames",
        "view_links.pvd",
    ]


def test_small_frame(tmp_path):
    """The pair 1 2 is near, 2 3 across the periodic side; times from the step; a step that stands
    twice."""
    done = convert(
        tmp_path,
        "--links",
        "l.dump",
        "--timestep",
        "0.5",
        a=ATOMS.format(0) + ATOMS.format(4) * 2,
        l=LINKS.format(4),
    )
    assert done.returncode == 0, done.stderr
    assert [t for t, _ in collection(tmp_path / "a.pvd")] == [0, 2]
    ((time, path),) = collection(tmp_path / "a_links.pvd")
    points, _, ends, _, data = vtu(path)
    assert time == 2 and points.tolist() == [[0, 0, 0], [2.5, 0, 0], [4.9, 2, 0]]
    assert ends.tolist() == [[1, 2]] and data["sigma"] == -5


def test_columns_of_words_are_left_out(tmp_path):
    atoms = ATOMS.replace("x y", "element x y").replace("1 0 0", "1 Fe 0 0")
    atoms = atoms.replace("1 2.5 0", "1 Fe 2.5 0").replace("2 4.9 2", "2 O 4.9 2")
    done = convert(tmp_path, a=atoms.format(0) + atoms.format(4))
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("\n") == 1 and "holds words: element" in done.stderr
    for _, path in collection(tmp_path / "a.pvd"):
        points, _, _, data, _ = vtu(path)
        assert points[2].tolist() == [4.9, 2, 0] and set(data) == {"id", "type", "x", "y"}


def test_frame_without_links(tmp_path):
    done = convert(
        tmp_path,
        "--links",
        "l.dump",
        a=ATOMS.format(0),
        l=LINKS.format(0).replace("ENTRIES\n2", "ENTRIES\n0").split("1 2 -5")[0],
    )
    assert done.returncode == 0, done.stderr
    ((_, path),) = collection(tmp_path / "a_links.pvd")
    piece = ElementTree.parse(path).getroot().find("UnstructuredGrid/Piece")
    assert (piece.get("NumberOfPoints"), piece.get("NumberOfCells")) == ("3", "0")


def test_several_dumps(tmp_path):
    """A file a frame; step 1 stands twice, and the later file counts."""
    moved = ATOMS.format(1).replace("3 1 0 0", "3 1 0.5 0")
    files = {"a": ATOMS.format(0) + ATOMS.format(1), "b": moved, "l": LINKS.format(1)}
    for name, content in files.items():
        (tmp_path / f"{name}.dump").write_text(content)
    done = convert(tmp_path, "b.dump")
    assert done.returncode == 2 and "-o is needed" in done.stderr
    done = convert(tmp_path, "b.dump", "-o", "out", "--links", "l.dump")
    assert done.returncode == 0, done.stderr
    assert "out.pvd: 2 frames; out_links.pvd: 1 frames" in done.stdout + done.stderr
    frames = dict(collection(tmp_path / "out.pvd"))
    assert [vtu(frames[step])[0][0, 0] for step in (0, 1)] == [0, 0.5]


def test_cut_frame_is_left_out(tmp_path):
    done = convert(
        tmp_path,
        "--links",
        "l.dump",
        a=ATOMS.format(0) + ATOMS.format(4)[:120],
        l=LINKS.format(0) + LINKS.format(4),
    )
    assert done.returncode == 0 and done.stderr.count("\n") == 1 and "cut" in done.stderr
    assert len(collection(tmp_path / "a.pvd")) == len(collection(tmp_path / "a_links.pvd")) == 1


@pytest.mark.parametrize(
    "atoms, links, words",
    [
        ("nonsense\n", LINKS, ["a.dump:1:"]),
        (ATOMS.replace(" x y", " u y"), LINKS, ["a.dump:9:", "column x"]),
        (
            ATOMS.replace("ATOMS\n3", "ATOMS\n0").split("3 1 0")[0],
            LINKS,
            ["a.dump:9:", "no automaton"],
        ),
        (ATOMS.replace("\n1 1", "\n3 1"), LINKS, ["a.dump:9:", "ID", "twice"]),
        (ATOMS.replace("2 2 4.9", "2.5 2 4.9"), LINKS, ["a.dump:12:", "id is 2.5"]),
        (ATOMS, LINKS.replace("id2", "x2"), ["l.dump:9:", "--ends", "x2"]),
        (ATOMS, LINKS.replace("2 3 0", "2 9 0"), ["l.dump:11:", " 9 "]),
        (ATOMS, LINKS.replace("{}", "7"), ["l.dump:9:", "step 7"]),
        (ATOMS, LINKS.replace("0.25", "nan"), ["l.dump:11:", "nan"]),
        (ATOMS, LINKS.replace("pp ss pp", "xy xz yz pp ss pp"), ["l.dump", "triclinic"]),
    ],
    ids=[
        "nonsense",
        "no x",
        "empty",
        "ID twice",
        "no integer",
        "no ends",
        "no automaton",
        "no step",
        "nan",
        "triclinic",
    ],
)
def test_bad_dumps(tmp_path, atoms, links, words):
    done = convert(
        tmp_path, "--links", "l.dump", a=atoms.replace("{}", "0"), l=links.replace("{}", "0")
    )
    assert done.returncode == 3 and done.stderr.count("\n") == 1 and done.stdout == ""
    assert all(word in done.stderr for word in words), done.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.dump", "l.dump"]


def test_options(tmp_path):
    assert convert(tmp_path, "--timestep", "-1", a=ATOMS.format(0)).returncode == 2
    done = convert(tmp_path, "-o", "no/a")
    assert done.returncode == 5 and done.stderr.count("\n") == 1 and "no" in done.stderr
    assert convert(tmp_path, "-o", "b").returncode == 0 and (tmp_path / "b.pvd").exists()


def test_frame_that_cannot_be_written(tmp_path):
    """The message names the frame's file, and nothing is left."""

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))

    done = convert(tmp_path, preexec=small_files, a=ATOMS.format(7))
    assert done.returncode == 5 and done.stderr.count("\n") == 1
    assert "a_frames/automata.7.vtu: cannot be written: " in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["a.dump"]


def test_list_of_frames_that_cannot_be_written(tmp_path):
    """No frames without it; those of an earlier call stay."""
    (tmp_path / "a.pvd").mkdir()
    done = convert(tmp_path, a=ATOMS.format(7))
    assert done.returncode == 5 and "a.pvd: cannot be written: " in done.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.dump", "a.pvd"]
    (tmp_path / "a_frames").mkdir()
    (tmp_path / "a_frames" / "automata.1.vtu").touch()
    assert convert(tmp_path).returncode == 5
    assert [path.name for path in (tmp_path / "a_frames").iterdir()] == ["automata.1.vtu"]


def test_frames_of_an_earlier_call_go(tmp_path):
    """All that the earlier call listed; a file that it did not write stays."""
    first = convert(
        tmp_path, "--links", "l.dump", a=ATOMS.format(0) + ATOMS.format(5), l=LINKS.format(5)
    )
    assert first.returncode == 0, first.stderr
    (tmp_path / "a_frames" / "mine.vtu").touch()
    assert (tmp_path / "a_links.pvd").exists()
    assert convert(tmp_path, a=ATOMS.format(5)).returncode == 0
    names = sorted(path.name for path in (tmp_path / "a_frames").iterdir())
    assert names == ["automata.5.vtu", "mine.vtu"]
    assert not (tmp_path / "a_links.pvd").exists()
