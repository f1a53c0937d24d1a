#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Packages, LAMMPS, build: all that the other scripts need.
# shellcheck source=tools/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: setup.sh [--no-tests | --gates] [CMAKE-OPTION...]

Installs the Debian packages that are missing (as root, or through sudo), obtains and builds LAMMPS
(tools/get_lammps.sh), then configures and builds the project in build/. What is there already is
left alone; a second call takes seconds.

  --no-tests                  build the plugin and the programs only, without what tests need
  --gates                     install the tools of tools/gate, too
Options that start with -D are given to CMake, for instance
  -DLAMMPS_ROOT=DIR           an existing LAMMPS with its lmp instead of a new one
  -DLAMMPS_TARBALL=FILE       Debian's lammps_*.orig.tar.?z instead of a download
  -DLAMMPS_RELEASE=20260704   the release of July 2026
  -DMCAWR_NATIVE=ON           the plugin compiled for this machine's processor

Environment: MCAWR_BUILD  build folder (default: build/ of the checkout)
             MCAWR_CACHE  cache folder of LAMMPS (default: ${XDG_CACHE_HOME:-~/.cache}/mca-wheelrail)
Exit codes: 0 ok, 1 build failed, 2 usage, 5 packages, download or files.
HELP
}
options=() targets=() tests=1 gates=''
for arg in "$@"; do
  case $arg in
    -h | --help) usage; exit 0 ;;
    --no-tests) targets=(--target programs) tests='' ;;
    --gates) gates=1 ;;
    -D*) options+=("$arg") ;;
    *) die 2 "unknown option '$arg' (CMake options start with -D); see --help" ;;
  esac
done

packages=(
  g++ cmake ninja-build pkg-config libopenmpi-dev openmpi-bin
  libarchive-dev libcli11-dev libfmt-dev libyaml-cpp-dev nlohmann-json3-dev libeigen3-dev
  libfftw3-dev libceres-dev libudunits2-dev libboost-dev libgtest-dev libgmock-dev libbenchmark-dev
  pybind11-dev python3-dev # for the Python module; -DBUILD_PYTHON=OFF does without
  python3 python3-numpy python3-matplotlib python3-yaml python3-pytest python3-meshio
  debian-archive-keyring xz-utils
  dpkg-dev file # for cpack -G DEB
)
[ -z "$tests" ] || packages+=(python3-sphinx python3-myst-parser furo libjs-mathjax) # the site
[ -z "$gates" ] || packages+=(black flake8 mypy clang-format-14 clang-tidy-14 shellcheck git)
missing_packages() {
  local p
  for p in "${packages[@]}"; do
    dpkg-query -W -f '${Status}' "$p" 2>/dev/null | grep -q ' installed$' || echo "$p"
  done
}
install_packages() {
  local missing sudo=()
  command -v dpkg-query >/dev/null || {
    say "not a Debian machine: its packages are taken as they are (needed: ${packages[*]})"
    return
  }
  mapfile -t missing < <(missing_packages)
  [ ${#missing[@]} -gt 0 ] || return 0
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null \
      || die 5 "packages are missing, and this is neither root nor is there sudo. As root: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  local apt=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Retries=3)
  "${apt[@]}" update || die 5 "apt-get update failed, see above"
  "${apt[@]}" install -y --no-install-recommends "${missing[@]}" \
    || die 5 "apt-get install failed, see above"
}

configure() {
  local generator=() fresh=() home
  mkdir -p "$build" 2>/dev/null || die 5 "cannot make the build folder '$build'"
  [ -w "$build" ] || die 5 "cannot write the build folder '$build'"
  if [ -f "$build/CMakeCache.txt" ]; then
    home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
    [ "$home" = "$root" ] || fresh=(--fresh) # the checkout was moved or copied
  fi
  [ -f "$build/build.ninja" ] || [ -f "$build/Makefile" ] || generator=(-G Ninja)
  cmake -S "$root" -B "$build" "${fresh[@]}" "${generator[@]}" "${options[@]}" \
    || die 1 "the project does not configure, see above"
}

install_packages
say "configuring $build (LAMMPS first, if it is not in the cache yet)"
configure
say "building"
cmake --build "$build" -j "$(jobs)" "${targets[@]}" || die 1 "the project does not build, see above"
