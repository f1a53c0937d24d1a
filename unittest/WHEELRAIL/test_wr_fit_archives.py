# SPDX-License-Identifier: GPL-2.0-or-later
"""wr_fit on archives (*.tar.xz): the same as on their files, one clear line for every fault. The
scripts' reader obeys the same rules."""

import csv
import io
import lzma
import os
import tarfile

import pytest

import friction_logs
from mcawr import archive
from mcawr.errors import BadInput
from wr_fit_run import one_line, wr_fit

SPEEDS = {"v10": 10.0, "v2": 2.0, "v5": 5.0}  # in order of names
LOG = friction_logs.friction_log()


def rows_of(folder, *logs):
    """The rows of these logs in the table of runs."""
    done = wr_fit(*logs, "--runs", "runs.csv", "-q", cwd=folder)
    assert done.returncode == 0, done.stderr
    return list(csv.DictReader((folder / "runs.csv").read_text().splitlines()[1:]))


@pytest.fixture
def packed(tmp_path):
    """A folder of logs, and an archive of the same."""
    texts = {
        f"{name}.friction": friction_logs.friction_log(v=v, seed=k)
        for k, (name, v) in enumerate(SPEEDS.items())
    }
    (tmp_path / "plan").mkdir()
    for name, text in texts.items():
        (tmp_path / "plan" / name).write_text(text)
    more = {"v2.profile": "no log\n", "v2.friction.part": "no log\n"}
    (tmp_path / "plan.tar.xz").write_bytes(archive.pack({**texts, **more}))
    return tmp_path


def test_an_archive_is_what_its_files_are(packed):
    loose, ours = rows_of(packed, "plan"), rows_of(packed, "plan.tar.xz")
    assert [row.pop("file") for row in loose] == [f"plan/{name}.friction" for name in SPEEDS]
    assert [row.pop("file") for row in ours] == [f"plan.tar.xz/{name}.friction" for name in SPEEDS]
    assert ours == loose


def test_a_file_of_an_archive_is_a_log(packed):
    (packed / "link.tar.xz").symlink_to("plan.tar.xz")
    first, second = "plan.tar.xz/v5.friction", "plan.tar.xz/v2.friction"
    assert [row["file"] for row in rows_of(packed, first, second)] == [first, second]
    for same in ("plan.tar.xz", "./plan.tar.xz", "link.tar.xz"):  # each log counts once
        files = [row["file"] for row in rows_of(packed, first, same, second)]
        assert files == [first, f"{same}/v10.friction", f"{same}/v2.friction"]
    for wrong, said in (
        ("v1.friction", "no such file in the archive"),
        ("v2.profile", "is no *.friction"),
        (".", "is no *.friction"),
        ("", "is no *.friction"),
    ):
        done = wr_fit(f"plan.tar.xz/{wrong}", cwd=packed)
        one_line(done, 3, f"plan.tar.xz/{wrong}: {said}")
    one_line(wr_fit("plan.tar.xz/a/v2.friction", cwd=packed), 3, "no such file or folder")
    one_line(wr_fit("no.tar.xz/v2.friction", cwd=packed), 3, "no.tar.xz: no such file or folder")


def test_what_is_wrong_with_a_log_names_it(packed):
    texts = {"a.friction": LOG.replace("strength: 92.0", "strength: x"), "b.friction": ""}
    (packed / "bad.tar.xz").write_bytes(archive.pack(texts))
    done = wr_fit("bad.tar.xz", cwd=packed)
    assert done.returncode == 3 and done.stderr.splitlines() == [
        "wr_fit: bad.tar.xz/a.friction:4: material: strength: 'x' is not allowed, must be a number "
        "> 0 (MPa), 1e-12 to 1e+12",
        "wr_fit: bad.tar.xz/b.friction: is empty",
    ]


def test_folders_with_the_ending_and_archives_in_folders(packed):
    (packed / "plan").rename(packed / "folder.tar.xz")
    assert len(rows_of(packed, "folder.tar.xz")) == 3
    assert len(rows_of(packed, "folder.tar.xz/v2.friction")) == 1
    (packed / "only").mkdir()
    (packed / "plan.tar.xz").rename(packed / "only" / "plan.tar.xz")
    said = "this folder holds no *.friction file (archives, *.tar.xz, have to be named themselves)"
    one_line(wr_fit("only", cwd=packed), 3, said)


def test_an_archive_is_not_written_over(packed):
    before = (packed / "plan.tar.xz").read_bytes()
    for log in ("plan.tar.xz", "plan.tar.xz/v2.friction"):
        for option in ("-o", "--runs"):
            done = wr_fit(log, option, "plan.tar.xz", cwd=packed)
            one_line(done, 2, "plan.tar.xz is an input, it would be overwritten")
    assert (packed / "plan.tar.xz").read_bytes() == before


# ---- archives of others


def tar(*members, **more):
    """Bytes of a tar file: names of logs, or TarInfos, which have no content."""
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w", **more) as file:
        for member in members:
            head = tarfile.TarInfo(member) if isinstance(member, str) else member
            if isinstance(member, str):
                head.size = len(LOG)
            file.addfile(head, io.BytesIO(LOG.encode()) if isinstance(member, str) else None)
    return stream.getvalue()


def special(kind, **more):
    head = tarfile.TarInfo("a.friction")
    head.type = kind
    for name, value in more.items():
        setattr(head, name, value)
    return head


def pax(size):
    """A sparse file of that size, of which nothing is stored."""
    records = {"GNU.sparse.major": "1", "GNU.sparse.minor": "0", "GNU.sparse.name": "a.friction",
               "GNU.sparse.realsize": str(size)}  # fmt: skip
    head = tarfile.TarInfo("a.friction")
    head.size, head.pax_headers = 512, records
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w", format=tarfile.PAX_FORMAT) as file:
        file.addfile(head, io.BytesIO(b"0\n".ljust(512, b"\0")))
    return stream.getvalue()


GOOD = tar("a.friction", "b.friction")
PLAIN = "is not allowed, must be a file with a plain name"
DAMAGED = "is damaged or cut"
WRONG = {
    "empty": (b"", "bad.tar.xz: "),
    "text": (LOG.encode(), "is not compressed by xz"),
    "not compressed": (GOOD, "is not compressed by xz"),
    "lzma": (lzma.compress(GOOD, format=lzma.FORMAT_ALONE), "is not compressed by xz"),
    "xz of nothing": (lzma.compress(b""), "cannot be unpacked: is "),
    "xz of text": (lzma.compress(LOG.encode()), "its end is missing"),
    "xz of zeros": (lzma.compress(bytes(4096) + b"x" + bytes(4096)), ""),
    "end cut": (lzma.compress(GOOD)[:-1], DAMAGED),
    "half cut": (lzma.compress(GOOD)[: len(lzma.compress(GOOD)) // 2], DAMAGED),
    "start only": (lzma.compress(GOOD)[:12], DAMAGED),
    "tar cut": (lzma.compress(GOOD[: len(LOG) // 2]), "its end is missing"),
    "tar cut between files": (lzma.compress(GOOD[: 512 + -(-len(LOG) // 512) * 512]), "its end"),
    "head damaged": (lzma.compress(b"A" + GOOD[1:]), DAMAGED),
    "joined": (lzma.compress(GOOD) + lzma.compress(tar("b.friction")), DAMAGED),
    "joined inside": (lzma.compress(GOOD + tar("b.friction")), DAMAGED),
    "no member": (lzma.compress(tar()), "this archive holds no *.friction file"),
    "no log": (lzma.compress(tar("a.profile")), "this archive holds no *.friction file"),
    "twice": (lzma.compress(tar("a.friction", "a.friction")), "member 'a.friction' is there twice"),
    "folder": (lzma.compress(tar(special(tarfile.DIRTYPE))), PLAIN),
    "link": (lzma.compress(tar(special(tarfile.SYMTYPE, linkname="/etc/passwd"))), PLAIN),
    "hard link": (
        lzma.compress(tar("b.friction", special(tarfile.LNKTYPE, linkname="b.friction"))),
        PLAIN,
    ),
    "device": (lzma.compress(tar(special(tarfile.CHRTYPE))), PLAIN),
    "pipe": (lzma.compress(tar(special(tarfile.FIFOTYPE))), PLAIN),
    "sparse": (lzma.compress(pax(2**40)), "a.friction' is"),
    "large": (lzma.compress(tar(special(tarfile.REGTYPE, size=2**60), format=tarfile.GNU_FORMAT)),
              ""),
    "bomb": (lzma.compress(bytes(257 * 2**20), preset=0), "holds more than 256 MiB"),
    **{
        f"name {name}": (lzma.compress(tar(name)), f"member '{name}' {PLAIN}")
        for name in ("/etc/a.friction", "../a.friction", "a/b.friction", "./a.friction", "..")
    },
}  # fmt: skip


@pytest.mark.parametrize("content, said", WRONG.values(), ids=WRONG)
def test_no_good_archive_is_one_clear_line(content, said, tmp_path):
    """For wr_fit; for the scripts where a log is to be read from it."""
    path = tmp_path / "bad.tar.xz"
    path.write_bytes(content)
    one_line(wr_fit("bad.tar.xz", "-o", "a.json", cwd=tmp_path), 3, "wr_fit: bad.tar.xz: ", said)
    assert [entry.name for entry in tmp_path.iterdir()] == ["bad.tar.xz"]
    if "holds no" in said:
        return
    with pytest.raises(BadInput, match=r"^bad\.tar\.xz: cannot be unpacked: ") as refused:
        archive.unpack("bad.tar.xz", content)
    assert said in str(refused.value)


def test_pipes_and_folders_are_no_archives(tmp_path):
    os.mkfifo(tmp_path / "pipe.tar.xz")
    one_line(wr_fit("pipe.tar.xz", cwd=tmp_path), 3, "pipe.tar.xz: is not a regular file")
    one_line(wr_fit("none.tar.xz", cwd=tmp_path), 3, "none.tar.xz: no such file or folder")


@pytest.mark.parametrize("form", [tarfile.USTAR_FORMAT, tarfile.GNU_FORMAT, tarfile.PAX_FORMAT])
def test_archives_of_other_programs_are_read(form, tmp_path):
    """Also long names, owners and times; in several pieces of xz."""
    names = ["b.friction", "a.friction"]
    if form != tarfile.USTAR_FORMAT:
        names.append("c" * 180 + ".friction")
    content = tar(*names, format=form)
    half = len(content) // 2
    pieces = lzma.compress(content[:half]), lzma.compress(content[half:])
    (tmp_path / "a.tar.xz").write_bytes(b"".join(pieces))
    files = [row["file"] for row in rows_of(tmp_path, *(f"a.tar.xz/{n}" for n in names))]
    assert files[:1] == ["a.tar.xz/b.friction"]
    found = archive.unpack("a.tar.xz", (tmp_path / "a.tar.xz").read_bytes())
    assert found == {name: LOG.encode() for name in names}


def test_equal_members_make_equal_archives():
    members = {"b.friction": "two\n", "a.profile": "µ\n", "a.friction": "one\n"}
    packed = archive.pack(members)
    assert packed == archive.pack(dict(sorted(members.items())))
    with tarfile.open(fileobj=io.BytesIO(packed), mode="r:xz") as file:
        heads = file.getmembers()
        assert [head.name for head in heads] == sorted(members)
        for head in heads:
            assert (head.mtime, head.uid, head.gid, head.uname, head.gname) == (0, 0, 0, "", "")
            assert head.mode == 0o644 and head.isreg()
    unpacked = archive.unpack("a", packed)
    assert {name: text.decode() for name, text in unpacked.items()} == members
