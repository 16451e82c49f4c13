#!/usr/bin/env bash
# OpenCV's own tutorial programs with cv::gmlpnp in place of cv: do they compile, run and find the same poses?
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/opencv_samples.sh
Fetches the distribution's source package of OpenCV into build/opencv_src, takes from it the tutorial programs that call
solvePnP, changes the namespace of the call, builds both forms into build/opencv_samples, runs them on OpenCV's images
and video and compares the poses.
HELP
  exit 0
fi

if ! grep -q solvePnPRansac "$root/modules/gmlpnp/include/opencv2/gmlpnp.hpp"; then
  echo "skipped: the programs call solvePnPRansac too, which cv::gmlpnp does not have yet"
  exit 0
fi

bash "$root/scripts/install_deps.sh" xvfb xauth python3
bash "$root/scripts/fetch_opencv.sh" "$root/build/opencv_src"
cmake -S "$root" -B "$root/build/opencv_samples" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGMLPNP_BUILD_SAMPLES=OFF \
  -DGMLPNP_BUILD_BENCHMARKS=OFF -DGMLPNP_OPENCV_SOURCE="$root/build/opencv_src/opencv"
cmake --build "$root/build/opencv_samples" --target opencv_samples
ctest --test-dir "$root/build/opencv_samples" --no-tests=error -L opencv-samples --verbose
