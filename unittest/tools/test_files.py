# SPDX-License-Identifier: GPL-2.0-or-later
"""The one way to write a file, and how a script ends: in the package and by every script."""

import json
import os
import resource
import stat
import subprocess
import threading
import time
from pathlib import Path

import pytest

import forked_scripts
from friction_logs import friction_log
from mcawr import archive, errors, files
from mcawr import friction_log as friction_logs
from script_calls import with_checksum
from test_dump_to_vtk import ATOMS
from test_plot_creep import GOOD as CREEP
from test_plot_fragment import GOOD as DUMP
from test_plot_layer import HEAD, frame

TOOLS = Path(__file__).resolve().parents[2] / "tools"
PNG = b"\x89PNG"
POINT = {
    "mu": 0.4, "mu_se": 0.01, "mu_grinding_in": 0.5, "mu_peak": 1.0, "mu_eq2": 0.41,
    "pressure": 15, "velocity": 5, "strength": 92, "viscosity": 0.41, "t_start": 5,
    "kappa1": 4.7, "kappa2": 365, "kappa3": 2239, "left_out": False,
}  # fmt: skip
RATE = {"min": 5, "median": 6, "max": 7}
CASE = {"row": "default laws", "style": "mca", "ranks": 1, "automata": 1600, "rate": RATE}
BENCH = {"format": "mca-benchmark 2", "cases": [{**CASE, "other": False}]}
POINTS = [POINT, {**POINT, "kappa2": 100, "pressure": 4}]
CONDITIONS = [{**point, "runs": [k]} for k, point in enumerate(POINTS)]
FIT = with_checksum({"report": {"points": POINTS, "conditions": CONDITIONS}})
INPUTS = {
    "a.csv": CREEP,
    "fit.json": FIT,
    "bench.json": json.dumps(BENCH),
    "a.friction": friction_log(),
    "a.dump": DUMP,
    "a.profile": HEAD + frame(1000, 3, 6) + frame(2000, 2, 7),
    "atoms.dump": ATOMS.format(0),
}
# every script that writes a file that the user names
WRITERS = {
    "plot_creep.py": ["a.csv", "-o"],
    "plot_fit.py": ["fit.json", "-o"],
    "plot_series.py": ["fit.json", "--against", "pressure", "-o"],
    "plot_benchmark.py": ["bench.json", "-o"],
    "plot_friction.py": ["a.friction", "-o"],
    "plot_fragment.py": ["a.dump", "--dpi", "40", "-o"],
    "plot_layer.py": ["a.profile", "-o"],
}
LONG = pytest.mark.long
# all of them write by the same function: one at once, the others with the long tests
SOME_WRITERS = [pytest.param(s, marks=[LONG] if k else []) for k, s in enumerate(WRITERS)]


@pytest.fixture(scope="module", autouse=True)
def fonts():
    """matplotlib's list of fonts is made now, not by a script that may write little."""
    import matplotlib.font_manager  # noqa: F401


@pytest.fixture
def work(tmp_path):
    for name, text in INPUTS.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def run(work, script, *words, **more):
    command = [TOOLS / script, *map(str, words)]
    if not more:
        return forked_scripts.run(command, work)
    return subprocess.run(
        command, cwd=work, text=True, capture_output=True, timeout=120, check=False, **more
    )


def failed(done, script, *words):
    """Exit code 5 and one line that says what."""
    assert done.returncode == 5, done.stderr
    assert done.stderr.count("\n") == 1 and done.stderr.startswith(f"{script}: "), done.stderr
    for word in words:
        assert word in done.stderr, done.stderr


def names(work):
    return sorted(path.name for path in work.iterdir())


def small_files():
    """As a disk that is full after 2000 bytes."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))


@pytest.fixture
def node(tmp_path):
    """A device of our own: as /dev/full, on which every write fails."""
    path = tmp_path / "full"
    try:
        os.mknod(path, 0o666 | stat.S_IFCHR, os.makedev(1, 7))
        with open(path, "wb"):
            pass
    except PermissionError:
        return Path("/dev/full")  # which a user cannot replace
    return path


# ---- write()


def test_new_file_and_old_file(tmp_path):
    path = tmp_path / "a"
    files.write(path, "first\n")
    assert path.read_text() == "first\n"
    mask = os.umask(0)
    os.umask(mask)
    assert stat.S_IMODE(path.stat().st_mode) == 0o666 & ~mask
    path.chmod(0o640)
    files.write(path, b"second\n")
    assert path.read_text() == "second\n" and stat.S_IMODE(path.stat().st_mode) == 0o640
    assert names(tmp_path) == ["a"]


def test_links_stay_links(tmp_path):
    folder = tmp_path / "far"
    folder.mkdir()
    (folder / "old").write_text("old")
    for target in ("old", "new"):  # of the second there is no file yet
        link = tmp_path / f"link to {target}"
        link.symlink_to(folder / target)
        files.write(link, "text")
        assert link.is_symlink() and (folder / target).read_text() == "text"
    assert names(folder) == ["new", "old"]


def test_several_files_or_none(tmp_path, node):
    """Also into a device, which takes its own before a file is replaced."""
    (tmp_path / "a").write_text("old")
    for last in (node, tmp_path / "no" / "b", tmp_path):
        with pytest.raises(errors.Failure, match="cannot be written"):
            files.write_all({tmp_path / "a": "new", tmp_path / "b": "new", last: "new"})
        assert (tmp_path / "a").read_text() == "old" and not (tmp_path / "b").exists()
    done = tmp_path / "done"
    done.write_text("c")
    files.write_all({tmp_path / "a": "new", str(tmp_path / "b"): b"bytes", tmp_path / "c": done})
    assert [(tmp_path / name).read_text() for name in "abc"] == ["new", "bytes", "c"]
    assert [name for name in names(tmp_path) if name != "full"] == ["a", "b", "c"]


def test_links_in_a_circle(tmp_path):
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    with pytest.raises(errors.Failure, match="cannot be written") as failure:
        files.write(tmp_path / "a", "text")
    assert failure.value.code == 5


def test_pipe_is_written_into(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    got = []
    reader = threading.Thread(target=lambda: got.append(pipe.read_bytes()))
    reader.start()
    content = b"x" * 300000  # more than a pipe holds
    files.write(pipe, content)
    reader.join(30)
    assert got == [content] and pipe.is_fifo()


def test_device_is_written_into(tmp_path, node):
    with pytest.raises(errors.Failure, match="No space left on device"):
        files.write(node, "text")
    assert node.is_char_device()


def test_folder_and_no_folder(tmp_path):
    for path in (tmp_path, tmp_path / "no" / "a"):
        with pytest.raises(errors.Failure, match="cannot be written") as failure:
            files.write(path, "text")
        assert failure.value.code == 5
    assert names(tmp_path) == []


def test_interrupt_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "a"
    path.write_text("old")

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        files.write(path, "new")
    assert path.read_text() == "old" and names(tmp_path) == ["a"]


# ---- files in archives


@pytest.fixture
def packed(work):
    names = ("a.friction", "a.profile")
    (work / "a.tar.xz").write_bytes(archive.pack({name: INPUTS[name] for name in names}))
    return work


def test_a_file_in_an_archive_is_read(packed, monkeypatch):
    """The archive is unpacked once."""
    unpack, calls = archive.unpack, []
    monkeypatch.setattr(archive, "unpack", lambda *words: calls.append(words) or unpack(*words))
    for name in ("a.friction", "a.profile"):
        path = packed / "a.tar.xz" / name
        assert files.is_there(path) and files.read_text(path) == INPUTS[name]
    assert not files.is_there(packed / "a.tar.xz" / "b.friction")
    assert files.is_there(packed / "a.tar.xz") and not files.is_there(packed / "b")
    for name in ("b.friction", "..", "a.friction/a"):
        with pytest.raises(errors.BadInput, match="cannot be read") as refused:
            files.read_bytes(f"{packed}/a.tar.xz/{name}")
        assert refused.value.code == 3
    assert len(calls) == 1
    with pytest.raises(errors.BadInput, match=r"no\.tar\.xz: cannot be read: No such file"):
        files.read_bytes(f"{packed}/no.tar.xz/a.friction")
    (packed / "folder.tar.xz").mkdir()
    (packed / "folder.tar.xz" / "a").write_text("text")
    assert files.read_text(packed / "folder.tar.xz" / "a") == "text"


def test_scripts_draw_what_is_in_an_archive(packed):
    for script, name in (("plot_friction.py", "a.friction"), ("plot_layer.py", "a.profile")):
        pictures = [packed / "loose.png", packed / "packed.png"]
        for path, picture in zip((name, f"a.tar.xz/{name}"), pictures):
            done = run(packed, script, path, "-o", picture)
            assert done.returncode == 0, done.stderr
        assert pictures[0].read_bytes() == pictures[1].read_bytes()
        done = run(packed, script, f"a.tar.xz/{name}", "-o", "a.tar.xz")
        assert done.returncode == 2 and "a.tar.xz: cannot be written: is read too" in done.stderr
        done = run(packed, script, f"a.tar.xz/no.{name}")
        assert done.returncode == 3 and done.stderr.count("\n") == 1
        assert "no such file in the archive" in done.stderr


# ---- the scripts


@pytest.mark.parametrize("script", SOME_WRITERS)
def test_full_device(script, work, node):
    done = run(work, script, *WRITERS[script], node)
    failed(done, script, str(node), "No space left on device")
    assert node.is_char_device() and node.stat().st_rdev == os.makedev(1, 7)


@pytest.mark.parametrize("script", SOME_WRITERS)
def test_full_disk(script, work):
    (work / "a.png").write_text("of yesterday")
    before = names(work)
    done = run(work, script, *WRITERS[script], "a.png", preexec_fn=small_files)
    failed(done, script, "a.png", "File too large")
    assert names(work) == before and (work / "a.png").read_text() == "of yesterday"


@pytest.mark.parametrize("script", SOME_WRITERS)
def test_link_and_pipe(script, work):
    os.mkfifo(work / "pipe")
    (work / "link.png").symlink_to(work / "picture.png")
    done = run(work, script, *WRITERS[script], "link.png")
    assert done.returncode == 0, done.stderr
    assert (work / "link.png").is_symlink()
    assert (work / "picture.png").read_bytes()[:4] == PNG
    got = []
    reader = threading.Thread(target=lambda: got.append((work / "pipe").read_bytes()))
    reader.start()
    done = run(work, script, *WRITERS[script], "pipe")
    reader.join(30)
    assert done.returncode == 0 and (work / "pipe").is_fifo() and got[0][:4] == PNG


def test_format_by_the_name(work):
    for ending, begin in (("pdf", b"%PDF"), ("svg", b"<?xml"), ("PNG", PNG)):
        done = run(work, "plot_friction.py", "a.friction", "-o", f"a.{ending}")
        assert done.returncode == 0, done.stderr
        assert (work / f"a.{ending}").read_bytes().startswith(begin)
    done = run(work, "plot_friction.py", "a.friction", "-o", "a.doc")
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and ".doc" in done.stderr


@LONG
def test_animation_on_a_full_disk(work):
    before = names(work)
    done = run(
        work, "plot_fragment.py", "a.dump", "--dpi", "60", "-o", "a.gif", preexec_fn=small_files
    )
    failed(done, "plot_fragment.py", "a.gif", "File too large")
    assert names(work) == before


def test_table_of_layers(work, node):
    failed(run(work, "plot_layer.py", "a.profile", "--csv", node), "plot_layer.py", str(node))
    pipe = {"stdin": subprocess.DEVNULL}  # a process of its own, whose output is a pipe
    done = run(work, "plot_layer.py", "a.profile", "--csv", "/dev/stdout", **pipe)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("step,centre,depth")


def test_table_and_picture_together(work):
    """Both or none."""
    before = names(work)
    words = ["a.profile", "--csv", "a.csv.new", "-o", "no/a.png"]
    failed(run(work, "plot_layer.py", *words), "plot_layer.py", "no/a.png")
    assert names(work) == before


@pytest.mark.parametrize("script", SOME_WRITERS)
def test_what_is_read_is_not_written_over(script, work):
    (given, *more) = WRITERS[script]
    (work / "link.png").symlink_to(given)
    for output in (given, f"./{given}", "link.png"):
        done = run(work, script, given, *more, output)
        assert done.returncode == 2 and "is read too" in done.stderr, done.stderr
        assert done.stderr.count("\n") == 1 and (work / given).read_text() == INPUTS[given]
    if script == "plot_layer.py":
        done = run(work, script, given, "--csv", "b", "-o", "b")
        assert done.returncode == 2 and "another result" in done.stderr


@pytest.mark.parametrize("script", SOME_WRITERS)
def test_folders_are_no_files(script, work):
    (work / "folder.png").mkdir()
    for output in ("folder.png", "new.png/", "no/a.png", "a" * 300):
        failed(run(work, script, *WRITERS[script], output), script, output)
    assert list((work / "folder.png").iterdir()) == []


def test_vtk(work, node):
    before = names(work)
    done = run(work, "dump_to_vtk.py", "atoms.dump", "-o", "a", preexec_fn=lambda: small(500))
    failed(done, "dump_to_vtk.py", "File too large")
    assert names(work) == before
    (work / "b.pvd").symlink_to("c.pvd")
    assert run(work, "dump_to_vtk.py", "atoms.dump", "-o", "b").returncode == 0
    assert (work / "b.pvd").is_symlink() and "<VTKFile" in (work / "c.pvd").read_text()
    (work / "d.pvd").symlink_to(node)
    failed(run(work, "dump_to_vtk.py", "atoms.dump", "-o", "d"), "dump_to_vtk.py", "d.pvd")
    assert node.is_char_device()


def small(size):
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


# ---- standard output

SPEAKERS = [
    ("campaign", ["list"]),
    pytest.param("campaign", ["list", "pressure"], marks=LONG),
    pytest.param("plot_layer.py", ["a.profile"], marks=LONG),
    pytest.param("dump_to_vtk.py", ["atoms.dump", "-o", "a"], marks=LONG),
]


@pytest.mark.parametrize("script, words", SPEAKERS)
def test_output_that_nobody_takes(script, words, work):
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [TOOLS / script, *words],
            cwd=work, stdout=full, stderr=subprocess.PIPE, text=True, timeout=120, check=False,
        )  # fmt: skip
    failed(done, script, "standard output", "No space left on device")
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "w") as closed:
        done = subprocess.run(
            [TOOLS / script, *words],
            cwd=work, stdout=closed, stderr=subprocess.PIPE, text=True, timeout=120, check=False,
        )  # fmt: skip
    failed(done, script, "standard output", "Broken pipe")


@pytest.mark.parametrize("script, words", SPEAKERS)
def test_closed_outputs(script, words, work):
    """As the shell's >&- and 2>&- leave them."""
    command = " ".join(str(word) for word in [TOOLS / script, *words])
    shell = dict(shell=True, cwd=work, text=True, timeout=120, check=False)
    done = subprocess.run(command + " >&-", stderr=subprocess.PIPE, **shell)
    failed(done, script, "standard output: cannot be written")
    done = subprocess.run(command + " >&- 2>&-", **shell)
    assert done.returncode == 5
    done = subprocess.run(command + " 2>&-", stdout=subprocess.PIPE, **shell)
    assert done.returncode == 0 and done.stdout


def test_terminated(work):
    """In order: nothing is left."""
    os.mkfifo(work / "pipe")  # nobody reads: the script waits
    before = names(work)
    command = [TOOLS / "plot_friction.py", "a.friction", "-o", "pipe"]
    process = subprocess.Popen(command, cwd=work, stderr=subprocess.PIPE, text=True)
    time.sleep(3)
    process.terminate()
    _, said = process.communicate(timeout=20)
    assert process.returncode == 6 and said == "plot_friction.py: interrupted\n"
    assert names(work) == before


def test_errors_that_nothing_takes(monkeypatch, capsys):
    """One line that says where; the whole of it on demand."""

    def main():
        raise ZeroDivisionError("by nothing")

    with pytest.raises(SystemExit) as end:
        errors.run_script(main)
    said = capsys.readouterr().err
    assert end.value.code == 1 and said.count("\n") == 1
    assert "internal error" in said and "ZeroDivisionError: by nothing" in said
    monkeypatch.setenv("MCAWR_TRACEBACK", "1")
    with pytest.raises(ZeroDivisionError):
        errors.run_script(main)


@pytest.mark.parametrize("script, words", SPEAKERS)
def test_nobody_takes_anything(script, words, work):
    """Neither standard output nor the line that says so."""
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [TOOLS / script, *words], cwd=work, stdout=full, stderr=full, timeout=120, check=False
        )
    assert done.returncode == 5


def test_one_line():
    assert errors.one_line(" a\nb\x1b[31mc\t") == "a\\nb\\x1b[31mc"
    assert errors.one_line("µ = 0,4 – größer") == "µ = 0,4 – größer"


def test_long_texts_of_files_are_cut_in_messages():
    text = f"a.vti: 'Float{'[' * 5000}64' is no type: Float32, Float64"
    message = str(errors.BadInput(text))
    assert len(message) < 1000 and message.startswith("a.vti: 'Float[")
    assert message.endswith("Float32, Float64")
    assert str(errors.BadInput(text[:900])) == text[:900]


@pytest.mark.parametrize("code", ["utf-8", "utf-8-sig", "utf-16"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_what_other_machines_save_is_read_with_its_check(tmp_path, code, end):
    head, rows = friction_log(ns=2).split("gap\n")
    lines = [*head.splitlines(), f"{head.splitlines().pop()}gap check"]
    lines.pop(-2)
    checks = friction_logs.Checks(lines)
    text = "\n".join([*lines, *map(checks.of, rows.splitlines()), ""])
    path = tmp_path / "a.friction"
    path.write_bytes(text.replace("\n", end).encode(code))
    assert files.read_text(path) == text
    assert len(friction_logs.read(str(path)).columns["mu"]) == 40


def test_what_is_no_text_is_named(tmp_path):
    path = tmp_path / "a.friction"
    for content, told in (
        (b"# \xb5m\n", "byte 3 is not UTF-8"),
        (b"\xff\xfe#", "is not UTF-16"),
        ("p,v\n1,2\n".encode("utf-16-le"), "is UTF-16 without a byte order mark"),
        ("p,v\n1,2\n".encode("utf-16-be"), "is UTF-16 without a byte order mark"),
        ("p,v\n1,2\n".encode("utf-32"), "is UTF-32"),
        (b"p,v\n1,2\n\0", "is binary, not text: character 9 is 0"),
    ):
        path.write_bytes(content)
        with pytest.raises(errors.BadInput, match=told):
            files.read_text(path)
