# shellcheck shell=bash
# Sourced by the scripts here: a folder of their own with the library as `cmake --install` leaves it.

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# install_library BUILD_FOLDER
install_library() {
    local component
    for component in steplab libsteplab0.2 libsteplab-dev; do
        cmake --install "$1" --prefix "$folder/prefix" --component "$component" >/dev/null
    done
}

# build_on_library PROJECT_FOLDER: the programs are in $folder/build then.
build_on_library() {
    rm -rf "$folder/build"
    cmake -S "$1" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" >/dev/null
    cmake --build "$folder/build"
}
