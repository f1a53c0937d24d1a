# SPDX-License-Identifier: GPL-2.0-or-later
"""Where our programs are and which version this is: in a checkout, or in a tree that
`cmake --install` made (there ROOT is PREFIX/share/mca-wheelrail)."""

import os
import re
import shutil
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
INSTALLED = os.path.join(ROOT, "VERSION")  # of an installed tree only


def program(name: str) -> str:
    """Path of lmp, wr_fit or wr_creep: of $MCAWR_BUILD, else of the installed tree that this
    script is part of, else of the checkout's build/. It need not be there."""
    build = os.environ.get("MCAWR_BUILD")
    if not build and os.path.exists(INSTALLED):
        name = "lmp-mca" if name == "lmp" else name
        build = os.path.dirname(os.path.dirname(ROOT))
    return os.path.join(build or os.path.join(ROOT, "build"), "bin", name)


def version() -> str:
    """Version and commit, "1.2.3 (v1.2.3-4-gabcdef0)"; the commit is "unknown" outside git."""
    if os.path.exists(INSTALLED):
        with open(INSTALLED, encoding="utf-8") as file:
            return file.read().strip()
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        found = re.search(r"^project\(\S+ VERSION (\S+)", file.read(), re.MULTILINE)
    number = found[1] if found else "unknown"
    commit = ""
    if os.path.exists(os.path.join(ROOT, ".git")) and shutil.which("git"):
        words = ["git", "-C", ROOT, "describe", "--always", "--dirty", "--match", "v[0-9]*"]
        commit = subprocess.run(words, text=True, capture_output=True, check=False).stdout.strip()
    return f"{number} ({commit or 'unknown'})"
