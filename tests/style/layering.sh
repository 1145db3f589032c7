#!/usr/bin/env bash
# The modules include each other in one direction only, and the check would notice if they did not.
set -euo pipefail
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

check() { "$CMAKE" "-DMODULES=$BUILD/modules.txt" "-DSOURCE=$1" -P "$SOURCE/cmake/check_layering.cmake"; }

# refuses FILE INCLUDE WORDS: the check must fail, and say WORDS, when FILE of a copy also includes INCLUDE.
refuses() {
    rm -rf "${copy:?}"/*
    cp -r "$SOURCE/src" "$SOURCE/include" "$copy"
    printf '#include %s\n' "$2" >>"$copy/$1"
    local said
    if said=$(check "$copy" 2>&1); then
        echo "an include of $2 in $1 went unnoticed"
        exit 1
    fi
    said=$(tr -s '\n ' ' ' <<<"$said") # the messages of CMake are wrapped
    [[ $said == *"$3"* ]] || { echo "expected '$3', got: $said"; exit 1; }
}

check "$SOURCE"
refuses src/base/diagnostics.cpp '"scene/anything.h"' "module 'base' includes module 'scene'"
refuses src/bvh/binary_tree.h '"trace/anything.h"' "module 'bvh' includes module 'trace'"
refuses src/base/nearest_name.h '<rayscope/accel.h>' "module 'base' includes module 'bvh'"
refuses include/rayscope/image.h '<rayscope/scene.h>' "module 'image' includes module 'scene'"
refuses src/image/srgb.h '<rayscope/nothing.h>' "belongs to no module"
