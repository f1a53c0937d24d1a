# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/campaign: plans, shipped ones among them, and the page."""

import math
import os
import re

import pytest

from campaign_calls import HEAD, ROOT, campaign, one_line
from campaign_parts import laws, plan as plans, size


LONG = pytest.mark.long
MANY = ", ".join(map(str, range(1, 401)))
SPACE = ROOT / "examples" / "space" / "in.friction"
BAD_PLANS = [
    ("", ["is empty"]),
    ("runs: [", ["not YAML"]),
    ("title: x\nruns: [{p: 1}]\n", [":1: not a plan"]),
    ("format: mca-campaign 2\nruns: [{p: 1}]\n", ["'mca-campaign 2' cannot be read"]),
    (HEAD + "runs: []\n", ["at least one run"]),
    (
        HEAD + "runs:\n  - {p: 1}\n  - {presure: 1}\n",
        [":4: unknown key 'presure'; known: p, v, strength, "],
    ),
    (
        HEAD + "defaults: {strenght: 3}\nruns: [{p: 1}]\n",
        [":2: unknown key in defaults 'strenght'", "'strength'"],
    ),
    (HEAD + "run: [{p: 1}]\n", ["unknown key 'run'", "'runs'"]),
    (HEAD + "runs: [{p: -1}]\n", [":2: p: '-1' is not allowed, must be a number > 0 (MPa)"]),
    (HEAD + "runs: [{p: .nan}]\n", ["p: '.nan'"]),
    (
        HEAD + "runs:\n  - v: 1\n    p: 1.0e9\n",
        [":4: p: '1000000000.0' is not allowed, must be < E = 206000 (MPa)"],
    ),
    (HEAD + "runs: [{p: [15, 22,5, 30]}]\n", [":2: '22,5' has a decimal comma"]),
    (HEAD + "runs: [{p: [0,05,0,5]}]\n", [":2: '0,05' has a decimal comma"]),
    (HEAD + "runs: [{p: 22,5}]\n", ["unknown key '5'"]),
    (HEAD + "runs: [{p: 1 500}]\n", ["p: '1 500' is not allowed"]),
    (HEAD + "runs: [{p: 0x10}]\n", ["p: '0x10' is not allowed"]),
    (HEAD + "runs: [{v: .inf}]\n", ["v: '.inf'"]),
    (HEAD + "runs: [{v: fast}]\n", ["v: 'fast'"]),
    (
        HEAD + "runs: [{columns: 4.5}]\n",
        ["columns: '4.5' is not allowed, must be a whole number >= 4"],
    ),
    (HEAD + "runs: [{p: []}]\n", ["p: an empty list"]),
    (HEAD + "runs: [{p: 1, p: 2}]\n", ["key 'p' appears twice"]),
    (HEAD + "runs: [{p: 1}, {p: 1.0}]\n", ["different names"]),
    (HEAD + "input: absent.in\nruns: [{p: 1}]\n", [":2: input: no such file"]),
    (HEAD + "input: ..\nruns: [{p: 1}]\n", [":2: input: no such file"]),
    (HEAD + "input: 5\nruns: [{p: 1}]\n", [":2: input: '5' is not allowed, must be text"]),
    (HEAD + "input: [a]\nruns: [{p: 1}]\n", [":2: input: '[...]'"]),
    (HEAD + "title: {a: 1}\nruns: [{p: 1}]\n", [":2: title: '{...}'"]),
    # what would be written outside the folder, or over the plan
    (HEAD + "runs: [{name: a/b}]\n", ["name: 'a/b'"]),
    (HEAD + "runs:\n  - p: 1\n    name: ..\n", [":4: name: '..' is not allowed"]),
    (HEAD + "runs: [{laws: [b, ../../esc]}]\n", [":2: laws: preset '../../esc' is not allowed"]),
    (HEAD + "runs: [{name: plan.yaml}]\n", ["name: 'plan.yaml'"]),
    (HEAD + "runs: [{name: [a, b]}]\n", ["name: '[...]'"]),
    # laws that lmp or the size of the fragment cannot use
    (HEAD + "runs: [{laws: e}]\n", [":2: laws: preset 'e' is not allowed, must be a, b, c, d"]),
    (HEAD + "runs: [{laws: nonsense words here}]\n", [":2: laws: preset 'nonsense' is not"]),
    (HEAD + "runs:\n  - laws: [d, d lnik 2]\n", [":3: laws: unknown keyword 'lnik'", "'link'"]),
    (HEAD + "runs: [{laws: d weld}]\n", [":2: laws: weld: '' is not allowed, must be a number in"]),
    (
        HEAD + "runs: [{laws: d link 0}]\n",
        [":2: laws: link: '0' is not allowed", "1e-12 .. 1e+12, elastic_limit, none"],
    ),
    (HEAD + "runs: [{laws: d link nan}]\n", ["laws: link: 'nan' is not allowed"]),
    (HEAD + "defaults: {laws: d link -1}\nruns: [{v: 1}]\n", [":2: laws: link: '-1' is not"]),
    (HEAD + "runs: [{laws: d worn 1}]\n", ["worn: '1' is not allowed, must be unloaded, never"]),
    # numbers that leave no step, kappa or log
    (
        HEAD + "runs: [{strength: 1e-200}]\n",
        ["strength: '1e-200' is not allowed, must be of a size in 1e-12 .. 1e+12 (MPa)"],
    ),
    (HEAD + "runs: [{v: 1e200}]\n", ["v: '1e+200'"]),
    (HEAD + "runs: [{E: 1e300, rho: 1e-30}]\n", ["E: '1e+300'"]),
    (HEAD + "runs: [{ns: 1e308}]\n", ["ns: '1e+308'"]),
    (HEAD + "runs: [{eta: 1e308}]\n", ["eta: '1e+308'"]),
    (HEAD + f"runs: [{{seed: 1{'0' * 400}}}]\n", ["seed: '1000", "0...' is not allowed"]),
    (HEAD + f"runs: [{{seed: 1{'0' * 5000}}}]\n", ["seed: '1000", "0...' is not allowed"]),
    (HEAD + "runs: [{ns: 0.1, row: 10}]\n", [":2: row: '10' is not allowed, must be <= ns = 0.1"]),
    (
        HEAD + "runs: [{ns: 1e-6, row: 1e-6}]\n",
        ["ns: '1e-06' is not allowed, must be at least a step, 4e-05 ns"],
    ),
    (
        HEAD + "runs: [{v: 0.005, ns: 1e5}]\n",
        ["ns: '100000.0' is not allowed, must be < 85899, 2147483647 steps of 4e-05 ns"],
    ),
    (HEAD + f"input: {SPACE}\nruns: [{{v: 1}}]\n", ["depth: the input script", "is in space"]),
    (
        HEAD + f"input: {SPACE}\nruns: [{{columns: 21, depth: 8}}]\n",
        ["columns: '21' is not allowed, must be an even number, in space"],
    ),
    (
        HEAD + "runs:\n  - rows: 8\n    held: 100\n",
        [":4: held: '100' is not allowed, must be less than half of rows = 8"],
    ),
    # numbers that YAML 1.1 reads in its own way
    (HEAD + "runs: [{p: 010}]\n", ["p: '010' is not allowed", "written like 12 or 1.5e-5"]),
    (HEAD + "runs: [{v: 1:30}]\n", ["v: '1:30'"]),
    (HEAD + "runs: [{p: 1_000}]\n", ["p: '1_000'"]),
    (HEAD + "runs: [{p: !!int x}]\n", ["p: 'x'"]),
    (HEAD + f"runs: {'[' * 3000}\n", ["nested too deep"]),
    (HEAD + "runs: [{p: [[1]]}]\n", [":2: not YAML: nested too deep"]),
    (HEAD + "runs: [{p: &a [*a]}]\n", ["nested too deep"]),
    (HEAD + "runs: [{[1]: 2}]\n", ["a key must be a word"]),
    (HEAD + "title: \0\n", ["is binary, not text: character 31"]),
    # more combinations than anybody waits for
    (
        HEAD + f"runs:\n  - {{p: 1}}\n  - {{p: [{MANY}], v: [{MANY}]}}\n",
        [":4: runs: its lists have 160000 combinations, a run may stand for 100000 at most"],
    ),
    # the line is that of the key
    (HEAD + "title: x\nruns:\n  - {p: 1}\ndefault: {v: 1}\n", [":5: unknown key 'default'"]),
    (HEAD + "defaults:\n  p: 1\n  vv: 2\nruns: [{p: 1}]\n", [":4: unknown key in defaults 'vv'"]),
    (HEAD + "defaults:\n  p: 1\n  E: -5\nruns: [{p: 1}]\n", [":4: E: '-5'"]),
    (HEAD + "runs:\n  - p: 1\n    vv: 2\n", [":4: unknown key 'vv'"]),
    (HEAD + "runs:\n  - p:\n    - 1\n    - -1\n", [":5: p: '-1'"]),
    (HEAD + "runs:\n  - {p: 1}\n  -\n", [":4: runs: 'None' is not a run"]),
    (HEAD + "title: x\ndefaults: 5\nruns: [{p: 1}]\n", [":3: defaults: '5' is not allowed"]),
]


@pytest.mark.parametrize(
    "text, parts",
    [  # every sixth, the others are long
        pytest.param(*plan, marks=[LONG] if k % 6 else []) for k, plan in enumerate(BAD_PLANS)
    ],
    ids=lambda value: repr(value).removeprefix(repr(HEAD)[:-1])[:60],
)
def test_bad_plan_is_one_clear_line(tmp_path, text, parts):
    path = tmp_path / "plan.yaml"
    path.write_text(text)
    one_line(campaign("run", path, "-o", tmp_path / "out"), 3, str(path), *parts)
    assert not (tmp_path / "out").exists()


def test_a_step_that_some_runs_leave_to_the_material(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text("format: mca-campaign 1\nruns:\n  - {v: 5, dt: 1e-5}\n  - {v: 2}\n")
    assert [run.name for run in plans.read(str(path)).runs] == ["v5-dt1e-05", "v2"]


def test_names_stay_as_they_are_written(tmp_path):
    """Those that look like numbers, too."""
    path = tmp_path / "plan.yaml"
    names = ["1.10", "1.1", "1e3", "007", "2"]
    path.write_text(HEAD + "runs:\n" + "".join(f"  - {{name: {n}, p: 5}}\n" for n in names))
    assert [run.name for run in plans.read(str(path)).runs] == names
    path.write_text(HEAD + "runs: [{name: 1.10, p: [5, 6]}, {name: ~}]\n")
    assert [run.name for run in plans.read(str(path)).runs] == ["1.10-p5", "1.10-p6", "p15"]


def sizes(tmp_path, *runs, more=""):
    """{name: (columns, rows, depth)} of the runs of a plan."""
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + more + "runs:\n" + "".join(f"  - {{{run}}}\n" for run in runs))
    found = plans.read(str(path)).runs
    return {r.name: tuple(r.values[key] for key in ("columns", "rows", "depth")) for r in found}


def test_size_follows_the_load(tmp_path):
    """By the share p/sigma_link, whatever strength, elastic limit and laws make it of; the plan's
    numbers go before it; no run is named after what it did not state."""
    assert sizes(tmp_path, "p: [9, 9.97, 9.98, 14.9, 15, 49.8, 49.9], strength: 100") == {
        "p9": (160, 14, None),
        "p9.97": (160, 14, None),
        "p9.98": (160, 20, None),  # 0.18 of 55.4 MPa
        "p14.9": (160, 20, None),
        "p15": (80, 20, None),  # 0.27 of it
        "p49.8": (80, 20, None),
        "p49.9": (160, 20, None),
    }
    laws = "laws: [c, c link 2, a, c link none, c link elastic_limit], p: 20, strength: 100"
    assert [size[0] for size in sizes(tmp_path, laws).values()] == [80, 160, 160, 160, 80]
    assert sizes(tmp_path, "elastic_limit: 0.8, p: 14, strength: 100")["run"][0] == 160
    strong = sizes(tmp_path, "E: 49900, p: [9, 15, 27.6, 27.8, 49.9], strength: 100")
    assert [size[:2] for size in strong.values()] == [
        (160, 14),
        (160, 20),  # 80 columns from E/sigma_0 = 500 on
        (160, 20),
        (80, 20),  # 0.5 of 55.4 MPa
        (160, 20),
    ]
    given = sizes(
        tmp_path,
        "name: own, columns: 30",
        "name: high, rows: 24",
        "name: thick, held: 5",
        "name: default, columns: auto, rows: auto",
        more="defaults: {columns: 50, rows: 18}\n",
    )
    assert given == {
        "own": (30, 18, None),
        "high": (50, 24, None),
        "thick": (50, 18, None),
        "default": (80, 20, None),
    }
    assert sizes(tmp_path, "held: 5, p: 1")["run"] == (160, 18, None)
    assert list(sizes(tmp_path, "columns: [20, auto], p: 1")) == ["columns20", "columns160"]


def test_size_in_space(tmp_path):
    """As many automata in a layer as in the plane, in even numbers of layers."""
    space = "input: " + str(ROOT / "examples/space/in.friction") + "\n"
    found = sizes(tmp_path, "p: [1, 15, 80], depth: auto", "name: d4, depth: 4", more=space)
    assert found == {"p1": (28, 20, 12), "p15": (20, 28, 8), "p80": (28, 28, 12), "d4": (40, 28, 4)}


def test_junctions_and_cost():
    """p W/(d sigma_link), in space p A/(d^2 sigma_link); core-seconds at the usual rate."""
    plane, space = (plans.read(plans.find(name)).runs[0] for name in ("velocity", "space"))
    sigma_link = 0.554 * 92
    assert size.junctions(plane.values) == pytest.approx(15 * 80 / sigma_link)
    layer = 2.5 / math.sqrt(2)
    area = (20 * layer) * (8 * layer)
    assert size.junctions(space.values) == pytest.approx(15 * area / 2.5**2 / sigma_link)
    assert plane.cost == pytest.approx(1600 * 500 / 4e-5 / 9e6)
    assert space.cost == pytest.approx(2240 * 100 / 4e-5 / 1.7e6)
    listed = campaign("list", "velocity").stdout
    assert re.search(r" v1-seed1 .* 80 +20 .* 24 +0.1898 +365.1 +4e-05 +0.617$", listed, re.M)
    assert "16 runs, 3.3 core-hours at 9 M automaton-steps a second and core\n" in listed


def test_a_word_is_no_size(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{columns: wide}]\n")
    one_line(
        campaign("list", path), 3, "columns: 'wide' is not", "a whole number >= 4 (", ", or auto"
    )
    path.write_text(HEAD + "runs: [{held: auto}]\n")
    one_line(campaign("list", path), 3, "held: 'auto' is not allowed")


def test_laws_have_the_keywords_of_the_pair_style():
    """And their words, as the page of pair_style mca has them."""
    syntax = (ROOT / "doc" / "pair_mca.md").read_text().split("```text")[2].split("```")[0]
    found = dict(re.findall(r"^(\w+) value = (.+)$", syntax, re.MULTILINE))
    assert found.pop("preset") == " or ".join(laws.PRESETS)
    numbers = {"h": (), "c": (), "factor": ()}
    for keyword, (least, words) in laws.VALUES.items():
        page = found.pop(keyword).split(" or ")
        assert [word for word in page if word not in numbers] == list(words)
        assert (least is not None) == (page[0] in numbers)
        number = least if least is not None else words[0]
        assert laws.wrong(f"d {keyword} {number}") is None
    assert not found


def test_csv_plan(tmp_path):
    path = tmp_path / "plan.csv"
    path.write_text("# made by hand\nname,p,v,seed\none,15,5,1\ntwo,1.5,2,2\n")
    runs = plans.read(str(path)).runs
    assert [(r.name, r.values["p"], r.values["seed"]) for r in runs] == [
        ("one", 15, 1),
        ("two", 1.5, 2),
    ]
    path.write_text("name,p,v\none,15\n")
    one_line(campaign("list", path), 3, ":2: 2 columns, 3 are expected")
    path.write_text("name,p,vv\none,15,3\n")
    one_line(campaign("list", path), 3, ":1: unknown column 'vv'; known: p, v, strength, ")
    path.write_text("name,p\none,much\n")
    one_line(campaign("list", path), 3, ":2: p: 'much' is not allowed, must be a number > 0 (MPa)")
    path.write_text('name,p\none,5\ntwo,6,"5\n')
    one_line(campaign("list", path), 3, ":3: not CSV: unexpected end of data")
    path.write_text("name,p,p\none,1,2\n")
    one_line(campaign("list", path), 3, ":1: column 'p' appears twice")
    path.write_text("name,p\none,010\n")
    one_line(campaign("list", path), 3, ":2: p: '010' is not allowed")


@pytest.mark.parametrize("code", ["utf-8", "utf-8-sig", "utf-16"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_csv_plan_as_spreadsheets_write_it(tmp_path, code, end):
    path = tmp_path / "plan.csv"
    for separator in ";\t":
        text = end.join(["name;p;v", "one;1,5;5", "two;22;0,5e1", ""])
        path.write_bytes(text.replace(";", separator).encode(code))
        runs = plans.read(str(path)).runs
        assert [(r.name, r.values["p"], r.values["v"]) for r in runs] == [
            ("one", 1.5, 5),
            ("two", 22, 5),
        ]


def test_csv_plan_has_one_decimal_mark(tmp_path):
    path = tmp_path / "plan.csv"
    path.write_text("p;v\n1,5;5\n2;1.500\n")
    one_line(campaign("list", path), 3, ":3: v: '1.500': line 2 has another decimal mark")
    path.write_text("p,v\n22,5,5\n")
    one_line(campaign("list", path), 3, ":2: 3 columns, 2 are expected")
    path.write_bytes("p,v\n1,2\n".encode("utf-16-le"))
    one_line(campaign("list", path), 3, "plan.csv: cannot be read: is UTF-16 without a byte order")


def test_plan_without_a_title_and_with_a_date_for_one(tmp_path):
    path = tmp_path / "plan.yaml"
    for given, title in (("", ""), (" 2001-99-99", "2001-99-99")):
        path.write_text(HEAD + f"title:{given}\nruns: [{{p: [1, 1.5e1, .5]}}]\n")
        plan = plans.read(str(path))
        assert plan.title == title
        assert [run.values["p"] for run in plan.runs] == [1, 15.0, 0.5]


def test_order_is_known(tmp_path):
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "order: seed\nruns: [{p: 1}]\n")
    one_line(campaign("list", path), 3, ":2: order: 'seed' is not allowed, must be cost or plan")


def test_step_follows_the_material():
    def dt(**values):
        return plans.Run(
            "x", {**{k: key.default for k, key in plans.KEYS.items()}, **values}, ""
        ).dt

    assert dt(E=4 * 206000) == 2.5e-5  # half the time of sound
    assert dt() == dt(laws="c weld 0.7") == dt(laws="d") == 4e-5  # slip is damped, too
    assert dt(rho=4 * 7800) == 5e-5  # never longer
    assert dt(eta=0.82) == 2e-5  # half the viscous time
    assert dt(laws="b") == 5e-5 and dt(laws="b", eta=0.82) == 2.5e-5
    assert dt(laws="b viscosity both") == 4e-5
    assert dt(laws="c viscosity normal") == 5e-5
    assert dt(laws="b viscosity both", eta=0.041) == 5e-5
    assert dt(rho=1950) == 1e-5 and dt(laws="b", rho=1950) == pytest.approx(1.2e-5)
    assert dt(dt=1e-5) == 1e-5


def test_flat_blocks_are_told(tmp_path):
    """Rows are 2.165 nm apart; an odd number has one midway."""
    path = tmp_path / "plan.yaml"
    runs = "[{roughness: [1.08, 1.09], rows: [13, 14]}]"
    path.write_text(HEAD + f"runs: {runs}\n")
    said = campaign("list", path).stdout.splitlines()[-1]
    assert said.startswith("warning: roughness1.08-rows14: less roughness")
    path.write_text(HEAD + "runs: [{rows: [13, 14]}]\n")
    assert "warning" not in campaign("list", path).stdout


def test_roughness_beyond_the_free_rows_is_told(tmp_path):
    """8 free rows are 17.3 nm high."""
    path = tmp_path / "plan.yaml"
    path.write_text(HEAD + "runs: [{rows: 14, roughness: [8.6, 8.7, 40]}]\n")
    said = campaign("list", path).stdout.splitlines()[-1]
    assert said.startswith("warning: roughness8.7 and 1 more: more roughness than half the height")


@pytest.mark.parametrize(("page", "runs"), [("campaign", 9), ("howto_campaign", 24)])
def test_plans_on_the_pages_are_plans(tmp_path, page, runs):
    text = (ROOT / f"doc/{page}.md").read_text("utf-8")
    (block,) = re.findall(r"```text\n(format: mca-campaign.*?)```", text, re.DOTALL)
    path = tmp_path / "plan.yaml"
    path.write_text(block)
    assert len(plans.read(str(path)).runs) == runs


SHIPPED = {
    "paper36": 72,
    "equal-kappas": 20,
    "similar": 24,
    "velocity": 16,
    "pressure": 16,
    "viscosity": 2,
    "roughness": 6,
    "smoke": 6,
    "convergence": 24,
    "ductility": 28,
    "width": 84,
    "width-long": 8,
    "light": 6,
    "own-material": 10,
    "temperature": 17,
    "rail": 80,
    "rail-checks": 30,
    "space": 19,
    "laws": 232,
    "laws-long": 68,
}


@pytest.mark.parametrize(
    "name, least",
    [
        pytest.param(name, runs, marks=[LONG] if k % 3 else [])
        for k, (name, runs) in enumerate(SHIPPED.items())
    ],
)
def test_shipped_plans(name, least):
    plan = plans.read(plans.find(name))
    assert len(plan.runs) >= least and plan.title
    assert campaign("list", name).returncode == 0


PAPER = ["paper36", "equal-kappas", "similar", "velocity", "pressure"]


OTHERS = ["viscosity", "roughness", "own-material", "ductility", "light"]
OTHERS += ["temperature", "convergence", "space"]


@pytest.mark.parametrize("name", [*PAPER, *OTHERS])
def test_runs_slide_500_nm(name):
    for run in plans.read(plans.find(name)).runs:
        assert run.values["v"] * run.values["ns"] >= 499.9, run.name


def test_work_counts_the_automata():
    """Automaton-steps, of a plane fragment and of the blocks of examples/space (its log has the
    number)."""
    space, plane = (plans.read(plans.find(name)).runs[0] for name in ("space", "velocity"))
    log = (ROOT / "examples" / "space" / "log.friction.2").read_text()
    automata = int(re.search(r"steps with (\d+) atoms", log).group(1))
    assert space.work == automata * space.steps and space.variables()["depth"] == "8"
    assert plane.work == 80 * 20 * plane.steps and "depth" not in plane.variables()


def test_rail_goes_from_one_seed_to_the_next():
    """All conditions with the first seed, then all with the second; columns by p/sigma_0: 160, or
    what the checks show to do."""
    plan = plans.read(plans.find("rail"))
    assert plan.in_order
    halves = [plan.runs[: len(plan.runs) // 2], plan.runs[len(plan.runs) // 2 :]]
    for seed, runs in enumerate(halves, 1):
        assert {run.values["seed"] for run in runs} == {seed}
    same = [[{**run.values, "seed": 0} for run in runs] for runs in halves]
    assert same[0] == same[1]
    for run in plan.runs:
        assert run.values["v"] * run.values["ns"] == 400, run.name
        ratio = run.values["p"] / run.values["strength"]
        wanted = 80 if 0.29 < ratio < 0.31 else 40 if ratio > 2 else 160
        assert run.values["columns"] == wanted, run.name


FIRST_STEP = ("base", "soft", "strong", "dense", "faint")


EQUAL = ("base", "thin", "thick", "soft", "stiff", "smooth")
FAINT = ("faint", "light")  # below 0.02 of the strength
LONG_STEP = {
    **{"base": 11, "smooth": 9, "dense": 8, "strong": 10, "soft": 7},
    **{"thin": 4, "thick": 4, "light": 5, "faint": 5, "stiff": 3, "slow": 2},
}


@pytest.mark.parametrize(
    "plan, number, slide",
    [
        ("laws", {**dict.fromkeys(FIRST_STEP, 40), "thin": 15, "thick": 15, "slow": 2}, 160),
        ("laws-long", LONG_STEP, 500),
    ],
)
def test_laws_at_their_conditions(plan, number, slide):
    """Each load has the width that it needs; as many runs as sets and seeds."""
    conditions = {}
    for run in plans.read(plans.find(plan)).runs:
        conditions.setdefault(run.name.split("-")[0], []).append(run)
    assert {name: len(runs) for name, runs in conditions.items()} == number
    for name, runs in conditions.items():
        differ = {(r.values["laws"], r.values["seed"], r.values["columns"]) for r in runs}
        assert len(differ) == len(runs)
        share = runs[0].values["p"] / runs[0].values["strength"]
        assert runs[0].values["columns"] == (160 if share < 0.15 else 80), name
        assert (share < 0.02) == (name in FAINT)
        assert (name in EQUAL) == all(
            found == pytest.approx(wanted, rel=2e-3)
            for found, wanted in ((runs[0].kappa1, 2.571), (runs[0].kappa2, 123.6))
        )
        slid = runs[0].values["v"] * runs[0].values["ns"]
        assert slid == pytest.approx(slide, abs=1), name


def test_a_folder_does_not_hide_the_plan_of_its_name(tmp_path, monkeypatch):
    (tmp_path / "paper36").mkdir()
    monkeypatch.chdir(tmp_path)
    assert plans.find("paper36") == os.path.join(plans.SHIPPED, "paper36.yaml")


def test_paper36_covers_the_papers_ranges():
    runs = plans.read(plans.find("paper36")).runs
    assert len({run.name.split("-")[0] for run in runs}) == 36
    kappa1, kappa2 = sorted(r.kappa1 for r in runs), sorted(r.kappa2 for r in runs)
    assert kappa1[0] < 0.1 and kappa1[-1] == pytest.approx(19, rel=0.01)
    assert kappa2[0] == pytest.approx(2, rel=0.05) and kappa2[-1] == pytest.approx(633, rel=0.01)
    for key, low, high in (("p", 0.5, 26), ("v", 1, 10), ("strength", 92, 552)):
        values = [r.values[key] for r in runs]
        assert min(values) == low and max(values) == high
    for key in ("E", "rho", "eta"):
        assert len({r.values[key] for r in runs}) >= 3


def test_ten_conditions_have_one_kappa():
    runs = plans.read(plans.find("equal-kappas")).runs
    assert len({run.name.split("-")[0] for run in runs}) == 10
    for run in runs:
        assert run.kappa1 == pytest.approx(runs[0].kappa1, rel=1e-3)
        assert run.kappa2 == pytest.approx(runs[0].kappa2, rel=1e-3)
        for key, low, high in (("p", 0.5, 26), ("v", 1, 10), ("strength", 92, 552)):
            assert low <= run.values[key] <= high  # the paper's ranges


def test_page_has_every_key_option_and_plan():
    page = (ROOT / "doc" / "campaign.md").read_text()
    keys = dict(
        re.findall(
            r"^\| `(\w+)` \| ([^|]+) \| "
            r"(?:ns|MPa|m/s|kg|Pa|Poisson|automata|rows|layers|nm|of the|total|preset|potential|K,)"
            r"[^|]*\|$",
            page,
            re.MULTILINE,
        )
    )
    assert list(keys) == list(plans.KEYS)
    for name, key in plans.KEYS.items():
        if key.default is not None:
            assert keys[name] == (
                key.default if isinstance(key.default, str) else f"{key.default:g}"
            )
    options = set()
    for command in ("list", "run", "one", "status", "pack"):
        said = campaign(command, "--help").stdout
        assert said.startswith(f"usage: campaign {command} [-h] ")
        usage, description, arguments = said.split("\n\n", 2)
        assert description.endswith(".") and "PLAN " in arguments
        helps = re.findall(r"^  (?:\S| (?=\S))+(?:\n {10}|  ) *(.*)$", arguments, re.MULTILINE)
        assert len(helps) == arguments.count("\n  -") + 1 and all(helps), said
        options |= set(re.findall(r"(?<![\w-])(--?[a-z]+)", said.split("options:")[1]))
    syntax = page.split("## Examples")[0]
    table = set(re.findall(r"`(--?[a-z]+)`", syntax))
    assert options - {"-h", "--help", "-np"} == table
    shipped = dict(
        re.findall(
            r"^\| `([\w-]+)` \| (\d+) \|",
            page.split("### Shipped plans")[1].split("###")[0],
            re.MULTILINE,
        )
    )
    assert {n: int(k) for n, k in shipped.items()} == {
        n: len(plans.read(plans.find(n)).runs) for n in SHIPPED
    }
