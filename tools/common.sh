# SPDX-License-Identifier: GPL-2.0-or-later
# Sourced by the scripts beside it: where things are, how to speak, how to call MPI.
# shellcheck shell=bash
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
# in an installed tree (root: PREFIX/share/mca-wheelrail) the programs are in PREFIX/bin
build=$root/build
[ ! -f "$root/VERSION" ] || build=$(dirname "$(dirname "$root")")
build=${MCAWR_BUILD:-$build}
case $build in /*) ;; *) build=$PWD/$build ;; esac
script=$(basename "$0")

say() { printf '\n=== %s\n' "$*"; }
die() { # EXIT-CODE MESSAGE
  local code=$1
  shift
  printf '%s: error: %s\n' "$script" "$*" >&2
  exit "$code"
}

# Compile jobs: one a core, at most one per GB of free memory.
jobs() {
  local cores mem
  cores=$(nproc)
  mem=$(awk '/MemAvailable/ {print int($2/1048576)}' /proc/meminfo)
  echo $((cores < mem ? cores : (mem > 0 ? mem : 1)))
}

# Open MPI: run as root too (containers), more ranks than cores, no pinning of ranks to cores
# (several runs at once would share one).
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
