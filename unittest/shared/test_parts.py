# SPDX-License-Identifier: GPL-2.0-or-later
"""Each Python test is in one part, quick or long; without a part all of a file run."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CONFTEST = Path(__file__).resolve().parents[1] / "conftest.py"
TESTS = """import pytest

@pytest.mark.long
def test_a():
    pass

@pytest.mark.parametrize("k", [1, pytest.param(2, marks=pytest.mark.long)])
def test_b(k):
    pass
"""


@pytest.mark.parametrize(
    "words, expected",
    [
        ([], ["test_a", "test_b[1]", "test_b[2]"]),
        (["--part", "quick"], ["test_b[1]"]),
        (["--part", "long"], ["test_a", "test_b[2]"]),
    ],
)
def test_parts(tmp_path, words, expected):
    shutil.copy(CONFTEST, tmp_path)
    (tmp_path / "pytest.ini").write_text("[pytest]\nmarkers = long: run by --all\n")
    (tmp_path / "test_some.py").write_text(TESTS)
    command = [sys.executable, "-m", "pytest", "-v", "-p", "no:cacheprovider", *words]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    ran = [line.split()[0] for line in done.stdout.splitlines() if " PASSED" in line]
    assert [name.removeprefix("test_some.py::") for name in ran] == expected
    assert "deselected" not in done.stdout
