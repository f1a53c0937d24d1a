# SPDX-License-Identifier: GPL-2.0-or-later
"""YAML as a plan needs it: every value with its line, and numbers only as everybody reads them."""

import math
import re
import typing
from typing import Any

import yaml

from mcawr.errors import BadInput

WORDS = ("name",)  # keys whose value is a word, even where it looks like a number
DEPTH = 4  # plan, runs, run, list of values, value
NUMBER = re.compile(r"[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?")


class PlanError(BadInput):
    """One clear line: file, line, key, value given, what is allowed."""


class Given(typing.NamedTuple):
    """What a plan says, and where: None, text, a number, a list of Given, or a dict of Given. A
    value in a dict has the line of its key."""

    line: int
    value: Any


def scalar(text: str) -> str | int | float:
    """The number that a word is, if it is a decimal one; else the word. YAML 1.1 would take 010 for
    8, 1:30 for 90 and 1e-5 for text."""
    if not NUMBER.fullmatch(text) or math.isinf(number := float(text)):
        return text
    return int(text) if text.lstrip("+-").isdecimal() and abs(number) < 2**53 else number


def shown(value: object) -> str:
    """A value for a message."""
    text = (
        "[...]" if isinstance(value, list) else "{...}" if isinstance(value, dict) else str(value)
    )
    return text if len(text) <= 60 else text[:57] + "..."


class DecimalComma(yaml.MarkedYAMLError):
    """What YAML takes for two values and nobody means."""


def _refuse_decimal_comma(words: list[yaml.Node]) -> None:
    """'[15, 22,5]' is three numbers to YAML: a whole number, a comma without a blank, and digits,
    in a list that has blanks elsewhere or with a zero before them."""
    if not all(isinstance(word, yaml.ScalarNode) for word in words):
        return
    tight = [a.end_mark.index + 1 == b.start_mark.index for a, b in zip(words, words[1:])]
    for a, b, is_tight in zip(words, words[1:], tight):
        sure = not all(tight) or re.fullmatch(r"0[0-9]+", b.value)
        if is_tight and sure and re.fullmatch(r"[-+]?[0-9]+,[0-9]+", f"{a.value},{b.value}"):
            raise DecimalComma(
                problem=f"'{a.value},{b.value}' has a decimal comma; a point is expected, and a "
                "blank after each comma of a list",
                problem_mark=a.start_mark,
            )


def _given(node: yaml.Node, depth: int = 0, is_word: bool = False) -> Given:
    mark = node.start_mark
    if depth > DEPTH:
        raise yaml.MarkedYAMLError(problem="nested too deep", problem_mark=mark)
    if isinstance(node, yaml.SequenceNode):
        _refuse_decimal_comma(node.value)
        return Given(mark.line + 1, [_given(item, depth + 1) for item in node.value])
    if isinstance(node, yaml.ScalarNode):
        if not node.style and node.value in ("", "~", "null"):
            return Given(mark.line + 1, None)
        quoted = node.style is not None
        return Given(mark.line + 1, node.value if quoted or is_word else scalar(node.value))
    result = {}
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            raise yaml.MarkedYAMLError(problem="a key must be a word", problem_mark=key.start_mark)
        if key.value in result:
            raise yaml.MarkedYAMLError(
                problem=f"key '{key.value}' appears twice", problem_mark=key.start_mark
            )
        found = _given(value, depth + 1, key.value in WORDS)
        result[key.value] = Given(key.start_mark.line + 1, found.value)
    return Given(mark.line + 1, result)


def read_yaml(path: str, text: str) -> Given:
    """What a YAML file says. Raises PlanError."""
    # PyYAML takes seconds for what no plan holds: its time grows as the square of the depth
    if found := re.search(r"([\[{]\s*){100}", text):
        line = text.count("\n", 0, found.start()) + 1
        raise PlanError(f"{path}:{line}: not YAML: nested too deep")
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
        return _given(node) if node else Given(1, None)
    except RecursionError:
        raise PlanError(f"{path}:1: not YAML: nested too deep") from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = (mark.line if mark else text.count("\n", 0, getattr(error, "position", 0))) + 1
        problem = getattr(error, "problem", None) or str(error).splitlines()[0]
        what = "" if isinstance(error, DecimalComma) else "not YAML: "
        raise PlanError(f"{path}:{line}: {what}{problem}") from None
