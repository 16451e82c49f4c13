#!/usr/bin/env bash
# Runs the paper's experiments and those beyond it, draws them and writes the tables of doc/lab/experiments.md and
# doc/lab/noise.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'HELP'
Usage: scripts/figures.sh [--quick] [--trials N] [--threads N] [experiment...]
Builds into build/release, runs gmlpnp_experiments (all experiments, or those named) into build/experiments, draws them
to build/experiments/pictures (PNG and SVG), copies the SVG to doc/figures and writes the tables of
doc/lab/experiments.md and doc/lab/noise.md.
  --quick       20 trials into build/experiments_quick, pictures there, doc/ left alone: whether it all runs
  --trials N    problems per cell, default 500, and 2000 for those of doc/lab/noise.md
  --threads N   worker threads, default one per core; the results do not depend on them
The results of experiments that are not named are those of an earlier run.
HELP
}

quick=false
options=()
names=()
while [[ $# -gt 0 ]]; do
  case "$1" in
    --help) usage; exit 0 ;;
    --quick) quick=true ;;
    --trials | --threads)
      [[ $# -ge 2 ]] || { echo "figures.sh: $1 needs a number" >&2; exit 2; }
      options+=("$1=$2")
      shift
      ;;
    -*) echo "figures.sh: unknown option '$1'; see --help" >&2; exit 2 ;;
    *) names+=("$1") ;;
  esac
  shift
done
[[ ${#names[@]} -gt 0 ]] || names=(all)

bash scripts/install_deps.sh libopengv-dev python3-matplotlib
cmake --preset release -DGMLPNP_BUILD_SAMPLES=ON
cmake --build --preset release --target gmlpnp_experiments

results=build/experiments
if $quick; then
  results=build/experiments_quick
  options=(--trials=20 "${options[@]}")
fi
# The questions of doc/lab/noise.md ask for more problems; a --trials that was asked for comes last and wins.
many_options=(--trials=2000)
many=()
few=()
for name in "${names[@]}"; do
  case "$name" in
    coverage | recovery | small | bias | tails) many+=("$name") ;;
    all)
      many=(coverage recovery small bias tails)
      few=(points noise time guess rounds case covariance consistency depth pixels omnidir outliers)
      ;;
    *) few+=("$name") ;;
  esac
done
program=build/release/samples/experiments/gmlpnp_experiments
[[ ${#few[@]} -eq 0 ]] || "$program" --out="$results" "${options[@]}" "${few[@]}"
[[ ${#many[@]} -eq 0 ]] || "$program" --out="$results" "${many_options[@]}" "${options[@]}" "${many[@]}"
/usr/bin/python3 scripts/figures/draw.py "$results" "$results/pictures" # Debian's, which has matplotlib
if ! $quick; then
  mkdir -p doc/figures
  cp "$results"/pictures/*.svg doc/figures/
  /usr/bin/python3 scripts/figures/tables.py "$results" doc/lab/experiments.md
  /usr/bin/python3 scripts/figures/tables.py "$results" doc/lab/noise.md
fi
