#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Set-up and the main job: friction run -> law -> creep curves -> pictures.
# shellcheck source=tools/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: quickstart.sh [options] [DIR]

Does the set-up (tools/setup.sh), then runs the paper's chain on real input:
  1. lmp      two rough steel blocks in sliding contact (examples/friction/in.friction)
  2. wr_fit   friction coefficient, kappa1 and kappa2 from the friction log
  3. wr_creep traction of a rough wheel of a locomotive (examples/wheelrail/eurosprinter.yaml), with
              our law of rail steel and with the paper's, beside what was measured; a law needs
              several runs, so ours is that of the shipped ones of plan rail
  4. pictures of the sheared fragment, of friction against time, of the creep curves
and writes the results into DIR (default: results/quickstart of the checkout), replacing those of
an earlier call. Takes about a minute after the set-up.

  --ns T       length of the friction run in ns (default 40)
  --np N       MPI ranks of the friction run (default 1)
  --seed S     seed of the roughness (default 1)
  -h, --help   this text

Environment: as for setup.sh
Exit codes: 0 ok, 2 usage, 5 packages, download or files; else that of the step that failed.
HELP
}
ns=40 np=1 seed=1 results=
while [ $# -gt 0 ]; do
  case $1 in
    --ns | --np | --seed)
      [ $# -ge 2 ] || die 2 "$1 needs a value; see --help"
      [[ $2 =~ ^[0-9]*\.?[0-9]+$ && $2 =~ [1-9] ]] || die 2 "$1 '$2': a positive number is needed"
      declare "${1#--}=$2"
      shift 2 ;;
    -h | --help) usage; exit 0 ;;
    -*) die 2 "unknown option '$1'; see --help" ;;
    *)
      [ -z "$results" ] || die 2 "'$1': one DIR is allowed, '$results' is given already"
      results=$1; shift ;;
  esac
done
results=${results:-$root/results/quickstart}
[[ $np =~ ^[0-9]+$ ]] || die 2 "--np '$np': a whole number is needed"
[[ $seed =~ ^[0-9]+$ ]] || die 2 "--seed '$seed': a whole number is needed"
case $results in /*) ;; *) results=$PWD/$results ;; esac

chain() {
  say "1/4 sliding friction: $ns ns, MPI ranks: $np (examples/friction/in.friction)"
  mpirun -np "$np" "$build/bin/lmp" -in "$root/examples/friction/in.friction" -log friction.log \
    -var ns "$ns" -var seed "$seed" -var frames 25000
  say "2/4 friction coefficient from the log"
  "$build/bin/wr_fit" friction.friction -o friction.json --runs runs.csv
  say "3/4 law and creep curves (tools/campaign_to_creep.sh, examples/wheelrail/eurosprinter.yaml)"
  wheel=$root/examples/wheelrail/eurosprinter
  "$root/tools/campaign_to_creep.sh" "$root/examples/campaign/logs/rail.tar.xz" \
    --material "$root/potentials/rail_steel.mca" --model bounded_rate --solid-only \
    --start-distance 250 --case "$wheel.yaml" --measured "$wheel.csv" -o creep -- \
    --set contact.hardness_limit=true --set contact.domain=4.2 --set cells="[72, 144]" \
    --set uncertainty.method=linear --set fields=none --set roughness="{hurst: 0.8,
      rms_slope: 0.0141421, wavelength_min: 3 mm, wavelength_max: 10 mm, seed: 1}"
  say "4/4 pictures"
  "$root/tools/plot_fragment.py" friction.dump -o fragment.png
  "$root/tools/plot_friction.py" friction.friction --runs runs.csv -o friction.png
}

column() { # FILE NAME: that column of the first row of a CSV file
  awk -F, -v name="$2" '/^#/ {next} !found {for (k = 1; k <= NF; k++) if ($k == name) c = k
    found = 1; next} {print $c; exit}' "$1"
}
summary() {
  say "done in $SECONDS s"
  cat <<END_OF_SUMMARY
Two rough steel blocks, p = 15 MPa, v = 5 m/s, strength 92 MPa, $ns ns; 40 automata across, to be
quick, half as many as this load needs:
  mu = $(column runs.csv mu) +- $(column runs.csv mu_se) (the paper's law: $(column runs.csv mu_eq2)) \
at kappa1 = $(column runs.csv kappa1), kappa2 = $(column runs.csv kappa2)
  friction log    $results/friction.friction
  fit             $results/friction.json, runs.csv
  pictures        $results/fragment.png, friction.png
Traction of a locomotive's wheel at 10 m/s, rough (rms slope 0.01), with the law of rail steel of the
shipped runs, with the paper's, and as it was measured; nothing is fitted to the measurement;
wr_creep's warnings above say how far from its fit each law is used:
  law             $results/creep/law.json
  tables          $results/creep/creep.csv, creep_band.csv; paper/creep.csv
  picture         $results/creep/creep.png
END_OF_SUMMARY
}

{ # one block, read as a whole: a change of this file during a run does no harm
  "$root/tools/setup.sh" --no-tests
  SECONDS=0
  mkdir -p "$results" 2>/dev/null || true
  [ -w "$results" ] || die 5 "cannot write the results folder '$results'"
  cd "$results" || exit 5
  # a failed step must not leave an older run's files
  rm -f -- friction.friction friction.dump friction.log friction.restart friction.json runs.csv \
    fragment.png friction.png creep/{law.json,runs.csv,fit.png,creep.png} \
    creep/{.,paper}/{creep.csv,creep.json,creep_band.csv,contact.csv,summary.json}
  chain
  summary
  exit 0
}
