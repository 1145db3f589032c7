#!/usr/bin/env bash
# scripts/portable_archive.sh BUILD FOLDER: packs the program of a build folder with the shared libraries that other
# distributions may lack, as FOLDER/rayscope-VERSION-SYSTEM.tar.gz. It runs from any place where the C and the C++ library are
# as new as here and libX11 is installed, which the library of the window is linked with; the window also needs OpenGL.
set -euo pipefail
(($# == 2)) || { echo "usage: portable_archive.sh BUILD FOLDER" >&2; exit 1; }
build=$1 folder=$2
for tool in patchelf ldd; do
    command -v "$tool" >/dev/null || { echo "error: $tool is not installed" >&2; exit 2; }
done
staging=$(mktemp -d)
trap 'rm -rf "$staging"' EXIT

version=$("$build/rayscope" --version | sed -n '1s/^rayscope //p')
name=rayscope-$version-$(uname -s | tr '[:upper:]' '[:lower:]')-$(uname -m)
cmake --install "$build" --prefix "$staging/$name" --component program --strip >/dev/null
program=$staging/$name/bin/rayscope
libraries=$staging/$name/lib/rayscope
mkdir -p "$libraries"

# Libraries that belong to the system: those of C and C++, because drivers load them too, and those of the graphics
# with what they need (libbsd, libmd).
ours() { ! grep -qE '^(ld-linux|linux-vdso|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|GL|EGL|GLX|OpenGL|GLdispatch|X[a-z0-9A-Z-]*|xcb[a-z0-9-]*|wayland-[a-z]*|drm|vulkan|bsd|md)\.so)' <<<"$1"; }
while read -r library path; do
    [[ $path != not ]] || { echo "error: $library is not installed" >&2; exit 2; }
    ours "$library" || continue
    cp -L "$path" "$libraries/$library"
    chmod 644 "$libraries/$library"
    # shellcheck disable=SC2016 # for the dynamic linker
    patchelf --set-rpath '$ORIGIN' "$libraries/$library"
done < <(ldd "$program" | awk '/=>/ {print $1, $3}')
# shellcheck disable=SC2016 # for the dynamic linker
patchelf --set-rpath '$ORIGIN/../lib/rayscope' "$program"

mkdir -p "$folder"
tar --create --gzip --file "$folder/$name.tar.gz" --directory "$staging" --sort=name --owner=0 --group=0 --numeric-owner \
    "$name"
