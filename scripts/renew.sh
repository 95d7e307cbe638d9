#!/usr/bin/env bash
# Renews what is made from the code and kept in the repository: scripts/renew.sh [hashes] [golden] [pages] [scenes] [pictures] [counts]
#
#   hashes    assets/golden/hashes.txt: the last bits of every method on every model
#   golden    assets/golden/*.png: the pictures that drawing is compared with
#   pages     the made sections of README.md and docs/*.md
#   scenes    assets/pictures: the pictures of models and shipped scenes on the window's page of scenes
#   pictures  docs/images: the pictures and diagrams of the pages
#   counts    tests/performance/counts.txt: instructions of the key kernels
#
# Without arguments: hashes, golden and pages, which a new method or model needs. Look at `git diff` before you commit: a
# hash or picture that changes without a reason is a fault.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

renew_hashes() {
    build release --target test_sim
    rm -f "$root/build/release/hashes.txt"
    "$root/build/release/tests/test_sim" --gtest_filter='*GoldenHashes.*' >/dev/null || true
    if [[ -e $root/build/release/hashes.txt ]]; then
        cp "$root/build/release/hashes.txt" "$root/assets/golden/hashes.txt"
    fi
}

renew_golden() {
    build release --target test_render
    STEPLAB_UPDATE_GOLDEN=1 "$root/build/release/tests/test_render" --gtest_filter='*Golden.picture_is_as_it_was*' >/dev/null
}

renew_counts() { build release --target renew_counts; }
renew_pages() { "$root/scripts/update-docs.sh"; }
renew_scenes() { "$root/scripts/update-scene-pictures.sh"; }
renew_pictures() { "$root/scripts/update-pictures.sh"; }

ensure_packages core graphics tests
if (($# == 0)); then set -- hashes golden pages; fi
for part in "$@"; do
    case $part in
        hashes | golden | pages | scenes | pictures | counts) "renew_$part" ;;
        *) fail "unknown part '$part' (hashes, golden, pages, scenes, pictures, counts)" ;;
    esac
done
git -C "$root" status --short -- assets docs README.md tests/performance
