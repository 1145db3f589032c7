#!/usr/bin/env bash
# Names in anonymous namespaces are unique within a module or a folder of tests, except for overloads, because builds with
# RAYSCOPE_UNITY compile several files at a time. The check detects planted violations.
set -euo pipefail
tool=$(command -v ctags-universal || command -v ctags) || { echo "universal-ctags is not installed"; exit 77; }
"$tool" --version 2>/dev/null | grep -q Universal || { echo "$tool is not universal-ctags"; exit 77; }
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

# duplicates ROOT: lines "FOLDER NAMESPACE NAME(TYPES): FILES".
duplicates() {
    (cd "$1" && find src tests -name '*.cpp' | sort | "$tool" -x -L - --kinds-c++=fvscg --_xformat=$'%F\t%{scope}\t%N\t%S' 2>/dev/null) |
        # Members of anonymous namespaces, without lambdas and test cases.
        grep -P '^[^\t]*\t[^\t]*__anon\w*\t(?!__anon|TEST|INSTANTIATE_)' |
        # The names and defaults of parameters do not matter.
        sed -E 's/([ &*])[A-Za-z_0-9]+(=[^,)]*)?([,)])/\1\3/g; s/::__anon\w*//' |
        awk -F '\t' '{
            split($1, folder, "/")
            name = $2 "::" $3 ($4 == "-" ? "" : $4) " in " folder[1] "/" folder[2]
            if (index(files[name] " ", " " $1 " ") == 0) { files[name] = files[name] " " $1; ++count[name] }
        } END { for (name in count) if (count[name] > 1) print name ":" files[name] }' | sort
}

# refuses LINE: the check of a copy in which two files of a module have this line in an anonymous namespace must fail.
refuses() {
    rm -rf "${copy:?}"/*
    mkdir -p "$copy/src/base" "$copy/tests"
    local file
    for file in one two; do
        printf 'namespace rayscope::base {\nnamespace {\n%s\n}\n}\n' "$1" >"$copy/src/base/$file.cpp"
    done
    [[ $(duplicates "$copy") == *"src/base/one.cpp src/base/two.cpp" ]] || { echo "the check accepted '$1' twice"; exit 1; }
}

refuses 'constexpr int kLimit = 3;'
refuses 'struct Limits { int low, high; };'
refuses 'int limitOf(const char* name, int other = 2) { return other; }'

found=$(duplicates "$SOURCE")
[[ -z $found ]] || { echo "$found"; exit 1; }
