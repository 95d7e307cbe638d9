#!/usr/bin/env bash
# Builds the programs of examples/ on the library as it is installed, and runs them: examples.sh BUILD_FOLDER SOURCE_FOLDER
#
# What docs/library.md says that one of them prints has to be what it prints.
set -euo pipefail
# shellcheck source=tests/library/installed.sh
source "$(dirname "${BASH_SOURCE[0]}")/installed.sh"

# said_of PROGRAM PAGE: the lines after "$ PROGRAM" in an indented block of a page.
said_of() {
    awk -v program="    \$ $1" '$0 == program { inside = 1; next } inside && !/^    / { exit } inside { print substr($0, 5) }' "$2"
}

install_library "$1"
build_on_library "$2/examples"
"$folder/build/own_method" | tee "$folder/printed"
diff <(said_of own_method "$2/docs/library.md") "$folder/printed"
"$folder/build/own_force"
