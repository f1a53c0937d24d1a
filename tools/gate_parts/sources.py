# SPDX-License-Identifier: GPL-2.0-or-later
"""The project's source files, by language."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("src", "unittest", "tools", "cmake", "examples", ".ci")
SUFFIXES = {".cpp": "c++", ".h": "c++", ".py": "python", ".sh": "shell", ".cmake": "cmake"}
Files = dict[str, list[pathlib.Path]]  # of each language
INTERPRETERS = {"python3": "python", "bash": "shell", "sh": "shell"}


def language(path: pathlib.Path) -> str | None:
    """Language of a file by its name, else by its first line; None for other files."""
    if path.name == "CMakeLists.txt":
        return "cmake"
    if path.suffix in SUFFIXES:
        return SUFFIXES[path.suffix]
    with open(path, "rb") as file:
        first = file.readline(80)
    if not first.startswith(b"#!"):
        return None
    return INTERPRETERS.get(first.decode("utf-8", "replace").split("/")[-1].strip())


def find() -> Files:
    """{language: [paths]} of all source files, in order; templates (*.in) are left out."""
    paths = [ROOT / "CMakeLists.txt"]
    for folder in FOLDERS:
        paths += (ROOT / folder).rglob("*")
    found: Files = {}
    for path in sorted(paths):
        parts = path.relative_to(ROOT).parts
        if path.suffix == ".in" or "__pycache__" in parts or "logs" in parts or not path.is_file():
            continue
        if (name := language(path)) is not None:
            found.setdefault(name, []).append(path)
    return found


def shown(path: pathlib.Path | str) -> str:
    """A path as the user sees it: from the project's root."""
    path = pathlib.Path(path)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)
