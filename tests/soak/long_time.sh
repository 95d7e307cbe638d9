#!/usr/bin/env bash
# An oscillator over 10^9 steps (or as many as are named) with one method of each family, in double and float, without
# and with compensated sums, against theory without rounding. Takes an hour; prints a table, judges nothing.
#     long_time.sh BUILD_FOLDER [STEPS]      (after: cmake --build BUILD_FOLDER --target long_time)
set -euo pipefail

program=$(realpath "$1")/soak/long_time
steps=${2:-1000000000}
readonly program steps
phase_and_energy() { printf ' phase after %g | energy |' "$1"; }

printf '| method | precision | sums |%s%s%s ns a step |\n' "$(phase_and_energy $((steps / 100)))" \
    "$(phase_and_energy $((steps / 10)))" "$(phase_and_energy "$steps")"
echo '|---|---|---|---|---|---|---|---|---|---|'
for method in velocity-verlet verlet rk4 pefrl srkn-11b gauss-16 dop853 rkn-12-10 taylor ias15; do nice "$program" "$method" "$steps"; done
# a tenth of the steps: it is ten times as slow
nice "$program" implicit-midpoint $((steps / 10))
