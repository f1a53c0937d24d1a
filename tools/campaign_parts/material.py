# SPDX-License-Identifier: GPL-2.0-or-later
"""Potential files (doc/potential_file.md) for plans: the quantities of a material in the plan's
units."""

from mcawr.errors import BadInput
from mcawr.files import read_text
from mcawr.numbers import decimal
from mcawr.words import known_words

from .located import shown
from .quantities import KEYS

# keyword of the file: (key of the plan, dimension)
QUANTITIES = {
    "youngs_modulus": ("E", "stress"),
    "poissons_ratio": ("nu", ""),
    "density": ("rho", "density"),
    "strength": ("strength", "stress"),
    "elastic_limit": ("elastic_limit", ""),
    "yield_strength": ("yield_strength", ""),
    "yield_strain": ("yield_strain", ""),
    "breaking_strain": ("breaking_strain", ""),
    "viscosity": ("eta", "viscosity"),
    "diameter": ("d", "length"),
}
# what a file's unit is in the plan's: MPa, kg/m3, Pa s, nm
UNITS = {
    "nano": {"stress": 1.0, "density": 1e6, "viscosity": 1e-3, "length": 1.0},
    "si": {"stress": 1e-6, "density": 1.0, "viscosity": 1.0, "length": 1e9},
    "micro": {"stress": 1e-3, "density": 1e3, "viscosity": 1e-3, "length": 1e3},
    "cgs": {"stress": 1e-7, "density": 1e3, "viscosity": 0.1, "length": 1e7},
}


def read(path):
    """{key of the plan: value}. Raises BadInput, with the line."""
    lines = read_text(path).split("\n")
    head = lines[0].split()
    units = head[head.index("UNITS:") + 1] if "UNITS:" in head[:-1] else None
    if units not in UNITS:
        raise BadInput(
            f"{path}:1: 'UNITS: STYLE' with {', '.join(UNITS)} is needed, not '{shown(units)}'"
        )
    found = {}
    for number, line in enumerate(lines[1:], 2):
        words = line.partition("#")[0].split()
        if not words:
            continue
        keyword, *value = words
        if keyword not in QUANTITIES:
            raise BadInput(
                f"{path}:{number}: unknown keyword '{shown(keyword)}'"
                f"{known_words(keyword, QUANTITIES)}"
            )
        key, dimension = QUANTITIES[keyword]
        if key in found:
            raise BadInput(f"{path}:{number}: {keyword} appears twice")
        allowed = f"a number {KEYS[key].allowed}"
        try:
            (text,) = value
            found[key] = float(f"{decimal(text) * UNITS[units].get(dimension, 1.0):.12g}")
            if not KEYS[key].check(found[key]):
                raise ValueError
        except ValueError:
            raise BadInput(
                f"{path}:{number}: {keyword}: '{shown(' '.join(value))}' is not allowed, must be "
                f"{allowed}"
            ) from None
    for keyword, (key, _) in QUANTITIES.items():
        if key not in found:
            raise BadInput(f"{path}: {keyword} is missing")
    return found
