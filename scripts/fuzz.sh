#!/usr/bin/env bash
# scripts/fuzz.sh [SECONDS [TARGET…]]: builds the fuzzers of tests/fuzz with Clang and runs each for SECONDS seconds (default
# 60), on all processors, or on JOBS of them. Without targets it runs all of tests/fuzz/targets.cpp. A line per target
# tells how many inputs were tried and what they covered. Inputs that extended the coverage are kept in build/fuzz/corpus and
# used again by the next run; inputs that fail are kept in build/fuzz/failures. The exit status is 1 if there are any. The
# targets that trace rays are tried by corpus_test alone, because Clang does not compile the kernels.
#
# scripts/fuzz.sh --store: replaces the stored corpus, tests/fuzz/corpus, by the fewest inputs of build/fuzz/corpus and of the
# stored one that together cover the same, the smallest first, up to 40 kB per target.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

stored=$root/tests/fuzz/corpus corpus=$root/build/fuzz/corpus failures=$root/build/fuzz/failures
programs=$root/build/fuzz/tests/fuzz
mapfile -t known < <(sed '/^#ifndef/,/^#endif/d' "$root/tests/fuzz/targets.cpp" | grep -oP '\{"\K[a-z]+(?=", fuzz)')
listed() { [[ " ${known[*]} " == *" $1 "* ]]; }

store=
[[ ${1:-} != --store ]] || { store=yes; shift; }
seconds=60
if [[ -z $store && $# -gt 0 ]]; then
    seconds=$1
    shift
fi
[[ $seconds =~ ^[0-9]+$ ]] || fail "expected a number of seconds, got '$seconds'"
jobs=${JOBS:-$(nproc)}
[[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "JOBS: expected a number of processors, got '$jobs'"
targets=("$@")
((${#targets[@]})) || targets=("${known[@]}")
for target in "${targets[@]}"; do listed "$target" || fail "unknown target '$target'; expected one of: ${known[*]}"; done

install_packages "${build_packages[@]}" "${fuzz_packages[@]}"
build fuzz 'fuzzer exr_seeds'
mkdir -p "$failures"
python3 "$root/tests/fuzz/make_seeds.py" "$corpus"
"$programs/exr_seeds" "$corpus/exr"

# last NAME LOG: the last number that libFuzzer printed behind this name.
last() { grep -oP "\b$1: \K[0-9]+" "$2" | tail -n 1; }

# run TARGET: prints the totals of libFuzzer; its last lines if an input failed.
run() {
    local target=$1 log=$failures/$1.log dictionary=$root/tests/fuzz/dictionaries/$1.dict options=()
    [[ ! -f $dictionary ]] || options+=("-dict=$dictionary")
    mkdir -p "$corpus/$target" "$stored/$target"
    if "$programs/fuzz_$target" "$corpus/$target" "$stored/$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=4096 \
        -print_final_stats=1 -close_fd_mask=1 -artifact_prefix="$failures/$target-" "${options[@]}" >"$log" 2>&1; then
        printf '%-9s %s executions, %s edges, %s features\n' "$target" \
            "$(grep -oP 'number_of_executed_units: \K.*' "$log")" "$(last cov "$log")" "$(last ft "$log")"
        rm "$log"
    else
        printf '%-9s failed:\n' "$target"
        tail -n 30 "$log"
        return 1
    fi
}

# keep TARGET: the stored corpus of a target.
keep() {
    local target=$1 merged size total=0 file
    merged=$(mktemp -d)
    "$programs/fuzz_$target" -merge=1 -close_fd_mask=3 "$merged" "$stored/$target" "$corpus/$target" 2>/dev/null ||
        fail "$target: the inputs could not be merged"
    rm -rf "${stored:?}/$target"
    mkdir -p "$stored/$target"
    while read -r size file; do
        ((total += size + 100, total <= 40000)) || break
        cp "$file" "$stored/$target/$(basename "$file" | cut -c 1-12)"
    done < <(find "$merged" -type f -printf '%s %p\n' | sort -n)
    printf '%-9s %s inputs\n' "$target" "$(find "$stored/$target" -type f | wc -l)"
    rm -rf "$merged"
}

if [[ -n $store ]]; then
    for target in "${targets[@]}"; do keep "$target"; done
    exit
fi
export -f run last
export root stored corpus failures seconds programs
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I '{}' bash -c 'run {}'
