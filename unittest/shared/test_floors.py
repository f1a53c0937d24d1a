# SPDX-License-Identifier: GPL-2.0-or-later
"""Who may include whom: every #include "..." of the sources against the table of floors.

A floor is a folder below src; a file belongs to the deepest floor of the table that holds it. It
may include its own floor and those that the table names, nothing else of the project. Headers of
others are named with <> everywhere but in the LAMMPS styles, whose host wants "atom.h"."""

import os
import re
from pathlib import Path

import pytest

SOURCE = Path(os.environ.get("PROJECT_SOURCE", Path(__file__).resolve().parents[2])) / "src"

PATCH_ROOMS = [
    f"WHEELRAIL/contact/patch/{room}" for room in ("solvers", "surfaces", "elasticity", "formats")
]
FLOORS = {
    "shared": [],
    # wheel and rail: base below law below fit and contact below creep
    "WHEELRAIL/base": ["shared"],
    "WHEELRAIL/law": ["WHEELRAIL/base", "shared"],
    "WHEELRAIL/fit": ["WHEELRAIL/law", "WHEELRAIL/base", "shared"],
    "WHEELRAIL/contact": ["WHEELRAIL/base", "shared"],
    "WHEELRAIL/contact/line": ["WHEELRAIL/contact", "WHEELRAIL/law", "WHEELRAIL/base", "shared"],
    # the rooms of the patch, and above them what puts one contact together
    "WHEELRAIL/contact/patch/formats": ["WHEELRAIL/base", "shared"],
    "WHEELRAIL/contact/patch/elasticity": ["WHEELRAIL/contact", "WHEELRAIL/base", "shared"],
    "WHEELRAIL/contact/patch/solvers": [
        "WHEELRAIL/contact/patch/elasticity",
        "WHEELRAIL/contact",
        "WHEELRAIL/base",
        "shared",
    ],
    "WHEELRAIL/contact/patch/surfaces": [
        "WHEELRAIL/contact/patch/elasticity",
        "WHEELRAIL/contact/patch/formats",
        "WHEELRAIL/contact",
        "WHEELRAIL/base",
        "shared",
    ],
    "WHEELRAIL/contact/patch": [*PATCH_ROOMS, "WHEELRAIL/contact", "WHEELRAIL/base", "shared"],
    # creep: the sweep knows no contact, line and patch do not know each other, cases know both
    "WHEELRAIL/creep/sweep": ["WHEELRAIL/contact", "WHEELRAIL/law", "WHEELRAIL/base", "shared"],
    "WHEELRAIL/creep/line": [
        "WHEELRAIL/creep/sweep",
        "WHEELRAIL/contact/line",
        "WHEELRAIL/contact",
        "WHEELRAIL/law",
        "WHEELRAIL/base",
        "shared",
    ],
    "WHEELRAIL/creep/patch": [
        "WHEELRAIL/creep/sweep",
        "WHEELRAIL/contact/patch",
        *PATCH_ROOMS,
        "WHEELRAIL/contact",
        "WHEELRAIL/law",
        "WHEELRAIL/base",
        "shared",
    ],
    "WHEELRAIL/creep/case": [
        "WHEELRAIL/creep/line",
        "WHEELRAIL/creep/patch",
        "WHEELRAIL/creep/sweep",
        "WHEELRAIL/law",
        "WHEELRAIL/base",
        "shared",
    ],
    # asked step by step, and the interfaces over it
    "WHEELRAIL/creep/online": [
        "WHEELRAIL/creep/case",
        "WHEELRAIL/creep/patch",
        "WHEELRAIL/contact/patch",
        "WHEELRAIL/contact/patch/elasticity",
        "WHEELRAIL/base",
    ],
    "WHEELRAIL/c": [
        "WHEELRAIL/creep/online",
        "WHEELRAIL/creep/case",
        "WHEELRAIL/creep/patch",
        "WHEELRAIL/base",
        "shared",
    ],
    "WHEELRAIL/python": [
        "WHEELRAIL/creep/online",
        "WHEELRAIL/creep/case",
        "WHEELRAIL/creep/line",
        "WHEELRAIL/creep/patch",
        "WHEELRAIL/creep/sweep",
        "WHEELRAIL/contact/patch/elasticity",
        "WHEELRAIL/fit",
        "WHEELRAIL/law",
        "WHEELRAIL/base",
        "shared",
    ],
    "WHEELRAIL": [
        "WHEELRAIL/creep/case",
        "WHEELRAIL/creep/line",
        "WHEELRAIL/creep/patch",
        "WHEELRAIL/creep/sweep",
        "WHEELRAIL/fit",
        "WHEELRAIL/law",
        "WHEELRAIL/base",
        "shared",
    ],
    # automata: laws below core below files below the LAMMPS styles
    "MCA/laws": ["shared"],
    "MCA/core": ["MCA/laws", "shared"],
    "MCA/files": ["MCA/core", "MCA/laws", "shared"],
    "MCA": ["MCA/files", "MCA/core", "MCA/laws", "shared"],
}
# below these no header of LAMMPS and none of MPI, but for the files named
WITHOUT_HOST = {"MCA/laws": [], "MCA/core": ["halo.cpp", "halo.h"], "MCA/files": []}
ROOTS = [SOURCE, SOURCE / "WHEELRAIL", SOURCE / "MCA"]  # of include paths
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.MULTILINE)


def sources():
    return sorted(p for p in SOURCE.rglob("*") if p.suffix in (".h", ".cpp"))


def floor_of(path):
    """The deepest floor of the table that holds a file of the project."""
    folder = path.relative_to(SOURCE).parent.as_posix()
    while folder not in FLOORS:
        assert folder != ".", f"{path} lies on no floor of the table"
        folder = Path(folder).parent.as_posix()
    return folder


def target(file, name):
    """The file of the project that an #include means; None when it is somebody else's. A tree never
    names the other one: its own folder is looked at first."""
    tree = SOURCE / file.relative_to(SOURCE).parts[0]
    for root in [file.parent, tree, *ROOTS]:
        if (root / name).is_file():
            return (root / name).resolve()
    return None


def arrows():
    for file in sources():
        for quote, name in INCLUDE.findall(file.read_text()):
            yield file, quote, name, target(file, name) if quote == '"' else None


def test_includes_point_down():
    wrong = []
    for file, _, name, other in arrows():
        if other is None:
            continue
        here, there = floor_of(file), floor_of(other)
        if there != here and there not in FLOORS[here]:
            wrong.append(
                f"{file.relative_to(SOURCE)} includes {name}: {here} may not include {there}"
            )
    assert not wrong, "\n".join(wrong)


def test_the_table_has_no_circle():
    def below(floor, seen):
        assert floor not in seen, f"circle: {' -> '.join([*seen, floor])}"
        for other in FLOORS[floor]:
            below(other, [*seen, floor])

    for floor in FLOORS:
        below(floor, [])


def module_of(file):
    """A header and its source are one module."""
    return file.relative_to(SOURCE).with_suffix("").as_posix()


def circles(tree):
    """Modules below this folder that include each other, directly or through others."""
    includes = {}
    for file, _, _, other in arrows():
        if other is not None and module_of(other) != module_of(file):
            includes.setdefault(module_of(file), set()).add(module_of(other))

    def reach(module, seen):
        for other in includes.get(module, ()):
            if other not in seen:
                seen.add(other)
                reach(other, seen)
        return seen

    below = {module: reach(module, set()) for module in includes if module.startswith(f"{tree}/")}
    return [module for module, seen in below.items() if module in seen]


@pytest.mark.parametrize("tree", ["shared", "WHEELRAIL", "MCA"])
def test_includes_point_down_inside_folders(tree):
    """Where a part includes what is made of it, there is a circle."""
    assert not circles(tree)


def test_wheelrail_and_shared_name_every_header_of_theirs():
    """A misspelt or moved header would otherwise pass for somebody else's."""
    wrong = [
        f"{file.relative_to(SOURCE)}: {name}"
        for file, quote, name, other in arrows()
        if quote == '"' and other is None and not file.is_relative_to(SOURCE / "MCA")
    ]
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("floor", WITHOUT_HOST)
def test_no_host_below(floor):
    assert (SOURCE / floor).is_dir()
    wrong = [
        f"{file.relative_to(SOURCE)} includes {name}"
        for file, quote, name, other in arrows()
        if floor_of(file) == floor
        and file.name not in WITHOUT_HOST[floor]
        and ((quote == '"' and other is None) or name in ("mpi.h", "lammps.h"))
    ]
    assert not wrong, "\n".join(wrong)


def test_programs_are_command_lines_only():
    """What stands directly in src/WHEELRAIL is a program: one file that no other includes."""
    assert {p.name for p in (SOURCE / "WHEELRAIL").glob("*.cpp")} == {"wr_creep.cpp", "wr_fit.cpp"}
    assert not list((SOURCE / "WHEELRAIL").glob("*.h"))


def test_the_check_sees_a_wrong_arrow(tmp_path, monkeypatch):
    """The test itself can fail: a law that includes a contact, a law of the automata that includes
    a header of LAMMPS, a part that includes the whole."""
    import sys

    module = sys.modules[__name__]
    for name, text in {
        "WHEELRAIL/law/a.h": '#include "contact/b.h"\n',
        "WHEELRAIL/contact/b.h": "",
        "MCA/laws/c.h": '#include "atom.h"\n',
        "MCA/core/whole.cpp": '#include "part.h"\n',
        "MCA/core/whole.h": "",
        "MCA/core/part.h": '#include "whole.h"\n',
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.setattr(module, "SOURCE", tmp_path)
    monkeypatch.setattr(module, "ROOTS", [tmp_path, tmp_path / "WHEELRAIL", tmp_path / "MCA"])
    with pytest.raises(AssertionError, match="law may not include WHEELRAIL/contact"):
        test_includes_point_down()
    with pytest.raises(AssertionError, match=r"c\.h includes atom\.h"):
        test_no_host_below("MCA/laws")
    assert circles("MCA") == ["MCA/core/part", "MCA/core/whole"]
