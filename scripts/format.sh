#!/usr/bin/env bash
# Formats all C++ sources by .clang-format; with --check, only names the files that are not formatted and fails.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

mode=(-i)
case ${1:-} in
    -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;;
    --check) mode=(--dry-run -Werror) ;;
esac

cd "$root"
find src include examples python tests benchmarks docs -name '*.[ch]pp' -print0 | xargs -0 -r -n 20 -P "$(nproc)" clang-format "${mode[@]}"
