#!/usr/bin/env bash
# Fetches sequences of the TUM RGB-D benchmark (CC BY 4.0) for samples/rgbd_motion.
set -euo pipefail

sequences=(360 desk desk2 floor plant room rpy teddy xyz)
base=https://cvg.cit.tum.de/rgbd/dataset

usage() {
  cat <<HELP
Usage: scripts/download_tum.sh [--url=BASE] FOLDER [SEQUENCE...]
Downloads sequences freiburg1_SEQUENCE of the TUM RGB-D benchmark into FOLDER and unpacks them there, by default all
of: ${sequences[*]}. About half a gigabyte each, packed. What is there already is not fetched
again; an interrupted download goes on where it ended; a file whose size is not the server's is refused.
  --url=BASE   another mirror; the archives lie in BASE/freiburg1 (default $base)
Then: rgbd_motion FOLDER/rgbd_dataset_freiburg1_* --output=out --residuals
HELP
}

fail() {
  echo "download_tum.sh: $1" >&2
  exit "${2:-1}"
}

arguments=()
for argument in "$@"; do
  case "$argument" in
    --help)
      usage
      exit 0
      ;;
    --url=?*) base=${argument#--url=} ;;
    -*) fail "unknown option $argument; see --help" 2 ;;
    *) arguments+=("$argument") ;;
  esac
done
if [[ ${#arguments[@]} -eq 0 ]]; then
  usage >&2
  exit 2
fi
folder=${arguments[0]}
chosen=("${arguments[@]:1}")
if [[ ${#chosen[@]} -eq 0 ]]; then
  chosen=("${sequences[@]}")
fi
for sequence in "${chosen[@]}"; do
  [[ " ${sequences[*]} " == *" $sequence "* ]] || fail "no sequence '$sequence' in freiburg1: ${sequences[*]}" 2
done
for tool in curl tar; do
  command -v "$tool" >/dev/null || fail "$tool is needed"
done
mkdir -p "$folder" || fail "$folder: cannot be made"

# The size that the server gives, after all redirections.
remote_size() {
  curl --silent --fail --location --head "$1" | tr -d '\r' |
    awk 'tolower($1) == "content-length:" { size = $2 } END { print size }'
}

local_size() {
  if [[ -f "$1" ]]; then stat --format=%s "$1"; else echo 0; fi
}

fetch() {
  local url=$1 file=$2 size
  size=$(remote_size "$url") || fail "$url: cannot be reached"
  [[ "$size" =~ ^[0-9]+$ ]] || fail "$url: the server does not tell its size"
  if [[ $(local_size "$file") -gt $size ]]; then
    fail "$file: larger than the server's $size bytes; remove it"
  fi
  if [[ $(local_size "$file") -lt $size ]]; then
    curl --fail --location --continue-at - --output "$file" "$url" ||
      fail "$url: the download broke off; run this again to go on"
  fi
  [[ $(local_size "$file") -eq $size ]] ||
    fail "$file: $(local_size "$file") bytes, but the server has $size; run this again to go on"
}

for sequence in "${chosen[@]}"; do
  name=rgbd_dataset_freiburg1_$sequence
  if [[ -f "$folder/$name/groundtruth.txt" ]]; then
    echo "$name: there already"
    continue
  fi
  fetch "$base/freiburg1/$name.tgz" "$folder/$name.tgz"
  # Into a folder of its own first: one that was broken off must not look complete.
  rm -rf "$folder/$name.unpacking"
  mkdir "$folder/$name.unpacking"
  tar -xzf "$folder/$name.tgz" -C "$folder/$name.unpacking" ||
    fail "$folder/$name.tgz: cannot be unpacked; remove it and run this again"
  rm -rf "${folder:?}/$name"
  mv "$folder/$name.unpacking/$name" "$folder/$name"
  rmdir "$folder/$name.unpacking"
  rm "$folder/$name.tgz"
  echo "$name: ready"
done
