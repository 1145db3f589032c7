#!/usr/bin/env bash
# scripts/run.sh passes on arguments and exit codes, prints nothing of its own on stdout, works from any folder, and renders
# a picture if there is no display.
set -euo pipefail
[[ $BUILD == "$SOURCE/build/release" ]] || { echo "run.sh builds another folder than this one"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/a folder"
cd "$folder/a folder"
unset DISPLAY WAYLAND_DISPLAY

fail() { echo "$*"; exit 1; }

said=$("$SOURCE/scripts/run.sh" 2>&1) || fail "run.sh without a display failed: $said"
[[ $said == *"no display"*rayscope.png* ]] || fail "no message about the missing display: $said"
[[ $(head -c 4 rayscope.png | tail -c 3) == PNG ]] || fail "rayscope.png is not a PNG"

[[ $("$SOURCE/scripts/run.sh" --version 2>errors) == "rayscope "* ]] || fail "arguments do not reach the program"
[[ ! -s errors ]] || fail "messages although nothing was installed or built: $(cat errors)"

status=0
"$SOURCE/scripts/run.sh" info 'no such scene.toml' >output 2>errors || status=$?
((status == 2)) || fail "exit code $status instead of 2"
grep -q 'no such scene.toml' errors || fail "the message does not name the file: $(cat errors)"
[[ ! -s output ]] || fail "a message went to stdout"
