#!/usr/bin/env bash
# The portable archive brings the libraries that other distributions may lack, finds them after it was moved, and renders the
# same picture as the build.
set -euo pipefail
command -v patchelf >/dev/null || { echo "patchelf is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "$*"; exit 1; }

"$SOURCE/scripts/portable_archive.sh" "$BUILD" "$folder/made"
mkdir "a place"
tar -xf made/*.tar.gz -C "a place"
place=$(echo "$folder/a place"/*)
[[ $(basename "$place") == rayscope-* ]] || fail "the archive does not hold one folder: $place"

# Everything but the C and C++ libraries and the graphics comes from the archive.
foreign=$(env -i ldd "$place/bin/rayscope" | sed -n 's/.* => \(.*\) (0x.*/\1/p' | grep -v "^$place/" |
    grep -vE '/(libc|libm|libdl|librt|libpthread|libstdc\+\+|libgcc_s|libGL|libEGL|libGLX|libOpenGL|libGLdispatch|libX[^/]*|libxcb[^/]*|libwayland[^/]*|libbsd|libmd)\.so') || true
[[ -z $foreign ]] || fail "the archive lacks: $foreign"
for library in fmt tbb OpenEXR png16; do
    [[ -n $(find "$place/lib/rayscope" -name "lib$library*.so*") ]] || fail "the archive lacks lib$library"
done

render() { env -i "$1" render builtin:cornell-area --size 64x48 --spp 4 -o "$2" -q; }
render "$place/bin/rayscope" portable.pfm
render "$BUILD/rayscope" built.pfm
cmp portable.pfm built.pfm
