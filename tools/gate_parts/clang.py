# SPDX-License-Identifier: GPL-2.0-or-later
"""clang-format and clang-tidy of Debian 12, over the C++ files."""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
from collections.abc import Callable, Iterable
from typing import Any

from mcawr.errors import Exit, fail
from mcawr.files import make_folder, write

from .sources import ROOT, Files, shown

VERSION = 14  # another one formats and finds differently
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.MULTILINE)
FINDING = re.compile(r"^(/.*?):(\d+):(\d+): (?:error|warning): (.*)$")


def _program(name: str) -> str:
    """The program of that name, in the version that the project is checked with."""
    for program in (f"{name}-{VERSION}", name):
        try:
            done = subprocess.run(
                [program, "--version"], capture_output=True, text=True, check=True
            )
        except (FileNotFoundError, subprocess.CalledProcessError):
            continue
        if re.search(rf"version {VERSION}\.", done.stdout):
            return program
    return fail(
        Exit.INTERNAL, f"{name} {VERSION} is missing (Debian 12: apt-get install {name}-{VERSION})"
    )


def _in_parallel(work: Callable[[pathlib.Path], Any], items: Iterable[pathlib.Path]) -> list[Any]:
    """work(item) of all items, as many at a time as there are cores."""
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        try:
            return list(pool.map(work, items))
        except BaseException:  # an interrupt: what waits is not begun
            pool.shutdown(cancel_futures=True)
            raise


# ---- clang-format


def check_format(files: Files, options: argparse.Namespace) -> list[str]:
    """Places that clang-format would change; with options.fix it does."""
    program = _program("clang-format")
    if options.fix and files["c++"]:
        subprocess.run([program, "-i", *files["c++"]], check=True)
    found = _in_parallel(lambda path: _misformatted(program, path), files["c++"])
    return [line for lines in found for line in lines]


def _misformatted(program: str, path: pathlib.Path) -> list[str]:
    command = [program, "--dry-run", "--Werror", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = [match for match in map(FINDING.match, done.stderr.splitlines()) if match]
    if done.returncode != 0 and not lines:
        fail(Exit.INTERNAL, f"{program} {shown(path)}: {done.stderr.strip()}")
    return [f"{shown(m[1])}:{m[2]}:{m[3]}: format: (tools/gate --fix clang-format)" for m in lines]


# ---- clang-tidy


class Unit:
    """A source file as it is compiled."""

    def __init__(self, entry: dict[str, Any]) -> None:
        self.path = pathlib.Path(entry["directory"], entry["file"]).resolve()
        self.command = entry.get("command") or shlex.join(entry["arguments"])
        words = shlex.split(self.command)
        self.folders = []  # in which headers are looked for
        for word, following in zip(words, [*words[1:], ""]):
            if word in ("-I", "-isystem"):
                self.folders.append(pathlib.Path(following))
            elif word.startswith("-I"):
                self.folders.append(pathlib.Path(word[2:]))

    def headers(self, texts: "Texts") -> list[pathlib.Path]:
        """All headers that the file includes and that lie in the project or beside one that does,
        through them too; of others (LAMMPS) those that are included from the project."""
        found, left = {self.path}, [self.path]
        while left:
            path = left.pop()
            if not path.is_relative_to(ROOT):
                continue
            for name in INCLUDE.findall(texts(path)):
                for folder in (path.parent, *self.folders):
                    header = (folder / name).resolve()
                    if header.is_file() and not str(header).startswith("/usr/"):
                        if header not in found:
                            found.add(header)
                            left.append(header)
                        break
        return sorted(found)

    def key(self, texts: "Texts", list_of_checks: str) -> str:
        """Changes with anything that may change the findings: the file, what it includes, how it is
        compiled, the list of checks. System headers count by their packages only through it."""
        digest = hashlib.sha256(f"{list_of_checks}\n{self.command}".encode())
        for path in self.headers(texts):
            digest.update(f"{path}\n{texts(path)}".encode())
        return digest.hexdigest()


def _single(entry: dict[str, Any]) -> list[dict[str, Any]]:
    """What compiles a folder as one source (cmake/Rooms.cmake) as entries of its sources."""
    path = pathlib.Path(entry["directory"], entry["file"])
    if path.parent.name != "Unity" or "command" not in entry:
        return [entry]
    return [
        {**entry, "file": name, "command": entry["command"].replace(entry["file"], name)}
        for name in INCLUDE.findall(path.read_text(encoding="utf-8"))
    ]


def _units(options: argparse.Namespace) -> dict[pathlib.Path, Unit]:
    """{path: Unit} of what the build folder compiles; its commands go to gates/ there."""
    path = options.build / "compile_commands.json"
    try:
        with open(path, encoding="utf-8") as file:
            entries = [single for entry in json.load(file) for single in _single(entry)]
    except OSError as error:
        fail(Exit.IO, f"{path}: cannot be read: {error.strerror}; configure the build first")
    make_folder(options.build / "gates")
    write(options.build / "gates" / "compile_commands.json", json.dumps(entries, indent=1))
    units: dict[pathlib.Path, Unit] = {}
    for entry in entries:  # the same file may be compiled several times, for other processors
        unit = Unit(entry)
        units.setdefault(unit.path, unit)
    return units


class Texts:
    """Contents of files, read once."""

    def __init__(self) -> None:
        self.known: dict[pathlib.Path, str] = {}

    def __call__(self, path: pathlib.Path) -> str:
        if path not in self.known:
            self.known[path] = path.read_text(encoding="utf-8", errors="replace")
        return self.known[path]


def check_tidy(files: Files, options: argparse.Namespace) -> list[str]:
    """Findings of clang-tidy in what is compiled of src and tools, and in the headers they include.

    Unit tests are left out: they would take as long again. A header given alone stands for all
    files that include it.
    """
    program = _program("clang-tidy")
    wanted = set(files["c++"])
    units, texts = _units(options), Texts()
    lists = "\n".join(
        f"{shown(path)}\n{path.read_text(encoding='utf-8')}"
        for path in sorted(
            [
                ROOT / ".clang-tidy",
                *(ROOT / "src").rglob(".clang-tidy"),
                *(ROOT / "unittest").rglob(".clang-tidy"),
            ]
        )
    )
    keys = {
        path: unit.key(texts, lists)
        for path, unit in units.items()
        if any(path.is_relative_to(ROOT / folder) for folder in ("src", "tools"))
        and wanted.intersection(unit.headers(texts))
    }
    memory = options.build / "gates" / "clang-tidy.json"
    clean = json.loads(memory.read_text(encoding="utf-8")) if memory.is_file() else {}
    work = [path for path, key in keys.items() if clean.get(shown(path)) != key]
    # the longest texts first, so that the end is not one long file alone
    work.sort(key=lambda path: -len(units[path].headers(texts)))

    def tidy(path: pathlib.Path) -> list[str]:
        found = _tidied(program, path, memory.parent)
        if not found:
            clean[shown(path)] = keys[path]
            write(memory, json.dumps(clean, indent=1, sort_keys=True))
        return found

    found = _in_parallel(tidy, work)
    return sorted({line for lines in found for line in lines})


def _tidied(program: str, path: pathlib.Path, commands: pathlib.Path) -> list[str]:
    command = [
        program,
        "-p",
        str(commands),
        "--quiet",
        f"--header-filter=^{re.escape(str(ROOT))}/(src|unittest|tools)/",
        "--extra-arg=-Wno-unknown-warning-option",
        str(path),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    lines = [match for match in map(FINDING.match, done.stdout.splitlines()) if match]
    if done.returncode != 0 and not lines:
        fail(Exit.INTERNAL, f"clang-tidy {shown(path)}: {(done.stderr or done.stdout)[-500:]}")
    return [
        f"{shown(m[1])}:{m[2]}:{m[3]}: {m[4].replace(',-warnings-as-errors', '')}" for m in lines
    ]
