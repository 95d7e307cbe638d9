#!/usr/bin/env bash
# Installs the packages of build/package into a bare Debian 12 and uses them there: scripts/bare-debian.sh [FOLDER OF DEBS]
#
# As root, with debootstrap. Runs the program, the library's example, the Python module and the command of the menu entry
# under Xvfb; then removes the packages and looks for what they left.

# shellcheck disable=SC2016 # what is quoted is expanded inside
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

debs=$(realpath "${1:-$root/build/package}")
((EUID == 0)) || fail "this makes a system of its own: run it as root"
compgen -G "$debs/*.deb" >/dev/null || fail "no packages in $debs: run scripts/package.sh first"
ensure_packages package

bare=$(mktemp -d)
trap 'umount -q "$bare/proc" || true; rm -rf --one-file-system "$bare"' EXIT
say "debootstrap"
debootstrap --variant=minbase bookworm "$bare" >"$bare.log" 2>&1 || { tail "$bare.log" >&2; fail "debootstrap failed"; }
rm -f "$bare.log"
cp /etc/resolv.conf "$bare/etc/resolv.conf"
cp "$debs"/*.deb "$bare/tmp/"
mount -t proc proc "$bare/proc"

inside() {
    chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive bash -euc "$1"
}

say "installing"
inside 'apt-get update -q >/dev/null; apt-get install -q -y --no-install-recommends /tmp/*.deb >/tmp/install.log 2>&1 ||
    { tail /tmp/install.log; exit 1; }'

say "the program"
inside 'cd /tmp; steplab --version
    steplab run --scene figure-eight --until 6 --summary - 2>/dev/null | grep -E "\"(hash|status)\""
    steplab snapshot --model rope --steps 20 --size 320x200 --out rope.png
    test -s /usr/share/man/man1/steplab-run.1.gz -a -s /usr/share/bash-completion/completions/steplab'

say "the Python module"
inside 'cd /tmp; python3 -c "
import steplab
run = steplab.run(steplab.Scene.from_file(\"figure-eight\"), until=6)
print(\"hash\", run.hash)
print(\"picture\", steplab.Simulation(steplab.Scene.model(\"rope\")).snapshot(320, 200).pixels.shape)"'

say "the command of the menu entry"
inside 'apt-get install -q -y --no-install-recommends xvfb >/dev/null 2>&1
    command=$(sed -n "s/^Exec=//p" /usr/share/applications/steplab.desktop)
    Xvfb :9 -screen 0 1280x800x24 >/dev/null 2>&1 & server=$!
    for ((i = 0; i < 100; ++i)); do [[ -S /tmp/.X11-unix/X9 ]] && break; sleep 0.1; done
    export DISPLAY=:9
    code=0; timeout -s TERM 20 $command --trace /tmp/trace || code=$?
    kill $server
    echo "ended with $code after: $(head -n 2 /tmp/trace | tr "\n" ";")"
    [[ $code == 124 || $code == 143 ]]; grep -q . /tmp/trace'

say "the library"
inside 'apt-get install -q -y --no-install-recommends g++ cmake make >/dev/null 2>&1
    cp -r /usr/share/doc/libsteplab-dev/examples /tmp/examples
    cmake -S /tmp/examples -B /tmp/examples/build >/dev/null
    cmake --build /tmp/examples/build >/dev/null
    /tmp/examples/build/own_method; /tmp/examples/build/own_force'

say "removing"
inside 'apt-get purge -q -y steplab libsteplab0.2 libsteplab-dev python3-steplab >/dev/null 2>&1
    rm -rf /tmp/* /root/.config/steplab
    left=$(find / -xdev -path /proc -prune -o -iname "*steplab*" -print; dpkg -l | grep steplab || true)
    if [[ -n $left ]]; then echo "left behind: $left"; exit 1; fi'
say "nothing is left: done"
