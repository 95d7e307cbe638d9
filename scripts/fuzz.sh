#!/usr/bin/env bash
# Feeds made-up inputs to what reads from outside, under sanitizers: scripts/fuzz.sh [target] [seconds]
#
# Targets are the sources of tests/fuzz (trajectory, text_trajectory ...); without one, each of them in turn. 60 seconds
# unless another time is given; 0: only the inputs that are kept. What was found worth keeping stays in
# build/fuzz/corpus and is continued from; an input that ends in a crash, a hang of 10 s or more than 1 GiB is kept in
# build/fuzz/found, and the script fails.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

mapfile -t targets < <(basename -s .cpp -a "$root"/tests/fuzz/*.cpp)
if [[ ${1:-} =~ ^[a-z_]+$ ]]; then
    [[ -e $root/tests/fuzz/$1.cpp ]] || fail "unknown target '$1' (${targets[*]})"
    targets=("$1")
    shift
fi
seconds=${1:-60}
if ((seconds == 0)); then limit=-runs=0; else limit=-max_total_time=$seconds; fi

ensure_packages core checks
build fuzz --target "${targets[@]/#/fuzz_}"
for target in "${targets[@]}"; do
    say "$target for $seconds s"
    folder=$root/build/fuzz/corpus/$target
    mkdir -p "$folder" "$root/build/fuzz/found"
    "$root/build/fuzz/tests/fuzz_$target" "$limit" -timeout=10 -rss_limit_mb=1024 -max_len=20000 \
        -print_final_stats=1 -verbosity=0 -artifact_prefix="$root/build/fuzz/found/$target-" \
        "$folder" "$root/tests/fuzz/corpus/$target" 2>&1 | grep -v '^INFO' || fail "$target: see build/fuzz/found"
done
