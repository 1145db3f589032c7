#!/usr/bin/env bash
# scripts/package.sh [FOLDER]: builds the Debian packages rayscope and librayscope-dev and the portable archive of the release
# configuration into FOLDER (build/packages).
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

folder=${1:-$root/build/packages}
install_packages "${build_packages[@]}" "${package_packages[@]}"
if [[ -f $root/build/release/build.ninja ]]; then
    build release 'rayscope_program rayscope rayscope_printed'
else
    build release 'rayscope_program rayscope rayscope_printed' -DRAYSCOPE_TESTS=OFF
fi
mkdir -p "$folder"
quietly "Building the Debian packages" cpack --config "$root/build/release/CPackConfig.cmake" -B "$folder"
rm -rf "$folder/_CPack_Packages"
quietly "Building the portable archive" "$root/scripts/portable_archive.sh" "$root/build/release" "$folder"
ls -l "$folder"
