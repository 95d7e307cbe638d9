#!/usr/bin/env bash
# Runs every test: scripts/test.sh [--native] [arguments of ctest, such as -R golden]
#
# Installs the Debian packages that are missing, builds build/release, and closes with ctest's summary. With --native
# methods are compiled for this processor's best instruction set alone: two thirds of the time.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

sets=()
if [[ ${1:-} == --native ]]; then
    sets=(-DSTEPLAB_INSTRUCTION_SETS=native)
    shift
fi
ensure_packages core graphics python tests lammps
build release "${sets[@]}"
say "running the tests of build/release"
ctest --preset release --parallel "$(nproc)" --no-label-summary "$@" 2>&1
