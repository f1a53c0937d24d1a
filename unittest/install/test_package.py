# SPDX-License-Identifier: GPL-2.0-or-later
"""The Debian package, unpacked into a folder, and the source archive."""

import os
import re
import subprocess
import tarfile
from pathlib import Path

import pytest

BUILD = Path(os.environ["BUILD"])
CPACK = Path(os.environ["CMAKE"]).with_name("cpack")
OURS = ("MCA", "LAMMPS_", "PYTHONPATH")
CLEAN = {name: value for name, value in os.environ.items() if not name.startswith(OURS)}


def run(*words, folder):
    done = subprocess.run(
        list(map(str, words)),
        cwd=folder,
        env=CLEAN,
        text=True,
        capture_output=True,
        timeout=200,
        check=False,
    )
    assert done.returncode == 0 and "Warning" not in done.stderr, (
        done.stdout[-2000:] + done.stderr[-2000:]
    )
    return done.stdout


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    folder = tmp_path_factory.mktemp("deb")
    words = (CPACK, "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    run("sh", "-c", 'umask 077; exec "$@"', "sh", *words, folder=folder)
    (found,) = folder.glob("mca-wheelrail_*.deb")
    return found


@pytest.mark.long
def test_package_runs(package, tmp_path):
    run("dpkg", "-x", package, tmp_path / "root", folder=tmp_path)
    usr = tmp_path / "root" / "usr"
    for path in (tmp_path / "root").rglob("*"):  # everybody may read, whoever made the package
        wanted = 0o555 if path.is_dir() else 0o444
        assert path.stat().st_mode & wanted == wanted, path
    assert [path.name for path in (tmp_path / "root").iterdir()] == ["usr"]
    assert (usr / "share/doc/mca-wheelrail/copyright").exists()
    assert not (usr / "bin" / "lmp").exists()  # that is Debian's lammps
    script = usr / "share/mca-wheelrail/examples/friction/in.friction"
    run(usr / "bin/lmp-mca", "-in", script, "-var", "ns", "0.05", folder=tmp_path)
    case = usr / "share/mca-wheelrail/examples/wheelrail/table2.yaml"
    run(usr / "bin/wr_creep", case, "-o", ".", folder=tmp_path)
    code = (
        f"import sys; sys.path = ['{usr}/lib/python3/dist-packages', *sys.path]; import wheelrail"
    )
    code += f"; wheelrail.Case('{case}')"
    run("/usr/bin/python3", "-c", code, folder=tmp_path)
    assert (tmp_path / "friction.friction").exists() and (tmp_path / "creep.csv").exists()


@pytest.mark.long
def test_dependencies(package, tmp_path):
    """What the programs load, and what the scripts import."""
    words = re.findall(r"[a-z][a-z0-9.+-]+", run("dpkg-deb", "-f", package, "Depends", folder="/"))
    for name in (
        "libc6",
        "libcholmod3",
        "libopenmpi3",
        "libfftw3-double3",
        "libarchive13",
        "libudunits2-0",
    ):
        assert name in words
    for name in ("python3-numpy", "python3-matplotlib", "python3-yaml", "openmpi-bin"):
        assert name in words
    assert not [word for word in words if word.startswith(("lammps", "liblammps", "libgtest"))]


def test_source_archive(tmp_path):
    config = BUILD / "CPackSourceConfig.cmake"
    run(CPACK, "--config", config, "-B", tmp_path, folder=tmp_path)
    (archive,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(archive) as file:
        names = {name.partition("/")[2] for name in file.getnames()}
        (top,) = {name.partition("/")[0] for name in file.getnames()}
        commit = file.extractfile(f"{top}/COMMIT").read().decode().strip()
    assert f"({commit})" in run(BUILD / "bin/wr_fit", "--version", folder=tmp_path)
    root = Path(__file__).resolve().parents[2]
    words = ["git", "-C", str(root), "ls-files"]
    listed = subprocess.run(words, text=True, capture_output=True, check=False)
    # all that git tracks, where there is a git
    tracked = set(listed.stdout.split("\n")) - {""}
    tracked = {name for name in tracked if not name.startswith(".git")}
    assert {"CMakeLists.txt", "tools/setup.sh", "unittest/install/test_package.py"} <= names
    assert tracked <= names
    assert not [name for name in names if name.startswith(("build", ".git/")) or "pycache" in name]
