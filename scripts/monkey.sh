#!/usr/bin/env bash
# A monkey at the window, on a display of its own: scripts/monkey.sh [--seed N] [--minutes M | --gestures G] [--program FILE]
#
# Keys, clicks, drags, wheel, typing and new sizes at random (default: seed 1 for 10 minutes), the same for a seed.
# Fails if the window ends by anything but its own Quit, does not answer within a minute, writes to standard error,
# keeps growing, or does not close on Ctrl+Q. The last gestures are then in monkey-SEED.txt, for xdotool to repeat.
set -uo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

seed=1 minutes=10 gestures=0 program=$root/build/release/bin/steplab-view
while (($#)); do
    case $1 in
        --seed) seed=$2 ;;
        --minutes) minutes=$2 ;;
        --gestures) gestures=$2 ;;
        --program) program=$(realpath "$2") ;;
        *) fail "unknown option '$1'" ;;
    esac
    shift 2
done
readonly seed minutes gestures program
folder=$(mktemp -d)
readonly folder per_round=40
# shellcheck source=/dev/null
source "$root/tests/ui/window_driver.sh"
trap clean_up EXIT
use_sanitizers # where the program was built with them

# round NUMBER: the gestures of a round as commands of xdotool. Typed numbers are short: a scene of millions of particles
# would leave no time for others.
round() {
    awk -v seed="$seed" -v round="$1" -v count=$per_round '
        function any(n) { return int(rand() * n) }
        function one(list,   parts, n) { n = split(list, parts, " "); return parts[1 + any(n)] }
        function place() { return any(2) ? any(1300) " " any(820) : 960 + any(330) " " any(800) }
        function wait() { return " sleep 0.0" any(6) }
        function drag(button,   line, i) {
            line = "mousemove " place() " mousedown " button
            for (i = any(6); i >= 0; --i) line = line " mousemove " place() wait()
            return line " mouseup " button
        }
        function gesture(   kind, key) {
            kind = any(100)
            if (kind < 30) return "key " one("space Right Left BackSpace Home f equal minus bracketleft bracketright Tab F1 F11 ctrl+p ctrl+equal ctrl+minus ctrl+0 Escape Return Delete Up Down ctrl+a ctrl+c ctrl+v ctrl+x ctrl+z ctrl+z ctrl+y End b r t j l s")
            if (kind < 60) return "mousemove " place() " click " one("1 1 1 1 3 2")
            if (kind < 65) return "mousemove " place() " click --repeat 2 --delay 40 1"
            if (kind < 80) return drag(one("1 1 1 3 2"))
            if (kind < 85) { key = one("ctrl shift alt"); return "keydown " key " " drag(one("1 1 3")) " keyup " key }
            if (kind < 92) return "mousemove " place() " click --repeat " 1 + any(12) " --delay 5 " one("4 5")
            if (kind < 97) return "type --delay 10 --args 1 -- " one("0 1 7 12 0.1 1e-3 -1 1e9 nan inf e . -- 5e-324 x µ ()")
            return "windowsize %1 " 200 + any(1100) " " 150 + any(700)
        }
        BEGIN { srand(seed * 100003 + round); for (i = 0; i < count; ++i) print gesture() wait() }'
}

open_for_the_monkey() {
    ln -sf trace "$folder/said"
    (cd "$folder" && exec "$program" --trace "$folder/trace" --config "$folder/view.toml" --model chain) 2>"$folder/errors" &
    window_pid=$!
    answered '^widget step ' 0 || give_up "it does not open"
    window=$(xdotool search --name steplab | head -1)
}

# said REGEX LINES: the last such line of the trace behind its first LINES.
said() {
    awk -v wanted="$1" -v from="$2" 'NR > from && $0 ~ wanted { line = $0 } END { print line; exit line == "" }' "$folder/trace" 2>/dev/null
}

# answered REGEX LINES [SECONDS]: waits until the trace has such a line behind its first LINES.
answered() {
    # shellcheck disable=SC2154  # of the driver
    local end=$((SECONDS + ${3:-$patience}))
    until said "$1" "$2" >"$folder/line"; do
        kill -0 "$window_pid" 2>/dev/null || return 1
        ((SECONDS < end)) || return 1
        sleep 0.05
    done
}

give_up() {
    cat "$folder"/round-*.txt >"monkey-$seed.txt"
    fail "$* (seed $seed, round $number; its last gestures: monkey-$seed.txt); errors: $(tail -n 30 "$folder/errors")"
}

# Quit is in the menu, too: then the window is opened again.
check_end() {
    local code=0
    wait "$window_pid" || code=$?
    window_pid=
    ((code == 0)) || give_up "the window ended with exit code $code"
    [[ ! -s $folder/errors ]] || give_up "it wrote"
    : >"$folder/trace"
}

# megabytes: what the window has in memory of its own: not the pages of files, among them those of the compiler of shaders,
# of which more and more are read, and not the shadow that AddressSanitizer keeps below 0x10007fff8000 of every address that
# was ever used: from 100 to 265 MB in an hour in which the rest grew by 78. Nothing else lies there.
megabytes() {
    awk '/^[0-9a-f]+-/ { split($1, at, "-"); shadow = sprintf("%16s", at[2]) <= sprintf("%16s", "10007fff8000") }
        /^Anonymous/ && !shadow { sum += $2 }
        END { print int(sum / 1024) }' "/proc/$window_pid/smaps"
}

# resized WIDTH HEIGHT LINES: asks for the size until the trace has it behind its first LINES: a window that is on its way
# out of full screen takes its own.
resized() {
    local tries=0 every=5
    while ((tries++ * every < patience)); do
        xdotool windowsize "$window" "$1" "$2" 2>>"$folder/xdotool.log"
        if answered "^size ${1}x$2" "$3" $every; then return; fi
        kill -0 "$window_pid" 2>/dev/null || return 1
    done
    give_up "it does not answer"
}

# play_round: the gestures, and then a size that it did not have before, which it has to answer.
play_round() {
    round "$number" >"$folder/round-$number.txt"
    rm -f "$folder/round-$((number - 3)).txt"
    sed "s/%1/$window/" "$folder/round-$number.txt" | xdotool - >>"$folder/xdotool.log" 2>&1
    local lines width=$((900 + number % 300)) height=$((600 + number % 97))
    lines=$(wc -l <"$folder/trace")
    resized $width $height "$lines" || { check_end && open_for_the_monkey; }
}

# prepare_rest: a session of which nothing is known but its start.
prepare_rest() {
    (cd "$folder" && exec "$program" --trace "$folder/trace" --config none --model chain --session rest.session) 2>"$folder/errors" &
    window_pid=$!
    answered '^widget step ' 0 || give_up "it does not open"
    xdotool key ctrl+q
    check_end
    [[ -s $folder/rest.session ]] || give_up "it records no session"
}

# clicked WIDGET LINES: waits until the trace has its place behind its first LINES, and clicks its middle.
clicked() {
    answered "^widget $1 [0-9]" "$2" 5 || return 1
    local at
    at=$(awk '{ print int(($(NF - 3) + $(NF - 1)) / 2), int(($(NF - 2) + $NF) / 2) }' "$folder/line")
    # shellcheck disable=SC2086  # two numbers
    xdotool mousemove $at click 1 2>>"$folder/xdotool.log"
}

# at_rest HEIGHT: opens the session of prepare_rest in place of the one that there is, with the usual panels and plots, so that what
# the window takes can be compared: what could be undone until then is gone.
at_rest() {
    local lines
    lines=$(wc -l <"$folder/trace")
    resized 1000 "$1" "$lines" || return 1
    xdotool mousemove 400 300 key Escape key Escape key Escape key ctrl+o 2>>"$folder/xdotool.log"
    clicked scenes.path "$lines" || return 1
    lines=$(wc -l <"$folder/trace")
    xdotool key ctrl+a type --delay 5 rest.session
    xdotool key Return
    answered '^widget scenes.path gone' "$lines" 5 || return 1
    clicked menu 0 || return 1
    clicked 'menu/reset layout' "$lines"
}

rest() {
    local tries
    for ((tries = 0; tries < 5; ++tries)); do
        if at_rest $((700 + tries)); then break; fi
        kill -0 "$window_pid" 2>/dev/null || return 1
    done
    ((tries < 5)) || give_up "it does not come to rest"
    sleep 2 # what is freed a moment later
    resting+=("$(megabytes)")
}

number=0
memory=() resting=()
start_display 1300x820
prepare_rest
open_for_the_monkey
begin=$SECONDS
while ((gestures > 0 ? number * per_round < gestures : SECONDS - begin < minutes * 60)); do
    ((++number))
    play_round
    memory+=("$(megabytes)")
    if ((number % 25 == 0)) && ! rest; then check_end && open_for_the_monkey; fi
done
echo "memory at rest, every 25 rounds: ${resting[*]} MB"
echo "$((number * per_round)) gestures with seed $seed in $((SECONDS - begin)) s"
if memory_grows "${memory[@]}"; then give_up "its memory grows"; fi
xdotool mousemove 400 300 key --clearmodifiers ctrl+q
end=$((SECONDS + 10))
while kill -0 "$window_pid" 2>/dev/null; do
    ((SECONDS < end)) || give_up "it does not close on Ctrl+Q"
    sleep 0.05
done
check_end
