#!/usr/bin/env bash
# Runs libFuzzer on every public function and every reader of the samples.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=1800
jobs=$(nproc)

usage() {
  cat <<HELP
Usage: scripts/fuzz.sh [--seconds N] [--jobs N] [name...]
Builds the preset fuzz (clang: libFuzzer, AddressSanitizer, UndefinedBehaviorSanitizer) and runs each fuzzer of
test/fuzz, or those named, for N seconds (default $seconds), as many at once as there are cores. Inputs that reach new code are
kept in build/fuzz/corpus, input that breaks a promise in build/fuzz/findings; any such fails the script.
Example: scripts/fuzz.sh --seconds 60 solve camera_file
HELP
}

names=()
while [[ $# -gt 0 ]]; do
  case "$1" in
    --help) usage; exit 0 ;;
    --seconds | --jobs)
      [[ "${2:-}" =~ ^[1-9][0-9]*$ ]] || { echo "fuzz.sh: $1 needs a number" >&2; exit 2; }
      declare "${1#--}=$2"
      shift
      ;;
    -*) echo "fuzz.sh: unknown option '$1'; see --help" >&2; exit 2 ;;
    *) names+=("$1") ;;
  esac
  shift
done

bash scripts/install_deps.sh clang libclang-rt-14-dev libgdal-dev
cmake --preset fuzz
cmake --build --preset fuzz
if [[ ${#names[@]} -eq 0 ]]; then
  mapfile -t names < <(find build/fuzz/test/fuzz -maxdepth 1 -name 'fuzz_*' -type f -executable -printf '%f\n' |
    sed 's/^fuzz_//' | sort)
fi
for name in "${names[@]}"; do
  [[ -x build/fuzz/test/fuzz/fuzz_$name ]] || { echo "fuzz.sh: there is no fuzzer '$name'" >&2; exit 2; }
done

export OPENCV_OPENCL_RUNTIME=disabled # its drivers are not ours to check
export ASAN_OPTIONS=detect_stack_use_after_return=1:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
mkdir -p build/fuzz/findings build/fuzz/logs

run() {
  local name=$1 corpus=build/fuzz/corpus/$1 log=build/fuzz/logs/$1.log
  mkdir -p "$corpus"
  build/fuzz/test/fuzz/fuzz_"$name" -max_total_time="$seconds" -max_len=16384 -timeout=20 -rss_limit_mb=4096 \
    -artifact_prefix=build/fuzz/findings/"$name"_ -print_final_stats=1 "$corpus" test/fuzz/corpus/"$name" \
    >"$log" 2>&1 && state=ok || state="FAILED, see $log"
  printf '%-16s %10s inputs  %s\n' "$name" "$(sed -n 's/stat::number_of_executed_units: *//p' "$log")" "$state"
  [[ $state == ok ]]
}

echo "${#names[@]} fuzzers, $seconds s each, $jobs at once"
export -f run
export seconds
printf '%s\n' "${names[@]}" | xargs -P "$jobs" -I{} bash -c 'run {}' || exit 1
