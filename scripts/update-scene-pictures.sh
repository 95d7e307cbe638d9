#!/usr/bin/env bash
# Draws the pictures of the window's page of scenes into assets/pictures/: scripts/update-scene-pictures.sh [NAME ...]
#
# Without names: those of all models and shipped scenes. A scene is drawn as its file opens it, at a sixth of its length.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

readonly diverged=4 # the exit code of a run that blew up; its last valid step is drawn
pictures=$root/assets/pictures
steplab=$root/build/release/bin/steplab

# moment NAME: the options of a picture, for a scene that is drawn better than as it opens.
moment() {
    case $1 in
        free) echo --steps 15 ;;
        oscillator) echo --steps 10 --view -14,12,5.5,0.8,0,0 ;;
        chain) echo --set n=8 --set v0=1.9 --steps 40 ;;
        mesh) echo --set dim=13 --set v0=8 --steps 60 --view 30,30,52,12,0,-12 ;;
        rope) echo --steps 9 --view -14,8,11,2.2,-1.6,0 ;;
        morse) echo --set edge=4 --set v0=2 --dt 0.01 --steps 240 --view 30,20,6.5,0.6,1.5,1.5 ;;
        crystal) echo --steps 300 --view 30,24,19,2.5,2.5,2.5 ;;
        beats) echo --until 1 --view -14,12,6,1.5,0,0 ;;
        catenary) echo --until 3 --view -14,8,5,1.5,-0.45,0 ;;
        cloth) echo --until 0.7 --view 30,16,4,0.8,-0.45,0.4 ;;
        figure-eight) echo --until 1.2 --view 0,60,5,0,0,0 ;;
        ion-crystal) echo --until 20 --view 30,20,13,0,0,0 ;;
        kepler-ellipse) echo --until 2 --view 10,35,5,0.8,0,0 ;;
        lennard-jones-drop) echo --until 1.6 --view 30,24,22,2.4,2.4,2.4 ;;
        three-pendulums) echo --until 3.3 --view -20,8,5,0,-0.5,0 ;;
        two-planets) echo --until 2 --view 20,40,9,0.4,0,0.9 ;;
        double-well) echo --until 8 --view 30,40,5,0.3,0,0.7 ;;
        fermi-pasta-ulam) echo --until 700 --view -14,8,30,16.5,0,0 --colour speed ;;
        fcc-crystal) echo --until 4 --set kT=2.5 --view 30,24,16,3.3,3.3,3.3 ;;
        galaxies) echo --until 9 --view 10,50,14,0,0,0.9 ;;
        newtons-cradle) echo --until 0.15 --view -20,8,3,0.3,0.4,0 ;;
        outer-solar-system) echo --until 55 --view 20,50,95,0,-8,-3 ;;
        polymer) echo --until 60 --view -14,20,42,29,0,0 ;;
        toda-ring) echo --until 12 --view -14,8,26,31.5,0,0 ;;
        pendulum) echo --until 0.3 --view -14,8,3,0,-0.5,0 ;;
        spring-network) echo --until 0.4 --view 30,20,4.5,0,0,0 ;;
        *) echo --until "$(awk '$1 == "until" { print $3 / 6 }' "$root/assets/scenes/$1.toml")" ;;
    esac
}

# picture NAME: two pixels for each that a display of usual density shows.
picture() {
    local kind=--scene
    if [[ " ${models[*]} " == *" $1 "* ]]; then kind=--model; fi
    # shellcheck disable=SC2046  # many words
    "$steplab" snapshot $kind "$1" $(moment "$1") --size 352x220 --grid off --out "$pictures/$1.png" ||
        (($? == diverged))
}

build release --target programs
mkdir -p "$pictures"
read -r -a models <<<"$(sed -n 's/^set(STEPLAB_MODELS \(.*\))/\1/p' "$root/src/models/list.cmake")"
# shellcheck disable=SC2046  # every model is a shipped scene, too
if (($# == 0)); then set -- $(basename -s .toml -- "$root"/assets/scenes/*.toml); fi
for name in "$@"; do picture "$name"; done
