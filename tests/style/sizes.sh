#!/usr/bin/env bash
# No file is longer than 300 lines and no function longer than 60. The lists name the exceptions.
set -euo pipefail
cd "$SOURCE"
long_files=(tests/bvh/meshes.cpp tests/measure/error_target_test.cpp tests/scene/toml_scene_test.cpp)
long_functions=(tests/bvh/meshes.cpp:edgeCaseRays)
wrong=0
complain() { echo "$*"; wrong=1; }
listed() { [[ " ${*:2} " == *" $1 "* ]]; }

mapfile -t files < <(find src include tests -name '*.h' -o -name '*.cpp' -o -name '*.inl' | sort)
for file in "${files[@]}"; do
    lines=$(wc -l <"$file")
    ((lines <= 300)) || listed "$file" "${long_files[@]}" || complain "$file has $lines lines; at most 300"
done

tool=$(command -v ctags-universal || command -v ctags) || { echo "universal-ctags is not installed"; exit $((wrong ? 1 : 77)); }
"$tool" --version 2>/dev/null | grep -q Universal || { echo "$tool is not universal-ctags"; exit $((wrong ? 1 : 77)); }
while read -r first last file name; do
    [[ $last =~ ^[0-9]+$ ]] || continue # a declaration
    lines=$((last - first + 1))
    ((lines <= 60)) || listed "$file:$name" "${long_functions[@]}" || complain "$file:$first: $name has $lines lines; at most 60"
done < <("$tool" -x --map-c++=+.inl --map-c++=+.h --kinds-c++=f --_xformat='%n %e %F %N' "${files[@]}" 2>/dev/null)
exit "$wrong"
