#!/usr/bin/env bash
# Modules and the folders of a module include each other in one direction only, modules declare only what they include,
# and the check detects planted violations.
set -euo pipefail
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

check() { "$CMAKE" "-DMODULES=$BUILD/modules.txt" "-DSOURCE=$1" -P "$SOURCE/cmake/check_layering.cmake"; }

# refuses FILE INCLUDE TEXT: the check of a copy in which FILE also includes INCLUDE must fail with a message that contains
# TEXT.
refuses() {
    rm -rf "${copy:?}"/*
    cp -r "$SOURCE/src" "$SOURCE/include" "$copy"
    [[ -f $copy/$1 ]] || { echo "no file $1"; exit 1; }
    printf '#include %s\n' "$2" >>"$copy/$1"
    local said
    if said=$(check "$copy" 2>&1); then
        echo "the check accepted an include of $2 in $1"
        exit 1
    fi
    said=$(tr -s '\n ' ' ' <<<"$said") # CMake wraps its messages
    [[ $said == *"$3"* ]] || { echo "expected '$3', got: $said"; exit 1; }
}

check "$SOURCE"

# A module that declares another which none of its files includes.
sed 's/^sampling|/sampling|base,/' "$BUILD/modules.txt" >"$copy/modules.txt"
if said=$("$CMAKE" "-DMODULES=$copy/modules.txt" "-DSOURCE=$SOURCE" -P "$SOURCE/cmake/check_layering.cmake" 2>&1); then
    echo "the check accepted an unused module"
    exit 1
fi
said=$(tr -s '\n ' ' ' <<<"$said")
[[ $said == *"module 'sampling' declares 'base' in USES"* ]] || { echo "another message: $said"; exit 1; }

refuses src/base/diagnostics.cpp '"scene/anything.h"' "module 'base' includes module 'scene'"
refuses src/bvh/binary_tree.h '"trace/anything.h"' "module 'bvh' includes module 'trace'"
refuses src/base/nearest_name.h '<rayscope/accel.h>' "module 'base' includes module 'bvh'"
refuses include/rayscope/image.h '<rayscope/scene.h>' "module 'image' includes module 'scene'"
refuses src/image/srgb.h '<rayscope/nothing.h>' "belongs to no module"
refuses src/viewer/model/history.h '"viewer/app/application.h"' "folder 'model' includes folder 'app'"
refuses src/measure/trade/pareto.h '"measure/target/half_films.h"' "folder 'trade' includes folder 'target'"
refuses src/measure/lab/lab_mesh.h '"measure/trade/pareto.h"' "folder 'lab' includes folder 'trade'"
refuses src/bvh/kernel/sphere.h '"bvh/builders/build.h"' "folder 'kernel' includes folder 'builders'"
