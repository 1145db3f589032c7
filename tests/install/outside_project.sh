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

"$CMAKE" -S "$CONSUMER" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/usr" -DCMAKE_BUILD_TYPE=Debug \
    -DEXAMPLES="$SOURCE/docs/examples"
"$CMAKE" --build "$folder/build" -j2
"$folder/build/consumer"
"$folder/usr/bin/rayscope" --version

# The example of docs/library.md does what the command line does, with the same bits.
cd "$folder"
"$folder/build/render_and_probe" >probe.txt 2>progress.txt
grep -q '^rmse 0\.' probe.txt && grep -q 'camera ray' probe.txt && grep -q '100 %' progress.txt ||
    { cat probe.txt progress.txt; exit 1; }
"$folder/usr/bin/rayscope" render builtin:cornell-area --size 160x120 --spp 16 --set max_depth=4 \
    -o same.png -o same.exr --aov depth -q
for pair in "cornell.exr same.exr" "cornell.png same.png" "cornell.depth.exr same.depth.exr"; do
    "$folder/usr/bin/rayscope" compare $pair --metric max --fail-above 0 >/dev/null ||
        { echo "the example and the command line differ: $pair"; exit 1; }
done
