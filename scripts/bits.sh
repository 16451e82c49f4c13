#!/usr/bin/env bash
# Proves that a change keeps every bit of what the module computes, or says in which calls it does not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ "${1:-}" == --help || $# -gt 1 ]]; then
  cat <<'HELP'
Usage: scripts/bits.sh [revision]
Prints hashes of what several thousand whole calls return (all solvers and lenses, 4 to 10 000 points), a line a group of
calls. With a revision (HEAD, main, a commit) it builds the module of that revision, too, with the same program, compiler
and flags, prints the groups that differ, and fails if there are any. Hashes depend on compiler, OpenCV, Eigen and the
machine's instruction set: compare two revisions on one machine, never two machines.
HELP
  [[ "${1:-}" == --help ]] && exit 0 || exit 2
fi

bash scripts/install_deps.sh

# Where the program of this tree, linked with the module of tree $1, is built and run; $2: a folder, $3: the output.
hashes_of() {
  if ! (cmake -S test/bits -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGMLPNP_TREE="$1" &&
    cmake --build "$2" --target gmlpnp_bits) >"$2.log" 2>&1; then
    cat "$2.log" >&2
    return 1
  fi
  "$2/gmlpnp_bits" >"$3"
}

mkdir -p build/bits
hashes_of "$PWD" build/bits/here build/bits/here.txt
if [[ $# -eq 0 ]]; then
  cat build/bits/here.txt
  exit 0
fi

commit=$(git rev-parse --verify --short=12 "$1^{commit}")
tree=$PWD/build/bits/tree
trap 'git worktree remove --force "$tree" 2>/dev/null || true' EXIT
git worktree remove --force "$tree" 2>/dev/null || true
git worktree add --quiet --detach "$tree" "$commit"
hashes_of "$tree" build/bits/there build/bits/there.txt
if diff --label "$commit" --label "working tree" -u0 build/bits/there.txt build/bits/here.txt; then
  echo "Same bits as $commit: $(tail -1 build/bits/here.txt)"
else
  echo "The bits differ from those of $commit in the groups above." >&2
  exit 1
fi
