#!/usr/bin/env bash
# scripts/tidy.sh [PATTERN]: checks the sources, or those whose path matches PATTERN, with clang-tidy; .clang-tidy lists the
# checks and argues the exceptions. The kernels of the BVH are left out, because Clang does not compile their vectors.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

folder=$root/build/tidy
install_packages "${build_packages[@]}" "${tidy_packages[@]}"
quietly 'Configuring (tidy)' cmake -S "$root" --preset tidy
mapfile -t generated < <(ninja -C "$folder" -t targets all | grep -oP '^generated/[^:]+')
quietly 'Embedding files' cmake --build "$folder" --target "${generated[@]}"
mapfile -t sources < <(grep -oP '"file": "\K[^"]+' "$folder/compile_commands.json" | grep -v '/bvh/kernel/' |
    grep -E "${1:-.}" | sort -u)
((${#sources[@]})) || fail "no source matches '$1'"
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p "$folder"
