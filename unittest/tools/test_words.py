# SPDX-License-Identifier: GPL-2.0-or-later
"""Help for misspelt words: the cases of unittest/shared/test_nearest_word.cpp."""

import pytest

from mcawr.words import edit_distance, known_words, nearest

MATERIAL = ["youngs_modulus", "poissons_ratio", "density", "strength", "yield_strain", "viscosity"]


def test_edits():
    pairs = [("creep", "creep"), ("crep", "creep"), ("cerep", "creep"), ("", "abc"), ("abc", "")]
    assert [edit_distance(a, b) for a, b in pairs] == [0, 1, 1, 3, 3]


@pytest.mark.parametrize(
    "word, known, expected",
    [
        ("rms_slpe", ["hurst", "rms_slope", "seed"], "rms_slope"),
        ("viscocity", MATERIAL, "viscosity"),
        ("youngs", MATERIAL, "youngs_modulus"),
        ("s", ["strength", "seed"], "seed"),
        ("seed", ["seeds_of_all", "sed"], "sed"),
        ("youngs", ["strength", "density"], ""),
        ("", MATERIAL, ""),
        ("x", [], ""),
    ],
)
def test_nearest(word, known, expected):
    assert nearest(word, known) == expected


def test_what_there_is_is_listed_where_nothing_is_near():
    assert known_words("strenght", MATERIAL) == "; the nearest known one is 'strength'"
    assert known_words("mass", ["density", "strength"]) == "; known: density, strength"
    assert known_words("mass", []) == ""
