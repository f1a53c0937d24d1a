# SPDX-License-Identifier: GPL-2.0-or-later
"""How a script ends: one clear line and an exit code, the same for all programs of the project."""

import enum
import errno
import os
import signal
import subprocess
import sys
import traceback
from collections.abc import Callable
from typing import NoReturn, TextIO

from . import programs

TOOLS = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))


class Exit(enum.IntEnum):
    """Exit codes."""

    OK = 0
    INTERNAL = 1  # also: a Python package is missing, a run failed
    USAGE = 2
    BAD_INPUT = 3
    NOT_CONVERGED = 4
    IO = 5
    INTERRUPTED = 6


class Failure(Exception):
    """One clear line for the user, and the exit code."""

    def __init__(self, code: int, text: object) -> None:
        super().__init__(str(text))
        self.code = code


class BadInput(Failure):
    """What is wrong in an input file: file, line, what stands there and what is allowed; of a long
    text, which what stands there may be, beginning and end."""

    def __init__(self, text: object) -> None:
        text = str(text)
        super().__init__(
            Exit.BAD_INPUT, text if len(text) <= 1000 else f"{text[:700]} ... {text[-200:]}"
        )


class OutputLost(Failure):
    """Standard output that nobody takes any more: a closed pipe, a full disk."""

    def __init__(self, error: OSError) -> None:
        super().__init__(Exit.IO, f"standard output: cannot be written: {error.strerror}")


def one_line(text: object) -> str:
    """The text as one line for a terminal: what cannot be printed is written as an escape."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in str(text).strip())


def fail(code: int, text: object) -> NoReturn:
    """Ends the script with this line. Raises Failure."""
    raise Failure(code, text)


def built(name: str) -> str:
    """Path of wr_fit or wr_creep. Raises Failure where it is not built."""
    path = programs.program(name)
    if not (os.path.isfile(path) and os.access(path, os.X_OK)):
        fail(Exit.IO, f"{path}: is not there: build it (tools/setup.sh)")
    return path


def fail_as(program: str, done: subprocess.CompletedProcess[str]) -> NoReturn:
    """Ends the script as a program that it called ended: with its exit code and its last line.
    Raises Failure."""
    code = done.returncode if done.returncode > 0 else Exit.INTERNAL
    last = (done.stderr.strip() or f"{program}: ended with code {done.returncode}").splitlines()[-1]
    raise Failure(code, last)


def missing(error: ImportError, package: str = "a Python package") -> Failure:
    """The failure for an ImportError: which package is not installed, or does not work."""
    name = (error.name or package).partition(".")[0]
    debian = {"yaml": "python3-yaml", "PIL": "python3-pil"}.get(name, f"python3-{name}")
    return Failure(Exit.INTERNAL, f"{name} is missing (Debian: apt-get install {debian})")


def complain(text: object) -> None:
    """One line on standard error, if anybody takes it."""
    if sys.stderr is None:  # closed by the caller
        return
    try:
        program = os.path.basename(sys.argv[0])
        print(f"{program}: {one_line(text)}", file=sys.stderr, flush=True)
    except OSError:
        _discard(sys.stderr)


def say(text: object, end: str = "\n") -> None:
    """Prints, and makes sure that it arrives. Raises OutputLost."""
    try:
        if sys.stdout is None:  # closed by the caller
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        print(text, end=end, flush=True)
    except OSError as error:
        _discard(sys.stdout)
        raise OutputLost(error) from None


def _discard(stream: TextIO | None) -> None:
    """What a stream still holds goes nowhere: else the interpreter would try again at its end."""
    if stream is None:
        return
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    except (AttributeError, OSError, ValueError):
        pass


def _internal(error: BaseException) -> Failure:
    """The failure for an error that nothing else takes: what, and where in our sources."""
    ours = [f for f in traceback.extract_tb(error.__traceback__) if f.filename.startswith(TOOLS)]
    at = f"{os.path.relpath(ours[-1].filename, TOOLS)}:{ours[-1].lineno}: " if ours else ""
    return Failure(
        Exit.INTERNAL,
        f"internal error: {at}{type(error).__name__}: {error}; please report it "
        "(MCAWR_TRACEBACK=1 shows where)",
    )


def _end(*_: object) -> NoReturn:
    raise KeyboardInterrupt


def run_script(main: Callable[[], int | None]) -> NoReturn:
    """Calls main() and ends the script: with its return value (None: 0), or with one line.

    With --version as the only argument the script prints its name, version and commit instead.
    What main prints is written out here, so that a full disk or a closed pipe is noticed. SIGTERM
    ends it as Ctrl-C does: in order.
    """
    code: int | str | None
    signal.signal(signal.SIGTERM, _end)
    try:
        if sys.argv[1:] == ["--version"]:
            say(f"{os.path.basename(sys.argv[0])} {programs.version()}")
            code = Exit.OK
        else:
            code = main() or Exit.OK
    except SystemExit as leave:  # argparse: --help, or a usage error
        code = leave.code
    except Failure as failure:
        complain(failure)
        code = failure.code
    except KeyboardInterrupt:
        complain("interrupted")
        code = Exit.INTERRUPTED
    except MemoryError:
        complain("out of memory")
        code = Exit.INTERNAL
    except Exception as error:
        if os.environ.get("MCAWR_TRACEBACK"):
            raise
        end = _failure_of(error)
        complain(end)
        code = end.code
    try:
        if sys.stdout is not None:
            sys.stdout.flush()
    except OSError as error:
        _discard(sys.stdout)
        if code in (None, Exit.OK):
            complain(OutputLost(error))
            code = Exit.IO
    sys.exit(code)


def _failure_of(error: Exception) -> Failure:
    if isinstance(error, ImportError) and error.name:
        return missing(error)
    if isinstance(error, OSError) and error.filename is not None:
        return Failure(Exit.IO, f"{error.filename}: {error.strerror or error}")
    return _internal(error)
