#!/bin/bash
# kernel_symbols.sh OBJECT…: the object files of the kernels offer their table of functions and nothing else. A weak
# symbol would be an inline function that the linker may pick for callers on machines without the instruction set.
set -eu
failed=0
for object in "$@"; do
    offered=$(nm --defined-only --extern-only "$object" | awk '{print $NF}' | grep -v 'KernelsE$' || true)
    if [ -n "$offered" ]; then
        echo "$object offers more than its kernels: $offered"
        failed=1
    fi
done
exit $failed
