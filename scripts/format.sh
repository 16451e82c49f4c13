#!/usr/bin/env bash
# Formats the C++ sources by .clang-format, or checks that they are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case "${1:-}" in
  --help)
    echo "Usage: scripts/format.sh [--check]"
    echo "Formats all C++ files in place; with --check names those that are not formatted and fails."
    exit 0
    ;;
  --check | "") ;;
  *)
    echo "format.sh: unknown argument '$1'; see --help" >&2
    exit 2
    ;;
esac

mapfile -d '' files < <(find modules python samples test \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sort -z)

if [[ "${1:-}" != --check ]]; then
  clang-format -i "${files[@]}"
  exit 0
fi

unformatted=0
for file in "${files[@]}"; do
  if ! clang-format --dry-run -Werror "$file" 2>/dev/null; then
    echo "not formatted: $file (run scripts/format.sh)"
    unformatted=1
  fi
done
exit "$unformatted"
