# SPDX-License-Identifier: GPL-2.0-or-later
"""Plans: which friction runs a campaign consists of (YAML or CSV), checked as a whole."""

import csv
import dataclasses
import itertools
import math
import os
import re
from collections.abc import Iterable, Iterator
from typing import Any

from mcawr.files import read_text
from mcawr.words import known_words

from . import laws, material, size
from .located import Given, PlanError, read_yaml, scalar, shown
from .quantities import KEYS, KEYWORDS, LEAST, MOST, Run

FORMAT = "mca-campaign 1"
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
SHIPPED = os.path.join(ROOT, "examples", "campaign")
INPUT = os.path.join("examples", "friction", "in.friction")  # below ROOT
TOP = ("format", "title", "input", "order", "defaults", "runs")
ORDERS = ("cost", "plan")
MOST_RUNS = 100000  # a plan of more takes minutes to read
MOST_STEPS = 2**31 - 1  # of a LAMMPS run
NAME = re.compile(
    r"(?!plan\.)[A-Za-z0-9][A-Za-z0-9_.+-]{0,199}"
)  # of a folder, beside which the plan stands

DECIMAL_COMMA = re.compile(r"[-+]?[0-9]+,[0-9]+([eE][-+]?[0-9]+)?")


@dataclasses.dataclass
class Plan:
    """A named list of runs."""

    path: str
    title: str
    runs: list
    in_order: bool = False  # runs start in the order of the plan, not the costly ones first


def find(name: str) -> str:
    """Path of a plan given by path or by the name of a shipped one."""
    if os.path.isfile(name):  # a folder of results may have the plan's name
        return name
    shipped = os.path.join(SHIPPED, name + ".yaml")
    if os.path.exists(shipped):
        return shipped
    known = (
        sorted(f[:-5] for f in os.listdir(SHIPPED) if f.endswith(".yaml"))
        if os.path.isdir(SHIPPED)
        else []
    )
    raise PlanError(
        f"{name}: no such file, and no plan of that name is shipped{known_words(name, known)}"
    )


def unknown(path: str, line: int, what: str, given: str, known: Iterable[str]) -> PlanError:
    """The error for a word that is not known."""
    return PlanError(f"{path}:{line}: unknown {what} '{shown(given)}'{known_words(given, known)}")


def refused(path: str, line: int, name: str, value: Any, allowed: str) -> PlanError:
    """The error for a value that is not allowed."""
    return PlanError(f"{path}:{line}: {name}: '{shown(value)}' is not allowed, must be {allowed}")


def _value(path: str, line: int, name: str, value: Any) -> Any:
    """A checked value of a key."""
    key = KEYS[name]
    if key.check is None:
        if not isinstance(value, str) or not re.fullmatch(
            r"[A-Za-z0-9_./-]+( [A-Za-z0-9_./-]+)*", value
        ):
            raise refused(path, line, name, value, key.allowed)
        if name == "laws" and (why := laws.wrong(value)):
            raise PlanError(f"{path}:{line}: laws: {why}")
        return value
    if name in size.KEYS and value == size.AUTO:
        return value
    unit = f" ({key.unit})" if key.unit else ""
    if not isinstance(value, (int, float)) or not key.check(value):
        number = key.allowed if key.allowed.startswith("a ") else "a number " + key.allowed
        raise refused(
            path,
            line,
            name,
            value,
            number
            + unit
            + (", written like 12 or 1.5e-5, not in quotes" if isinstance(value, str) else "")
            + (f", or {size.AUTO}" if name in size.KEYS else ""),
        )
    if value != 0 and not LEAST <= abs(value) <= MOST:
        raise refused(path, line, name, value, f"of a size in {LEAST:g} .. {MOST:g}{unit}")
    return value


def _check_together(path: str, line: int, entry: Any, values: dict[str, Any]) -> None:
    """What one value allows another to be; the line is that of the key, if the run has it."""

    def at(name: str) -> int:
        return entry[name].line if name in entry else line

    def check(right: Any, name: str, allowed: Any) -> None:
        if not right:
            raise refused(path, at(name), name, values[name], allowed)

    E, strength = values["E"], values["strength"]
    elastic = values["yield_strength"] * strength / E
    check(values["p"] < E, "p", f"< E = {E:g} (MPa)")
    check(values["yield_strength"] <= 1, "yield_strength", "<= 1 (of the strength)")
    check(
        values["elastic_limit"] <= values["yield_strength"],
        "elastic_limit",
        f"<= yield_strength = {values['yield_strength']:g}",
    )
    check(
        values["yield_strain"] > elastic,
        "yield_strain",
        f"> the elastic strain there, {elastic:.4g}",
    )
    check(
        values["yield_strain"] - elastic + strength / E < values["breaking_strain"] < 0.5,
        "breaking_strain",
        f"> {values['yield_strain'] - elastic + strength / E:.4g}, where the plastic strain begins "
        "to rise above that at yield_strain, and < 0.5",
    )
    dt = Run("", values, "").dt
    if values["ns"] < dt:
        raise refused(path, at("ns"), "ns", values["ns"], f"at least a step, {dt:g} ns")
    longest = MOST_STEPS * dt
    check(values["ns"] < longest, "ns", f"< {longest:.5g}, {MOST_STEPS} steps of {dt:g} ns")
    for name in ("columns", "depth"):
        check(values["depth"] is None or values[name] % 2 == 0, name, "an even number, in space")
    if values["row"] > values["ns"]:
        raise refused(
            path,
            at("row"),
            "row",
            values["row"],
            f"<= ns = {values['ns']:g}, or the log has no row",
        )
    if 2 * values["held"] >= values["rows"]:
        raise refused(
            path, at("held"), "held", values["held"], f"less than half of rows = {values['rows']:g}"
        )


def _short(value: Any) -> str:
    return value.replace(" ", "_") if isinstance(value, str) else f"{value:g}"


def _suffix(name: str, value: Any) -> str:
    """A value in the name of a run."""
    if name == "material":
        return os.path.basename(value).removesuffix(".mca")
    if name == "upper_material":
        return "below_" + os.path.basename(value).removesuffix(".mca")
    return name + _short(value)


def _material(path: str, line: int, name: str, temperature: float | None) -> dict[str, Any]:
    """{key: value} of a potential file, looked for beside the plan and in potentials."""
    places = (os.path.dirname(os.path.realpath(path)), os.path.join(ROOT, "potentials"))
    for place in places:
        if os.path.isfile(os.path.join(place, name)):
            try:
                return material.read(os.path.join(place, name), temperature)
            except material.TemperatureError as error:
                raise PlanError(f"{path}:{line}: {error}") from None
    raise PlanError(f"{path}:{line}: material: no file {name} beside the plan, nor in {places[1]}")


def _solid(path: str, line: int, of_run: Any, stated: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """Two dictionaries of the quantities that a potential file gives: below what the plan's
    defaults state, and above, where the run has a file or a temperature of its own."""
    name = of_run.get("material", stated.get("material"))
    temperature = of_run.get("temperature", stated.get("temperature"))
    if name is None and temperature is None:
        return {}, {}
    found = _material(path, line, name or KEYS["material"].default, temperature)
    return ({}, found) if {"material", "temperature"} & set(of_run) else (found, {})


def _upper(path: str, at: int, values: dict[str, Any]) -> dict[str, Any] | None:
    """The quantities of the upper block's own potential file, but for the diameter, which is one
    for both; None without a file."""
    if values["upper_material"] is None:
        return None
    found = _material(path, at, values["upper_material"], values["temperature"])
    return {key: value for key, value in found.items() if key in KEYWORDS}


def _expand(
    path: str, line: int, entry: Any, defaults: dict[str, Any], stated: Any
) -> Iterator[tuple[int, str, dict[str, Any]]]:
    """All runs of an entry: a list of values stands for each of them in turn."""
    given = {}
    for name, (at, value) in entry.items():
        if name == "name":
            continue
        if name not in KEYS:
            raise unknown(path, at, "key", name, list(KEYS) + ["name"])
        items = value if isinstance(value, list) else [Given(at, value)]
        if not items:
            raise PlanError(f"{path}:{at}: {name}: an empty list")
        given[name] = [_value(path, item.line, name, item.value) for item in items]
    count = math.prod(map(len, given.values()))
    if count > MOST_RUNS:
        raise PlanError(
            f"{path}:{line}: runs: its lists have {count} combinations, a run may stand for "
            f"{MOST_RUNS} at most"
        )
    named, label = entry.get("name", (line, None))
    if isinstance(label, (list, dict)):
        raise refused(path, named, "name", label, "a word")
    for combination in itertools.product(*given.values()):
        values = dict(zip(given, combination))
        at, upper_at = (
            entry[name].line if name in entry else line for name in ("material", "upper_material")
        )
        below, above = _solid(path, at, values, stated)
        values = {**defaults, **below, **stated, **above, **values}
        values["upper"] = _upper(path, upper_at, values)
        values = size.settled(values)
        _check_together(path, line, entry, values)
        if values["upper"]:
            _check_together(path, upper_at, {}, {**values, **values["upper"]})
        suffix = "-".join(_suffix(n, values[n]) for n in given if len(given[n]) > 1)
        yield (named, "-".join(filter(None, [label, suffix])), values)


def _read_yaml(path: str, text: str) -> tuple[str, bool, Given, Any, Any]:
    data = read_yaml(path, text).value
    if not isinstance(data, dict) or "format" not in data:
        raise PlanError(f"{path}:1: not a plan: it must begin with 'format: {FORMAT}'")
    line, given = data["format"]
    if given != FORMAT:
        raise PlanError(
            f"{path}:{line}: format: '{shown(given)}' cannot be read, must be '{FORMAT}'"
        )
    for key, (line, value) in data.items():
        if key not in TOP:
            raise unknown(path, line, "key", key, TOP)
        if key in ("title", "input") and not isinstance(value, (str, type(None))):
            raise refused(path, line, key, value, "text")
        if key == "order" and value not in ORDERS:
            raise refused(path, line, key, value, " or ".join(ORDERS))
        if key == "defaults" and not isinstance(value, (dict, type(None))):
            raise refused(path, line, key, value, "keys with values")
    line, runs = data.get("runs", (1, None))
    if not isinstance(runs, list) or not runs:
        raise PlanError(f"{path}:{line}: runs: must be a list of at least one run")
    for line, entry in runs:
        if not isinstance(entry, dict):
            raise PlanError(
                f"{path}:{line}: runs: '{shown(entry)}' is not a run such as {{p: 15, v: 5}}"
            )
    absent = Given(1, None)
    return (
        data.get("title", absent).value or "",
        data.get("order", absent).value == "plan",
        data.get("input", absent),
        data.get("defaults", absent).value or {},
        runs,
    )


def _cells(path: str, text: str) -> list[tuple[int, list[str]]]:
    """Lines of a CSV with their numbers; the first decides what separates."""
    lines = [
        (number, line)
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.startswith("#")
    ]
    separator = next((c for c in ";\t" if lines and c in lines[0][1]), ",")
    found = []
    for number, line in lines:
        try:
            cells = next(csv.reader([line], delimiter=separator, strict=True))
        except csv.Error as error:
            raise PlanError(f"{path}:{number}: not CSV: {error}") from None
        found.append((number, [cell.strip() for cell in cells]))
    return found


def _read_csv(path: str, text: str) -> tuple[str, bool, Given, Any, Any]:
    cells = _cells(path, text)
    if len(cells) < 2:
        raise PlanError(f"{path}:1: no run: a line of keys and at least one row are expected")
    first, names = cells[0]
    for name in names:
        if name not in KEYS and name != "name":
            raise unknown(path, first, "column", name, list(KEYS) + ["name"])
        if names.count(name) > 1:
            raise PlanError(f"{path}:{first}: column '{name}' appears twice")
    entries = []
    texts = {name for name in names if name == "name" or KEYS[name].check is None}
    marks: dict[str, int] = {}  # where a decimal point and a comma stand first
    for number, row in cells[1:]:
        if len(row) != len(names):
            raise PlanError(f"{path}:{number}: {len(row)} columns, {len(names)} are expected")
        for place, (name, cell) in enumerate(zip(names, row)):
            if name in texts:
                continue
            marks |= {mark: number for mark in ".," if mark in cell and mark not in marks}
            if len(marks) == 2:
                raise PlanError(
                    f"{path}:{number}: {name}: '{cell}': line {min(marks.values())} has another "
                    "decimal mark; one of point and comma is allowed in a file"
                )
            if DECIMAL_COMMA.fullmatch(cell):
                row[place] = cell.replace(",", ".")
        entries.append(
            Given(
                number,
                {
                    name: Given(number, cell if name in texts else scalar(cell))
                    for name, cell in zip(names, row)
                },
            )
        )
    return "", False, Given(1, None), {}, entries


def _check_known(path: str, line: int, program: str, all_values: list[dict[str, Any]]) -> None:
    """The input script declares what not every one has: LAMMPS takes a variable that nothing reads
    without a word."""
    with open(program, encoding="utf-8", errors="replace") as file:
        declared = set(re.findall(r"^\s*variable\s+(\w+)", file.read(), re.MULTILINE))
    if "depth" in declared and any(values["depth"] is None for values in all_values):
        raise PlanError(
            f"{path}:{line}: depth: the input script {program} is in space: a run needs a depth, a "
            f"number or {size.AUTO}"
        )
    for variable, key in (("depth", "depth"), ("upper_values", "upper_material")):
        if variable not in declared and any(values[key] is not None for values in all_values):
            raise PlanError(
                f"{path}:{line}: {key}: the input script {program} has no variable {variable}"
            )


def read(path: str) -> Plan:
    """The plan in a YAML or CSV file. Raises BadInput."""
    text = read_text(path)
    if not text.strip():
        raise PlanError(f"{path}: is empty")
    reader = _read_csv if path.endswith(".csv") else _read_yaml
    title, in_order, (script_line, script), given, entries = reader(path, text)
    # as the plan says it: the record of a run keeps it, and a checkout may stand elsewhere next
    # time
    defaults = {**{name: key.default for name, key in KEYS.items()}, "input": script or INPUT}
    stated = {}
    for name, (line, value) in given.items():
        if name not in KEYS:
            raise unknown(path, line, "key in defaults", name, KEYS)
        stated[name] = _value(path, line, name, value)
    program = os.path.realpath(
        os.path.join(os.path.dirname(os.path.realpath(path)), script)
        if script
        else os.path.join(ROOT, INPUT)
    )
    if not os.path.isfile(program):
        raise PlanError(f"{path}:{script_line}: input: no such file: {program}")
    expanded = [
        item for number, entry in entries for item in _expand(path, number, entry, defaults, stated)
    ]
    varying = [n for n in KEYS if len({str(values[n]) for _, _, values in expanded}) > 1]
    follow = set(size.KEYS)  # from others, and name no run unless a run states them
    if {"material", "temperature"} & set(varying):  # they stand for its quantities
        follow |= {key for key, _ in material.QUANTITIES.values()}
    follow -= {n for _, entry in entries for n in entry}
    varying = [n for n in varying if n not in follow]
    _check_known(path, script_line, program, [values for _, _, values in expanded])
    runs: list[Run] = []
    seen: dict[str, int] = {}
    for number, label, values in expanded:
        told = [_suffix(n, values[n]) for n in varying if values[n] is not None]
        name = label or "-".join(told) or "run"
        if not NAME.fullmatch(name):
            raise refused(
                path,
                number,
                "name",
                name,
                "of letters, digits, _ . + -, begin with a letter or digit and not "
                "with 'plan.', and have 200 at most",
            )
        if name in seen:
            raise PlanError(
                f"{path}:{number}: run '{name}' stands in line {seen[name]} too: give them "
                "different names"
            )
        seen[name] = number
        runs.append(Run(name, values, program))
    return Plan(path, title, runs, in_order)
