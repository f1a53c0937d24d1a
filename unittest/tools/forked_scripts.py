# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of the project's Python scripts, each in a copy of this process, which has imported their
packages: the start of Python and matplotlib is spared, and no run sees what another did."""

import os
import runpy
import signal
import subprocess
import sys
import time
import traceback


def load_packages():
    """What copies shall have in memory: matplotlib for pictures without a screen, numpy, yaml."""
    os.environ["MPLBACKEND"] = "agg"
    import matplotlib
    import matplotlib.pyplot
    import numpy
    import yaml

    return matplotlib, numpy, yaml


def run(command, folder, patience=120.0, **environment):
    """As subprocess.run() of [SCRIPT, words] in a folder, with its output as text and with these
    variables of the environment, too. The exit code is None where the run was ended."""
    load_packages()
    names = [os.path.join(folder, ".out"), os.path.join(folder, ".err")]
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child == 0:
        os.environ.update(environment)
        _become(list(map(str, command)), folder, *names)
    code = _wait(child, patience)
    texts = []
    for name in names:
        with open(name, "rb") as file:
            texts.append(file.read().decode("utf-8", "replace"))
        os.unlink(name)
    return subprocess.CompletedProcess(command, code, *texts)


def _wait(child, patience):
    """Exit code of a child; None when it had to be killed."""
    end = time.monotonic() + patience
    while time.monotonic() < end:
        found, status = os.waitpid(child, os.WNOHANG)
        if found:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.002)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    return None


def _become(command, folder, out, err):
    """The rest of a copy's life: the script. Does not return."""
    code = 1
    try:
        os.setsid()
        os.chdir(folder)
        streams = [os.open("/dev/null", os.O_RDONLY)]
        streams += [os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC) for name in (out, err)]
        for number, stream in enumerate(streams):
            os.dup2(stream, number)
        os.closerange(3, 64)
        # a test's own streams do not lead to these files
        sys.stdout = open(1, "w", encoding="utf-8", closefd=False)
        sys.stderr = open(2, "w", encoding="utf-8", closefd=False)
        sys.argv = command
        runpy.run_path(command[0], run_name="__main__")
        code = 0
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            code = end.code or 0
        else:
            print(end.code, file=sys.stderr)
    except BaseException:  # as the interpreter would
        traceback.print_exc()
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    finally:
        os._exit(code)
