#!/usr/bin/env bash
# Draws the pictures of README.md and docs/ into docs/images/.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

readonly diverged=4 # the exit code of a run that blew up; its last valid step is drawn
images=$root/docs/images

# picture NAME [arguments of steplab snapshot]
picture() {
    local name=$1
    shift
    say "docs/images/$name.png: steplab snapshot $*"
    "$root/build/release/bin/steplab" snapshot "$@" --out "$images/$name.png" || (($? == diverged))
}

folder=$(mktemp -d)
# shellcheck disable=SC2034  # of the driver
program=$root/build/release/bin/steplab-view
# shellcheck source=/dev/null
source "$root/tests/ui/window_driver.sh"
trap clean_up EXIT

# window_picture NAME: the window as it is now, and its end
window_picture() {
    xdotool key ctrl+p
    expect 'saved .*'
    window_saved "$1"
}

# window_saved NAME: the picture that the window has saved, and its end
window_saved() {
    mv "$folder"/*.png "$images/$1.png"
    close_window
    rm "$folder/trace"
}

build release --target programs draw_diagrams
mkdir -p "$images"
"$root/build/release/docs/draw_diagrams" "$images"
picture window --model mesh --set dim=17 --set v0=7 --steps 158 --colour displacement --ui on --size 1280x800 \
    --view 25,22,54,16,0,-16
picture free --model free --steps 40 --colour speed --size 800x500
picture oscillator --model oscillator --steps 10 --size 800x500
picture chain --model chain --set n=16 --set v0=1.9 --steps 100 --colour speed --size 800x500
picture mesh --model mesh --set dim=30 --set v0=8 --steps 130 --colour displacement --size 800x500 --view 30,25,98,29,0,-27
picture rope --model rope --steps 9 --colour strain --size 800x500
picture morse --model morse --set edge=4 --set v0=2 --dt 0.01 --steps 480 --colour speed --size 800x500 \
    --view 30,20,8,0.7,0.9,0.7
picture ensemble --model morse --method velocity-verlet --dt 0.01 --until 30 --ensemble 256 --spread v0=0.999999:1.000001 \
    --size 800x500 --view 30,20,5,1.9,0.5,0.5
picture crystal --model crystal --steps 300 --colour speed --size 800x500
picture diverged --model mesh --set dim=13 --method verlet --dt 0.74 --steps 1000 --ui on --size 1280x800
picture runs-ghosts --model rope --dt 0.005 --until 3.5 --run method=rk4 --run method=euler-forward --size 800x500
picture runs-split --model morse --dt 0.02 --until 12 --run method=rk4 --run method=verlet --run method=euler --run method=dopri5 \
    --layout split --ui on --size 1280x800
picture phase-portraits --model oscillator --until 20 --run method=velocity-verlet,dt=0.4 --run method=rk4,dt=0.4 \
    --run method=euler-forward,dt=0.02 --ui on --plots phase-portrait,energy-error --size 1280x800
picture verdict --model rope --method velocity-verlet --dt 0.05 --steps 40 --ui on --size 1280x800 --background light \
    --colour strain
picture panel-tabs --model chain --until 20 --run method=rk4 --run method=euler --ui on --size 640x480 --scale 1

picture magnified --model mesh --set dim=30 --set v0=0.02 --steps 900 --displacements 100 --colour displacement --size 800x500 \
    --view 30,25,98,29,0,-27
while read -r scene until; do
    picture "scene-$scene" --scene "$scene" --until "$until" --size 480x320
done <<'SCENES'
three-pendulums 2.2
newtons-cradle 0.4
two-planets 7
cloth 1.5
fermi-pasta-ulam 60
SCENES

say "docs/images/comet.gif: four methods on an ellipse"
"$root/build/release/bin/steplab" record --scene kepler-ellipse --set e=0.6 --until 26 --run method=dop853 \
    --run method=velocity-verlet,dt=0.1 --run method=rk4,dt=0.2 --run method=euler-forward,dt=0.01 --layout split \
    --fps 10 --speed 4 --size 520x400 --view 0,75,7,0.4,0,0.2 --grid off --out "$images/comet.gif"

start_display 1280x800
say "docs/images/scenes.png: the page of scenes"
open_window --model rope
xdotool mousemove 1270 790 key ctrl+o; expect 'widget scenes.path [0-9].*'; sleep 3 # the pictures are read meanwhile
ffmpeg -v error -f x11grab -video_size 1280x800 -i "$DISPLAY" -frames:v 1 -y "$images/scenes.png" # the page has no key for it
close_window
rm "$folder/trace"
say "docs/images/time-line.png: a time line with a branch, a mark and a change"
open_window --model mesh --set v0=7 --method rk4 --dt 0.05 --speed 4 --play
expect 'step 24[0-9]'; click play; expect 'playing false'
enter time 5; expect 'step 100'
xdotool key b; expect 'bookmarks 1'
enter dt 0.1; expect 'branches 1'
click play; expect 'step 14[0-9]'; click play; expect 'playing false'
window_picture time-line
say "docs/images/lesson.png: a lesson that was done"
open_window --lesson order-is-not-accuracy --size 1280x800
click lesson.do; expect 'playing true'; expect 'playing false'
xdotool mousemove 640 200; sleep 1
window_picture lesson
say "docs/images/speed-against-error.png: plots of three runs of a scene file"
open_window --scene kepler-ellipse --run method=velocity-verlet,dt=0.02 --run method=rk4,dt=0.05 --run method=dop853 --speed 4 --play
expect 'step 3[0-9][0-9]'; click play; expect 'playing false'
choose 'plot 2' 'speed against error'; expect 'costs complete'
xdotool mousemove 640 200; sleep 1
window_picture speed-against-error
say "docs/images/plot.png: a plot as the window saves it"
open_window --model chain --run method=velocity-verlet,dt=0.2 --run method=rk4,dt=0.2 --run method=euler-forward,dt=0.002 \
    --speed 4 --play
expect 'step 1[0-9][0-9]'; click play; expect 'playing false'
click 'energy error.save'; expect 'widget energy error.png [0-9].*'; click 'energy error.png'
expect 'saved .*'
window_saved plot
say "docs/images/playback.png: a trajectory that is played"
"$root/build/release/bin/steplab" run --model mesh --set dim=20 --set v0=9 --dt 0.05 --steps 400 --every 2 \
    --out "$folder/mesh.trajectory" >/dev/null
open_window --trajectory "$folder/mesh.trajectory" --speed 4 --play
expect 'step 2[2-9][0-9]'; click play; expect 'playing false'
window_picture playback
say "docs/images/million.png: a mesh of a million particles that LAMMPS computes on two ranks"
"$root/build/release/bin/steplab" export --model mesh --set dim=1000 --method velocity-verlet --to scene --out "$folder/million.toml"
"$root/build/release/bin/steplab" cluster --scene "$folder/million.toml" --dt 0.1 --steps 800 --every 100 --ranks 2 \
    --out "$folder/million.trajectory" >/dev/null
picture million --trajectory "$folder/million.trajectory" --steps 800 --ui on --colour displacement --displacements 10 \
    --view 35,30,120,1000,0,-1000 --size 1000x640 --scale 0.8
