#!/usr/bin/env bash
# Measures how fast the window draws while runs are playing, on a virtual display of 1280x720 with a software renderer, and
# prints a table: frames of the window, pictures of the scene and steps of the leading run a second; processor time of the
# window and of the display for each frame, which other programs on the machine change less. Judges nothing: the numbers depend on the machine.
#     frame_times.sh SECONDS BUILD_FOLDER...      (after: cmake --build BUILD_FOLDER --target steplab-view)
# Several build folders take turns, to be compared.
set -uo pipefail

seconds=$1 builds=("${@:2}")
readonly seconds builds
# shellcheck source=/dev/null
source "$(dirname "$0")/../ui/window_driver.sh"

# processor_time PID: of a program so far, in milliseconds.
processor_time() {
    awk -v tick="$(getconf CLK_TCK)" '{ sub(/.*\) /, ""); print ($12 + $13) * 1000 / tick }' "/proc/$1/stat"
}

# newest WORD: what the window said last behind this word.
newest() {
    grep "^$1 " "$folder/said" | tail -n 1 | cut -d' ' -f2-
}

# now: milliseconds, frames, pictures and steps so far, processor time of the window and of the display.
now() {
    expect 'drawn .*'
    echo "$(($(date +%s%N) / 1000000)) $(newest drawn) $(newest pictured)" \
        "$(processor_time "$window_pid") $(processor_time "$display_pid")"
}

# row BUILD NAME CONFIG OPTION...: the numbers of a window of its own.
row() (
    local title=$2
    program=$(realpath "$1/bin/steplab-view")
    ((${#builds[@]} > 1)) && title="$2 ($(basename "$1"))"
    folder=$(mktemp -d)
    trap clean_up EXIT
    config=$folder/view.toml
    printf 'version = 1\n%s\n' "$3" >"$config"
    shift 3
    start_display 1280x720
    open_window --size 1280x720 --play "$@"
    local begin end i
    for ((i = 0; i < 4; ++i)); do begin=$(now); done # its shaders are compiled by then
    for ((i = 0; i < seconds; ++i)); do end=$(now); done
    echo "$begin $end" | awk -v title="$title" '{
        seconds = ($7 - $1) / 1000; frames = $8 - $2
        printf "%-40s %6.1f %6.1f %8.1f %11.1f %11.1f\n", title, frames / seconds, ($9 - $3) / seconds,
               ($10 - $4) / seconds, ($11 - $5) / frames, ($12 - $6) / frames }'
)

# rows NAME CONFIG OPTION...: of every build.
rows() {
    local build
    for build in "${builds[@]}"; do row "$build" "$@"; done
}

readonly three='plots = [{kind = "energy error", scale = "linear"}, {kind = "displacement", scale = "linear"},
                         {kind = "position error", scale = "logarithmic"}]'
readonly two_runs=(--run method=rk4,dt=0.1 --run method=velocity-verlet,dt=0.1)
readonly four_runs=("${two_runs[@]}" --run method=euler,dt=0.1 --run method=midpoint,dt=0.05)

echo "load of the machine: $(cut -d' ' -f1-3 /proc/loadavg) on $(nproc) processors"
printf '%-40s %6s %6s %8s %11s %11s\n' '' frames scenes steps 'window [ms]' 'display [ms]'
rows 'one run, scene alone' '' --model chain --ui off
rows 'one run, 2 plots' '' --model chain
rows 'one run of a mesh, 2 plots' '' --model mesh
rows 'two runs split, 3 plots' "$three" --model chain "${two_runs[@]}" --layout split
rows 'two runs as ghosts, 3 plots' "$three" --model chain "${two_runs[@]}" --layout ghosts
rows 'four runs split, 3 plots' "$three" --model chain "${four_runs[@]}" --layout split
# whose diagrams take longer than this measures
for scene in '--model crystal' '--scene cloth'; do
    read -ra options <<<"$scene"
    rows "${scene#* }, energy error" 'plots = [{kind = "energy error", scale = "linear"}]' "${options[@]}"
    rows "${scene#* }, speed against error" 'plots = [{kind = "speed against error", scale = "logarithmic"}]' "${options[@]}"
done
