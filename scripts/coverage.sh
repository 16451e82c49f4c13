#!/usr/bin/env bash
# Line coverage of the module's sources by the tests that are not slow.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

required=95 # percent of the lines in modules/gmlpnp/src

if [[ "${1:-}" == --help ]]; then
  cat <<HELP
Usage: scripts/coverage.sh
Builds the preset coverage, runs its tests, writes build/coverage/report/index.html and fails below $required % of lines.
HELP
  exit 0
fi

bash scripts/install_deps.sh gcovr
cmake --preset coverage
cmake --build --preset coverage
find build/coverage -name '*.gcda' -delete # counts of an earlier run would add up
ctest --preset coverage -j2

mkdir -p build/coverage/report
# By its full path: gcovr is Debian's, and so is the Python it runs on.
/usr/bin/gcovr --root . --filter modules/gmlpnp/src/ --html-details build/coverage/report/index.html \
  --txt --print-summary --fail-under-line "$required" build/coverage/modules
