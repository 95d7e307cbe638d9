#!/usr/bin/env bash
# Unpacks what scripts/tarball.sh made in bare systems and uses it there: scripts/bare-tarball.sh [SUITE ...]
#
# As root, with debootstrap; by default bookworm, trixie (Debian 12, 13) and noble (Ubuntu 24.04). Each gets what a
# desktop has anyway, libraries of OpenGL and X11, and nothing of steplab's: the program has to give the hash that it
# gives here, draw a picture, and open its window under Xvfb.

# shellcheck disable=SC2016 # what is quoted is expanded inside
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

((EUID == 0)) || fail "this makes systems of its own: run it as root"
tarball=$(compgen -G "$root/build/steplab-*.tar.xz") || fail "no tarball in build: run scripts/tarball.sh first"
ensure_packages package
if (($# == 0)); then set -- bookworm trixie noble; fi
bare=
trap 'leave' EXIT

leave() {
    [[ -z $bare ]] && return
    umount -q "$bare/proc" || true
    rm -rf --one-file-system "$bare" "$bare.log" "$bare.scripts"
}

# bootstrap SUITE
bootstrap() {
    local options=()
    bare=$(mktemp -d)
    cp -r /usr/share/debootstrap "$bare.scripts"
    if [[ ! -e $bare.scripts/scripts/$1 ]]; then # debootstrap of Debian 12 knows Ubuntu, but not this suite nor its keys
        ln -s gutsy "$bare.scripts/scripts/$1"
        options=(--no-check-gpg "--components=main,universe")
    fi
    DEBOOTSTRAP_DIR=$bare.scripts debootstrap --variant=minbase "${options[@]}" "$1" "$bare" >"$bare.log" 2>&1 ||
        { tail "$bare.log" >&2; fail "debootstrap failed"; }
    cp /etc/resolv.conf "$bare/etc/resolv.conf"
    mount -t proc proc "$bare/proc"
}

inside() {
    chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        bash -euc "$1"
}

for suite in "$@"; do
    say "$suite"
    bootstrap "$suite"
    tar -C "$bare/opt" -xf "$tarball"
    inside 'apt-get update -q >/dev/null
        apt-get install -q -y --no-install-recommends libgl1 libglx0 libopengl0 libegl1 libgl1-mesa-dri libx11-6 \
            libxcursor1 libxi6 libxinerama1 libxrandr2 xvfb xkb-data >/tmp/install.log 2>&1 || { tail /tmp/install.log; exit 1; }'
    inside 'cd /opt/steplab-*; bin/steplab --version
        bin/steplab run --scene polymer --until 1 --summary - 2>/dev/null | grep -E "\"(hash|status)\""
        bin/steplab snapshot --model rope --steps 20 --size 320x200 --out /tmp/rope.png'
    inside 'cd /; Xvfb :9 -screen 0 1280x800x24 >/dev/null 2>&1 & server=$!
        for ((i = 0; i < 100; ++i)); do [[ -S /tmp/.X11-unix/X9 ]] && break; sleep 0.1; done
        code=0; DISPLAY=:9 timeout -s TERM 20 /opt/steplab-*/bin/steplab-view --trace /tmp/trace || code=$?
        kill $server
        echo "the window ended with $code after: $(head -n 2 /tmp/trace | tr "\n" ";")"
        [[ $code == 124 || $code == 143 ]]; grep -q "^widget" /tmp/trace'
    leave
    bare=
done
say "done"
