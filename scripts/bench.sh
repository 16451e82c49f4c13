#!/usr/bin/env bash
# Measures the solvers against cv::solvePnP and prints the ratios as a Markdown table.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/bench.sh [--times [Google Benchmark arguments...] | --batch | --ransac [--scale=1]]
Builds into build/release and prints CPU times relative to SQPNP: medians of paired repetitions.
  --times    absolute times by Google Benchmark instead, e.g. --times --benchmark_filter=SQPNP
  --batch    how much faster solveBatch is on several threads
  --ransac   RANSAC beside that of OpenCV instead (10 minutes): the tables of doc/lab/ransac.md, which are replaced;
             with another --scale (share of the problems) they are only printed
HELP
  exit 0
fi

{
  bash scripts/install_deps.sh
  cmake --preset release -DGMLPNP_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target bench_solvepnp bench_ransac
} >&2 # so that the table alone can go into a file

bench=build/release/test/benchmark/bench_solvepnp
if [[ "${1:-}" == --times ]]; then
  shift
  exec "$bench" "$@"
fi

cpu=$(awk -F': *' '/^model name/ { print $2; exit }' /proc/cpuinfo)
heading="$(date -u +%F), ${cpu:-$(uname -m)}, one thread."
if [[ "${1:-}" == --ransac ]]; then
  shift
  tables=build/release/ransac.md
  printf '%s\n\n' "$heading" >"$tables"
  build/release/test/benchmark/bench_ransac "$@" | tee -a "$tables"
  if [[ $# -eq 0 ]]; then
    sed '/^<!-- table -->$/q' doc/lab/ransac.md >build/release/doc.md
    { cat build/release/doc.md && echo && cat "$tables"; } >doc/lab/ransac.md
  fi
  exit 0
fi
if [[ "${1:-}" == --batch ]]; then
  printf '%s\n\n' "${heading%, one thread.}."
  exec "$bench" --batch
fi
printf '%s\n\n' "$heading"
"$bench" --ratios
