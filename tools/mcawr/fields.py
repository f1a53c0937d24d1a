# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields of one point of a patch contact: the .vti files of wr_creep."""

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from typing import Any

from .errors import BadInput
from .files import read_bytes
from .numbers import decimal, whole
from .tables import LARGEST

TYPES = {"Float64": "<f8", "UInt8": "u1"}
APART, STICK, SLIP = range(3)


@dataclass
class Fields:
    """Cells of a box; arrays[name] has the shape (ny, nx), vectors (ny, nx, 3). mm, MPa, K."""

    nx: int
    ny: int
    left: float
    bottom: float
    dx: float
    dy: float
    title: str
    arrays: dict = field(default_factory=dict)

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """For matplotlib's imshow with origin="lower"."""
        right = self.left + self.nx * self.dx
        return (self.left, right, self.bottom, self.bottom + self.ny * self.dy)

    def size_of(self, name: str) -> Any:
        """Length of a vector, or the scalar itself."""
        import numpy

        values = self.arrays[name]
        return values if values.ndim == 2 else numpy.hypot(values[..., 0], values[..., 1])


def read_vti(path: str) -> Fields:
    """Fields of a .vti file of wr_creep: cell data, raw, appended. Raises BadInput."""
    content = read_bytes(path)
    mark = b'<AppendedData encoding="raw">'
    begin = content.find(mark)
    first = content.find(b"_", begin + len(mark)) + 1
    if begin < 0 or not first:
        raise BadInput(f"{path}: not VTK image data with raw appended arrays")
    try:
        head = content[:begin].decode("utf-8")
        return _fields_of(path, head, content[first:])
    except (ElementTree.ParseError, UnicodeDecodeError, KeyError, ValueError) as error:
        raise BadInput(f"{path}: not VTK image data of wr_creep: {error}") from None


def _fields_of(path: str, head: str, blocks: bytes) -> Fields:
    tree = ElementTree.fromstring(head + "</VTKFile>")
    image = tree.find("ImageData")
    if image is None or tree.get("header_type") != "UInt64":
        raise ValueError("ImageData with lengths of type UInt64 expected")
    extent = [whole(word) for word in image.get("WholeExtent", "").split()]
    origin = [decimal(word) for word in image.get("Origin", "").split()]
    spacing = [decimal(word) for word in image.get("Spacing", "").split()]
    if len(extent) != 6 or len(origin) != 3 or len(spacing) != 3 or extent[4:] != [0, 0]:
        raise ValueError("extent, origin and spacing of a plane expected")
    nx, ny = extent[1] - extent[0], extent[3] - extent[2]
    if nx < 1 or ny < 1:
        raise ValueError(f"{nx} x {ny} cells")
    if min(spacing[:2]) <= 0 or max(abs(x) for x in (*origin, *spacing)) > LARGEST:
        raise ValueError(f"a raster from {origin} in steps of {spacing}")
    titles = re.findall(r"<!-- (.*?) -->", head)
    title = titles[0] if titles else ""
    result = Fields(nx, ny, origin[0], origin[1], spacing[0], spacing[1], title)
    for array in tree.iter("DataArray"):
        name = array.get("Name")
        result.arrays[str(name)] = _array_of(path, array, blocks, nx, ny)
    return result


def _array_of(path: str, array: ElementTree.Element, blocks: bytes, nx: int, ny: int) -> Any:
    import numpy

    name, kind = array.get("Name"), numpy.dtype(TYPES[array.get("type", "")])
    components, offset = (
        whole(array.get(key, default))
        for key, default in (("NumberOfComponents", "1"), ("offset", ""))
    )
    expected = nx * ny * components * kind.itemsize
    length = int.from_bytes(blocks[offset : offset + 8], "little")
    begin = offset + 8
    if components not in (1, 3) or offset < 0 or length != expected or len(blocks) < begin + length:
        raise BadInput(f"{path}: {name}: {length} bytes, {nx} x {ny} cells need {expected}")
    values = numpy.frombuffer(blocks, kind, nx * ny * components, begin)
    if not (abs(values.astype(float)) <= LARGEST).all():  # nan too
        raise BadInput(f"{path}: {name}: a value that is not a number within +-{LARGEST:g}")
    return values.reshape((ny, nx) if components == 1 else (ny, nx, components))
