# SPDX-License-Identifier: GPL-2.0-or-later
"""The scripts called in the test's own process, which saves the start of Python and matplotlib."""

import importlib.machinery
import importlib.util
import json
import sys
import zlib
from pathlib import Path

import pytest

from mcawr import errors

TOOLS = Path(__file__).resolve().parents[2] / "tools"


def with_checksum(data):
    """wr_fit's JSON as wr_fit writes it."""
    text = json.dumps(data, indent=2) + "\n"
    return text.replace("{\n", f'{{\n  "checksum": "{zlib.crc32(text.encode()):08x}",\n', 1)


def load(script):
    """A script as a module."""
    loader = importlib.machinery.SourceFileLoader(script.replace(".", "_"), str(TOOLS / script))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Caller:
    """call(script, *words): (exit code, what was printed, what was complained of)."""

    def __init__(self, monkeypatch, capfd):
        self.monkeypatch, self.capfd = monkeypatch, capfd
        monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")

    def __call__(self, script, *words):
        self.monkeypatch.setattr(sys, "argv", [str(TOOLS / script), *map(str, words)])
        self.capfd.readouterr()
        with pytest.raises(SystemExit) as end:
            errors.run_script(load(script).main)
        out, err = self.capfd.readouterr()
        if "matplotlib.pyplot" in sys.modules:
            sys.modules["matplotlib.pyplot"].close("all")
        return int(end.value.code or 0), out, err

    def refused(self, code, script, *words):
        """The one line with which it ends with that code."""
        found, out, err = self(script, *words)
        assert (found, err.count("\n"), out) == (code, 1, ""), f"{words}: {found}: {out}{err}"
        assert err.startswith(script), err
        return err
