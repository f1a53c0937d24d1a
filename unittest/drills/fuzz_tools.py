#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Fuzzing of the readers of the scripts: falsified files, each of which is refused with one line
(BadInput) or read."""

import json
import lzma
import os
import pathlib
import random
import signal
import tempfile

from drill import HANG, ROOT, Drill, inputs

from campaign_parts import folder, material, plan as plans
from campaign_parts.quantities import Run
from mcawr import archive, dump, errors, fields, friction_log, tables

WORDS = [
    b"nan", b"inf", b"-1", b"0", b"1e308", b"1e309", b"99999999999999999999", b"0x10", b"", b"\n",
    b",", b"#", b"[" * 2000, b"{", b"- " * 500, b"\x00", b"\xff\xfe", b"\xc3\xa9", b"'", b'"',
    b"ITEM: ", b"null", b"!!python/object:x ", b"&a [*a]", b"<", b"\x1b[31m",
]  # fmt: skip


MARKS = (b"\xef\xbb\xbf", b"\xff\xfe", b"\xfe\xff")
SEPARATORS = (b",", b";", b"\t", b" ", b"; ", b" , ")


def of_another_machine(data, generator):
    """What another machine makes of a whole text: line ends, marks, encodings, decimal signs,
    separators."""
    what = generator.randrange(7)
    if what == 0:
        return data.replace(b"\n", generator.choice((b"\r\n", b"\r", b"\n\r", b"\n\n")))
    if what == 1:
        return generator.choice(MARKS) + data
    if what == 2:
        return data.decode("latin-1").encode(generator.choice(("utf-16", "utf-16-le", "utf-16-be")))
    if what == 3:
        return data.replace(b"um", generator.choice((b"\xb5m", b"\xc2\xb5m", b"\xe6m")))
    if what == 4:
        return data.replace(b".", b",")
    if what == 5:
        return data.replace(generator.choice(SEPARATORS), generator.choice(SEPARATORS))
    return data.replace(b"\n", generator.choice(SEPARATORS) + b"\n")


def falsified(corpus, generator):
    """One of the corpus with 1 to 6 changes."""
    data = bytearray(generator.choice(corpus))
    for _ in range(generator.choice((1, 1, 1, 2, 6))):
        at, width = generator.randrange(len(data) + 1), generator.choice((0, 1, 4, 40, 400))
        what = generator.randrange(6)
        if what == 0 and at < len(data):
            data[at] ^= 1 << generator.randrange(8)
        elif what == 1:
            data[at : at + width] = generator.choice(WORDS)
        elif what == 2:
            del data[at : at + max(width, 1)]
        elif what == 3:
            data[at:at] = data[at : at + width] * generator.choice((1, 2, 50))
        elif what == 4:
            other = generator.choice(corpus)
            begin = generator.randrange(len(other))
            data[at : at + width] = other[begin : begin + width]
        else:
            data = bytearray(of_another_machine(bytes(data), generator))
    return bytes(data)


def read_dump(path):
    """All columns of all frames."""
    read = dump.Dump(path)
    for number, frame in enumerate(read.frames):
        read.columns(number, [name for name in frame["names"] if name not in ("element", "mol")])


def read_log(path):
    """A friction log, two ways."""
    friction_log.last_rows(path, 3)
    friction_log.read(path)


def read_archive(path, packed):
    """An archive: behind the checksums of xz, what was packed."""
    if archive.unpack(path, pathlib.Path(path).read_bytes()) != packed:
        raise AssertionError("other members than were packed")


def read_tar(path):
    """What stands behind these checksums."""
    archive.unpack(path, lzma.compress(pathlib.Path(path).read_bytes(), preset=0))


def run_record():
    """What a campaign keeps of a finished run, and run.json with it."""
    record = {"parameters": {"p": 15, "v": 5.0, "ns": 80}, "inputs": {"in.friction": "1f"},
              "results": {"run.friction": "2e"}, "attempts": 1}  # fmt: skip
    with tempfile.TemporaryDirectory() as top:
        kept = folder.RunFolder(top, Run(".", {}, ""))
        kept.write_record(record)
        return record, pathlib.Path(kept.file("run.json")).read_bytes()


def read_run_record(path, record):
    """run.json: the record that was written, or refused."""
    top = os.path.dirname(path)
    os.replace(path, os.path.join(top, "run.json"))
    if folder.RunFolder(top, Run(".", {}, "")).record() != record:
        raise AssertionError("another record than was written")


def read_material(path):
    """A potential file, where it has temperatures at one of them."""
    hot = b"\ntemperature" in pathlib.Path(path).read_bytes()
    material.read(path, 450.0 if hot else None)


def shipped(where, pattern):
    """Contents of files of the project."""
    return [path.read_bytes() for path in sorted((ROOT / where).glob(pattern))]


def readers():
    """{name: (good files, function of a path)}."""
    import plot_benchmark
    import plot_creep
    from script_calls import with_checksum
    from test_plot_patch import contact, vti

    import plot_fit
    import plot_layer

    text = {name: content.encode() for name, content in inputs().items()}
    lines = text["a.friction"].splitlines(keepends=True)
    sealed = with_checksum(json.loads(text["fit.json"])).encode()
    record, kept = run_record()
    members = {name: content[:900] for name, content in text.items()}
    packed = archive.pack({name: content.decode() for name, content in members.items()})
    return {
        "dump": ([text["a.dump"], text["atoms.dump"]], read_dump),
        "friction_log": ([b"".join(lines[:15])], read_log),
        "archive": ([packed], lambda path: read_archive(path, members)),
        "sealed_archive": ([lzma.decompress(packed)], read_tar),
        "vti": ([vti(contact())[:4000], vti(contact())], fields.read_vti),
        "fit": ([text["fit.json"], sealed], plot_fit.read),
        "table": ([text["a.csv"]], lambda path: tables.read(path, "a table", list)),
        "creep": ([text["a.csv"]], lambda path: plot_creep.read(path, ("creep",))),
        "profile": ([text["a.profile"]], plot_layer.read_frames),
        "benchmark": ([text["bench.json"]], plot_benchmark.read_cases),
        "material": (shipped("potentials", "*.mca"), read_material),
        # the long ones have nothing that these have not, and take ten times as long
        "plan": ([p for p in shipped("examples/campaign", "*.yaml") if len(p) < 700], plans.read),
        "run": ([kept], lambda path: read_run_record(path, record)),
    }


def main():
    """All readers."""
    tables.complain = lambda _: None  # notes of files without a checksum
    drill = Drill(__doc__, 1000, "files for each reader; 1000000 in the table of doc/testing.md")
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else drill.folder  # six times as fast
    folder_of_one = tempfile.TemporaryDirectory(prefix="drill-", dir=memory)
    path = pathlib.Path(folder_of_one.name) / "x.yaml"
    for name, (corpus, read) in readers().items():
        if not drill.wanted(name):
            continue
        for number in range(drill.given.count):
            generator = random.Random(f"{drill.given.seed} {number}")
            path.write_bytes(falsified(corpus, generator))
            signal.setitimer(signal.ITIMER_PROF, HANG)  # processor time; ends the drill
            try:
                read(str(path))
                drill.count(name, "accepted")
            except (errors.BadInput, folder.FolderError) as error:
                if len(errors.one_line(error)) > 3000:
                    drill.fault(name, f"file {number}: a message of {len(str(error))} letters")
                else:
                    drill.count(name, "refused")
            except Exception as error:  # whatever else is a fault of the reader
                drill.fault(name, f"file {number}: {type(error).__name__}: {error}"[:300])
    signal.setitimer(signal.ITIMER_PROF, 0)
    folder_of_one.cleanup()
    drill.end()


if __name__ == "__main__":
    main()
