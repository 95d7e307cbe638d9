#!/usr/bin/env bash
# The core for arm64, whose vectors are those of NEON, on another processor: scripts/arm64.sh [arguments of ctest]
#
# Builds tests of numbers, models and runs by Debian's cross compiler and runs those of golden hashes, of forces and
# of the exponential in an emulator: the same bits are to come out. Lets apt install packages of arm64. Takes half an hour
# to build on two cores, which is why .ci/run leaves it out.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

check_apt
if [[ $(dpkg --print-architecture) != arm64 ]] && ! dpkg --print-foreign-architectures | grep -qx arm64; then
    as_root dpkg --add-architecture arm64
    as_root apt-get update -q >&2
fi
ensure_packages core arm64 lammps
build arm64 -DSTEPLAB_WERROR=ON --target test_core test_models test_sim
(($#)) || set -- -R 'GoldenHashes|Exponential|Forces'
quiet_tests arm64 "$@"
