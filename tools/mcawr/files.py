# SPDX-License-Identifier: GPL-2.0-or-later
"""The one way to write a file: whole or not at all."""

import contextlib
import io
import os
import stat

from .errors import Exit, Failure


def _cannot(path, error):
    return Failure(Exit.IO, f"{path}: cannot be written: {error.strerror or error}")


def _target(path):
    """(what is written, its permissions or None) of a regular file or a new one, through links;
    None of a device, a pipe or a socket, and of the names of open files (/dev/stdout)."""
    folder = os.path.realpath(os.path.dirname(path) or ".")
    if folder == "/dev" or folder.startswith(("/dev/fd", "/proc/")):
        return None
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError:  # new, or a link that leads to no file yet
        return os.path.realpath(path), None
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(21, "Is a directory", path)
    if not stat.S_ISREG(mode):
        return None
    if not os.access(path, os.W_OK):  # a rename would not care
        raise PermissionError(13, "Permission denied", path)
    return os.path.realpath(path), stat.S_IMODE(mode)


def _write_all(descriptor, content):
    view = memoryview(content)
    while view:
        view = view[os.write(descriptor, view) :]


def write(path, content):
    """Writes a file whole or not at all; content is text or bytes.

    A regular file, or the one that a link leads to, is written beside and renamed, and keeps its
    permissions; after a failure it is what it was, and nothing is left beside it. A device or a
    pipe is written into: a file renamed over it would take its place. Raises Failure (5).
    """
    content = content.encode() if isinstance(content, str) else content
    path = os.fspath(path)
    try:
        target = _target(path)
        if target is None:
            descriptor = os.open(path, os.O_WRONLY | os.O_CLOEXEC)
            try:
                _write_all(descriptor, content)
            finally:
                os.close(descriptor)
        else:
            _replace(*target, content)
    except OSError as error:
        raise _cannot(path, error) from None


def _replace(target, permissions, content):
    folder, name = os.path.split(target)
    beside = os.path.join(folder, f".{name[:50]}.{os.getpid()}.part")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC
    descriptor = os.open(beside, flags, 0o666)
    try:
        try:
            _write_all(descriptor, content)
            if permissions is not None:
                os.fchmod(descriptor, permissions)
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        os.replace(beside, target)
    except BaseException:  # also an interrupt
        with contextlib.suppress(OSError):
            os.remove(beside)
        raise


def move(source, path):
    """Puts a finished file in the place of path, as write does. Raises Failure (5)."""
    try:
        target = _target(path)
        if target is None:
            with open(source, "rb") as file:
                write(path, file.read())
        else:
            os.replace(source, target[0])
    except OSError as error:
        raise _cannot(path, error) from None


def make_folder(path):
    """The folder and its parents. Raises Failure (5)."""
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise Failure(Exit.IO, f"{path}: cannot be made: {error.strerror}") from None


def save_figure(figure, path, dpi=130):
    """Writes a figure of matplotlib, in the format that the name ends in (without an ending: PNG),
    and closes it. Raises Failure: 2 for a format that there is not, else 5."""
    from matplotlib import pyplot

    kind = os.path.splitext(path)[1].lstrip(".").lower() or "png"
    known = figure.canvas.get_supported_filetypes()
    if kind not in known:
        raise Failure(
            Exit.USAGE, f"{path}: '.{kind}' is no picture; known: {' '.join(sorted(known))}"
        )
    page = io.BytesIO()
    figure.savefig(page, dpi=dpi, format=kind)
    pyplot.close(figure)
    write(path, page.getvalue())
