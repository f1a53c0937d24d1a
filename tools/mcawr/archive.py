# SPDX-License-Identifier: GPL-2.0-or-later
"""Archives of a campaign's logs and profiles: files side by side in a tar file that is compressed
by xz. wr_fit reads them by the same rules."""

import io
import lzma
import os
import tarfile

from .errors import BadInput

ENDING = ".tar.xz"
LARGEST = 256  # MiB, of all that an archive holds; wr_fit has the same
END = 1024  # zero bytes at the end of every tar file


def is_archive(path: str) -> bool:
    """Whether a path is that of an archive; there need not be a file of that name."""
    return path.endswith(ENDING) and not os.path.isdir(path)


def inside(path: str) -> tuple[str, str] | None:
    """(archive, name) of a path that leads into one, like paper36.tar.xz/r01.friction; None of
    other paths."""
    folder, name = os.path.split(path)
    return (folder, name) if name and is_archive(folder) else None


def pack(members: dict[str, str]) -> bytes:
    """Bytes of an archive of {name: text}; equal members give equal bytes."""
    tar = io.BytesIO()
    with tarfile.open(fileobj=tar, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name in sorted(members):
            content = members[name].encode()
            head = tarfile.TarInfo(name)  # of no owner and no time, to be read by all
            head.size = len(content)
            archive.addfile(head, io.BytesIO(content))
    return lzma.compress(tar.getvalue(), preset=9 | lzma.PRESET_EXTREME)


def unpack(path: str, content: bytes) -> dict[str, bytes]:
    """{name: bytes} of an archive's content. Raises BadInput: it is damaged, cut or larger than
    LARGEST, or a member is no regular file with a plain name."""
    tar = _decompressed(path, content)
    if not tar.endswith(bytes(END)):
        raise _cannot(path, "is not a whole tar file: its end is missing")
    members: dict[str, bytes] = {}
    try:
        with tarfile.open(fileobj=io.BytesIO(tar), mode="r:") as archive:
            for head in archive:
                _check(path, head, members)
                file = archive.extractfile(head)
                members[head.name] = file.read() if file else b""
            if tar[archive.offset :].strip(b"\0"):  # where the reader ended without an error
                raise tarfile.ReadError
    except (tarfile.TarError, ValueError, OverflowError):
        raise _cannot(path, "is damaged or cut") from None
    return members


def _decompressed(path: str, content: bytes) -> bytes:
    if not content.startswith(b"\xfd7zXZ\0"):
        raise _cannot(path, "is not compressed by xz")
    try:
        with lzma.open(io.BytesIO(content), format=lzma.FORMAT_XZ) as file:
            tar = file.read(LARGEST * 2**20 + 1)
    except (lzma.LZMAError, EOFError):
        raise _cannot(path, "is damaged or cut") from None
    if len(tar) > LARGEST * 2**20:
        raise _cannot(
            path,
            f"holds more than {LARGEST} MiB: pack fewer runs into one, or more rows into one "
            "(--rows)",
        )
    return tar


def _check(path: str, head: tarfile.TarInfo, members: dict[str, bytes]) -> None:
    """A member, before it is read."""
    name = head.name
    if not head.isreg() or head.issparse() or "/" in name or name in ("", ".", ".."):
        raise _cannot(path, f"member '{name}' is not allowed, must be a file with a plain name")
    if name in members:
        raise _cannot(path, f"member '{name}' is there twice")


def _cannot(path: str, why: str) -> BadInput:
    return BadInput(f"{path}: cannot be unpacked: {why}")
