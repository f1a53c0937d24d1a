# SPDX-License-Identifier: GPL-2.0-or-later
"""No source writes or reads a number by the locale of its host program: printf and its kin know
only text and whole numbers, a stream is given none, and strtod and its kin are not called
(src/shared/plain_number.h has what stands in their place)."""

import os
import re
from pathlib import Path

import pytest

SOURCE = Path(os.environ.get("PROJECT_SOURCE", Path(__file__).resolve().parents[2])) / "src"

PRINTF = re.compile(r"\b(?:v?s?n?f?printf)\s*\(((?:[^()]|\([^()]*\))*)\)")
REAL = re.compile(r"%[-+ #0-9.*']*(?:L|l)*[aefgAEFG]")
READERS = re.compile(r"\b(?:strto(?:d|f|ld)|ato[fil]|std::sto(?:d|f|ld)|f?s?scanf)\s*\(")
# << of a stream: text of a whole file only; a matrix of Eigen is filled so, too
STREAM = re.compile(r"\b(?:std::)?o?stringstream\s+(\w+)")
TAKES = r"(?m)^\s*{name}\s*<<(?!\s*\w+\.rdbuf\(\);)"


def faults(text):
    """What a source does by the locale, a line each."""
    found = [f"printf of a real number: {call[0][:60]}" for call in PRINTF.finditer(text)
             if REAL.search(call[1])]  # fmt: skip
    found += [f"reads by the locale: {call[0]}" for call in READERS.finditer(text)]
    for name in STREAM.findall(text):
        found += [f"stream {name} takes more than a file's text"] * bool(
            re.search(TAKES.format(name=name), text)
        )
    return found


def test_no_source_follows_the_locale():
    wrong = [
        f"{path.relative_to(SOURCE)}: {fault}"
        for path in sorted(SOURCE.rglob("*"))
        if path.suffix in (".h", ".cpp", ".in")
        for fault in faults(path.read_text())
    ]
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize(
    "text",
    [
        'std::snprintf(word.data(), word.size(), "%.*g ", digits, value);',
        'fprintf(fp, "%d %12.4lf\\n", f(i), x);',
        "double x = std::strtod(word, &end);",
        "std::ostringstream text;\n  text.precision(17);\n  text << value << ' ';",
    ],
)
def test_the_check_sees_a_number(text):
    assert faults(text)


@pytest.mark.parametrize(
    "text",
    [
        'std::fprintf(stderr, "%s%s: %d of %d points", a.c_str(), b, done, 5);',
        "std::ostringstream text;\n  text << in.rdbuf();",
        "std::istringstream words(line);\n  while (words >> word)",
    ],
)
def test_the_check_leaves_text_alone(text):
    assert not faults(text)
