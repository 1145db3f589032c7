#!/usr/bin/env bash
# Links between the documents lead somewhere, the modules in the map are the modules there are, and generated pages are
# what the program would write today.
set -euo pipefail
cd "$SOURCE"
wrong=0
complain() { echo "$*"; wrong=1; }

for page in README.md docs/*.md; do
    while read -r link; do
        target=${link%%#*}
        [[ -z $target || $target == *://* || -e $(dirname "$page")/$target ]] || complain "$page: no file '$link'"
    done < <(grep -oP '\]\(\K[^)\s]+' "$page")
done

for module in src/*/; do
    module=$(basename "$module")
    grep -q "^| \`$module\` |" docs/architecture.md || complain "docs/architecture.md: no row for the module '$module'"
done

if [[ -e docs/settings.md ]]; then
    diff docs/settings.md <("$BUILD/rayscope" settings --markdown) ||
        complain "docs/settings.md is out of date: rayscope settings --markdown > docs/settings.md"
fi
exit "$wrong"
