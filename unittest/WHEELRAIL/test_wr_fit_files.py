# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_fit: one clear line for every bad log and option; files whole or not at all."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile

import pytest

from wr_fit_run import PNG, WR_FIT, one_line, wr_fit


@pytest.mark.parametrize(
    "change, parts",
    [
        (lambda text: "", ["empty"]),
        (
            lambda text: text.replace("mca-friction 1", "mca-friction 9"),
            [":1: format: 'mca-friction 9'"],
        ),
        (lambda text: text.replace("time: ns", "time: ps"), [":3: units: time: 'ps'", "'ns'"]),
        (lambda text: text[:500], ["the head is not YAML"]),
        (
            lambda text: text.replace("strength: 92", "strength: -92"),
            [":4: material: strength: '-92.0'", "> 0 (MPa)"],
        ),
        (
            lambda text: text.replace("density: 7800", "density: 1e200"),
            [":4: material: density: '1e200.0'"],
        ),
        (lambda text: text.replace("seed: 1", "seed: 1.5"), [":8: run: seed: '1.5'", "whole"]),
        (
            lambda text: text.replace("{pressure", "{pressure: 20, pressure"),
            [":5: pressure: appears twice"],
        ),
        (
            lambda text: re.sub(r" \S+ 3456 ", " 1e308 3456 ", text),
            [":10: mu: '1e308' is not allowed"],
        ),
        (
            lambda text: text.replace("pressure: 15", "presure: 15"),
            ["'presure' is unknown", "'pressure'"],
        ),
        (
            lambda text: text.replace(" 3456 ", " nan ", 1),
            [":10: links: 'nan' is not a finite number"],
        ),
        (lambda text: text.replace(" 3456 ", " many ", 1), [":10: links: 'many'"]),
    ],
    ids=[
        "empty",
        "version",
        "units",
        "truncated",
        "negative",
        "enormous",
        "seed",
        "twice",
        "huge mu",
        "keyword",
        "nan",
        "text",
    ],
)
def test_bad_log_is_one_clear_line(log, tmp_path, change, parts):
    log.write_text(change(log.read_text()))
    out = tmp_path / "out"
    out.mkdir()
    one_line(wr_fit(log, "-o", out / "law.json", "--runs", out / "p.csv"), 3, str(log), *parts)
    assert list(out.iterdir()) == []


def test_all_bad_logs_are_named(tmp_path):
    for name in "ab":
        (tmp_path / f"{name}.friction").write_text("nonsense\n")
    result = wr_fit(tmp_path)
    assert result.returncode == 3
    assert "a.friction" in result.stderr and "b.friction" in result.stderr


def test_missing_log_and_usage(tmp_path):
    one_line(wr_fit(tmp_path / "no.friction"), 3, "no such file or folder")
    one_line(wr_fit(tmp_path), 3, "holds no *.friction file")
    one_line(wr_fit(), 2, "LOG")
    one_line(wr_fit("x", "--modle", "eq2"), 2, "--modle", "--model")
    one_line(wr_fit("x", "--model", "eq3"), 2, "eq3", "eq2")
    assert wr_fit("--help").returncode == 0 and "Examples:" in wr_fit("--help").stdout


@pytest.mark.parametrize(
    "option, value, allowed",
    [
        ("--level", "95", "from 0.5 to 0.9999"),
        ("--level", "nan", "from 0.5 to 0.9999"),
        ("--kappa2-min", "nan", ">= 0"),
        ("--kappa2-min", "inf", ">= 0"),
        ("--kappa3", "nan", "> 0"),
        ("--kappa3", "0", "> 0"),
        ("--start", "nan", ">= 0 (ns)"),
        ("--start", "inf", ">= 0 (ns)"),
        ("--start", "-5", ">= 0 (ns)"),
        ("--start", "abc", ">= 0 (ns)"),
        ("--start", "", ">= 0 (ns)"),
        ("--start-distance", "-5", ">= 0 (nm)"),
        ("--grinding-in", "nan", "> 0 (ns)"),
        ("--grinding-in", "0", "> 0 (ns)"),
    ],
)
def test_bad_option_is_one_clear_line(log, option, value, allowed):
    one_line(
        wr_fit(log, option, value),
        2,
        f"{option}: '{value}' is not allowed, must be a number {allowed}; see",
    )


@pytest.mark.parametrize("option", ["-o", "--runs", "--plot"])
def test_unwritable_output(log, tmp_path, option):
    """Nothing else is written then, and nothing printed."""
    blocked = tmp_path / "blocked"
    blocked.write_text("a file, not a folder")
    for target in (tmp_path / "folder" / "x", blocked / "x", tmp_path):
        result = one_line(
            wr_fit(log, option, target, "--runs" if option == "-o" else "-o", tmp_path / "other"),
            5,
            str(target),
        )
        assert result.stdout == ""
    assert sorted(p.name for p in tmp_path.iterdir()) == ["blocked", "run.friction"]


@pytest.mark.parametrize("option", ["-o", "--runs", "--plot"])
def test_outputs_do_not_overwrite_logs_or_each_other(log, tmp_path, option):
    content = log.read_bytes()
    (tmp_path / "link").symlink_to(log)
    for name in (log, tmp_path / "." / "run.friction", tmp_path / "link"):
        one_line(
            wr_fit(log, option, name), 2, f"{option}: {name} is an input, it would be overwritten"
        )
        one_line(wr_fit(tmp_path, option, name), 2, option)
    other = "--runs" if option == "-o" else "-o"
    one_line(wr_fit(log, option, "x", other, "./x", cwd=tmp_path), 2, "is also the file of")
    assert log.read_bytes() == content and sorted(p.name for p in tmp_path.iterdir()) == [
        "link",
        "run.friction",
    ]


@pytest.mark.parametrize("option, start", [("-o", b"{"), ("--runs", b"# t_start"), ("--plot", PNG)])
def test_a_pipe_is_written_into(log, tmp_path, option, start):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE) as reader:
        assert wr_fit(log, "-q", option, pipe).returncode == 0
        assert reader.communicate(timeout=60)[0].startswith(start)
    assert pipe.is_fifo()


def test_a_lost_report_is_an_error(log):
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = subprocess.run([WR_FIT, log], stdout=full, stderr=subprocess.PIPE, text=True)
    one_line(result, 5, "standard output: cannot write: No space left on device")


def test_what_is_no_log_is_refused(log, tmp_path):
    """A pipe would be waited for, a link to itself leads nowhere; neither is passed over in a
    folder."""
    os.mkfifo(tmp_path / "p.friction")
    one_line(wr_fit(tmp_path / "p.friction"), 3, "p.friction: is not a regular file")
    one_line(wr_fit(tmp_path), 3, "p.friction: is not a regular file")
    (tmp_path / "p.friction").unlink()
    (tmp_path / "l.friction").symlink_to("l.friction")
    one_line(wr_fit(tmp_path), 3, "l.friction: is a link that leads to no file")


def test_unreadable_folder_is_named(log):
    """As another user where the tests run as root, whom nothing is unreadable to; of a copy, since
    such a user may not reach the build."""
    with tempfile.TemporaryDirectory() as top:
        closed = pathlib.Path(top) / "runs" / "closed"
        closed.mkdir(parents=True)
        os.chmod(top, 0o755)
        closed.chmod(0)
        copy = shutil.copy(WR_FIT, top)
        more = {"user": 65534} if os.geteuid() == 0 else {}
        result = wr_fit(pathlib.Path(top) / "runs", program=copy, **more)
        closed.chmod(0o755)
    one_line(result, 3, f"{closed}: cannot be searched: Permission denied")


def test_cut_last_line_is_said(log):
    log.write_text(log.read_text() + "401000 20.05 10")
    result = wr_fit(log)
    assert result.returncode == 0
    assert "the last line was cut" in result.stderr
