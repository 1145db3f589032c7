#!/usr/bin/env bash
# scripts/tidy.sh [PATTERN]: builds the program with Clang and checks the sources, or those whose path matches PATTERN, with
# clang-tidy. .clang-tidy lists the checks and argues the exceptions.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_packages "${build_packages[@]}" "${tidy_packages[@]}"
build tidy rayscope_program
mapfile -t sources < <(grep -oP '"file": "\K[^"]+' "$root/build/tidy/compile_commands.json" | grep -E "${1:-.}" | sort -u)
((${#sources[@]})) || fail "no source matches '$1'"
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p "$root/build/tidy"
