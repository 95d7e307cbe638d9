#!/usr/bin/env bash
# Makes the site of the documentation, with search, in build/site/html: scripts/docs.sh
#
# The pages of docs/ and README.md, and the notebooks with their results, which are executed for it. Fails on a link that
# leads nowhere.
set -euo pipefail
# shellcheck source=scripts/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

case ${1:-} in -h | --help) help_of "${BASH_SOURCE[0]}"; exit ;; esac

pages=$root/build/site/pages
# mkdocs and the notebooks are Debian's, and so is the Python that they need
export PATH=/usr/bin:$PATH

# The pages with links as they lie beside each other; what is no page is looked at in the repository.
collect_pages() {
    rm -rf "$root/build/site"
    mkdir -p "$pages"
    cp -r "$root"/docs/*.md "$root/docs/images" "$root/CHANGELOG.md" "$root/LICENSE" "$pages"
    sed -E 's#\]\(docs/#](#g' "$root/README.md" >"$pages/index.md"
    sed -i -E 's#\]\(\.\./README\.md#](index.md#g; s#\]\(\.\./CHANGELOG\.md#](CHANGELOG.md#g; s#\]\(\.\./(python/notebooks/[a-z0-9-]+)\.ipynb#](\1.md#g; s#\]\(python/notebooks/#](notebooks/#g' "$pages"/*.md
}

execute_notebooks() {
    local notebook
    for notebook in "$root"/python/notebooks/*.ipynb; do
        PYTHONPATH=$root/build/release/python PYDEVD_DISABLE_FILE_VALIDATION=1 \
            /usr/bin/python3 -Xfrozen_modules=off "$root/python/tests/notebooks.py" "$notebook" "$pages/notebooks"
    done
}

ensure_packages core graphics python site
build release -DSTEPLAB_INSTRUCTION_SETS=native --target programs steplab_python
say "executing the notebooks"
collect_pages
execute_notebooks
say "making the pages"
/usr/bin/mkdocs build --strict --quiet --config-file "$root/docs/site/mkdocs.yml"
say "the site is in build/site/html: open index.html there"
