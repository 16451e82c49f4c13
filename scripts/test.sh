#!/usr/bin/env bash
# Everything a change must pass: build without warnings, format, tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/test.sh [--slow] [ctest arguments...]
Installs what is missing, builds into build/test with warnings as errors, checks the format and runs the tests.
  --slow   also run the tests labelled `slow` (Monte-Carlo statistics)
Example: scripts/test.sh -R Solve
HELP
  exit 0
fi

labels=(-LE slow)
if [[ "${1:-}" == --slow ]]; then
  labels=()
  shift
fi

bash scripts/install_deps.sh pybind11-dev python3-dev python3-numpy python3-opencv python3-matplotlib mypy \
  libgdal-dev libopengv-dev
cmake -S . -B build/test -G Ninja -DCMAKE_BUILD_TYPE=Release -DGMLPNP_WERROR=ON \
  -DGMLPNP_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3 # Debian's, whichever comes first on the PATH
cmake --build build/test

# A format error fails the script, but only after the tests have had their say.
format=0
bash scripts/format.sh --check || format=$?

ctest --test-dir build/test --output-on-failure --no-tests=error -j2 "${labels[@]}" "$@"
exit "$format"
