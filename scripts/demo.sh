#!/usr/bin/env bash
# From a bare Debian to poses of a real camera: errors, times, noise, uncertainty and a picture.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/demo.sh [file...]
Installs what is missing, builds into build/demo and runs samples/pose_from_correspondences on correspondence files,
by default those of samples/data (a hand-held RGB-D camera, 0.1 s from image to image). The first file is reported in
full and its residuals are drawn to build/demo/residuals.png; several files then get a table each and their mean errors.
HELP
  exit 0
fi

files=("$@")
if [[ ${#files[@]} -eq 0 ]]; then
  files=("$root"/samples/data/*.txt)
fi

bash "$root/scripts/install_deps.sh" python3-matplotlib
build="$root/build/demo"
mkdir -p "$build"
echo "Building into build/demo ..."
if ! {
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGMLPNP_BUILD_SAMPLES=ON \
    -DGMLPNP_BUILD_TESTS=OFF -DGMLPNP_BUILD_BENCHMARKS=OFF &&
    cmake --build "$build" --target pose_from_correspondences
} >"$build/build.log" 2>&1; then
  cat "$build/build.log" >&2
  exit 1
fi
program="$build/samples/pose_from_correspondences"

"$program" --residuals="$build/residuals.csv" --csv="$build/poses.csv" "${files[0]}"
if [[ ${#files[@]} -gt 1 ]]; then
  printf '\nAll %d files\n\n' "${#files[@]}"
  "$program" --brief --csv="$build/poses.csv" "${files[@]}"
fi
/usr/bin/python3 -B "$root/samples/python/draw.py" "$build/residuals.csv" >/dev/null # Debian's, which has matplotlib
echo
echo "Picture of the residuals: build/demo/residuals.png; all poses and errors: build/demo/poses.csv"
