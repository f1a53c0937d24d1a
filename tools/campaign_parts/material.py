# SPDX-License-Identifier: GPL-2.0-or-later
"""Potential files (doc/potential_file.md) for plans: the quantities of a material in the plan's
units."""

import bisect
import itertools
import os
from typing import Any

from mcawr.errors import BadInput
from mcawr.files import read_text
from mcawr.numbers import decimal
from mcawr.words import known_words

from .located import shown
from .quantities import KEYS, KEYWORDS

# keyword of the file: (key of the plan, dimension)
DIMENSIONS = {
    "E": "stress",
    "strength": "stress",
    "rho": "density",
    "eta": "viscosity",
    "d": "length",
}
QUANTITIES = {
    keyword: (key, DIMENSIONS.get(key, ""))
    for key, keyword in {**KEYWORDS, "d": "diameter"}.items()
}
# what a file's unit is in the plan's: MPa, kg/m3, Pa s, nm
UNITS = {
    "nano": {"stress": 1.0, "density": 1e6, "viscosity": 1e-3, "length": 1.0},
    "si": {"stress": 1e-6, "density": 1.0, "viscosity": 1.0, "length": 1e9},
    "micro": {"stress": 1e-3, "density": 1e3, "viscosity": 1e-3, "length": 1e3},
    "cgs": {"stress": 1e-7, "density": 1e3, "viscosity": 0.1, "length": 1e7},
}


class TemperatureError(BadInput):
    """The temperature that a plan says, or does not say, is none of the file's."""


def _values(path: str, number: int, keyword: str, words: list[str], key: str, factor: float) -> Any:
    """The numbers of a line, in the unit of the plan's key."""
    found = []
    for text in words or [""]:
        try:
            value = float(f"{decimal(text) * factor:.12g}")
            check = KEYS[key].check
            if check and not check(value):
                raise ValueError
        except ValueError:
            raise BadInput(
                f"{path}:{number}: {keyword}: '{shown(text)}' is not allowed, must be a number "
                f"{KEYS[key].allowed}"
            ) from None
        found.append(value)
    return found


def _lines(path: str, lines: Any, units: Any) -> Any:
    """{key of the plan: (line, values)}; of `temperature`, too."""
    known = {**QUANTITIES, "temperature": ("temperature", "")}
    found = {}
    for number, line in enumerate(lines, 2):
        words = line.partition("#")[0].split()
        if not words:
            continue
        keyword, *values = words
        if keyword not in known:
            raise BadInput(
                f"{path}:{number}: unknown keyword '{shown(keyword)}'{known_words(keyword, known)}"
            )
        key, dimension = known[keyword]
        if key in found:
            raise BadInput(f"{path}:{number}: {keyword} appears twice")
        factor = UNITS[units].get(dimension, 1.0)
        found[key] = (number, _values(path, number, keyword, values, key, factor))
    return found


def _check_counts(path: str, found: Any, temperatures: Any) -> None:
    """Every quantity is there, once or once for each temperature."""
    for keyword, (key, _) in QUANTITIES.items():
        if key not in found:
            raise BadInput(f"{path}: {keyword} is missing")
        number, values = found[key]
        if len(values) not in (1, len(temperatures)):
            allowed = f"1 or {len(temperatures)}, as many as temperature"
            raise BadInput(
                f"{path}:{number}: {keyword} has {len(values)} values, allowed: "
                + (allowed if temperatures else "one, or a line temperature with as many")
            )


def _check_temperatures(path: str, number: int, temperatures: Any) -> None:
    """At least two that rise."""
    if len(temperatures) < 2:
        raise BadInput(f"{path}:{number}: temperature has one value, allowed: two or more")
    for before, after in itertools.pairwise(temperatures):
        if after <= before:
            raise BadInput(
                f"{path}:{number}: temperature {after:g} stands after {before:g}, allowed: values "
                "that rise"
            )


def _at(temperature: float | None, temperatures: Any, values: Any) -> Any:
    """Linear between the temperatures."""
    if len(values) == 1:
        return values[0]
    upper = max(1, bisect.bisect_left(temperatures, temperature))
    t0, t1 = temperatures[upper - 1 : upper + 1]
    share = (temperature - t0) / (t1 - t0)
    return float(f"{(1 - share) * values[upper - 1] + share * values[upper]:.12g}")


def read(path: str, temperature: float | None = None) -> dict[str, Any]:
    """{key of the plan: value} at a temperature (K), which a file that has temperatures needs and
    no other may have. Raises BadInput, with the line, and TemperatureError."""
    lines = read_text(path).split("\n")
    head = lines[0].split()
    units = head[head.index("UNITS:") + 1] if "UNITS:" in head[:-1] else None
    if units not in UNITS:
        raise BadInput(
            f"{path}:1: 'UNITS: STYLE' with {', '.join(UNITS)} is needed, not '{shown(units)}'"
        )
    found = _lines(path, lines[1:], units)
    number, temperatures = found.pop("temperature", (None, []))
    if number:
        _check_temperatures(path, number, temperatures)
    _check_counts(path, found, temperatures)
    name = os.path.basename(path)
    if temperature is not None and not temperatures:
        raise TemperatureError(f"temperature: {name} has none, the plan says {temperature:g}")
    if temperatures:
        allowed = f"allowed for {name}: {temperatures[0]:g} to {temperatures[-1]:g}"
        if temperature is None:
            raise TemperatureError(f"temperature is missing, {allowed}")
        if not temperatures[0] <= temperature <= temperatures[-1]:
            raise TemperatureError(f"temperature: '{temperature:g}' is not allowed, {allowed}")
    return {key: _at(temperature, temperatures, values) for key, (_, values) in found.items()}
