# SPDX-License-Identifier: GPL-2.0-or-later
"""Doc pages against the sources: LAMMPS's sections, every keyword on its page and none that does
not exist, links that lead somewhere, input scripts that run.

A fenced block marked ``lammps`` is a complete input script and is run; excerpts are ``text``.
"""

import os
import re
import subprocess
import zlib
from pathlib import Path

import pytest
import yaml

from mcawr import friction_log, layer_health
from mcawr.files import read_text
from single_rank import alone

ROOT = Path(__file__).resolve().parents[2]

MCA = ROOT / "src" / "MCA"
LMP = os.environ.get("MCAWR_LMP", str(ROOT / "build" / "bin" / "lmp"))
PAGES = [
    ROOT / "README.md",
    *sorted((ROOT / "doc").glob("*.md")),
    *sorted((ROOT / "examples").glob("*/README.md")),
]

# the fourth section is named after what the kind of style has to say there
STATE = {
    "fix": "Restart, fix_modify, output, run start/stop, minimize info",
    "pair": "Mixing, shift, table, tail correction, restart, rRESPA info",
    "compute": "Output info",
    "region": "Restart, output info",
    "command": "Restart, run start/stop info",
}


def name(path):
    return str(path.relative_to(ROOT))


def source(file):
    return (MCA / file).read_text(encoding="utf-8")


def page(file):
    return (ROOT / "doc" / file).read_text(encoding="utf-8")


def without_code(text):
    return re.sub(
        r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    )


def section(text, title):
    """What stands below that heading, up to the next one of the same level."""
    found = re.search(rf"^## {re.escape(title)}\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    assert found, f"no section {title}"
    return found.group(1)


def styles():
    """(kind, style, page) of all that the plugin registers; upper case is internal."""
    found = re.findall(r'add\("(\w+)", "([\w/]+)"', source("mca_plugin.cpp"))
    assert len(found) > 5
    for kind, style in found:
        if style.upper() != style:
            prefix = "" if kind == "command" else f"{kind}_"
            yield pytest.param(
                kind, style, f"{prefix}{style.replace('/', '_')}.md", id=f"{kind} {style}"
            )


@pytest.mark.parametrize("kind, style, file", styles())
def test_sections(kind, style, file):
    text = page(file)
    title = {"pair": f"pair_style {style}", "command": style}.get(kind, f"{kind} {style}")
    assert text.splitlines()[0] == f"# {title} command"
    assert re.findall(r"^## (.+)$", without_code(text), re.MULTILINE) == [
        "Syntax",
        "Examples",
        "Description",
        STATE[kind],
        "Restrictions",
        "Related commands",
        "Default",
    ]
    index = page("README.md")
    assert f"]({file})" in index


# ---- keywords: those that a source parses, and those that the page's Syntax names


def listed(text, what):
    """Words in *italics* of the list item "keyword = *a* or *b* ..."."""
    item = re.search(rf"^\* {what} = (.*?)(?=^\* |^\n|^```)", text, re.MULTILINE | re.DOTALL)
    assert item, f"no list of {what}"
    return re.findall(r"\*([^*\s]+)\*", item.group(1))


def attributes(file):
    """The compute's table of names."""
    table = r"static const char \*const \w+\[\w*\] = \{(.*?)\};"
    return re.findall(r'"(\w+)"', re.search(table, source(file), re.DOTALL)[1])


def pair_values():
    """{keyword: what it takes} of the Syntax section; unittest/MCA/test_law_docs.cpp holds it
    against the laws."""
    syntax = section(page("pair_mca.md"), "Syntax")
    return dict(re.findall(r"^(\w+) value = (.*)$", syntax, re.MULTILINE))


def test_pair_keywords():
    parsed = re.findall(r'strcmp\(arg\[iarg\], "(\w+)"\)', source("pair_mca_setup.cpp"))
    assert len(parsed) == 3 and set(parsed) <= pair_values().keys()
    syntax = section(page("pair_mca.md"), "Syntax")
    assert sorted(listed(syntax, "keyword")) == sorted(pair_values())


def test_pair_defaults():
    """The Default section says what the table of presets has for preset d."""
    text = page("pair_mca.md")
    rows = dict(re.findall(r"^\| \*(\w+)\* \| .*? \| .*? \| .*? \| (.*?) \|$", text, re.MULTILINE))
    default = " ".join(section(text, "Default").split())
    assert len(rows) > 8 and rows.keys() <= pair_values().keys()
    for keyword, value in [("preset", "d"), *rows.items()]:
        assert f"{keyword} = {value}" in default, keyword


def explained(syntax):
    return [
        word
        for words in re.findall(r"^([\w,]+) = ", syntax, re.MULTILINE)
        for word in words.split(",")
    ]


@pytest.mark.parametrize(
    "file, table",
    [
        ("fix_mca_events.md", "fix_mca_events.cpp"),
        ("compute_mca_link_local.md", "compute_mca_link_local.cpp"),
    ],
)
def test_compute_attributes(file, table):
    syntax = section(page(file), "Syntax")
    assert listed(syntax, "attribute") == attributes(table)
    assert explained(syntax) == attributes(table)


def test_atom_attributes():
    """compute mca/atom shows what it finds itself and the states of automata."""
    table = source("core/automaton_states.h")
    states = re.findall(
        r'\{"\w+",\s+In::\w+,\s+Upkeep::\w+,\s+(nullptr|"\w+"),\s+In::(\w+),\s+"(.*?)",'
        r'\s+"(.*?)"(?:, false)?\}',
        table,
    )
    assert states and len(states) == len(re.findall(r'^    \{"', table, re.MULTILINE))
    shown = {name.strip('"'): words for name, *words in states if name != "nullptr"}
    found = re.findall(r'^      \{"(\w+)", ', source("compute_mca_atom.cpp"), re.MULTILINE)
    assert len(found) == 13 and shown
    syntax = section(page("compute_mca_atom.md"), "Syntax")
    assert sorted(listed(syntax, "attribute")) == sorted([*found, *shown])
    assert explained(syntax) == listed(syntax, "attribute")
    for name, (dimensions, unit, meaning) in shown.items():
        line = f"{name} = {meaning}" + (f" ({unit})" if unit else "")
        line += {"Both": "", "Plane": ", dimension 2 only", "Space": ", dimension 3 only"}[
            dimensions
        ]
        assert line in syntax.splitlines(), name


@pytest.mark.parametrize(
    "file, parser, pattern",
    [
        ("fix_mca_drive.md", "fix_mca_drive.cpp", r'keyword == "(\w+)"'),
        ("mca_links.md", "mca_links.cpp", r'strcmp\(arg\[iarg\], "(\w+)"\)'),
    ],
)
def test_keywords(file, parser, pattern):
    parsed = re.findall(pattern, source(parser))
    syntax = section(page(file), "Syntax")
    assert parsed and sorted(listed(syntax, "keyword")) == sorted(set(parsed))
    assert sorted(re.findall(r"^(\w+) value = ", syntax, re.MULTILINE)) == sorted(set(parsed))


def test_potential_file():
    """The table of quantities with what is allowed, and the example, which is steel.mca."""
    coded = re.findall(
        r'\{"(\w+)", &Material::\w+, "([^"]+)",\s*"([^"]+)"\}', source("laws/material.cpp")
    )
    text = page("potential_file.md")
    table = re.findall(r"^\| `(\w+)` \|[^|]*\| (.*?) \| (.*?) \|$", text, re.MULTILINE)
    assert coded and table == coded
    steel = (ROOT / "potentials" / "steel.mca").read_text(encoding="utf-8").splitlines()
    assert "\n".join([steel[0]] + [line for line in steel if not line.startswith("#")]) in text


def test_bounds_of_a_solid_layer():
    """Python's are those of C++, and the page's."""
    header = (ROOT / "src/shared/layer_health.h").read_text(encoding="utf-8")
    bounds = dict(re.findall(r"constexpr double (\w+) = ([0-9.e-]+);", header))
    assert float(bounds["sinkAllowance"]) == layer_health.SINK
    assert float(bounds["fallAllowance"]) == layer_health.FALL
    assert float(bounds["smoothLimit"]) == layer_health.SMOOTH
    text = " ".join(page("friction_log.md").split())
    assert f"$1 - p/K - {bounds['sinkAllowance']}$" in text
    assert f"by more than {bounds['fallAllowance']} of the work" in text
    assert f"With fewer than {float(bounds['leastJunctions']):g} mu scatters" in text
    assert f"more than {100 * layer_health.SMOOTH:g} % of the way were smooth" in text


def test_friction_log():
    """Columns and head as the format's one description for C++ has them, in Python, too."""
    schema = (ROOT / "src/shared/friction_log_format.h").read_text(encoding="utf-8")
    row = re.compile(r'\{&Row::\w+, "(\w+)", "([^"]*)", Over::(\w+),')
    assert row.findall(schema) == list(map(tuple, friction_log.TABLE))
    assert re.search(r'checkName = "(\w+)"', schema)[1] == friction_log.CHECK
    columns = [*friction_log.COLUMNS, friction_log.CHECK]
    text = page("friction_log.md")
    table = re.findall(r"^\| `(\w+)` \|[^|]*\| ?([^|]*?) ?\|$", text, re.MULTILINE)
    assert table == [
        *((column.name, column.unit) for column in friction_log.TABLE),
        (friction_log.CHECK, ""),
    ]
    assert f"\n{' '.join(columns)}\n" in text
    sections = re.search(r"namespace section {(.*?)}", schema, re.DOTALL)[1]
    written = ["format"] + re.findall(r'"(\w+)"', sections)
    example = re.search(r"^```text\n(.*?)^```", text, re.MULTILINE | re.DOTALL)[1]
    assert re.findall(r"^# (\w+): ", example, re.MULTILINE) == written
    head, _, check = example.rstrip("\n").rpartition(" ")
    assert int(check) == zlib.crc32(f"{head} ".encode())
    numbers = re.findall(r'\{&Head::\w+, section::(\w+), "(\w+)"', schema)
    given = yaml.safe_load(re.sub("^# ", "", example, flags=re.MULTILINE).split("\nstep ")[0])
    assert numbers == [
        (section, key)
        for section in dict(numbers)
        for key in given[section]
        if (section, key) != ("geometry", "packing")
    ]
    for head in re.findall(r"^\| `(\w+)` \|[^|]*\|$", text, re.MULTILINE):
        assert head in written
    shipped = read_text(f"{ROOT}/examples/campaign/logs/velocity.tar.xz/v5-seed1.friction")
    laws = [
        re.findall(r"(\w+):", re.search(r"^# laws: (.*)", log, re.MULTILINE)[1])
        for log in (example, shipped)
    ]
    assert laws[0] == laws[1]
    packed = re.search(r"^# (campaign: {.*})", text, re.MULTILINE)[1]
    assert yaml.safe_load(packed)["campaign"].keys() == {"command", "rows_averaged"}


def test_example_variables():
    """The table of the friction example is what its script has."""
    script = (ROOT / "examples" / "friction" / "in.friction").read_text(encoding="utf-8")
    text = (ROOT / "examples" / "friction" / "README.md").read_text(encoding="utf-8")
    default = {
        k: v.replace("${name}", "NAME").replace("${material}", "MATERIAL")
        for k, v in re.findall(
            r"^variable +(\w+) +(?:index|equal) +([^\s#]+) *(?:#.*)?$",
            script.split("\nif ")[0],
            re.MULTILINE,
        )
    }
    table = re.findall(r"^\| `(\w+)` \| `?(.*?)`? \|", text, re.MULTILINE)
    assert default and dict(table) == default


def test_region_arguments():
    syntax = section(page("region_mca_rough.md"), "Syntax")
    order = re.search(r'needs: below\|above ([\w ]+)"', source("region_mca_rough.cpp"))[1]
    assert f"region ID mca/rough side {order} keyword value ..." in syntax


# ---- links and scripts


def anchors(text):
    """GitHub's anchors of the headings."""
    return [
        re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        for title in re.findall(r"^#+ (.+)$", without_code(text), re.MULTILINE)
    ]


@pytest.mark.parametrize("path", PAGES, ids=name)
def test_links(path):
    targets = re.findall(r"\]\(([^)\s]+)\)", without_code(path.read_text(encoding="utf-8")))
    for target in targets:
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        goal = path.parent / file if file else path
        assert goal.exists(), target
        if anchor:
            assert anchor in anchors(goal.read_text(encoding="utf-8")), target


@pytest.mark.parametrize("path", PAGES, ids=name)
def test_blocks_are_marked(path):
    """Every fenced block says what it is, and none stays open; Python is Python."""
    text = path.read_text(encoding="utf-8")
    fences = re.findall(r"^```(.*)$", text, re.MULTILINE)
    assert len(fences) % 2 == 0
    assert all(
        fence in ("text", "lammps", "sh", "python", "c", "yaml", "json", "csv", "bibtex")
        for fence in fences[::2]
    )
    assert not any(fences[1::2])
    for block in re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        compile(block, path.name, "exec")


@pytest.mark.parametrize(
    "path", [*PAGES, ROOT / "CHANGELOG.md", ROOT / "CONTRIBUTING.md"], ids=name
)
def test_lines_are_short(path):
    """At most 100 columns, but for what cannot be broken: code, rows of tables, pictures."""
    text = re.sub(
        r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL
    )
    long = [line for line in text.splitlines() if len(line) > 100 and line[:1] not in "|!"]
    assert not long


def scripts():
    found = [
        pytest.param(block, id=f"{name(path)}-{number}")
        for path in PAGES
        for number, block in enumerate(
            re.findall(
                r"^```lammps\n(.*?)^```", path.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
            ),
            1,
        )
    ]
    assert found
    return found


@pytest.mark.parametrize("script", scripts())
def test_script_runs(script, tmp_path):
    (tmp_path / "in.doc").write_text(script, encoding="utf-8")
    done = subprocess.run(
        [LMP, "-in", "in.doc"],
        cwd=tmp_path,
        env=os.environ | alone(tmp_path),
        timeout=120,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:]
    # July 2026 says so of a plugin's command when `clear` loads the plugin again; samples of pages,
    # but for the README's, are small
    expected = ["Overriding built-in command style mca_links", "may rub half as much as a wide one"]
    warnings = [
        line
        for line in done.stdout.splitlines()
        if "WARNING" in line and not any(text in line for text in expected)
    ]
    assert "Total wall time" in done.stdout and not warnings, done.stdout[-3000:]
