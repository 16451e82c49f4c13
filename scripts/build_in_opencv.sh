#!/usr/bin/env bash
# Builds, tests and binds modules/gmlpnp inside OpenCV's own source tree, as a module of opencv_contrib would be.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  cat <<'HELP'
Usage: scripts/build_in_opencv.sh [OpenCV source directory]
Builds OpenCV with modules/gmlpnp in OPENCV_EXTRA_MODULES_PATH, only what the module needs, into build/opencv, with
warnings from the module as errors. Then runs there: its C++ tests but the slow ones, its performance tests with one
sample each, its tutorial and Python tests against cv2.gmlpnp, and OpenCV's own PnP tests on our functions and flags. Without a directory the distribution's source package of OpenCV
is fetched into build/opencv_src; of apt's configuration nothing is changed.
Later runs rebuild what has changed. JOBS=n sets the number of compilers at a time.
HELP
}

case "${1:-}" in
  --help)
    usage
    exit 0
    ;;
  -*)
    echo "build_in_opencv.sh: unknown argument '$1'; see --help" >&2
    exit 2
    ;;
esac

sources=$root/build/opencv_src
build=$root/build/opencv

bash "$root/scripts/install_deps.sh" dpkg-dev python3-dev python3-numpy zlib1g-dev

if [[ $# -ge 1 ]]; then
  opencv=$(cd "$1" && pwd)
else
  bash "$root/scripts/fetch_opencv.sh" "$sources"
  opencv=$sources/opencv
fi
if [[ ! -f $opencv/modules/core/CMakeLists.txt ]]; then
  echo "build_in_opencv.sh: $opencv is not an OpenCV source directory" >&2
  exit 2
fi

# OPENCV_EXTRA_MODULES_PATH is a folder of modules: one that holds ours alone.
modules=$root/build/opencv_modules
mkdir -p "$modules"
ln -sfn "$root/modules/gmlpnp" "$modules/gmlpnp"

# Off: what would be downloaded, is not in Debian's source package, or only takes time to build.
without=()
for part in IPP ITT OPENCL FFMPEG GSTREAMER GTK QT VTK V4L 1394 PROTOBUF ADE JASPER OPENJPEG OPENEXR TIFF WEBP JPEG PNG \
  QUIRC LAPACK OBSENSOR; do
  without+=("-DWITH_$part=OFF")
done
echo "Configuring OpenCV in $opencv ..."
mkdir -p "$build"
if ! cmake -S "$opencv" -B "$build" -G Ninja -Wno-dev -DCMAKE_BUILD_TYPE=Release "${without[@]}" \
  -DOPENCV_EXTRA_MODULES_PATH="$modules" -DBUILD_LIST=gmlpnp,ts,python3 -DBUILD_EXAMPLES=ON -DBUILD_opencv_apps=OFF \
  -DBUILD_JAVA=OFF -DCPU_DISPATCH= -DGMLPNP_WERROR=ON -DPYTHON3_EXECUTABLE=/usr/bin/python3 \
  >"$build/configure.log" 2>&1; then
  cat "$build/configure.log" >&2
  exit 1
fi
grep -E 'To be built:|Module opencv_gmlpnp' "$build/configure.log"

cmake --build "$build" -j "${JOBS:-$(nproc)}" \
  --target opencv_gmlpnp opencv_test_gmlpnp opencv_perf_gmlpnp opencv_python3 example_gmlpnp_gmlpnp_tutorial

echo "--- C++ tests ---"
"$build/bin/opencv_test_gmlpnp" --gtest_filter='-Slow*:*/Slow*'

echo "--- Performance tests, one sample each ---"
"$build/bin/opencv_perf_gmlpnp" --perf_min_samples=1 --perf_force_samples=1

echo "--- The tutorial ---"
"$build/bin/example_gmlpnp_gmlpnp_tutorial"

echo "--- Python ---"
export PYTHONPATH="$build/python_loader:$opencv/modules/python/test"
/usr/bin/python3 - <<'PYTHON'
import cv2, numpy
points = numpy.array([[x, y, z] for x in (-1., 1.) for y in (-1., 1.) for z in (-1., 1.)])
K = numpy.array([[800., 0, 320], [0, 800, 240], [0, 0, 1]])
pixels, _ = cv2.projectPoints(points, (0.1, -0.2, 0.3), (0.5, 0.25, 8.), K, None)
found, rvec, tvec = cv2.gmlpnp.solvePnP(points, pixels, K, None)
print("cv2", cv2.__version__, "cv2.gmlpnp.solvePnP:", found, rvec.ravel(), tvec.ravel())
PYTHON
/usr/bin/python3 "$root/modules/gmlpnp/misc/python/test/test_gmlpnp.py"
/usr/bin/python3 "$root/modules/gmlpnp/samples/gmlpnp_tutorial.py"

echo "--- OpenCV's own PnP tests, on cv::gmlpnp ---"
if ! grep -q solvePnPRansac "$root/modules/gmlpnp/include/opencv2/gmlpnp.hpp"; then
  echo "skipped: they call solvePnPRansac too, which cv::gmlpnp does not have yet"
  exit 0
fi
original=$(find "$opencv/modules" -name test_solvepnp_ransac.cpp)
pnp_tests=$build/bin/opencv_test_gmlpnp_as_calib3d
mkdir -p "$build/pnp_tests"
sed -f "$root/test/in_opencv/pnp_tests.sed" "$original" >"$build/pnp_tests/test_solvepnp_ransac.cpp"
includes=("-I$build" "-I$(dirname "$original")" "-I$root/modules/gmlpnp/include")
for folder in "$opencv"/modules/*/include; do
  includes+=("-I$folder")
done
for file in test_solvepnp_ransac test_main; do
  [[ $file == test_main ]] && folder=$(dirname "$original") || folder=$build/pnp_tests
  c++ -std=c++17 -O1 -w "${includes[@]}" -c "$folder/$file.cpp" -o "$build/pnp_tests/$file.o"
done
c++ -o "$pnp_tests" "$build"/pnp_tests/*.o "$build/lib/libopencv_ts.a" "$build"/lib/libopencv_*.so -Wl,-rpath,"$build/lib" \
  -pthread -ldl
"$pnp_tests"
