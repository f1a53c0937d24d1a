# SPDX-License-Identifier: GPL-2.0-or-later
"""Every program and script that writes files, as the drills call it."""

import dataclasses
import json
import sys

from drill import CASE, DRIVE, PATCH, SLIDING, inputs, run, writers

from friction_logs import friction_log


@dataclasses.dataclass
class Writer:
    """One call that writes. In its words {out} is the name of the output."""

    name: str
    program: str
    words: list
    outputs: list  # names of files, {out} among them; the first is the one that may be a device
    # whether the output is a file that a device or a pipe may stand for
    plain: bool = True
    # compared with those of a good run, byte by byte; the others, in which there is a time, are
    # JSON. None: all of them
    exact: list = None
    # the output grows row by row: after a failure it may hold its first rows
    grows: bool = False

    def command(self, drill, out):
        """The whole command, with this name of the output."""
        words = [str(word).format(out=out) for word in self.words]
        if self.program == "lmp":
            return drill.lmp(*words[:1], out=out)
        return [drill.program(self.program), *words]

    @property
    def folder(self):
        """Whether the output is a folder, which is there before the files in it."""
        return self.outputs[0].startswith("{out}/")

    def names(self, out):
        """Names of its files."""
        return [name.format(out=out) for name in self.outputs]


def all_writers():
    """Every program and script that writes a file which its caller names."""
    every = [
        Writer("fix mca/drive", "lmp", ["in.drive"], ["{out}"], grows=True),
        Writer("mca_links write", "lmp", ["in.links"], ["{out}"]),
        Writer("wr_fit -o", "wr_fit", ["logs", "-q", "-o", "{out}"], ["{out}"]),
        Writer("wr_fit --runs", "wr_fit", ["logs", "-q", "--runs", "{out}"], ["{out}"]),
        Writer("wr_fit --plot", "wr_fit", ["logs", "-q", "--plot", "{out}"], ["{out}"]),
        Writer(
            "wr_creep -o", "wr_creep", ["case.yaml", "-q", "-o", "{out}"],
            ["{out}/creep.csv", "{out}/contact.csv", "{out}/creep.json", "{out}/summary.json"],
            plain=False, exact=["{out}/creep.csv", "{out}/contact.csv"],
        ),
        Writer(
            "wr_creep static", "wr_creep",
            ["case.yaml", "-q", "-o", "{out}", "--set", "mode=static", "--set",
             "static.force_ratio=[0.2, 0.4]"],
            ["{out}/static.csv", "{out}/contact.csv", "{out}/summary.json"],
            plain=False, exact=["{out}/static.csv", "{out}/contact.csv"],
        ),
        Writer(
            "wr_creep patch", "wr_creep", ["patch.yaml", "-q", "-o", "{out}"],
            ["{out}/creep.csv", "{out}/summary.json"], plain=False, exact=["{out}/creep.csv"],
        ),
        Writer(
            "wr_creep --polach", "wr_creep",
            ["patch.yaml", "-q", "-o", "curves", "--set",
             "creep={{from: 0.0001, to: 0.1, n: 12}}", "--polach", "{out}"],
            ["{out}", "{out}.csv"],
        ),
        Writer("plot_layer --csv", "plot_layer.py", ["a.profile", "--csv", "{out}"], ["{out}"]),
        Writer(
            "dump_to_vtk", "dump_to_vtk.py", ["atoms.dump", "-o", "{out}"],
            ["{out}.pvd", "{out}_frames/automata.500.vtu"], plain=False,
        ),
        Writer(
            "plot_fragment gif", "plot_fragment.py",
            ["a.dump", "--dpi", "40", "-o", "{out}.gif"], ["{out}.gif"], plain=False,
        ),
    ]  # fmt: skip
    for script, words in writers().items():
        every.append(Writer(script.removesuffix(".py"), script, [*words, "{out}"], ["{out}"]))
    return every


def inputs_in(folder, drill):
    """Puts what the writers read into a folder."""
    for name, text in inputs().items():
        (folder / name).write_text(text)
    (folder / "case.yaml").write_text(CASE)
    (folder / "patch.yaml").write_text(PATCH)
    (folder / "in.drive").write_text(SLIDING + DRIVE.format(log="${out}") + "run 200\n")
    (folder / "in.links").write_text(SLIDING + "run 20\nmca_links write ${out}\n")
    logs = folder / "logs"
    logs.mkdir()
    for k, velocity in enumerate((1, 2, 5, 8)):
        (logs / f"{k}.friction").write_text(friction_log(v=velocity, seed=k, ns=10.0))


def good_run(writer, folder, drill, out):
    """{name: bytes} of what the writer leaves when nothing goes wrong."""
    done = run(writer.command(drill, out), folder)
    if done.code != 0:
        sys.exit(f"{writer.name}: a good run ends with {done.code}: {done.line}")
    return contents(writer, folder, out)


def contents(writer, folder, out, names=None):
    """{name with {out} in it: bytes} of the outputs that are there."""
    found = {}
    for name in names or writer.outputs:
        path = folder / name.format(out=out)
        if path.is_file():
            found[name] = path.read_bytes()
    return found


def unlike(writer, good, left):
    """What is wrong with the files that a run left, beside those of a good run; empty: nothing.
    Each is whole, or it is not there."""
    for name, content in left.items():
        if writer.grows:
            begin = content[: content.rfind(b"\n") + 1]
            if not good[name].startswith(begin) or b"\nstep " not in begin:
                return f"{name}: not the first rows of the log"
        elif name not in (writer.exact or writer.outputs):
            try:
                json.loads(content)
            except ValueError:
                return f"{name}: half of it"
        elif content != good[name]:
            return f"{name}: {len(content)} bytes that are not those of a good run"
    return ""
