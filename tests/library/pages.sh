#!/usr/bin/env bash
# Builds the program of each page with C++ on the library as it is installed, and runs it: pages.sh BUILD_FOLDER SOURCE_FOLDER
#
# The block ```cmake of a page is its CMakeLists.txt, and ```cpp its my_program.cpp, as they stand there.
set -euo pipefail
# shellcheck source=tests/library/installed.sh
source "$(dirname "${BASH_SOURCE[0]}")/installed.sh"

# block LANGUAGE PAGE: the lines of the only such block of a page.
block() {
    awk -v fence="\`\`\`$1" '
        $0 == fence { inside = 1; ++blocks; next }
        $0 == "```" { inside = 0 }
        inside { print }
        END { exit blocks != 1 || inside }' "$2"
}

# run_page PAGE, in an empty folder
run_page() {
    local project=$folder/page
    rm -rf "$project" "$folder/run"
    mkdir "$project" "$folder/run"
    block cmake "$1" >"$project/CMakeLists.txt" || { echo "$1: a page with C++ has one block \`\`\`cmake"; return 1; }
    block cpp "$1" >"$project/my_program.cpp" || { echo "$1: a page with CMake has one block \`\`\`cpp"; return 1; }
    build_on_library "$project"
    (cd "$folder/run" && "$folder/build/my_program")
}

mapfile -t pages < <(grep -lE '^ *``` *(cpp|c\+\+|cxx|cmake)' "$2/README.md" "$2"/docs/*.md)
[[ ${#pages[@]} -gt 0 ]] || { echo "no page has a block of C++"; exit 1; }
install_library "$1"
for page in "${pages[@]}"; do
    echo "$page"
    run_page "$page"
done
