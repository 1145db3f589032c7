#!/usr/bin/env bash
# scripts/run.sh [ARGS]: installs missing packages, builds, and runs `rayscope ARGS`. Without ARGS it opens the window with
# the built-in scene or, if there is no display, renders that scene to rayscope.png.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install_packages "${build_packages[@]}"
if [[ -f $root/build/release/build.ninja ]]; then
    build release rayscope_program
else
    build release rayscope_program -DRAYSCOPE_TESTS=OFF
fi

program=$root/build/release/rayscope
if (($# == 0)) && [[ -z ${DISPLAY:-} && -z ${WAYLAND_DISPLAY:-} ]]; then
    say "There is no display (neither DISPLAY nor WAYLAND_DISPLAY is set): rendering the built-in scene to rayscope.png"
    exec "$program" render builtin:cornell -o rayscope.png
fi
exec "$program" "$@"
