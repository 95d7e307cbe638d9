#!/usr/bin/env bash
# Runs every test: scripts/test.sh [arguments of ctest, such as -R golden]
#
# Installs the Debian packages that are missing, builds build/release, and closes with ctest's summary.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

ensure_packages core graphics tests
build release
say "running the tests of build/release"
ctest --preset release --parallel "$(nproc)" --no-label-summary "$@" 2>&1
