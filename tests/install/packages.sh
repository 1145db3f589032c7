#!/usr/bin/env bash
# The Debian packages are complete, lintian finds no errors and no warnings in them, and the unpacked program renders the same
# picture as that of the build.
set -euo pipefail
for tool in dpkg-deb dpkg-shlibdeps; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "$*"; exit 1; }

"$CPACK" --config "$BUILD/CPackConfig.cmake" -B "$folder" >log 2>&1 || fail "$(cat log)"
program=$(echo rayscope_*.deb) development=$(echo librayscope-dev_*.deb)

field() { dpkg-deb --field "$1" "$2"; }
for library in libc6 libfmt libopenexr libpng16 libtbb libtomlplusplus; do
    [[ $(field "$program" Depends) == *"$library"* ]] || fail "rayscope does not depend on $library"
done
for library in libfmt-dev libglm-dev libopenexr-dev libtbb-dev nlohmann-json3-dev; do
    [[ $(field "$development" Depends) == *"$library"* ]] || fail "librayscope-dev does not depend on $library"
done

dpkg-deb --extract "$program" root
dpkg-deb --extract "$development" root
for file in share/man/man1/rayscope.1.gz share/bash-completion/completions/rayscope share/doc/rayscope/copyright \
    share/fish/vendor_completions.d/rayscope.fish share/zsh/vendor-completions/_rayscope \
    share/rayscope/scenes/cornell.toml share/rayscope/scripts/fetch_dragon.sh include/rayscope/accel.h; do
    [[ -s root/usr/$file ]] || fail "the packages lack /usr/$file"
done
[[ $(find root/usr -name librayscope.a) && $(find root/usr -name rayscopeConfig.cmake) ]] || fail "the library is missing"
diff <(zcat root/usr/share/man/man1/rayscope.1.gz) <("$BUILD/rayscope" manual) || fail "the manual page is out of date"
found=$(grep -rlaF -e "$SOURCE" -e "$BUILD" root) || true
[[ -z $found ]] || fail "these files name folders of the build: $found"

render() { "$1" render builtin:cornell-area --size 64x48 --spp 4 -o "$2" -q; }
render root/usr/bin/rayscope packaged.pfm
render "$BUILD/rayscope" built.pfm
cmp packaged.pfm built.pfm

# Each tool checks what it knows; those that are missing are named.
missing=()
check() {
    local tool=$1
    shift
    if command -v "$tool" >/dev/null; then
        "$@" || fail "$tool complains"
    else
        missing+=("$tool")
    fi
}
quiet_manual() { [[ -z $(man --warnings -E UTF-8 -l -Tutf8 -Z root/usr/share/man/man1/rayscope.1.gz 2>&1 >/dev/null | tee /dev/stderr) ]]; }
check lintian lintian --allow-root --fail-on error,warning "$program" "$development"
check groff quiet_manual
if [[ -e root/usr/share/applications/rayscope.desktop ]]; then
    check desktop-file-validate desktop-file-validate root/usr/share/applications/rayscope.desktop
    check appstreamcli appstreamcli validate --no-net root/usr/share/metainfo/org.rayscope.rayscope.metainfo.xml
    grep -q "<release version=\"$(field "$program" Version | sed 's/-.*//')\"" root/usr/share/metainfo/*.xml ||
        fail "the metainfo file does not name this release"
fi
((${#missing[@]} == 0)) || echo "not installed: ${missing[*]}"
