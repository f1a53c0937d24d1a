# SPDX-License-Identifier: GPL-2.0-or-later
"""How large a fragment a load needs: what `auto` is in the keys columns, rows and depth, the one
place of the rule and of its constants (doc/campaign.md, The size of the fragment).

Blocks touch at junctions, contacts that are pressed to the linking pressure sigma_link. A load p
has p/sigma_link of the area in them. Where they are few a narrow fragment rubs too little or too
much. Where they cover most of the area, it heals into one crystal and rubs too much."""

import math
from collections.abc import Mapping
from typing import Any

AUTO = "auto"
KEYS = ("columns", "rows", "depth")
PRESET_A = 2.35  # sigma_link/sigma_0 of preset a; all others link at the elastic limit
# (share p/sigma_link below which it holds, automata in a layer, the same of strong blocks,
# free rows in the plane, free layers of examples/space): p/sigma_0 = 0.1, 0.15, 0.28, 0.5 where
# links form at steel's elastic limit, 0.554
SIZES = (
    (0.18, 160, 160, 8, 14),
    (0.27, 160, 160, 14, 22),
    (0.5, 80, 160, 14, 22),
    (0.9, 80, 80, 14, 22),
    (math.inf, 160, 160, 14, 22),
)
STRONG = 500  # E/sigma_0 below which a block is: its layer is thinner, its junctions coarser
ASPECT = 2.5  # columns over depth, in space


def blocks(values: Mapping[str, Any]) -> list[dict[str, Any]]:
    """All values with the quantities of the lower block, and where the upper one has a material of
    its own, with those of the upper."""
    upper = values.get("upper")
    return [{**values}, {**values, **upper}] if upper else [{**values}]


def link_pressure(values: Mapping[str, Any]) -> float:
    """Elastic compression that links an unlinked contact of the blocks (MPa), by the words of
    `laws`; infinite where none does."""
    words = str(values["laws"]).split()
    chosen = dict(zip(words[1::2], words[2::2])).get("link")
    if chosen is None:
        chosen = str(PRESET_A) if words[0] == "a" else "elastic_limit"
    if chosen == "none":
        return math.inf
    return min(
        (block["elastic_limit"] if chosen == "elastic_limit" else float(chosen)) * block["strength"]
        for block in blocks(values)
    )


def share(values: Mapping[str, Any]) -> float:
    """p/sigma_link: the share of the area in junctions."""
    return values["p"] / link_pressure(values)


def in_layer(values: Mapping[str, Any]) -> float:
    """Automata in a layer of the lattice; in the fcc packing of examples/space every other site of
    one is empty."""
    return values["columns"] * (values["depth"] or 2) / 2


def junctions(values: Mapping[str, Any]) -> float:
    """Junctions that carry the load at once: p W/(d sigma_link) in a plane of width W = columns d;
    in space p A/(d^2 sigma_link)."""
    return share(values) * in_layer(values)


def _even(least: float) -> int:
    return 2 * math.ceil(least / 2 - 1e-9)


def settled(values: Mapping[str, Any]) -> dict[str, Any]:
    """The values with a number where `auto` stands."""
    result = dict(values)
    _, layer, strong, free, free_in_space = next(row for row in SIZES if share(values) < row[0])
    if all(block["E"] < STRONG * block["strength"] for block in blocks(values)):
        layer = strong
    if result["depth"] == AUTO:
        result["depth"] = _even(math.sqrt(2 * layer / ASPECT))
    depth = result["depth"]
    if result["columns"] == AUTO:
        result["columns"] = _even(2 * layer / depth) if depth else layer
    if result["rows"] == AUTO:
        result["rows"] = 2 * result["held"] + (free_in_space if depth else free)
    return result
