#!/usr/bin/env bash
# Draws the pictures of README.md and docs/ anew, into docs/images/.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

images=$root/docs/images

# picture NAME [arguments of steplab snapshot]
picture() {
    local name=$1
    shift
    say "docs/images/$name.png: steplab snapshot $*"
    "$root/build/release/bin/steplab" snapshot "$@" --out "$images/$name.png"
}

build release --target programs
mkdir -p "$images"
picture window --model mesh --set dim=17 --steps 123 --ui on --size 1280x800
picture free --model free --steps 40 --size 800x500
picture oscillator --model oscillator --steps 10 --size 800x500
picture chain --model chain --steps 120 --size 800x500
picture mesh --model mesh --set dim=24 --steps 150 --size 800x500
picture rope --model rope --steps 12 --size 800x500
picture morse --model morse --set v0=2 --dt 0.02 --steps 450 --size 800x500
