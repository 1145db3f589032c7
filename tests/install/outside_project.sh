#!/usr/bin/env bash
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$CMAKE" --install "$BUILD" --prefix "$folder/usr" >/dev/null

# What is installed must not lead back to where it was built.
! grep -rIlF -e "$SOURCE" "$folder/usr/lib"*/cmake "$folder/usr/include" ||
    { echo "the package names the source folder"; exit 1; }
! grep -rIn 'rayscope_options\|rayscope_base' "$folder/usr/lib"*/ --include='*.cmake' ||
    { echo "the package exports targets of the build"; exit 1; }

"$CMAKE" -S "$CONSUMER" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/usr" -DCMAKE_BUILD_TYPE=Debug
"$CMAKE" --build "$folder/build" -j2
"$folder/build/consumer"
"$folder/usr/bin/rayscope" --version
