#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Bit flips and truncations of every kind of file that a program of ours goes on from.

A falsified file has to be refused, or to give the same results as the good one. A friction log
that was cut is a shorter one: it grows row by row, and nothing says how long it will be.
"""

import signal
import subprocess
import sys
import time

from drill import CASE, DRIVE, ENVIRONMENT, PATCH, SLIDING, Drill, falsified, problem, run

from friction_logs import campaign

CONTINUED = (
    "units nano\nread_restart {file}\nfix integrate all nve/mca\nfix hold bottom freeze\n"
    + DRIVE
    + "run 40\n"
    + "compute states all mca/atom links\n"
    + "dump states all custom 1 states.dump id x y vx vy c_states\n"
    + "dump_modify states format float %.17g sort id\nrun 0\n"
)
READ_LINKS = """units nano
dimension 2
boundary p s p
atom_style hybrid sphere bond
special_bonds lj 1 1 1
neighbor 0.4 bin
read_data {file}
mass * 1
bond_style zero
bond_coeff * 2.5
pair_style mca
pair_coeff * * steel.mca strength 92
mca_links read {file}
fix integrate all nve/mca
timestep 5e-5
compute states all mca/atom links
dump states all custom 1 states.dump id x y vx vy c_states
dump_modify states format float %.17g sort id
run 20
"""


class Kind:
    """A kind of file: made once, then read after each flip."""

    grows = False  # cut off, it is a good file of an earlier time

    def __init__(self, drill):
        self.drill = drill

    def make(self, folder):
        """Makes the good file. Returns its path."""
        raise NotImplementedError

    def use(self, folder):
        """Reads the file in the folder. Returns (how that ended, the results)."""
        raise NotImplementedError


class LineJournal(Kind):
    """Journal of a sweep that was interrupted."""

    case = CASE
    speeds, points = 40, 2048

    def make(self, folder):
        (folder / "case.yaml").write_text(self.case)
        journal = folder / "out" / "wr_creep.journal"
        pause = 0.3
        for _ in range(20):
            call = subprocess.Popen(
                list(map(str, self.command())), cwd=folder, env=ENVIRONMENT,
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            )  # fmt: skip
            time.sleep(pause)
            call.send_signal(signal.SIGTERM)
            call.wait()
            if journal.exists() and journal.stat().st_size > 500:  # some pieces
                return journal
            pause *= 0.7 if call.returncode == 0 else 1.2
        sys.exit("no sweep could be interrupted")

    def command(self):
        words = [self.drill.program("wr_creep"), "case.yaml", "-o", "out", "--threads", 1, "-q"]
        speeds = ", ".join(f"{k} m/s" for k in range(1, self.speeds + 1))
        return [*words, "--set", f"speed=[{speeds}]", "--set", f"cells={self.points}"]

    def use(self, folder):
        done = run(self.command(), folder)
        table = folder / "out" / "creep.csv"
        return done, table.read_bytes() if done.code == 0 else None


class PatchJournal(LineJournal):
    """Journals of point contacts."""

    case = PATCH
    speeds, points = 20, 48


class Law(Kind):
    """A fitted law, carried to a creep curve."""

    def make(self, folder):
        campaign(folder / "logs")
        done = run([self.drill.program("wr_fit"), "logs", "-o", "law.json", "-q"], folder)
        if done.code != 0:
            sys.exit(f"no law: {done.line}")
        (folder / "case.yaml").write_text(CASE.replace("bucher2006", "law.json"))
        for log in (folder / "logs").rglob("*.friction"):
            log.unlink()
        return folder / "law.json"

    def use(self, folder):
        done = run([self.drill.program("wr_creep"), "case.yaml", "-o", "out", "-q"], folder)
        names = ("creep.csv", "creep_band.csv")
        return done, done.code == 0 and [(folder / "out" / name).read_bytes() for name in names]


class Log(Kind):
    """A friction log of a run, fitted."""

    grows = True

    def make(self, folder):
        script = SLIDING + DRIVE.format(log="a.friction") + "run 2000\n"
        (folder / "in.first").write_text(script)
        done = run(self.drill.lmp("in.first"), folder)
        if done.code != 0:
            sys.exit(f"no friction log: {done.line}")
        return folder / "a.friction"

    def use(self, folder):
        done = run([self.drill.program("wr_fit"), "a.friction", "--runs", "p.csv"], folder)
        return done, done.code == 0 and (folder / "p.csv").read_bytes()


class Restart(Kind):
    """A restart file, from which a driven run goes on."""

    def make(self, folder):
        script = SLIDING + DRIVE.format(log="a.friction") + "run 60\nwrite_restart a.restart\n"
        (folder / "in.first").write_text(script)
        done = run(self.drill.lmp("in.first"), folder)
        if done.code != 0:
            sys.exit(f"no restart file: {done.line}")
        (folder / "in.next").write_text(CONTINUED.format(file="a.restart", log="a.friction"))
        return folder / "a.restart"

    def use(self, folder):
        done = run(self.drill.lmp("in.next"), folder)
        names = ("states.dump", "a.friction")
        return done, done.code == 0 and [(folder / name).read_bytes() for name in names]


class Links(Kind):
    """A file of mca_links write."""

    def make(self, folder):
        (folder / "in.first").write_text(SLIDING + "run 60\nmca_links write a.data\n")
        done = run(self.drill.lmp("in.first"), folder)
        if done.code != 0:
            sys.exit(f"no file of links: {done.line}")
        (folder / "in.next").write_text(READ_LINKS.format(file="a.data"))
        return folder / "a.data"

    def use(self, folder):
        done = run(self.drill.lmp("in.next"), folder)
        return done, done.code == 0 and (folder / "states.dump").read_bytes()


KINDS = {
    "journal": LineJournal,
    "patch_journal": PatchJournal,
    "law": Law,
    "friction_log": Log,
    "restart": Restart,
    "links": Links,
}


def copy_of(folder, drill):
    """The folder with all that a kind made, for one use."""
    import shutil

    fresh = drill.new_folder("flip")
    shutil.rmtree(fresh)
    shutil.copytree(folder, fresh)
    return fresh


def main():
    """Flips all kinds."""
    import shutil

    drill = Drill(__doc__, 12, "flips of each kind of file; 200 in the table of doc/testing.md")
    for name, kind in KINDS.items():
        if not drill.wanted(name):
            continue
        maker = kind(drill)
        folder = drill.new_folder(name)
        path = maker.make(folder)
        good = path.read_bytes()
        work = copy_of(folder, drill)
        done, expected = maker.use(work)
        if done.code != 0:
            sys.exit(f"{name}: the good file is refused: {done.line}")
        for _ in range(drill.given.count):
            changed, how = falsified(good, drill.random)
            shutil.rmtree(work)
            shutil.copytree(folder, work)
            (work / path.relative_to(folder)).write_bytes(changed)
            done, results = maker.use(work)
            wrong = problem(done)
            if wrong:
                drill.fault(name, f"{how}: {wrong}")
            elif done.code != 0:
                drill.count(name, "refused")
            elif results == expected:
                drill.count(name, "same results")
            elif maker.grows and how.startswith("cut"):
                drill.count(name, "shorter")
            else:
                drill.fault(name, f"{how}: accepted, other results")
    drill.end()


if __name__ == "__main__":
    main()
