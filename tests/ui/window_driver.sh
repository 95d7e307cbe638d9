# shellcheck shell=bash disable=SC2154  # the script that sources this one sets folder and program
# Sourced by window_test.sh: opens the real window on a display of its own and drives it with xdotool. It never sleeps:
# the window writes every change to its trace, and expect waits for the line that has to come.

readonly patience=60 # seconds until a line counts as missing

fail() {
    echo "FAILED: $*" >&2
    echo "last lines of its trace:" >&2
    tail -n 30 "$folder/said" >&2
    exit 1
}

clean_up() {
    [[ -n ${window_pid:-} ]] && kill "$window_pid" 2>/dev/null
    [[ -n ${manager_pid:-} ]] && kill "$manager_pid" 2>/dev/null
    [[ -n ${display_pid:-} ]] && kill "$display_pid" 2>/dev/null
    wait
    rm -rf "$folder"
}

# start_display WIDTHxHEIGHT: a virtual display; it reports its number once it is ready.
start_display() {
    for tool in Xvfb xdotool; do
        command -v "$tool" >/dev/null || { echo "FAILED: $tool is needed (see scripts/packages.txt)" >&2; exit 1; }
    done
    mkfifo "$folder/number"
    Xvfb -displayfd 7 -screen 0 "${1}x24" -nolisten tcp 7>"$folder/number" 2>"$folder/display.log" &
    display_pid=$!
    local number
    read -r -t $patience number <"$folder/number" || fail "the virtual display did not start"
    export DISPLAY=:$number
    unset WAYLAND_DISPLAY
}

# start_window_manager: what minimises windows and brings them back; ready once it has put its name on the display.
start_window_manager() {
    command -v openbox >/dev/null || { echo "FAILED: openbox is needed (see scripts/packages.txt)" >&2; exit 1; }
    mkfifo "$folder/manager"
    openbox --sm-disable --startup "sh -c 'echo ready >$folder/manager'" 2>>"$folder/display.log" &
    manager_pid=$!
    local word
    read -r -t $patience word <"$folder/manager" || fail "the window manager did not start"
}

# open_window OPTION...: opens the window and its trace. Unless `config` names a file for it, nothing is remembered from
# one window to the next.
open_window() {
    declare -gA place=()
    mkfifo "$folder/trace"
    (cd "$folder" && exec "$program" --trace "$folder/trace" --config "${config:-none}" "$@") 2>"$folder/errors" &
    window_pid=$!
    exec 3<"$folder/trace"
    : >"$folder/said"
    expect "widget step .*"
}

# expect REGEX...: waits until each of these lines has come, in any order; remembers where widgets are.
expect() {
    local missing=("$@") line wanted left deadline=$((SECONDS + patience))
    while ((${#missing[@]})); do
        # a run that goes on writes lines for ever
        IFS= read -r -t $patience line <&3 && ((SECONDS <= deadline)) || fail "expected '${missing[*]}'; errors: $(cat "$folder/errors")"
        echo "$line" >>"$folder/said"
        note_widget "$line"
        left=()
        for wanted in "${missing[@]}"; do
            [[ $line =~ ^$wanted$ ]] || left+=("$wanted")
        done
        missing=("${left[@]}")
    done
}

# comes SECONDS REGEX: whether such a line comes in that time.
comes() {
    local line deadline=$((SECONDS + $1))
    while ((SECONDS <= deadline)); do
        IFS= read -r -t "$1" line <&3 || return 1
        echo "$line" >>"$folder/said"
        note_widget "$line"
        [[ $line =~ ^$2$ ]] && return 0
    done
    return 1
}

note_widget() {
    [[ $1 =~ ^widget\ (.*)\ (-?[0-9]+)\ (-?[0-9]+)\ (-?[0-9]+)\ (-?[0-9]+)$ ]] || return 0
    local x=$(((BASH_REMATCH[2] + BASH_REMATCH[4]) / 2)) y=$(((BASH_REMATCH[3] + BASH_REMATCH[5]) / 2))
    place[${BASH_REMATCH[1]}]="$x $y"
}

# point_at WIDGET: moves the pointer onto its middle, once it stands still.
point_at() {
    [[ -n ${place[$1]:-} ]] || expect "widget $1 [0-9].*"
    # shellcheck disable=SC2086  # two numbers
    xdotool mousemove ${place[$1]}
}

click() {
    point_at "$1"
    xdotool click 1
}

# drag X Y BUTTON X Y: from one place to another, on the way through the middle.
drag() {
    xdotool mousemove "$1" "$2" mousedown "$3" mousemove $((($1 + $4) / 2)) $((($2 + $5) / 2)) mousemove "$4" "$5" mouseup "$3"
}

# choose MENU ITEM: opens a menu and clicks one of its items once it is there.
choose() {
    click "$1"
    expect "widget $1/$2 [0-9].*"
    click "$1/$2"
}

# choose_beside MENU ITEM [REGEX...]: an item of a menu beside the menu, and the lines that it brings. The menu has to
# be gone: else the next one could not be told from it.
choose_beside() {
    choose menu "$1"
    expect "widget menu/$2 [0-9].*"
    click "menu/$2"
    # once in some hundred runs beside other work the first click goes unanswered; why is not known
    (($# == 2)) && comes 10 "widget menu/$2 gone" && return
    (($# == 2)) && click "menu/$2"
    expect "widget menu/$2 gone" "${@:3}"
}

# enter SLIDER TEXT: types a value in place of a slider.
enter() {
    click "$1.value"
    expect "widget $1.entry [0-9].*"
    xdotool type -- "$2"
    xdotool key Return
}

# close_window: it exits with code 0 and nothing on standard error.
close_window() {
    xdotool key ctrl+q
    local code=0
    wait "$window_pid" || code=$?
    window_pid=
    ((code == 0)) || fail "the window ended with exit code $code"
    [[ ! -s $folder/errors ]] || fail "it wrote: $(cat "$folder/errors")"
}
