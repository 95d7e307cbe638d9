#!/usr/bin/env bash
# Measures the window on a virtual display: what it costs while it is paused and untouched, and how long its panels take
# to answer while a mesh of 1000 x 1000 is stepping. Prints numbers, judges nothing: they depend on the machine.
#     window.sh BUILD_FOLDER      (after: cmake --build BUILD_FOLDER --target steplab-view window_latency)
set -uo pipefail

build=$(realpath "$1")
program=$build/bin/steplab-view
readonly build program
# shellcheck source=/dev/null
source "$(dirname "$0")/../ui/window_driver.sh"

# processor_time: of the window so far, in hundredths of a second.
processor_time() {
    awk '{ print $14 + $15 }' "/proc/$window_pid/stat"
}

# measured COMMAND...: in a folder, on a display and with a window of its own.
measured() (
    folder=$(mktemp -d)
    trap clean_up EXIT
    "$@"
)

idle() {
    start_display 1280x800
    open_window --model mesh
    sleep 5
    local before
    before=$(processor_time)
    sleep 20
    echo "paused and untouched: $(($(processor_time) - before)) hundredths of a second of processor time in 20 s"
}

# answers X Y AWAY_X AWAY_Y PIXEL_X PIXEL_Y SIDE
answers() {
    "$build/bin/window_latency" "$@" 30
}

panels() {
    start_display 1280x800
    open_window "$@"
    sleep 10
    local x y
    [[ -n ${place[snapshot]:-} ]] || expect 'widget snapshot [0-9].*'
    read -r x y <<<"${place[snapshot]}"
    answers "$x" "$y" 800 500 $((x - 25)) $((y - 8)) 1
}

# The grid at the edge of the scene stands still unless the camera moves.
camera() {
    start_display 1280x800
    open_window "$@"
    sleep 10
    xdotool mousemove 800 300 mousedown 1
    answers 760 300 800 300 320 440 60
    xdotool mouseup 1
}

echo "load of the machine: $(cut -d' ' -f1-3 /proc/loadavg) on $(nproc) processors"
measured idle
echo "panels of the paused window:"
measured panels
echo "panels while a mesh of 1000 x 1000 is stepping:"
measured panels --model mesh --set dim=1000 --play
echo "camera while a mesh of 1000 x 1000 is stepping:"
measured camera --model mesh --set dim=1000 --play
