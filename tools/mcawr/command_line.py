# SPDX-License-Identifier: GPL-2.0-or-later
"""Command lines of the scripts: one way to read numbers, one line for what is wrong."""

import argparse
import re
from collections.abc import Callable
from typing import Any, NoReturn

from . import numbers
from .errors import Exit, complain

SIZES = (1e-12, 1e12)  # far beyond what a script can draw or run


class Parser(argparse.ArgumentParser):
    """A command line whose help is the script's docstring as it stands; a usage error is one line
    (exit code 2). Options are written in full."""

    def __init__(self, doc: str | None = None, **more: Any) -> None:
        super().__init__(
            description=doc,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
            **more,
        )
        # what argparse takes for a value that is no option: -1e-3, -inf and -nan too, so that they
        # are refused for what they are
        self._negative_number_matcher = re.compile(r"-\.?[0-9]|-inf|-nan", re.IGNORECASE)

    def error(self, message: str) -> NoReturn:
        complain(f"{message}; see --help")
        self.exit(Exit.USAGE)


def _checked(
    read: Callable[[str], Any], text: str, allowed: str, is_in: Callable[[Any], bool]
) -> Any:
    try:
        value = read(text)
    except ValueError:
        value = None
    if value is None or not is_in(value):
        raise argparse.ArgumentTypeError(f"'{text}': {allowed} is needed")
    return value


def number_in(
    least: float = SIZES[0], most: float = SIZES[1], unit: str = ""
) -> Callable[[str], float]:
    """Type of an option that takes a number in least .. most."""
    allowed = f"a number in {least:g} .. {most:g}" + (f" ({unit})" if unit else "")
    return lambda text: _checked(numbers.decimal, text, allowed, lambda x: least <= x <= most)


def whole_in(least: int, most: int) -> Callable[[str], int]:
    """Type of an option that takes a whole number in least .. most."""
    allowed = f"a whole number in {least} .. {most}"
    return lambda text: _checked(numbers.whole, text, allowed, lambda n: least <= n <= most)


def file_name(text: str) -> str:
    """Type of an option that takes the name of a file, a folder or a program."""
    if not text or "\0" in text:
        raise argparse.ArgumentTypeError(f"'{text}': a name is needed")
    return text
