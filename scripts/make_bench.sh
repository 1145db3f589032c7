#!/usr/bin/env bash
# scripts/make_bench.sh [SIZE]: compares build times and ray throughput with Embree, with one thread and with all, the builders
# with one another, build times from a thousand to ten million triangles, and whole pictures; writes docs/bench.md, its charts,
# and the tables of ratios and pictures in docs/performance.md. SIZE is the width and height of the image of primary rays (512).
# Takes about twenty minutes on an otherwise idle machine.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

size=${1:-512}
build release rayscope_program
"$root/scripts/fetch_dragon.sh" 47k 202k 871k

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bench() { "$root/build/release/rayscope" bench "$@"; }

# hills TRIANGLES: a terrain scene with about so many triangles.
hills() {
    local side
    side=$(python3 -c "print(max(1, round(($1 / 2) ** 0.5)))")
    sed "s/cells = \[[0-9, ]*\]/cells = [$side, $side]/" "$root/scenes/million.toml" >"$folder/hills-$1.toml"
    echo "$folder/hills-$1.toml"
}

scenes=(builtin:monkey builtin:teapot)
for mesh in dragon-47k dragon dragon-202k dragon-871k; do
    sed "s#meshes/dragon.obj#$root/scenes/meshes/$mesh.obj#" "$root/scenes/dragon.toml" >"$folder/$mesh.toml"
    scenes+=("$folder/$mesh.toml")
done
{
    cat "$folder/dragon-871k.toml"
    for box in 'size = [4, 3, 6], inward = true }' 'size = [0.5, 0.5, 0.5] }' 'size = [0.4, 1, 0.4] }'; do
        printf '\n[[mesh]]\ngenerate = { shape = "box", %s\nmaterial = "jade"\n' "$box"
        [[ $box == *inward* ]] || printf 'transform = { translate = [1.2, -0.9, 0.8] }\n'
    done
} >"$folder/room-871k.toml"
"$root/scripts/hard_mesh.py" >"$folder/hard.obj"
sed "s#meshes/dragon.obj#hard.obj#" "$root/scenes/dragon.toml" >"$folder/hard.toml"
scenes+=("$folder/room-871k.toml" "$folder/hard.toml" "$(hills 5000000)")

for threads in 1 "$(nproc)"; do
    bench "${scenes[@]}" --threads "$threads" --size "$size" --rounds 7 --json "$folder/race-$threads.json"
done
for builder in median sah sah_binned high; do
    bench "$folder/dragon.toml" "$folder/hard.toml" --size 256 --rounds 5 --set "bvh_builder=$builder" \
        --json "$folder/builder-$builder.json"
done
for triangles in 1000 10000 100000 1000000 10000000; do
    bench "$(hills $triangles)" --size 8 --rounds 5 --json "$folder/growth-$triangles.json"
done
pictures=(cornell cornell-area cornell-glossy cornell-transparent monkey teapot spheres spheres-dof cubes-transparent environment)
bench "${pictures[@]/#/builtin:}" --threads 1 --size 400 --rounds 7 --json "$folder/picture-1.json"
build release frame_bench -DRAYSCOPE_BENCHMARKS=ON
for threads in 1 "$(nproc)"; do
    "$root/build/release/tests/bench/frame_bench" "$threads" 800 builtin:cornell builtin:teapot "$folder/dragon.toml" \
        >"$folder/frame-$threads.json"
done
"$root/scripts/bench_page.py" "$folder" "$root/docs" "$size"
