#!/usr/bin/env bash
# Links between the documents are valid, docs/architecture.md lists every module and every folder of a module, and generated
# pages are up to date.
set -euo pipefail
cd "$SOURCE"
wrong=0
complain() { echo "$*"; wrong=1; }

for page in README.md docs/*.md tests/README.md; do
    while read -r link; do
        target=${link%%#*}
        [[ -z $target || $target == *://* || -e $(dirname "$page")/$target ]] || complain "$page: no file '$link'"
    done < <(grep -oP '\]\(\K[^)\s]+' "$page")
done

for module in src/*/; do
    module=$(basename "$module")
    grep -q "^| \`$module\` |" docs/architecture.md || complain "docs/architecture.md: no row for the module '$module'"
done
for folder in src/*/*/; do
    folder=${folder#src/} folder=${folder%/}
    grep -q "^| \`$folder\` |" docs/architecture.md || complain "docs/architecture.md: no row for the folder '$folder'"
done

if [[ -e docs/settings.md ]]; then
    diff docs/settings.md <("$BUILD/rayscope" settings --markdown) ||
        complain "docs/settings.md is out of date: rayscope settings --markdown > docs/settings.md"
fi
exit "$wrong"
