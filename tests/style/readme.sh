#!/usr/bin/env bash
# Every command of the README works: its sh blocks are run line by line in an empty folder, with the program of this build
# in place of the two scripts.
set -euo pipefail
source "$SOURCE/tests/support/readme_commands.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$SOURCE/scenes" scenes

PATH=$BUILD:$PATH
run_readme "$SOURCE/README.md"
for script in run test; do
    readme_commands "$SOURCE/README.md" | grep -qx "scripts/$script.sh" ||
        { echo "the README does not mention scripts/$script.sh"; exit 1; }
done
