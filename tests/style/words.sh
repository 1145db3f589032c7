#!/usr/bin/env bash
# The files contain no paths of one machine, no marks of unfinished work, no leftovers of merges, and none of the phrases
# that docs/glossary.md replaces.
set -euo pipefail
cd "$SOURCE"
patterns=(
    '/hom[e]/|/wor[k]/|/Use[r]s/'
    '\b(TOD[O]|FIXM[E]|XX[X]|HAC[K])\b'
    'surely belo[w]|in vai[n]|[0-9a-z] go before (it|the[m])|times as dea[r]'
    '^(<<<<<<[<] |>>>>>>[>] |======[=]$)'
)
folders=(src include shaders scenes scripts cmake docs packaging tests .ci README.md CHANGELOG.md CONTRIBUTING.md vcpkg.json CMakeLists.txt CMakePresets.json)
found=0
for pattern in "${patterns[@]}"; do
    for folder in "${folders[@]}"; do
        [[ ! -e $folder ]] || ! grep -rInE --exclude=glossary.md "$pattern" "$folder" || found=1
    done
done
exit "$found"
