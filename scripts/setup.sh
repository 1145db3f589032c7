# shellcheck shell=bash
# Shared by run.sh, test.sh and fuzz.sh: installing packages, configuring, building. Sourced.
# All messages go to stderr; stdout belongs to the program.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=scripts/packages.sh
source "$root/scripts/packages.sh"

say() { printf '%s\n' "$*" >&2; }
fail() { say "error: $*"; exit 1; }

# Prints those of the named packages that are not installed.
missing_packages() {
    local name
    for name in "$@"; do
        [[ $(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null) == installed ]] || printf '%s\n' "$name"
    done
}

# Whether the package manager can install all of these without an update of its lists.
has_candidates() {
    local name
    for name in "$@"; do
        [[ $(apt-cache policy "$name" 2>/dev/null) == *Candidate:\ [0-9]* ]] || return 1
    done
}

as_root() {
    if ((EUID == 0)); then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "root is required and sudo is not installed; run as root: $*"
    fi
}

apt() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=120 -o Dpkg::Use-Pty=0 "$@" \
        </dev/null >/dev/null
}

# install_packages NAME…: installs the missing ones and prints their names; silent if none is missing.
install_packages() {
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        command -v cmake >/dev/null && [[ -f $root/build/release/build.ninja ]] && return
        say "This system has no apt-get. If the build does not find a library, install the equivalent of these Debian packages:"
        say "    $*"
        return
    fi
    local missing
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0
    say "Installing ${missing[*]}"
    has_candidates "${missing[@]}" || apt update || fail "apt-get update failed; check the network connection"
    apt install -y --no-install-recommends "${missing[@]}" || fail "could not install ${missing[*]}"
}

# Installs the optional packages if that needs neither a password nor an update of the package lists.
install_optional_packages() {
    command -v apt-get >/dev/null || return 0
    ((EUID == 0)) || sudo -n true 2>/dev/null || return 0
    local name
    for name in $(missing_packages "${optional_packages[@]}"); do
        has_candidates "$name" || continue
        say "Installing $name"
        apt install -y --no-install-recommends "$name" || say "note: continuing without $name"
    done
}

# quietly WHAT COMMAND…: silent if the command succeeds within two seconds; otherwise prints WHAT and, on a terminal, the
# last line of the output; prints the whole output if the command fails.
quietly() {
    local what=$1 log pid status=0 ticks=0
    shift
    log=$(mktemp)
    set -m # a process group of its own, so that Ctrl+C ends the command with all its children
    "$@" >"$log" 2>&1 </dev/null &
    pid=$!
    set +m
    trap 'kill -- "-$pid" 2>/dev/null; rm -f "$log"; exit 130' INT TERM
    while kill -0 "$pid" 2>/dev/null; do
        sleep 0.1
        ((++ticks == 20)) && say "$what …"
        if ((ticks >= 20 && ticks % 10 == 0)) && [[ -t 2 ]]; then
            printf '\r\033[K%.*s' "$((${COLUMNS:-80} - 1))" "$(tail -n 1 "$log")" >&2
        fi
    done
    ((ticks >= 20)) && [[ -t 2 ]] && printf '\r\033[K' >&2
    wait "$pid" || status=$?
    trap - INT TERM
    ((status == 0)) || { say "$what failed:"; cat "$log" >&2; }
    rm -f "$log"
    return "$status"
}

# build PRESET TARGETS [CMAKE-OPTION…]: configures if there are options or no build folder, then builds the targets, which
# are separated by spaces.
build() {
    local preset=$1 targets folder=$root/build/$1
    read -ra targets <<<"$2"
    shift 2
    if [[ ! -f $folder/build.ninja || $# -gt 0 ]]; then
        quietly "Configuring ($preset)" cmake -S "$root" --preset "$preset" "$@" || return
    fi
    quietly "Building ($preset; the first time takes some minutes)" cmake --build "$folder" --target "${targets[@]}"
}
