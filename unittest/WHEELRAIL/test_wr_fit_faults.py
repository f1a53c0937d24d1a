# SPDX-License-Identifier: GPL-2.0-or-later
"""What happens around wr_fit: outputs that cannot be written, closed streams, text that a terminal
would obey, logs at the ends of their ranges."""

import json
import os
import pathlib
import random
import re
import resource
import subprocess

import pytest

import friction_logs

WR_FIT = pathlib.Path(os.environ["WHEELRAIL_BIN"]) / "wr_fit"


def wr_fit(*arguments, **options):
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    return subprocess.run([WR_FIT, *map(str, arguments)], text=True, timeout=120, **options)


def one_line(done, code, *parts):
    assert done.returncode == code, done.stderr
    assert done.stderr.count("\n") == 1, done.stderr
    for part in parts:
        assert part in done.stderr
    return done


@pytest.fixture
def log(tmp_path):
    path = tmp_path / "run.friction"
    path.write_text(friction_logs.friction_log())
    return path


LONG = pytest.mark.long
OUTPUTS = ("-o", "--runs", "--plot")


@pytest.mark.parametrize("full", ["-o", *(pytest.param(o, marks=LONG) for o in OUTPUTS[1:])])
def test_outputs_appear_together_or_not_at_all(log, tmp_path, full):
    out = tmp_path / "out"
    out.mkdir()
    (out / "old").write_text("old")
    (out / "full").symlink_to("/dev/full")
    names = {"-o": out / "old", "--runs": out / "new.csv", "--plot": out / "fit.png"}
    names[full] = out / "full"
    done = wr_fit(log, *(word for pair in names.items() for word in pair))
    one_line(done, 5, "full: cannot write: No space left on device")
    assert done.stdout == ""
    assert sorted(p.name for p in out.iterdir()) == ["full", "old"]
    assert (out / "old").read_text() == "old"


@pytest.mark.parametrize("limit", [3000, *(pytest.param(n, marks=LONG) for n in (0, 100, 20000))])
def test_a_disk_that_fills_up_leaves_nothing(log, tmp_path, limit):
    """The picture is the largest of the three, and written first."""
    out = tmp_path / "out"
    out.mkdir()
    done = wr_fit(
        *(log, "-o", out / "a.json", "--runs", out / "p.csv", "--plot", out / "fit.png"),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
    )
    assert done.returncode == 5 and "File too large" in done.stderr, done.stderr
    assert [p.name for p in out.iterdir() if p.suffix == ".png" or "part" in p.name] == []


@pytest.mark.parametrize("option", OUTPUTS)
def test_a_name_is_not_empty(log, option):
    one_line(wr_fit(log, option, ""), 2, "'' is not allowed, must be a name")


def test_a_picture_that_cannot_be_made_is_an_error(log, tmp_path):
    (tmp_path / "matplotlib.py").write_text("raise ImportError('none here')\n")
    (tmp_path / "fit.png").write_text("of other logs")
    done = wr_fit(
        *(log, "-o", tmp_path / "fit.json", "--plot", tmp_path / "fit.png"),
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert done.returncode == 5
    assert "fit.png was not made" in done.stderr and "all else was" in done.stderr
    assert (tmp_path / "fit.json").exists() and not (tmp_path / "fit.png").exists()


def test_the_picture_has_the_format_of_its_name(log, tmp_path):
    pytest.importorskip("matplotlib")
    for name, start in (("a.png", b"\x89PNG"), ("a.svg", b"<?xml"), ("a", b"\x89PNG")):
        assert wr_fit(log, "-q", "--plot", tmp_path / name).returncode == 0
        assert (tmp_path / name).read_bytes().startswith(start)
    done = wr_fit(log, "-q", "--plot", tmp_path / "a.nothing")
    one_line(done, 2, f"--plot {tmp_path / 'a.nothing'}: '.nothing' is not a picture", ".png, ")
    assert not (tmp_path / "a.nothing").exists()


@pytest.mark.parametrize("arguments", [(), ("--help",), ("--version",), ("--nonsense",)])
def test_streams_that_cannot_be_written(log, tmp_path, arguments):
    right = wr_fit(log, *arguments).returncode
    for name in ("stderr", "stdout"):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = wr_fit(log, *arguments, **{name: full})
        assert done.returncode == (5 if name == "stdout" and right == 0 else right)
    table = tmp_path / "p.csv"
    for closed in ("2>&-", "1>&-", "0<&- 1>&- 2>&-"):
        table.unlink(missing_ok=True)
        command = [str(WR_FIT), str(log), "--runs", str(table), *arguments]
        done = subprocess.run(
            ["/bin/sh", "-c", f'"$@" {closed}', "sh", *command], capture_output=True, timeout=60
        )
        assert done.returncode == (5 if "1>&-" in closed and right == 0 else right), closed
        if not arguments:
            assert table.read_text().startswith("# t_start") and "wr_fit" not in table.read_text()


def test_what_logs_say_is_shown_not_obeyed(tmp_path):
    """In messages, warnings and the report: names of files, keys and values of the head."""
    evil = "\x1b]0;title\x07\x1b[31m\nwr_fit: all is well\u009b2J"
    quoted = json.dumps(evil)
    good = friction_logs.friction_log()
    bad = {
        "a": good.replace("seed: 1", f"seed: {quoted}"),
        "b": good.replace("seed: 1", f"{quoted}: 1, {quoted}: 2"),
        "c": good.replace("mca-friction 1", quoted),
        "d": good.replace(" 3456 ", " \x1b[31m ", 1),
        "e": good.replace("mu links", "\x1b[31m links"),
    }
    for name, text in bad.items():
        (tmp_path / f"{name}{evil}.friction").write_text(text)
    done = wr_fit(tmp_path)
    assert done.returncode == 3
    assert len(done.stderr.splitlines()) == len(bad)
    assert all(line.startswith("wr_fit: ") for line in done.stderr.splitlines())
    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", done.stderr), done.stderr
    for path in tmp_path.iterdir():
        path.unlink()
    for seed in (1, 2):
        text = friction_logs.friction_log(seed=seed)
        text = text.replace("{preset: B}", f"{{{quoted}: {seed}}}")
        (tmp_path / f"{seed}{evil}.friction").write_text(text + "1 2 3")
    done = wr_fit(tmp_path, "-o", tmp_path / "fit.json")
    assert done.returncode == 0 and "are taken together" in done.stderr
    assert len(done.stderr.splitlines()) == 4  # two cut lines, laws, short sliding
    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", done.stdout + done.stderr)
    rows = [line for line in done.stdout.splitlines() if line.startswith(str(tmp_path))]
    assert len(rows) == 2, done.stdout


def test_names_that_are_no_utf8(tmp_path):
    path = os.fsencode(tmp_path) + b"/K\xf6ln.friction"
    with open(path, "w", encoding="utf-8") as file:
        file.write(friction_logs.friction_log())
    done = wr_fit(tmp_path, "-o", tmp_path / "fit.json")
    assert done.returncode == 0 and "K\\xf6ln.friction" in done.stdout, done.stderr
    assert json.loads((tmp_path / "fit.json").read_text())["report"]["points"]


def test_logs_that_the_drive_may_write(tmp_path):
    """Any seed, a layer driven backwards, no pressure."""
    for name, change in {
        "seed": lambda text: text.replace("seed: 1", "seed: -9000000000000000"),
        "backwards": lambda text: re.sub(
            r"^(\d+ \S+ )(\S+) (\S+) (\S+) (\S+)",
            lambda m: f"{m[1]}-{m[2]} -{m[3]} {m[4]} -{m[5]}",
            text.replace("velocity: 5", "velocity: -5"),
            flags=re.MULTILINE,
        ),
        "unpressed": lambda text: re.sub(
            r"^(\d+ \S+ \S+ )\S+ \S+ \S+",
            lambda m: f"{m[1]}0.01 0 0",
            text.replace("pressure: 15.0", "pressure: 0"),
            flags=re.MULTILINE,
        ),
    }.items():
        (tmp_path / f"{name}.friction").write_text(change(friction_logs.friction_log(noise=0.01)))
        done = wr_fit(tmp_path / f"{name}.friction", "-o", tmp_path / "fit.json")
        assert done.returncode == 0 and len(done.stderr.splitlines()) == 1, done.stderr
        assert "warning: 1 of 1 run" in done.stderr
        run = json.loads((tmp_path / "fit.json").read_text())["report"]["points"][0]
        assert run["seed"] == (-9000000000000000 if name == "seed" else 1)
        if name == "unpressed":
            assert run["kappa2"] == 0 and run["mu"] == 0 and run["left_out"]
        else:
            assert run["mu"] == pytest.approx(friction_logs.eq2(4.745983, 365.0756), rel=0.05)
            assert not run["left_out"]


def test_logs_at_the_ends_of_their_ranges(tmp_path):
    """Whatever the ranges allow is fitted, or said not to be: no internal error, no nan."""
    generator = random.Random(3)
    ends = [1e-12, 1e-6, 1.0, 1e6, 1e12]
    for number in range(12):
        folder = tmp_path / str(number)
        folder.mkdir()
        for seed in range(1, 9):
            text = friction_logs.friction_log(ns=4, seed=seed)
            for key in ("youngs_modulus", "density", "strength", "pressure", "velocity"):
                text = re.sub(rf"{key}: [^,}}]+", f"{key}: {generator.choice(ends)!r}", text)
            pressure = float(re.search(r"pressure: ([^,}]+)", text)[1])
            rows = [line.split() for line in text.splitlines() if line[0].isdigit()]
            head = text[: text.index("\n", text.index("step time")) + 1]
            factor = generator.choice([1e-9, 1.0, 1e9])
            for row in rows:
                row[5] = f"{factor * float(row[5]):.8g}"
                row[3] = f"{min(1e12, float(row[5]) * pressure):.8g}"
                row[5] = f"{float(row[3]) / pressure:.8g}"
            (folder / f"{seed}.friction").write_text(
                head + "".join(" ".join(row) + "\n" for row in rows)
            )
        for model in ("eq2", "eq4", "constant", "eq2_kappa3"):
            options = ("--include-drifting", "--kappa2-min", "0", "--model", model)
            done = wr_fit(folder, *options, "-o", folder / "fit.json")
            assert done.returncode in (0, 3, 4), done.stderr
            assert "internal" not in done.stderr and "nan" not in done.stderr, done.stderr
            assert not re.search(r"\bnan\b", done.stdout), done.stdout
