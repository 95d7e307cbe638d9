#!/usr/bin/env bash
# Prints which lines of core, methods, models and sim the tests execute; fails under 95 %.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

ensure_packages core checks lammps
build coverage
find "$root/build/coverage" -name '*.gcda' -delete
quiet_tests coverage
gcovr --root "$root" --object-directory "$root/build/coverage" --filter 'src/(core|methods|models|sim)/' \
    --exclude-unreachable-branches --exclude-throw-branches --print-summary --fail-under-line 95 -j "$(nproc)"
