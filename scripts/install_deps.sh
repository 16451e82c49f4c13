#!/usr/bin/env bash
# Installs what the build and the tests need on Debian or Ubuntu.
set -euo pipefail

if [[ "${1:-}" == --help ]]; then
  cat <<'HELP'
Usage: scripts/install_deps.sh [package...]
Installs the packages the build, the tests and the benchmark need (Debian 12, Ubuntu 22.04 or newer), and any further
packages named. Does nothing, and needs no rights, when all of them are there.
HELP
  exit 0
fi

packages=(
  cmake ninja-build g++ pkg-config
  libopencv-dev libeigen3-dev
  libgtest-dev libbenchmark-dev
  clang-format
  "$@"
)

installed() {
  [[ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

missing=()
for package in "${packages[@]}"; do
  installed "$package" || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then
  exit 0
fi

echo "Installing ${missing[*]}"
as_root=()
if [[ $EUID -ne 0 ]]; then
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
