#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Kills programs that write at random times (SIGKILL): each file is whole or not there, and the
same command, given again, leaves what an undisturbed run leaves."""

import os
import shutil
import signal
import subprocess
import time

from drill import DRIVE, ENVIRONMENT, SLIDING, Drill, problem, run
from writing import Writer, all_writers, contents, good_run, inputs_in, unlike

NAMES = (
    "fix mca/drive",
    "mca_links write",
    "wr_fit -o",
    "wr_creep -o",
    "wr_creep patch",
    "dump_to_vtk",
    "plot_friction",
)
RESTARTED = "restart 40 a.restart b.restart\n"


def killed(command, folder, pause):
    """Starts a command and kills it, and all that it started, after so many seconds."""
    call = subprocess.Popen(
        list(map(str, command)), cwd=folder, env=ENVIRONMENT, start_new_session=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        call.wait(pause)
        return False
    except subprocess.TimeoutExpired:
        os.killpg(call.pid, signal.SIGKILL)
        call.wait()
        return True


def drill_writer(drill, writer, inputs, count):
    """Kills one writer at random times of its run."""
    work = drill.new_folder("work")
    shutil.copytree(inputs, work, dirs_exist_ok=True)
    begin = time.monotonic()
    good = good_run(writer, work, drill, "x")
    whole = time.monotonic() - begin
    for _ in range(count):
        shutil.rmtree(work)
        shutil.copytree(inputs, work)
        pause = drill.random.uniform(0.0, whole)
        if not killed(writer.command(drill, "x"), work, pause):
            drill.count(writer.name, "was done before")
            continue
        wrong = unlike(writer, good, contents(writer, work, "x"))
        done = run(writer.command(drill, "x"), work)
        again = contents(writer, work, "x")
        wrong = wrong or problem(done) or unlike(writer, good, again)
        if wrong or done.code != 0 or again.keys() != good.keys():
            drill.fault(writer.name, f"after {pause:.3f} s: {wrong or done.line or 'files lack'}")
        else:
            drill.count(writer.name, "killed, as new")


def drill_restart(drill, inputs, count):
    """A run with a friction log, killed, goes on from its last restart file: the same log."""
    name = "lmp, restart"
    steps = "run 2000 upto\n"
    begin = SLIDING + DRIVE.format(log="x") + RESTARTED + steps
    go_on = (
        "units nano\nread_restart {file}\nfix integrate all nve/mca\nfix hold bottom freeze\n"
        + DRIVE.format(log="x")
        + steps
    )
    work = drill.new_folder("restart")
    (work / "in.begin").write_text(begin)
    whole = Writer(name, "lmp", ["in.begin"], ["x"])
    started = time.monotonic()
    good = good_run(whole, work, drill, "x")["x"]
    seconds = time.monotonic() - started
    for _ in range(count):
        shutil.rmtree(work)
        work.mkdir()
        (work / "in.begin").write_text(begin)
        pause = drill.random.uniform(0.2 * seconds, seconds)
        if not killed(drill.lmp("in.begin"), work, pause):
            drill.count(name, "was done before")
            continue
        files = sorted(work.glob("?.restart"), key=lambda path: path.stat().st_mtime, reverse=True)
        if not files:
            drill.count(name, "killed before the first restart file")
            continue
        # the last one may be cut: LAMMPS writes it in place, which is why there are two
        for file in files:
            (work / "in.next").write_text(go_on.format(file=file.name))
            done = run(drill.lmp("in.next"), work)
            if problem(done) or done.code == 0:
                break
        log = work / "x"
        if problem(done) or done.code != 0 or log.read_bytes() != good:
            drill.fault(name, f"after {pause:.3f} s: {problem(done) or done.line or 'another log'}")
        else:
            drill.count(name, "killed, went on to the same log")


def main():
    """Kills all of them."""
    drill = Drill(__doc__, 2, "kills of each writer; 5 in the table of doc/testing.md")
    inputs = drill.new_folder("inputs")
    inputs_in(inputs, drill)
    for writer in all_writers():
        if writer.name in NAMES and drill.wanted(writer.name):
            drill_writer(drill, writer, inputs, drill.given.count)
    if drill.wanted("restart"):
        drill_restart(drill, inputs, drill.given.count)
    drill.end()


if __name__ == "__main__":
    main()
