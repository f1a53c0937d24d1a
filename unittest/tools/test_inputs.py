# SPDX-License-Identifier: GPL-2.0-or-later
"""What the scripts read: whatever stands there, one line that names it, exit code 3, no file
written."""

import json
import os
import re
import stat
from unittest.mock import ANY

import pytest

from mcawr import files
from test_dump_to_vtk import ATOMS, LINKS
from test_files import BENCH, FIT, INPUTS
from test_plot_patch import FILES

AGAINST = ("--against", "pressure")
READERS = {  # script: its words, {} for the file; the file that it takes
    "plot_creep.py": (["{}", "-o", "out.png"], INPUTS["a.csv"]),
    "plot_fit.py": (["{}", "-o", "out.png"], FIT),
    "plot_series.py": (["{}", "--against", "velocity", "-o", "out.png"], FIT),
    "plot_benchmark.py": (["{}", "-o", "out.png"], json.dumps(BENCH)),
    "plot_friction.py": (["{}", "-o", "out.png"], INPUTS["a.friction"]),
    "plot_fragment.py": (["{}", "-o", "out.png", "--dpi", "30"], INPUTS["a.dump"]),
    "plot_layer.py": (["{}", "-o", "out.png"], INPUTS["a.profile"]),
    "plot_patch.py fields": (["{}", "-o", "out.png"], FILES["a.vti"]),
    "plot_patch.py curves": (["{}", "-o", "out.png"], FILES["creep.csv"]),
    "plot_patch.py transient": (["{}", "-o", "out.png"], FILES["series.csv"]),
    "dump_to_vtk.py": (["{}", "-o", "out"], ATOMS.format(0)),
    "dump_to_vtk.py --links": (["{}", "good.dump", "-o", "out"], LINKS.format(0)),
    "campaign list": (["{}"], "format: mca-campaign 1\nruns: [{p: 1}]\n"),
}


def content_of(reader):
    content = READERS[reader][1]
    return content if isinstance(content, bytes) else content.encode()


@pytest.fixture
def read(call, tmp_path, monkeypatch):
    """read(reader, path, code): the line with which it refuses the file."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "good.dump").write_text(ATOMS.format(0))

    def refuse(reader, path):
        before = sorted(p.name for p in tmp_path.iterdir())
        words = [str(path) if word == "{}" else word for word in READERS[reader][0]]
        line = call.refused(3, *reader.split(), *words)
        assert "internal" not in line, line
        assert sorted(p.name for p in tmp_path.iterdir()) == before
        return line

    return refuse


def some(readers):
    """All of them, of which the first three are quick tests."""
    return [
        reader if k < 3 else pytest.param(reader, marks=pytest.mark.long)
        for k, reader in enumerate(readers)
    ]


def test_good_files_are_taken(call, tmp_path, monkeypatch):
    """What is made worse below."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "good.dump").write_text(ATOMS.format(0))
    for reader, (words, _) in READERS.items():
        (tmp_path / "file").write_bytes(content_of(reader))
        words = ["file" if word == "{}" else word for word in words]
        code, _, err = call(*reader.split(), *words)
        assert code == 0, f"{reader}: {err}"


@pytest.mark.parametrize("reader", READERS)
def test_no_regular_file(reader, read, tmp_path):
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "circle").symlink_to("circle")
    for name in ("missing", "folder", "pipe", "circle", "good.dump/file", "a" * 300):
        line = read(reader, name)
        assert name in line
    assert stat.S_ISCHR(os.stat("/dev/zero").st_mode)
    if reader != "campaign list":
        assert "not a regular file" in read(reader, "/dev/zero")


@pytest.mark.parametrize("reader", READERS)
def test_no_such_content(reader, read, tmp_path):
    path = tmp_path / "file"
    deep = b'{"report":' * 5000 if "fit" in reader or "series" in reader else b"[" * 100000
    for content in (b"", b"\n", b"\0" * 1000, b"\xff\xfe\0a", b"a,b\n1,2\n", b"{}", deep, b"\r\n"):
        path.write_bytes(content)
        assert "file" in read(reader, path)


@pytest.mark.parametrize("reader", some(READERS))
def test_cut_files(reader, call, tmp_path, monkeypatch):
    """Cut anywhere: taken for what is whole of it, or refused in one line."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "good.dump").write_text(ATOMS.format(0))
    whole = content_of(reader)
    words = ["file" if word == "{}" else word for word in READERS[reader][0]]
    for k in range(12):
        (tmp_path / "file").write_bytes(whole[: len(whole) * k // 12])
        code, _, err = call(*reader.split(), *words)
        assert code in (0, 3) and err.count("\n") <= 1, f"{k}: {code}: {err}"
        assert "internal" not in err, err


@pytest.mark.parametrize("reader", some(r for r in READERS if "fields" not in r))
@pytest.mark.parametrize("number", ["nan", "1e308", "0x10", "1_0", ""])
def test_numbers(reader, number, call, tmp_path, monkeypatch):
    """Every number of the file in turn; where it counts for nothing it may be anything."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(files, "picture", lambda *_, **__: b"drawn elsewhere")
    (tmp_path / "good.dump").write_text(ATOMS.format(0))
    words = ["file" if word == "{}" else word for word in READERS[reader][0]]
    lines = content_of(reader).decode().split("\n")
    refused = 0
    for at, line in list(enumerate(lines))[:11]:
        separator = "," if "," in line else " "
        cells = line.split(separator)
        for k in range(len(cells) if any(c.isdigit() for c in line) else 0):
            changed = separator.join([*cells[:k], number, *cells[k + 1 :]])
            (tmp_path / "file").write_text("\n".join([*lines[:at], changed, *lines[at + 1 :]]))
            code, _, err = call(*reader.split(), *words)
            assert code in (0, 3) and "internal" not in err, f"{changed}: {code}: {err}"
            assert err.count("\n") <= 1, f"{changed}: {err}"
            refused += code == 3
    assert refused


@pytest.mark.parametrize("script, words", [("plot_fit.py", ()), ("plot_series.py", AGAINST)])
def test_checksum_of_a_fit(call, tmp_path, monkeypatch, script, words):
    """A changed number is found; without the line it counts, with a note."""
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "law.json"
    text = FIT
    path.write_text(text)
    assert call(script, path, *words, "-o", "a.png") == (0, ANY, "")
    line = re.search(r'  "checksum": .*\n', text)[0]
    for bad in (
        text.replace('"mu": 0.4,', '"mu": 0.5,', 1),
        text + " ",
        text.replace(line, '  "checksum": null,\n'),
    ):
        path.write_text(bad)
        code, _, err = call(script, path, *words, "-o", "b.png")
        assert code == 3 and err.count("\n") == 1 and not (tmp_path / "b.png").exists()
        assert "does not fit: the file was changed since wr_fit wrote it" in err
        assert "remove this line" in err
    path.write_text(text.replace('"mu": 0.4,', '"mu": 0.5,', 1).replace(line, ""))
    code, _, err = call(script, path, *words, "-o", "b.png")
    assert code == 0 and err.count("\n") == 1 and "law.json: no checksum" in err
