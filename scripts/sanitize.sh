#!/usr/bin/env bash
# The core under sanitizers, assertions on, hardly optimised: scripts/sanitize.sh [--threads | --all] [arguments of ctest]
#
# With --threads what several threads do together, under the sanitizer of threads; without, all else, under those of
# memory and undefined behaviour. With --all the same of the whole program: window, off-screen modules, their tests, and
# a monkey at the window for ten minutes (scripts/monkey.sh).
#
# Its results have to be the same bits there too. It has to build where no OpenGL package is installed: nothing it
# compiled has read a header of one. Takes half an hour on two cores, with --all 47 and the build: run it before a release and
# after work on memory, threads or files. Of it .ci/run has the monkey, for a
# minute, with steppers as they are compiled elsewhere.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

ensure_packages core checks lammps
if [[ ${1:-} == --threads ]]; then
    shift
    build tsan -DSTEPLAB_WERROR=ON
    # not what runs out of memory: the sanitizer brings its own
    quiet_tests tsan -R 'Team|Worker|Bands|LargePairs|Pieces|ParallelForEach|SpeedError|Limits|LiveEnsemble|Ensemble' \
        -E 'is_missing|no_memory' "$@"
    exit
fi
# Minutes of runs through code that other tests run too, and memory that a sanitizer adds to or does not let be limited.
left_out='HardCase|LongTime|LargeRun|MemoryLimits|memory_does_not_grow|repository'
if [[ ${1:-} == --all ]]; then
    shift
    ensure_packages graphics tests
    build asan-all -DSTEPLAB_WERROR=ON
    use_sanitizers
    quiet_tests asan-all -E "$left_out" "$@"
    "$root/scripts/monkey.sh" --program "$root/build/asan-all/bin/steplab-view"
    exit
fi
build asan -DSTEPLAB_WERROR=ON # by clang++, which takes half of the time that g++ takes here
say "no OpenGL, GLFW or ImGui header was read"
if ninja -C "$root/build/asan" -t deps | grep -E '/(GL|GLES[0-9]*|EGL|KHR|GLFW|glm|imgui)/|imgui\.h'; then
    fail "the core has read the headers above"
fi
quiet_tests asan -E "$left_out" "$@"
