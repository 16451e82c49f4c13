#!/usr/bin/env bash
# Fetches the distribution's source package of OpenCV without touching apt's configuration.
set -euo pipefail

if [[ "${1:-}" == --help || $# -ne 1 ]]; then
  cat <<'HELP'
Usage: scripts/fetch_opencv.sh <folder>
Unpacks the source package of OpenCV into <folder>/opencv, from the package sources that this system already uses.
Does nothing where it is there. Needs no rights: apt's lists and cache for it are kept in <folder>.
HELP
  [[ "${1:-}" == --help ]] && exit 0 || exit 2
fi

mkdir -p "$1"
folder=$(cd "$1" && pwd)
if [[ -f $folder/opencv/modules/core/CMakeLists.txt ]]; then
  exit 0
fi

bash "$(dirname "${BASH_SOURCE[0]}")/install_deps.sh" dpkg-dev

# The same sources, of type deb-src.
list='' parts=''
eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
rm -rf "$folder/apt"
mkdir -p "$folder"/apt/{parts,lists/partial,cache/archives/partial}
for file in "$list" "$parts"/*.list "$parts"/*.sources; do
  [[ -f $file ]] || continue
  case "$file" in
    *.sources) sed 's/^Types:.*/Types: deb-src/' "$file" ;;
    *) sed -n 's/^deb /deb-src /p' "$file" ;;
  esac >"$folder/apt/parts/$(basename "$file")"
done
options=(
  -o Dir::Etc::sourcelist=/dev/null
  -o Dir::Etc::sourceparts="$folder/apt/parts"
  -o Dir::State::lists="$folder/apt/lists"
  -o Dir::Cache="$folder/apt/cache"
)

cd "$folder"
apt-get -qq "${options[@]}" update
rm -rf opencv-*/ # of an interrupted run
apt-get -qq "${options[@]}" source opencv
rm -rf opencv
mv opencv-*/ opencv
