# What the scripts of this folder share; to be sourced. Nothing here asks a question.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
exec </dev/null

say() { printf '\n== %s\n' "$*" >&2; }

fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

# memory_grows MB...: whether a program that was measured now and then never again takes as little as before: the least in
# the last quarter against the least in the two before it. What is most depends on the scenes that happen to be shown and
# on what can be undone, by 80 MB and more; the least grows by what is lost, and by what the allocator keeps of the largest
# scene so far: 57 MB were measured at one of 5000 gestures, and 33 MB within a first minute, when things are used for the
# first time; 68 MB within five minutes. An hour of 39 000 gestures, a thousand rounds, has to be flat within 64 MB, or 5 %
# under sanitizers: 3 kB lost in each gesture are found. A shorter one may grow by a quarter more.
memory_grows() {
    local before=0 after=0 allowed i
    for ((i = $# / 4 + 1; i <= $#; ++i)); do
        if ((i <= $# * 3 / 4)); then
            ((before == 0 || ${!i} < before)) && before=${!i}
        else
            ((after == 0 || ${!i} < after)) && after=${!i}
        fi
    done
    allowed=$((before / 20 > 64 ? before / 20 : 64))
    (($# < 400)) && allowed=$((64 + before / 4))
    echo "memory: at least $before MB, later at least $after MB; $allowed MB more are allowed"
    ((after > before + allowed))
}

# help_of FILE: the comment at the head of a script, which is its --help.
help_of() { awk 'NR > 1 && !/^#/ { exit } NR > 1 { sub(/^# ?/, ""); print }' "$1"; }

# entries SECTION...: the lines of these sections of packages.txt, comments removed.
entries() {
    awk -v wanted=" $* " '
        { sub(/#.*/, ""); gsub(/^[ \t]+|[ \t]+$/, "") }
        /^\[/ { gsub(/[][ \t]/, ""); inside = index(wanted, " " $0 " "); next }
        inside && NF' "$root/scripts/packages.txt"
}

is_installed() { dpkg-query -W -f='${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed; }

is_offered() { [[ -n $(apt-cache madison "$1" 2>/dev/null) ]]; }

# missing NAME...: what to install where one of these will do: nothing if one is there, else the first that is offered.
missing_of() {
    local name
    for name in "$@"; do
        if is_installed "$name"; then return; fi
    done
    for name in "$@"; do
        if is_offered "$name"; then echo "$name"; return; fi
    done
    echo "$1"
}

# missing_packages SECTION...: what has to be installed, one name a line; wanted ones only where they are offered.
missing_packages() {
    local entry name
    while read -r entry; do
        read -r -a names <<<"${entry//[?|]/ }"
        name=$(missing_of "${names[@]}")
        if [[ -z $name ]]; then continue; fi
        if [[ $entry == \?* ]] && ! is_offered "$name"; then continue; fi
        echo "$name"
    done < <(entries "$@")
}

as_root() {
    if ((EUID == 0)); then "$@"; else sudo -n "$@"; fi
}

check_apt() {
    if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then return; fi
    fail "there is no apt here to install packages with. Install what scripts/packages.txt lists by the means of
your system, then run:  cmake --preset release && cmake --build --preset release"
}

# missing_required SECTION...: of these, those that nothing works without.
missing_required() {
    local wanted
    wanted=$(entries "$@" | sed -n 's/^?//p')
    missing_packages "$@" | grep -vxF "${wanted// /}" || true
}

# stop_unless_optional MESSAGE SECTION...: fails if something is missing that nothing works without.
stop_unless_optional() {
    local message=$1 required
    shift
    mapfile -t required < <(missing_required "$@")
    if ((${#required[@]})); then fail "$message ${required[*]}"; fi
}

# ensure_packages SECTION...: installs what is missing; where everything is there, apt is not called at all.
ensure_packages() {
    check_apt
    local packages
    mapfile -t packages < <(missing_packages "$@")
    if ((${#packages[@]} == 0)); then return; fi
    if ! as_root true 2>/dev/null; then
        stop_unless_optional "packages are missing, and installing them needs root, or a sudo that asks for no password.
Run this script as root, or have these installed first:  apt-get install --no-install-recommends" "$@"
        return
    fi
    say "refreshing apt's lists: packages are missing (${packages[*]})"
    as_root apt-get update -q >&2 || say "the lists could not be refreshed; going on with the old ones"
    mapfile -t packages < <(missing_packages "$@")
    say "installing with apt: ${packages[*]}"
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${packages[@]}" >&2 ||
        stop_unless_optional "apt could not install:" "$@"
}

# build PRESET [-Doption=value ...] [arguments of cmake --build]
build() {
    local preset=$1 log=$root/build/$1.configure.log options=()
    shift
    while [[ ${1:-} == -D* ]]; do options+=("$1"); shift; done
    say "building build/$preset"
    mkdir -p "$root/build"
    cd "$root" || exit
    cmake --preset "$preset" "${options[@]}" >"$log" 2>&1 || { cat "$log" >&2; fail "cmake could not set up build/$preset"; }
    cmake --build --preset "$preset" "$@" >&2
}

# For what runs under AddressSanitizer: drivers of OpenGL leak, and a request for too much memory is an exception, not an
# end.
use_sanitizers() { export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1; }

# quiet_tests PRESET [arguments of ctest]: prints the summary only, everything if a test fails.
quiet_tests() {
    local preset=$1 log=$root/build/$1.tests.log
    shift
    say "testing build/$preset: ctest $*"
    if ! ctest --preset "$preset" --parallel "$(nproc)" --no-label-summary "$@" >"$log" 2>&1; then
        cat "$log" >&2
        fail "tests of build/$preset failed"
    fi
    tail -n 3 "$log"
}
