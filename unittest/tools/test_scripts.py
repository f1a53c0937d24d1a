# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/*.sh: help, usage errors and the cache of LAMMPS, none of which builds anything."""

import os
import subprocess
from pathlib import Path

import pytest

TOOLS = Path(__file__).resolve().parents[2] / "tools"
SCRIPTS = [
    "get_lammps.sh",
    "build_docs.sh",
    "setup.sh",
    "quickstart.sh",
    "check.sh",
    "benchmark.py",
    "plot_fragment.py",
    "plot_creep.py",
    "dump_to_vtk.py",
]


def run(script, *arguments, cwd=None, **environment):
    env = {**os.environ, **{k: str(v) for k, v in environment.items()}}
    env = {k: v for k, v in env.items() if v != "None"}
    return subprocess.run(
        [TOOLS / script, *map(str, arguments)],
        cwd=cwd,
        env=env,
        text=True,
        capture_output=True,
        timeout=60,
        check=False,
    )


def one_line(done, code, *words):
    """Failed with that code and one line on stderr that holds the words."""
    assert done.returncode == code
    assert done.stderr.count("\n") == 1
    for word in words:
        assert word in done.stderr
    assert done.stdout == ""


@pytest.mark.parametrize("script", SCRIPTS)
def test_help(script, tmp_path):
    done = run(script, "--help", cwd=tmp_path)
    assert done.returncode == 0
    assert script in done.stdout and done.stderr == ""
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("script", ["get_lammps.sh", "setup.sh", "quickstart.sh"])
def test_unknown_option(script):
    one_line(run(script, "--nonsense"), 2, "--nonsense", "--help")


@pytest.mark.parametrize(
    "option, value",
    [("--version", "20240101"), ("--jobs", "0"), ("--jobs", "two"), ("--packages", "a;b")],
)
def test_get_lammps_refuses_values(option, value):
    one_line(run("get_lammps.sh", option, value), 2, option, value)


@pytest.mark.parametrize(
    "option, value",
    [
        ("--ns", "0"),
        ("--ns", "nan"),
        ("--ns", "-1"),
        ("--np", "1.5"),
        ("--np", "0"),
        ("--seed", "x"),
    ],
)
def test_quickstart_refuses_values(option, value):
    one_line(run("quickstart.sh", option, value), 2, option, value)


def test_option_without_value():
    one_line(run("get_lammps.sh", "--version"), 2, "--version")
    one_line(run("quickstart.sh", "--ns"), 2, "--ns")


def test_cache_folder(tmp_path):
    """The folder depends on version and options, and an empty one is not complete."""
    first = run("get_lammps.sh", "--print", MCAWR_CACHE=tmp_path / "a b")
    other = run("get_lammps.sh", "--print", "--packages", "PLUGIN", MCAWR_CACHE=tmp_path / "a b")
    newer = run("get_lammps.sh", "--print", "--version", "20260704", MCAWR_CACHE=tmp_path / "a b")
    assert first.returncode == other.returncode == newer.returncode == 1
    assert len({first.stdout, other.stdout, newer.stdout}) == 3
    assert first.stdout.startswith(str(tmp_path / "a b" / "lammps-20250204-"))
    # half made: stamp without lmp
    Path(first.stdout.strip()).mkdir(parents=True)
    (Path(first.stdout.strip()) / "complete").touch()
    assert run("get_lammps.sh", "--print", MCAWR_CACHE=tmp_path / "a b").returncode == 1


def test_why_lammps_is_built_again(tmp_path):
    """Another mpicxx first in PATH, as conda puts one there."""
    first = Path(run("get_lammps.sh", "--print", MCAWR_CACHE=tmp_path).stdout.strip())
    first.mkdir()
    mpi = subprocess.run(["mpicxx", "-show"], text=True, capture_output=True, check=True).stdout
    (first / "options").write_text(f"mpi={mpi}")
    (first / "complete").touch()
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "mpicxx").write_text("#!/bin/sh\necho conda-c++\n")
    (tmp_path / "bin" / "mpicxx").chmod(0o755)
    path = f"{tmp_path / 'bin'}:{os.environ['PATH']}"
    done = run("get_lammps.sh", "--print", MCAWR_CACHE=tmp_path, PATH=path)
    assert done.returncode == 1 and done.stdout.strip() != str(first)
    for words in (
        str(first),
        f"mpi '{mpi.strip()}', now 'conda-c++'",
        str(tmp_path / "bin/mpicxx"),
    ):
        assert words in done.stderr, done.stderr


def test_cache_places(tmp_path):
    done = run("get_lammps.sh", "--print", MCAWR_CACHE=None, XDG_CACHE_HOME=tmp_path)
    assert done.stdout.startswith(str(tmp_path / "mca-wheelrail"))
    done = run("get_lammps.sh", "--print", MCAWR_CACHE=None, XDG_CACHE_HOME=None, HOME=tmp_path)
    assert done.stdout.startswith(str(tmp_path / ".cache" / "mca-wheelrail"))
    done = run("get_lammps.sh", "--print", MCAWR_CACHE=None, XDG_CACHE_HOME=None, HOME=None)
    one_line(done, 5, "MCAWR_CACHE")


def test_cache_that_cannot_be_made(tmp_path):
    (tmp_path / "file").touch()
    done = run("get_lammps.sh", "--source-only", MCAWR_CACHE=tmp_path / "file" / "cache")
    one_line(done, 5, "cache folder", str(tmp_path))


def test_other_tarball_is_refused(tmp_path):
    wrong = tmp_path / "lammps.tar.xz"
    wrong.write_bytes(b"not LAMMPS")
    done = run("get_lammps.sh", "--source-only", "--tarball", wrong, MCAWR_CACHE=tmp_path / "cache")
    assert done.returncode == 5
    assert "SHA-256" in done.stderr.splitlines()[-1]
    assert done.stdout == ""
    assert not list((tmp_path / "cache").glob("lammps-*-source"))
    missing = run(
        "get_lammps.sh", "--source-only", "--tarball", tmp_path / "no", MCAWR_CACHE=tmp_path
    )
    one_line(missing, 5, "--tarball", str(tmp_path / "no"))


def test_benchmark_without_lmp(tmp_path):
    one_line(run("benchmark.py", "--build", tmp_path), 5, "lmp", str(tmp_path))
