#!/usr/bin/env bash
# The last line of scripts/test.sh counts what CTest reports. A stand-in for CTest writes the reports; nothing is built.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/checkout with space"
cp -r "$SOURCE/scripts" "$folder/checkout with space"
for tool in cmake dpkg-query apt-get apt-cache sudo; do
    printf '#!/bin/sh\n[ "${0##*/}" = dpkg-query ] && printf installed\n' >"$folder/bin/$tool"
done
printf '#!/bin/sh\n[ -z "$BROKEN_BUILD" ]\n' >"$folder/bin/cmake"
cat >"$folder/bin/ctest" <<'END'
#!/usr/bin/env bash
while [[ $1 != --output-junit ]]; do shift; done
printf '<?xml version="1.0"?>\n<testsuite name="Linux"\n\ttests="10"\n\tfailures="%s"\n\tdisabled="0"\n\tskipped="1"\n>' \
    "$FAILURES" >"$2"
exit "$STATUS"
END
chmod +x "$folder"/bin/*

# expect STATUS LAST-LINE VARIABLES… -- ARGUMENTS…
expect() {
    local status=$1 line=$2 variables=() got=0 said
    shift 2
    while [[ $1 != -- ]]; do variables+=("$1"); shift; done
    shift
    said=$(env PATH="$folder/bin:$PATH" FAILURES=0 STATUS=0 BROKEN_BUILD= "${variables[@]}" \
        "$folder/checkout with space/scripts/test.sh" "$@" 2>/dev/null) || got=$?
    [[ $got == "$status" && $(tail -n 1 <<<"$said") == "$line" ]] ||
        { echo "test.sh ${variables[*]} $*: expected $status and '$line', got $got and '$said'"; exit 1; }
}

expect 0 '27 passed, 0 failed' --
expect 0 '9 passed, 0 failed' -- --quick
expect 1 '7 passed, 2 failed' FAILURES=2 STATUS=8 -- --quick
expect 1 '9 passed, 1 failed' STATUS=8 -- --quick
expect 1 '0 passed, 3 failed' BROKEN_BUILD=1 --
