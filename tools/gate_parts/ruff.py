# SPDX-License-Identifier: GPL-2.0-or-later
"""ruff: rules of ruff.toml, and the format of all Python."""

import difflib
import json
import pathlib
import subprocess
import tomllib

from mcawr.errors import Exit, fail
from mcawr.files import write

from .sources import ROOT, shown

MENDED = ("I001",)  # of the rules: the order of imports


def _module():
    """The folder with ruff, obtained if need be."""
    command = [ROOT / "tools" / "get_ruff.sh"]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        fail(Exit.IO, "ruff cannot be obtained, see above")
    return done.stdout.strip()


def _run(texts):
    """What ruff says of {path: text}, in that order."""
    with open(ROOT / "ruff.toml", "rb") as file:
        options = tomllib.load(file)
    asked = {
        "module": f"{_module()}/ruff_wasm.js",
        "options": options,
        "files": [{"path": str(path), "text": text} for path, text in texts.items()],
    }
    command = ["node", pathlib.Path(__file__).with_name("ruff.js")]
    try:
        done = subprocess.run(
            command, input=json.dumps(asked), capture_output=True, text=True, check=False
        )
    except FileNotFoundError:
        fail(Exit.INTERNAL, "node is missing (Debian: apt-get install nodejs)")
    if done.returncode != 0:
        fail(Exit.INTERNAL, f"ruff failed: {done.stderr.strip()}")
    return json.loads(done.stdout)


def _place(starts, location):
    return starts[location["row"] - 1] + location["column"] - 1


def _mended(text, findings):
    """The text with the fixes of some rules; the last ones first, so that places stay right."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    edits = [e for f in findings if f["code"] in MENDED for e in f["edits"]]
    for edit in sorted(edits, key=lambda e: -_place(starts, e["location"])):
        begin, end = _place(starts, edit["location"]), _place(starts, edit["end_location"])
        text = text[:begin] + (edit["content"] or "") + text[end:]
    return text


def _format_finding(path, text, formatted):
    """Where the text first differs from its format."""
    lines, wanted = text.splitlines(), formatted.splitlines()
    matcher = difflib.SequenceMatcher(None, lines, wanted, autojunk=False)
    first = next((op for op in matcher.get_opcodes() if op[0] != "equal"), (0, 0))
    return f"{shown(path)}:{first[1] + 1}:1: format: not as ruff formats it (tools/gate --fix ruff)"


def check(files, options):
    """Findings in Python files; with options.fix, imports are sorted and files formatted first."""
    texts = {path: path.read_text(encoding="utf-8") for path in files["python"]}
    if not texts:
        return []
    results = _run(texts)
    if options.fix:
        mended = {p: _mended(texts[p], r["findings"]) for p, r in zip(texts, results)}
        for path, result in zip(mended, _run(mended)):
            text = mended[path] if result["formatted"] is None else result["formatted"]
            if text != texts[path]:
                write(path, text)
                texts[path] = text
        results = _run(texts)
    findings = []
    for path, result in zip(texts, results):
        for f in result["findings"]:
            findings.append(f"{shown(path)}:{f['row']}:{f['column']}: {f['code']} {f['message']}")
        if result["formatted"] not in (None, texts[path]):
            findings.append(_format_finding(path, texts[path], result["formatted"]))
    return findings
