#!/usr/bin/env bash
# Renews the made sections of README.md and docs/: tables of models, methods and keys, the output of commands.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

build release --target programs update_docs
"$root/build/release/docs/update_docs" "$root/build/release/bin" "$root"/README.md "$root"/docs/*.md
