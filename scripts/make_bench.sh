#!/usr/bin/env bash
# scripts/make_bench.sh [SIZE]: measures builds and rays beside Embree on the meshes of docs/bench.md, with one thread and
# with all, and writes that page. SIZE is the width and height of the image of primary rays (512). Takes about ten minutes; the
# machine should have nothing else to do.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

size=${1:-512}
build release rayscope_program
"$root/scripts/fetch_dragon.sh" 47k 202k 871k

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
scenes=(builtin:monkey builtin:teapot)
for mesh in dragon-47k dragon dragon-202k dragon-871k; do
    sed "s#meshes/dragon.obj#$root/scenes/meshes/$mesh.obj#" "$root/scenes/dragon.toml" >"$folder/$mesh.toml"
    scenes+=("$folder/$mesh.toml")
done
for threads in 1 "$(nproc)"; do
    "$root/build/release/rayscope" bench "${scenes[@]}" --threads "$threads" --size "$size" --rounds 7 \
        --json "$folder/$threads.json"
done
"$root/scripts/bench_page.py" "$folder"/*.json >"$folder/bench.md"
mv "$folder/bench.md" "$root/docs/bench.md"
