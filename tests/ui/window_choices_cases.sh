# shellcheck shell=bash disable=SC2154,SC2034  # the script that sources this one sets folder, and uses config
# Sourced by window_test.sh: what a person chooses about the window, and what of it is remembered.

# reopen OPTION...: another window after the last one was closed.
reopen() {
    rm -f "$folder/trace"
    open_window "$@"
}

# said REGEX...: these lines have come already.
said() {
    local wanted
    for wanted in "$@"; do
        grep -qxE "$wanted" "$folder/said" || fail "it did not say '$wanted'"
    done
}

# width_of WIDGET: its width as traced last.
width_of() { grep "^widget $1 [0-9]" "$folder/said" | tail -1 | awk '{ print $(NF - 1) - $(NF - 3) }'; }

the_interface_is_scaled_by_keys() {
    start_display 1600x1200
    open_window --model chain --size 1600x1200
    local usual
    usual=$(width_of snapshot)
    xdotool key ctrl+equal; expect 'scale 1.1' 'widget snapshot [0-9].*'
    (($(width_of snapshot) > usual)) || fail "the button is $(width_of snapshot) wide, and was $usual"
    xdotool key ctrl+equal ctrl+equal ctrl+equal; expect 'scale 1.75' 'widget panel.edge 52[0-9].*'
    xdotool key ctrl+0; expect 'scale 1' 'widget panel.edge 29[0-9].*'
    xdotool key ctrl+minus ctrl+minus ctrl+minus; expect 'scale 0.75'
    xdotool key ctrl+minus Right; expect 'step 1'
    [[ $(grep '^scale ' "$folder/said" | tail -1) == 'scale 0.75' ]] || fail 'there is a smaller scale'
    choose_beside 'text size' larger 'scale 0.9'
    close_window
}

choices_are_remembered() {
    local config="$folder/new folder/view.toml"
    start_display 1280x800
    open_window --model chain --size 1200x790
    xdotool key Right; expect 'step 1'
    close_window
    [[ ! -e $config ]] || fail 'a window in which nothing was chosen wrote a file'
    reopen --model chain
    xdotool key ctrl+equal; expect 'scale 1.1' 'widget background/light [0-9].*' 'widget plot 1 [0-9].*'
    click background/light
    choose 'plot 1' energies; expect 'widget energies.scale [0-9].*'
    read -r x y <<<"${place[panel.edge]}"
    drag "$x" "$y" 1 400 "$y"; expect 'widget panel.edge 39[0-9].*'
    close_window
    grep -qx 'scale = 1.1' "$config" || fail "the scale has more digits than it needs: $(cat "$config")"
    grep -q "^theme = 'light'" "$config" || fail "the theme is not in the file: $(cat "$config")"
    reopen --model chain
    said 'scale 1.1' 'widget energies.scale [0-9].*' 'widget panel.edge 39[0-9].*'
    choose menu 'copy command'; expect 'copied steplab view --model chain --method [a-z0-9-]* --precision double --dt [0-9.]* .*--background light.*'
    xdotool key Tab; expect 'widget model gone'
    close_window
    reopen --model chain --ui on --size 1000x700 --background dark --scale 1
    said 'size 1000x700' 'scale 1'
    expect 'widget model [0-9].*'
    close_window
    grep -q '^panel = false' "$config" || fail "what the command line said was remembered: $(cat "$config")"
    reopen --model chain --size 1280x800
    choose menu 'reset layout'; expect 'scale 1' 'widget panel.edge 29[0-9].*'
    close_window
}

choices_that_cannot_be_read_are_no_error() {
    local config=$folder/view.toml text
    start_display 1280x800
    for text in 'scale = = 2' 'scale = 1e9' 'version = 99'; do
        echo "$text" >"$config"
        reopen --model chain
        said 'scale 1'
        [[ -n ${place[refusal]:-} ]] || expect 'widget refusal [0-9].*'
        xdotool key Escape; expect 'widget refusal gone'
        xdotool key ctrl+q
        wait "$window_pid" || fail "it ended with exit code $?"
        window_pid=
        [[ $(wc -l <"$folder/errors") == 1 ]] && grep -q "note: .*view.toml: " "$folder/errors" ||
            fail "of '$text' it wrote: $(cat "$folder/errors")"
        [[ $(cat "$config") == "$text" ]] || fail 'the file was replaced'
    done
}

# size_of PNG: WIDTHxHEIGHT.
size_of() { od -An -t u1 -j 16 -N 8 "$1" | awk '{ print ($1 * 256 + $2) * 65536 + $3 * 256 + $4 "x" ($5 * 256 + $6) * 65536 + $7 * 256 + $8 }'; }

pictures_show_what_is_chosen() {
    start_display 1280x800
    open_window --model chain
    xdotool key ctrl+p; expect 'saved steplab-chain-1.png'
    choose_beside pictures 'scene alone'; xdotool key ctrl+p; expect 'saved steplab-chain-2.png'
    choose_beside pictures caption; xdotool key ctrl+p; expect 'saved steplab-chain-3.png'
    choose_beside pictures 'scene alone'; xdotool key ctrl+p; expect 'saved steplab-chain-4.png'
    local sizes i
    for i in 1 2 3 4; do sizes+="$(size_of "$folder/steplab-chain-$i.png") "; done
    [[ $sizes == '1280x800 980x'???' 980x'???' 1280x838 ' ]] || fail "the pictures are $sizes"
    local alone=${sizes#* } captioned
    alone=${alone%% *} captioned=${sizes#* * } captioned=${captioned%% *}
    ((${captioned#*x} == ${alone#*x} + 38)) || fail "the caption is not below the scene: $sizes"
    close_window
}

opens_with_plots_and_a_caption() {
    start_display 1280x800
    open_window --model chain --plots phase-portrait,energies --caption 'how it began'
    [[ -n ${place[phase portrait.save]:-} && -n ${place[energies.save]:-} && -z ${place[displacement.save]:-} ]] ||
        fail "other plots are shown: ${!place[*]}"
    xdotool key Right; expect 'step 1' 'pictured 1'
    xdotool key ctrl+p; expect 'saved steplab-chain-1.png'
    [[ $(size_of "$folder/steplab-chain-1.png") == 1280x838 ]] || fail "its size is $(size_of "$folder/steplab-chain-1.png")"
    choose menu 'copy command'
    expect "copied steplab view .* --plots phase-portrait,energies --caption 'how it began' --config none"
    close_window
}

films_are_recorded() {
    local frames i
    start_display 1280x800
    open_window --model chain --method rk4 --dt 0.01 --speed 1
    choose_beside pictures films/.png
    # a place is told when it changes: the button of a film that is taken is wider
    xdotool key ctrl+r; expect 'film begun' 'film 1 step 0' 'widget record [0-9].*'
    xdotool key space; expect 'film 10 step 30'
    xdotool key equal; expect 'film 20 step 63'
    choose menu record; expect 'film saved steplab-chain-1.frames' 'widget record [0-9].*'
    xdotool key space; expect 'playing false'
    frames=$(grep -cE '^film [0-9]+ step' "$folder/said")
    [[ $(find "$folder/steplab-chain-1.frames" -name '*.png' | wc -l) == "$frames" ]] || fail "not $frames pictures"
    # frame k shows the last step that is not after k/30 s
    awk '/^film [0-9]/ { if ($4 != int(($2 - 1) / 30 / 0.01 + 1e-6)) { print "frame " $2 - 1 " shows step " $4; exit 1 } }' \
        "$folder/said" >&2 || fail 'frames are not at equal distances'
    choose_beside pictures films/.mp4
    choose_beside pictures 'scene alone'; choose_beside pictures caption
    click record; expect 'film begun' 'film 1 step [0-9]+'
    xdotool key space; expect 'film 12 step [0-9]+'
    close_window
    [[ $(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$folder/steplab-chain-1.mp4") -ge 12 ]] ||
        fail 'the film of a window that was closed is not complete'
}

# film_of_numbered_pictures: the first 20 pictures of a run from its start, the whole window.
film_of_numbered_pictures() {
    rm -f "$folder/trace"
    open_window --model chain --method rk4 --dt 0.01 --size 900x640
    choose_beside pictures films/.png
    xdotool key ctrl+r; expect 'film begun' 'film 1 step 0'
    xdotool key space; expect 'film 20 step 63'
    xdotool key ctrl+r; expect 'film saved steplab-chain-[0-9].frames'
    xdotool key space; expect 'playing false'
    close_window
}

films_of_the_same_are_the_same() {
    local i
    start_display 1280x800
    film_of_numbered_pictures
    film_of_numbered_pictures
    cmp -s "$folder"/steplab-chain-1.frames/000{05,15}.png && fail 'the pictures do not change'
    for ((i = 0; i < 20; ++i)); do
        cmp "$folder/steplab-chain-1.frames/$(printf %05d.png $i)" "$folder/steplab-chain-2.frames/$(printf %05d.png $i)" ||
            fail "picture $i of two films of the same is another one"
    done
}

films_are_completed_when_a_signal_ends_the_window() {
    local signal code
    start_display 1280x800
    for signal in TERM HUP; do
        rm -f "$folder/trace" "$folder"/*.mp4
        open_window --model chain --method rk4 --dt 0.01 --play
        xdotool key ctrl+r; expect 'film begun' 'film 12 step [0-9]+'
        kill -s $signal "$window_pid"
        code=0
        wait "$window_pid" || code=$?
        window_pid=
        ((code == 128 + $(kill -l $signal))) || fail "SIG$signal ended it with exit code $code"
        grep -q 'completing the film' "$folder/errors" || fail "it wrote: $(cat "$folder/errors")"
        [[ $(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$folder/steplab-chain-1.mp4") -ge 12 ]] ||
            fail 'the film is not complete'
    done
}

films_in_which_nothing_moves_end() {
    start_display 1280x800
    open_window --model free --dt 1e6
    choose_beside pictures films/.png
    xdotool key ctrl+r; expect 'film begun' 'film 1 step 0'
    click fastest
    xdotool key space; expect 'widget refusal [0-9].*' 'film saved steplab-free-1.frames'
    (($(find "$folder/steplab-free-1.frames" -name '*.png' | wc -l) == 1)) || fail 'there are other pictures'
    xdotool key Escape; expect 'widget refusal gone'
    close_window
}

films_that_cannot_be_written_say_why() {
    local usual_path=$PATH
    start_display 1280x800
    mkdir "$folder/bin"
    printf '#!/bin/sh\nhead -c 9000000 >/dev/null\necho no space >&2\nexit 1\n' >"$folder/bin/ffmpeg"
    chmod +x "$folder/bin/ffmpeg"
    PATH=$folder/bin:$PATH open_window --model chain --method rk4 --dt 0.01 --play
    xdotool key ctrl+r; expect 'film begun' 'film failed' 'widget refusal [0-9].*'
    [[ -z $(find "$folder" -name '*.mp4*') ]] || fail 'something of the film is left'
    xdotool key Right; expect 'playing false' # it goes on
    close_window
    # what was written is kept, also where the film fails while the window is closed
    printf '#!/bin/sh\nprintf half >>/dev/fd/3\ncat >/dev/null\necho no space >&2\nexit 1\n' >"$folder/bin/ffmpeg"
    rm -f "$folder/trace"
    PATH=$folder/bin:$PATH open_window --model chain --method rk4 --dt 0.01
    xdotool key ctrl+r; expect 'film begun' 'film 1 step 0'
    xdotool key ctrl+q
    local code=0
    wait "$window_pid" || code=$?
    window_pid=
    ((code == 3)) || fail "a film that fails at the end ended the window with exit code $code"
    grep -q "^steplab-view: the film ended: ffmpeg, which writes films, failed: no space; .*'steplab-chain-1.mp4.partial'$" \
        "$folder/errors" || fail "it wrote: $(cat "$folder/errors")"
    [[ $(cat "$folder/steplab-chain-1.mp4.partial") == half ]] || fail 'what was written is not kept'
    rm "$folder/bin/ffmpeg"
    local tool
    for tool in mkfifo rm cat tail grep xdotool; do ln -s "$(command -v $tool)" "$folder/bin"; done
    PATH=$folder/bin
    reopen --model chain
    xdotool key ctrl+r; expect 'widget refusal [0-9].*'
    close_window
    PATH=$usual_path
}

# steer_to WIDGET KEY: presses the key until the keyboard is at the widget.
steer_to() {
    local i
    for ((i = 0; i < 60; ++i)); do
        [[ $(grep '^focus ' "$folder/said" | tail -1) == "focus $1" ]] && return
        xdotool key "$2"; expect 'focus .*'
    done
    fail "$2 does not lead to $1"
}

the_keyboard_reaches_the_panels() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 0.1
    xdotool key F6; expect 'focus model'
    steer_to method Down
    xdotool key Return; expect 'focus method/.*'
    steer_to method/euler Down
    xdotool key Return; expect 'method euler' 'focus method'
    steer_to dt Down
    xdotool key Return; expect 'widget dt.entry [0-9].*'
    xdotool type 0.05; xdotool key Return; expect 'dt 0.05'
    xdotool keydown Down; expect 'focus colouring' 'focus background/.*' 'focus grid' # held, it goes on
    xdotool keyup Down
    xdotool key Escape; expect 'focus '
    xdotool key Right; expect 'step 1'
    xdotool key space; expect 'playing true'
    xdotool key space; expect 'playing false'
    close_window
}

small_windows_have_tabs() {
    start_display 1280x800
    open_window --model chain --method rk4 --dt 0.1 --size 640x480
    expect 'widget tab/Scene [0-9].*'
    said 'widget scene.n [0-9].*' 'widget plot 1 [0-9].*'
    click tab/Method; expect 'widget method [0-9].*' 'widget scene.n gone'
    enter dt 0.05; expect 'dt 0.05'
    click tab/State; expect 'widget selection.fixed [0-9].*' 'widget dt gone'
    local id
    id=$(xdotool search --name '^steplab$' | tail -1)
    xdotool windowsize "$id" 400 300; expect 'size 400x300' 'widget tab/State gone' 'widget plot 1 gone'
    xdotool key Tab; expect 'widget tab/Plot [0-9].*' 'widget selection.fixed [0-9].*'
    click tab/Plot; expect 'widget plot 1 [0-9].*'
    choose 'plot 1' energies; expect 'widget energies.scale [0-9].*'
    xdotool windowsize "$id" 1280 800; expect 'size 1280x800' 'widget tab/Plot gone' 'widget method [0-9].*'
    close_window
}
