# SPDX-License-Identifier: GPL-2.0-or-later
"""`cmake --install` into a folder that is moved afterwards: all that a user calls works there."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

BUILD = Path(os.environ["BUILD"])
ROOT = Path(__file__).resolve().parents[2]
BUILT_HERE = os.environ["BUILT_HERE"] == "TRUE"  # our own LAMMPS is installed too
OURS = ("MCA", "LAMMPS_", "PYTHONPATH")  # must not lead to the build
CMAKELISTS = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
CLEAN = {name: value for name, value in os.environ.items() if not name.startswith(OURS)}


def run(*words, folder, code=0):
    """Standard output of a call in that folder, without a word of the build in its environment."""
    done = subprocess.run(
        list(map(str, words)),
        cwd=folder,
        env=CLEAN,
        text=True,
        capture_output=True,
        timeout=200,
        check=False,
    )
    assert done.returncode == code, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout


@pytest.fixture(scope="module")
def tree(tmp_path_factory):
    """The installed tree in its second place; the name of the first is in `installed_as`."""
    top = tmp_path_factory.mktemp("install")
    words = (os.environ["CMAKE"], "--install", BUILD, "--prefix", top / "first")
    run("sh", "-c", 'umask 077; exec "$@"', "sh", *words, folder=top)
    (top / "first").rename(top / "second place")
    return top / "second place"


def files(folder):
    return [path for path in folder.rglob("*") if path.is_file() or path.is_symlink()]


def test_what_is_there(tree):
    assert sorted(path.name for path in (tree / "bin").iterdir()) == [
        "lmp-mca",
        "mca-campaign",
        "mca-reproduce",
        "wr_creep",
        "wr_fit",
    ]
    share = tree / "share" / "mca-wheelrail"
    for name in ("README.md", "doc/pair_mca.md", "examples/friction/in.friction", "LICENSE"):
        assert (share / name).read_bytes() == (ROOT / name).read_bytes()
    for path in files(tree):
        assert path.exists(), f"{path}: leads nowhere"
        assert not re.search("gtest|gmock|benchmark|__pycache__|unittest", str(path)), path


def test_everybody_may_read(tree):
    """Whatever the umask of who installs."""
    for path in (tree, *tree.rglob("*")):
        wanted = 0o555 if path.is_dir() or path.parent.name == "bin" else 0o444
        assert path.stat().st_mode & wanted == wanted, path


def test_no_path_of_the_build(tree):
    """In what is read or run; static libraries keep the names of their sources."""
    known = [str(place).encode() for place in (BUILD, ROOT / "src", tree.parent / "first")]
    for path in files(tree):
        if path.suffix != ".a":
            found = [place for place in known if place in path.read_bytes()]
            assert not found, path


def test_versions(tree):
    number = re.search(r"^project\(\S+ VERSION (\S+)", CMAKELISTS, re.MULTILINE)[1]
    texts = set()
    for name in sorted(path.name for path in (tree / "bin").iterdir()):
        words = run(tree / "bin" / name, "--version", folder=tree).split(" of MCA")[0].split()
        assert words[:2] == [name, number]
        texts.add(words[2])
    assert len(texts) == 1 and re.fullmatch(r"\((unknown|[\w.-]*[0-9a-f]{7,}(-dirty)?)\)", *texts)


def test_friction_run(tree, tmp_path):
    script = tree / "share/mca-wheelrail/examples/friction/in.friction"
    out = run(tree / "bin/lmp-mca", "-in", script, "-var", "ns", "0.2", folder=tmp_path)
    assert "Total wall time" in out
    assert (tmp_path / "friction.friction").exists()


def test_wr_creep(tree, tmp_path):
    case = tree / "share/mca-wheelrail/examples/wheelrail/table2.yaml"
    run(tree / "bin/wr_creep", case, "-o", ".", folder=tmp_path)
    run(
        sys.executable,
        tree / "share/mca-wheelrail/tools/plot_creep.py",
        "creep.csv",
        "-o",
        "creep.png",
        folder=tmp_path,
    )
    assert (tmp_path / "creep.png").stat().st_size > 1000


def test_campaign(tree, tmp_path):
    (tmp_path / "plan.csv").write_text("ns,row\n0.1,0.05\n")
    run(tree / "bin/mca-campaign", "run", "plan.csv", "-o", "runs", folder=tmp_path)
    assert len(list((tmp_path / "runs").rglob("run.friction"))) == 1


def test_reproduce(tree, tmp_path):
    """wr_fit is found by the script, and the script by `wr_fit --plot`."""
    out = run(tree / "bin/mca-reproduce", "fig4", "-o", "figures", folder=tmp_path)
    assert out and (tmp_path / "figures/fig4.png").exists()
    logs = tree / "share/mca-wheelrail/examples/campaign/logs/velocity.tar.xz"
    words = (logs, "--model", "constant", "-o", "law.json", "--plot", "fit.png", "-q")
    run(tree / "bin/wr_fit", *words, folder=tmp_path)
    assert (tmp_path / "fit.png").exists()


def test_python(tree, tmp_path):
    """The example: friction as numpy array, beside the log of the same run."""
    share = tree / "share/mca-wheelrail"
    if not BUILT_HERE:
        assert not (tree / "lib/mca-wheelrail/python").exists()
        return
    source = f'source "{share}/env.sh" && exec "$@"'
    code = (
        "import numpy, friction, mcawr.friction_log\n"
        "series, positions = friction.slide(0.48, strength=150, every=1000)\n"
        "assert positions.shape == (560, 3)\n"
        "numpy.save('series.npy', series)\n"
    )
    words = (sys.executable, "-c", f"import sys; sys.path.append(sys.argv[1])\n{code}")
    run("bash", "-c", source, "-", *words, share / "examples/python", folder=tmp_path)
    series = np.load(tmp_path / "series.npy")
    assert series.shape == (120, 3)
    time, tau, mu = series.T
    assert time == pytest.approx(np.arange(1, 121) * 0.004)
    assert mu == pytest.approx(tau / 15)
    rows = np.loadtxt(
        [
            line
            for line in (tmp_path / "python.friction").read_text().splitlines()
            if re.match("[0-9]", line)
        ]
    )
    assert "strength: 150" in (tmp_path / "python.friction").read_text()
    # means over 1000 steps against values of single steps: ten in each
    blocks = tau.reshape(12, 10)
    error = blocks.std(axis=1, ddof=1) / np.sqrt(10)
    assert np.abs(blocks.mean(axis=1) - rows[-12:, 3]).max() < 4 * error.max()


def test_python_module(tree, tmp_path):
    """Found by env.sh."""
    code = (
        "import wheelrail\n"
        "case = wheelrail.Case('table2.yaml', {'creep': 0.01, 'speed': '20 m/s'})\n"
        "print(wheelrail.__file__, case.solve()['traction_ratio'][0] > 0.1)"
    )
    share = tree / "share/mca-wheelrail"
    (tmp_path / "table2.yaml").write_text((share / "examples/wheelrail/table2.yaml").read_text())
    source = f'source "{share}/env.sh" && exec "$@"'
    out = run("bash", "-c", source, "-", "/usr/bin/python3", "-c", code, folder=tmp_path)
    assert out == f"{tree}/lib/python3/dist-packages/wheelrail/__init__.py True\n"


def test_c_consumers(tree, tmp_path):
    """The example of the page by CMake, for C alone, and by pkg-config."""
    for name in ("forces.c", "case.yaml"):
        source = tree / "share/mca-wheelrail/examples/c" / name
        (tmp_path / name).write_text(source.read_text())
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(consumer LANGUAGES C)\n"
        "find_package(wheelrail REQUIRED COMPONENTS c)\nadd_executable(forces forces.c)\n"
        "target_link_libraries(forces wheelrail::c m)\n"
    )
    cmake = os.environ["CMAKE"]
    run(cmake, "-S", ".", "-B", "out", f"-DCMAKE_PREFIX_PATH={tree}", folder=tmp_path)
    run(cmake, "--build", "out", folder=tmp_path)
    shown = run("out/forces", "case.yaml", folder=tmp_path)
    assert len(shown.splitlines()) == 22
    compile_it = (
        "flags=$(pkg-config --cflags --libs wheelrail) && "
        'eval "cc forces.c $flags -lm -o forces" && ./forces case.yaml'
    )
    places = (f"PKG_CONFIG_PATH={tree}/lib/pkgconfig", f"LD_LIBRARY_PATH={tree}/lib")
    assert run("env", *places, "sh", "-c", compile_it, folder=tmp_path) == shown


def test_c_library_shows_its_own_names_only(tree):
    """What it is made of stays inside: another version beside it, or of FFTW's users, is safe."""
    names = run("nm", "-D", "--defined-only", tree / "lib/libwheelrail_c.so", folder=tree)
    assert len(names.split("\n")) > 10
    assert {line.split()[-1].partition("_")[0] for line in names.splitlines()} == {"wheelrail"}


@pytest.mark.long
def test_consumer(tree, tmp_path):
    """A project of its own with find_package(wheelrail)."""
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(consumer LANGUAGES CXX)\n"
        "find_package(wheelrail REQUIRED)\nadd_executable(consumer consumer.cpp)\n"
        "target_link_libraries(consumer wheelrail::wheelrail)\n"
    )
    (tmp_path / "consumer.cpp").write_text(
        '#include "base/quantity.h"\n#include <cstdio>\n'
        'int main() { std::printf("%g", wheelrail::parseQuantity("36 km/h", "m/s")); }\n'
    )
    cmake = os.environ["CMAKE"]
    run(cmake, "-S", ".", "-B", "out", f"-DCMAKE_PREFIX_PATH={tree}", folder=tmp_path)
    run(cmake, "--build", "out", folder=tmp_path)
    assert run(tmp_path / "out/consumer", folder=tmp_path) == "10"
