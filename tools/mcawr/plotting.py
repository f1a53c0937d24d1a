# SPDX-License-Identifier: GPL-2.0-or-later
"""matplotlib without a screen."""

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
