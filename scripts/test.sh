#!/usr/bin/env bash
# scripts/test.sh [--all | --long]: installs missing packages, builds the release configuration and runs its test suite.
#   --all     also the suites under the address, undefined-behaviour and thread sanitizers, and a build with -O0 that
#             compiles every file alone, without precompiled headers, checks the one-definition rule at link time, and runs
#             the quick unit tests
#   --long    everything of --all, including the tests that take minutes each
#   --quick   the same as no option
# A failed test case fails the run; only cases with the label "ui" are repeated, once, and the repeats are printed.
# The last line says how many test cases passed and failed.
set -euo pipefail
# shellcheck source=scripts/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

suites=(release)
without_long=(--label-exclude '^long$')
case ${1:-} in
    '' | --quick) ;;
    --all) suites=(release asan tsan plain) ;;
    --long) suites=(release asan tsan plain) without_long=() ;;
    *) fail "unknown option '$1'; scripts/test.sh takes --all, --long or --quick" ;;
esac

passed=0 failed=0

# attribute NAME FILE: a count of the JUnit file that CTest wrote.
attribute() { grep -m1 -oP "\b$1=\"\K[0-9]+" "$2" || echo 0; }

# Adds the counts of a JUnit file to the totals.
count() {
    local total broken skipped
    total=$(attribute tests "$1") broken=$(attribute failures "$1")
    skipped=$(($(attribute skipped "$1") + $(attribute disabled "$1")))
    ((passed += total - broken - skipped, failed += broken)) || true
    ((skipped == 0)) || say "$skipped skipped"
}

run_ctest() {
    local preset=$1 report=$2
    shift 2
    "${launcher[@]}" ctest --test-dir "$root/build/$preset" --output-on-failure --progress --output-junit "$report" "$@"
}

# repeat_ui PRESET REPORT: repeats the failed window tests of a report once, because clicks between two slow frames are lost
# when the machine is busy.
repeat_ui() {
    local preset=$1 report names broken repeats
    names=$(grep -oP '<testcase name="\K[^"]+(?=".* status="fail")' "$2" | tr -c 'A-Za-z0-9_\n' . | paste -sd '|') || true
    [[ -n $names ]] || return 0
    report=$(mktemp)
    run_ctest "$preset" "$report" --no-tests=ignore --label-regex '^ui$' --tests-regex "^($names)\$" || true
    repeats=$(attribute tests "$report") broken=$(attribute failures "$report")
    if ((repeats > 0)); then
        say "repeated $repeats of the failed cases (label ui), $((repeats - broken)) passed then:" \
            "$(grep -oP '<testcase name="\K[^"]+' "$report" | tr '\n' ' ')"
        ((passed += repeats - broken, failed -= repeats - broken)) || true
    fi
    rm -f "$report"
}

# run_suite PRESET [CTEST-OPTION…]: a suite that fails without naming a test case counts as one failure.
run_suite() {
    local preset=$1 report before=$failed status=0
    shift
    report=$(mktemp)
    run_ctest "$preset" "$report" --no-tests=error --parallel "$(nproc)" "${without_long[@]}" "$@" || status=$?
    count "$report"
    ((status == 0 || failed > before)) || ((++failed))
    ((status == 0)) || repeat_ui "$preset" "$report"
    rm -f "$report"
}

# The thread sanitizer does not support strong randomization of the address space.
fixed_addresses=(setarch "$(uname -m)" --addr-no-randomize)
"${fixed_addresses[@]}" true 2>/dev/null || fixed_addresses=()

install_packages "${build_packages[@]}" "${test_packages[@]}"
install_optional_packages
for suite in "${suites[@]}"; do
    targets=all options=() launcher=()
    case $suite in
        tsan) targets=thread_tests options=(--label-regex '^threads$') launcher=("${fixed_addresses[@]}") ;;
        plain) targets='rayscope_program quick_tests' options=(--label-regex '^unit$') ;;
    esac
    say "== $suite"
    if ! build "$suite" "$targets" -DRAYSCOPE_TESTS=ON; then
        ((++failed))
    else
        run_suite "$suite" "${options[@]}"
    fi
done

echo "$passed passed, $failed failed"
((failed == 0))
