#!/usr/bin/env bash
# scripts/test.sh [--quick | --long]: installs what is missing, builds, and runs the whole test suite: as released, then
# with the address and undefined-behaviour sanitizers, then what uses threads with the thread sanitizer.
#   --quick   as released only
#   --long    also the tests that take minutes each
# The last line says how many test cases passed and failed.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

suites=(release asan tsan)
without_long=(--label-exclude '^long$')
case ${1:-} in
    '') ;;
    --quick) suites=(release) ;;
    --long) without_long=() ;;
    *) fail "unknown option '$1'; scripts/test.sh takes --quick or --long" ;;
esac

passed=0 failed=0

# Adds the counts that CTest wrote into a JUnit file to the totals.
count() {
    local total broken skipped
    attribute() { grep -m1 -oP "\b$1=\"\K[0-9]+" "$2" || echo 0; }
    total=$(attribute tests "$1") broken=$(attribute failures "$1")
    skipped=$(($(attribute skipped "$1") + $(attribute disabled "$1")))
    ((passed += total - broken - skipped, failed += broken)) || true
    ((skipped == 0)) || say "$skipped skipped"
}

# A case that fails is run once more, because windows and interrupts depend on the load of the machine.
# run_suite PRESET [CTEST-OPTION…]: a suite that breaks without naming a test counts as one failure.
run_suite() {
    local preset=$1 report before=$failed status=0
    shift
    say "== $preset"
    report=$(mktemp)
    "${launcher[@]}" ctest --test-dir "$root/build/$preset" --output-on-failure --no-tests=error --progress \
        --repeat until-pass:2 \
        --parallel "$(nproc)" --output-junit "$report" "${without_long[@]}" "$@" || status=$?
    count "$report"
    rm -f "$report"
    ((status == 0 || failed > before)) || ((++failed))
}

# The thread sanitizer needs addresses that strong randomisation of the address space takes away.
fixed_addresses=(setarch "$(uname -m)" --addr-no-randomize)
"${fixed_addresses[@]}" true 2>/dev/null || fixed_addresses=()

install_packages "${build_packages[@]}" "${test_packages[@]}"
install_optional_packages
for suite in "${suites[@]}"; do
    target=all options=() launcher=()
    [[ $suite != tsan ]] || { target=thread_tests options=(-L '^threads$') launcher=("${fixed_addresses[@]}"); }
    if build "$suite" "$target" -DRAYSCOPE_TESTS=ON; then
        run_suite "$suite" "${options[@]}"
    else
        ((++failed))
    fi
done

echo "$passed passed, $failed failed"
((failed == 0))
