#!/usr/bin/env bash
# The program of a release build is hardened as cmake/hardening.cmake says, every file of it is compiled with these options,
# and the presets for tests check the standard library. Nothing starts other programs but what the user asked for by a command
# of its own. The check detects programs and compile commands without protection.
set -euo pipefail
for tool in readelf nm; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# weaknesses PROGRAM: a line for each protection that the program lacks.
weaknesses() {
    local header segments dynamic symbols
    header=$(readelf -hW "$1") segments=$(readelf -lW "$1") dynamic=$(readelf -dW "$1") symbols=$(nm -D "$1")
    grep -qE 'Type: +DYN' <<<"$header" || echo "$1 is not position independent"
    grep -q GNU_RELRO <<<"$segments" || echo "$1 has no segment that becomes read-only"
    grep -qE '\((FLAGS|BIND_NOW)\).*BIND_NOW|\(FLAGS_1\).*NOW' <<<"$dynamic" || echo "$1 binds its functions lazily"
    grep -qE 'GNU_STACK.* RW ' <<<"$segments" || echo "$1 has an executable stack"
    grep -q __stack_chk_fail <<<"$symbols" || echo "$1 does not check its stack"
    grep -qE ' U __[a-z]+_chk' <<<"$symbols" || echo "$1 does not check the sizes of buffers"
}

# lacking FILE OPTION…: a line for each option that a command of the compilation database lacks.
lacking() {
    local file=$1 option count
    shift
    for option in "$@"; do
        count=$(grep -E '"command":.* -c .*/src/' "$file" | grep -cvF -- " $option ") || true
        ((count == 0)) || echo "$count files are compiled without $option"
    done
}

# starters FOLDER: calls that start a program.
starters() {
    grep -rnE '\b(system|popen|execl[pe]?|execv[pe]*|posix_spawnp?|v?fork)\(' "$1" | grep -v '^[^:]*/cli/fetch_command.cpp:' || true
}
found=$(starters "$SOURCE/src")
[[ -z $found ]] || { echo "$found"; exit 1; }
echo 'if (std::system(command)) return;' >"$folder/starts.cpp"
[[ -n $(starters "$folder") ]] || { echo "the check missed a program that is started"; exit 1; }

count=$(grep 'CMAKE_BUILD_TYPE": "Debug"' -A 3 "$SOURCE/CMakePresets.json" | grep CMAKE_CXX_FLAGS_DEBUG | tee "$folder/flags" | wc -l)
((count >= 5)) || { echo "only $count presets for tests were found"; exit 1; }
! grep -vF -- -D_GLIBCXX_ASSERTIONS "$folder/flags" || { echo "these presets do not check the standard library"; exit 1; }
[[ $HARDENED == 1 ]] || { echo "no release build: the protections of the program are not checked"; exit 0; }

found=$(weaknesses "$BUILD/rayscope"; lacking "$BUILD/compile_commands.json" -fstack-protector-strong -U_FORTIFY_SOURCE)
[[ -z $found ]] || { echo "$found"; exit 1; }

# A program without any protection.
printf '#include <cstring>\nint main(int n, char** v) { char a[9]; std::strcpy(a, v[0]); return a[n]; }\n' >"$folder/weak.cpp"
"$CXX" -O1 -fno-stack-protector -U_FORTIFY_SOURCE -no-pie -Wl,-z,norelro -Wl,-z,lazy -Wl,-z,execstack -o "$folder/weak" \
    "$folder/weak.cpp"
(($(weaknesses "$folder/weak" | wc -l) == 6)) || { echo "the check missed a weakness:"; weaknesses "$folder/weak"; exit 1; }
sed 's/ -fstack-protector-strong / /' "$BUILD/compile_commands.json" >"$folder/commands.json"
[[ -n $(lacking "$folder/commands.json" -fstack-protector-strong) ]] || { echo "the check missed a missing option"; exit 1; }
