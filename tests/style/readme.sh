#!/usr/bin/env bash
# Every command of the README works: its sh blocks are run line by line in an empty folder, with the program of this build
# in place of the two scripts.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$SOURCE/scenes" scenes

commands() { awk '/^ *```sh$/ {inside = 1; next} /^ *```/ {inside = 0} inside && !/^ *(#|$)/' "$SOURCE/README.md"; }

# The command that a line of the README becomes here: empty for lines that open a window, build, or fetch.
translated() {
    local line=${1%%  #*}
    case $line in
        scripts/run.sh | scripts/run.sh\ view* | scripts/test.sh* | git\ * | cd\ * | cmake\ *) ;;
        scripts/run.sh\ *) echo "${line/scripts\/run.sh/rayscope}" ;;
        *) echo "$line" ;;
    esac
}

PATH=$BUILD:$PATH
count=0
while read -r line; do
    command=$(translated "$line")
    [[ -n $command ]] || continue
    echo "\$ $command"
    bash -euo pipefail -c "$command" </dev/null || { echo "failed: $line"; exit 1; }
    ((++count))
done < <(commands)
grep -qx 'scripts/run.sh' <(commands) || { echo "the README does not mention scripts/run.sh"; exit 1; }
grep -qx 'scripts/test.sh' <(commands) || { echo "the README does not mention scripts/test.sh"; exit 1; }
((count >= 3)) || { echo "only $count commands were found"; exit 1; }
