# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/build_docs.sh: every page of ours goes through, needs no network, and faults are errors."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def build(root, folder):
    return subprocess.run(
        [root / "tools" / "build_docs.sh", folder / "site"],
        env={**os.environ, "MCAWR_BUILD": str(folder)},
        text=True,
        capture_output=True,
        timeout=200,
        check=False,
    )


def test_site(tmp_path):
    done = build(ROOT, tmp_path)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    site = tmp_path / "site"
    pages = list(site.rglob("*.html"))
    for page in [ROOT / "README.md", *(ROOT / "doc").glob("*.md")]:
        assert (site / page.relative_to(ROOT)).with_suffix(".html") in pages
    for page in pages:
        text = page.read_text(encoding="utf-8")
        fetched = re.findall(r'<(?:script|img)[^>]* src="([^"]+)', text)
        fetched += re.findall(r'<link rel="stylesheet"[^>]* href="([^"]+)', text)
        for file in fetched:
            assert (page.parent / re.sub(r"\?.*", "", file)).exists(), (page, file)
    laws = (site / "doc/laws.html").read_text(encoding="utf-8")
    assert 'mathjax/MathJax.js?config=TeX-AMS_SVG-full"' in laws
    assert laws.count('class="math') > 100
    assert "viscos" in (site / "searchindex.js").read_text(encoding="utf-8")


@pytest.mark.long
def test_faults_are_errors(tmp_path):
    """A link and an anchor that lead nowhere, and a page that is not in the navigation."""
    copy = tmp_path / "copy"
    copy.mkdir()
    for file in [
        *ROOT.glob("*.md"),
        ROOT / "LICENSE",
        ROOT / "CITATION.cff",
        ROOT / "CMakeLists.txt",
    ]:
        shutil.copy(file, copy)
    for folder in ("doc", "examples", "tools"):
        ignored = shutil.ignore_patterns("*.friction", "*.profile", "__pycache__")
        shutil.copytree(ROOT / folder, copy / folder, ignore=ignored)
    with open(copy / "doc" / "wr_fit.md", "a", encoding="utf-8") as page:
        page.write("\n[one](no_page.md) [two](laws.md#no-heading)\n")
    (copy / "doc" / "lost.md").write_text("# Lost\n", encoding="utf-8")
    done = build(copy, tmp_path)
    assert done.returncode == 1
    faults = [line for line in done.stderr.splitlines() if "WARNING" in line]
    assert len(faults) == 3, done.stderr
    for word in ("no_page.md", "no-heading", "lost.md"):
        assert sum(word in line for line in faults) == 1, done.stderr
