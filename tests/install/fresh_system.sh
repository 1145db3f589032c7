#!/usr/bin/env bash
# In a minimal system of this distribution, made by debootstrap: the portable archive needs only libX11, the Debian
# package installs with its dependencies and runs, its completions load, and purging it leaves nothing behind.
set -euo pipefail
((EUID == 0)) || { echo "debootstrap needs root"; exit 77; }
for tool in debootstrap patchelf; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
system=$folder/system
trap 'umount "$system/proc" 2>/dev/null || true; rm -rf "$folder"' EXIT
fail() { echo "$*"; exit 1; }

release=$(. /etc/os-release && echo "$VERSION_CODENAME")
# shellcheck disable=SC2016 # for apt-get
mirror=$(apt-get indextargets --format '$(SITE)' "Codename: $release" "Created-By: Packages" | head -n 1)
debootstrap --variant=minbase "$release" "$system" "$mirror" >"$folder/log" 2>&1 ||
    { tail -n 5 "$folder/log"; echo "debootstrap cannot make a system here"; exit 77; }
mount -t proc proc "$system/proc"

"$CPACK" --config "$BUILD/CPackConfig.cmake" -B "$folder/packages" >"$folder/log" 2>&1 || fail "$(cat "$folder/log")"
"$SOURCE/scripts/portable_archive.sh" "$BUILD" "$folder/packages"
cp "$folder"/packages/rayscope_*.deb "$folder"/packages/*.tar.gz "$system/tmp"

inside() { chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 "$@"; }
picture=(render builtin:cornell-area --size 64x48 --spp 4 -q -o)
"$BUILD/rayscope" "${picture[@]}" "$folder/built.pfm"

inside apt-get install -qq -y --no-install-recommends libx11-6 >"$folder/log" 2>&1 || fail "$(tail "$folder/log")"
inside sh -c 'mkdir /opt/portable && tar -xf /tmp/rayscope-*.tar.gz -C /opt/portable --strip-components=1'
inside /opt/portable/bin/rayscope "${picture[@]}" /tmp/portable.pfm
cmp "$system/tmp/portable.pfm" "$folder/built.pfm"

inside sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends /tmp/rayscope_*.deb' \
    >"$folder/log" 2>&1 || fail "$(tail "$folder/log")"
inside rayscope "${picture[@]}" /tmp/packaged.pfm
cmp "$system/tmp/packaged.pfm" "$folder/built.pfm"
inside bash -c 'source /usr/share/bash-completion/completions/rayscope && complete -p rayscope' >/dev/null
inside apt-get purge -qq -y rayscope >/dev/null 2>&1
left=$(find "$system/usr" "$system/etc" -name '*rayscope*')
[[ -z $left ]] || fail "purging leaves: $left"
