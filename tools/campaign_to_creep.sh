#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# From friction logs to creep curves with the uncertainty of the law carried through.
# shellcheck source=tools/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

usage() {
  cat <<'HELP'
Usage: campaign_to_creep.sh CAMPAIGN... [-o DIR] [--case CASE.yaml] [--start NS] [-- OPTIONS OF wr_creep]

CAMPAIGN are friction logs (*.friction), folders with them, as tools/campaign run leaves them, or
archives of them (*.tar.xz), as tools/campaign pack does. Then
  1. wr_fit    the law of Eq. 2 with its covariance        DIR/law.json, runs.csv, fit.png
  2. wr_creep  the case with this law and its uncertainty  DIR/creep.csv, creep_band.csv, ...
               and with the paper's law for comparison     DIR/paper/creep.csv, ...
  3. a picture of both, with the 95 % band of the law      DIR/creep.png

  -o DIR         results (default: results/creep of the checkout; installed: creep)
  --case CASE    case file (default: examples/wheelrail/table2.yaml)
  --start NS     average the logs from this time on (default: wr_fit looks for the stationary part)
  --start-distance NM  and from this distance of sliding on
  --model NAME   law to fit, a model of wr_fit (default: eq2)
  --kappa3 K     with a model that has a power of kappa3 = E/sigma_0: take the law for this one; 206
                 is that of the wheel's steel in table2.yaml, the logs need several materials
  --ductility D  the same of the breaking strain times E/sigma_0
  --material FILE  potential file of the material that all logs are of: the law is one of it, with
                 --model bounded (bounded_...) or table
  --solid-only   leave out runs whose layer sank
  --measured FILE  measured points (CSV of creep and T/N) beside the curves of the picture
  --or-shipped   where the logs do not give a law, say so and take that of the runs that are
                 shipped (examples/campaign/logs, velocity and pressure: one material)
  -h, --help     this text
wr_creep warns where the case needs the law outside of what it was fitted on; its page says what
that may mean.
Examples: campaign_to_creep.sh runs -o out -- --set speed="20 m/s"
          campaign_to_creep.sh examples/campaign/logs/{velocity,pressure}.tar.xz
          campaign_to_creep.sh --model eq2_ductility --ductility 9.2 --start-distance 250 \
            examples/campaign/logs/{paper36,equal-kappas,similar,ductility,velocity,pressure}.tar.xz
          campaign_to_creep.sh examples/campaign/logs/rail.tar.xz --solid-only \
            --material potentials/rail_steel.mca --model bounded_rate --start-distance 250 \
            --case examples/wheelrail/eurosprinter.yaml \
            --measured examples/wheelrail/eurosprinter.csv

Environment: MCAWR_BUILD, the build folder (default: build of the checkout)
Exit codes: 0 ok, 2 usage; else that of the step that failed (4: the logs do not determine the law).
HELP
}

campaigns=() fit_options=() picture_options=() or_shipped=false of_material=false results=$root/results/creep case=$root/examples/wheelrail/table2.yaml
[ ! -f "$root/VERSION" ] || results=$PWD/creep # an installed tree
while [ $# -gt 0 ]; do
  case $1 in
    -o | --case | --start | --start-distance | --model | --kappa3 | --ductility | --material | --measured)
      [ $# -ge 2 ] || die 2 "$1 needs a value; see --help"
      case $1 in
        -o) results=$2 ;;
        --case) case=$2 ;;
        --measured)
          [ -r "$2" ] || die 3 "--measured $2: cannot be read"
          picture_options+=("$1" "$2")
          ;;
        *)
          fit_options+=("$1" "$2")
          [ "$1" != --material ] || of_material=true
          ;;
      esac
      shift 2
      ;;
    --solid-only)
      fit_options+=("$1")
      shift
      ;;
    --or-shipped)
      or_shipped=true
      shift
      ;;
    -h | --help)
      usage
      exit 0
      ;;
    --)
      shift
      break
      ;;
    -*) die 2 "unknown option $1; see --help" ;;
    *)
      campaigns+=("$1")
      shift
      ;;
  esac
done
[ ${#campaigns[@]} -gt 0 ] || die 2 "a folder or an archive with friction logs is needed; see --help"
mkdir -p "$results" || exit 5

fit() { # LOGS AND OPTIONS: the law and its runs
  "$build/bin/wr_fit" "$@" -o "$results/law.json" --runs "$results/runs.csv"
}
# with too few conditions wr_fit writes a report without a law
has_law() { grep -q '"format": "mca-friction-law' "$results/law.json"; }

# What an earlier call made of another law: pictures, and what the summaries of wr_creep name.
drop_former() {
  rm -f "$results"/{fit,creep}.png
  /usr/bin/python3 - "$results" "$results/paper" <<'PYTHON'
import json, os, sys

for folder in sys.argv[1:]:
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    except (OSError, ValueError):
        continue
    if not isinstance(summary, dict) or summary.get("format") != "wr_creep-summary 1":
        continue
    for name in summary.get("files", []):
        path = os.path.join(folder, str(name))
        if os.path.basename(path) == name and os.path.isfile(path):
            os.remove(path)
PYTHON
}

label="law of the logs"
! $of_material || label="law of the material"
echo "1/3 wr_fit ${campaigns[*]}"
code=0
fit "${campaigns[@]}" "${fit_options[@]}" || code=$?
case $code in 0 | 4) drop_former ;; esac # there is another law.json
[ $code -eq 0 ] || { [ $code -eq 4 ] && $or_shipped; } || exit $code
if ! has_law; then
  $or_shipped || die 4 "${campaigns[*]}: too few conditions for a law; see $results/law.json"
  shipped=$root/examples/campaign/logs
  echo "These logs do not give a law: the law of the shipped runs is taken ($shipped)"
  # their mu rises with velocity and has no term of pressure
  fit "$shipped/velocity.tar.xz" "$shipped/pressure.tar.xz" --start-distance 250 \
    --model velocity -q || exit $?
  label="law of the shipped runs"
fi
echo "2/3 wr_creep $case"
# 200 draws from the law's covariance: parameters of a short campaign are known to some 10 % only,
# which derivatives do not see
"$build/bin/wr_creep" "$case" -o "$results" --set uncertainty.method=sampled "$@" \
  --set friction.law="$results/law.json" || exit $?
of_paper=() # the paper's law has no errors
while [ $# -gt 0 ]; do
  case $1 in
    --set) case ${2-} in uncertainty.*) shift ;; *) of_paper+=("$1") ;; esac ;;
    --set=uncertainty.*) ;;
    *) of_paper+=("$1") ;;
  esac
  shift
done
"$build/bin/wr_creep" "$case" -o "$results/paper" -q "${of_paper[@]}" \
  --set friction.law=bucher2006 || exit $?
echo "3/3 pictures"
fit_picture="$results/fit.png, "
! $of_material || fit_picture= # Figs. 7 and 8 are of Eq. 2
code=0
{ $of_material || "$root/tools/plot_fit.py" "$results/law.json" -o "$results/fit.png"; } &&
  "$root/tools/plot_creep.py" "$results/creep.csv" "$results/paper/creep.csv" --label "$label" \
    --label "paper's law" "${picture_options[@]}" -o "$results/creep.png" &&
  echo "pictures: $fit_picture$results/creep.png" || code=$?
# no matplotlib, as the scripts have said
[ $code -ne 1 ] || /usr/bin/python3 -c 'import matplotlib' 2>/dev/null || code=0
echo "law: $results/law.json; creep curves: $results/creep.csv, with 95 % limits: $results/creep_band.csv"
exit $code
