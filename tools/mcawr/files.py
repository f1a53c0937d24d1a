# SPDX-License-Identifier: GPL-2.0-or-later
"""The one way to write a file, whole or not at all, and to read one."""

import codecs
import contextlib
import functools
import io
import os
import pathlib
import secrets
import stat
from collections.abc import Iterable, Mapping
from typing import Any

from . import archive
from .errors import BadInput, Exit, Failure, one_line

Path = str | os.PathLike[str]
Content = str | bytes | pathlib.Path  # the last: of a finished file


def _cannot(path: Path, error: OSError) -> Failure:
    return Failure(Exit.IO, f"{path}: cannot be written: {error.strerror or error}")


def _target(path: str) -> tuple[str, int | None] | None:
    """(what is written, its permissions or None) of a regular file or a new one, through links;
    None of a device, a pipe or a socket, and of the names of open files (/dev/stdout)."""
    if path.endswith(os.sep):
        raise IsADirectoryError(21, "Is a directory", path)
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


def _write_into(path: Path, content: bytes) -> None:
    """Into a device or a pipe."""
    descriptor = os.open(path, os.O_WRONLY | os.O_CLOEXEC)
    try:
        _write_bytes(descriptor, content)
    finally:
        os.close(descriptor)


def _write_bytes(descriptor: int, content: bytes) -> None:
    view = memoryview(content)
    while view:
        view = view[os.write(descriptor, view) :]


def _write_beside(target: str, permissions: int | None, content: bytes) -> str:
    """Name of a new file in the target's folder that holds the content."""
    folder, name = os.path.split(target)
    beside = os.path.join(folder, f".{name[:50]}.{secrets.token_hex(4)}.part")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC
    descriptor = os.open(beside, flags, 0o666)
    try:
        try:
            _write_bytes(descriptor, content)
            if permissions is not None:
                os.fchmod(descriptor, permissions)
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
    except BaseException:  # also an interrupt
        _remove(beside)
        raise
    return beside


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        os.remove(path)


def write(path: Path, content: Content) -> None:
    """Writes a file whole or not at all; content is text or bytes.

    A regular file, or the one that a link leads to, is written beside and renamed, and keeps its
    permissions; after a failure it is what it was, and nothing is left beside it. A device or a
    pipe is written into: a file renamed over it would take its place. Raises Failure (5).
    """
    write_all({path: content})


def write_all(contents: Mapping[Any, Content]) -> None:
    """Writes several files, as write does: all of them or none (only a failing rename, or what a
    device has taken already, cannot be undone).

    contents: {path: text, bytes or the pathlib.Path of a finished file, which is moved there}.
    Raises Failure (5).
    """
    beside: list[tuple[Path, Path, str]] = []  # what is written, where it is now, its place
    into: list[tuple[Path, bytes]] = []
    path: Path = ""
    try:
        for path, content in contents.items():
            target = _target(os.fspath(path))
            if target and isinstance(content, pathlib.Path) and _same_disk(content, target[0]):
                beside.append((path, content, target[0]))
            elif target:
                beside.append((path, _write_beside(*target, _bytes_of(content)), target[0]))
            else:
                into.append((path, _bytes_of(content)))
        for path, content in into:
            _write_into(path, content)
        while beside:
            path, part, place = beside[0]
            os.replace(part, place)
            beside.pop(0)
    except OSError as error:
        raise _cannot(path, error) from None
    finally:
        for _, part, _ in beside:
            _remove(part)


def replace_all(contents: Mapping[Any, Content], former: Iterable[Path]) -> None:
    """Writes several files, as write_all does, in place of those of an earlier call: of these,
    what is not written anew is removed. Raises Failure (5)."""
    write_all(contents)
    kept = {os.path.realpath(path) for path in contents}
    for path in former:
        if os.path.realpath(path) not in kept and os.path.isfile(path):
            _remove(path)


def _bytes_of(content: Content) -> bytes:
    if isinstance(content, pathlib.Path):
        return content.read_bytes()
    return content.encode() if isinstance(content, str) else content


def _same_disk(source: pathlib.Path, target: str) -> bool:
    return source.stat().st_dev == os.stat(os.path.dirname(target)).st_dev


def check_apart(inputs: Iterable[Path], outputs: Iterable[Path | None]) -> None:
    """No output (None: not asked for) is an input or another output. Raises Failure (2)."""
    places = {os.path.realpath(_on_disk(path)): "is read too" for path in inputs}
    for path in outputs:
        if path is None or (os.path.exists(path) and not os.path.isfile(path)):
            continue
        if wrong := places.get(os.path.realpath(path)):
            raise Failure(Exit.USAGE, f"{path}: cannot be written: {wrong}: give another name")
        places[os.path.realpath(path)] = "is the name of another result"


def read_bytes(path: Path) -> bytes:
    """What stands in a regular file, or in one of an archive like paper36.tar.xz/r01.friction.
    Raises BadInput."""
    found = archive.inside(os.fspath(path))
    if not found:
        return _read_file(path)
    try:
        return _members(found[0])[found[1]]
    except KeyError:
        raise BadInput(f"{path}: cannot be read: no such file in the archive") from None


def is_there(path: Path) -> bool:
    """Whether read_bytes finds such a file; raises BadInput for an archive that it cannot read."""
    found = archive.inside(os.fspath(path))
    return found[1] in _members(found[0]) if found else os.path.exists(path)


@functools.cache
def _members(path: str) -> dict[str, bytes]:
    """All that an archive holds; it is unpacked once."""
    return archive.unpack(path, _read_file(path))


def _on_disk(path: Path) -> Path:
    """The file that a path leads to: the archive of one in an archive."""
    found = archive.inside(os.fspath(path))
    return found[0] if found else path


def _read_file(path: Path) -> bytes:
    """The bytes of a regular file only: of a device or a pipe there might be no end."""
    try:
        with open(path, "rb", opener=open_now) as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise BadInput(f"{path}: cannot be read: is not a regular file")
            return file.read()
    except OSError as error:
        raise BadInput(f"{path}: cannot be read: {error.strerror}") from None


def open_now(path: str, flags: int) -> int:
    """An opener that does not wait for somebody to write into a pipe."""
    return os.open(path, flags | os.O_NONBLOCK)


def _zeros(content: bytes, text: str) -> str:
    """What a text with zeros is: UTF-16 has one for each letter and digit, UTF-32 three."""
    if content[:4] in (codecs.BOM_UTF32_LE, codecs.BOM_UTF32_BE):
        return "is UTF-32; save it as UTF-8"
    zeros = content[:64].count(0)
    if 3 * zeros >= len(content[:64]) and 2 * zeros <= len(content[:64]) + 2:
        return "is UTF-16 without a byte order mark; save it as UTF-8"
    return f"is binary, not text: character {text.index(chr(0)) + 1} is 0"


def read_text(path: Path) -> str:
    """The text of a regular file or of one in an archive, UTF-8 or UTF-16 with a byte order mark;
    its lines end with \\n, whatever they end with there. Raises BadInput."""
    content = read_bytes(path)
    marked = content[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
    try:
        text = content.decode("utf-16" if marked else "utf-8-sig")
    except UnicodeDecodeError as error:
        code = "UTF-16" if marked else "UTF-8"
        raise BadInput(f"{path}: cannot be read: byte {error.start + 1} is not {code}") from None
    if "\0" in text:
        raise BadInput(f"{path}: cannot be read: {_zeros(content, text)}")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def make_folder(path: Path) -> None:
    """The folder and its parents. Raises Failure (5)."""
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise Failure(Exit.IO, f"{path}: cannot be made: {error.strerror}") from None


def check_size(figure: Any, dpi: float) -> None:
    """Raises Failure (2) where a picture would have more than a hundred million points."""
    width, height = (size * dpi for size in figure.get_size_inches())
    if not width * height <= 1e8:
        raise Failure(Exit.USAGE, f"a picture of {width:.4g} x {height:.4g} points is too large")


def picture(figure: Any, path: str, dpi: float = 130, kind: str = "png") -> bytes:
    """Bytes of a figure of matplotlib in the format that the path ends in (without an ending:
    kind); closes it. Raises Failure: 2 for a format that there is not, 3 for what cannot be
    drawn."""
    from matplotlib import pyplot
    from matplotlib.text import Text

    kind = (os.path.splitext(path)[1].lstrip(".") or kind).lower()
    known = figure.canvas.get_supported_filetypes()
    if kind not in known:
        raise Failure(
            Exit.USAGE, f"{path}: '.{kind}' is not a picture; known: {' '.join(sorted(known))}"
        )
    check_size(figure, dpi)
    for text in figure.findobj(Text):  # of files and of the command line
        text.set_text("\n".join(map(one_line, text.get_text().split("\n"))))
    page = io.BytesIO()
    try:
        figure.savefig(page, dpi=dpi, format=kind)
    except (ValueError, ArithmeticError, RuntimeError) as error:  # sizes, formulas in labels
        raise Failure(Exit.BAD_INPUT, f"{path}: cannot be drawn: {error}") from None
    pyplot.close(figure)
    return page.getvalue()


def save_figure(figure: Any, path: str, dpi: float = 130, kind: str = "png") -> None:
    """Writes a figure of matplotlib and closes it. Raises Failure, as picture and write do."""
    write(path, picture(figure, path, dpi, kind))
