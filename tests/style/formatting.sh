#!/usr/bin/env bash
# The code is formatted as .clang-format says. Releases of clang-format differ in detail, so the test is skipped if another
# one is installed.
set -euo pipefail
wanted=14
tool=$(command -v clang-format-$wanted || command -v clang-format) || { echo "clang-format is not installed"; exit 77; }
[[ $("$tool" --version) =~ version\ $wanted\. ]] || { echo "clang-format is not version $wanted"; exit 77; }
cd "$SOURCE"
find src include tests -name '*.h' -o -name '*.cpp' -o -name '*.inl' | xargs "$tool" --dry-run --Werror
