#!/usr/bin/env bash
# The checks that take longer than those of .ci/run: scripts/checks.sh
#
# Golden hashes with the other compiler, the kept inputs of what reads from outside under the sanitizers, the site of the
# documentation, the packages, and that the benchmarks compile. Takes more than an hour on two cores: run it before a
# release and after work on methods, forces or files.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

ensure_packages core graphics tests checks benchmarks lammps
build clang -DSTEPLAB_WERROR=ON --target test_sim
quiet_tests clang -R GoldenHashes
"$root/scripts/fuzz.sh" 0
"$root/scripts/docs.sh"
"$root/scripts/package.sh"
build release -DSTEPLAB_WERROR=ON --target benchmarks
