#!/usr/bin/env bash
# Runs the tests under AddressSanitizer + UndefinedBehaviorSanitizer and under ThreadSanitizer, of g++ and of clang++.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/sanitize.sh [preset...] [-- ctest arguments...]
Builds the presets (default: asan tsan asan-clang tsan-clang) with warnings as errors and runs all their tests but the
slow ones.
Example: scripts/sanitize.sh tsan -- -R Threads
HELP
  exit 0
fi

presets=()
while [[ $# -gt 0 && "$1" != -- ]]; do
  presets+=("$1")
  shift
done
[[ $# -eq 0 ]] || shift
[[ ${#presets[@]} -gt 0 ]] || presets=(asan tsan asan-clang tsan-clang)

# What test.sh installs, so that all is built; clang and its sanitizers.
bash scripts/install_deps.sh pybind11-dev python3-dev python3-numpy python3-opencv libgdal-dev libopengv-dev \
  clang libclang-rt-14-dev

# ThreadSanitizer cannot place its shadow memory where the kernel randomises addresses by more than 28 bits.
fixed_addresses=()
if setarch "$(uname -m)" -R true 2>/dev/null; then
  fixed_addresses=(setarch "$(uname -m)" -R)
fi

# OpenCL drivers are not ours to check; without them UMat runs on the CPU.
export OPENCV_OPENCL_RUNTIME=disabled

# The preset asan sets EIGEN_MALLOC_ALREADY_ALIGNED: under ASan Eigen would pad its blocks by hand, and those that OpenGV
# (built without) hands over would be freed at the wrong place.
for preset in "${presets[@]}"; do
  echo "--- $preset ---"
  cmake --preset "$preset"
  cmake --build --preset "$preset"
  "${fixed_addresses[@]}" ctest --preset "$preset" -j2 "$@"
done
