#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Obtain ruff for the gate of that name, once, into the cache.
set -euo pipefail
export LC_ALL=C

usage() {
  cat <<'HELP'
Usage: get_ruff.sh [--tarball FILE] [--print]

Obtains ruff, the linter and formatter for Python, as its authors publish it for Node.js (package
@astral-sh/ruff-wasm-nodejs), through this machine's own npm configuration, checks its SHA-256 and
unpacks it in the cache (no root, no change to the system). Debian 12 has no ruff, and the binary
of later releases needs their C library. A second call finds it there and returns at once. The last
line on standard output is the folder with ruff_wasm.js; everything else goes to standard error.

  --tarball FILE  take this tarball instead of downloading one
  --print         print the folder only, do nothing; exit code 1 if it is not complete yet
  -h, --help      this text

Environment: MCAWR_CACHE  cache folder (default: ${XDG_CACHE_HOME:-~/.cache}/mca-wheelrail)
Exit codes: 0 ok, 2 usage, 5 download, cache or file problem.
HELP
}
say() { printf 'get_ruff: %s\n' "$*" >&2; }
die() { # EXIT-CODE MESSAGE
  local code=$1
  shift
  printf 'get_ruff: error: %s\n' "$*" >&2
  exit "$code"
}

package=@astral-sh/ruff-wasm-nodejs version=0.17.4
tar=astral-sh-ruff-wasm-nodejs-$version.tgz
sha256=114aa8a86810476791a694c5b9c97d001c3c85fb0ff368ff108be589ac744388

tarball='' mode=get
while [ $# -gt 0 ]; do
  case $1 in
    --tarball)
      [ $# -ge 2 ] || die 2 "$1 needs a value; see --help"
      tarball=$2
      shift 2
      ;;
    --print) mode=print && shift ;;
    -h | --help) usage && exit 0 ;;
    *) die 2 "unknown option '$1'; see --help" ;;
  esac
done

if [ -z "${MCAWR_CACHE:-}${XDG_CACHE_HOME:-}${HOME:-}" ]; then
  die 5 "neither MCAWR_CACHE, XDG_CACHE_HOME nor HOME is set: set MCAWR_CACHE to a cache folder"
fi
cache=${MCAWR_CACHE:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/mca-wheelrail}
case $cache in /*) ;; *) cache=$PWD/$cache ;; esac
prefix=$cache/ruff-$version
complete() { [ -f "$prefix/ruff_wasm.js" ] && [ -f "$prefix/complete" ]; }
finish() {
  printf '%s\n' "$prefix"
  exit "$1"
}
if complete; then finish 0; fi
[ $mode = get ] || finish 1

mkdir -p "$cache" 2>/dev/null || true
[ -w "$cache" ] || die 5 "cannot write the cache folder '$cache': set MCAWR_CACHE to one you can"
# one call at a time: a second one waits here and then finds the work done
exec 9>"$cache/ruff.lock"
flock 9
if complete; then finish 0; fi

work=$cache/work-ruff
rm -rf "$work"
mkdir "$work"
trap 'rm -rf "$work"' EXIT
if [ -z "$tarball" ]; then
  command -v npm >/dev/null \
    || die 5 "'npm' is missing: apt-get install npm (tools/setup.sh does), or give --tarball $tar"
  say "downloading $package $version (4 MB)"
  (cd "$work" && npm pack --silent "$package@$version" >&2) \
    || die 5 "could not download $package@$version, see npm's message above; or give --tarball $tar"
  tarball=$work/$tar
fi
[ -r "$tarball" ] || die 5 "--tarball '$tarball': cannot read it"
printf '%s  %s\n' "$sha256" "$tarball" | sha256sum --quiet -c - >/dev/null 2>&1 \
  || die 5 "'$tarball' is not $tar: its SHA-256 differs from $sha256"
mkdir "$work/tree"
tar -xzf "$tarball" -C "$work/tree" --strip-components=1 || die 5 "cannot unpack '$tarball'"
touch "$work/tree/complete"
rm -rf "$prefix"
mv "$work/tree" "$prefix"
say "done: $prefix"
finish 0
