#!/usr/bin/env bash
# Measures the solvers against cv::solvePnP and prints the ratios as a Markdown table.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/bench.sh [--times [Google Benchmark arguments...]]
Builds into build/release and prints CPU times relative to SQPNP: medians of paired repetitions.
  --times   absolute times by Google Benchmark instead, e.g. --times --benchmark_filter=SQPNP
HELP
  exit 0
fi

{
  bash scripts/install_deps.sh
  cmake --preset release -DGMLPNP_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target bench_solvepnp
} >&2 # so that the table alone can go into a file

bench=build/release/test/benchmark/bench_solvepnp
if [[ "${1:-}" == --times ]]; then
  shift
  exec "$bench" "$@"
fi

cpu=$(awk -F': *' '/^model name/ { print $2; exit }' /proc/cpuinfo)
echo "$(date -u +%F), ${cpu:-$(uname -m)}, one thread."
echo
"$bench" --ratios
