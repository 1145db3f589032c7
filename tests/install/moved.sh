#!/usr/bin/env bash
# An installation works after its folder was moved, where neither the source tree nor the build folder exists: every command
# of the installed README, and the data files. No installed file names a folder of the build.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$CMAKE" --install "$BUILD" --prefix "$folder/first" --strip >/dev/null

# The debug information of the library, which --strip leaves, names the source files.
find "$folder/first" -name '*.a' -exec strip --strip-debug {} +
found=$(grep -rlaF -e "$SOURCE" -e "$BUILD" -e "$folder/first" "$folder/first") || true
[[ -z $found ]] || { echo "these files name folders of the build: $found"; exit 1; }

mkdir -p "$folder/other place" "$folder/place"
mv "$folder/first" "$folder/other place/rayscope"
installed="$folder/other place/rayscope"
cp "$SOURCE/tests/support/readme_commands.sh" "$folder"
hidden=(unshare --mount)
"${hidden[@]}" true 2>/dev/null || hidden=(unshare --mount --map-root-user)
"${hidden[@]}" true 2>/dev/null || { echo "no mount namespaces here, which hide the source tree"; exit 77; }

# SC2016: expanded by the inner shell.
# shellcheck disable=SC2016
"${hidden[@]}" env -u XDG_DATA_DIRS HOME="$folder/place" INSTALLED="$installed" FOLDER="$folder" SOURCE="$SOURCE" \
    BUILD="$BUILD" bash -euo pipefail -c '
    mount -t tmpfs none "$SOURCE"
    [[ ! -e $BUILD/rayscope ]] || mount -t tmpfs none "$BUILD"
    [[ ! -e $SOURCE/CMakeLists.txt && ! -e $BUILD/rayscope ]] || { echo "the source tree is still there"; exit 1; }
    source "$FOLDER/readme_commands.sh"
    cd "$FOLDER/place"
    ln -s "$INSTALLED/share/rayscope/scenes" scenes
    PATH=$INSTALLED/bin:$PATH
    run_readme "$INSTALLED/share/doc/rayscope/README.md"

    # A mesh that is too large to be embedded is found beside the program, and `fetch` finds its script.
    mkdir "$INSTALLED/share/rayscope/scenes/meshes"
    printf "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" >"$INSTALLED/share/rayscope/scenes/meshes/dragon.obj"
    rayscope info builtin:dragon | grep -q "1 triangles" || { echo "the mesh beside the program is not found"; exit 1; }
    mkdir -p "$FOLDER/place/.local/share/rayscope/scenes/meshes"
    cp "$INSTALLED/share/rayscope/scenes/meshes/dragon.obj" "$FOLDER/place/.local/share/rayscope/scenes/meshes"
    rayscope fetch dragon | grep -q "dragon.obj exists" || { echo "fetch does not find its script"; exit 1; }
'
