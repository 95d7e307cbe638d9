#!/usr/bin/env bash
# Instructions of the key kernels: tests/performance/counts.sh PROGRAM COMPILER [--renew]
#
# Counts, by valgrind, the instructions a step of each kernel takes in PROGRAM (kernels.cpp) and fails if one differs
# from that in counts.txt by more than a tenth. Counts belong to a compiler (name-version-processor) that counts.txt
# must know. With --renew the counts of this compiler are written there anew:
#     cmake --build --preset release --target renew_counts
set -euo pipefail

program=$1 compiler=$2 renew=${3:-}
known=$(dirname "${BASH_SOURCE[0]}")/counts.txt
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Lines "COMPILER KERNEL METHOD PRECISION INSTRUCTIONS-A-STEP".
count() {
    local files
    valgrind --tool=callgrind --callgrind-out-file="$folder/out" "$program" 2>"$folder/log" || { cat "$folder/log" >&2; return 1; }
    mapfile -t files < <(ls -v "$folder"/out.*)
    awk -v compiler="$compiler" '
        /^desc: Trigger: Client Request: / { kernel = $5 " " $6 " " $7; steps = $8 }
        /^totals: / && steps { printf "%s %s %.1f\n", compiler, kernel, $2 / steps; steps = 0 }' \
        "${files[@]}"
}

if [[ $renew != --renew ]] && ! grep -q "^$compiler " "$known"; then
    echo "no counts of $compiler are known (--target renew_counts writes them)" >&2
    exit 2
fi
count >"$folder/counts"
if [[ $renew == --renew ]]; then
    { grep -sv "^$compiler " "$known" || true; cat "$folder/counts"; } >"$folder/all"
    cp "$folder/all" "$known"
    exit
fi
awk -v compiler="$compiler" '
    $1 != compiler { next }
    { key = $2 " " $3 " " $4 }
    NR == FNR { known[key] = $5; next }
    {
        ratio = key in known ? $5 / known[key] : 0
        wrong = ratio < 0.9 || ratio > 1.1
        printf "%-36s %12.1f instructions a step, %5.3f of what is known%s\n", key, $5, ratio, wrong ? "  WRONG" : ""
        failed = failed || wrong
        delete known[key]
    }
    END {
        for (key in known) { print key " was not counted"; failed = 1 }
        if (failed) print "if the change is meant: cmake --build --preset release --target renew_counts"
        exit failed
    }' "$known" "$folder/counts"
