# SPDX-License-Identifier: GPL-2.0-or-later
"""LAMMPS text dumps: of atoms (dump custom) and of local values (dump local)."""

from collections.abc import Iterable, Sequence
from typing import Any

from .errors import BadInput
from .files import read_text
from .numbers import decimal, whole
from .tables import LARGEST


class Dump:
    """A LAMMPS text dump; numbers are read when a frame is asked for.

    frames: one dict each: step; time (None where the dump has none); count of rows; box, a pair of
    bounds for each axis; periodic, for each axis; triclinic; names of the columns; head and first,
    the places of the line of names and of the first row in lines.
    cut: whether the last frame was not whole, hence left out.
    """

    def __init__(self, path: str, spellings: dict[str, str] | None = None) -> None:
        """spellings: {name: the other name under which a column may stand}."""
        self.path, self.spellings = path, spellings or {}
        self.lines = read_text(path).split("\n")[:-1]  # what follows the last end of line was cut
        self.frames, self.cut, number = [], False, 0
        while number < len(self.lines) and not self.cut:
            frame = self._head(number)
            if frame is None:  # the run was interrupted while it wrote
                self.cut = True
            else:
                self.frames.append(frame)
                number = frame["first"] + frame["count"]
        if not self.frames:
            raise BadInput(f"{path}: no complete frame in it")

    def _head(self, number: int) -> dict[str, Any] | None:
        """What stands before the rows of the frame at lines[number]; None if the frame is cut."""
        frame: dict[str, Any] = {"time": None}
        at, table = number, None
        try:
            while table is None or not self.lines[at].startswith(table):
                item, value = self.lines[at], self.lines[at + 1]
                if item == "ITEM: TIMESTEP":
                    frame["step"] = whole(value)
                elif item == "ITEM: TIME":
                    frame["time"] = decimal(value)
                elif item.startswith("ITEM: NUMBER OF "):
                    frame["count"] = whole(value)
                    table = "ITEM: " + item.removeprefix("ITEM: NUMBER OF ") + " "
                elif item.startswith("ITEM: BOX BOUNDS"):
                    sides = item.split()[3:]
                    frame["periodic"] = [side == "pp" for side in sides[-3:]]
                    frame["triclinic"] = len(sides) == 6
                    frame["box"] = [
                        [decimal(word) for word in line.split()[:2]]
                        for line in self.lines[at + 1 : at + 4]
                    ]
                    at += 2
                elif item != "ITEM: UNITS":
                    raise ValueError
                at += 2
            frame["names"] = self.lines[at].removeprefix(table).split()
            frame["head"], frame["first"] = at, at + 1
            if not (
                frame["count"] >= 0
                and "step" in frame
                and len(frame["box"]) == 3
                and all(-LARGEST < a < b < LARGEST for a, b in frame["box"])
            ):
                raise ValueError
        except (IndexError, ValueError, KeyError):
            if number > 0 and at + 4 >= len(self.lines):
                return None
            raise BadInput(f"{self.path}:{number + 1}: not a frame of a LAMMPS text dump") from None
        last = frame["first"] + frame["count"]
        if len(self.lines) < last or (
            frame["count"] and len(self.lines[last - 1].split()) != len(frame["names"])
        ):
            return None
        return frame

    def columns(self, number: int, names: Iterable[str]) -> dict[str, list[float]]:
        """{name: values of that column} of a frame."""
        frame = self.frames[number]
        places = {name: self._place(frame, name) for name in names}
        values: dict[str, list[float]] = {name: [] for name in names}
        for k in range(frame["first"], frame["first"] + frame["count"]):
            words = self.lines[k].split()
            if len(words) != len(frame["names"]):
                raise BadInput(
                    f"{self.path}:{k + 1}: {len(words)} values, {len(frame['names'])} are expected"
                )
            try:
                for name, place in places.items():
                    value = float(words[place])
                    if not -LARGEST < value < LARGEST or "_" in words[place]:
                        raise ValueError
                    values[name].append(value)
            except ValueError:
                raise BadInput(
                    f"{self.path}:{k + 1}: {name} is '{words[place][:40]}', a number within "
                    f"+-{LARGEST:g} is expected"
                ) from None
        return values

    def _place(self, frame: dict[str, Any], name: str) -> int:
        for spelling in (name, self.spellings.get(name)):
            if spelling in frame["names"]:
                return frame["names"].index(spelling)
        raise BadInput(
            f"{self.path}:{frame['head'] + 1}: column {name} is missing, the dump has: "
            f"{' '.join(frame['names'])}"
        )


class Film:
    """The frames of several dumps in the order of their steps; of two of one step that of the later
    file. What Dump has, but the lines."""

    def __init__(self, paths: Sequence[str], spellings: dict[str, str] | None = None) -> None:
        """paths: at least one."""
        dumps = [Dump(path, spellings) for path in paths]
        places = {
            frame["step"] if len(dumps) > 1 else k: (dump, k)
            for dump in dumps
            for k, frame in enumerate(dump.frames)
        }
        self._places = [places[at] for at in sorted(places)]
        self.frames = [dump.frames[k] for dump, k in self._places]
        self.path = self._places[0][0].path  # of the first frame
        self.cut = [dump.path for dump in dumps if dump.cut]  # whose last frame is left out

    def path_of(self, number: int) -> str:
        """The file of a frame."""
        return self._places[number][0].path

    def columns(self, number: int, names: Iterable[str]) -> dict[str, list[float]]:
        """{name: values of that column} of a frame."""
        dump, k = self._places[number]
        return dump.columns(k, names)
