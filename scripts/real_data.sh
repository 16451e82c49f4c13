#!/usr/bin/env bash
# The tables and pictures of doc/lab/real_data.md from the real data sets.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if [[ "${1:-}" == --help || $# -gt 2 ]]; then
  cat <<'HELP'
Usage: scripts/real_data.sh [DATA [OUTPUT]]
Installs what is missing, builds into build/real_data and runs rgbd_motion, lidar_motion and uav_localization on the
data sets in DATA (default: GMLPNP_DATA, else ../shared/data): tum_fr1_rpy, kitti360, aerial_ngi and aerial_odm. Those
that are missing are named and left out. Tables and pictures go to OUTPUT (default: build/real_data/results, and the
tables then also into doc/lab/real_data.md).
HELP
  [[ "${1:-}" == --help ]] && exit 0 || exit 2
fi
data=${1:-${GMLPNP_DATA:-$root/../shared/data}}
output=${2:-$root/build/real_data/results}

bash "$root/scripts/install_deps.sh" libgdal-dev python3-matplotlib
build="$root/build/real_data"
mkdir -p "$build" "$output"
echo "Building into build/real_data ..."
if ! {
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGMLPNP_BUILD_SAMPLES=ON \
    -DGMLPNP_BUILD_TESTS=OFF -DGMLPNP_BUILD_BENCHMARKS=OFF -DGMLPNP_BUILD_PYTHON=OFF &&
    cmake --build "$build" --target rgbd_motion lidar_motion uav_localization make_orthophoto
} >"$build/build.log" 2>&1; then
  cat "$build/build.log" >&2
  exit 1
fi

# run NAME PROGRAM ARGUMENT...: tables and pictures into a folder of that name.
run() {
  local name=$1 program=$2
  shift 2
  printf '\n== %s: %s\n\n' "$name" "$program"
  "$build/samples/$program" "$@" --residuals --output="$output/$name" &&
    /usr/bin/python3 -B "$root/samples/python/draw.py" "$output/$name" || # Debian's, which has matplotlib
    echo "$name: failed"
}

present() {
  [[ -e "$data/$1" ]] || {
    echo "left out: no $1 in $data"
    return 1
  }
}

joined() {
  local IFS=,
  echo "$*"
}

if present tum_fr1_rpy; then
  run rgbd rgbd_motion "$data/tum_fr1_rpy"
fi

if present kitti360; then
  kitti=("$data/kitti360" --motion="$data/kitti360/pseudo_velo_motion.txt")
  run lidar_1 lidar_motion "${kitti[@]}" --step=1
  run lidar_3 lidar_motion "${kitti[@]}" --step=3
  run lidar_3_chain lidar_motion "${kitti[@]}" --step=3 --chain
  run lidar_1_fisheye_02 lidar_motion "${kitti[@]}" --step=1 --through=02
  run lidar_1_fisheye_03 lidar_motion "${kitti[@]}" --step=1 --through=03
  run lidar_1_fisheye_03_wide lidar_motion "${kitti[@]}" --step=1 --through=03 --aside=60 --field=240
fi

if present aerial_ngi; then
  photographs=("$data"/aerial_ngi/*_RGB.tif)
  ngi=(--dem="$data/aerial_ngi/dem.tif" --poses="$data/aerial_ngi/ngi_xyz_opk.csv"
    --camera="833.333333 833.333333 319.5 575.5")
  run ngi uav_localization "${photographs[@]}" --reference="$(joined "${photographs[@]}")" "${ngi[@]}"
  mkdir -p "$output/orthophotos"
  for photograph in "${photographs[@]}"; do
    "$build/samples/make_orthophoto" "$photograph" "$output/orthophotos/$(basename "$photograph")" "${ngi[@]}"
  done
  run ngi_orthophotos uav_localization "${photographs[@]}" --orthophoto="$(joined "$output"/orthophotos/*_RGB.tif)" \
    "${ngi[@]}"
fi

if present aerial_odm; then
  photographs=("$data"/aerial_odm/100_*.tif)
  run odm uav_localization "${photographs[@]}" --reference="$(joined "${photographs[@]}")" \
    --dem="$data/aerial_odm/dsm.tif" --poses="$data/aerial_odm/odm_xyz_opk.csv" \
    --camera="911.719212 911.719212 681.385011 462.000565" \
    --distortion="-0.26406291 0.101889342 0.000734590627 0.000259520671 -0.025819564"
fi

if [[ $# -lt 2 ]]; then
  /usr/bin/python3 "$root/scripts/real_data_tables.py" "$output" "$root/doc/lab/real_data.md"
fi
