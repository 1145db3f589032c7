#!/usr/bin/env bash
# Renders the pictures of docs/effects.md into docs/images/ from the shipped scenes.
#   scripts/make_pictures.sh [PROGRAM]     PROGRAM defaults to build/release/rayscope
set -euo pipefail
cd "$(dirname "$0")/.."
program=${1:-build/release/rayscope}
[[ -x $program ]] || { echo "no program at '$program': build it with scripts/run.sh or name it" >&2; exit 1; }
mkdir -p docs/images

# picture NAME SCENE OPTIONS…: one picture of 320 × 240.
picture() {
    local name=$1 scene=$2
    shift 2
    echo "$name"
    "$program" render "$scene" -o "docs/images/$name.png" --size 320x240 --set spp=32 --quiet "$@"
}
# pair NAME SCENE KEY OFF ON OPTIONS…: the same picture with a setting at two values.
pair() {
    local name=$1 scene=$2 key=$3 off=$4 on=$5
    shift 5
    picture "$name-off" "$scene" "$@" --set "$key=$off"
    picture "$name" "$scene" "$@" --set "$key=$on"
}

pair    shading            builtin:cornell             shading false true
pair    recursion          builtin:cornell             max_depth 0 5
pair    hard-shadows       builtin:cornell             hard_shadows false true
picture segment-light      builtin:cube                --set spp=16
pair    parallelogram      builtin:cornell-area        soft_shadows false true --set spp=16
pair    normals            builtin:teapot              normal_interpolation false true
pair    texture            builtin:quad-textured       texture_filter nearest bilinear
pair    mipmap             builtin:environment         texture_filter nearest mipmap --set spp=1 --look-from -0.9,0.16,-3.4 --look-at 0,0.12,0
pair    environment        builtin:environment         environment false true
picture reflection-map     builtin:environment         --set reflection_map=true
pair    samples            builtin:cube                spp 1 32
pair    glossy             builtin:cornell-glossy      glossy_sigma 0.5 2 --set spp=16 --set glossy_samples=8
pair    transparency       builtin:cubes-transparent   transparency false true
pair    shadow-of-glass    builtin:cornell-transparent transparent_shadows false true
pair    depth-of-field     builtin:spheres-dof         depth_of_field false true
picture sharp-zone         builtin:spheres-dof         --set sharp_zone=1.5
pair    bloom              builtin:environment         bloom false true --set bloom_threshold=0.9 --set bloom_size=16 --set bloom_sigma=6
picture bloom-stage        builtin:environment         --set bloom=true --set bloom_threshold=0.9 --set bloom_size=16 --set bloom_sigma=6 --set bloom_debug=true
pair    color              builtin:cornell             tone course srgb
picture motion-blur        scenes/spheres-moving.toml
