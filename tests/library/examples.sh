#!/usr/bin/env bash
# Builds the programs of examples/ on the library as it is installed, and runs them: examples.sh BUILD_FOLDER EXAMPLES
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for component in steplab libsteplab0.2 libsteplab-dev; do
    cmake --install "$1" --prefix "$folder/prefix" --component "$component" >/dev/null
done
cmake -S "$2" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" >/dev/null
cmake --build "$folder/build"
"$folder/build/own_method"
"$folder/build/own_force"
