#!/usr/bin/env bash
# The files hold no paths of one machine, no marks of unfinished work and no leftovers of merges.
set -euo pipefail
cd "$SOURCE"
patterns=(
    '/hom[e]/|/wor[k]/|/Use[r]s/'
    '\b(TOD[O]|FIXM[E]|XX[X]|HAC[K])\b'
    '^(<<<<<<[<] |>>>>>>[>] |======[=]$)'
)
folders=(src include shaders scenes scripts cmake docs tests .ci README.md CMakeLists.txt CMakePresets.json)
found=0
for pattern in "${patterns[@]}"; do
    for folder in "${folders[@]}"; do
        [[ ! -e $folder ]] || ! grep -rInE "$pattern" "$folder" || found=1
    done
done
exit "$found"
