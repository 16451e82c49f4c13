#!/usr/bin/env bash
# Runs the tests under AddressSanitizer + UndefinedBehaviorSanitizer, then under ThreadSanitizer.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/sanitize.sh [ctest arguments...]
Builds the presets asan and tsan with warnings as errors and runs all their tests but the slow ones.
HELP
  exit 0
fi

bash scripts/install_deps.sh

# ThreadSanitizer cannot place its shadow memory where the kernel randomises addresses by more than 28 bits.
fixed_addresses=()
if setarch "$(uname -m)" -R true 2>/dev/null; then
  fixed_addresses=(setarch "$(uname -m)" -R)
fi

# OpenCL drivers are not ours to check; without them UMat runs on the CPU.
export OPENCV_OPENCL_RUNTIME=disabled

# The preset asan sets EIGEN_MALLOC_ALREADY_ALIGNED: under ASan Eigen would pad its blocks by hand, and those that OpenGV
# (built without) hands over would be freed at the wrong place.
for preset in asan tsan; do
  echo "--- $preset ---"
  cmake --preset "$preset"
  cmake --build --preset "$preset"
  "${fixed_addresses[@]}" ctest --preset "$preset" -j2 "$@"
done
