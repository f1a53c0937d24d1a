#!/bin/bash
# Set-up and the main job: friction run -> law -> creep curves -> pictures.
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: quickstart.sh [options] [DIR]

Does the set-up (tools/setup.sh), then runs the paper's chain on real input:
  1. lmp      two rough steel blocks in sliding contact (examples/friction/in.friction)
  2. wr_fit   friction coefficient, kappa1 and kappa2 from the friction log
  3. wr_creep creep curves of Table 2's wheel/rail contact (examples/wheelrail/table2.yaml)
  4. pictures of the sheared fragment, of friction against time, of the creep curves
and writes the results into DIR (default: results/quickstart of the checkout), replacing those of
an earlier call. Takes about 3 minutes on 2 cores after the set-up.

  --ns T       length of the friction run in ns (default 10)
  --np N       MPI ranks of the friction run (default 2)
  --seed S     seed of the roughness (default 1)
  -h, --help   this text

Environment: as for setup.sh
Exit codes: 0 ok, 2 usage, 5 packages, download or files; else that of the step that failed.
HELP
}
ns=10 np=2 seed=1 results=$root/results/quickstart
while [ $# -gt 0 ]; do
  case $1 in
    --ns | --np | --seed)
      [ $# -ge 2 ] || die 2 "$1 needs a value; see --help"
      [[ $2 =~ ^[0-9]*\.?[0-9]+$ && $2 =~ [1-9] ]] || die 2 "$1 '$2': a positive number is needed"
      declare "${1#--}=$2"
      shift 2 ;;
    -h | --help) usage; exit 0 ;;
    -*) die 2 "unknown option '$1'; see --help" ;;
    *) results=$1; shift ;;
  esac
done
[[ $np =~ ^[0-9]+$ ]] || die 2 "--np '$np': a whole number is needed"
[[ $seed =~ ^[0-9]+$ ]] || die 2 "--seed '$seed': a whole number is needed"
case $results in /*) ;; *) results=$PWD/$results ;; esac

"$root/tools/setup.sh"

mkdir -p "$results" 2>/dev/null || true
[ -w "$results" ] || die 5 "cannot write the results folder '$results'"
cd "$results"
results_of_a_run=(friction.friction friction.dump friction.log law.json points.csv
  creep.csv contact.csv summary.json fragment.png friction.png creep.png)
rm -f -- "${results_of_a_run[@]}" # a failed step must not leave an older run's files

say "1/4 sliding friction: $ns ns on $np ranks"
mpirun -np "$np" "$build/bin/lmp" -in "$root/examples/friction/in.friction" -log friction.log \
  -var ns "$ns" -var seed "$seed"

say "2/4 friction coefficient from the log"
"$build/bin/wr_fit" friction.friction -o law.json --points points.csv

say "3/4 creep curves"
"$build/bin/wr_creep" "$root/examples/wheelrail/table2.yaml" -o .

say "4/4 pictures"
"$root/tools/plot_fragment.py" friction.dump -o fragment.png
"$root/tools/plot_friction.py" friction.friction -o friction.png
"$root/tools/plot_creep.py" creep.csv -o creep.png

say "done; results are in $results"
