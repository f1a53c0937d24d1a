# SPDX-License-Identifier: GPL-2.0-or-later
"""Help for misspelt words, by the rule of src/shared/nearest_word.h."""

from collections.abc import Iterable


def edit_distance(a: str, b: str) -> int:
    """Insertions, deletions, replacements and swaps of neighbours that turn a into b."""
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        last, before, row = before, row, [i]
        for j, y in enumerate(b, 1):
            row.append(min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (x != y)))
            if i > 1 and j > 1 and x == b[j - 2] and a[i - 2] == y:
                row[j] = min(row[j], last[j - 2] + 1)
    return row[-1]


def nearest(word: str, known: Iterable[str]) -> str:
    """The word at the smallest edit distance, at most a third of the longer one's letters; else the
    shortest that begins with the given one; "" if there is none."""
    near = [(edit_distance(word, k), k) for k in known]
    near = [(distance, k) for distance, k in near if distance <= max(len(word), len(k)) // 3]
    if near:
        return min(near, key=lambda pair: pair[0])[1]
    return min((k for k in known if word and k.startswith(word)), key=len, default="")


def known_words(word: str, known: Iterable[str]) -> str:
    """The end of a message about an unknown word, with "; " before: the nearest word, or all."""
    known = list(known)
    if near := nearest(word, known):
        return f"; the nearest known one is '{near}'"
    return f"; known: {', '.join(known)}" if known else ""
