#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The pages as a site: HTML that can be searched, without a network.
# shellcheck source=tools/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: build_docs.sh [DIR]

Builds the Markdown pages into a site in DIR (default: build/site), with Sphinx, MyST and the theme
Furo from Debian. Open DIR/index.html; search and formulas work without a network. A link that
leads nowhere, or a page missing in the navigation (doc/site/conf.py), is an error.

Environment: as for setup.sh
Exit codes: 0 ok, 1 a page is wrong, 2 usage, 5 packages are missing.
HELP
}
case ${1:-} in
  -h | --help) usage; exit 0 ;;
  -*) die 2 "unknown option '$1'; see --help" ;;
esac
[ $# -le 1 ] || die 2 "one folder at most; see --help"
site=${1:-$build/site}
for file in /usr/bin/sphinx-build /usr/lib/python3/dist-packages/{myst_parser,furo} \
  /usr/share/javascript/mathjax/MathJax.js; do
  [ -e "$file" ] || die 5 "$file is missing: apt-get install \
python3-sphinx python3-myst-parser furo libjs-mathjax (tools/setup.sh installs them)"
done
# -n: also references that Markdown does not check; -W: a warning is an error
/usr/bin/python3 -m sphinx -q -n -W --keep-going -b html -c "$root/doc/site" \
  -d "$build/site.doctrees" "$root" "$site" || die 1 "the pages have faults, see above"
say "$site/index.html"
