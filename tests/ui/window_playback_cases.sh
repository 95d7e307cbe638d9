# shellcheck shell=bash disable=SC2154  # the script that sources this one sets folder and program
# Sourced by window_test.sh: files that are played.

trajectory_is_played() {
    start_display 1280x800
    local steplab
    steplab=$(dirname "$program")/steplab
    (cd "$folder" && "$steplab" run --model chain --dt 0.1 --steps 40 --every 2 --out a.trajectory >run.txt)
    open_window --trajectory a.trajectory
    grep -qx 'playback 0 21' "$folder/said" || expect 'playback 0 21'
    xdotool key Right; expect 'playback 1 21' 'step 2'
    click time; expect 'step 20'
    enter time 1.3; expect 'step 12'
    enter time 'step 7'; expect 'step 6'
    xdotool key b; expect 'bookmarks 1'
    xdotool key r; expect 'error a trajectory is played back.*' 'widget refusal.close [0-9].*'
    xdotool key Escape; expect 'widget refusal.close gone'
    xdotool key t; expect 'error a trajectory is played back: no runs go beside it.*'
    xdotool key Escape
    click fastest; expect 'rate fastest'
    click play; expect 'playback 20 21' 'playing false'
    choose menu 'copy command'
    expect 'copied steplab view --trajectory a.trajectory --steps 40 .*'
    xdotool key BackSpace; expect 'playback 0 21'
    xdotool key Right; expect 'step 2'
    click continue; expect 'playback none' 'step 0' 'command .*--from a.trajectory:2.*'
    xdotool key Right; expect 'step 1'
    drop "$folder/a.trajectory"
    expect 'playback 0 21'
    xdotool key bracketright; expect 'playback none' 'model mesh'
    close_window
}

# xyz_frame NUMBER: a frame of another program, 10 steps apart, in a box that leans.
xyz_frame() {
    printf '3\nLattice="4 0 0 1 4 0 0 0 4" Properties=species:S:1:pos:R:3:charge:R:1 Step=%d Time=%d\n' $((10 * $1)) "$1"
    printf 'H 0 0 %d 0.5\nO 1 1 1 -1\nO 2 2 2 nan\n' "$1"
}

text_of_another_program_is_followed() {
    start_display 1280x800
    for i in 0 1 2; do xyz_frame $i; done >"$folder/a.xyz"
    open_window --trajectory a.xyz --colour column:charge
    grep -qx 'colour column:charge' "$folder/said" || expect 'colour column:charge'
    grep -qx 'playback 0 3' "$folder/said" || expect 'playback 0 3'
    xdotool key Right; expect 'playback 1 3' 'step 10'
    xyz_frame 3 >>"$folder/a.xyz"; expect 'playback 1 4'
    xyz_frame 4 | head -c 100 >>"$folder/a.xyz"
    xyz_frame 4 | tail -c +101 >>"$folder/a.xyz"; expect 'playback 1 5'
    click time; xdotool key Right Right; expect 'playback 4 5'
    choose colouring speed; expect 'colour speed'
    choose colouring column:charge; expect 'colour column:charge'
    choose menu 'copy command'
    expect 'copied steplab view --trajectory a.xyz --steps 40 .*--colour column:charge .*'
    xdotool key bracketright; expect 'playback none' 'colour speed'
    close_window
}
