#!/usr/bin/env bash
# Drives the real window with keys and mouse on a virtual display.
#     window_test.sh PROGRAM CASE DROP_FILE
set -uo pipefail

program=$(realpath "$1")
drop_file=$(realpath "$3")
readonly program drop_file
folder=$(mktemp -d)
readonly folder
# shellcheck source=/dev/null
source "$(dirname "$0")/window_driver.sh"
# shellcheck source=/dev/null
source "$(dirname "$0")/window_choices_cases.sh"
source "$(dirname "$0")/window_playback_cases.sh"
export XDG_CONFIG_HOME=$folder/config # not that of the person who runs the tests
export MALLOC_PERTURB_=85 # memory that is used after it was freed is no longer as it was, the driver's too
trap clean_up EXIT

keys_drive_the_run() {
    start_display 1280x800
    open_window --model mesh
    xdotool key Right; expect 'step 1'
    xdotool key Right; expect 'step 2'
    xdotool key Left; expect 'step 1'
    xdotool key BackSpace; expect 'step 0'
    xdotool key space; expect 'playing true' 'step 3'
    xdotool key space; expect 'playing false'
    xdotool key equal; expect 'rate 2'
    xdotool key minus; expect 'rate 1'
    xdotool key bracketleft; expect 'model chain'
    xdotool key bracketright; expect 'model mesh'
    close_window
}

keys_drive_the_window() {
    start_display 1280x800
    open_window --model mesh --size 1000x700
    xdotool key Tab; expect 'widget model gone'
    xdotool key Tab; expect 'widget model [0-9].*'
    xdotool key F1; expect 'widget help [0-9].*'
    xdotool key F1; expect 'widget help gone'
    xdotool key F11; expect 'size 1280x800'
    xdotool key F11; expect 'size 1000x700'
    xdotool key shift+Right; expect 'widget panel.edge 31[0-9].*'
    xdotool key shift+Home; expect 'widget panel.edge 29[0-9].*'
    xdotool key ctrl+p; expect 'saved steplab-mesh-1.png'
    [[ $(head -c 8 "$folder/steplab-mesh-1.png" | tail -c 7) == $'PNG\r\n\x1a' ]] || fail "the picture is no PNG"
    close_window
}

signals_end_it() {
    local signal code
    start_display 1280x800
    for signal in TERM HUP; do # a shell has its background programs ignore SIGINT
        rm -f "$folder/trace"
        open_window --model chain --play
        kill -s $signal "$window_pid"
        code=0
        wait "$window_pid" || code=$?
        window_pid=
        ((code == 128 + $(kill -l $signal))) || fail "SIG$signal ended it with exit code $code"
    done
}

a_trace_that_cannot_be_written_ends_it() {
    start_display 1280x800
    local code=0
    "$program" --trace /dev/full 2>"$folder/errors" || code=$?
    ((code == 3)) || fail "it ended with exit code $code"
    grep -q "cannot write '/dev/full'" "$folder/errors" || fail "it wrote: $(cat "$folder/errors")"
}

losing_its_display_it_says_so() {
    start_display 1280x800
    open_window --model chain
    kill "$display_pid"
    local code=0
    wait "$window_pid" || code=$?
    window_pid=
    ((code == 5)) || fail "it ended with exit code $code"
    [[ $(cat "$folder/errors") == 'steplab-view: the connection to the display is lost' ]] || fail "it wrote: $(cat "$folder/errors")"
}

mouse_moves_the_camera() {
    start_display 1280x800
    open_window --model chain
    local home
    home=$(grep '^camera ' "$folder/said" | tail -1)
    xdotool mousemove 800 300 click 4; expect 'camera .*'
    xdotool key Home; expect "$home"
    xdotool mousemove 800 300 mousedown 1 mousemove 860 300 mousemove 900 320 mouseup 1; expect 'camera .*'
    xdotool key Home; expect "$home"
    xdotool mousemove 800 300 mousedown 3 mousemove 860 300 mousemove 900 320 mouseup 3; expect 'camera .*'
    xdotool key f; expect 'camera .*'
    close_window
}

panel_changes_the_run() {
    start_display 1280x800
    open_window --model mesh
    choose model rope; expect 'model rope' 'run 1'
    choose method verlet; expect 'method verlet'
    click precision/float; expect 'precision float'
    enter dt 0.05; expect 'dt 0.05'
    click step; expect 'step 1'
    click step; expect 'step 2'
    click 'step back'; expect 'step 1'
    click play; expect 'playing true'
    enter scene.g 1.62; expect 'command .*--set g=1.62.*'
    click play; expect 'playing false'
    enter scene.n 25; expect 'command .*--set n=25.*' 'step 0'
    click restart; expect 'run [0-9]+'
    choose menu 'copy command'
    expect 'copied steplab view --model rope --set n=25 --set g=1.62 --method verlet --precision float --dt 0.05 --config none'
    close_window
}

plots_are_chosen_and_saved() {
    cd "$folder" || exit
    start_display 1600x900
    open_window --model chain --method rk4 --dt 0.1 --size 1600x900
    xdotool key Right Right Right; expect 'step 3' 'pictured 3'
    choose 'plot 1' energies; expect 'widget energies [0-9].*'
    click energies.scale
    click plots.add; expect 'widget plot 3 [0-9].*'
    click energies.save; expect 'widget energies.csv [0-9].*'; click energies.csv
    expect 'widget energies.csv gone'
    [[ $(head -n 1 steplab-energies-1.csv) == time,kinetic,potential,total && $(wc -l <steplab-energies-1.csv) == 5 ]] ||
        fail 'the table of a plot does not hold the four steps'
    xdotool key Tab; expect 'widget energies gone'
    xdotool key Right; expect 'step 4'
    xdotool key Tab; expect 'widget energies [0-9].*'
    click energies.save; expect 'widget energies.csv [0-9].*'; click energies.csv
    expect 'widget energies.csv gone'
    [[ $(wc -l <steplab-energies-2.csv) == 6 ]] || fail 'steps are missing from a plot that was hidden'
    click energies.save; expect 'widget energies.svg [0-9].*'; click energies.svg
    expect 'widget energies.svg gone'
    grep -q '<polyline' steplab-energies-1.svg || fail 'the drawing of a plot has no line'
    choose 'plot 3' spectrum; expect 'widget spectrum [0-9].*'
    choose 'plot 3' 'pair potential'; expect 'widget spectrum gone' 'widget pair potential [0-9].*'
    point_at energies.axis; xdotool click 4
    click energies.save; expect 'widget energies.svg [0-9].*'; click energies.svg
    expect 'widget energies.svg gone'
    cmp -s steplab-energies-1.svg steplab-energies-2.svg && fail 'the wheel over the values of a plot changes nothing'
    click 'energy error.close'; expect 'widget plot 3 gone' 'widget plot 2 [0-9].*'
    choose 'plot 2' 'speed against error'; expect 'costs complete'
    close_window
}

# saved_table FILE OPTION...: the energy error of a run of some hundred steps in a window with these options.
saved_table() {
    open_window --model chain --method velocity-verlet --dt 0.1 --play "${@:2}"
    expect 'step [1-9][0-9]{2}'
    xdotool key space; expect 'playing false'
    click 'energy error.save'; expect 'widget energy error.csv [0-9].*'; click 'energy error.csv'
    expect 'widget energy error.csv gone'
    mv "$folder/steplab-energy-error-1.csv" "$1"
    close_window
    rm "$folder/trace"
}

# As many steps for each frame, or far more: the same rows.
plots_have_the_same_rows_at_any_rate() {
    start_display 1280x800
    saved_table "$folder/slow" --speed 2
    saved_table "$folder/fast" --speed 16 --size 1280x790
    local rows slow fast
    slow=$(wc -l <"$folder/slow") fast=$(wc -l <"$folder/fast")
    rows=$((slow < fast ? slow : fast))
    ((rows > 100)) || fail "only $rows rows"
    cmp -s <(head -n $rows "$folder/slow") <(head -n $rows "$folder/fast") || fail 'the rows depend on the rate'
}

plots_tell_values_under_the_pointer() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 0.1
    xdotool key Right Right Right; expect 'pictured 3'
    point_at 'energy error'; expect 'widget energy error.values [0-9].*'
    xdotool mousemove 700 300; expect 'widget energy error.values gone'
    close_window
}

diagram_points_become_runs() {
    start_display 1280x800
    printf 'version = 1\nplots = [{kind = "speed against error", scale = "logarithmic"}]\n' >"$folder/view.toml"
    config=$folder/view.toml open_window --model oscillator
    expect 'costs complete'
    local times
    for ((times = 0; times < 12; ++times)); do # where points are is said while the keyboard is at the plots
        xdotool key F6
        comes 2 'widget speed against error.point/rk4, dt [^ ]* s, double [0-9].*' && break
    done
    local point
    point=$(printf '%s\n' "${!place[@]}" | grep 'point/rk4, dt' | head -n 1)
    click "$point"; expect 'runs rk4 double 0.1, rk4 double [0-9.e-]*'
    close_window
}

runs_go_beside_each_other() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 0.1
    choose 'add run' euler; expect 'runs rk4 double 0.1, euler double 0.1' 'compared 2'
    xdotool key t; expect 'runs rk4 double 0.1, euler double 0.1, rk4 float 0.1' 'compared 3'
    xdotool key Right Right; expect 'step 2' 'pictured 2'
    click layout/split; expect 'widget magnify gone'
    click layout/ghosts; expect 'widget magnify [0-9].*'
    click 'equal cost'; expect 'runs rk4 double 0.1, euler double 0.025, rk4 float 0.1'
    click 'run 1'; expect 'method euler' 'runs euler double 0.025, .*'
    click 'run 0.remove'; expect 'method rk4'
    xdotool key r; expect 'changes 1'
    choose_beside runs 'turn round' 'changes 2'
    choose_beside runs twin 'runs rk4 double 0.1'
    close_window
}

lessons_are_opened_done_and_closed() {
    start_display 1280x720
    open_window --model mesh --size 1280x720
    xdotool key Right; expect 'step 1'
    choose menu try; expect 'widget lesson/half-the-step [0-9].*'
    click lesson/half-the-step; expect 'lesson half-the-step 1' 'widget lesson.do [0-9].*'
    click lesson.do; expect 'model oscillator' 'step 500' 'playing false' 'runs euler-forward double 0.02, euler-forward double 0.01'
    click lesson.next; expect 'lesson half-the-step 2' 'widget lesson.back [0-9].*'
    click lesson.do; expect 'runs velocity-verlet double 0.2, velocity-verlet double 0.1' 'step 50' 'playing false'
    click lesson.next; expect 'lesson half-the-step 3' 'widget lesson.end [0-9].*'
    click lesson.back; expect 'lesson half-the-step 2' 'widget lesson.next [0-9].*'
    xdotool key ctrl+z; expect 'runs velocity-verlet double 0.2'
    xdotool key ctrl+z; expect 'runs euler-forward double 0.02, euler-forward double 0.01'
    xdotool key ctrl+z; expect 'runs euler-forward double 0.02'
    xdotool key ctrl+z; expect 'model mesh' 'step 1'
    click lesson.close; expect 'lesson none' 'widget lesson gone' 'rate 1' 'widget energy error.scale [0-9].*' # as before it
    close_window
    rm -f "$folder/trace"
    open_window --lesson one-step
    grep -q '^lesson one-step 1' "$folder/said" || fail 'the lesson is not open'
    xdotool key Escape; expect 'lesson none'
    close_window
}

time_line_leads_back_and_forth() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 0.1
    xdotool key Right Right Right Right; expect 'step 4' 'reached 4'
    click time; expect 'step 2'
    enter time 0.3; expect 'step 3'
    enter time 'step 1'; expect 'step 1'
    xdotool key b; expect 'bookmarks 1'
    enter dt 0.2; expect 'dt 0.2' 'branches 1' 'changes 1' 'reached 1'
    xdotool key ctrl+z; expect 'dt 0.1' 'changes 0'
    xdotool key ctrl+y; expect 'dt 0.2' 'changes 1'
    xdotool key Right Right; expect 'step 3' 'widget branch 0 48[0-9] .*' # where it is once the track is longer
    click 'branch 0'; expect 'dt 0.1' 'step 1' 'reached 4' 'widget branch 0 48[0-9] .*' # what is left goes on to 0.5 s, the track to there
    click 'bookmark 0'; xdotool key b; expect 'bookmarks 0'
    xdotool key Right; expect 'step 2'
    xdotool key BackSpace; expect 'step 0'
    xdotool key ctrl+z; expect 'step 2'
    xdotool key Right Right Right Right; expect 'step 6'
    xdotool key j; expect 'playing true' 'playing false' 'step 0'
    xdotool key l; expect 'loop true'
    click loop; expect 'loop false'
    close_window
}

hands_move_particles() {
    start_display 1280x1200
    open_window --model chain --method rk4 --dt 0.1 --size 1280x1200
    xdotool key s
    drag 330 150 1 1260 700; enter selection.mass 2.5; expect 'altered 10' 'changes 1'
    xdotool key ctrl+z; expect 'altered 0' 'changes 0'
    click selection.velocity; xdotool key ctrl+a; xdotool type '0, 0.5, 0'; click selection.kick; expect 'changes 1'
    xdotool key ctrl+z; expect 'changes 0'
    click selection.fixed; expect 'altered 10' 'changes 1'
    xdotool key ctrl+z; expect 'altered 0' 'changes 0'
    xdotool key ctrl+y; expect 'altered 10' 'changes 1'
    xdotool key ctrl+z; expect 'altered 0' 'changes 0'
    xdotool keydown ctrl; drag 731 404 1 740 300; expect 'changes 1' # particle 4, while the run stands
    xdotool keyup ctrl key ctrl+z; expect 'changes 0'
    xdotool keydown ctrl; drag 731 404 3 740 300; expect 'changes 1' # a kick
    xdotool keyup ctrl key ctrl+z; expect 'changes 0'
    xdotool mousemove 731 404 key space keydown ctrl mousedown 1 mousemove 740 380
    expect 'changes 1' 'step [0-9]{2}'
    xdotool mousemove 740 300; expect 'step [3-9][0-9]'
    xdotool mouseup 1 keyup ctrl key space; expect 'playing false'
    xdotool key ctrl+z; expect 'changes 0' 'step [0-9]'
    keys_pull_a_particle
    close_window
}

keys_pull_a_particle() {
    xdotool key BackSpace keydown ctrl key Up key Up keyup ctrl; expect 'changes 1' # while the run stands
    xdotool key ctrl+z; expect 'changes 0'
    xdotool key space keydown ctrl key Up; expect 'changes 1' 'step [1-9][0-9]'
    expect 'step [3-9][0-9]'
    xdotool keyup ctrl key space; expect 'playing false'
    xdotool key ctrl+z; expect 'changes 0'
}

# shows_its_pictures DRIVER WAY: those of Mesa's software renderer of this name come to the window in this way.
shows_its_pictures() {
    export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=$1
    open_window --model chain --method rk4 --size 480x360
    grep -qx "textures $2" "$folder/said" || fail "textures are not $2"
    choose_beside pictures 'scene alone'
    xdotool key Right; expect 'pictured 1'
    xdotool key ctrl+p; expect 'saved steplab-chain-1.png'
    xdotool key ctrl+p; expect 'saved steplab-chain-2.png'
    xdotool key space; expect 'pictured [2-9][0-9]'
    xdotool key space; expect 'playing false'
    xdotool key ctrl+p; expect 'saved steplab-chain-3.png'
    cmp -s "$folder"/steplab-chain-{1,2}.png || fail 'two pictures of one step differ'
    cmp -s "$folder"/steplab-chain-{2,3}.png && fail 'pictures of two steps are the same'
    close_window
    rm "$folder/trace" "$folder"/steplab-chain-*.png
}

# The slow renderer stands for the driver of a graphics card.
pictures_are_copied_or_shared_as_the_driver_allows() {
    start_display 480x360
    shows_its_pictures llvmpipe copied
    shows_its_pictures softpipe shared
}

# Frames of this size take a software renderer longer than their time: none is waited for.
input_is_answered_while_frames_are_slow() {
    start_display 3840x2160
    open_window --model mesh --set dim=60 --size 3800x2100 --speed 4 --play
    expect 'step [0-9]+'
    xdotool key b; expect 'bookmarks 1'
    xdotool key space; expect 'playing false'
    close_window
}

ensemble_goes_with_the_run() {
    start_display 1280x960
    open_window --model chain --method euler --size 1280x930 # room for all rows of the panel
    click ensemble/16; expect 'ensemble 0' 'widget ensemble width [0-9].*'
    click step; expect 'step 1' 'ensemble [0-9.]+e-[0-9]+'
    click play; expect 'playing true' 'step [0-9]{2}'
    click play; expect 'playing false'
    choose 'ensemble spread' k; expect 'ensemble [0-9.]+e-[0-9]+'
    enter 'ensemble width' 0.25; expect 'ensemble 0\.[0-9]+'
    click restart; expect 'step 0' 'ensemble 0'
    click ensemble/off; expect 'ensemble none' 'widget ensemble width gone'
    close_window
}

wrong_entries_are_refused() {
    start_display 1280x800
    open_window --model oscillator
    enter dt nonsense; expect 'widget refusal.close [0-9].*'
    click refusal.close; expect 'widget refusal gone'
    enter scene.m -3; expect 'widget refusal.close [0-9].*'
    close_window
}

text_entries_paste_what_was_copied() {
    start_display 1280x800
    open_window --model oscillator --dt 0.25
    choose menu 'copy command'; expect 'copied .*'
    click dt.value; expect 'widget dt.entry [0-9].*'
    xdotool key ctrl+v key Return; expect 'widget refusal.close [0-9].*'
    click refusal.close; expect 'widget refusal gone'
    close_window
}

divergence_is_reported_and_cured() {
    start_display 1280x800
    open_window --model oscillator --method euler --dt 2.5 # a periodic motion, for which the remedy stays stable
    click fastest; expect 'rate fastest'
    xdotool key space; expect 'diverged [0-9]+' 'widget remedy.dt [0-9].*'
    click remedy.dt; expect 'diverged no' 'playing true' 'widget divergence gone'
    close_window
}

blow_up_is_explained_and_gone_through() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 2
    click fastest; expect 'rate fastest'
    xdotool key space
    expect 'widget divergence [0-9].*' 'widget divergence.beginning [0-9].*' 'widget remedy.dt [0-9].*'
    click divergence.beginning
    expect 'widget divergence gone' 'pictured [0-9]*'
    xdotool key Right; expect 'step 1'
    xdotool key space; expect 'diverged 4'
    expect 'widget divergence.page [0-9].*' 'widget remedy.dt [0-9].*' # which moves the page's button
    click divergence.page; expect 'page divergence.md'
    click divergence.close; expect 'widget divergence gone'
    xdotool key Left; expect 'diverged no'
    enter time 'step 4'; expect 'diverged 4' 'widget divergence [0-9].*' # it is back
    close_window
}

# Two seconds a step: were it not for the first step beyond the bound, the check would come after minutes.
blow_up_is_announced_at_once() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 2 --play
    expect 'diverged [0-9]+' 'playing false' 'widget divergence [0-9].*'
    close_window
}

window_takes_any_size() {
    start_display 3840x2160
    open_window --model rope --size 3840x2160 --scale 2
    [[ -n ${place[displacement]:-} ]] || fail 'a large window shows no plot'
    local id
    id=$(xdotool search --name '^steplab$' | tail -1)
    xdotool windowsize "$id" 400 300; expect 'size 400x300' 'widget displacement gone'
    xdotool windowsize "$id" 1600 1200; expect 'size 1600x1200'
    xdotool key Right; expect 'step 1'
    close_window
}

minimised_it_draws_nothing_and_comes_back() {
    start_display 1280x800
    start_window_manager
    open_window --model mesh --size 1000x700
    local id
    id=$(xdotool search --name '^steplab$' | tail -1)
    xdotool windowminimize --sync "$id"; expect 'size 0x0'
    xdotool windowmap --sync "$id"; expect 'size 1000x700'
    xdotool windowfocus --sync "$id" key space; expect 'playing true' 'step 3'
    xdotool windowminimize --sync "$id"; expect 'size 0x0'
    xdotool windowmap --sync "$id"; expect 'size 1000x700' 'step [0-9]+'
    close_window
}

command_line_opens_its_scene() {
    start_display 1280x800
    open_window --model morse --set edge=2 --method midpoint --precision float --dt 0.02 --view 10,20,30,1,2,3
    grep -qx 'command --model morse --set edge=2 --method midpoint --precision float --dt 0.02' "$folder/said" ||
        fail "another scene was opened"
    grep -qx 'camera 10,20,30,1,2,3' "$folder/said" || fail "another view was opened"
    close_window
}

copied_command_opens_the_same_again() {
    start_display 1280x800
    local scene='--model chain --method verlet --precision double --dt 0.05'
    local options='--steps 40 --view 10,20,30,1,2,3 --colour speed --background light --springs off --grid off'
    options+=' --particle 3 --speed 2.5 --ensemble 16 --spread k=0.999:1.001 --size 1000x700 --ui on'
    # shellcheck disable=SC2086  # many words
    open_window $scene $options
    [[ $(tail -1 <(grep '^step ' "$folder/said")) == 'step 40' ]] || expect 'step 40'
    grep -qx 'tracked 3' "$folder/said" || expect 'tracked 3'
    choose menu 'copy command'
    expect "copied steplab view $scene $options --config none"
    close_window
}

extreme_views_are_answered() {
    start_display 1280x800
    open_window --model chain --set L=1e30 --play
    xdotool mousemove 800 300 click 4; expect 'camera .*'
    xdotool click 5 click 5; expect 'camera .*'
    xdotool key f; expect 'camera .*' # from where the wheel has left it: it opens with all in view
    close_window
    rm "$folder/trace"
    open_window --model mesh --view 0,0,1e-16,4,0,-4
    xdotool mousemove 800 300 click 5; expect 'camera .*'
    xdotool key f; expect 'camera .*'
    close_window
    rm "$folder/trace"
    open_window --model mesh --view 0,0,10,1e30,0,0
    expect 'widget lost.fit [0-9].*'
    click lost.fit; expect 'widget lost gone'
    close_window
}

escape_closes_what_is_open() {
    start_display 1280x800
    open_window --model mesh
    click method; expect 'widget method/rk4 [0-9].*'
    xdotool key Escape; expect 'widget method/rk4 gone'
    xdotool key F1; expect 'widget help [0-9].*'
    xdotool key Escape; expect 'widget help gone'
    xdotool key ctrl+p; expect 'saved steplab-mesh-1.png' 'widget notice [0-9].*'
    click notice; expect "copied $folder/steplab-mesh-1.png"
    xdotool key Escape; expect 'widget notice gone'
    close_window
}

without_a_scene_it_opens_the_page_of_scenes() {
    start_display 1280x800
    open_window
    click model/two-planets; expect 'model two-planets' 'widget scenes.path gone'
    click model; expect 'widget model/rope [0-9].*'
    click model/rope; expect 'model rope'
    xdotool key ctrl+o; expect 'widget scenes.path [0-9].*'
    xdotool key Escape key Escape; expect 'widget scenes.path gone'
    close_window
}

# scene K: a scene file of a chain with this force constant.
scene() {
    printf 'steplab = 1\n[parameters]\nk = { value = %s, range = [1, 100], what = "stiffness" }\n' "$1"
    printf '[[particles]]\ngroup = "c"\nline = { count = 5, step = [1, 0, 0] }\n'
    printf '[[springs]]\nbetween = "c"\nk = "k"\n[run]\nmethod = "verlet"\ndt = 0.01\n'
}

# drop PATH: drops a file onto the window; %20 stands for a blank.
drop() { "$drop_file" "$(xdotool search --name '^steplab$' | tail -1)" "$1"; }

scene_files_are_opened_by_path_and_by_drop() {
    start_display 1280x800
    scene 3 >"$folder/one.toml"
    scene 4 >"$folder/the other.toml"
    open_window --model mesh
    xdotool key ctrl+o; expect 'widget scenes.path [0-9].*'
    xdotool type -- 'none.toml'
    xdotool key Return; expect 'refused none.toml: there is no such file' 'widget refusal.close [0-9].*'
    click refusal.close; expect 'widget refusal gone'
    click scenes.path
    xdotool key ctrl+a type -- 'one.toml'
    xdotool key Return; expect 'model one' 'widget scenes.path gone' 'widget scene.k.value [0-9].*'
    drop "$folder/the%20other.toml"
    expect 'model the other' "command --scene '$folder/the other.toml' --method verlet --precision double --dt 0.01"
    close_window
}

scene_file_is_read_again_when_it_changes() {
    start_display 1280x800
    scene 3 >"$folder/a.toml"
    open_window --scene a.toml
    xdotool mousemove 800 300 click 4; expect 'camera .*'
    local camera
    camera=$(grep '^camera ' "$folder/said" | tail -1)
    click step; expect 'step 1'
    enter dt 0.005; expect 'dt 0.005'
    scene '"oops"' >"$folder/a.toml"
    expect 'refused a.toml:3:.*' 'widget refusal.close [0-9].*'
    click step; expect 'step 2' # of the last good scene
    scene 4 >"$folder/b.toml"
    mv "$folder/b.toml" "$folder/a.toml" # as editors do
    expect 'run [0-9]+' 'step 0' 'widget refusal gone'
    grep -q "^dt 0.005" "$folder/said" || fail "dt was lost"
    [[ $(grep '^camera ' "$folder/said" | tail -1) == "$camera" ]] || fail "the camera moved"
    close_window
}

# chain_at X: three particles, the last of them at X, as extended XYZ.
chain_at() { printf '3\n\nX 0 0 0\nX 1 0 0\nX %s 0 0\n' "$1"; }

files_that_a_scene_reads_are_watched() {
    start_display 1280x800
    chain_at 2 >"$folder/a.xyz"
    chain_at 5 >"$folder/b.xyz"
    listed() {
        printf 'steplab = 1\n[[particles]]\nfile = "%s"\n[[pairs]]\npotential = "gravity"\nG = 1\n' "$1"
        printf '[start]\nfrom = "start.xyz:0"\n'
    }
    chain_at 3 >"$folder/start.xyz"
    listed a.xyz >"$folder/a.toml"
    open_window --scene a.toml
    click step; expect 'step 1'
    chain_at 4 >"$folder/a.xyz"
    expect 'run [0-9]+' 'step 0'
    click step; expect 'step 1'
    chain_at 6 >"$folder/start.xyz" # named with a step
    expect 'run [0-9]+' 'step 0'
    click step; expect 'step 1'
    listed b.xyz >"$folder/a.toml"
    expect 'run [0-9]+' 'step 0'
    click step; expect 'step 1'
    chain_at 7 >"$folder/b.xyz" # watched since the scene reads it
    expect 'run [0-9]+' 'step 0'
    click step; expect 'step 1'
    printf 'nonsense' >"$folder/b.xyz"
    expect 'refused .*b.xyz.*'
    close_window
}

session_is_recorded_saved_and_played() {
    start_display 1280x800
    open_window --model chain --session a.session
    xdotool key Right; expect 'step 1'
    xdotool key Right; expect 'step 2'
    xdotool key space; expect 'step [1-9][0-9]'
    xdotool key space; expect 'playing false'
    choose menu 'save session'; expect 'saved steplab-session-1.session'
    close_window
    grep -qx 'steplab-session = 2' "$folder/a.session" || fail "no session was recorded"
    local steplab file last
    steplab=$(dirname "$program")/steplab
    for file in a.session steplab-session-1.session; do
        "$steplab" replay "$folder/$file" >"$folder/errors" 2>&1 || fail "$file does not repeat the session"
    done
    rm "$folder/trace"
    cp "$folder/a.session" "$folder/before"
    open_window --session a.session
    last=$(sed -n '/^.end/,$s/^step = //p' "$folder/a.session")
    grep -qx "step $last" "$folder/said" || expect "step $last"
    close_window
    cmp "$folder/before" "$folder/a.session" || fail "the session that was played was changed"
}

session_is_written_when_a_signal_ends_the_window() {
    start_display 1280x800
    local signal code steplab
    steplab=$(dirname "$program")/steplab
    for signal in TERM HUP; do
        rm -f "$folder/trace" "$folder/a.session"
        open_window --model chain --session a.session
        xdotool key Right; expect 'step 1'
        kill -s $signal "$window_pid"
        code=0
        wait "$window_pid" || code=$?
        window_pid=
        ((code == 128 + $(kill -l $signal))) || fail "SIG$signal ended it with exit code $code"
        "$steplab" replay "$folder/a.session" >"$folder/errors" 2>&1 || fail "the session is not whole"
        grep -qx 'do = "step"' "$folder/a.session" || fail "the step is missing"
    done
}

session_file_is_played_by_path_and_by_drop() {
    start_display 1280x800
    open_window --model chain --session a.session
    xdotool key Right; expect 'step 1'
    xdotool key r; expect 'changes 1'
    xdotool key Right; expect 'step 2'
    close_window
    rm "$folder/trace"
    open_window --model rope --session b.session
    drop "$folder/a.session"
    expect 'model chain' 'step 2' 'changes 1' 'saved b.session'
    [[ -s $folder/b.session ]] || fail "the session before it was not written"
    xdotool key ctrl+o
    expect 'widget scenes.path [0-9].*'
    xdotool type a.session
    xdotool key Return
    expect 'widget scenes.path gone' 'run [0-9]+'
    close_window
}

saved_scene_opens_the_same_again() {
    start_display 1280x800
    open_window --model chain --set n=7 --method pefrl --dt 0.02 --view 10,20,30,1,2,3 --colour speed
    xdotool key ctrl+s; expect 'saved steplab-chain-1.toml'
    close_window
    rm "$folder/trace"
    open_window --scene steplab-chain-1.toml
    grep -qx 'camera 10,20,30,1,2,3' "$folder/said" || fail "another view was opened"
    grep -qx 'method pefrl' "$folder/said" || fail "another method was opened"
    grep -qx 'dt 0.02' "$folder/said" || fail "another dt was opened"
    close_window
}

# refused CODE TEXT COMMAND...: the command exits with this code and has this text in one line on standard error.
refused() {
    local code=0 wanted=$1 text=$2
    shift 2
    "$@" >"$folder/said" 2>"$folder/errors" || code=$?
    ((code == wanted)) || fail "exit code $code, not $wanted: $(cat "$folder/errors")"
    grep -qF -- "$text" "$folder/errors" || fail "expected '$text' but got: $(cat "$folder/errors")"
    (($(wc -l <"$folder/errors") == 1)) || fail "more than one line: $(cat "$folder/errors")"
}

without_a_display_it_explains_what_to_do() {
    refused 5 'DISPLAY is not set' env -u DISPLAY -u WAYLAND_DISPLAY "$program"
    refused 5 'steplab snapshot --model rope' env -u DISPLAY -u WAYLAND_DISPLAY "$program" --model rope
    refused 5 "DISPLAY=':987654'" env -u WAYLAND_DISPLAY DISPLAY=:987654 "$program"
    refused 2 'nonsense' env -u DISPLAY "$program" --model nonsense
    refused 2 '--size' env -u DISPLAY "$program" --size 12
}

without_opengl_or_shaders_it_reports_that() {
    start_display 640x480
    refused 5 'OpenGL 3.3' env MESA_GL_VERSION_OVERRIDE=2.1 "$program"
    refused 5 "$folder" env STEPLAB_SHADERS="$folder" "$program"
    refused 5 libegl1 env __EGL_VENDOR_LIBRARY_DIRS="$folder" "$program"
}

"$2"
