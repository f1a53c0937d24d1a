# SPDX-License-Identifier: GPL-2.0-or-later
"""The words of `laws` (doc/pair_mca.md): a preset, and keywords with values; what goes together
lmp checks."""

from mcawr.numbers import decimal
from mcawr.words import known_words

from .located import shown
from .quantities import LEAST, MOST

PRESETS = ("a", "b", "c", "d")
# what a keyword takes: a number of this size at least, if any, or one of these words
VALUES: dict[str, tuple[float | None, tuple[str, ...]]] = {
    "packing": (None, ("hex", "fcc", "hcp", "sc")),
    "thickness": (LEAST, ()),
    "cutoff": (LEAST, ()),
    "plane": (None, ("strain", "stress")),
    "elasticity": (None, ("many-body", "pairwise")),
    "plasticity": (None, ("isochoric", "radial", "none")),
    "flow": (None, ("contacts", "links")),
    "fracture": (
        None,
        ("strain", "stress", "equivalent", "drucker-prager", "mohr-coulomb", "none"),
    ),
    "compressive_strength": (1.0, ("none",)),
    "viscosity": (None, ("both", "normal", "none")),
    "friction": (0.0, ()),
    "steps": (None, ("corrected", "plain")),
    "link": (LEAST, ("elastic_limit", "none")),
    "link_work": (LEAST, ("none",)),
    "weld": (LEAST, ("elastic_limit", "none")),
    "heal": (LEAST, ("hardness", "none")),
    "healed_strain": (LEAST, ("yield_strain", "none")),
    "worn": (None, ("unloaded", "never")),
}


def _is_allowed(value: str, least: float | None, words: tuple[str, ...]) -> bool:
    if value in words:
        return True
    try:
        return least is not None and least <= decimal(value) <= MOST
    except ValueError:
        return False


def wrong(laws: str) -> str | None:
    """What is wrong with the words, and what is allowed; None if nothing is."""
    preset, *pairs = laws.split()
    if preset not in PRESETS:
        return f"preset '{shown(preset)}' is not allowed, must be {', '.join(PRESETS)}"
    for keyword, value in zip(pairs[::2], [*pairs[1::2], ""]):
        if keyword not in VALUES:
            return f"unknown keyword '{shown(keyword)}'{known_words(keyword, VALUES)}"
        least, words = VALUES[keyword]
        if not _is_allowed(value, least, words):
            number = [] if least is None else [f"a number in {least:g} .. {MOST:g}"]
            allowed = ", ".join([*number, *words])
            return f"{keyword}: '{shown(value)}' is not allowed, must be {allowed}"
    return None
