#!/usr/bin/env bash
# Measures this machine: scripts/benchmark.sh [--quick] [--rows REGEX]
#
# Installs what is missing, builds build/release and its benchmarks, times the steps of steplab beside hand-written
# loops, Boost.odeint, GSL, SUNDIALS and LAMMPS, one core each, then the time to an error beside the same libraries,
# drawing, watching, writing and whole processes, and writes benchmarks/results/<processor>.csv. Takes
# some ten minutes on a quiet machine; with --quick fewer, less exactly. --rows chain-10/rk4 prints only the rows of steps
# (row/method/precision) it is found in and writes nothing.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

rounds=5 options=() rows='' error_rounds=20 repeats=5
while (($#)); do
    case $1 in
        -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;;
        --quick) rounds=1 error_rounds=3 repeats=1 options=(--benchmark_repetitions=2 --benchmark_min_time=0.005) ;;
        --rows) rows=${2:?--rows needs a regular expression}; shift ;;
        *) fail "unknown argument $1" ;;
    esac
    shift
done

programs=$root/build/release/benchmarks

steps() { "$programs/steps" "${options[@]}" --benchmark_filter="${1:-.}" "${@:2}"; }

# lammps ROW PARTICLES WHO SCRIPT STEPS VARIABLE...: the time of a step as LAMMPS prints it, in the columns of `steps`.
lammps() {
    local row=$1 particles=$2 who=$3 script=$4 steps=$5
    shift 5
    if [[ ! $row/velocity-verlet/double =~ ${rows:-.} ]] || ! command -v lmp >/dev/null; then return; fi
    OMP_NUM_THREADS=1 lmp -in "$root/benchmarks/lammps/$script" -log none "$@" -var warm_up "$steps" -var steps "$steps" |
        awk -v row="$row" -v n="$particles" -v who="$who" '
            /^Loop time/ { ns = $4 * 1e9 / $9 }
            END { if (!ns) exit 1; printf "%s,velocity-verlet,double,%d,%s,%.2f,%.4f,\n", row, n, who, ns, ns / n }'
}

lammps_rows() {
    lammps mesh-1000x1000 1000000 LAMMPS mesh.in 16 -var dim 1000
    local side style
    for side in 16 32 64; do
        for style in morse morse/opt; do
            lammps "morse-bulk-$((side ** 3))" $((side ** 3)) "LAMMPS $style" morse_bulk.in $((3200 / side)) \
                -var side "$side" -var style "$style"
        done
    done
    for style in lj/smooth/linear lj/cut/opt; do
        lammps liquid-32000 32000 "LAMMPS $style" lj_liquid.in 100 -var side 20 -var style "$style"
    done
}

# The rows in which LAMMPS takes part, again in turns with it: whatever slows the machine for a while hits both.
measure() {
    steps "$rows"
    local round row
    for ((round = 0; round < rounds; ++round)); do
        lammps_rows
        for row in mesh-1000x1000 morse-bulk-4096 morse-bulk-32768 morse-bulk-262144 liquid-32000; do
            if [[ $row/velocity-verlet/double =~ ${rows:-.} ]]; then
                steps "$row/velocity-verlet" --benchmark_repetitions=1
            fi
        done
    done
}

# nanoseconds PROGRAM ARGUMENT...: what a process takes that writes into an empty folder.
nanoseconds() {
    local folder begin
    folder=$(mktemp -d)
    begin=$(date +%s%N)
    (cd "$folder" && exec "$@" >/dev/null)
    echo $(($(date +%s%N) - begin))
    rm -r "$folder"
}

# process NAME ARGUMENT...: processes of steplab, in turns with one that does nothing.
process() {
    local row=process-$1,-,double,1 ns round
    shift
    for ((round = 0; round < 4 * repeats; ++round)); do
        ns=$(nanoseconds "$root/build/release/bin/steplab" "$@")
        printf '%s,steplab,%d.00,%d.0000,\n' "$row" "$ns" "$ns"
        ns=$(nanoseconds true)
        printf '%s,nothing,%d.00,%d.0000,\n' "$row" "$ns" "$ns"
    done
}

# What is no step: the time to an error, pictures, a window that watches, files, whole processes.
measure_others() {
    "$programs/peers" --lines "$error_rounds"
    if [[ -x $programs/drawing ]]; then "$programs/drawing" --lines $((2 * repeats)); fi
    "$programs/watching" --lines "$repeats"
    "$programs/trajectories" --lines
    process run-1000 run --model chain --steps 1000 --out run.csv
    process snapshot snapshot --out picture.png
}

# The least of all times of the same, in the order of first appearance; a hash that differs is an error.
least() {
    awk -F , -v OFS=, '
        $1 == "row" { if (!head++) print; next }
        {
            key = $1 FS $2 FS $3 FS $4 FS $5
            if (!(key in time)) { keys[++count] = key; hash[key] = $8 }
            if (hash[key] != $8) { print "two results of " key > "/dev/stderr"; exit 1 }
            if (!(key in time) || $6 + 0 < time[key] + 0) { time[key] = $6; each[key] = $7 }
        }
        END { for (i = 1; i <= count; ++i) print keys[i], time[keys[i]], each[keys[i]], hash[keys[i]] }'
}

# processor: "amd-epyc-family25-model17-avx512": a short name of the kind of processor, none of the machine.
processor() {
    awk -F '[ \t]*: ' '
        $1 == "model name" { name = tolower($2) }
        $1 == "cpu family" { family = $2 }
        $1 == "model" { model = $2 }
        $1 == "flags" || $1 == "Features" { flags = " " $2 " " }
        /^$/ { exit }
        END {
            gsub(/\([^)]*\)|@.*|[0-9]+-core|cpu|processor/, "", name)
            isa = flags ~ / avx512f / ? "avx512" : flags ~ / avx2 / ? "avx2" : flags ~ / asimd / ? "neon" : "baseline"
            text = name (family == "" ? "" : " family " family " model " model) " " isa
            gsub(/[^a-z0-9]+/, "-", text)
            gsub(/^-|-$/, "", text)
            print text
        }' /proc/cpuinfo
}

# flags_of_steps: what the peers were compiled with, without folders and warnings.
flags_of_steps() {
    ninja -C "$root/build/release" -t commands benchmarks/steps | grep -m1 'peers_double\.cpp\.o -c' | tr ' ' '\n' |
        grep -E '^-(O|m|f|std)' | paste -sd ' '
}

about() {
    local compiler
    compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$root/build/release/CMakeCache.txt")
    echo "# processor: $(sed -n 's/^model name[ \t]*: //p' /proc/cpuinfo | head -n 1)"
    echo "# compiler: $("$compiler" --version | head -n 1)"
    echo "# flags: $(flags_of_steps)"
    echo "# commit: $(git -C "$root" describe --always --dirty --abbrev=10 --exclude '*')"
    echo "# date: $(date -u +%F)"
}

ensure_packages core benchmarks lammps
build release --target benchmarks programs
say "measuring (a quiet machine measures best)"
if [[ -n $rows ]]; then measure | least; exit; fi

results=$root/benchmarks/results/$(processor).csv
mkdir -p "${results%/*}"
{ about && { measure && measure_others; } | tee /dev/stderr | least; } >"$results.partial"
mv "$results.partial" "$results"
say "the results are in $results; scripts/update-docs.sh puts them into docs/performance.md"
