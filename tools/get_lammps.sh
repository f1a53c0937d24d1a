#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Obtain LAMMPS and build lmp for the plugin, once, into a cache outside the checkout.
set -euo pipefail
export LC_ALL=C

usage() {
  cat <<'HELP'
Usage: get_lammps.sh [options]

Obtains the source of LAMMPS (Debian's source package, through this machine's own apt
configuration, in a private apt folder: no root, no change to the system), checks signature and
SHA-256, unpacks what is needed and builds lmp with a shared library, and beside it the Python
module lammps. All is kept in a cache; a second call finds it and returns at once. The last line on
standard output is the folder that holds src/, build/lmp and python/lammps; everything else goes to
standard error.

  --version N        20250204 (default: the stable release of 4 Feb 2025) or 20260704
  --tarball FILE     take this lammps_*.orig.tar.?z instead of downloading one
  --packages "A B"   LAMMPS packages to build (default: BPM EXTRA-COMPUTE EXTRA-DUMP EXTRA-FIX
                     GRANULAR MISC MOLECULE PLUGIN RIGID)
  --source-only      only fetch and unpack; prints the folder that holds src/
  --print            print the folder only, do nothing; exit code 1 if it is not complete yet; then
                     says how the options of another one in the cache differ
  --jobs N           compile jobs at once (default: one a core, at most one per GB of memory)
  -h, --help         this text

Environment: MCAWR_CACHE       cache folder (default: ${XDG_CACHE_HOME:-~/.cache}/mca-wheelrail)
             MCAWR_DEBIAN_URI  base address of a Debian archive (default: what apt here uses)
             CXX, CXXFLAGS     compiler and extra flags for LAMMPS (default: c++, none)
Exit codes: 0 ok, 1 build failed, 2 usage, 5 download, cache or file problem.
HELP
}
say() { printf 'get_lammps: %s\n' "$*" >&2; }
die() { local code=$1; shift; printf 'get_lammps: error: %s\n' "$*" >&2; exit "$code"; }

version=20250204 tarball='' mode=build jobs=''
packages='BPM EXTRA-COMPUTE EXTRA-DUMP EXTRA-FIX GRANULAR MISC MOLECULE PLUGIN RIGID'
while [ $# -gt 0 ]; do
  case $1 in
    --version|--tarball|--packages|--jobs)
      [ $# -ge 2 ] || die 2 "$1 needs a value; see --help"
      case $1 in
        --version) version=$2 ;; --tarball) tarball=$2 ;;
        --packages) packages=$2 ;; --jobs) jobs=$2 ;;
      esac
      shift 2 ;;
    --source-only) mode=source; shift ;;
    --print) mode=print; shift ;;
    -h|--help) usage; exit 0 ;;
    *) die 2 "unknown option '$1'; see --help" ;;
  esac
done

# deb: exact Debian source version; suites: where it may be found; sha256: of the tarball;
# top: folder inside the tarball
case $version in
  20250204) deb=20250204+dfsg.1-2 suites='trixie'
    orig=lammps_20250204+dfsg.1.orig.tar.xz top=lammps-4Feb2025/
    sha256=3671165bd52fad36734e0a9136c5bc5ecb225e03988f8c89aa13366a8b53b1c7 ;;
  20260704) deb=20260704+dfsg-2 suites='forky sid'
    orig=lammps_20260704+dfsg.orig.tar.gz top=''
    sha256=cddbc45a047416bd48a4a0b87f24a5b61b3446982b74d18cafe619c22b17eb62 ;;
  *) die 2 "--version $version is not known; allowed: 20250204, 20260704" ;;
esac
if [ -n "$jobs" ] && ! [[ $jobs =~ ^[1-9][0-9]*$ ]]; then
  die 2 "--jobs '$jobs': a positive whole number is needed"
fi
read -ra packages <<<"$packages"
for p in "${packages[@]}"; do
  [[ $p =~ ^[A-Z0-9-]+$ ]] || die 2 "--packages '$p': not the name of a LAMMPS package"
done

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
pch=$here/../cmake/lammps_pch
if [ -z "${MCAWR_CACHE:-}${XDG_CACHE_HOME:-}${HOME:-}" ]; then
  die 5 "neither MCAWR_CACHE, XDG_CACHE_HOME nor HOME is set: set MCAWR_CACHE to a folder for the cache"
fi
cache=${MCAWR_CACHE:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/mca-wheelrail}
case $cache in /*) ;; *) cache=$PWD/$cache ;; esac

compiler=${CXX:-c++}
release_flags='-O2 -DNDEBUG'
configuration=(-DBUILD_SHARED_LIBS=ON -DBUILD_MPI=ON -DBUILD_OMP=OFF -DBUILD_TOOLS=OFF
  -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON # lmp finds its library wherever both are moved together
  -DBUILD_DOC=OFF -DENABLE_TESTING=OFF -DDOWNLOAD_POTENTIALS=OFF -DLAMMPS_SIZES=smallbig
  -DWITH_JPEG=OFF -DWITH_PNG=OFF -DWITH_FFMPEG=OFF -DWITH_GZIP=OFF -DWITH_CURL=OFF)
options="packages=$(printf '%s\n' "${packages[@]}" | sort -u | tr '\n' ' ')
configuration=${configuration[*]}
flags=$release_flags ${CXXFLAGS:-}
compiler=$($compiler -dumpmachine 2>/dev/null || true) $($compiler -dumpfullversion 2>/dev/null || true)
mpi=$(mpicxx -show 2>/dev/null || true)
pch=$(cat "$pch.cmake" "$pch.h" | grep -v SPDX-License-Identifier | sha256sum)"
have_source() { [ -f "$source_dir/src/version.h" ] && [ -f "$source_dir/python/lammps/core.py" ]; }
source_dir=$cache/lammps-$version-source
prefix=$cache/lammps-$version-$(printf '%s' "$options" | sha256sum | cut -c1-12)
complete() { [ -f "$prefix/complete" ] && [ -x "$prefix/build/lmp" ] && have_source; }

# why a LAMMPS that is in the cache does not do: what it was built with, and what it would be now
say_what_differs() {
  local other line was
  for other in "$cache/lammps-$version-"*; do
    if [ "$other" = "$prefix" ] || ! [ -f "$other/complete" ] || ! [ -f "$other/options" ]; then
      continue
    fi
    say "the LAMMPS in $other was built with other options:"
    while IFS= read -r line; do
      was=$(sed -n "s/^${line%%=*}=//p" "$other/options")
      [ "$was" = "${line#*=}" ] || say "  ${line%%=*} '$was', now '${line#*=}'"
    done <<<"$options"
    say "  (compiler: $(command -v "$compiler" || true), mpicxx: $(command -v mpicxx || true))"
  done
}

case $mode in
  print) printf '%s\n' "$prefix"; complete && exit 0; say_what_differs; exit 1 ;;
  source) if have_source; then printf '%s\n' "$source_dir"; exit 0; fi ;;
  build) if complete; then say "LAMMPS $version is in the cache"; printf '%s\n' "$prefix"; exit 0; fi ;;
esac

need() { # COMMAND DEBIAN-PACKAGE
  command -v "$1" >/dev/null || die 5 "'$1' is missing: apt-get install $2 (tools/setup.sh installs all that is needed)"
}
need flock util-linux; need tar tar; need xz xz-utils; need gzip gzip; need sha256sum coreutils
if [ $mode = build ]; then
  need "$compiler" g++; need cmake cmake; need ninja ninja-build; need mpicxx libopenmpi-dev
  [ "$version" -lt 20260000 ] || need python3 python3
fi
mkdir -p "$cache" 2>/dev/null || true
[ -w "$cache" ] || die 5 "cannot write the cache folder '$cache': set MCAWR_CACHE to a folder you can write"

# One call at a time: a second one waits here and then finds the work done.
exec 9>"$cache/lock"
if ! flock -n 9; then
  say "another call is working in $cache; waiting for it"
  flock 9
fi

check_tarball() { # FILE
  printf '%s  %s\n' "$sha256" "$1" | sha256sum --quiet -c - >/dev/null 2>&1 \
    || die 5 "'$1' is not $orig: its SHA-256 differs from $sha256; remove it and try again"
}

# base address of the Debian archive, from apt's own configuration (needs neither root nor lists)
archive_uri() {
  local codename uris name base
  codename=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")
  uris=$(apt-get --print-uris update 2>/dev/null || true)
  for name in ${codename:+"$codename"} stable testing unstable sid; do
    base=$(sed -n "s|^'\(.*\)/dists/$name/InRelease'.*|\1|p" <<<"$uris")
    [ -n "$base" ] || continue
    # several entries: the plain archive's path ends in /debian
    { grep '/debian/*$' <<<"$base" || printf '%s\n' "$base"; } | head -n 1
    return
  done
}

download() { # leaves $work/$orig
  local key=/usr/share/keyrings/debian-archive-keyring.gpg uri suite
  need apt-get apt
  [ -f $key ] || die 5 "$key is missing: apt-get install debian-archive-keyring"
  uri=${MCAWR_DEBIAN_URI:-$(archive_uri)}
  [ -n "$uri" ] || die 5 "no Debian archive in this machine's apt sources: set MCAWR_DEBIAN_URI, or give --tarball FILE ($orig)"
  for suite in $suites; do
    rm -rf "$work/apt"; mkdir -p "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
    printf '%s\n' 'Types: deb-src' "URIs: $uri" "Suites: $suite" 'Components: main' \
      "Signed-By: $key" >"$work/apt/lammps.sources"
    local apt=(apt-get -q -o "Dir::Etc::SourceList=$work/apt/lammps.sources"
      -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$work/apt/lists"
      -o "Dir::Cache=$work/apt/cache" -o APT::Get::List-Cleanup=0 -o Acquire::Languages=none
      -o Acquire::Retries=3 -o APT::Sandbox::User=)
    say "downloading LAMMPS $deb from Debian's suite $suite (130 to 210 MB)"
    # --tar-only: neither the .dsc nor Debian's patches are needed
    if (cd "$work" && "${apt[@]}" update && "${apt[@]}" source --tar-only --download-only \
          --only-source "lammps=$deb") >&2 && [ -f "$work/$orig" ]; then
      return 0
    fi
    say "suite $suite did not give lammps $deb"
  done
  die 5 "could not download lammps $deb: see apt's message above; or give --tarball FILE ($orig)"
}

get_source() {
  local work=$cache/work-$version file=$tarball
  mkdir -p "$work"
  if [ -n "$tarball" ]; then
    [ -r "$tarball" ] || die 5 "--tarball '$tarball': cannot read it"
  else
    file=$work/$orig
    if [ ! -f "$file" ] || [ ! -f "$work/downloaded" ]; then
      download
      touch "$work/downloaded"
    fi
  fi
  say "checking and unpacking $orig"
  check_tarball "$file"
  rm -rf "$work/tree"; mkdir "$work/tree"
  local members=() m strip=()
  for m in src cmake python doc/lammps.1 LICENSE README; do members+=("$top$m"); done
  [ -z "$top" ] || strip=(--strip-components=1)
  tar -xf "$file" -C "$work/tree" "${strip[@]}" "${members[@]}" \
    || die 5 "cannot unpack '$file'"
  grep -q LAMMPS_VERSION "$work/tree/src/version.h" || die 5 "'$file' holds no LAMMPS source"
  mkdir -p "$work/tree/bench" "$work/tree/potentials"  # LAMMPS's install rules name them
  rm -rf "$source_dir"
  mv "$work/tree" "$source_dir"
  rm -rf "$work"
}

build() {
  local log=$prefix/build.log cores mem
  cores=$(nproc); mem=$(awk '/MemAvailable/ {print int($2/1048576)}' /proc/meminfo)
  jobs=${jobs:-$((cores < mem ? cores : (mem > 0 ? mem : 1)))}
  say_what_differs
  mkdir -p "$prefix"
  printf '%s\n' "$options" >"$prefix/options"
  cp "$pch.h" "$pch.cmake" "$prefix/"
  ln -sfn "../lammps-$version-source/src" "$prefix/src"
  local args=(-S "$source_dir/cmake" -B "$prefix/build" -G Ninja -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_COMPILER=$compiler" "-DCMAKE_CXX_FLAGS_RELEASE=$release_flags"
    "-DCMAKE_PROJECT_lammps_INCLUDE=$prefix/lammps_pch.cmake"
    "${configuration[@]}")
  local p
  for p in "${packages[@]}"; do args+=("-DPKG_$p=ON"); done
  say "configuring LAMMPS $version with ${packages[*]} (log: $log)"
  cmake "${args[@]}" >"$log" 2>&1 || { tail -n 20 "$log" >&2; die 1 "LAMMPS does not configure; log: $log"; }
  say "building lmp with $jobs jobs: 2 to 3 minutes on 2 cores; an interrupted build continues where it stopped"
  NINJA_STATUS='[%f/%t %es] ' ninja -C "$prefix/build" -j "$jobs" >&2 \
    || die 1 "LAMMPS does not build; the message is above"
  "$prefix/build/lmp" -h >"$prefix/lmp_help" 2>&1 || { tail "$prefix/lmp_help" >&2; die 1 "the new lmp does not run"; }
  for p in "${packages[@]}"; do
    grep -qw -e "$p" "$prefix/lmp_help" || die 1 "the new lmp lacks package $p"
  done
  # the Python module looks for the library beside itself
  rm -rf "$prefix/python"
  mkdir "$prefix/python"
  cp -r "$source_dir/python/lammps" "$prefix/python/"
  ln -s ../../build/liblammps.so.0 "$prefix/python/lammps/liblammps.so"
  # objects and the precompiled header are of no use any more
  rm -rf "$prefix/build/CMakeFiles" "$prefix/build/.ninja_deps" "$prefix/build/.ninja_log"
  printf 'LAMMPS %s\n%s\n' "$version" "$options" >"$prefix/complete.tmp"
  mv "$prefix/complete.tmp" "$prefix/complete"
  say "done: $prefix"
}

{ # one block, read as a whole: a change of this file during a build does no harm
  have_source || get_source
  if [ $mode = source ]; then printf '%s\n' "$source_dir"; exit 0; fi
  complete || build
  printf '%s\n' "$prefix"
  exit 0
}
