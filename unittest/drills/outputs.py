#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Every program and script that writes a file, where it cannot or where it must not replace what
is there: a full disk, devices, pipes, links, folders, files without permission, a closed output.

A full disk is a folder that takes so many bytes (full_disk.cpp, preloaded), which needs no
privileges; what else a program writes, such as MPI's own files, does not meet it. Devices are nodes
made for the drill; where that is not allowed the drill says so and uses /dev/full, which nobody can
replace.
"""

import os
import shutil
import stat
import subprocess
import sys
import threading

from drill import ENVIRONMENT, Drill, problem, run
from quick import Scripts
from writing import all_writers, contents, inputs_in, unlike

PAGE = 4096


class Runs:
    """Runs of writers. The library of full disks is preloaded into this process, so that copies of
    it that become scripts have it, too."""

    def __init__(self, drill):
        library = drill.given.build / "lib" / "full_disk.so"
        if not library.exists():
            sys.exit(f"{library}: not there; build it first (--build DIR)")
        if os.environ.get("LD_PRELOAD") != str(library):
            drill.folder.rmdir()
            os.environ["LD_PRELOAD"] = str(library)
            os.execv(sys.executable, [sys.executable, *sys.argv])
        del os.environ["LD_PRELOAD"], ENVIRONMENT["LD_PRELOAD"]
        self.drill, self.library, self.scripts = drill, str(library), Scripts()

    def run(self, writer, out, folder, **disk):
        """One call of a writer, where there is a disk on that one."""
        command = writer.command(self.drill, out)
        if command[0].suffix == ".py":
            return self.scripts.run(command, folder, **disk)
        if disk:
            disk["LD_PRELOAD"] = self.library
            # it comes before the sanitizers, and takes write only
            disk["ASAN_OPTIONS"] = "verify_asan_link_order=0:" + os.environ.get("ASAN_OPTIONS", "")
        return run(command, folder, env=ENVIRONMENT | disk)

    def good(self, writer, folder, out):
        """{name: bytes} of what the writer leaves when nothing goes wrong."""
        done = self.run(writer, out, folder)
        if done.code != 0:
            sys.exit(f"{writer.name}: a good run ends with {done.code}: {done.line}")
        return contents(writer, folder, out)


class Full:
    """Runs of writers on a full disk."""

    def __init__(self, drill, runs, inputs):
        self.drill, self.runs, self.inputs = drill, runs, inputs

    def run(self, writer, size):
        """Runs with room for so many bytes. Returns (how it ended, folder with what is left)."""
        disk, work = self.drill.new_folder("disk"), self.drill.new_folder("work")
        shutil.copytree(self.inputs, work, dirs_exist_ok=True)
        (work / "disk").symlink_to(disk)
        room = {"FULL_DISK": str(disk), "FULL_DISK_SIZE": str(size)}
        return self.runs.run(writer, "disk/x", work, **room), disk

    def drill_writer(self, writer, good):
        """A disk with no room, with room for some of the files, and one with room enough."""
        total = sum(len(content) + PAGE for content in good.values())
        sizes = sorted({PAGE, total // 3 // PAGE * PAGE + PAGE, total // PAGE * PAGE - PAGE})
        for size in sizes:
            if size < PAGE:
                continue
            done, left = self.run(writer, size)
            kind, what = "full disk", f"{writer.name}, {size} bytes"
            wrong = problem(done) or unlike(writer, good, contents(writer, left, "x"))
            names = {str(path.relative_to(left)) for path in left.rglob("*")}
            kept = {name for name in names if name.startswith("x/wr_creep.journal")}
            kept |= {"x"} if writer.folder else set()
            extra = names - set(writer.names("x")) - kept
            whole = contents(writer, left, "x").keys() == good.keys()
            if wrong:
                self.drill.fault(kind, f"{what}: {wrong}")
            elif done.code == 0 and not whole:
                self.drill.fault(kind, f"{what}: exit code 0 without the files")
            elif done.code != 0 and extra:
                self.drill.fault(kind, f"{what}: leaves {sorted(extra)}")
            elif done.code != 0 and "disk/x" not in done.line:
                self.drill.fault(kind, f"{what}: does not name the file: {done.line}")
            else:
                self.drill.count(kind, "written" if done.code == 0 else "refused")


class Nodes:
    """Devices that the drill makes for itself."""

    def __init__(self, folder):
        self.folder = folder
        self.own = True
        try:
            self.make("try", 3)
            with open(folder / "try", "wb"):
                pass
        except PermissionError:
            self.own = False
            print("devices: no node can be made here; /dev/null and /dev/full instead")

    def make(self, name, minor):
        """A node as /dev/null (3) or /dev/full (7); a link to those where none can be made."""
        path = self.folder / name
        path.unlink(missing_ok=True)
        if self.own:
            os.mknod(path, 0o666 | stat.S_IFCHR, os.makedev(1, minor))
        else:
            path.symlink_to({3: "/dev/null", 7: "/dev/full"}[minor])
        return path


def drill_nodes(drill, runs, writer, work, nodes):
    """A device that takes everything, one that is full, and links to both."""
    for minor, name, code in ((3, "null", 0), (7, "full", 5)):
        for link in (False, True):
            path = nodes.make(f"{name}", minor)
            given = path
            if link:
                given = nodes.folder / f"link-{name}"
                given.unlink(missing_ok=True)
                given.symlink_to(path)
            done = runs.run(writer, given, work)
            kind, what = "device", f"{writer.name} on {name}{' by a link' if link else ''}"
            wrong = problem(done)
            if wrong:
                drill.fault(kind, f"{what}: {wrong}")
            elif not path.is_char_device() or (link and not given.is_symlink()):
                drill.fault(kind, f"{what}: is a regular file now")
            elif (done.code == 0) != (code == 0):
                drill.fault(kind, f"{what}: exit code {done.code}: {done.line}")
            else:
                drill.count(kind, "written into" if code == 0 else "refused")


def drill_pipe(drill, runs, writer, work, good):
    """A pipe with a reader gets all the bytes; one whose reader leaves ends the program."""
    pipe = drill.new_folder("pipe") / "pipe"
    os.mkfifo(pipe)
    got = []

    def read():
        got.append(pipe.read_bytes())

    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    done = runs.run(writer, pipe, work)
    reader.join(1.0)
    if reader.is_alive():  # nobody opened the pipe: let the reader go
        os.close(os.open(pipe, os.O_RDWR | os.O_NONBLOCK))
        reader.join(1.0)
    content = good[writer.outputs[0]]
    wrong = problem(done)
    if wrong:
        drill.fault("pipe", f"{writer.name}: {wrong}")
    elif not pipe.is_fifo():
        drill.fault("pipe", f"{writer.name}: is a regular file now")
    elif done.code == 0 and got != [content]:
        drill.fault("pipe", f"{writer.name}: {len(content)} bytes did not arrive as they are")
    else:
        drill.count("pipe", "written into" if done.code == 0 else "refused")


def drill_places(drill, runs, writer, work, good):
    """A link to a file, a folder of that name, no such folder, and an empty name."""
    folder = drill.new_folder("places")
    if not writer.grows:  # a log is begun where there is nothing
        (folder / "far").write_text("old")
    (folder / "link").symlink_to("far")
    (folder / "taken").mkdir()
    done = runs.run(writer, folder / "link", work)
    if problem(done) or done.code != 0 or not (folder / "link").is_symlink():
        drill.fault("link", f"{writer.name}: {problem(done) or done.line or 'the link is gone'}")
    elif (folder / "far").read_bytes() != good[writer.outputs[0]]:
        drill.fault("link", f"{writer.name}: the file behind it is another than it should be")
    else:
        drill.count("link", "written through")
    for what, path in (("folder", "taken"), ("no folder", "no/x"), ("empty name", "")):
        done = runs.run(writer, folder / path if path else "", work)
        wrong = problem(done)
        if wrong:
            drill.fault(what, f"{writer.name}: {wrong}")
        elif done.code == 0:
            drill.fault(what, f"{writer.name}: exit code 0")
        elif (folder / "no").exists() or list((folder / "taken").iterdir()):
            drill.fault(what, f"{writer.name}: leaves files")
        else:
            drill.count(what, "refused")


SPEAKERS = {
    "wr_fit": ["logs"],
    "wr_creep": ["case.yaml", "-o", "spoken"],
    "wr_creep --print-config": ["case.yaml", "--print-config"],
    "wr_creep --help": ["--help"],
    "wr_fit --help": ["--help"],
    "plot_layer.py": ["a.profile"],
    "dump_to_vtk.py": ["atoms.dump", "-o", "spoken"],
    "campaign": ["list"],
    "campaign list": ["list", "pressure"],
}


def drill_speakers(drill, work):
    """Standard output on a full device or closed, and standard error too."""
    for name, words in SPEAKERS.items():
        command = [drill.program(name.split()[0]), *words]
        for both in (False, True):
            with open("/dev/full", "wb") as full:
                error = full if both else subprocess.PIPE
                done = run(command, work, stdout=full, stderr=error)
            wrong = "" if both and done.code in range(1, 7) else problem(done)
            if wrong or done.code == 0:
                drill.fault("standard output", f"{name}, full: {wrong or 'exit code 0'}")
            else:
                drill.count("standard output", "refused")
        reading, writing = os.pipe()
        os.close(reading)
        with os.fdopen(writing, "wb") as closed:
            done = run(command, work, stdout=closed)
        # SIGPIPE ends a program of the shell without a word, as it ends cat
        wrong = "" if done.code == -13 else problem(done)
        if wrong or done.code == 0:
            drill.fault("standard output", f"{name}, closed pipe: {wrong or 'exit code 0'}")
        else:
            drill.count("standard output", "refused")


def main():
    """All writers on all outputs."""
    drill = Drill(__doc__, 1000, "writers that are drilled, the first ones")
    runs = Runs(drill)
    inputs, work = drill.new_folder("inputs"), drill.new_folder("work")
    inputs_in(inputs, drill)
    shutil.copytree(inputs, work, dirs_exist_ok=True)
    full, nodes = Full(drill, runs, inputs), Nodes(drill.new_folder("nodes"))
    for writer in all_writers()[: drill.given.count]:
        if not drill.wanted(writer.name):
            continue
        whole = drill.new_folder("whole")  # with the output's name, which stands in some of them
        shutil.copytree(inputs, whole, dirs_exist_ok=True)
        good = runs.good(writer, whole, "x")
        full.drill_writer(writer, good)
        if writer.plain:
            drill_nodes(drill, runs, writer, work, nodes)
            drill_pipe(drill, runs, writer, work, good)
            drill_places(drill, runs, writer, work, good)
    if drill.wanted("standard output"):
        drill_speakers(drill, work)
    drill.end()


if __name__ == "__main__":
    main()
