"""Plans: which friction runs a campaign consists of (YAML or CSV), checked as a whole."""
import csv
import dataclasses
import difflib
import itertools
import math
import os
import re

import yaml

FORMAT = "mca-campaign 1"
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
SHIPPED = os.path.join(ROOT, "examples", "campaign")
INPUT = os.path.join(ROOT, "examples", "friction", "in.friction")


class PlanError(Exception):
    """One clear line: file, line, key, value given, what is allowed."""


@dataclasses.dataclass(frozen=True)
class Key:
    """A quantity of a run: its default, unit, what is allowed, and its variable in the input script."""
    default: object
    unit: str
    allowed: str
    check: object
    variable: str = ""   # of in.friction; empty: handled by Run
    factor: float = 1.0  # plan's unit -> script's unit


def _positive(x):
    return x > 0


def _whole(least):
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
    "columns": Key(40, "automata across", "a whole number >= 4", _whole(4), "columns"),
    "rows": Key(32, "rows of automata", "a whole number >= 8", _whole(8), "rows"),
    "held": Key(1, "rows fixed at the bottom, and driven at the top", "a whole number >= 1", _whole(1), "held"),
    "roughness": Key(3.25, "nm", ">= 0", lambda x: x >= 0, "amplitude"),
    "seed": Key(1, "", "a whole number >= 1", _whole(1), "seed"),
    "ns": Key(100.0, "ns, duration", "> 0", _positive, "ns"),
    "laws": Key("b", "preset of pair_style mca, further keywords may follow", "words", None, "laws"),
    "dt": Key(None, "ns, step [scaled from 5e-5 with the material]", "> 0", _positive, "dt"),
    "row": Key(0.05, "ns between rows of the log", "> 0", _positive),
    "checkpoint": Key(2.0, "ns between restart files", "> 0", _positive),
    "picture": Key(0.0, "ns between frames of the dump, 0: none", ">= 0", lambda x: x >= 0),
    "profile": Key(0.0, "ns that each mean profile of the layer covers, 0: none", ">= 0", lambda x: x >= 0),
}


@dataclasses.dataclass
class Run:
    """One friction run."""
    name: str
    values: dict
    input: str

    @property
    def kappa1(self):
        """rho E v^2 / sigma_0^2."""
        v = self.values
        return v["rho"] * v["E"] * 1e6 * v["v"] ** 2 / (v["strength"] * 1e6) ** 2

    @property
    def kappa2(self):
        """p E / sigma_0^2."""
        v = self.values
        return v["p"] * v["E"] / v["strength"] ** 2

    @property
    def dt(self):
        """Step in ns: as given, else 5e-5 scaled with the time of sound and the viscous time of the
        material, rounded down to two digits."""
        if self.values["dt"] is not None:
            return self.values["dt"]
        base, v = {name: key.default for name, key in KEYS.items()}, self.values
        sound = math.sqrt(base["E"] / base["rho"]) / math.sqrt(v["E"] / v["rho"])
        viscous = math.inf if v["eta"] == 0 else (v["rho"] / v["eta"]) / (base["rho"] / base["eta"])
        dt = 5e-5 * min(1.0, sound, viscous)
        unit = 10.0 ** (math.floor(math.log10(dt)) - 1)
        return float(f"{math.floor(dt / unit * (1 + 1e-9)) * unit:.6g}")

    @property
    def steps(self):
        """Number of steps of the whole run."""
        return round(self.values["ns"] / self.dt)

    @property
    def work(self):
        """Automaton-steps: what the run costs."""
        return self.steps * self.values["columns"] * self.values["rows"]

    def variables(self):
        """Variables of the input script, in the script's units."""
        result = {}
        for name, key in KEYS.items():
            value = self.values[name]
            if key.variable and value is not None:
                result[key.variable] = value if isinstance(value, str) else f"{value * key.factor:.12g}"
        result["dt"] = f"{self.dt:.12g}"
        for variable, name in (("every", "row"), ("checkpoint", "checkpoint"), ("frames", "picture")):
            ns = self.values[name]
            result[variable] = str(max(1, round(ns / self.dt)) if ns > 0 else 0)
        # a checkpoint at the end of a row keeps the log's rows whole
        every = int(result["every"])
        result["checkpoint"] = str(max(1, round(int(result["checkpoint"]) / every)) * every)
        # a profile is the mean of samples taken each 100 steps
        result["profile"] = str(100 * math.ceil(self.values["profile"] / self.dt / 100 - 1e-9))
        return result


@dataclasses.dataclass
class Plan:
    """A named list of runs."""
    path: str
    title: str
    runs: list


class _Located(dict):
    """A mapping that knows the line it stands on."""
    line = 0


class _Loader(yaml.SafeLoader):
    """YAML with line numbers; a key that stands twice is an error."""

    def construct_mapping(self, node, deep=False):
        keys = [self.construct_object(key, deep=True) for key, _ in node.value]
        for key, (key_node, _) in zip(keys, node.value):
            if keys.count(key) > 1:
                raise yaml.MarkedYAMLError(problem=f"key '{key}' stands twice", problem_mark=key_node.start_mark)
        return super().construct_mapping(node, deep=deep)


def _located(loader, node):
    result = _Located(loader.construct_mapping(node, deep=True))
    result.line = node.start_mark.line + 1
    return result


_Loader.add_constructor(yaml.resolver.BaseResolver.DEFAULT_MAPPING_TAG, _located)
# YAML 1.1 takes 1e-5 for text
_Loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?[0-9]+(\.[0-9]*)?[eE][-+]?[0-9]+$"),
                              list("-+0123456789"))


def find(name):
    """Path of a plan given by path or by the name of a shipped one."""
    if os.path.isfile(name):  # a folder of results may have the plan's name
        return name
    shipped = os.path.join(SHIPPED, name + ".yaml")
    if os.path.exists(shipped):
        return shipped
    known = sorted(f[:-5] for f in os.listdir(SHIPPED) if f.endswith(".yaml")) if os.path.isdir(SHIPPED) else []
    near = difflib.get_close_matches(name, known, 1, 0.0)
    raise PlanError(f"{name}: no such file, and no plan of that name is shipped"
                    + (f"; the nearest known one is '{near[0]}'" if near else ""))


def unknown(path, line, what, given, known):
    """The error for a word that is not known."""
    near = difflib.get_close_matches(str(given), list(known), 1, 0.0)[0]
    return PlanError(f"{path}:{line}: unknown {what} '{given}'; the nearest known one is '{near}'")


def _value(path, line, name, value):
    """A checked value of a key."""
    key = KEYS[name]
    where = f"{path}:{line}: {name}: '{value}' is not allowed, must be "
    if key.check is None:
        if not isinstance(value, str) or not re.fullmatch(r"[A-Za-z0-9_./-]+( [A-Za-z0-9_./-]+)*", value):
            raise PlanError(where + key.allowed)
        return value
    unit = f" ({key.unit})" if key.unit else ""
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value) or not key.check(value):
        raise PlanError(where + (key.allowed if key.allowed.startswith("a ") else "a number " + key.allowed) + unit)
    return value


def _short(value):
    return value.replace(" ", "_") if isinstance(value, str) else f"{value:g}"


def _expand(path, line, entry, defaults):
    """All runs of an entry: a list of values stands for each of them in turn."""
    for name in entry:
        if name not in KEYS and name != "name":
            raise unknown(path, line, "key", name, list(KEYS) + ["name"])
    given = {name: value if isinstance(value, list) else [value] for name, value in entry.items() if name != "name"}
    for name, values in given.items():
        if not values:
            raise PlanError(f"{path}:{line}: {name}: an empty list")
        given[name] = [_value(path, line, name, value) for value in values]
    for combination in itertools.product(*given.values()):
        values = {**defaults, **dict(zip(given, combination))}
        label = entry.get("name")
        if label is not None and not re.fullmatch(r"[A-Za-z0-9_.-]+", str(label)):
            raise PlanError(f"{path}:{line}: name: '{label}' is not allowed, must be of letters, digits, _ . -")
        several = [n for n in given if len(given[n]) > 1]
        suffix = "-".join(f"{n}{_short(values[n])}" for n in several)
        yield line, "-".join(filter(None, [str(label) if label is not None else None, suffix])), values


def _read_yaml(path, text):
    try:
        data = yaml.load(text, Loader=_Loader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        raise PlanError(f"{path}:{mark.line + 1 if mark else 1}: not YAML: {error.problem}") from None
    except yaml.YAMLError as error:
        raise PlanError(f"{path}: not YAML: {str(error).splitlines()[0]}") from None
    if not isinstance(data, dict) or "format" not in data:
        raise PlanError(f"{path}:1: no plan: it must begin with 'format: {FORMAT}'")
    if data["format"] != FORMAT:
        raise PlanError(f"{path}:{data.line}: format: '{data['format']}' cannot be read, must be '{FORMAT}'")
    for key in data:
        if key not in ("format", "title", "input", "defaults", "runs"):
            raise unknown(path, data.line, "key", key, ("format", "title", "input", "defaults", "runs"))
    defaults = data.get("defaults") or _Located()
    if not isinstance(defaults, dict):
        raise PlanError(f"{path}:{data.line}: defaults: must be keys with values")
    if not isinstance(data.get("runs"), list) or not data["runs"]:
        raise PlanError(f"{path}:{data.line}: runs: must be a list of at least one run")
    for entry in data["runs"]:
        if not isinstance(entry, dict):
            raise PlanError(f"{path}:{data.line}: runs: '{entry}' is not a run such as {{p: 15, v: 5}}")
    return data.get("title", ""), data.get("input"), (defaults.line if defaults else 0, defaults), [
        (entry.line, entry) for entry in data["runs"]]


def _read_csv(path, text):
    rows = [(number, line) for number, line in enumerate(text.splitlines(), 1)
            if line.strip() and not line.startswith("#")]
    cells = [(number, [cell.strip() for cell in row]) for (number, _), row in
             zip(rows, csv.reader(line for _, line in rows))]
    if len(cells) < 2:
        raise PlanError(f"{path}: no run: a line of keys and at least one row are expected")
    first, names = cells[0]
    entries = []
    for number, row in cells[1:]:
        if len(row) != len(names):
            raise PlanError(f"{path}:{number}: {len(row)} columns, {len(names)} are expected")
        entry = {}
        for name, cell in zip(names, row):
            if name not in KEYS and name != "name":
                raise unknown(path, first, "column", name, list(KEYS) + ["name"])
            text_key = name == "name" or KEYS[name].check is None
            try:
                entry[name] = cell if text_key else (int(cell) if re.fullmatch(r"\d+", cell) else float(cell))
            except ValueError:
                raise PlanError(f"{path}:{number}: {name}: '{cell}' is not a number") from None
        entries.append((number, entry))
    return "", None, (0, {}), entries


def read(path):
    """The plan in a YAML or CSV file. Raises PlanError."""
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise PlanError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if not text.strip():
        raise PlanError(f"{path}: is empty")
    reader = _read_csv if path.endswith(".csv") else _read_yaml
    title, script, (line, given), entries = reader(path, text)
    defaults = {name: key.default for name, key in KEYS.items()}
    for name, value in given.items():
        if name not in KEYS:
            raise unknown(path, line, "key in defaults", name, KEYS)
        defaults[name] = _value(path, line, name, value)
    script = os.path.join(os.path.dirname(os.path.realpath(path)), script) if script else INPUT
    if not os.path.exists(script):
        raise PlanError(f"{path}: input: no such file: {script}")
    expanded = [item for number, entry in entries for item in _expand(path, number, entry, defaults)]
    varying = [n for n in KEYS if len({str(values[n]) for _, _, values in expanded}) > 1]
    runs, seen = [], {}
    for number, label, values in expanded:
        name = label or "-".join(f"{n}{_short(values[n])}" for n in varying) or "run"
        if name in seen:
            raise PlanError(f"{path}:{number}: run '{name}' stands in line {seen[name]} too: give them different names")
        seen[name] = number
        runs.append(Run(name, values, os.path.realpath(script)))
    return Plan(path, title, runs)
