# SPDX-License-Identifier: GPL-2.0-or-later
"""What doc/python.md and doc/c_interface.md show comes out so: their blocks are run in order, and a
block of text behind one is what it prints. The examples beside them run, too."""

import contextlib
import io
import os
import pathlib
import re
import subprocess

import numpy as np
import pytest
import slip_control

SOURCE = pathlib.Path(os.environ["PROJECT_SOURCE"])
BIN = pathlib.Path(os.environ["WHEELRAIL_BIN"])
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.MULTILINE | re.DOTALL)


def blocks(page, language):
    """[(code, what it prints or None)] of a page."""
    text = (SOURCE / "doc" / page).read_text(encoding="utf-8")
    return [found[1:] for found in BLOCK.findall(text) if found[0] == language]


def printed_by(code, names):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, "doc/python.md", "exec"), names)  # noqa: S102: that is the test
    return out.getvalue()


def test_python_page(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "examples").symlink_to(SOURCE / "examples")
    found = blocks("python.md", "python")
    assert len(found) > 7
    names = {}
    for code, text in found:
        assert printed_by(code, names) == text, code


def test_c_page(tmp_path):
    (code, text), *more = blocks("c_interface.md", "c")
    assert not more
    (tmp_path / "step.c").write_text(code)
    (tmp_path / "case.yaml").write_text((SOURCE / "examples/c/case.yaml").read_text())
    words = ["cc", "-std=c11", "-Wall", "-Wextra", "-Werror", "step.c", "-o", "step"]
    include = f"-I{SOURCE / 'src/WHEELRAIL/c'}"
    lib = BIN.parent / "lib"
    subprocess.run(
        [*words, include, f"-L{lib}", "-lwheelrail_c", f"-Wl,-rpath,{lib}"],
        cwd=tmp_path,
        check=True,
    )
    done = subprocess.run(["./step"], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == text
    (tmp_path / "case.yaml").unlink()
    done = subprocess.run(["./step"], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "case.yaml" in done.stdout and "0.0 N 0.0 N" in done.stdout


def test_c_page_names_every_call():
    header = (SOURCE / "src/WHEELRAIL/c/wheelrail.h").read_text()
    calls = set(re.findall(r"^WHEELRAIL_API .*?(wheelrail_\w+)\(", header, re.MULTILINE))
    page = (SOURCE / "doc/c_interface.md").read_text(encoding="utf-8")
    assert len(calls) == 13
    rows = "".join(re.findall(r"^\| `.*\|$", page, re.MULTILINE))
    assert calls == set(re.findall(r"`(wheelrail_\w+)`", rows))


def assert_alike(printed, page):
    """The page shows these lines; numbers to what a contact in steps is good for."""
    number = r"-?\d+\.?\d*"
    shape = re.escape(re.sub(number, "#", printed)).replace(r"\#", number)
    found = re.search(re.sub(r"(\\ )+", " +", shape), page)
    assert found, f"the page has no such lines:\n{printed}"
    ours, shown = ([float(x) for x in re.findall(number, text)] for text in (printed, found[0]))
    assert ours == pytest.approx(shown, rel=1e-4, abs=0.05)


def test_c_example_shows_what_its_page_shows():
    words = [BIN / "c_example", SOURCE / "examples/c/case.yaml"]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    page = (SOURCE / "examples/c/README.md").read_text(encoding="utf-8")
    assert_alike(done.stdout, page)
    missing = subprocess.run([words[0], "no case.yaml"], capture_output=True, text=True)
    assert missing.returncode == 3 and "no case.yaml" in missing.stderr


def test_slip_control():
    """With the controller the creep ends where it is aimed at, at almost the most that the rail
    carries; without one the wheel spins, on less friction."""
    rows = slip_control.drive(0.6)
    _, speed, creep, torque, force, call = rows.T
    assert -creep[-100:] == pytest.approx(np.full(100, slip_control.TARGET), rel=0.1)
    assert 0.25 * 100e3 < force[-1] < 0.35 * 100e3 and torque[-1] < slip_control.TORQUE
    assert speed[-1] == pytest.approx(5.0 + np.sum(2 * force[:-1]) * 1e-3 / slip_control.MASS)
    spinning = slip_control.drive(0.6, controlled=False)
    assert -spinning[-1, 2] > 0.1 and spinning[-1, 4] < 0.9 * force[-1]
    assert np.median(call) < 0.02  # a loaded machine; the page has what a quiet one takes


def test_slip_control_shows_what_its_page_shows(tmp_path):
    script = SOURCE / "examples/python/slip_control.py"
    words = ["/usr/bin/python3", script, "-o", "picture.png"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert len(done.stdout.splitlines()) == 2
    assert_alike(done.stdout, (SOURCE / "examples/python/README.md").read_text(encoding="utf-8"))
    assert (tmp_path / "picture.png").read_bytes()[1:4] == b"PNG" and "median" in done.stderr


@pytest.mark.parametrize("page", ["python.md", "c_interface.md"])
def test_pages_leave_no_block_out(page):
    """Each block is of a language that a test knows."""
    text = (SOURCE / "doc" / page).read_text(encoding="utf-8")
    assert set(re.findall(r"^```(\w+)$", text, re.MULTILINE)) <= {"python", "c", "sh", "text"}
