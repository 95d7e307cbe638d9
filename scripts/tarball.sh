#!/usr/bin/env bash
# Makes build/steplab-VERSION-linux-ARCHITECTURE.tar.xz, which runs where it is unpacked: scripts/tarball.sh [--native]
#
# Programs, scenes, lessons, manual, fonts and the libraries that systems have in other versions or not at all; those of
# OpenGL, X11 and the C++ runtime are the system's. For Debian 12 and newer, Ubuntu 24.04 and newer, and others of their
# age. With --native with methods for this processor alone, which is quicker, for trying it out.
# scripts/bare-tarball.sh uses it in bare systems.

# shellcheck disable=SC2016 # $ORIGIN is for the loader of programs
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

sets=("-DSTEPLAB_INSTRUCTION_SETS=avx2;avx512")
if [[ ${1:-} == --native ]]; then sets=(-DSTEPLAB_INSTRUCTION_SETS=native); fi

# of_system LIBRARY: whether every system that the programs are for has it, and has to be the one to give it. What the
# drivers of OpenGL link, too, may not come in another version.
of_system() {
    case $1 in
        ld-linux* | libc.so* | libm.so* | libdl.so* | libpthread.so* | librt.so*) ;;
        libstdc++.so* | libgcc_s.so* | libz.so* | libzstd.so*) ;;
        libGLEW*) false ;;
        libGL* | libEGL* | libOpenGL* | libX* | libxcb* | libOSMesa*) ;;
        *) false ;;
    esac
}

# add_library FILE: with what its package says of its licence
add_library() {
    local name package
    name=$(basename "$1")
    [[ -e $tree/lib/steplab/$name ]] && return
    install -m 644 "$(realpath "$1")" "$tree/lib/steplab/$name"
    patchelf --set-rpath '$ORIGIN' "$tree/lib/steplab/$name"
    package=$(dpkg-query --search "*/$(basename "$(realpath "$1")")" | head -1 | cut -d: -f1)
    install -D -m 644 "/usr/share/doc/$package/copyright" "$tree/share/doc/steplab/licences/$package"
    add_libraries_of "$1"
}

# add_libraries_of FILE: those that it names, and theirs
add_libraries_of() {
    local name
    for name in $(patchelf --print-needed "$1"); do
        if ! of_system "$name"; then add_library "$(ldd "$1" | awk -v name="$name" '$1 == name { print $3 }')"; fi
    done
}

# add_fonts: those that the programs would take here
add_fonts() {
    local package=fonts-dejavu-core files=(/usr/share/fonts/truetype/dejavu/DejaVuSans{,-Bold}.ttf)
    if [[ -e /usr/share/fonts/opentype/inter/Inter-Regular.otf ]]; then
        package=fonts-inter files=(/usr/share/fonts/opentype/inter/Inter-{Regular,SemiBold}.otf)
    fi
    mkdir -p "$tree/share/steplab/fonts"
    install -m 644 "${files[@]}" "$tree/share/steplab/fonts"
    install -D -m 644 "/usr/share/doc/$package/copyright" "$tree/share/doc/steplab/licences/$package"
}

ensure_packages core graphics python package
build package "${sets[@]}"
cd "$root/build"
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:[A-Z]*=//p' package/CMakeCache.txt)
name=steplab-$version-linux-$(uname -m)
tree=$root/build/tarball/$name
say "collecting"
rm -rf "$root/build/tarball"
cmake --install package --prefix "$tree" --component steplab --strip >/dev/null
for program in "$tree"/bin/*; do
    patchelf --set-rpath '$ORIGIN/../lib/steplab' "$program"
    add_libraries_of "$program"
done
for module in package/lib/steplab/*.so; do
    patchelf --set-rpath '$ORIGIN' "$tree/lib/steplab/$(basename "$module")"
    add_libraries_of "$module"
done
add_fonts
rm -rf "$tree/share/lintian"
say "packing"
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git -C "$root" log -1 --format=%ct)" \
    -C tarball -cJf "$name.tar.xz" "$name"
ls -l "$root/build/$name.tar.xz"
