#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Set-up and tests.
# shellcheck source=tools/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: check.sh [--all] [--sanitize] [CTEST-OPTION...]

Does the set-up (tools/setup.sh), then runs the tests: GoogleTest and pytest, through CTest.
Fails if a test fails, is skipped or disabled, or if there is none. Other options are those of
ctest, for instance -R hertz (only the tests with that name). The output is kept in build/check.log.
No test needs root; the form of the sources is held by tools/gate, which is no part of this.

  --all       long tests and drills, too (doc/testing.md): as CI does
  --sanitize  in a build of its own, build-sanitize/, with AddressSanitizer and
              UndefinedBehaviorSanitizer; a finding fails its test. About ten times as long

Environment: as for setup.sh
Exit codes: 0 all passed, 1 a test failed or the build did, 2 usage, 5 packages, download or files.
HELP
}
options=() without=(-LE 'drill|long') for_ctest=()
for arg in "$@"; do
  case $arg in
    -h | --help) usage; exit 0 ;;
    --all) without=() ;;
    --sanitize)
      [ -n "${MCAWR_BUILD:-}" ] || build=$root/build-sanitize
      options=(-DSANITIZE=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo)
      ;;
    *) for_ctest+=("$arg") ;;
  esac
done
export MCAWR_BUILD=$build

{ # one block, read as a whole: a change of this file during a run does no harm
  "$root/tools/setup.sh" "${options[@]}"
  [ ${#without[@]} -gt 0 ] || cmake --build "$build" -j "$(jobs)" --target drills \
    || die 1 "the drills do not build, see above"
  say "tests"
  log=$build/check.log
  status=0
  # several tests run at once, each with its ranks: those that wait give their core away
  export OMPI_MCA_mpi_yield_when_idle=1
  # two more at once than cores: many wait for what they have started most of the time
  ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(($(nproc) + 2))" \
    "${without[@]}" "${for_ctest[@]}" 2>&1 | tee "$log" || status=1
  [ $status -eq 0 ] || die 1 "tests failed; log: $log"

  # ctest counts skipped and disabled tests as passed, and so does pytest
  skipped=$(grep -E '\*\*\*(Skipped|Not Run)|\((Skipped|Disabled)\)' "$log" || true)
  [ -z "$skipped" ] || die 1 "tests were skipped: $skipped"
  skipped=$(grep -E '^.*[0-9]+ (skipped|deselected|xfailed).* in [0-9.]+s' \
    "$build/Testing/Temporary/LastTest.log" || true)
  [ -z "$skipped" ] || die 1 "pytest skipped tests: $skipped (see $build/Testing/Temporary/LastTest.log)"
  exit 0
}
