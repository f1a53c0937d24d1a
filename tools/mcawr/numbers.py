# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers as everybody reads them: decimal and finite."""

import math
import re

NUMBER = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?")
WHOLE = re.compile(r"[-+]?[0-9]+")


def decimal(text: str) -> float:
    """The number that a text is, blanks around it left out. Raises ValueError for all that is not
    decimal and finite: 0x10, 1_000, "1 500", nan, inf, 1e999."""
    text = text.strip()
    if not NUMBER.fullmatch(text) or math.isinf(value := float(text)):
        raise ValueError(f"'{text[:40]}' is not a finite decimal number")
    return value


def whole(text: str) -> int:
    """The whole number that a text of at most 18 digits is. Raises ValueError."""
    if not WHOLE.fullmatch(text.strip()) or len(text.strip().lstrip("+-")) > 18:
        raise ValueError(f"'{text[:40]}' is not a whole number")
    return int(text)


def finite(value: object) -> float:
    """A value of a JSON file as a float. Raises TypeError, ValueError for all but finite
    numbers."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise TypeError(f"'{str(value)[:40]}' is not a number")
    try:
        value = float(value)
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise ValueError(f"{value} is not a finite number")
    return value
