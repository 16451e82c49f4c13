#!/usr/bin/env bash
# Static analysis: clang-tidy with .clang-tidy, then cppcheck.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/tidy.sh [regular expression of paths]
Runs clang-tidy over what is in modules, python, samples and test (or over the files that match) and cppcheck over
the module; any finding fails. Needs no build: only its commands, in build/tidy, and the docstrings that it generates.
HELP
  exit 0
fi

bash scripts/install_deps.sh clang clang-tidy cppcheck python3
# Clang's flags; precompiled headers would have to be built first.
cmake --preset clang -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
if grep -q docstrings.cpp build/tidy/compile_commands.json; then
  cmake --build build/tidy --target gmlpnp_docstrings
fi

# /usr/bin/python3 by name: run-clang-tidy is part of Debian's clang-tidy and needs no other interpreter. Files that the
# build generates are left out.
/usr/bin/python3 /usr/bin/run-clang-tidy -quiet -p build/tidy -j"$(nproc)" "${1:-^$PWD/(modules|python|samples|test)/}"

# Without the headers of OpenCV and Eigen: cppcheck would spend its time there. The macros of OpenCV's bindings are empty.
cppcheck --quiet --std=c++17 --language=c++ --enable=warning,performance,portability --inline-suppr \
  --suppress=missingIncludeSystem --error-exitcode=1 \
  -DCV_EXPORTS= -DCV_EXPORTS_W= -DCV_EXPORTS_W_SIMPLE= -DCV_WRAP= -DCV_PROP_RW= -DCV_OUT= -DCV_IN_OUT= \
  -Imodules/gmlpnp/include modules/gmlpnp/src
