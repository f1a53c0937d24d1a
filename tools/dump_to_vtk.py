#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Dumps of LAMMPS as ParaView reads them: automata as points, links as lines, with all columns.

    dump_to_vtk.py friction.dump -o friction
    dump_to_vtk.py friction.dump --links links.dump -o friction
    dump_to_vtk.py run.*.dump -o run

DUMP is a text dump of atoms (dump custom) with the columns id, x and y (or xu, yu) and any others,
--links one of compute mca/link/local (dump local) with both IDs and any others. Each may be several
files; of frames that stand twice, as a continued run leaves them, the later one counts. Writes
NAME.pvd, the frames with their times, NAME_links.pvd likewise, and the frames (*.vtu) in the folder
NAME_frames. A frame of links needs the automata of the same step. Links across a periodic side are
left out: they would be drawn through the box. The columns element and typelabel, which hold words,
are left out with a note; all others hold numbers. Frames and links of an earlier call with the same
NAME go. Exit codes: 0 ok, 1 no meshio, 2 usage, 3 bad input file, 5 a file cannot be written.
"""

import argparse
import contextlib
import os
import pathlib
import tempfile
from typing import Any
from xml.etree import ElementTree

from mcawr.command_line import Parser, file_name, number_in
from mcawr.dump import Dump
from mcawr.errors import BadInput, Exit, Failure, complain, fail, run_script, say
from mcawr.files import make_folder, replace_all

INTEGERS = {"id", "mol", "type", "proc", "procp1", "ix", "iy", "iz"}
WORDS = {"element", "typelabel"}  # columns of dump custom
ENDS = [("batom1", "batom2"), ("id1", "id2")]


class Frames:
    """The frames of several dumps: at[step] is (dump, number of the frame in it). cut: whether a
    last frame was left out."""

    def __init__(self, paths: list[str]) -> None:
        self.at: dict[int, tuple[Dump, int]] = {}
        self.cut = False
        words: dict[str, str] = {}  # column: the first dump that has it
        for path in paths:
            dump = Dump(path)
            for number, frame in enumerate(dump.frames):
                self.at[frame["step"]] = dump, number
                words |= {name: path for name in WORDS & set(frame["names"]) - words.keys()}
            if dump.cut:
                complain(f"{path}: the last frame is cut and left out")
                self.cut = True
        for name, path in sorted(words.items()):
            complain(f"note: {path}: left out, since it holds words: {name}")


class Writer:
    """Frames as *.vtu in a folder beside their places; finish() moves all of them there."""

    def __init__(self, output: str, folder: str, timestep: float) -> None:
        self.output, self.folder, self.timestep = output, folder, timestep
        self.frames = f"{output}_frames"  # where they go
        self.series: dict[
            str, list[tuple[float, str]]
        ] = {}  # name of the collection: [(time, file)]

    def frame(
        self,
        collection: str,
        kind: str,
        frame: dict[str, Any],
        points: Any,
        cells: list[tuple[str, Any]],
        point_data: dict[str, Any],
        cell_data: dict[str, Any],
    ) -> None:
        import meshio

        name = f"{kind}.{frame['step']}.vtu"
        mesh = meshio.Mesh(
            points,
            cells,
            point_data=point_data,
            cell_data={key: [values] for key, values in cell_data.items()},
        )
        try:
            meshio.vtu.write(os.path.join(self.folder, name), mesh)
        except OSError as error:
            path = os.path.join(self.frames, name)
            fail(Exit.IO, f"{path}: cannot be written: {error.strerror}")
        time = frame["time"] if frame["time"] is not None else frame["step"] * self.timestep
        self.series.setdefault(collection, []).append((time, name))

    def former(self) -> list[str]:
        """The collections of an earlier call of this name, and the frames that they list."""
        found = []
        for path in (f"{self.output}.pvd", f"{self.output}_links.pvd"):
            try:
                listed = ElementTree.parse(path).getroot().findall("Collection/DataSet")
            except (OSError, ElementTree.ParseError):
                continue
            found.append(path)
            for node in listed:
                folder, name = os.path.split(node.get("file", ""))
                if folder == os.path.basename(self.frames) and name.endswith(".vtu"):
                    found.append(os.path.join(self.frames, name))
        return found

    def finish(self) -> None:
        files: dict[str, pathlib.Path | bytes] = {}
        for collection, series in self.series.items():
            root = ElementTree.Element("VTKFile", type="Collection", version="0.1")
            listed = ElementTree.SubElement(root, "Collection")
            for time, name in series:
                files[os.path.join(self.frames, name)] = pathlib.Path(self.folder, name)
                ElementTree.SubElement(
                    listed,
                    "DataSet",
                    timestep=repr(time),
                    part="0",
                    file=f"{os.path.basename(self.frames)}/{name}",
                )
            text = ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)
            files[f"{self.output}{collection}.pvd"] = text
        make_folder(self.frames)
        try:
            replace_all(files, self.former())
        except Failure:
            with contextlib.suppress(OSError):  # it holds the frames of an earlier call
                os.rmdir(self.frames)
            raise


def arrays(dump: Dump, number: int, integers: set[str]) -> dict[str, Any]:
    """{column: its values} of all columns of numbers of a frame."""
    import numpy

    frame = dump.frames[number]
    names = [name for name in frame["names"] if name not in WORDS]
    columns = {
        name: numpy.array(values, dtype=float)
        for name, values in dump.columns(number, names).items()
    }
    for name in integers & set(columns):
        values = columns[name]
        wrong = numpy.flatnonzero(values != numpy.rint(values))
        if len(wrong):
            raise BadInput(
                f"{dump.path}:{frame['first'] + 1 + wrong[0]}: {name} is {values[wrong[0]]}, "
                "an integer is expected"
            )
        columns[name] = values.astype(numpy.int64)
    return columns


def positions(dump: Dump, number: int, columns: dict[str, Any]) -> Any:
    import numpy

    frame = dump.frames[number]
    where = f"{dump.path}:{frame['head'] + 1}"
    axes = ["xu", "yu", "zu"] if "xu" in columns else ["x", "y", "z"]
    for name in ["id", *axes[:2]]:
        if name not in columns:
            raise BadInput(
                f"{where}: column {name} is missing, the dump has: {' '.join(frame['names'])}"
            )
    count = len(columns["id"])
    if count == 0:
        raise BadInput(f"{where}: no automaton in the frame of step {frame['step']}")
    if len(numpy.unique(columns["id"])) < count:
        raise BadInput(f"{where}: an ID appears twice in the frame of step {frame['step']}")
    return numpy.column_stack([columns.get(name, numpy.zeros(count)) for name in axes])


def ends_of(dump: Dump, number: int, given: tuple[str, str] | None) -> tuple[str, str]:
    """Names of the columns that hold the IDs of a link's automata."""
    frame = dump.frames[number]
    choice = [given] if given else ENDS
    for pair in choice:
        if set(pair) <= set(frame["names"]):
            return pair
    raise BadInput(
        f"{dump.path}:{frame['head'] + 1}: no columns {' or '.join(map(' '.join, choice))} "
        f"with the IDs of a link (--ends), the dump has: {' '.join(frame['names'])}"
    )


def lines(
    dump: Dump,
    number: int,
    ends: tuple[str, str],
    columns: dict[str, Any],
    ids: Any,
    points: Any,
    source: str,
) -> tuple[Any, Any]:
    """(rows that are drawn, their ends as rows of the automata)."""
    import numpy

    frame = dump.frames[number]
    order = numpy.argsort(ids)
    found = []
    for name in ends:
        place = numpy.searchsorted(ids[order], columns[name])
        row = order[numpy.minimum(place, len(order) - 1)]
        missing = numpy.flatnonzero(ids[row] != columns[name])
        if len(missing):
            raise BadInput(
                f"{dump.path}:{frame['first'] + 1 + missing[0]}: automaton "
                f"{columns[name][missing[0]]} "
                f"does not stand in the frame of step {frame['step']} of {source}"
            )
        found.append(row)
    pairs = numpy.column_stack(found)
    box = numpy.array(frame["box"])
    half = numpy.where(frame["periodic"], 0.5 * (box[:, 1] - box[:, 0]), numpy.inf)
    drawn = (abs(points[pairs[:, 1]] - points[pairs[:, 0]]) < half).all(axis=1)
    return drawn, pairs[drawn]


def convert(given: argparse.Namespace, writer: Writer) -> str:
    """Writes all frames; returns what is to be said."""
    import numpy

    automata, links = Frames(given.dump), Frames(given.links)
    for dump, number in links.at.values():
        if dump.frames[number]["triclinic"]:
            raise BadInput(f"{dump.path}: links of a triclinic box cannot be drawn")
    if automata.cut:  # the run may have written one dump further than the other
        links.at = {step: at for step, at in links.at.items() if step <= max(automata.at)}
    for step, (dump, number) in links.at.items():
        if step not in automata.at:
            raise BadInput(
                f"{dump.path}:{dump.frames[number]['head'] + 1}: {' '.join(given.dump)} has no "
                f"complete frame of step {step}"
            )
    left_out = 0
    for step, (dump, number) in sorted(automata.at.items()):
        columns = arrays(dump, number, INTEGERS)
        points = positions(dump, number, columns)
        rows = numpy.arange(len(points)).reshape(-1, 1)
        writer.frame("", "automata", dump.frames[number], points, [("vertex", rows)], columns, {})
        if step in links.at:
            source = dump.path
            dump, number = links.at[step]
            ends = ends_of(dump, number, given.ends)
            cells = arrays(dump, number, {*INTEGERS, *ends})
            drawn, pairs = lines(dump, number, ends, cells, columns["id"], points, source)
            left_out += len(drawn) - len(pairs)
            writer.frame(
                "_links",
                "links",
                dump.frames[number],
                points,
                [("line", pairs)],
                {},
                {name: values[drawn] for name, values in cells.items()},
            )
    said = f"{given.output}.pvd: {len(automata.at)} frames"
    if given.links:
        said += (
            f"; {given.output}_links.pvd: {len(links.at)} frames, {left_out} links across a "
            "periodic side "
            "left out"
        )
    return said


def arguments() -> argparse.Namespace:
    parser = Parser(__doc__)
    parser.add_argument("dump", type=file_name, metavar="DUMP", nargs="+")
    parser.add_argument(
        "-o", "--output", type=file_name, metavar="NAME", help="[the dump's name without .dump]"
    )
    parser.add_argument(
        "--links",
        type=file_name,
        metavar="DUMP",
        action="append",
        default=[],
        help="dump local of compute mca/link/local; may stand several times",
    )
    parser.add_argument(
        "--ends",
        nargs=2,
        metavar="COLUMN",
        help=f"columns of both IDs [{', or '.join(map(' '.join, ENDS))}]",
    )
    parser.add_argument(
        "--timestep",
        type=number_in(),
        default=1.0,
        metavar="DT",
        help="time of a step, where the dump has no times (dump_modify time yes) [1]",
    )
    given = parser.parse_args()
    if len(given.dump) > 1 and not given.output:
        parser.error("-o is needed with several dumps")
    given.output = given.output or given.dump[0].removesuffix(".dump")
    if not os.path.basename(given.output):
        parser.error(f"-o {given.output}: the name of a file without its ending is needed")
    if given.ends and not given.links:
        parser.error("--ends: is for --links")
    return given


def main() -> None:
    given = arguments()
    import meshio  # noqa: F401, the frames need it

    try:
        beside = os.path.dirname(os.path.abspath(given.output))
        with tempfile.TemporaryDirectory(dir=beside, prefix=".dump_to_vtk.") as folder:
            writer = Writer(given.output, folder, given.timestep)
            said = convert(given, writer)
            writer.finish()
    except OSError as error:
        fail(Exit.IO, f"{given.output}.pvd: cannot be written: {error.strerror}")
    say(said)


if __name__ == "__main__":
    run_script(main)
