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

# answered REGEX LINES [SECONDS]: waits until the trace has such a line behind its first LINES.
answered() {
    # shellcheck disable=SC2154  # of the driver
    local end=$((SECONDS + ${3:-$patience}))
    until tail -n "+$(($2 + 1))" "$folder/trace" 2>/dev/null | grep -qE "$1"; do
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

# megabytes: what the window has in memory, without the shadow that AddressSanitizer keeps below 0x10007fff8000 of every
# address that was ever used: from 100 to 265 MB in an hour in which the rest grew by 78. Nothing else lies there.
megabytes() {
    awk '/^[0-9a-f]+-/ { split($1, at, "-"); shadow = sprintf("%16s", at[2]) <= sprintf("%16s", "10007fff8000") }
        /^Rss/ && !shadow { sum += $2 }
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

# rest: the window as it would be found at any time, the chain at its start, so that what it takes can be compared.
rest() {
    local lines at tries
    for ((tries = 0; tries < 5; ++tries)); do
        lines=$(wc -l <"$folder/trace")
        resized 1000 700 "$lines" || return 1
        xdotool mousemove 400 300 key Escape key Escape key Escape key ctrl+o 2>>"$folder/xdotool.log"
        answered '^widget scenes.path [0-9]' "$lines" 5 || continue
        at=$(grep -E '^widget scenes.path [0-9]' "$folder/trace" | tail -1 | cut -d' ' -f3,4)
        lines=$(wc -l <"$folder/trace")
        # shellcheck disable=SC2086  # two numbers
        xdotool mousemove $at click 1 key ctrl+a type --delay 5 "$root/assets/scenes/chain.toml"
        xdotool key Return
        if answered '^widget scenes.path gone' "$lines" 5; then break; fi
    done
    sleep 2 # what is freed a moment later
    resting+=("$(megabytes)")
}

number=0
memory=() resting=()
start_display 1300x820
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
