#!/usr/bin/env bash
# scripts/test.sh counts what CTest reports, and repeats failed cases only if they have the label "ui". A fake CTest writes
# the reports; nothing is built.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/checkout with space"
cp -r "$SOURCE/scripts" "$folder/checkout with space"
for tool in dpkg-query apt-get apt-cache sudo; do
    printf '#!/bin/sh\n[ "${0##*/}" = dpkg-query ] && printf installed\n' >"$folder/bin/$tool"
done
printf '#!/bin/sh\n[ -z "$BROKEN_BUILD" ]\n' >"$folder/bin/cmake"
# FAILURES of 10 cases fail in each suite. UI of them have the label and are run again, when UI_FAILURES of them fail.
cat >"$folder/bin/ctest" <<'END'
#!/usr/bin/env bash
tests=10 failures=$FAILURES skipped=1 status=$STATUS
[[ " $* " != *" --repeat "* ]] || { echo "a repetition of every case" >&2; exit 1; }
if [[ " $* " == *" --tests-regex "* ]]; then
    [[ " $* " == *" --label-regex ^ui\$ "* ]] || { echo "a repetition without the label" >&2; exit 1; }
    [[ " $* " == *" --tests-regex ^(case.0|case.1)\$ "* ]] || { echo "a repetition of other cases: $*" >&2; exit 1; }
    tests=$UI failures=$UI_FAILURES skipped=0 status=$((UI_FAILURES > 0 ? 8 : 0))
fi
while [[ $1 != --output-junit ]]; do shift; done
{
    printf '<?xml version="1.0"?>\n<testsuite name="Linux"\n\ttests="%s"\n\tfailures="%s"\n\tdisabled="0"\n\tskipped="%s"\n>\n' \
        "$tests" "$failures" "$skipped"
    for ((i = 0; i < tests; ++i)); do
        printf '\t<testcase name="case.%s" classname="c" time="1" status="%s">\n' "$i" "$( ((i < failures)) && echo fail || echo run)"
    done
} >"$2"
exit "$status"
END
chmod +x "$folder"/bin/*

# run_script VARIABLES… -- ARGUMENTS…: the output in $said, the messages in the file $folder/messages.
run_script() {
    local variables=()
    while [[ $1 != -- ]]; do variables+=("$1"); shift; done
    shift
    env PATH="$folder/bin:$PATH" FAILURES=0 STATUS=0 UI=0 UI_FAILURES=0 BROKEN_BUILD= "${variables[@]}" \
        "$folder/checkout with space/scripts/test.sh" "$@" 2>"$folder/messages"
}

# expect STATUS LAST-LINE VARIABLES… -- ARGUMENTS…
expect() {
    local status=$1 line=$2 got=0 said
    shift 2
    said=$(run_script "$@") || got=$?
    [[ $got == "$status" && $(tail -n 1 <<<"$said") == "$line" ]] ||
        { echo "$*: expected $status and '$line', got $got and '$said'"; cat "$folder/messages"; exit 1; }
}

expect 0 '9 passed, 0 failed' --
expect 0 '9 passed, 0 failed' -- --quick
expect 0 '36 passed, 0 failed' -- --all # four suites of 9
expect 0 '36 passed, 0 failed' -- --long
expect 1 '7 passed, 2 failed' FAILURES=2 STATUS=8 --
! grep -q '^repeated' "$folder/messages" || { echo "a case without the label was repeated"; exit 1; }
expect 0 '9 passed, 0 failed' FAILURES=2 STATUS=8 UI=2 --
grep -q '^repeated 2 of the failed cases (label ui), 2 passed then: case.0 case.1' "$folder/messages" ||
    { echo "the repeats were not printed:"; cat "$folder/messages"; exit 1; }
expect 1 '8 passed, 1 failed' FAILURES=2 STATUS=8 UI=1 --
expect 1 '7 passed, 2 failed' FAILURES=2 STATUS=8 UI=1 UI_FAILURES=1 --
expect 1 '9 passed, 1 failed' STATUS=8 --
expect 1 '0 passed, 1 failed' BROKEN_BUILD=1 --
expect 1 '0 passed, 4 failed' BROKEN_BUILD=1 -- --all
