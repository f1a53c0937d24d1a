# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx: the pages as they stand in the checkout, as a site (tools/build_docs.sh).

The navigation is below: a page that is missing in it is a warning, and warnings are errors.
"""

import re
from pathlib import Path

from pygments.lexers.shell import BashLexer
from pygments.lexers.special import TextLexer

ROOT = Path(__file__).resolve().parents[2]
MATHJAX = Path("/usr/share/javascript/mathjax")  # Debian's libjs-mathjax
# of MathJax what formulas need: TeX to SVG, which no browser refuses for a file on disk
MATHJAX_PARTS = (
    "MathJax.js",
    "config/TeX-AMS_SVG-full.js",
    "extensions",
    "jax/element",
    "jax/output/SVG/fonts/TeX",
)

project = "MCA-WHEELRAIL"
copyright = "the MCA-WHEELRAIL developers, GPL-2.0-or-later"
CMAKE = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
release = version = re.search(r"^project\(\S+ VERSION (\S+)", CMAKE, re.MULTILINE)[1]

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4  # as GitHub makes them
root_doc = "README"
include_patterns = ["*.md", "doc/*.md", "examples/**/README.md"]
exclude_patterns = ["build*", "results", "src", "unittest", "tools", "cmake"]
html_theme = "furo"
html_title = f"{project} {release}"
html_show_sourcelink = False
html_copy_source = False
html_extra_path = ["index.html"]
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG-full"
myst_update_mathjax = False  # MyST's settings are for MathJax 3
mathjax2_config = {
    "tex2jax": {
        "inlineMath": [[r"\(", r"\)"]],
        "displayMath": [[r"\[", r"\]"]],
        "ignoreClass": "tex2jax_ignore|mathjax_ignore|document",
        "processClass": "math",
    },
    "showMathMenu": False,
    "messageStyle": "none",
}

NAVIGATION = {
    "Begin": "doc/install doc/howto_friction doc/howto_campaign doc/howto_wheelrail"
    " doc/howto_patch doc/howto_tribology doc/howto_view",
    "Examples": "examples/**/README",
    "Plugin": "doc/pair_mca doc/fix_nve_mca doc/fix_mca_drive doc/fix_mca_events"
    " doc/compute_mca_atom doc/compute_mca_energy doc/compute_mca_fragment_atom"
    " doc/compute_mca_link_local doc/region_mca_rough"
    " doc/mca_links",
    "Programs": "doc/wr_fit doc/campaign doc/reproduce doc/wr_creep"
    " doc/wr_creep_axes doc/wr_creep_validation",
    "Libraries": "doc/python doc/c_interface",
    "Files": "doc/potential_file doc/friction_log doc/wr_creep_files",
    "Background": "doc/laws doc/how_close doc/rough_patch doc/how_chosen doc/listings"
    " doc/howto_mechanics"
    " doc/performance",
    "Project": "doc/README doc/architecture doc/testing CONTRIBUTING CHANGELOG",
}


def add_navigation(_, page, source):
    """The navigation, which README.md does not have on other sites."""
    if page == root_doc:
        for caption, pages in NAVIGATION.items():
            lines = "\n".join(pages.split())
            source[0] += f"\n```{{toctree}}\n:hidden:\n:glob:\n:caption: {caption}\n{lines}\n```\n"


def copy_mathjax(app, error):
    """Formulas are drawn without a network."""
    if error is None and app.builder.name == "html":
        from sphinx.util.fileutil import copy_asset

        for part in MATHJAX_PARTS:
            goal = Path(app.outdir) / "_static" / "mathjax" / part
            goal = goal if (MATHJAX / part).is_dir() else goal.parent
            goal.mkdir(parents=True, exist_ok=True)
            copy_asset(str(MATHJAX / part), str(goal))


def setup(app):
    """Called by Sphinx."""
    app.add_lexer("lammps", BashLexer)
    app.add_lexer("csv", TextLexer)
    app.connect("source-read", add_navigation)
    app.connect("build-finished", copy_mathjax)
