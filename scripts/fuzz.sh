#!/usr/bin/env bash
# scripts/fuzz.sh [SECONDS [TARGET…]]: builds the fuzzers of tests/fuzz with Clang and runs each for SECONDS seconds (default
# 60), on all processors. Without targets it runs all of them: png jpeg bmp tga hdr pfm pnm exr obj mtl ply stl gltf scene settings
# films. Inputs that extended the coverage are kept in build/fuzz/corpus and used again by the next run; inputs that fail are
# kept in build/fuzz/failures. The exit status is 1 if there are any.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

seconds=${1:-60}
[[ $seconds =~ ^[0-9]+$ ]] || fail "expected a number of seconds, got '$seconds'"
shift || true
targets=("$@")
((${#targets[@]})) || targets=(png jpeg bmp tga hdr pfm pnm exr obj mtl ply stl gltf scene settings films)

install_packages "${build_packages[@]}" "${fuzz_packages[@]}"
build fuzz "${targets[*]/#/fuzz_}"

corpus=$root/build/fuzz/corpus failures=$root/build/fuzz/failures
mkdir -p "$failures"

# seed_image TARGET: small images of the kinds that ImageMagick writes.
seed_image() {
    local folder=$corpus/$1 depth colours
    case $1 in
        png) colours=(PNG8: PNG24: PNG32: PNG48:) ;;
        bmp) colours=(BMP: BMP2: BMP3:) ;;
        pnm) colours=(PBM: PGM: PPM:) ;;
        exr) colours=(EXR:) ;;
        *) colours=("${1^^}:") ;;
    esac
    for depth in 8 16; do
        for kind in "${colours[@]}"; do
            convert -size 7x5 gradient:red-blue -depth "$depth" "$kind$folder/$depth-${kind%:}" 2>/dev/null || true
            convert -size 7x5 gradient: -colorspace Gray -depth "$depth" -compress RLE "$kind$folder/grey-$depth-${kind%:}" \
                2>/dev/null || true
            convert -size 3x9 plasma: -interlace Plane -compress None "$kind$folder/plain-$depth-${kind%:}" 2>/dev/null || true
        done
    done
}

# seed TARGET: the files from which the mutations start.
seed() {
    mkdir -p "$corpus/$1"
    case $1 in
        scene) cp "$root"/scenes/*.toml "$corpus/$1" ;;
        obj | mtl) cp "$root"/scenes/*."$1" "$corpus/$1" 2>/dev/null || true ;;
        settings) printf 'spp=4' >"$corpus/$1/spp" ;;
        png | jpeg | bmp | tga | hdr | pfm | pnm | exr) seed_image "$1" ;;
    esac
}

# run TARGET: prints the totals of libFuzzer; its last lines if an input failed.
run() {
    local target=$1 log dictionary=$root/tests/fuzz/dictionaries/$1.dict options=()
    [[ ! -f $dictionary ]] || options+=("-dict=$dictionary")
    log=$failures/$target.log
    if "$root/build/fuzz/tests/fuzz/fuzz_$target" "$corpus/$target" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=4096 -print_final_stats=1 -artifact_prefix="$failures/$target-" "${options[@]}" >"$log" 2>&1; then
        printf '%-9s %s executions, coverage %s\n' "$target" \
            "$(grep -oP 'number_of_executed_units: \K.*' "$log")" "$(grep -oP 'cov: \K[0-9]+' "$log" | tail -n 1)"
        rm "$log"
    else
        printf '%-9s failed:\n' "$target"
        tail -n 30 "$log"
        return 1
    fi
}

for target in "${targets[@]}"; do seed "$target"; done
export -f run
export root corpus failures seconds
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I '{}' bash -c 'run {}'
