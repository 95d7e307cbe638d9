#!/usr/bin/env bash
# Opens steplab's window: scripts/run.sh [--model rope --method rk4 --dt 0.1 ...]
#
# Installs the Debian packages that are missing, builds build/release, and passes its arguments to `steplab view`.
# Without a display it writes a picture of the same scene, its panel included, and says where; the picture's own
# arguments (--steps, --size, --out, ...; see `steplab snapshot --help`) are then welcome too.
set -euo pipefail
caller=$PWD
readonly no_opengl=5 # the exit code of a program that found no display or no OpenGL
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

has() {
    local wanted=$1 argument
    shift
    for argument in "$@"; do
        if [[ $argument == "$wanted" || $argument == "$wanted="* ]]; then return; fi
    done
    return 1
}

is_built_for_all() {
    local cache=$root/build/release/CMakeCache.txt
    [[ -e $cache ]] && ! grep -q '^STEPLAB_INSTRUCTION_SETS:.*=native$' "$cache"
}

# A picture of the scene under way rather than of its start, unless the arguments say otherwise.
write_picture() {
    local defaults=()
    has --out "$@" || defaults+=(--out "$root/build/steplab.png")
    has --ui "$@" || defaults+=(--ui on)
    has --steps "$@" || has --until "$@" || defaults+=(--steps 100)
    "$steplab" snapshot "${defaults[@]}" "$@"
    if ! has --out "$@"; then say "no window here; the picture is $root/build/steplab.png"; fi
}

if has --help "$@" || has -h "$@"; then help_of "${BASH_SOURCE[0]}"; exit; fi

# A first build is for this processor alone; what scripts/test.sh has completed for all of them stays so.
sets=()
if ! is_built_for_all; then sets=(-DSTEPLAB_INSTRUCTION_SETS=native); fi

ensure_packages core graphics
build release "${sets[@]}" --target programs
steplab=$root/build/release/bin/steplab
cd "$caller"

if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
    say "opening the window"
    code=0
    "$steplab" view "$@" || code=$?
    if ((code != no_opengl)); then exit "$code"; fi
fi
write_picture "$@"
