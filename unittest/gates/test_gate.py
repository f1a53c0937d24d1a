# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/gate over a small project of its own: what is wrong is found, mended, and remembered.

No part of ctest, since it needs the gates' tools: `python3 -m pytest unittest/gates`."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SPDX = "SPDX-License-Identifier: GPL-2.0-or-later"
HEADER = f"// {SPDX}\nint twice(int value);\n"
SOURCE = f'// {SPDX}\n#include "a.h"\n\nint twice(int value)\n{{\n  return 2 * value;\n}}\n'
SCRIPT = f'#!/bin/bash\n# {SPDX}\necho "$1"\n'
PYTHON = f'# {SPDX}\n"""Nothing."""\n\nimport os\nimport sys\n\nprint(os.name, sys.argv)\n'
TYPED = f"# {SPDX}\n\nVALUE: int = 1 + 1\n"
CONFIGURATION = (".clang-tidy", ".clang-format", ".flake8", "pyproject.toml")


@pytest.fixture
def project(tmp_path):
    for name in ("tools/mcawr", "tools/gate_parts"):
        shutil.copytree(ROOT / name, tmp_path / name)
    for name in ("tools/gate", *CONFIGURATION):
        shutil.copy(ROOT / name, tmp_path / name)
    (tmp_path / "tools" / "typed.py").write_text(TYPED)
    (tmp_path / "src").mkdir()
    (tmp_path / "build").mkdir()
    (tmp_path / "CMakeLists.txt").write_text(f"# {SPDX}\n")
    for name, text in (("a.h", HEADER), ("a.cpp", SOURCE), ("a.sh", SCRIPT), ("a.py", PYTHON)):
        (tmp_path / "src" / name).write_text(text)
    entry = {"directory": str(tmp_path / "build"), "file": str(tmp_path / "src" / "a.cpp")}
    entry["command"] = f"c++ -std=c++17 -c {entry['file']}"
    (tmp_path / "build" / "compile_commands.json").write_text(json.dumps([entry]))
    git(tmp_path, "init", "-q", "-b", "main")
    commit(tmp_path, "Begin")  # what is on main is not looked at
    git(tmp_path, "switch", "-q", "-c", "branch")
    return tmp_path


def git(project, *words):
    identity = ("-c", "user.name=a", "-c", "user.email=a@b")
    command = ["git", "-C", project, *identity, *words]
    return subprocess.run(command, check=True, text=True, capture_output=True).stdout


def commit(project, message):
    git(project, "commit", "-q", "--allow-empty", "-m", message)


def gate(project, *words, **environment):
    return subprocess.run(
        [project / "tools" / "gate", *words],
        cwd=project,
        env={
            **os.environ,
            "PYTHONDONTWRITEBYTECODE": "1",
            "MCAWR_BUILD": str(project / "build"),  # not the one that these tests are of
            **environment,
        },
        text=True,
        capture_output=True,
        timeout=120,
        check=False,
    )


def test_clean(project):
    done = gate(project)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count(": 0 findings\n") == 8


@pytest.mark.parametrize(
    "name, file, old, new, finding, mended",
    [
        ("clang-format", "a.cpp", "return 2", "return  2", "src/a.cpp:6:9: format", True),
        ("black", "a.py", "os.name", "os . name", "src/a.py:7:1: format", True),
        ("flake8", "a.py", "sys.argv", "sys.argv, x", "src/a.py:7:26: F821", False),
        ("flake8", "a.py", "Nothing", "No " * 60 + "no", "src/a.py:2:101: E501", False),
        ("mypy", "../tools/typed.py", "1 + 1", '1 + ""', "tools/typed.py:3:18: error", False),
        ("shellcheck", "a.sh", '"$1"', "$1", "src/a.sh:3:6: note", False),
        ("spdx", "a.sh", SPDX, "GPL", "src/a.sh:2:1: spdx", True),
        ("spdx", "a.h", f"// {SPDX}\n", "", "src/a.h:1:1: spdx", True),
        ("clang-tidy", "a.cpp", "twice(int value)", "Twice(int value)", "a.cpp:4:5: inv", False),
    ],
)
def test_finding(project, name, file, old, new, finding, mended):
    path = project / "src" / file
    good = path.read_text()
    assert old in good
    path.write_text(good.replace(old, new))
    done = gate(project, name)
    assert done.returncode == 1 and finding in done.stdout, done.stdout + done.stderr
    assert done.stdout.endswith(f"{name}: 1 findings\n")
    assert gate(project, name, "--", "CMakeLists.txt").returncode == 0  # another file
    again = gate(project, name, "--fix")
    assert again.returncode == (0 if mended else 1)
    assert (gate(project, name).returncode == 0) == mended


@pytest.mark.parametrize(
    "message, finding",
    [
        ("Short\n\nWhy it is so.", ""),
        ("L" * 72 + "\n\nWhy.", ""),
        ("L" * 73 + "\n\nWhy.", "subject: 73 columns, at most 72"),
        ("Short", "body: there is none"),
        ("Short\nat once why", "the line after the subject must be empty"),
    ],
)
def test_commits(project, message, finding):
    before = git(project, "rev-parse", "HEAD").strip()
    commit(project, message)
    commit(project, "After it\n\nIs good.")
    done = gate(project, "commits")
    assert done.returncode == bool(finding) and finding in done.stdout
    number = git(project, "rev-parse", "--short", "HEAD~").strip()
    assert done.stdout.count(f"commit {number}: ") == bool(finding)
    assert gate(project, "commits", "--base", before).returncode == bool(finding)
    assert gate(project, "commits", "--base", "HEAD~").returncode == 0  # it is older
    git(project, "branch", "-f", "main", "branch")
    assert gate(project, "commits").returncode == 0  # nothing of it is to come
    git(project, "update-ref", "refs/remotes/origin/main", before)  # upstream comes first
    assert gate(project, "commits").returncode == bool(finding)


def test_nothing_to_compare_with(project):
    git(project, "branch", "-D", "main")
    done = gate(project, "commits")
    assert done.returncode == 2 and "--base" in done.stderr and done.stderr.count("\n") == 1
    done = gate(project, "commits", "--base", "nonsense")
    assert done.returncode == 2 and "nonsense" in done.stderr


def test_tidy_remembers(project):
    """A clean file is looked at again after a change of it, of a header, its command or list."""
    known = project / "build" / "gates" / "clang-tidy.json"
    assert gate(project, "clang-tidy").returncode == 0
    keys = [json.loads(known.read_text())["src/a.cpp"]]
    path = shutil.which("clang-tidy-14")
    assert path
    header, commands = project / "src" / "a.h", project / "build" / "compile_commands.json"
    for file, old, new in (
        (header, "int twice", "// a comment\nint twice"),
        (commands, "-std=c++17", "-std=c++17 -DA=1"),
        (project / ".clang-tidy", "WarningsAsErrors", "# a comment\nWarningsAsErrors"),
        (project / "src" / "a.cpp", "2 * value", "value * 2"),
    ):
        unchanged = known.stat().st_mtime_ns
        assert gate(project, "clang-tidy").returncode == 0
        assert known.stat().st_mtime_ns == unchanged  # nothing was looked at
        text = file.read_text()
        assert old in text
        file.write_text(text.replace(old, new))
        assert gate(project, "clang-tidy").returncode == 0
        keys.append(json.loads(known.read_text())["src/a.cpp"])
    assert len(set(keys)) == 5
    header.write_text(HEADER.replace("twice(int value)", "twice(int Value)"))
    assert "src/a.h:2:15" in gate(project, "clang-tidy").stdout
    assert "src/a.h:2:15" in gate(project, "clang-tidy").stdout  # a finding is not forgotten


def test_tidy_of_sources_that_are_compiled_as_one(project):
    folder = project / "build" / "Unity"
    folder.mkdir()
    commands = project / "build" / "compile_commands.json"
    entry = json.loads(commands.read_text())[0]
    one = folder / "unity_0_cxx.cxx"
    one.write_text(f'#include "{entry["file"]}"\n')
    entry["command"] = entry["command"].replace(entry["file"], str(one))
    commands.write_text(json.dumps([{**entry, "file": str(one)}]))
    header = project / "src" / "a.h"
    header.write_text(HEADER.replace("twice(int value)", "twice(int Value)"))
    assert "src/a.h:2:15" in gate(project, "clang-tidy").stdout
    header.write_text(HEADER)
    assert gate(project, "clang-tidy").returncode == 0
    assert "src/a.cpp" in (project / "build" / "gates" / "clang-tidy.json").read_text()


def test_usage(project):
    done = gate(project, "nonsense")
    assert done.returncode == 2 and "clang-tidy" in done.stderr
    done = gate(project, "black", "--", "no.py")
    assert done.returncode == 2 and done.stderr == "gate: no.py: no such file\n"
    (project / "build" / "compile_commands.json").unlink()
    done = gate(project, "clang-tidy")
    assert done.returncode == 5 and done.stderr.count("\n") == 1


def test_tool_is_missing(project):
    """No quiet pass without the tool."""
    (project / "bin").mkdir()
    (project / "bin" / "python3").symlink_to("/usr/bin/python3")
    for name in ("clang-format", "clang-tidy", "shellcheck", "black", "flake8", "mypy"):
        done = gate(project, name, PATH=str(project / "bin"))
        assert done.returncode == 1 and f"apt-get install {name}" in done.stderr
