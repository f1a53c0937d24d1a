# SPDX-License-Identifier: GPL-2.0-or-later
"""matplotlib without a screen; films of pictures."""

import io
from typing import Any

from .errors import missing


def pyplot() -> Any:
    """The module matplotlib.pyplot. Raises Failure (1) without matplotlib."""
    try:
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib import pyplot as module
    except ImportError as error:
        raise missing(error, "matplotlib") from None
    return module


def film(pages: list[bytes], rate: float) -> bytes:
    """Bytes of a GIF that shows pictures (PNG) in turn. Raises Failure (1) without Pillow.

    rate: pictures per second.
    """
    try:
        from PIL import Image
    except ImportError as error:
        raise missing(error) from None
    images = [
        Image.open(io.BytesIO(page)).convert("P", palette=Image.Palette.ADAPTIVE) for page in pages
    ]
    content = io.BytesIO()
    images[0].save(
        content,
        format="GIF",
        save_all=True,
        append_images=images[1:],
        duration=round(1000 / rate),
        loop=0,
    )
    return content.getvalue()
