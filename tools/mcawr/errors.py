# SPDX-License-Identifier: GPL-2.0-or-later
"""How a script ends: one clear line and an exit code, the same for all programs of the project."""

import enum
import os
import sys


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

    def __init__(self, code, text):
        super().__init__(str(text))
        self.code = code


class BadInput(Failure):
    """What is wrong in an input file: file, line, what stands there and what is allowed."""

    def __init__(self, text):
        super().__init__(Exit.BAD_INPUT, text)


class OutputLost(Failure):
    """Standard output that nobody takes any more: a closed pipe, a full disk."""

    def __init__(self, error):
        super().__init__(Exit.IO, f"standard output: cannot be written: {error.strerror}")


def one_line(text):
    """The text as one line for a terminal: what cannot be printed is written as an escape."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in str(text).strip())


def fail(code, text):
    """Ends the script with this line. Raises Failure."""
    raise Failure(code, text)


def missing(error, package="a Python package"):
    """The failure for an ImportError: which package is not installed, or does not work."""
    name = (error.name or package).partition(".")[0]
    debian = {"yaml": "python3-yaml", "PIL": "python3-pil"}.get(name, f"python3-{name}")
    return Failure(Exit.INTERNAL, f"{name} is missing (Debian: apt-get install {debian})")


def complain(text):
    """One line on standard error, if anybody takes it."""
    try:
        print(f"{os.path.basename(sys.argv[0])}: {one_line(text)}", file=sys.stderr, flush=True)
    except OSError:
        _discard(sys.stderr)


def say(text, end="\n"):
    """Prints, and makes sure that it arrives. Raises OutputLost."""
    try:
        print(text, end=end, flush=True)
    except OSError as error:
        _discard(sys.stdout)
        raise OutputLost(error) from None


def _discard(stream):
    """What a stream still holds goes nowhere: else the interpreter would try again at its end."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    except (OSError, ValueError):
        pass


def run_script(main):
    """Calls main() and ends the script: with its return value (None: 0), or with one line.

    What main prints is written out here, so that a full disk or a closed pipe is noticed.
    """
    try:
        code = main() or Exit.OK
    except SystemExit as end:  # argparse: --help, or a usage error
        code = end.code
    except Failure as failure:
        complain(failure)
        code = failure.code
    except ImportError as error:
        if not error.name:
            raise
        complain(missing(error))
        code = Exit.INTERNAL
    except KeyboardInterrupt:
        complain("interrupted")
        code = Exit.INTERRUPTED
    except OSError as error:
        # of print(), which names no file
        text = f"{error.filename or 'standard output'}: {error.strerror or error}"
        complain(text)
        code = Exit.IO
    try:
        sys.stdout.flush()
    except OSError as error:
        _discard(sys.stdout)
        if code in (None, Exit.OK):
            complain(OutputLost(error))
            code = Exit.IO
    sys.exit(code)
