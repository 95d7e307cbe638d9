#!/usr/bin/env bash
# Makes the Debian packages of steplab in build/package: scripts/package.sh [--native]
#
# steplab (programs, scenes, lessons, manual), libsteplab0.2, libsteplab-dev (headers) and python3-steplab, with methods
# for all instruction sets; with --native for this processor's alone, which is quicker, for trying the packages out.
# scripts/bare-debian.sh installs them into a bare Debian and uses them there.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

sets=("-DSTEPLAB_INSTRUCTION_SETS=avx2;avx512")
if [[ ${1:-} == --native ]]; then sets=(-DSTEPLAB_INSTRUCTION_SETS=native); fi
ensure_packages core graphics python package
rm -f "$root"/build/package/*.deb
build package "${sets[@]}"
say "packing"
cd "$root/build/package"
cpack >cpack.log 2>&1 || { cat cpack.log >&2; fail "cpack failed"; }
if command -v lintian >/dev/null; then lintian --fail-on error ./*.deb; fi
ls -l "$root"/build/package/*.deb
