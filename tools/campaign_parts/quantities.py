# SPDX-License-Identifier: GPL-2.0-or-later
"""The quantities of a friction run, and what follows from them: step, cost, variables of the input
script."""

import dataclasses
import math
import re
from collections.abc import Callable
from typing import Any

from . import size
from .size import AUTO

LEAST, MOST = (
    1e-12,
    1e12,
)  # sizes of numbers in a plan: far outside, the step and kappa1 are no numbers any more

# automaton-steps a second and core in the plane and in space, of samples that fit a cache: half of
# what doc/performance.md has of a quiet machine, since others use a machine, too
RATE, RATE_IN_SPACE = 9e6, 1.7e6


@dataclasses.dataclass(frozen=True)
class Key:
    """A quantity of a run: its default, unit, what is allowed, and its variable in the input
    script."""

    default: Any
    unit: str
    allowed: str
    check: Callable[[Any], bool] | None
    variable: str = ""  # of in.friction; empty: handled by Run
    factor: float = 1.0  # plan's unit -> script's unit


def _positive(x: float) -> bool:
    return x > 0


def _whole(least: int) -> Callable[[float], bool]:
    return lambda x: x == int(x) and x >= least


# defaults are the paper's Table 1 and the fragment of examples/friction
KEYS = {
    "p": Key(15.0, "MPa", "> 0", _positive, "p"),
    "v": Key(5.0, "m/s", "> 0", _positive, "v"),
    "strength": Key(92.0, "MPa", "> 0", _positive, "strength"),
    "E": Key(206000.0, "MPa", "> 0", _positive, "E"),
    "nu": Key(0.3, "", "in -1 .. 0.5", lambda x: -1 < x < 0.5, "nu"),
    "rho": Key(7800.0, "kg/m3", "> 0", _positive, "rho", 1e-6),
    "eta": Key(0.41, "Pa s", ">= 0", lambda x: x >= 0, "eta", 1e3),
    "elastic_limit": Key(0.554, "of the strength", "> 0", _positive, "elastic_limit"),
    "yield_strength": Key(0.87, "of the strength", "> 0", _positive, "yield_strength"),
    "yield_strain": Key(0.015, "total strain", "> 0", _positive, "yield_strain"),
    "breaking_strain": Key(0.04, "total strain", "> 0", _positive, "breaking_strain"),
    "d": Key(2.5, "nm", "> 0", _positive, "d"),
    "material": Key("steel.mca", "potential file", "the name of a potential file", None),
    "upper_material": Key(
        None, "potential file of the upper block", "the name of a potential file", None
    ),
    "temperature": Key(None, "K, of a potential file that has temperatures", "> 0", _positive),
    "columns": Key(AUTO, "automata across", "a whole number >= 4", _whole(4), "columns"),
    "rows": Key(AUTO, "rows of automata", "a whole number >= 8", _whole(8), "rows"),
    "held": Key(
        3,
        "rows fixed at the bottom, and driven at the top",
        "a whole number >= 1",
        _whole(1),
        "held",
    ),
    "depth": Key(
        None,
        "layers along z, of an input script in space",
        "a whole number >= 2",
        _whole(2),
        "depth",
    ),
    "roughness": Key(3.25, "nm", ">= 0", lambda x: x >= 0, "amplitude"),
    "seed": Key(1, "", "a whole number >= 1", _whole(1), "seed"),
    "ns": Key(100.0, "ns, duration", "> 0", _positive, "ns"),
    "laws": Key(
        "d", "preset of pair_style mca, further keywords may follow", "words", None, "laws"
    ),
    "dt": Key(None, "ns, step [scaled from 5e-5 with the material]", "> 0", _positive, "dt"),
    "row": Key(0.05, "ns between rows of the log", "> 0", _positive),
    "checkpoint": Key(2.0, "ns between restart files", "> 0", _positive),
    "picture": Key(0.0, "ns between frames of the dump, 0: none", ">= 0", lambda x: x >= 0),
    "profile": Key(
        0.0, "ns that each mean profile of the layer covers, 0: none", ">= 0", lambda x: x >= 0
    ),
}


# keyword of pair_coeff by key, of what blocks may have each of their own; d is one for both
KEYWORDS = {
    "E": "youngs_modulus",
    "nu": "poissons_ratio",
    "rho": "density",
    "strength": "strength",
    "elastic_limit": "elastic_limit",
    "yield_strength": "yield_strength",
    "yield_strain": "yield_strain",
    "breaking_strain": "breaking_strain",
    "eta": "viscosity",
}


@dataclasses.dataclass
class Run:
    """One friction run."""

    name: str
    values: dict[str, Any]
    input: str

    @property
    def upper(self) -> dict[str, Any]:
        """The quantities of the upper block where it has a material of its own, else empty."""
        return self.values.get("upper") or {}

    @property
    def weaker(self) -> dict[str, Any]:
        """All values, with the quantities of the weaker block."""
        return min(size.blocks(self.values), key=lambda v: v["strength"])

    @property
    def kappa1(self) -> float:
        """rho E v^2 / sigma_0^2, of the weaker block."""
        v = self.weaker
        return v["rho"] * v["E"] * 1e6 * v["v"] ** 2 / (v["strength"] * 1e6) ** 2

    @property
    def kappa2(self) -> float:
        """p E / sigma_0^2, of the weaker block."""
        v = self.weaker
        return v["p"] * v["E"] / v["strength"] ** 2

    def slack(self, ns: float) -> float:
        """How far the mean normal stress (MPa) of the second half of a run may be from its
        pressure: 5 %, and what blocks that fall the height of their roughness and bounce ten times
        do to a short mean."""
        v = self.values
        mass = v["rho"] * 1e-9 * v["rows"] * v["d"] * math.sqrt(3) / 2  # kg/m2
        fall = math.sqrt(2e-9 * (v["roughness"] + v["d"]) * mass / (v["p"] * 1e6)) * 1e9  # ns
        return v["p"] * (0.05 + 10 * fall / (0.5 * ns))

    @property
    def dt(self) -> float:
        """Step in ns: as given, else 5e-5 scaled with the time of sound and the viscous time of an
        automaton, rounded down to two digits. Of two materials the stiffest, lightest and most
        viscous that their contacts can be."""
        if self.values["dt"] is not None:
            return self.values["dt"]
        base, v = {name: key.default for name, key in KEYS.items()}, dict(self.values)
        for name, worse in (("E", max), ("rho", min), ("eta", max)):
            v[name] = worse(v[name], self.upper.get(name, v[name]))
        size = v["d"] / base["d"]
        sound = size * math.sqrt(base["E"] / base["rho"]) / math.sqrt(v["E"] / v["rho"])
        viscous = (
            math.inf
            if v["eta"] == 0
            else size**2 * (v["rho"] / v["eta"]) / (base["rho"] / base["eta"])
        )
        if re.search(r"^[cd]\b(?!.*\bviscosity\b)|\bviscosity both\b", v["laws"]):
            viscous *= 0.8  # slip damps rotation: 5.772e-5 ns where it else is 8.92e-5, doc/laws.md
        dt = 5e-5 * min(1.0, sound, viscous)
        unit = 10.0 ** (math.floor(math.log10(dt)) - 1)
        return float(f"{math.floor(dt / unit * (1 + 1e-9)) * unit:.6g}")

    @property
    def is_flat(self) -> bool:
        """In the plane: whether the rough line, midway between the outer rows, crosses no row of
        automata, so that any seed gives the same blocks."""
        v = self.values
        row = v["d"] * math.sqrt(3) / 2
        return not v["depth"] and v["roughness"] < 0.5 * row * (1 - v["rows"] % 2)

    @property
    def is_rough(self) -> bool:
        """Whether the rough line comes near held or driven rows, that would be of both blocks."""
        v = self.values
        row = v["d"] * math.sqrt(3) / 2
        return bool(v["roughness"] > 0.5 * row * (v["rows"] - 2 * v["held"]))

    @property
    def steps(self) -> int:
        """Number of steps of the whole run."""
        return round(self.values["ns"] / self.dt)

    @property
    def automata(self) -> int:
        """Number of automata."""
        return int(size.in_layer(self.values) * self.values["rows"])

    @property
    def work(self) -> int:
        """Automaton-steps: what the run costs."""
        return self.steps * self.automata

    @property
    def cost(self) -> float:
        """Core-seconds to expect, at the usual rate."""
        return self.work / (RATE_IN_SPACE if self.values["depth"] else RATE)

    def variables(self) -> dict[str, str]:
        """Variables of the input script, in the script's units."""
        result = {}
        for name, key in KEYS.items():
            value = self.values[name]
            if key.variable and value is not None:
                result[key.variable] = (
                    value if isinstance(value, str) else f"{value * key.factor:.12g}"
                )
        if self.upper:
            result["upper_values"] = " ".join(
                f"{KEYWORDS[name]} {value * KEYS[name].factor:.12g}"
                for name, value in self.upper.items()
            )
        result["dt"] = f"{self.dt:.12g}"
        for variable, name in (
            ("every", "row"),
            ("checkpoint", "checkpoint"),
            ("frames", "picture"),
        ):
            ns = self.values[name]
            result[variable] = str(max(1, round(ns / self.dt)) if ns > 0 else 0)
        # a checkpoint at the end of a row keeps the log's rows whole
        every = int(result["every"])
        result["checkpoint"] = str(max(1, round(int(result["checkpoint"]) / every)) * every)
        # a profile is the mean of samples taken each 100 steps
        result["profile"] = str(100 * math.ceil(self.values["profile"] / self.dt / 100 - 1e-9))
        return result
